//! A conical tread 1:n with the flange of S1002, joined by a fillet.
//!
//! Tests with a known answer need a cone: the rolling radii differ by 2 y / n, and a free wheelset
//! follows Klingel's wavelength. The flange keeps the wheelset on the track where the cone alone
//! would not.

use super::point::ProfilePoint;
use super::s1002;

const MM: f64 = 1e-3;

/// Radius of the fillet between tread and flange face, in mm; the same as in S1002.
const FILLET_RADIUS: f64 = 13.0;

/// A tread that falls by 1 on n towards the field side, with the flange of S1002.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cone {
    ratio: f64,
    /// Lateral coordinate and height of the fillet's centre, in mm.
    centre: (f64, f64),
    /// Where the fillet meets the flange face and the tread, in mm.
    fillet: (f64, f64),
}

impl Cone {
    /// The cone 1:`ratio`, or nothing if the ratio is not between 5 and 200.
    pub fn new(ratio: f64) -> Option<Self> {
        if !(5.0..=200.0).contains(&ratio) {
            return None;
        }
        // The centre keeps the distance FILLET_RADIUS from the tread z = -s / n and from the
        // flange face z = f0 + f1 s; both straight lines are moved by it and intersected.
        let tread = -1.0 / ratio;
        let [f0, face] = s1002::FLANGE_FACE;
        let above_tread = FILLET_RADIUS * (1.0 + tread * tread).sqrt();
        let beside_face = f0 + FILLET_RADIUS * (1.0 + face * face).sqrt();
        let s = (above_tread - beside_face) / (face - tread);
        let touch = |slope: f64| s + FILLET_RADIUS * slope / (1.0 + slope * slope).sqrt();
        Some(Self {
            ratio,
            centre: (s, above_tread + tread * s),
            fillet: (touch(face), touch(tread)),
        })
    }

    /// The n of 1:n.
    pub fn ratio(&self) -> f64 {
        self.ratio
    }

    /// The profile at `lateral` metres from the running circle.
    pub(super) fn at(&self, lateral: f64) -> ProfilePoint {
        let s = lateral.clamp(s1002::RANGE.0, s1002::RANGE.1) / MM;
        if s >= self.fillet.1 {
            s1002::polynomial(&[0.0, -1.0 / self.ratio], s)
        } else if s >= self.fillet.0 {
            s1002::concave_arc(s, self.centre.0, self.centre.1, FILLET_RADIUS)
        } else if s >= s1002::FLANGE_FACE_END {
            s1002::polynomial(&s1002::FLANGE_FACE, s)
        } else {
            s1002::flange(s)
        }
    }
}
