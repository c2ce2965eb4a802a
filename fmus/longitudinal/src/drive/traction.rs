//! Tractive effort of a locomotive by notch and speed.
//!
//! ```text
//! F = min(f_N T(v), μ(v) m g, p_N η P / v)      (theory, eq. 12)
//! ```
//!
//! with the effort limit T of the drive, the adhesion μ, the power P for traction, its share η at
//! the rail, and the shares f_N and p_N of effort and power in the notch. Between two notches, while
//! the lever moves, and with a continuous throttle, the shares are linear. A table for each notch may
//! replace `f_N T(v)`; power and adhesion limit only where they are given.
//!
//! Form: Cole 2006, ch. 9, with tables where Cole has fractions of N. Validated by
//! `benchmark_traction_in_notches_5_and_8`: 172.6 and 327.1 kN for two locomotives at 60 km/h.

use numerics::constants::{KILOMETRES_PER_HOUR, STANDARD_GRAVITY};
use numerics::{Interpolation, LinearTable, Piecewise, TableError};
use stock::Between;

use crate::command::HIGHEST_NOTCH;

/// Traction of one locomotive.
#[derive(Clone, Debug, PartialEq)]
pub struct Traction {
    /// Power at the rail in the highest notch, W; without a limit infinite.
    power: f64,
    /// Share of the power by lever (0 to 1).
    power_share: LinearTable,
    effort: Effort,
    /// Effort that the wheels find adhesion for, N over m/s.
    adhesion: Option<LinearTable>,
    /// Time from idle to the highest notch, s.
    pub ramp: f64,
}

/// Effort limit of the drive.
#[derive(Clone, Debug, PartialEq)]
enum Effort {
    /// A share by lever of a limit by speed, N over m/s.
    Share(LinearTable, Piecewise),
    /// By speed, N over m/s, in each notch from 1.
    ByNotch(Vec<LinearTable>),
}

fn by_speed(speed_kmh: &[f64], values: &[f64], unit: f64) -> Result<LinearTable, TableError> {
    let speeds = speed_kmh.iter().map(|v| v / KILOMETRES_PER_HOUR).collect();
    LinearTable::new(speeds, values.iter().map(|value| value * unit).collect())
}

fn by_lever(shares: &[f64]) -> Result<LinearTable, TableError> {
    let levers = (0..shares.len()).map(|notch| notch as f64 / HIGHEST_NOTCH);
    LinearTable::new(levers.collect(), shares.to_vec())
}

/// An effort of a file by speed, N over m/s.
pub(crate) fn effort_by_speed(file: &stock::EffortBySpeed) -> Result<Piecewise, TableError> {
    let efforts: Vec<f64> = file.effort_kn.iter().map(|f| f * 1e3).collect();
    let interpolation = match file.interpolation {
        Between::Linear => Interpolation::Linear,
        Between::Cubic => Interpolation::Cubic,
    };
    Piecewise::new(
        file.speed_kmh.iter().map(|v| v / KILOMETRES_PER_HOUR).collect(),
        &efforts,
        interpolation,
    )
}

impl Traction {
    /// The traction of a locomotive of `mass`, kg.
    ///
    /// # Errors
    /// When a table cannot be used.
    pub fn new(file: &stock::Traction, mass: f64) -> Result<Self, TableError> {
        let weight = mass * STANDARD_GRAVITY;
        let adhesion = file.adhesion.as_ref();
        let effort = match (&file.effort, &file.by_notch) {
            (Some(effort), _) => {
                Effort::Share(by_lever(&file.notch_effort)?, effort_by_speed(effort)?)
            }
            (None, by_notch) => {
                let tables = by_notch.iter().flat_map(|table| {
                    table.effort_kn.iter().map(|row| by_speed(&table.speed_kmh, row, 1e3))
                });
                Effort::ByNotch(tables.collect::<Result<_, _>>()?)
            }
        };
        Ok(Self {
            power: file.power_kw.map_or(f64::INFINITY, |kw| kw * 1e3 * file.efficiency),
            power_share: match file.power_kw {
                Some(_) => by_lever(&file.notch_power)?,
                None => LinearTable::new(vec![0.0], vec![1.0])?,
            },
            effort,
            adhesion: adhesion.map(|a| by_speed(&a.speed_kmh, &a.value, weight)).transpose()?,
            ramp: file.ramp_s,
        })
    }

    /// Effort at a lever from 0 (idle) to 1 (highest notch) and a speed, m/s, in N.
    pub fn force(&self, lever: f64, speed: f64) -> f64 {
        let at = |table: &LinearTable, x: f64| table.value(x, &mut 0);
        let limit = match &self.effort {
            Effort::Share(share, effort) => at(share, lever) * effort.value(speed, &mut 0),
            Effort::ByNotch(notches) => between_notches(notches, lever, speed),
        };
        let power = self.power * at(&self.power_share, lever);
        let force = match &self.adhesion {
            Some(adhesion) => limit.min(at(adhesion, speed)),
            None => limit,
        };
        // Not a quotient, so that standstill needs no case of its own.
        match force * speed > power {
            true => power / speed,
            false => force,
        }
    }
}

/// Effort between the tables of two notches, linear in the lever.
fn between_notches(notches: &[LinearTable], lever: f64, speed: f64) -> f64 {
    let notch = lever * HIGHEST_NOTCH;
    let below = notch.floor();
    let at = |notch: f64| match notches.get((notch as usize).wrapping_sub(1)) {
        Some(table) => table.value(speed, &mut 0),
        None => 0.0,
    };
    match notch - below {
        0.0 => at(below),
        share => at(below) + share * (at(below + 1.0) - at(below)),
    }
}
