//! A rail head of one crown radius, for tests: on it a cone touches at one fixed point.

use super::rail_head::HalfArc;

/// Crown of 300 mm and corner of 13 mm, as wide as 60E1.
pub(super) const ARCS: [HalfArc; 2] =
    [HalfArc::tangent(0.300, 0.026), HalfArc::tangent(0.013, 0.037)];
