//! `hotfoot wiring`: what a scenario or a package consists of.

use std::path::PathBuf;

use anyhow::Result;
use clap::Args;
use hotfoot::Structure;
use hotfoot::run::wiring;
use serde_json::{Value, json};

use crate::options::{Fmus, Settings};
use crate::output::{print_json, write};
use crate::run::scenario_path;
use crate::supervise::command_in_child;
use crate::supervise::limits::Limits;

/// Arguments of `hotfoot wiring`.
#[derive(Args)]
pub struct WiringArguments {
    /// Scenario: its folder or file, or the name of a shipped one; or an SSP package (.ssp, its folder, or .ssd), or
    /// one .fmu
    #[arg(value_parser = scenario_path())]
    scenario: PathBuf,
    #[command(flatten)]
    settings: Settings,
    /// Print JSON
    #[arg(long, conflicts_with = "dot")]
    json: bool,
    /// Print a graph for Graphviz, as for `dot -Tsvg`
    #[arg(long)]
    dot: bool,
    #[command(flatten)]
    fmus: Fmus,
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
    let WiringArguments { scenario, settings, fmus, .. } = arguments;
    let structure = wiring(scenario, &settings.settings, &fmus.folder())?;
    if arguments.json {
        return print_json(&as_json(&structure));
    }
    write(if arguments.dot { structure.dot() } else { structure.text() })
}

/// Components with when they step, and what flows between them.
fn as_json(structure: &Structure) -> Value {
    let Structure { name, components, connections, stages, step, .. } = structure;
    let stage =
        |number: usize| stages.get(number).cloned().unwrap_or_else(|| (number + 1).to_string());
    let components: Vec<Value> = components
        .iter()
        .map(|component| {
            json!({
                "name": component.name,
                "fmu": component.source,
                "stage": stage(component.schedule.stage),
                "every": component.schedule.every,
            })
        })
        .collect();
    let connections: Vec<Value> = connections
        .iter()
        .map(|connection| {
            json!({
                "from": connection.from.to_string(),
                "to": connection.to.to_string(),
                "takes": format!("{:?}", connection.sampling).to_lowercase(),
            })
        })
        .collect();
    json!({ "name": name, "step_s": step, "components": components, "connections": connections })
}
