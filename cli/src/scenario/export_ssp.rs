//! `hotfoot export-ssp`: a scenario's train as a package for other tools.

use std::path::PathBuf;

use anyhow::Result;
use clap::Args;
use files::Setting;
use hotfoot::run::{Exported, export, workplace};

use crate::output::print;
use crate::run::{default_fmus, scenario_path};
use crate::supervise::command_in_child;
use crate::supervise::limits::Limits;

/// Arguments of `hotfoot export-ssp`.
#[derive(Args)]
pub struct ExportArguments {
    /// Scenario: its folder or file, or the name of a shipped one
    #[arg(value_parser = scenario_path())]
    scenario: PathBuf,
    /// Value of a key of the scenario in place of the file's, such as train.speed_m_per_s=20; can be given more
    /// than once
    #[arg(long = "set", value_name = "KEY=VALUE")]
    settings: Vec<Setting>,
    /// Package to write; left out: named as the scenario's folder, in the current folder
    #[arg(long, short)]
    output: Option<PathBuf>,
    /// Folder of Hotfoot's own FMUs; left out: `fmus` beside the folder of the program
    #[arg(long)]
    fmus: Option<PathBuf>,
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
    let fmus = arguments.fmus.clone().unwrap_or_else(default_fmus);
    let name = || workplace::scenario_name(&arguments.scenario);
    let target = arguments.output.clone().unwrap_or_else(|| format!("{}.ssp", name()).into());
    let exported = export(&arguments.scenario, &arguments.settings, &fmus, &target)?;
    let Exported { components, connections } = exported;
    let target = target.display();
    print(format_args!("{target}: {components} components, {connections} connections"))
}
