//! A wheel profile over a rail profile.

use crate::error::ContactError;
use crate::profile::file::Reading;
use crate::profile::rail::RailProfile;
use crate::profile::wheel::WheelProfile;

/// How far aside, in m, a gauge side that ends above the depth of the gauge may be there by its tangent.
const MOST_LACKING: f64 = 0.0025;

/// Profiles of a wheel and its rail and the dimensions that place them over each other.
#[derive(Clone, Debug, PartialEq)]
pub struct ProfilePair {
    /// Profile of the wheel.
    pub wheel: WheelProfile,
    /// Profile of the rail.
    pub rail: RailProfile,
    /// Inclination of the rail towards the track's middle, such as 1/40; 0 is upright.
    pub rail_inclination: f64,
    /// Distance between the gauge faces, in m.
    pub gauge: f64,
    /// Depth below the rail's top to which the gauge is measured, in m: 0.014, in North America 0.015875.
    pub gauge_depth: f64,
    /// Distance between the flange backs of a wheelset, in m.
    pub flange_back_distance: f64,
    /// Distance of the running circle from the flange back, in m: 0.070 (EN 13715).
    pub running_circle_from_flange_back: f64,
    /// Radius of the wheel at the running circle, in m.
    pub nominal_radius: f64,
}

impl ProfilePair {
    /// Depth of the gauge below the rail's top where nothing is said, in m (EN 13848-1).
    pub const GAUGE_DEPTH: f64 = 0.014;

    /// The pair on standard gauge: 1435 mm at 14 mm below the top, flange backs 1360 mm apart, running
    /// circles 70 mm from them.
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
            gauge_depth: Self::GAUGE_DEPTH,
            flange_back_distance: 1.360,
            running_circle_from_flange_back: Reading::RUNNING_CIRCLE,
            nominal_radius,
        }
    }

    /// Lateral distance of the running circle from the wheelset's middle, in m.
    pub fn running_circle(&self) -> f64 {
        0.5 * self.flange_back_distance + self.running_circle_from_flange_back
    }

    /// Lateral distance of the rail's highest point from the track's middle, in m.
    pub fn rail_top(&self) -> f64 {
        let head = self.rail.head().inclined(self.rail_inclination);
        0.5 * self.gauge - head.gauge_face(self.gauge_depth)
    }

    /// The error of a wheel that stands beside its rail, shifted by `lateral` metres.
    pub(crate) fn no_contact(&self, lateral: f64) -> ContactError {
        ContactError::NoContact {
            wheel: self.wheel.name(),
            rail: self.rail.name(),
            shift_mm: 1e3 * lateral,
        }
    }

    /// Refuses dimensions that no railway has, and a rail whose gauge cannot be measured.
    pub(crate) fn check(&self) -> Result<(), ContactError> {
        check("rail inclination", self.rail_inclination, 0.0, 0.05, "between 0 and 1/20")?;
        check("gauge", self.gauge, 0.3, 2.5, "between 0.3 and 2.5 m")?;
        check("depth of the gauge", self.gauge_depth, 0.005, 0.03, "between 0.005 and 0.03 m")?;
        let (least, most, allowed) = match &self.wheel {
            WheelProfile::Points(_) => (0.05, 0.1, "between 0.05 and 0.1 m"),
            // The shipped profiles have their flange back there.
            WheelProfile::S1002 | WheelProfile::Cone(_) => {
                (0.0699, 0.0701, "0.07 m for a profile that is no file")
            }
        };
        let circle = self.running_circle_from_flange_back;
        check("running circle's distance from the flange back", circle, least, most, allowed)?;
        if let RailProfile::Points(points) = &self.rail
            && points.gauge_lacks(self.gauge_depth) > MOST_LACKING
        {
            let reason = format!(
                "the gauge side reaches {:.1} mm below the top, but the gauge is measured {} mm below it: \
                 points of the gauge face are missing, or gauge_depth_mm (option --gauge-depth-mm) is less",
                1e3 * points.gauge_depth(),
                1e3 * self.gauge_depth
            );
            return Err(ContactError::ProfileFile { file: self.rail.name(), reason });
        }
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

    /// 15.875 mm (5/8 inch) below the top of an upright 60E1, on its flank of 1:20 from 14.3 mm, the gauge
    /// faces stand 1435 mm apart where they do so at 14 mm: the rail stands nearer by 1.575 mm/20.
    #[test]
    fn analytic_the_gauge_is_measured_at_its_depth() {
        let at =
            |gauge_depth| ProfilePair { rail_inclination: 0.0, gauge_depth, ..pair() }.rail_top();
        let nearer = at(0.0159) - at(0.0143);
        assert!((nearer - 0.0016 / 20.0).abs() < 1e-6, "{nearer}");
    }

    #[test]
    fn impossible_dimensions_are_named_with_what_is_allowed() {
        assert!(pair().check().is_ok());
        for (wrong, quantity) in [
            (ProfilePair { rail_inclination: 0.06, ..pair() }, "rail inclination"),
            (ProfilePair { gauge: f64::NAN, ..pair() }, "gauge"),
            (ProfilePair { gauge_depth: 14.0, ..pair() }, "depth of the gauge"),
            (
                ProfilePair { running_circle_from_flange_back: 0.075, ..pair() },
                "running circle's distance",
            ),
            (ProfilePair { flange_back_distance: 1.44, ..pair() }, "flange-back distance"),
            (ProfilePair { nominal_radius: 0.0, ..pair() }, "nominal wheel radius"),
        ] {
            let message = wrong.check().unwrap_err().to_string();
            assert!(message.starts_with(quantity) && message.contains("must be"), "{message}");
        }
    }
}
