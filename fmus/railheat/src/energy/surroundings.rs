//! What the train and a change of the weather do to the elements beyond what untouched rail feels.

use super::model::EnergyModel;
use super::parameters::Parameters;
use super::zones::Zone;
use crate::contact::Wheel;
use crate::section::{add, dot};
use crate::weather::Weather;

impl EnergyModel {
    /// Counts the time for which elements lie under a vehicle or in its shadow.
    pub(super) fn cover(&mut self, weather: &Weather, time: f64) {
        let Parameters { train, line, .. } = &self.parameters;
        let shade = train.shade.filter(|_| weather.direct > 0.0);
        for vehicle in &self.vehicles {
            let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
            for chainage in self.chainages[vehicle.clone()].iter().flatten() {
                (low, high) = (low.min(*chainage), high.max(*chainage));
            }
            if low > high {
                continue;
            }
            let body = [low - train.overhang, high + train.overhang];
            if train.wind_share > 0.0 {
                let under = line.shares(body[0], body[1]);
                under.for_each(|(element, _)| self.state.elements.cover(element, time));
            }
            let middle = line.nearest(0.5 * (low + high));
            let azimuth = self.zones[usize::from(self.zone_of[middle])].sector.azimuth;
            let shadow = shade.and_then(|shade| shade.shadow(&weather.sun, azimuth, body));
            if let Some([from, to]) = shadow {
                let dark = line.shares(from, to);
                dark.for_each(|(element, _)| self.state.elements.shade(element, time));
            }
        }
    }

    /// What touched elements feel of the weather beyond what untouched rail does.
    pub(super) fn update_extra(&mut self, wheels: &[Wheel], weather: &Weather) {
        let Self { parameters: Parameters { train, exchange, .. }, untouched, followers, .. } =
            self;
        let surface = untouched.surface();
        let exposed = surface.exposed();
        let speed = wheels.iter().map(|wheel| wheel.speed.abs()).fold(0.0, f64::max);
        let in_train = exchange.coefficient(weather.wind.max(train.wind_share * speed));
        let train_wind = (in_train - exchange.coefficient(weather.wind)) * exposed;
        for (zone, state) in self.zones.iter_mut().zip(&self.state.untouched) {
            let Zone { extra, initial, light, in_modes, .. } = zone;
            let mean = initial.mean(surface) + dot(&extra.mean, &state.amplitudes);
            let present = exchange.coefficient(weather.wind) + exchange.radiation(mean);
            // In the weather of the start the modes have it all; rounding must not count as a change.
            let change = present - *in_modes;
            let change = if change.abs() < 1e-9 * present { 0.0 } else { change };
            extra.conductance = change * exposed;
            extra.train_wind = train_wind;
            extra.over_air = mean - weather.ambient;
            extra.shade.fill(0.0);
            extra.shade_followed.fill(0.0);
            extra.shade_heat = 0.0;
            if train.shade.is_none() {
                continue;
            }
            for (piece, facet) in surface.facets().iter().enumerate() {
                let heat = facet.length * light.direct[piece];
                if heat > 0.0 {
                    add(&mut extra.shade, heat, untouched.shape(piece));
                    extra.shade_heat += heat;
                }
            }
            followers.read(&mut extra.shade_followed, &extra.shade);
        }
    }
}
