//! The target of `cargo fuzz` for the reader whose name the program has (CONTRIBUTING.md, "Fuzzing").

#![no_main]

use std::sync::LazyLock;

use libfuzzer_sys::fuzz_target;
use readers::{Reader, reader};

static READER: LazyLock<Reader> =
    LazyLock::new(|| reader(env!("CARGO_BIN_NAME")).expect("every target is named after a reader"));

fuzz_target!(|bytes: &[u8]| READER(bytes));
