//! `hotfoot export-ssp`: a scenario's train as a package for other tools.

use std::path::PathBuf;

use anyhow::Result;
use clap::Args;
use hotfoot::run::{Exported, export, workplace};

use crate::run::default_fmus;

/// Arguments of `hotfoot export-ssp`.
#[derive(Args)]
pub struct ExportArguments {
    /// Scenario: its folder or file
    scenario: PathBuf,
    /// Package to write; left out: named as the scenario's folder, in the current folder
    #[arg(long, short)]
    output: Option<PathBuf>,
    /// Folder of Hotfoot's own FMUs; left out: `fmus` beside the folder of the program
    #[arg(long)]
    fmus: Option<PathBuf>,
}

/// Writes a scenario's train as an SSP package, and tells what is in it.
///
/// # Errors
/// When the scenario is wrong, a unit fails, or the package cannot be written.
pub fn export_ssp(arguments: &ExportArguments) -> Result<()> {
    let fmus = arguments.fmus.clone().unwrap_or_else(default_fmus);
    let name = || workplace::scenario_name(&arguments.scenario);
    let target = arguments.output.clone().unwrap_or_else(|| format!("{}.ssp", name()).into());
    let exported = export(&arguments.scenario, &fmus, &target)?;
    let Exported { components, connections } = exported;
    println!("{}: {components} components, {connections} connections", target.display());
    Ok(())
}
