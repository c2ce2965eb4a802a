//! The paper's four scenarios: run one after the other, and what was measured as a table.

use std::path::Path;

use anyhow::Result;

use crate::package;
use crate::shell::run_scenario;

/// The scenarios.
const CASES: [&str; 4] = [
    "straight-constant-speed",
    "straight-increasing-speed",
    "curve-constant-speed",
    "curve-increasing-speed",
];

/// Runs all of them into folders in `results`, with further arguments of `hotfoot run`.
pub fn run_all(results: &Path, arguments: &[String]) -> Result<()> {
    for name in CASES {
        run_scenario(&format!("scenarios/{name}"), &results.join(name), arguments)?;
    }
    Ok(())
}

/// Prints the table of the runs in `results`.
pub fn print(results: &Path) -> Result<()> {
    package::read_by("examples/read-results/scenario_table.py", results)
}
