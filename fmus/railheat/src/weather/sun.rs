//! The sun seen from the rail, and the shadow that the rail casts on itself.
//!
//! The rail is a prism, so that what shades a piece of surface is found in the section: the ray to
//! the sun (`docs/theory/railheat/energy.md#eq-15`), seen along the track, must not meet the
//! outline again. Validated by `analytic_sun_…`.

use serde::{Deserialize, Serialize};

use crate::section::{Facet, Outline, Point};

/// Where the sun stands.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Sun {
    /// Angle above the horizon, rad.
    pub elevation: f64,
    /// Azimuth from north over east, rad.
    pub azimuth: f64,
}

impl Sun {
    /// Components of the direction to the sun: to the right of a track, along it, upwards.
    pub(crate) fn direction(&self, track_azimuth: f64) -> [f64; 3] {
        let (side, along) = libm::sincos(self.azimuth - track_azimuth);
        let (up, level) = libm::sincos(self.elevation);
        [level * side, level * along, up]
    }

    /// For each piece of the surface the share of the sun's irradiance that falls on it.
    ///
    /// It is the cosine of the angle of incidence, zero in the shade and at night.
    pub fn lit(&self, outline: &Outline, facets: &[Facet], track_azimuth: f64) -> Vec<f64> {
        let [right, _, up] = self.direction(track_azimuth);
        let share = |facet: &Facet| {
            let incidence = facet.normal.y * right - facet.normal.z * up;
            let sunny = up > 0.0 && incidence > 0.0 && !shaded(outline, facet, right, up);
            if sunny { incidence } else { 0.0 }
        };
        facets.iter().map(share).collect()
    }
}

/// Whether the ray from the middle of a piece to the sun meets the outline.
fn shaded(outline: &Outline, facet: &Facet, right: f64, up: f64) -> bool {
    let middle = facet.middle();
    // Begins a little outside, so that the piece does not shade itself.
    let start = Point { y: middle.y + 1e-6 * facet.normal.y, z: middle.z + 1e-6 * facet.normal.z };
    outline.sides().any(|(a, b)| {
        let (dy, dz) = (b.y - a.y, b.z - a.z);
        let determinant = dy * up + dz * right;
        if determinant == 0.0 {
            return false;
        }
        let (ey, ez) = (start.y - a.y, start.z - a.z);
        let along = (ey * up + ez * right) / determinant;
        let ahead = (dy * ez - dz * ey) / determinant;
        (0.0..=1.0).contains(&along) && ahead > 0.0
    })
}
