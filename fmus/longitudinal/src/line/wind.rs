//! The wind over the line.

/// A uniform wind.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wind {
    /// Speed of the air, m/s.
    pub speed: f64,
    /// Angle that it comes from, to the right of the heading at the beginning of the track, rad:
    /// zero is a head wind there.
    pub direction: f64,
}

impl Wind {
    /// Its part against a heading, rad, from the beginning of the track, m/s.
    pub fn against(&self, heading: f64) -> f64 {
        self.speed * libm::cos(self.direction - heading)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A wind of 10 m/s from 60 degrees to the right of a track that heads north: half of it blows
    /// against a train to the north, all of it against one that has turned by 60 degrees, and none
    /// across; a train that has turned round has it from behind.
    #[test]
    fn analytic_part_of_the_wind_against_the_heading() {
        let wind = Wind { speed: 10.0, direction: 60.0_f64.to_radians() };
        for (heading, expected) in [(0.0, 5.0), (60.0, 10.0), (150.0, 0.0), (240.0, -10.0)] {
            let found = wind.against(f64::to_radians(heading));
            assert!((found - expected).abs() < 1e-14, "{found} m/s, not {expected}");
        }
    }
}
