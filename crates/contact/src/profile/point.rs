//! Height and slope of a profile.

/// Height and slope of a profile at one lateral coordinate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProfilePoint {
    /// Height in m, positive downwards; 0 at the running circle of a wheel and at the top of a rail.
    pub height: f64,
    /// d height / d lateral.
    pub slope: f64,
}
