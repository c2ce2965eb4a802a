//! `hotfoot creep`: creep forces, friction power and flash temperature of one contact.
//!
//! | file | part |
//! |---|---|
//! | `arguments.rs` | its options |
//! | `row.rs` | what a set of creepages does |
//! | `plot.rs` | what `--plot` draws |

mod arguments;
mod plot;
mod row;

use contact::{CreepForces, TangentialForce};

pub use arguments::CreepArguments;
use row::{Row, rows};

use crate::error::{ToolError, ensure};

/// A row of comma-separated values for each creepage; or draws them and names the file.
///
/// # Errors
/// When the contact is not given, the lists of creepages differ in length, or the plot cannot be
/// written.
pub fn creep(arguments: &CreepArguments) -> Result<String, ToolError> {
    let [initial, remaining] = [0, 1].map(|i| arguments.reduction[i]);
    ensure(
        initial > 0.0 && remaining <= 1.0,
        "--reduction must be k0 greater than zero, alpha between 0 and 1, beta not negative",
    )?;
    let [adhesion, slip] = [0, 1].map(|i| arguments.factors[i]);
    ensure(adhesion >= slip, "--factors must be kA not below kS, both greater than zero")?;
    let rows = rows(arguments)?;
    match &arguments.plot {
        Some(file) => plot::page(arguments, &rows)?.write(file),
        None => Ok(csv(&rows)),
    }
}

/// The rows with their header.
fn csv(rows: &[Row]) -> String {
    let mut text = String::from(
        "longitudinal,lateral,spin_1_m,force_longitudinal_n,force_lateral_n,spin_moment_n_m,\
         friction_power_w,flash_temperature_k\n",
    );
    for Row { creepages: [xi, eta, phi], forces, flash } in rows {
        let CreepForces { force, spin_moment, friction_power, .. } = forces;
        let TangentialForce { longitudinal, lateral } = force;
        text += &format!(
            "{xi},{eta},{phi},{longitudinal:.3},{lateral:.3},{spin_moment:.4},\
             {friction_power:.4},{flash:.3}\n"
        );
    }
    text
}
