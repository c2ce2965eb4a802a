//! The weather at a time.

use serde::{Deserialize, Serialize};

use super::sun::Sun;

/// The weather.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Weather {
    /// Temperature of the air T_a, K.
    pub ambient: f64,
    /// Wind speed W, m/s.
    pub wind: f64,
    /// Direct irradiance of a surface that faces the sun, before the filter I, W/m².
    pub direct: f64,
    /// Diffuse irradiance of a horizontal surface D, W/m².
    pub diffuse: f64,
    /// Thermal radiation of the sky on a horizontal surface, W/m²; none: as [`Exchange`] says.
    ///
    /// [`Exchange`]: super::Exchange
    pub sky: Option<f64>,
    /// Where the sun stands.
    pub sun: Sun,
}

impl Weather {
    /// Air of a temperature in K without wind, and no sun.
    pub const fn still(ambient: f64) -> Self {
        let sun = Sun { elevation: 0.0, azimuth: 0.0 };
        Self { ambient, wind: 0.0, direct: 0.0, diffuse: 0.0, sky: None, sun }
    }
}
