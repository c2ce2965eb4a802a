//! `hotfoot export-ssp`: a scenario's train as a package for other tools.

use std::path::PathBuf;

use anyhow::Result;
use clap::Args;
use hotfoot::run::{Exported, export, workplace};

use crate::options::{Fmus, Quiet, Settings};
use crate::output::print;
use crate::run::scenario_path;
use crate::supervise::command_in_child;
use crate::supervise::limits::Limits;

/// Arguments of `hotfoot export-ssp`.
#[derive(Args)]
pub struct ExportArguments {
    /// Scenario: its folder or file, or the name of a shipped one
    #[arg(value_parser = scenario_path())]
    scenario: PathBuf,
    #[command(flatten)]
    settings: Settings,
    /// Package to write; left out: named as the scenario's folder, in the current folder
    #[arg(long, short)]
    output: Option<PathBuf>,
    #[command(flatten)]
    fmus: Fmus,
    #[command(flatten)]
    quiet: Quiet,
    #[command(flatten)]
    limits: Limits,
}

/// Writes a scenario's train as an SSP package, in a child process, and tells what is in it.
/// Gives the exit code.
///
/// # Errors
/// When the scenario is wrong, a unit fails, or the package cannot be written.
pub fn export_ssp(arguments: &ExportArguments) -> Result<u8> {
    command_in_child(&arguments.limits, || export_here(arguments))
}

fn export_here(arguments: &ExportArguments) -> Result<()> {
    let settings = &arguments.settings.settings;
    let name = || workplace::scenario_name(&arguments.scenario);
    let target = arguments.output.clone().unwrap_or_else(|| format!("{}.ssp", name()).into());
    let exported = export(&arguments.scenario, settings, &arguments.fmus.folder(), &target)?;
    let Exported { components, connections } = exported;
    if arguments.quiet.quiet {
        return Ok(());
    }
    let target = target.display();
    print(format_args!("{target}: {components} components, {connections} connections"))
}
