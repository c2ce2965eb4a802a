//! A draft gear: what its file comes down to.
//!
//! | file | part |
//! |---|---|
//! | `file.rs` | the draft-gear file |
//! | `wedge.rs` | its section on a friction clutch |
//! | `force_curve.rs` | force over deflection by points |

mod file;
mod force_curve;
mod wedge;

use files::{Check, Mistake};
use schemars::JsonSchema;
use serde::Deserialize;

pub(crate) use file::GearFile;
pub use force_curve::ForceCurve;
pub use wedge::Wedge;

/// A draft gear: what it does in draft and in buff.
#[derive(Clone, Debug, PartialEq)]
pub struct DraftGear {
    /// Name for people.
    pub name: String,
    /// Where the values come from.
    pub source: String,
    /// Behaviour in draft.
    pub draft: Characteristic,
    /// Behaviour in buff; a gear in a yoke has the same in both.
    pub buff: Characteristic,
}

/// Force over deflection in one direction.
#[derive(Clone, Debug, PartialEq)]
pub struct Characteristic {
    /// Slope of the force while friction holds the gear between its two curves, MN/m.
    pub locked_stiffness_mn_m: f64,
    /// Slope beyond the last point of the curves, where the gear is solid, MN/m.
    pub structure_stiffness_mn_m: f64,
    /// Viscous damping in parallel to the curves, kN s/m.
    pub damping_kn_s_m: f64,
    /// Speed over which one curve blends into the other, mm/s; none: the force is clamped.
    pub transition_speed_mm_s: Option<f64>,
    /// Force while the gear is pushed in.
    pub loading: ForceCurve,
    /// Force while it comes out again.
    pub unloading: ForceCurve,
    /// Force of a hydraulic cushion over the square of its speed, by deflection.
    pub orifice: Option<Orifice>,
}

/// Section `[orifice]`: what it takes to press the oil through.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Orifice {
    /// Deflections, rising from zero, mm.
    pub deflection_mm: Vec<f64>,
    /// Force over the square of the speed, kN s²/m².
    pub resistance_kn_s2_m2: Vec<f64>,
}

impl Characteristic {
    /// The lock must be stiffer than every piece of the curves and than the structure.
    pub(crate) fn check_lock(&self, check: &Check) -> Result<(), Mistake> {
        let slopes = [
            ("structure_stiffness_mn_m", self.structure_stiffness_mn_m),
            ("loading", self.loading.steepest_mn_m()),
            ("unloading", self.unloading.steepest_mn_m()),
        ];
        let locked = self.locked_stiffness_mn_m;
        match slopes.into_iter().find(|(_, slope)| *slope >= locked) {
            None => Ok(()),
            Some((key, slope)) => {
                let wanted = format!(
                    "must be less steep than locked_stiffness_mn_m = {locked}, which holds between the curves"
                );
                Err(check.error(key, format!("{slope} MN/m"), wanted))
            }
        }
    }
}

impl Orifice {
    pub(crate) fn check(&self, check: &Check) -> Result<(), Mistake> {
        let columns = (&self.deflection_mm, &self.resistance_kn_s2_m2);
        check.columns(("deflection_mm", columns.0), ("resistance_kn_s2_m2", columns.1), 1)
    }

    pub(crate) fn scaled(mut self, factor: f64) -> Self {
        self.resistance_kn_s2_m2.iter_mut().for_each(|value| *value *= factor);
        self
    }
}
