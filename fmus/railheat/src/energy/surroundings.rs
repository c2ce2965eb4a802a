//! What the train and a change of the weather do to the elements beyond what untouched rail feels.

use super::model::Energy;
use super::parameters::Parameters;
use super::weather::Weather;
use crate::section::{add, dot};
use crate::wheels::Wheel;

impl Energy {
    /// Counts the time for which elements lie under a vehicle.
    pub(super) fn cover(&mut self, time: f64) {
        let Parameters { train, line, .. } = &self.parameters;
        if !(train.shade || train.wind_share > 0.0) {
            return;
        }
        for vehicle in &self.vehicles {
            let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
            for place in self.places[vehicle.clone()].iter().flatten() {
                (low, high) = (low.min(*place), high.max(*place));
            }
            let (from, to) = (low - train.overhang, high + train.overhang);
            if low <= high {
                line.shares(from, to).for_each(|(e, _)| self.state.elements.cover(e, time));
            }
        }
    }

    /// What touched elements feel of the weather beyond what untouched rail does.
    pub(super) fn weigh(&mut self, wheels: &[Wheel], weather: &Weather) {
        let Parameters { train, exchange, .. } = &self.parameters;
        let surface = self.untouched.surface();
        let exposed = surface.exposed();
        let rise = dot(&self.extra.mean, &self.state.untouched.amplitudes);
        let mean = self.untouched.initial_mean() + rise;
        let present = exchange.coefficient(weather.wind) + exchange.radiation(mean);
        // In the weather of the start the modes have it all; rounding must not count as a change.
        let change = present - self.in_modes;
        let change = if change.abs() < 1e-9 * present { 0.0 } else { change };
        self.extra.conductance = change * exposed;
        let speed = wheels.iter().map(|wheel| wheel.speed.abs()).fold(0.0, f64::max);
        let in_train = exchange.coefficient(weather.wind.max(train.wind_share * speed));
        self.extra.train_wind = (in_train - exchange.coefficient(weather.wind)) * exposed;
        self.extra.over_air = mean - weather.ambient;
        self.extra.shade.fill(0.0);
        self.extra.shade_heat = 0.0;
        if !train.shade {
            return;
        }
        let width = self.modes.width();
        for (piece, facet) in surface.facets().iter().enumerate() {
            let heat = facet.length * self.light.direct[piece];
            if heat > 0.0 {
                let shape = self.untouched.shape(piece, width);
                add(&mut self.extra.shade, heat, shape);
                self.extra.shade_heat += heat;
            }
        }
    }
}
