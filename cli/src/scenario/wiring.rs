//! `hotfoot wiring`: what a scenario or a package consists of.

use std::path::PathBuf;

use anyhow::Result;
use clap::Args;
use files::Setting;
use hotfoot::Structure;
use hotfoot::run::wiring;
use serde_json::{Value, json};

use crate::output::{print_json, write};
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
    /// Value of a key of the scenario in place of the file's, such as train.speed_m_per_s=20; can be given more
    /// than once
    #[arg(long = "set", value_name = "KEY=VALUE")]
    settings: Vec<Setting>,
    /// Print JSON
    #[arg(long, conflicts_with = "dot")]
    json: bool,
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
    let structure = wiring(&arguments.scenario, &arguments.settings, &fmus)?;
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
