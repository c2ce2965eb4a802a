//! The tutorials of the book: each command is run, and prints what the page shows.
//!
//! `TRYCMD=overwrite cargo test --release -p hotfoot-tests tutorials` writes what the commands print now; `...`
//! stands for lines and `[..]` for words that differ from run to run.

use std::path::PathBuf;

use hotfoot_tests::{program, root};

#[test]
fn commands_of_the_tutorials_print_what_their_pages_show() {
    let cases = trycmd::TestCases::new();
    cases.register_bin("hotfoot", program());
    for tool in ["cc", "mkdir", "mv", "python3"] {
        cases.register_bin(tool, on_the_path(tool));
    }
    cases.case(root().join("docs/tutorials/*.md"));
}

/// The path of a program that every machine with a compiler has.
fn on_the_path(program: &str) -> PathBuf {
    let folders = std::env::var_os("PATH").expect("there is a PATH");
    let mut files = std::env::split_paths(&folders).map(|folder| folder.join(program));
    files.find(|file| file.is_file()).unwrap_or_else(|| panic!("{program} is not on the PATH"))
}
