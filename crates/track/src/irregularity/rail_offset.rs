//! The offset of a rail.

/// Offset of one rail from its designed line, and the change of the offset along the track.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RailOffset {
    /// Across, to the right, m.
    pub lateral: f64,
    /// Down, m.
    pub vertical: f64,
    /// Change of `lateral` along the track, m/m.
    pub lateral_slope: f64,
    /// Change of `vertical` along the track, m/m.
    pub vertical_slope: f64,
}
