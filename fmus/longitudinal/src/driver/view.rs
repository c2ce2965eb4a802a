//! What the driver sees.

use crate::train::dynamics::{TrainDynamics, TrainState};

/// What the driver sees.
#[derive(Clone, Copy, Debug)]
pub struct View<'a> {
    /// Time, s.
    pub time: f64,
    /// Chainage of the leading vehicle's middle, m.
    pub chainage: f64,
    /// Velocity of the leading vehicle, m/s.
    pub velocity: f64,
    /// The train and its state; none before the run begins.
    pub train: Option<(&'a TrainDynamics, &'a TrainState)>,
}
