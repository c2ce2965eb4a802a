//! Tractive effort of a locomotive by notch and speed.
//!
//! ```text
//! F = min(f_N T(v), μ(v) m g, p_N η P / v)      (theory, eq. 12)
//! ```
//!
//! with the effort limit T of the drive, the adhesion μ, the power P for traction, its share η at
//! the rail, and the shares f_N and p_N of effort and power in the notch. Between two notches, while
//! the drive is on its way, the shares are linear.
//!
//! Form: Cole 2006, ch. 9, with tables where Cole has fractions of N. Validated by
//! `benchmark_traction_in_notches_5_and_8`: 172.6 and 327.1 kN for two locomotives at 60 km/h.

use numerics::{LinearTable, TableError};

use crate::gravity::STANDARD_GRAVITY;

/// Number of the highest notch.
pub const HIGHEST_NOTCH: f64 = 8.0;

/// Kilometres per hour in a metre per second.
const KMH: f64 = 3.6;

/// Traction of one locomotive.
#[derive(Clone, Debug, PartialEq)]
pub struct Traction {
    /// Power at the rail in the highest notch, W.
    power: f64,
    /// Share of the power by lever (0 to 1).
    power_share: LinearTable,
    /// Share of the effort limit by lever.
    effort_share: LinearTable,
    /// Effort limit of the drive by speed, N over m/s.
    effort: LinearTable,
    /// Effort that the wheels find adhesion for, N over m/s.
    adhesion: LinearTable,
    /// Time from idle to the highest notch, s.
    pub ramp: f64,
}

impl Traction {
    /// The traction of a locomotive of `mass`, kg.
    ///
    /// # Errors
    /// When a table cannot be used.
    pub fn new(file: &stock::Traction, mass: f64) -> Result<Self, TableError> {
        let by_speed = |speed_kmh: &[f64], values: &[f64], unit: f64| {
            let speeds = speed_kmh.iter().map(|v| v / KMH).collect();
            LinearTable::new(speeds, values.iter().map(|value| value * unit).collect())
        };
        let by_lever = |shares: &[f64]| {
            let levers = (0..shares.len()).map(|notch| notch as f64 / HIGHEST_NOTCH);
            LinearTable::new(levers.collect(), shares.to_vec())
        };
        Ok(Self {
            power: file.power_kw * 1e3 * file.efficiency,
            power_share: by_lever(&file.notch_power)?,
            effort_share: by_lever(&file.notch_effort)?,
            effort: by_speed(&file.effort.speed_kmh, &file.effort.effort_kn, 1e3)?,
            adhesion: by_speed(
                &file.adhesion.speed_kmh,
                &file.adhesion.value,
                mass * STANDARD_GRAVITY,
            )?,
            ramp: file.ramp_s,
        })
    }

    /// Effort at a lever from 0 (idle) to 1 (highest notch) and a speed, m/s, in N.
    pub fn force(&self, lever: f64, speed: f64) -> f64 {
        let at = |table: &LinearTable, x: f64| table.value(x, &mut 0);
        let limit = at(&self.effort_share, lever) * at(&self.effort, speed);
        let power = self.power * at(&self.power_share, lever);
        let force = limit.min(at(&self.adhesion, speed));
        // Not a quotient, so that standstill needs no case of its own.
        match force * speed > power {
            true => power / speed,
            false => force,
        }
    }
}
