//! `hotfoot contact`: how a wheelset touches its rails over the lateral displacement.
//!
//! | file | part |
//! |---|---|
//! | `arguments.rs` | its options |
//! | `outline.rs` | the options that it shares with `hotfoot profile` |
//! | `placement.rs` | the wheelset at a displacement: contacts and the loads that they share |
//! | `plot.rs` | what `--plot` draws |
//! | `profile/` | `hotfoot profile`: what is understood of a file of points |

mod arguments;
mod outline;
mod placement;
mod plot;
pub mod profile;

pub use arguments::ContactArguments;
use placement::{Placement, placements};

use crate::error::{ToolError, ensure};

/// Most displacements of a table: each takes a search of some milliseconds.
const MOST_DISPLACEMENTS: f64 = 1e4;

/// The contacts of both wheels as comma-separated values, a row each; or draws them and names the file.
///
/// # Errors
/// When a profile is not known, a wheel stands beside its rail, or the plot cannot be written.
pub fn contact(arguments: &ContactArguments) -> Result<String, ToolError> {
    let span = arguments.to_mm - arguments.from_mm;
    ensure(span >= 0.0, "--to-mm must not be below --from-mm")?;
    ensure(
        span / arguments.step_mm <= MOST_DISPLACEMENTS,
        format!("--step-mm makes more than {MOST_DISPLACEMENTS} rows"),
    )?;
    let placements = placements(arguments)?;
    match &arguments.plot {
        Some(file) => plot::page(arguments, &placements).write(file),
        None => Ok(csv(&placements)),
    }
}

/// The rows of all contacts, with their header.
fn csv(placements: &[Placement]) -> String {
    let mut text = String::from(
        "lateral_mm,roll_mrad,radius_difference_mm,conicity,equivalent_conicity,side,contact,\
         gap_mm,rail_mm,wheel_mm,radius_change_mm,angle_mrad,normal_force_n,a_mm,b_mm,approach_mm\n",
    );
    let optional = |value: Option<f64>| value.map_or(String::new(), |value| format!("{value:.5}"));
    for placement in placements {
        let Placement { lateral_mm, roll_mrad, radius_difference_mm: difference, .. } = placement;
        let conicity = optional(placement.conicity);
        let equivalent = optional(placement.equivalent_conicity);
        let head = format!("{lateral_mm},{roll_mrad:.5},{difference:.5},{conicity},{equivalent}");
        for (side, contacts) in ["left", "right"].into_iter().zip(&placement.wheels) {
            for (number, contact) in contacts.iter().enumerate() {
                let values = contact.values().map(|value| format!("{value:.5}")).join(",");
                text += &format!("{head},{side},{},{values}\n", number + 1);
            }
        }
    }
    text
}
