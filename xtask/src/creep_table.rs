//! The table of the creep law, made anew.

use anyhow::Result;

use crate::shell::{cargo, run};

/// The file beside the code.
const FILE: &str = "crates/contact/data/exact-rolling.table";

/// Solves all nodes on all cores; with `every`, only every so many rays, and writes nothing.
pub fn make(every: Option<usize>) -> Result<()> {
    // Wider registers halve the time; the values stay the same bit by bit.
    let wide = if cfg!(target_arch = "x86_64") { "-Ctarget-cpu=x86-64-v3" } else { "" };
    run(cargo()
        .args(["run", "--release", "-p", "contact", "--example", "creep_table", "--", FILE])
        .args(every.map(|every| every.to_string()))
        .env("RUSTFLAGS", wide)
        .env("CARGO_TARGET_DIR", crate::shell::target().join("creep-table")))
}
