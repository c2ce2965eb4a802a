//! The sunlight that the rail's surface absorbs, computed anew when sun or irradiance change.

use super::conditions::Weather;
use super::exchange::{Exchange, Surface};
use crate::section::Outline;

/// What each piece of the surface absorbs.
#[derive(Clone, Debug, Default)]
pub(crate) struct Light {
    /// Weather for which it was computed.
    weather: Option<Weather>,
    /// Of the direct sun, W/m².
    pub direct: Vec<f64>,
    /// In all, W/m².
    pub absorbed: Vec<f64>,
}

impl Light {
    /// The light in a weather on a track of this azimuth.
    pub fn new(
        outline: &Outline,
        surface: &Surface,
        exchange: &Exchange,
        weather: &Weather,
        azimuth: f64,
    ) -> Self {
        let lit = weather.sun.lit(outline, surface.facets(), azimuth);
        let without = Weather { diffuse: 0.0, ..*weather };
        Self {
            weather: Some(*weather),
            direct: surface.absorbed(exchange, &without, &lit),
            absorbed: surface.absorbed(exchange, weather, &lit),
        }
    }

    /// Brings the light on a track of this azimuth up to date.
    pub fn update(
        &mut self,
        outline: &Outline,
        surface: &Surface,
        exchange: &Exchange,
        weather: &Weather,
        azimuth: f64,
    ) {
        let of_light = |w: &Weather| (w.direct, w.diffuse, w.sun);
        if self.weather.as_ref().map(of_light) != Some(of_light(weather)) {
            *self = Self::new(outline, surface, exchange, weather, azimuth);
        }
    }
}
