//! Places at which the whole section is kept: what they have (`sections.rs` has what happens there).

use serde::{Deserialize, Serialize};

use super::along::Along;
use super::elements::Elements;
use super::followers::Followers;

/// What a place has more than untouched rail.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct KeptElement {
    /// The element of the rail with which the place's own begin.
    pub(super) first: usize,
    /// The place among its own elements.
    pub(super) middle: usize,
    /// What they have.
    pub(super) elements: Elements,
}

/// What all places have in common.
pub(super) struct Sections {
    /// No mode follows.
    pub(super) followers: Followers,
    /// Whether the field side is to the right.
    pub(super) field_side_is_right: bool,
    /// Conduction along the track, if wanted.
    pub(super) along: Option<Along>,
    /// Scratch.
    pub(super) source: Vec<f64>,
}
