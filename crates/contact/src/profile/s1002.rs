//! Wheel profile S1002 (EN 13715), in the polynomial form published by H. Netter (DLR) and used by
//! the Manchester contact benchmark.
//!
//! Eight sections, S in mm from the running circle (positive to the field side), z in mm (positive
//! towards the flange tip). They deviate by at most 1.6e-6 mm from the benchmark's point file.

use super::point::ProfilePoint;

/// Lateral range in m. The back of the flange (-70 mm) is upright, so the range ends just before.
pub(super) const RANGE: (f64, f64) = (-0.0699, 0.060);

const MM: f64 = 1e-3;

/// Section A: the conical field side (1:15), z = c0 + c1 S.
const FIELD_SIDE: [f64; 2] = [1.364323640, -0.066666667];

/// Section B: the tread.
const TREAD: [f64; 9] = [
    0.0,
    -3.358537058e-2,
    1.565681624e-3,
    -2.810427944e-5,
    5.844240864e-8,
    -1.562379023e-8,
    5.309217349e-15,
    -5.957839843e-12,
    2.646656573e-13,
];

/// Section C: from the tread to the throat.
const TREAD_TO_THROAT: [f64; 8] = [
    -4.320221063e3,
    -1.038384026e3,
    -1.065501873e2,
    -6.051367875,
    -2.054332446e-1,
    -4.169739389e-3,
    -4.687195829e-5,
    -2.252755540e-7,
];

/// Section E: the flange face, 70 degrees.
pub(super) const FLANGE_FACE: [f64; 2] = [-93.576667419, -2.747477419];

/// Where the flange face (section E) ends at the flange tip's arc, in mm.
pub(super) const FLANGE_FACE_END: f64 = -39.764473993;

/// The profile at `lateral` metres, held constant outside [`RANGE`].
pub(super) fn at(lateral: f64) -> ProfilePoint {
    let s = lateral.clamp(RANGE.0, RANGE.1) / MM;
    if s < FLANGE_FACE_END {
        flange(s)
    } else if s < -38.426669071 {
        polynomial(&FLANGE_FACE, s)
    } else if s < -35.0 {
        concave_arc(s, -26.210665, 16.446, 13.0)
    } else if s < -26.0 {
        polynomial(&TREAD_TO_THROAT, s)
    } else if s < 32.15796 {
        polynomial(&TREAD, s)
    } else {
        polynomial(&FIELD_SIDE, s)
    }
}

/// The flange beyond its face (sections F, G and H); `s` in mm.
pub(super) fn flange(s: f64) -> ProfilePoint {
    if s < -62.764705882 {
        convex_arc(s, -49.5, 9.519259302, 20.5)
    } else if s < -49.662510381 {
        convex_arc(s, -55.0, 16.0, 12.0)
    } else {
        convex_arc(s, -58.558326413, 8.834924130, 20.0)
    }
}

/// A polynomial by Horner's rule (section C loses digits otherwise).
pub(super) fn polynomial(coefficients: &[f64], s: f64) -> ProfilePoint {
    let (mut value, mut slope) = (0.0, 0.0);
    for c in coefficients.iter().rev() {
        slope = slope * s + value;
        value = value * s + c;
    }
    ProfilePoint { height: value * MM, slope }
}

/// A bulge of the wheel, z = z0 + sqrt(R^2 - x^2).
fn convex_arc(s: f64, centre: f64, height: f64, radius: f64) -> ProfilePoint {
    let x = s - centre;
    let root = (radius * radius - x * x).sqrt();
    ProfilePoint { height: (height + root) * MM, slope: -x / root }
}

/// A hollow of the wheel, z = z0 - sqrt(R^2 - x^2).
pub(super) fn concave_arc(s: f64, centre: f64, height: f64, radius: f64) -> ProfilePoint {
    let x = s - centre;
    let root = (radius * radius - x * x).sqrt();
    ProfilePoint { height: (height - root) * MM, slope: x / root }
}
