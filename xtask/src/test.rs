//! The whole test run.

use std::process::Command;

use anyhow::Result;

use crate::shell::{cargo, run};
use crate::{fmus, python};

/// Format, lints, FMUs and their model descriptions, Rust tests, FMPy tests.
pub fn run_all() -> Result<()> {
    step("format");
    run(cargo().args(["fmt", "--all", "--check"]))?;
    step("FMUs");
    fmus::build()?;
    step("model descriptions");
    fmus::check_model_descriptions()?;
    step("lints");
    let lint = ["clippy", "--workspace", "--all-targets", "--release", "--", "-D", "warnings"];
    run(cargo().args(lint))?;
    step("documentation");
    let docs = ["doc", "--workspace", "--no-deps", "--release", "--quiet"];
    run(cargo().args(docs).env("RUSTDOCFLAGS", "-D warnings"))?;
    step("Rust tests");
    run(cargo().args(["test", "--workspace", "--release"]))?;
    step("FMPy tests");
    let interpreter = python::interpreter()?;
    run(Command::new(interpreter).args(["-m", "pytest", "-q", "tests/python"]))
}

fn step(name: &str) {
    println!("\n=== {name}");
}
