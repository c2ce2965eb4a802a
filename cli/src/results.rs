//! `hotfoot report` and `hotfoot expect`: what is made of the folder that a run has written.

use std::path::Path;

use hotfoot::report;
use hotfoot::run::expected;
use miette::{IntoDiagnostic, Result, miette};

/// Makes the report of a results folder again.
///
/// # Errors
/// When the folder is not one that a run has written.
pub fn report(results: &Path) -> Result<()> {
    let (file, _) = report::write(results).into_diagnostic()?;
    println!("{}", file.display());
    Ok(())
}

/// Says how the figures of a run compare with those expected of its scenario.
///
/// # Errors
/// When a file cannot be read, or a figure differs.
pub fn expect(results: &Path, expected: &Path) -> Result<()> {
    let comparisons = expected::compare(results, expected).into_diagnostic()?;
    comparisons.iter().for_each(|comparison| println!("{comparison}"));
    match comparisons.iter().filter(|comparison| !comparison.agrees()).count() {
        0 => Ok(()),
        count => Err(miette!("{count} of {} figures differ", comparisons.len())),
    }
}
