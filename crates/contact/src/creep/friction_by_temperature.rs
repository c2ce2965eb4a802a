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
//! With theta = (A - 1) T_1/dT, where T_1 is the highest flash temperature with mu_ref all over, and as
//! long as no point leaves the range,
//!
//! ```text
//! F/(mu_ref N) = 1/(1 - 0.63 theta),   T_max/T_1 = (1 + 0.2 theta/(1 - 0.49 theta)) F/(mu_ref N)
//! ```
//!
//! for theta from -2 to 0.3 (`analytic_friction_by_temperature_solves_the_strips`: 1.5 %; CONTACT, whose
//! forces ask for 0.63 to 0.64 where the strips have 0.60 to 0.62: 1 %). So friction counts at a rise 0.63
//! times as high as the highest one by friction that is alike all over, and is found in closed form.
//! Where a part only slips the temperature is overestimated, but low.

use super::sliding::Sliding;
use crate::flash::flash_rise;
use crate::geometry::contact_point::ContactPatch;

/// Rise that counts for the force, by the highest one.
const MEAN: f64 = 0.63;

/// How the highest rise changes against the force with theta, first and second power.
const PEAK: [f64; 2] = [0.2, 0.49];

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
        let flash = 1.0 + PEAK[0] * theta / (1.0 - PEAK[1] * theta);
        Sliding { coefficient, flash }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::flash::HERTZ_PEAK;
    use crate::kalker::CreepCoefficients;
    use std::f64::consts::PI;

    /// Elements of a strip.
    const ELEMENTS: usize = 100;

    /// Force by mu_ref N and highest rise by T_1 from C11, element by element from the leading edge.
    fn strips(theta: f64) -> (f64, f64) {
        let step = 2.0 / ELEMENTS as f64;
        let pressure = |i: usize| (1.0 - (1.0 - step * (i as f64 + 0.5)).powi(2)).sqrt();
        // Rise half an element behind the beginning of one so many elements upstream.
        let weight = |distance: usize| {
            let end = step * (distance as f64 + 0.5);
            2.0 * (end.sqrt() - (end - step).max(0.0).sqrt())
        };
        let (mut force, mut whole, mut highest) = (0.0, 0.0, 0.0_f64);
        for strip in 0..20 {
            let y = (f64::from(strip) + 0.5) / 20.0;
            let half = (1.0 - y * y).sqrt();
            let scale = half * half.sqrt() / (HERTZ_PEAK * PI.sqrt());
            let mut flux: Vec<f64> = Vec::new();
            for i in 0..ELEMENTS {
                let upstream: f64 = (0..i).map(|j| flux[j] * weight(i - j)).sum();
                let own = scale * weight(0) * pressure(i);
                let rise = (scale * upstream + own) / (1.0 - theta * own);
                flux.push((1.0 + theta * rise) * pressure(i));
                highest = highest.max(rise);
            }
            force += half * half * flux.iter().sum::<f64>();
            whole += half * half * (0..ELEMENTS).map(pressure).sum::<f64>();
        }
        (force / whole, highest)
    }

    /// The closed form against the strips: 1.5 % in force and 2 % in the highest temperature.
    #[test]
    fn analytic_friction_by_temperature_solves_the_strips() {
        let patch = ContactPatch {
            normal_force: 100e3,
            a: 6e-3,
            b: 9e-3,
            kalker: CreepCoefficients::new(2.0 / 3.0, 0.28),
        };
        let (speed, slip, reference) = (20.0, 4.0, 0.3);
        let per_metre = 0.5 * reference * patch.normal_force * slip / speed;
        let rise = flash_rise(per_metre, patch.a, patch.b, speed, STEEL_PENETRATION);
        for theta in [-2.0, -1.0, -0.5, -0.1, 0.1, 0.3] {
            // The range is wide enough for all temperatures, and A follows from theta.
            let range = 4.0 * rise;
            let friction = FrictionByTemperature {
                reference_coefficient: reference,
                limit_ratio: 1.0 + theta * range / rise,
                reference_temperature: 0.0,
                range,
                bulk_temperature: 0.0,
            };
            let found = friction.sliding(&patch, slip, speed);
            let (force, highest) = strips(theta);
            let share = found.coefficient / reference;
            assert!((share / force - 1.0).abs() < 0.015, "{theta}: {share} for {force}");
            let temperature = found.flash * share;
            assert!(
                (temperature / highest - 1.0).abs() < 0.02,
                "{theta}: {temperature}, {highest}"
            );
        }
    }

    /// Below and beyond the range friction is constant, and so it is without slip. Exact.
    #[test]
    fn analytic_friction_by_temperature_ends() {
        let friction = FrictionByTemperature {
            reference_coefficient: 0.4,
            limit_ratio: 0.5,
            reference_temperature: 100.0,
            range: 200.0,
            bulk_temperature: 20.0,
        };
        let values = [0.0, 100.0, 200.0, 300.0, 900.0].map(|temperature| friction.at(temperature));
        assert_eq!(values, [0.4, 0.4, 0.30000000000000004, 0.2, 0.2]);
        let kalker = CreepCoefficients::new(1.0, 0.28);
        let patch = ContactPatch { normal_force: 100e3, a: 6e-3, b: 6e-3, kalker };
        assert_eq!(friction.sliding(&patch, 0.0, 10.0), Sliding { coefficient: 0.4, flash: 1.0 });
        assert_eq!(friction.sliding(&patch, 50.0, 10.0), Sliding { coefficient: 0.2, flash: 1.0 });
    }
}
