//! Profiles as they are measured, from `tests/profiles`: S1002 and an inclined 60E1 with its flanks, clean, as averages
//! rounded to 0.01 mm, and with two points of a gauge face 3 µm beside each other.

use crate::near;
use contact::{
    GeometryTable, ProfileFile, ProfileKind, ProfilePair, RailProfile, Reading, WheelProfile,
};
use std::path::Path;

const MM: f64 = 1e-3;

fn file(name: &str) -> String {
    format!("{}/../../tests/profiles/{name}", env!("CARGO_MANIFEST_DIR"))
}

fn pair(wheel: &str, rail: &str) -> ProfilePair {
    let wheel = WheelProfile::named(&file(wheel)).unwrap();
    let rail = RailProfile::named(&file(rail)).unwrap();
    ProfilePair::standard_gauge(wheel, rail, 0.0, 0.46)
}

/// The outlines lie on the clean ones, square to them: within half of the last digit, which is what rounding
/// leaves where the outline is level over several points, there and at the
/// running circle, whose height is zero.
#[test]
fn property_measured_points_lie_on_the_clean_outline() {
    for (name, clean, kind) in [
        ("wheel-rounded.txt", "wheel-clean.txt", ProfileKind::Wheel),
        ("rail-rounded.txt", "rail-clean.txt", ProfileKind::Rail),
        ("rail-two-points.txt", "rail-clean.txt", ProfileKind::Rail),
    ] {
        let read = |name: &str| {
            let reading = Reading::default();
            ProfileFile::read(Path::new(&file(name)), Some(kind), &reading).unwrap().profile
        };
        let (found, expected) = (read(name), read(clean));
        for i in -165..=165 {
            let lateral = 0.2 * f64::from(i) * MM;
            let (found, expected) = (found.at(lateral), expected.at(lateral));
            let square = 1.0 / (1.0 + expected.slope * expected.slope).sqrt();
            let off = (found.height - expected.height) * square / MM;
            near(&format!("{name} in mm at {lateral} m"), off, 0.0, 6e-3);
        }
    }
}

/// A wheel touches rounded profiles where it touches the clean ones: rolling radii within 0.01 mm on the
/// tread. 0.003 mm of height on a slope of 1:30 to 1:80 is 0.2 mm aside, and 0.01 mm in the radius.
#[test]
fn property_rounded_profiles_touch_as_the_clean_ones() {
    let table = |wheel, rail| GeometryTable::shared(&pair(wheel, rail)).unwrap();
    let clean = table("wheel-clean.txt", "rail-clean.txt");
    // Without the lower part of its face the gauge of the last rail is measured 0.2 mm aside.
    for (wheel, rail, tolerance) in [
        ("wheel-rounded.txt", "rail-rounded.txt", 0.02),
        ("wheel-clean.txt", "rail-two-points.txt", 0.1),
    ] {
        let other = table(wheel, rail);
        for i in -8..=8 {
            let shift = 0.5 * f64::from(i) * MM;
            let (found, expected) = (other.at(shift), clean.at(shift));
            let case = |what: &str| format!("{what} of {wheel} on {rail} at {shift} m");
            let radius = (found.radius_change - expected.radius_change) / MM;
            near(&case("radius in mm"), radius, 0.0, tolerance);
            near(&case("drop in mm"), (found.drop - expected.drop) / MM, 0.0, 0.5 * tolerance);
        }
    }
}
