//! The Python environment of the FMPy tests.

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::Result;

use crate::shell::{output, run, target};

/// Pinned packages.
const REQUIREMENTS: &str = "tests/python/requirements.txt";

/// The folder of libclang in the environment, for crates that generate their bindings.
pub fn libclang(interpreter: &Path) -> Result<PathBuf> {
    let mut python = Command::new(interpreter);
    python.args(["-c", "import clang, os; print(os.path.join(clang.__path__[0], 'native'))"]);
    Ok(output(&mut python)?.trim().into())
}

/// A program that a package of the environment brings.
pub fn program(interpreter: &Path, name: &str) -> PathBuf {
    interpreter.with_file_name(name)
}

/// The interpreter of the environment; makes the environment if it is not there or its
/// requirements have changed.
pub fn interpreter() -> Result<PathBuf> {
    let folder = target().join("python");
    let interpreter = folder.join("bin/python");
    let installed = folder.join("requirements.txt");
    let wanted = std::fs::read_to_string(REQUIREMENTS)?;
    if std::fs::read_to_string(&installed).is_ok_and(|text| text == wanted) {
        return Ok(interpreter);
    }
    run(Command::new("python3").args(["-m", "venv", "--clear"]).arg(&folder))?;
    run(Command::new(&interpreter)
        .args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "-r"])
        .arg(REQUIREMENTS))?;
    std::fs::write(installed, wanted)?;
    Ok(interpreter)
}
