//! Rail profile 60E1 (EN 13674-1, formerly UIC60): crown, shoulder and gauge corner.
//!
//! The arcs R300, R80 and R13 join tangentially; the flank 1:20 that follows at 36 mm is steeper
//! than any wheel and never touched. The chain lies within 0.04 mm of the point file of the
//! Manchester contact benchmark.

use super::rail_head::HalfArc;

/// From the middle outwards: radius and half-width at which the arc ends, in m.
pub(super) const ARCS: [HalfArc; 3] = [
    HalfArc::tangent(0.300, 0.010228),
    HalfArc::tangent(0.080, 0.026025),
    HalfArc::tangent(0.013, 0.0359986),
];
