//! Heat by source, and the audit (`docs/theory/railheat/energy.md#eq-23`).

use std::ops::AddAssign;

use serde::{Deserialize, Serialize};

/// Heat since the start by source, J or J/m, positive into the rail.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Sources {
    /// Friction of the wheels.
    pub friction: f64,
    /// Conduction from the wheels.
    pub chill: f64,
    /// Hysteresis of bending.
    pub bending: f64,
    /// Air, sky, sun and pad.
    pub weather: f64,
}

impl Sources {
    /// All heat that came in, less what went out.
    pub fn total(&self) -> f64 {
        self.friction + self.chill + self.bending + self.weather
    }

    /// All of it multiplied, such as heat per metre by metres.
    pub fn times(self, factor: f64) -> Self {
        Self {
            friction: factor * self.friction,
            chill: factor * self.chill,
            bending: factor * self.bending,
            weather: factor * self.weather,
        }
    }

    /// Heat that moved, in or out: the measure of the audit's error.
    pub fn moved(&self) -> f64 {
        self.friction.abs() + self.chill.abs() + self.bending.abs() + self.weather.abs()
    }
}

impl AddAssign for Sources {
    fn add_assign(&mut self, other: Self) {
        self.friction += other.friction;
        self.chill += other.chill;
        self.bending += other.bending;
        self.weather += other.weather;
    }
}

/// Where the heat of the whole modelled rail came from and where it is, J.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Ledger {
    /// Heat in the rail above the initial state, from the temperatures themselves.
    pub stored: f64,
    /// Heat since the start.
    pub sources: Sources,
}

impl Ledger {
    /// Heat that is stored but did not come in, J.
    ///
    /// The heat that goes to the surroundings is summed over the surface, the stored heat over the
    /// volume; `property_energy_audit` bounds the difference by 1e-9 of the heat put in.
    pub fn error(&self) -> f64 {
        self.stored - self.sources.total()
    }
}
