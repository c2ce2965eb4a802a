//! What a file of weather says of a time.

use crate::weather::sun::Sun;

/// What a file says of a time.
pub(super) struct Sample {
    /// Temperature of the air, °C.
    pub air: f64,
    /// Speed of the wind, m/s.
    pub wind: f64,
    pub light: Sunlight,
    /// Thermal radiation of the sky on a horizontal surface, W/m².
    pub sky: Option<f64>,
    pub sun: Sun,
}

/// Irradiances, W/m².
pub(super) enum Sunlight {
    /// On a surface that faces the sun, and from the sky on a horizontal one.
    Parts([f64; 2]),
    /// On a horizontal surface from both.
    Global(f64),
}

/// The value between two at a share of the way.
pub(super) fn between([from, to]: [f64; 2], share: f64) -> f64 {
    from + share * (to - from)
}
