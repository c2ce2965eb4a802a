//! Lengths by which people know a profile.

use crate::contact::outline::MM;

/// Height beyond the running circle at which the thickness of a flange is measured, m (EN 15313).
const THICKNESS_AT: f64 = 10.0 * MM;

/// How far above its tip the gradient of a flange begins, m (EN 15313).
const GRADIENT_FROM_TIP: f64 = 2.0 * MM;

/// The flange of a wheel.
pub(super) struct Flange {
    /// Sh: height of the tip beyond the running circle, m.
    pub height: f64,
    /// Sd: from the flange back to the face, 10 mm beyond the running circle, m.
    pub thickness: Option<f64>,
    /// qR: how far the face goes aside from there to 2 mm before the tip, m.
    pub gradient: Option<f64>,
}

impl Flange {
    /// Of an outline in m whose height is 0 at the running circle, at `circle` m from the flange back.
    pub fn new(outline: &[[f64; 2]], circle: f64) -> Self {
        let tip = outline.iter().enumerate().max_by(|a, b| a.1[1].total_cmp(&b.1[1]));
        let (tip, height) = tip.map_or((0, 0.0), |(i, point)| (i, point[1]));
        let face = |height: f64| crossing(outline[tip..].iter(), height);
        let at_thickness = face(THICKNESS_AT);
        let near_tip = face(height - GRADIENT_FROM_TIP);
        Self {
            height,
            thickness: at_thickness.map(|lateral| lateral + circle),
            gradient: at_thickness.zip(near_tip).map(|(face, tip)| face - tip),
        }
    }
}

/// Lateral coordinate of the gauge face `depth` m below the `top` of a rail; nothing above it.
pub(super) fn gauge_point(outline: &[[f64; 2]], top: [f64; 2], depth: f64) -> Option<f64> {
    let gauge_side = outline.iter().rev().skip_while(|point| point[0] > top[0]);
    crossing(gauge_side, top[1] + depth)
}

/// Lateral coordinate at which the points first pass the `height`.
fn crossing<'a>(points: impl Iterator<Item = &'a [f64; 2]>, height: f64) -> Option<f64> {
    let mut before: Option<[f64; 2]> = None;
    for point in points {
        if let Some([y, z]) = before
            && (z - height) * (point[1] - height) <= 0.0
            && z != point[1]
        {
            return Some(y + (point[0] - y) * (height - z) / (point[1] - z));
        }
        before = Some(*point);
    }
    None
}
