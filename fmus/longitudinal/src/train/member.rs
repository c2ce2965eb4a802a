//! What tells a vehicle of the train from others of its type.

use crate::brake::pipe::Source;

/// A vehicle's part in the train, and the places of its last lookups, which speed up the next ones
/// and have no influence on results.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Member {
    /// Group of locomotives whose commands it follows.
    pub group: usize,
    /// What its brake listens to, if the pipe commands it.
    pub source: Source,
    /// Force of the shoes by the hand brake, N.
    pub hand_force: f64,
    /// Places of the last lookups in the track.
    pub track_index: [usize; 2],
    /// Place of the last lookup in the friction of the shoes.
    pub friction_index: usize,
}
