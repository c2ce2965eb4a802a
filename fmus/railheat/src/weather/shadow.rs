//! The shadow that a vehicle's body throws on the rail below it.
//!
//! The body is a box. A ray from the rail to the sun is at the height z above the rail displaced by
//! z r/u to the right and by z f/u along the track, with the components r, f and u of the sun's
//! direction to the right, forwards and upwards. The rail is in the shade where the ray meets the
//! box (`docs/theory/railheat/energy.md#eq-16`); bogies and wheels are left out, so that a low sun
//! shines below the floor. Validated by `analytic_shadow_of_a_vehicle`.

use numerics::constants::RAIL_LATERAL_POSITION;

use super::sun::Sun;

/// The box that throws the shadow, and where the rail lies below it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body {
    /// Half the width of the body, m.
    pub half_width: f64,
    /// Height of its floor above the rail, m.
    pub floor: f64,
    /// Height of its roof above the rail, m.
    pub roof: f64,
    /// Lateral position of the rail, to the right of the track's middle, m.
    pub rail: f64,
}

impl Body {
    /// A wagon of usual size above the left rail of standard gauge.
    pub const WAGON: Self =
        Self { half_width: 1.5, floor: 1.1, roof: 3.9, rail: -RAIL_LATERAL_POSITION };

    /// Begin and end of the shadow of a body that reaches from one chainage to another, m.
    ///
    /// There is none when the sun is down or the shadow misses the rail.
    pub fn shadow(&self, sun: &Sun, track_azimuth: f64, body: [f64; 2]) -> Option<[f64; 2]> {
        let [right, forwards, up] = sun.direction(track_azimuth);
        if up <= 0.0 {
            return None;
        }
        let aside = right / up;
        let (mut low, mut high) = (self.floor, self.roof);
        if aside == 0.0 {
            if self.rail.abs() > self.half_width {
                return None;
            }
        } else {
            // Heights at which the ray passes the planes of the side walls.
            let walls = [-self.half_width, self.half_width].map(|wall| (wall - self.rail) / aside);
            low = low.max(walls[0].min(walls[1]));
            high = high.min(walls[0].max(walls[1]));
        }
        if low > high {
            return None;
        }
        let along = [low, high].map(|height| height * forwards / up);
        let shadow = [body[0] - along[0].max(along[1]), body[1] - along[0].min(along[1])];
        Some(shadow)
    }
}
