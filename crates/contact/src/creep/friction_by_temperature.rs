//! Friction that falls, or rises, with the temperature of the contact.
//!
//! ```text
//! mu = mu_ref (1 + (A - 1) (T - T_ref)/dT)   from T_ref to T_ref + dT, constant beyond             (C10)
//! ```
//!
//! is CONTACT's law (Vollebregt, user guide, "friction that depends on temperature") with its
//! dmu = (A - 1) mu_ref, there with the temperature of each point. A contact that slips as a whole heats
//! itself: on each strip along the rolling direction temperature and friction fulfil
//!
//! ```text
//! T(x) = T_bulk + integral of mu(T) p w/(2 beta sqrt(pi v (x' - x))) dx' upstream                  (C11)
//! ```
//!
//! With theta = (A - 1) T_1/dT, where T_1 is the highest flash temperature with mu_ref all over, the
//! force by mu_ref N is 1/(1 - 0.636 theta) as long as no point leaves the range, and the highest flash
//! temperature by T_1 is 1/(1 - 0.842 theta + 0.07 theta²): both within 1 % of the solution of C11 for
//! theta from -2 to 0.4 (`analytic_friction_by_temperature_solves_the_strips`). So
//! friction counts at the temperature 0.636 times as high as the highest one, and is found in closed
//! form. Where a part only slips the temperature is overestimated, but low.

use super::friction::Sliding;
use crate::flash::flash_rise;
use crate::geometry::contact_point::ContactPatch;

/// Temperature that counts for the force, by the highest one: the mean over the pressure.
const MEAN: f64 = 0.636;

/// The first power of theta in the highest temperature.
const PEAK: f64 = 0.842;

/// The second power of theta in the highest temperature.
const PEAK_SQUARED: f64 = 0.07;

/// sqrt(k rho c) of steel with 40 W/(m K), 7850 kg/m³ and 450 J/(kg K), in W √s/(m² K).
pub(crate) const STEEL_PENETRATION: f64 = 11_887.0;

/// Friction by the temperature of the contact (C10).
#[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize, serde::Serialize)]
#[serde(deny_unknown_fields)]
pub struct FrictionByTemperature {
    /// mu_ref: friction coefficient up to the reference temperature.
    pub reference_coefficient: f64,
    /// A: friction from the end of the range on by mu_ref, positive.
    pub limit_ratio: f64,
    /// T_ref, in °C.
    pub reference_temperature: f64,
    /// dT: range over which friction changes, in K, positive.
    pub range: f64,
    /// T_bulk: temperature of wheel and rail away from the contact, in °C.
    pub bulk_temperature: f64,
}

impl FrictionByTemperature {
    /// Friction coefficient at a temperature in °C.
    pub fn at(&self, temperature: f64) -> f64 {
        let share = ((temperature - self.reference_temperature) / self.range).clamp(0.0, 1.0);
        self.reference_coefficient * (1.0 + (self.limit_ratio - 1.0) * share)
    }

    /// Friction of a contact whose points slip at `slip_velocity` (m/s), while it rolls at `speed`.
    #[inline]
    pub(crate) fn sliding(&self, patch: &ContactPatch, slip_velocity: f64, speed: f64) -> Sliding {
        let per_metre = 0.5 * patch.normal_force * slip_velocity / speed;
        // Highest rise with a friction coefficient of 1.
        let rise = flash_rise(per_metre, patch.a, patch.b, speed, STEEL_PENETRATION);
        let rise = if patch.normal_force > 0.0 { rise } else { 0.0 };
        let reference = self.reference_coefficient;
        let slope = (self.limit_ratio - 1.0) * reference / self.range;
        let before = self.reference_temperature - self.bulk_temperature;
        // mu = mu_ref + slope (T_bulk + MEAN rise mu - T_ref), of which the whole is the line.
        let resistance = 1.0 - MEAN * rise * slope;
        let line = (reference - slope * before) / resistance;
        let limit = self.limit_ratio * reference;
        let cold = MEAN * rise * reference <= before;
        let hot = MEAN * rise * limit >= before + self.range || resistance <= 0.0;
        let coefficient = if cold {
            reference
        } else if hot {
            limit
        } else {
            line.clamp(reference.min(limit), reference.max(limit))
        };
        let theta = if cold || hot { 0.0 } else { slope * rise };
        let flash = (1.0 - MEAN * theta) / (1.0 - PEAK * theta + PEAK_SQUARED * theta * theta);
        Sliding { coefficient, flash }
    }
}
