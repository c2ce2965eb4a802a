//! A wheel profile over a rail profile.

use crate::error::ContactError;
use crate::profile::rail::RailProfile;
use crate::profile::wheel::WheelProfile;

/// Depth below the rail's top at which the gauge is measured, in m.
const GAUGE_DEPTH: f64 = 0.014;

/// Profiles of a wheel and its rail and the dimensions that place them over each other.
#[derive(Clone, Debug, PartialEq)]
pub struct ProfilePair {
    /// Profile of the wheel.
    pub wheel: WheelProfile,
    /// Profile of the rail.
    pub rail: RailProfile,
    /// Inclination of the rail towards the track's middle, such as 1/40; 0 is upright.
    pub rail_inclination: f64,
    /// Distance between the gauge faces 14 mm below the top, in m.
    pub gauge: f64,
    /// Distance between the flange backs of a wheelset, in m.
    pub flange_back_distance: f64,
    /// Radius of the wheel at the running circle, in m.
    pub nominal_radius: f64,
}

impl ProfilePair {
    /// The pair on standard gauge: 1435 mm, flange backs 1360 mm apart.
    pub fn standard_gauge(
        wheel: WheelProfile,
        rail: RailProfile,
        rail_inclination: f64,
        nominal_radius: f64,
    ) -> Self {
        Self {
            wheel,
            rail,
            rail_inclination,
            gauge: 1.435,
            flange_back_distance: 1.360,
            nominal_radius,
        }
    }

    /// Lateral distance of the running circle from the wheelset's middle, in m.
    pub fn running_circle(&self) -> f64 {
        0.5 * self.flange_back_distance + self.wheel.running_circle_from_flange_back()
    }

    /// Lateral distance of the rail's highest point from the track's middle, in m.
    pub fn rail_top(&self) -> f64 {
        let head = self.rail.head().inclined(self.rail_inclination);
        0.5 * self.gauge - head.gauge_face(GAUGE_DEPTH)
    }

    /// Refuses dimensions that no railway has.
    pub(crate) fn check(&self) -> Result<(), ContactError> {
        check("rail inclination", self.rail_inclination, 0.0, 0.05, "between 0 and 1/20")?;
        check("gauge", self.gauge, 0.3, 2.5, "between 0.3 and 2.5 m")?;
        check(
            "flange-back distance",
            self.flange_back_distance,
            self.gauge - 0.15,
            self.gauge - 0.03,
            "30 to 150 mm less than the gauge",
        )?;
        check("nominal wheel radius", self.nominal_radius, 0.1, 1.5, "between 0.1 and 1.5 m")
    }
}

/// Refuses a value outside `least..=most`, and one that is not a number.
fn check(
    quantity: &'static str,
    value: f64,
    least: f64,
    most: f64,
    allowed: &'static str,
) -> Result<(), ContactError> {
    if (least..=most).contains(&value) {
        Ok(())
    } else {
        Err(ContactError::OutOfRange { quantity, value, allowed })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pair() -> ProfilePair {
        let (wheel, rail) = (WheelProfile::S1002, RailProfile::Rail60E1);
        ProfilePair::standard_gauge(wheel, rail, 1.0 / 40.0, 0.46)
    }

    /// Half of 1360 mm and 70 mm from the flange back to the running circle (EN 13715).
    #[test]
    fn analytic_running_circles_are_1500_mm_apart() {
        assert!((pair().running_circle() - 0.750).abs() < 1e-12);
    }

    #[test]
    fn impossible_dimensions_are_named_with_what_is_allowed() {
        assert!(pair().check().is_ok());
        for (wrong, quantity) in [
            (ProfilePair { rail_inclination: 0.06, ..pair() }, "rail inclination"),
            (ProfilePair { gauge: f64::NAN, ..pair() }, "gauge"),
            (ProfilePair { flange_back_distance: 1.44, ..pair() }, "flange-back distance"),
            (ProfilePair { nominal_radius: 0.0, ..pair() }, "nominal wheel radius"),
        ] {
            let message = wrong.check().unwrap_err().to_string();
            assert!(message.starts_with(quantity) && message.contains("must be"), "{message}");
        }
    }
}
