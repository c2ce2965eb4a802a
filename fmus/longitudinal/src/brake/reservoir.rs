//! The air of a conventional brake: reservoir, leakage and the gradient of the pressure.
//!
//! Pressures are counted in shares of what a full service application takes: the command u lowers the
//! pipe by u, and a cylinder that fills by c takes c from the reservoir of its vehicle. The valve
//! compares pipe and reservoir, so that the reservoir's lack s rises to what the pipe asks for and
//! then laps; when the pipe rises, the reservoir is charged from it (theory, eq. 15c to 15f):
//!
//! ```text
//! filling:     ds = dc   while s < l                     l = min(u + k_p t, u_max (1 − γ x))
//! recharging:  ds/dt = −(s − l)/(τ + τ_x x)   when s > l
//! leaking:     dc/dt = −k_c c
//! ```
//!
//! with the distance x along the pipe from the source of the air, the leakage k_p of a pipe that nobody
//! maintains, k_c of the cylinder, and the gradient γ by which a leaking pipe holds less pressure at
//! its end, so that a full service gives less there. So an application that comes before the
//! reservoirs are full again gives less, or nothing, as conventional brakes do.
//!
//! This is the balance of the air in the empirical class of models of Wu et al., *Freight train air
//! brake models*, 2023; the flow along the pipe and the pressures' own dynamics are not in it. Times and
//! leakages are data of the vehicle; the shipped vehicles have none, because none are published for
//! them. Leakage of the pipe of up to 5 psi in a minute and a gradient of up to 15 psi are what
//! 49 CFR 232.205 lets pass in a train test: 0.19 a minute and 0.58 of a full service of 26 psi.
//!
//! Validated by `analytic_reservoir_…` in `tests/validation/brakes.rs`.

use crate::brake::state::BrakeState;
use crate::command::EMERGENCY;

/// Seconds in a minute.
const MINUTE: f64 = 60.0;

/// The air of one vehicle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Reservoir {
    /// Time constant of recharging, s, and what a metre of pipe adds to it, s/m.
    recharge: [f64; 2],
    /// Leakage of the pipe, 1/s.
    pipe_leakage: f64,
    /// Leakage of the cylinder, 1/s.
    cylinder_leakage: f64,
    /// Gradient of the greatest pressure, 1/m.
    gradient: f64,
}

impl Reservoir {
    /// The air of a vehicle file.
    pub fn new(file: &stock::Reservoir) -> Self {
        Self {
            recharge: [file.recharge_s, file.recharge_s_per_km * 1e-3],
            pipe_leakage: file.pipe_leakage_per_min / MINUTE,
            cylinder_leakage: file.cylinder_leakage_per_min / MINUTE,
            gradient: file.gradient_per_km * 1e-3,
        }
    }

    /// What the pipe asks for at a distance from its source, m.
    pub fn level(&self, state: &BrakeState, distance: f64) -> f64 {
        let greatest = if state.pressure_command == EMERGENCY { EMERGENCY } else { 1.0 };
        let gradient = (1.0 - self.gradient * distance).max(0.0);
        (state.pressure_command + state.leaked).min(greatest * gradient)
    }

    /// Recharges the reservoir and lets pipe and cylinder leak over a time `step`, s.
    pub fn recharge_and_leak(&self, state: &mut BrakeState, distance: f64, step: f64) {
        let [beside, by_distance] = self.recharge;
        let surplus = (state.spent - self.level(state, distance)).max(0.0);
        state.spent -= surplus * (step / (beside + by_distance * distance)).min(1.0);
        if state.pressure_command > 0.0 {
            state.leaked += self.pipe_leakage * step;
        }
        state.cylinder -= self.cylinder_leakage * state.cylinder * step;
    }
}
