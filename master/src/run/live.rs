//! What of a train is shown while it runs.

use numerics::constants::KILOMETRES_PER_HOUR;

use crate::system::step::System;
use crate::system::tap::Tap;
use crate::train::layout::Layout;

/// The signals that are shown while running; none of a system that is no train.
#[derive(Default)]
pub struct LiveFigures {
    /// Speed of the leading vehicle.
    speed: Option<Tap>,
    /// Rear coupler force of each vehicle.
    coupler_forces: Vec<Option<Tap>>,
}

impl LiveFigures {
    /// Those of a train.
    pub fn of(layout: &Layout, system: &mut System) -> Self {
        let mut force = |number| layout.tap_train(system, number, "coupler.rear.force");
        let coupler_forces = (1..=layout.count).map(&mut force).collect();
        Self { speed: layout.tap_train(system, 1, "velocity"), coupler_forces }
    }

    /// Speed of the leading vehicle, and the rear coupler force of the largest magnitude in the train
    /// with its vehicle, counted from one.
    pub fn text(&self, system: &System) -> String {
        let Some(speed) = &self.speed else { return String::new() };
        let force = |tap: &Option<Tap>| tap.as_ref().map_or(0.0, |tap| system.value(tap));
        let forces = self.coupler_forces.iter().map(force);
        let (vehicle, coupler_force) =
            forces.enumerate().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs())).unwrap_or_default();
        format!(
            ", {:.1} km/h, coupler {:.0} kN at {}",
            system.value(speed) * KILOMETRES_PER_HOUR,
            coupler_force / 1e3,
            vehicle + 1,
        )
    }
}
