//! What distinguishes a vehicle of the train from others of its type.

use crate::brake::pipe::Source;

/// A vehicle's part in the train, and the indices of its last lookups.
///
/// The indices speed up the next lookups and do not affect results.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Member {
    /// Group of locomotives whose commands it follows.
    pub group: usize,
    /// Where the commands of its air brake come from.
    pub source: Source,
    /// Force of the shoes by the hand brake, N.
    pub hand_force: f64,
    /// Last lookups in the track.
    pub track_index: [usize; 2],
    /// Last lookup in the friction of the shoes.
    pub friction_index: usize,
}
