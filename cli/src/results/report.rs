//! `hotfoot report`: what is made of the folder that a run has written.

use std::path::{Path, PathBuf};

use anyhow::{Result, ensure};
use clap::Args;
use hotfoot::run::folder::claim::{Owner, owner, release};
use hotfoot::run::folder::complete::{complete, is_complete};
use hotfoot::run::{End, Ended};
use hotfoot::{recording, report};

use crate::options::Quiet;
use crate::output::{print, tell};
use crate::supervise::temporary;

/// Arguments of `hotfoot report`.
#[derive(Args)]
pub struct ReportArguments {
    /// Folder that a run has written
    results: PathBuf,
    /// Also write each table as a CSV file into the folder `csv` of the results
    #[arg(long)]
    csv: bool,
    #[command(flatten)]
    quiet: Quiet,
}

/// Makes the report of a results folder again, and completes the results of a run that was killed.
///
/// # Errors
/// When the folder is not one that a run has written.
pub fn report(arguments: &ReportArguments) -> Result<()> {
    let ReportArguments { results, csv, quiet } = arguments;
    temporary::clean_up();
    files::exists(results)?;
    let owner = owner(results)?;
    let recorded_nothing = || format!("{}: the run has recorded nothing", results.display());
    ensure!(owner == Owner::None || results.join("series").exists(), recorded_nothing());
    check_folder(results)?;
    match owner {
        Owner::Living => {
            tell("note: the run goes on; the report shows what is recorded until now");
            report::write(results)?;
        }
        Owner::None if is_complete(results)? => {
            report::write(results)?;
        }
        owner => {
            let ended = match owner {
                Owner::Dead => Ended::because(End::Killed, "the program of the run was killed"),
                _ => Ended::because(End::Failed, "the run could not complete its results"),
            };
            let recorded = complete(results, ended)?;
            ensure!(recorded.is_some(), recorded_nothing());
            release(results);
        }
    }
    if *csv {
        write_csv(results)?;
    }
    if quiet.quiet {
        return Ok(());
    }
    print(results.join("report.html").display())
}

/// Writes the tables in a folder of results as CSV files.
///
/// # Errors
/// When one cannot be read or written.
pub fn write_csv(results: &Path) -> Result<()> {
    Ok(recording::copy_as_csv(&results.join("series"), &results.join("csv"))?)
}

/// Refuses a folder that no run has written.
///
/// # Errors
/// When there is none, or it has no manifest.
pub fn check_folder(results: &Path) -> Result<()> {
    files::exists(results)?;
    let is_one = results.join("manifest.toml").is_file();
    ensure!(is_one, "{} is no folder of results: it has no manifest.toml", results.display());
    Ok(())
}
