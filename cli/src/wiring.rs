//! `hotfoot wiring`: what a scenario or a package consists of.

use std::path::PathBuf;

use anyhow::Result;
use clap::Args;
use hotfoot::run::wiring;

use crate::output::write;
use crate::run::{default_fmus, scenario_path};
use crate::supervise::command_in_child;
use crate::supervise::limits::Limits;

/// Arguments of `hotfoot wiring`.
#[derive(Args)]
pub struct WiringArguments {
    /// Scenario: its folder or file, or the name of a shipped one; or an SSP package (.ssp, its folder, or .ssd), or
    /// one .fmu
    #[arg(value_parser = scenario_path())]
    scenario: PathBuf,
    /// Print a graph for Graphviz, as for `dot -Tsvg`
    #[arg(long)]
    dot: bool,
    /// Folder of Hotfoot's own FMUs; left out: `fmus` beside the folder of the program
    #[arg(long)]
    fmus: Option<PathBuf>,
    #[command(flatten)]
    limits: Limits,
}

/// Prints the components of a scenario or a package, when they step, and what flows between them.
/// Gives the exit code.
///
/// # Errors
/// When the scenario or package is wrong, or an FMU is missing or unfit.
pub fn print(arguments: &WiringArguments) -> Result<u8> {
    command_in_child(&arguments.limits, || print_here(arguments))
}

fn print_here(arguments: &WiringArguments) -> Result<()> {
    let fmus = arguments.fmus.clone().unwrap_or_else(default_fmus);
    let structure = wiring(&arguments.scenario, &fmus)?;
    write(if arguments.dot { structure.dot() } else { structure.text() })
}
