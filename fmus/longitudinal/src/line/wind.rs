//! The wind over the line.

/// A uniform wind.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wind {
    /// Speed of the air, m/s.
    pub speed: f64,
    /// Angle that it comes from, to the right of the heading at the beginning of the track, rad:
    /// zero is a head wind there.
    pub direction: f64,
}

impl Wind {
    /// Its part against a heading, rad, from the beginning of the track, m/s.
    pub fn against(&self, heading: f64) -> f64 {
        self.speed * (self.direction - heading).cos()
    }
}
