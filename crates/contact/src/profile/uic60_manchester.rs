//! UIC60 of the Manchester contact benchmark, to repeat that benchmark; use 60E1 otherwise.
//!
//! Source: Shackleton and Iwnicki 2006.
//!
//! The benchmark gives points. They are arcs of the same radii as 60E1, but with corners of 0.1 and
//! 0.4 degrees where the arcs meet, which lift the gauge corner by 0.04 mm: enough to move the contact
//! on the flange root by half a millimetre. The corners are fitted here to 27 points of the file
//! `MBench_UIC60_v3.prr` (CONTACT's examples): at most 0.005 mm off from the gauge corner to the
//! field side's shoulder, and 0.012 mm at the field side's corner, which no wheel touches.

use super::rail_head::HalfArc;

/// From the middle outwards.
pub(super) const ARCS: [HalfArc; 3] = [
    HalfArc::tangent(0.300, 0.010317449),
    HalfArc::cornered(0.080, 0.026102323, 0.032677301),
    HalfArc::cornered(0.013, 0.036, 0.237823108),
];
