//! How a file of points is to be read.

/// How a file of points is to be read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// Distance of the running circle from the flange back of a wheel, m.
    pub running_circle: f64,
    /// Cut-off wavelength to which the outline is made smooth, m; 0 leaves the points as they are.
    pub wavelength: f64,
    /// Lengths in the file for a metre, if the file does not say it or is wrong.
    pub per_metre: Option<f64>,
    /// Whether a rail is to be turned round, so that its other side is that of the gauge.
    pub mirrored: bool,
}

impl Reading {
    /// Distance of the running circle from the flange back where nothing is said, m (EN 13715).
    pub const RUNNING_CIRCLE: f64 = 0.070;

    /// Cut-off wavelength of smoothing where nothing is said, m.
    pub const WAVELENGTH: f64 = 0.004;
}

impl Default for Reading {
    fn default() -> Self {
        Self {
            running_circle: Self::RUNNING_CIRCLE,
            wavelength: Self::WAVELENGTH,
            per_metre: None,
            mirrored: false,
        }
    }
}
