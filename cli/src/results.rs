//! `hotfoot report` and `hotfoot expect`: what is made of the folder that a run has written.

use std::path::Path;

use anyhow::{Result, bail, ensure};
use hotfoot::report;
use hotfoot::run::expected;

/// Makes the report of a results folder again.
///
/// # Errors
/// When the folder is not one that a run has written.
pub fn report(results: &Path) -> Result<()> {
    check_folder(results)?;
    let (file, _) = report::write(results)?;
    println!("{}", file.display());
    Ok(())
}

/// Says how the figures of a run compare with those expected of its scenario.
///
/// # Errors
/// When a file cannot be read, or a figure differs.
pub fn expect(results: &Path, expected: &Path) -> Result<()> {
    check_folder(results)?;
    let comparisons = expected::compare(results, expected)?;
    comparisons.iter().for_each(|comparison| println!("{comparison}"));
    match comparisons.iter().filter(|comparison| !comparison.agrees()).count() {
        0 => Ok(()),
        count => bail!("{count} of {} figures differ", comparisons.len()),
    }
}

/// Refuses a folder that no run has written.
fn check_folder(results: &Path) -> Result<()> {
    files::exists(results)?;
    let is_one = results.join("manifest.toml").is_file();
    ensure!(is_one, "{} is no folder of results: it has no manifest.toml", results.display());
    Ok(())
}
