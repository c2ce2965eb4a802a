//! Communication points, from integers so that rounding does not add up.

/// Communication points t_k = start + k·length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Clock {
    /// Time of point 0, s.
    pub start: f64,
    /// Time between two points, s.
    pub length: f64,
}

impl Clock {
    /// Time of point `k`, s.
    pub fn at(&self, k: u64) -> f64 {
        self.start + k as f64 * self.length
    }
}

/// A time without the rounding of its last digits, for messages, s.
pub fn shown(time: f64) -> f64 {
    (time * 1e9).round() / 1e9
}
