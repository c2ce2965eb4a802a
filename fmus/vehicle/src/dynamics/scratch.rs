//! What a step works with besides the state: arrays that every step fills anew.

use crate::body::{Frame, Placement, Seen, Wrench};
use crate::structure::Structure;
use crate::suspension::energy::ElementEnergy;
use crate::suspension::pair::Between;
use crate::track::RailMotion;

/// Scratch of a step. All of it follows from the state, so that nothing here needs saving.
#[derive(Clone, Debug)]
pub(crate) struct Scratch {
    /// The track under each body where it is.
    pub frames: Vec<Frame>,
    /// The rails under each wheelset, left and right.
    pub rails: Vec<[RailMotion; 2]>,
    /// Each body's frame in the frame of the first body.
    pub placements: Vec<Placement>,
    /// Each body in the frame of the first body.
    pub seen: Vec<Seen>,
    /// What passes between the bodies of each pair.
    pub between: Vec<Between>,
    /// Force and moment on each body, in its own frame.
    pub wrenches: Vec<Wrench>,
    /// Energy in the force elements in the middle of the last step.
    pub elements: ElementEnergy,
    /// Length of step, s, for which `decay` holds.
    pub step: f64,
    /// Factor by which each damper's force decays in a step.
    pub decay: Vec<f64>,
    /// Where the track was looked up last.
    pub track_index: usize,
    /// Where the friction along the line was looked up last.
    pub friction_index: usize,
}

impl Scratch {
    /// Scratch for this vehicle.
    pub fn new(structure: &Structure) -> Self {
        let bodies = structure.bodies.len();
        Self {
            frames: vec![Frame::default(); bodies],
            rails: vec![Default::default(); structure.wheelsets.len()],
            placements: vec![Placement::default(); bodies],
            seen: vec![Seen::default(); bodies],
            between: vec![Between::default(); structure.suspension.pairs.len()],
            wrenches: vec![Wrench::default(); bodies],
            elements: ElementEnergy::default(),
            step: 0.0,
            decay: vec![0.0; structure.suspension.dampers.len()],
            track_index: 0,
            friction_index: 0,
        }
    }
}
