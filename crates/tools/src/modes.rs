//! `hotfoot modes`: natural frequencies, damping and shapes of a vehicle on its suspension.

use std::fmt::Write;

use clap::Args;
use vehicle::linear::{Mode, Surfaces, System};
use vehicle::structure::Structure;

use crate::VehicleArgument;
use crate::error::ToolError;

/// Names of a body's coordinates.
const COORDINATES: [&str; 6] = ["x", "y", "z", "roll", "pitch", "yaw"];

/// Least share of the kinetic energy that the table names.
const LEAST_SHARE: f64 = 0.05;

/// Arguments of `hotfoot modes`.
#[derive(Args)]
pub struct ModesArguments {
    #[command(flatten)]
    /// The vehicle.
    pub vehicle: VehicleArgument,
    /// Dry friction sticks; otherwise surfaces slide without friction
    #[arg(long)]
    stick: bool,
    /// Leave all damping out
    #[arg(long)]
    undamped: bool,
    /// Print comma-separated values with the whole shapes
    #[arg(long)]
    csv: bool,
}

/// The modes of a vehicle whose wheelsets are held, as a table or as comma-separated values.
///
/// # Errors
/// When the vehicle cannot be read.
pub fn modes(arguments: &ModesArguments) -> Result<String, ToolError> {
    let structure = arguments.vehicle.structure()?;
    let surfaces = if arguments.stick { Surfaces::Stick } else { Surfaces::Slide };
    let mut system = System::new(&structure, surfaces).with_wheelsets_held(&structure);
    if arguments.undamped {
        system = system.without_damping();
    }
    let modes = system.modes().oscillating;
    let text = if arguments.csv { csv } else { table };
    Ok(text(&structure, &modes))
}

/// The modes as a table, with the coordinates that hold most of the kinetic energy.
fn table(structure: &Structure, modes: &[Mode]) -> String {
    let mut text = String::from("frequency  damping  share of the kinetic energy\n");
    text += "       Hz        %\n";
    for mode in modes {
        let mut shares: Vec<(usize, f64)> = mode.energy.iter().copied().enumerate().collect();
        shares.retain(|(_, share)| *share >= LEAST_SHARE);
        shares.sort_by(|a, b| b.1.total_cmp(&a.1));
        let names: Vec<String> = shares
            .iter()
            .map(|(i, share)| {
                let (body, coordinate) = (&structure.bodies[i / 6], COORDINATES[i % 6]);
                format!("{} {coordinate} {:.0} %", body.name, 100.0 * share)
            })
            .collect();
        let (frequency, damping) = (mode.frequency(), 100.0 * mode.damping_ratio());
        let _ = writeln!(text, "{frequency:9.3}  {damping:7.2}  {}", names.join(", "));
    }
    text
}

/// The modes as comma-separated values: real and imaginary part of every coordinate.
fn csv(structure: &Structure, modes: &[Mode]) -> String {
    let mut text = String::from("frequency_hz,damping_ratio");
    let free = structure.bodies.iter().filter(|body| !body.turns);
    for body in free {
        for coordinate in COORDINATES {
            let name = format!("{}.{coordinate}", body.name);
            let _ = write!(text, ",{name}.re,{name}.im");
        }
    }
    text.push('\n');
    for mode in modes {
        let _ = write!(text, "{},{}", mode.frequency(), mode.damping_ratio());
        for value in mode.shape.iter() {
            let _ = write!(text, ",{:e},{:e}", value.re, value.im);
        }
        text.push('\n');
    }
    text
}
