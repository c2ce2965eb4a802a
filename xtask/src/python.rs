//! Python environments: that of the tests, and that of the tools that make the wheel.

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::Result;

use crate::shell::{output, run, target};

/// A Python environment with pinned packages.
pub struct Environment {
    /// Its folder in that of cargo's targets.
    pub folder: &'static str,
    /// The file that names the packages.
    pub requirements: &'static str,
}

/// The environment of the tests.
pub const TESTS: Environment =
    Environment { folder: "python", requirements: "tests/python/requirements.txt" };

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

impl Environment {
    /// Its interpreter; makes the environment if it is not there or its requirements have changed.
    pub fn interpreter(&self) -> Result<PathBuf> {
        let folder = target().join(self.folder);
        let interpreter = folder.join("bin/python");
        let installed = folder.join("requirements.txt");
        let wanted = std::fs::read_to_string(self.requirements)?;
        if std::fs::read_to_string(&installed).is_ok_and(|text| text == wanted) {
            return Ok(interpreter);
        }
        run(Command::new("python3").args(["-m", "venv", "--clear"]).arg(&folder))?;
        run(Command::new(&interpreter)
            .args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "-r"])
            .arg(self.requirements))?;
        std::fs::write(installed, wanted)?;
        Ok(interpreter)
    }
}
