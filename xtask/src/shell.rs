//! Running commands.

use std::path::Path;
use std::process::Command;

use anyhow::{Context, Result, bail};

/// Makes the root of the workspace the current folder.
pub fn go_to_workspace() -> Result<()> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().context("xtask has a parent")?;
    std::env::set_current_dir(root).with_context(|| root.display().to_string())
}

/// Runs a command and fails if it does.
pub fn run(command: &mut Command) -> Result<()> {
    let status = command.status().with_context(|| format!("cannot start {command:?}"))?;
    if !status.success() {
        bail!("{command:?} failed with {status}");
    }
    Ok(())
}

/// Runs a command and gives what it prints.
pub fn output(command: &mut Command) -> Result<String> {
    let output = command.output().with_context(|| format!("cannot start {command:?}"))?;
    if !output.status.success() {
        bail!("{command:?} failed: {}", String::from_utf8_lossy(&output.stderr));
    }
    Ok(String::from_utf8(output.stdout)?)
}

/// The cargo that runs us.
pub fn cargo() -> Command {
    Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
}

/// The program `hotfoot`, built in release.
pub fn hotfoot() -> Command {
    Command::new(target().join("release/hotfoot"))
}

/// Runs a scenario into a folder, with further arguments of `hotfoot run`.
pub fn run_scenario(scenario: &str, results: &Path, arguments: &[String]) -> Result<()> {
    let command = ["run", scenario, "--overwrite", "--results"];
    run(hotfoot().args(command).arg(results).args(arguments))
}

/// Cargo's target folder.
pub fn target() -> std::path::PathBuf {
    std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| "target".into(), Into::into)
}
