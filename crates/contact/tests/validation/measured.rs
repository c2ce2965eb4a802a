//! Profiles as they are measured, from `tests/profiles`: S1002 and an inclined 60E1 with its flanks, clean, as averages
//! rounded to 0.01 mm, and with two points of a gauge face 3 µm beside each other.

use crate::near;
use contact::{GeometryTable, ProfilePair, RailProfile, WheelProfile};

const MM: f64 = 1e-3;

fn file(name: &str) -> String {
    format!("{}/../../tests/profiles/{name}", env!("CARGO_MANIFEST_DIR"))
}

fn pair(wheel: &str, rail: &str) -> ProfilePair {
    let wheel = WheelProfile::named(&file(wheel)).unwrap();
    let rail = RailProfile::named(&file(rail)).unwrap();
    ProfilePair::standard_gauge(wheel, rail, 0.0, 0.46)
}

/// The outlines lie on the clean ones within what rounding leaves after smoothing, square to them, and where
/// points are missing above the two of a gauge face, within 0.01 mm of its chord.
#[test]
fn property_measured_points_lie_on_the_clean_outline() {
    let clean = pair("wheel-clean.txt", "rail-clean.txt");
    for (wheel, rail, from, tolerance) in [
        ("wheel-rounded.txt", "rail-rounded.txt", -33.0, 4e-3),
        ("wheel-clean.txt", "rail-two-points.txt", -34.0, 6e-3),
    ] {
        let other = pair(wheel, rail);
        for i in 0..300 {
            let lateral = (from + 0.2 * f64::from(i)) * MM;
            for (found, expected) in [
                (other.wheel.at(lateral), clean.wheel.at(lateral)),
                (other.rail.at(lateral), clean.rail.at(lateral)),
            ] {
                let square = 1.0 / (1.0 + expected.slope * expected.slope).sqrt();
                let off = (found.height - expected.height) * square / MM;
                if lateral.abs() < 35.0 * MM {
                    near(&format!("{wheel}, {rail} in mm at {lateral} m"), off, 0.0, tolerance);
                }
            }
        }
    }
}

/// A wheel touches rounded profiles where it touches the clean ones: rolling radii within 0.01 mm on the
/// tread. 0.003 mm of height on a slope of 1:30 to 1:80 is 0.2 mm aside, and 0.01 mm in the radius.
#[test]
fn property_rounded_profiles_touch_as_the_clean_ones() {
    let table = |wheel, rail| GeometryTable::shared(&pair(wheel, rail)).unwrap();
    let clean = table("wheel-clean.txt", "rail-clean.txt");
    for (wheel, rail) in
        [("wheel-rounded.txt", "rail-rounded.txt"), ("wheel-clean.txt", "rail-two-points.txt")]
    {
        let other = table(wheel, rail);
        for i in -8..=8 {
            let shift = 0.5 * f64::from(i) * MM;
            let (found, expected) = (other.at(shift), clean.at(shift));
            let case = |what: &str| format!("{what} of {wheel} on {rail} at {shift} m");
            let radius = (found.radius_change - expected.radius_change) / MM;
            near(&case("radius in mm"), radius, 0.0, 0.02);
            near(&case("drop in mm"), (found.drop - expected.drop) / MM, 0.0, 5e-3);
        }
    }
}
