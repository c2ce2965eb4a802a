//! Conventional air brake, described by its effect and not by the flow of its air.
//!
//! A change of the pressure in the brake pipe runs along the train (`pipe.rs`). Where it has
//! arrived, a vehicle fills or empties its cylinder along the curves of its file (theory,
//! eq. 15a): with the fraction c of the cylinder's pressure and the curve f over the time,
//!
//! ```text
//! dc/dt = f'(f⁻¹(c))      up to c = u, the command
//! ```
//!
//! so that a partial application follows the same curve and stops at its command. Without graduated
//! release, any release empties the cylinder. The air that there is limits it where the file says so
//! (`reservoir.rs`). Validity: shape and times are those of the table that is given; local pressure
//! waves are not in it.
//!
//! Source of the form: empirical models as in Wu et al., *Freight train air brake models*,
//! International Journal of Rail Transportation 11(1), 2023.

use crate::brake::reservoir::Reservoir;
use crate::brake::state::BrakeState;
use crate::command::EMERGENCY;

/// Air brake of one vehicle.
#[derive(Clone, Debug, PartialEq)]
pub struct AirBrake {
    /// Speeds of the pressure wave along the train, m/s.
    service_wave: f64,
    release_wave: f64,
    emergency_wave: f64,
    build_up: Rates,
    emergency_build_up: Rates,
    release: Rates,
    graduated: bool,
    reservoir: Option<Reservoir>,
}

/// Rates of a curve that rises from 0 to 1, by the fraction.
#[derive(Clone, Debug, PartialEq)]
struct Rates {
    /// Fraction at which an interval ends, and the rate in it, 1/s.
    intervals: Vec<(f64, f64)>,
}

impl Rates {
    fn new(curve: &stock::FractionByTime) -> Self {
        let rate = |(t, f): (&[f64], &[f64])| (f[1], (f[1] - f[0]) / (t[1] - t[0]));
        Self {
            intervals: curve.time_s.windows(2).zip(curve.fraction.windows(2)).map(rate).collect(),
        }
    }

    /// The fraction after a time `step`, s.
    fn advanced(&self, fraction: f64, step: f64) -> f64 {
        let interval = self.intervals.iter().find(|(end, _)| fraction < *end);
        fraction + interval.map_or(0.0, |(_, rate)| rate * step)
    }
}

impl AirBrake {
    /// The brake of a vehicle file.
    pub fn new(file: &stock::AirBrake) -> Self {
        Self {
            service_wave: file.service_wave_m_per_s,
            release_wave: file.release_wave_m_per_s,
            emergency_wave: file.emergency_wave_m_per_s,
            build_up: Rates::new(&file.build_up),
            emergency_build_up: Rates::new(&file.emergency_build_up),
            release: Rates::new(&file.release),
            graduated: file.graduated_release,
            reservoir: file.reservoir.as_ref().map(Reservoir::new),
        }
    }

    /// Speed at which a change of the command runs along the train, m/s.
    pub(crate) fn wave(&self, from: f64, to: f64) -> f64 {
        match to {
            EMERGENCY => self.emergency_wave,
            to if to > from => self.service_wave,
            _ => self.release_wave,
        }
    }

    /// The slowest of these speeds, m/s.
    pub(crate) fn slowest_wave(&self) -> f64 {
        self.service_wave.min(self.release_wave).min(self.emergency_wave)
    }

    /// Takes a new command that has arrived along the pipe.
    pub(crate) fn set_pressure_command(&self, state: &mut BrakeState, command: f64) {
        if command < state.pressure_command {
            state.releasing = !self.graduated;
        } else if command > state.pressure_command {
            state.releasing = false;
        }
        state.pressure_command = command;
        state.leaked = 0.0;
    }

    /// Advances the cylinder by a time `step`, s, on a vehicle `distance`, m, from the source of its air.
    pub(crate) fn advance(&self, state: &mut BrakeState, distance: f64, step: f64) {
        if let Some(reservoir) = &self.reservoir {
            reservoir.recharge_and_leak(state, distance, step);
        }
        let now = state.cylinder;
        let target = match &self.reservoir {
            _ if state.releasing => 0.0,
            None => state.pressure_command,
            Some(reservoir) => {
                // Only a graduated release follows the pipe down.
                let level = reservoir.level(state, distance);
                let kept = if self.graduated { now.min(level) } else { now };
                kept + (level - state.spent).max(0.0)
            }
        };
        if now < target {
            let filled = match state.pressure_command {
                EMERGENCY => EMERGENCY * self.emergency_build_up.advanced(now / EMERGENCY, step),
                _ => self.build_up.advanced(now, step),
            };
            state.cylinder = filled.min(target);
            state.spent += state.cylinder - now;
        } else if now > target {
            // Pressure above full service goes at the rate of full service.
            let gone = self.release.advanced((1.0 - now).max(0.0), step) - (1.0 - now).max(0.0);
            state.cylinder = (now - gone).max(target);
        }
    }
}
