//! Propulsion resistance of a vehicle on straight level track, and the wind.
//!
//! ```text
//! R = a + b v + c v² + S max(0, 1 − v/v_S)      (theory, eq. 9)
//! W = −c ((v + w) |v + w| − v |v|)              (theory, eq. 9a)
//! ```
//!
//! with the coefficients of a formula, each in its file, or with a table that replaces the first
//! three terms. S is what it takes to set the vehicle in motion, gone at the speed v_S; w is the wind
//! against the running direction, and W what it adds: a tail wind may push. Valid up to the speeds of freight trains, about 120 km/h; a side wind does not
//! count.
//!
//! Validated by `benchmark_resistance_of_the_train_at_60_kmh`: 209.9 kN for the paper's train.

use numerics::constants::KILOMETRES_PER_HOUR;
use numerics::{LinearTable, TableError};
use stock::ResistanceFormula;

use super::coefficients::Coefficients;
use super::{aar_rp548, arema, canadian_national, cole, davis};

/// Propulsion resistance.
#[derive(Clone, Debug, PartialEq)]
pub struct Resistance {
    /// N.
    constant: f64,
    /// N s/m.
    linear: f64,
    /// Part of the air, N s²/m².
    quadratic: f64,
    /// Force over m/s that replaces the three.
    table: Option<LinearTable>,
    /// What setting in motion takes beyond that, N.
    starting: f64,
    /// Speed at which nothing of it is left, m/s.
    starting_until: f64,
}

/// The coefficients of the file's formula for a mass, t, on axles; those of a table are zero.
fn coefficients(file: &stock::Resistance, tonnes: f64, axles: f64) -> Coefficients {
    let air = file.air_coefficient.unwrap_or_default();
    let area = file.area_m2.unwrap_or_default();
    match file.formula {
        ResistanceFormula::Coefficients => Coefficients {
            constant: file.constant_n_per_t * tonnes + file.axle_n * axles,
            linear: file.linear_n_per_t_kmh * tonnes,
            quadratic: file.quadratic_n_per_kmh2,
        },
        ResistanceFormula::Davis => davis::coefficients(tonnes, axles, air, area),
        ResistanceFormula::AarRp548 => aar_rp548::coefficients(tonnes),
        ResistanceFormula::Arema => arema::coefficients(tonnes, axles, air),
        ResistanceFormula::CanadianNational => {
            canadian_national::coefficients(tonnes, axles, air, area)
        }
        ResistanceFormula::Cole => cole::coefficients(tonnes, axles, air),
        ResistanceFormula::Table => Coefficients::default(),
    }
}

impl Resistance {
    /// The resistance of a vehicle.
    ///
    /// # Errors
    /// When its table cannot be used.
    pub fn new(vehicle: &stock::Vehicle) -> Result<Self, TableError> {
        let file = &vehicle.resistance;
        let tonnes = vehicle.mass_kg * 1e-3;
        let formula = file.factor * coefficients(file, tonnes, f64::from(vehicle.axles));
        let table = file.table.as_ref().map(|table| {
            let speeds = table.speed_kmh.iter().map(|v| v / KILOMETRES_PER_HOUR).collect();
            LinearTable::new(
                speeds,
                table.effort_kn.iter().map(|f| f * 1e3 * file.factor).collect(),
            )
        });
        Ok(Self {
            constant: formula.constant,
            linear: formula.linear * KILOMETRES_PER_HOUR,
            quadratic: formula.quadratic * KILOMETRES_PER_HOUR * KILOMETRES_PER_HOUR,
            table: table.transpose()?,
            starting: file.starting_n_per_t * tonnes,
            starting_until: file.starting_until_kmh / KILOMETRES_PER_HOUR,
        })
    }

    /// Greatest force against the motion at a speed, m/s, in N.
    ///
    /// At standstill it is what sets the vehicle in motion.
    #[inline]
    pub fn force(&self, speed: f64) -> f64 {
        let rolling = match &self.table {
            None => self.constant + speed * (self.linear + speed * self.quadratic),
            Some(table) => table.value(speed, &mut 0),
        };
        match self.starting > 0.0 && speed < self.starting_until {
            true => rolling + self.starting * (1.0 - speed / self.starting_until),
            false => rolling,
        }
    }

    /// What a wind against the running direction, m/s, adds at a velocity, m/s, in N; positive
    /// forward.
    #[inline]
    pub fn wind(&self, velocity: f64, headwind: f64) -> f64 {
        let air = velocity + headwind;
        -self.quadratic * (air * air.abs() - velocity * velocity.abs())
    }
}
