//! Rail profile AS 60 kg/m (AS 1085.1): crown, shoulder and gauge corner.
//!
//! The data sheet gives a head of 70 mm at 16 mm below the top, flanks 1:20, and the radii 190.5, 80 and
//! 10 mm, but not where the crown's arcs meet: **10 mm from the middle is
//! taken here**, as on 60E1; the other joints follow from tangents to the arcs and the flank. So the head
//! is representative.

use super::rail_head::HalfArc;

/// From the middle outwards: radius and half-width at which the arc ends, in m.
pub(super) const ARCS: [HalfArc; 3] = [
    HalfArc::tangent(0.1905, 0.010),
    HalfArc::tangent(0.080, 0.027_544_945),
    HalfArc::tangent(0.010, 0.034_814_415),
];
