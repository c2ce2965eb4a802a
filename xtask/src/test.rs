//! The whole test run.

use std::process::Command;

use anyhow::Result;

use crate::shell::{cargo, output, run, target};
use crate::{fmus, python};

/// Format, lints, FMUs and their model descriptions, Rust tests, FMPy tests, the crate `fmi`.
pub fn run_all() -> Result<()> {
    step("format");
    run(cargo().args(["fmt", "--all", "--check"]))?;
    step("build");
    // All at once, since the tests' dependencies give others more features: built one after the
    // other, half of the workspace would be compiled twice.
    let targets = ["--lib", "--bins", "--tests"];
    run(cargo().args(["build", "--release", "--workspace"]).args(targets))?;
    fmus::pack()?;
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
    run(Command::new(interpreter).args(["-m", "pytest", "-q", "-n", "auto", "tests/python"]))?;
    step("the crate fmi as importer");
    importer()
}

/// The tests with the crate `fmi`, which generates its bindings with libclang: that of the Python
/// environment, with the headers of the C compiler.
fn importer() -> Result<()> {
    let headers = output(Command::new("cc").arg("-print-file-name=include"))?;
    run(cargo()
        .args(["test", "--release", "--manifest-path", "tests/interop/Cargo.toml"])
        .env("CARGO_TARGET_DIR", target().join("interop"))
        .env("LIBCLANG_PATH", python::libclang()?)
        .env("BINDGEN_EXTRA_CLANG_ARGS", format!("-I{}", headers.trim()))
        .env("HOTFOOT_FMUS", std::path::absolute(target().join("fmus"))?))
}

fn step(name: &str) {
    println!("\n=== {name}");
}
