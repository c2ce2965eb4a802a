//! Wheel and rail profiles.

use crate::{near, pair};
use contact::{RailProfile, WheelProfile, wheelset_geometry};

const MM: f64 = 1e-3;

/// EN 13715 in Netter's form (DLR): 1:29.8 on the running circle, 70 degrees on the flange
/// face, 28 mm flange height (12 mm arc about a height of 16 mm).
#[test]
fn benchmark_s1002_characteristic_values() {
    let wheel = WheelProfile::S1002;
    assert_eq!(wheel.at(0.0).height, 0.0);
    near("slope at 0", wheel.at(0.0).slope, -0.0336, 5e-5);
    let face = wheel.at(-39.0 * MM).slope.atan().to_degrees();
    near("flange face in degrees", face, -70.0, 5e-3);
    near("flange height in mm", wheel.at(-55.0 * MM).height / MM, 28.0, 1e-9);
    near("slope of the field side", wheel.at(50.0 * MM).slope, -1.0 / 15.0, 1e-6);
}

/// The sections of a wheel join. The coefficients have ten digits, and the terms of section C reach
/// 2e5 mm: half a unit in the tenth digit is 1e-4 mm. Tolerance twice that, and 1e-4 in slope.
#[test]
fn property_wheel_sections_join() {
    let borders =
        [32.15796, -26.0, -35.0, -38.426669071, -39.764473993, -49.662510381, -62.764705882];
    let check = |wheel: &WheelProfile, border: f64| {
        let step = 1e-9;
        let (p, q) = (wheel.at(border * MM - step), wheel.at(border * MM + step));
        let case = format!("{} at {border} mm", wheel.name());
        let bend = 2.0 * step * p.slope.abs().max(q.slope.abs());
        near(&case, q.height, p.height, 2e-4 * MM + bend);
        near(&case, q.slope, p.slope, 1e-4);
    };
    for border in borders {
        check(&WheelProfile::S1002, border);
    }
    let cone = WheelProfile::named("cone-1-20").unwrap();
    for border in &borders[3..] {
        check(&cone, *border);
    }
}

/// A cone has its slope on the whole tread, and the flange of S1002.
#[test]
fn analytic_cone() {
    let cone = WheelProfile::named("cone-1-20").unwrap();
    for s in [-15.0, 0.0, 30.0] {
        near("height", cone.at(s * MM).height, -s * MM / 20.0, 1e-15);
        near("slope", cone.at(s * MM).slope, -0.05, 1e-15);
    }
    let s1002 = WheelProfile::S1002;
    for s in [-39.0, -45.0, -55.0] {
        assert_eq!(cone.at(s * MM), s1002.at(s * MM));
    }
}

/// The ends of the arcs of 60E1 (EN 13674-1). Tolerance: half of the last digit of the height; at
/// the last point half of the last digit of the half-width, times the slope of 20.
#[test]
fn benchmark_60e1_arcs() {
    let rail = RailProfile::Rail60E1;
    for (half_width, height, tolerance) in
        [(10.228, 0.1744, 5.1e-5), (26.025, 2.3022, 5.1e-5), (35.9986, 14.2997, 1e-3)]
    {
        for side in [-1.0, 1.0] {
            let computed = rail.at(side * half_width * MM).height / MM;
            near("height in mm", computed, height, tolerance);
        }
    }
}

/// Points of `MBench_UIC60_v3.prr` (CONTACT's examples), canted 1:40, gauge side negative. The fitted
/// arcs are good to 0.005 mm on the gauge side and the crown, where wheels touch.
#[test]
fn benchmark_uic60_manchester_points() {
    let (sine, cosine) = (1.0_f64 / 40.0).atan().sin_cos();
    let crown = 0.300;
    let upright = RailProfile::Uic60Manchester;
    for (y, z) in [
        (-40.633237, 7.9154033),
        (-33.430349, 2.9996514),
        (-28.253335, 1.8275158),
        (-17.632924, 0.51899909),
        (-5.4165968, 0.049010748),
        (7.5166786, 0.18731651),
        (18.559752, 1.6998989),
    ] {
        // Turned back about the crown's top; the crown's arc keeps the origin at the highest point.
        let (y, z) = (y * MM + crown * sine, z * MM + crown * (cosine - 1.0));
        let (lateral, height) = (y * cosine - z * sine, z * cosine + y * sine);
        near("height in mm", upright.at(lateral).height / MM, height / MM, 5e-3);
    }
}

/// The rail's top lies 760.53 mm from the track's middle (CONTACT, docs/reference/contact.md, from the benchmark's rail).
#[test]
fn benchmark_manchester_rail_place() {
    for rail in ["60E1", "UIC60-manchester"] {
        near("rail top in mm", pair("S1002", rail).rail_top() / MM, 760.53, 5e-3);
    }
    near("running circle in mm", pair("S1002", "60E1").running_circle() / MM, 750.0, 1e-9);
}

/// S1002 as CONTACT's examples have it: a file of points 0.35 mm apart whose header mirrors them, the
/// flange first. The wheel touches where S1002 itself does. Tolerance 0.1 mm: between the points are cubics.
#[test]
fn property_points_of_s1002_touch_as_s1002() {
    let place = |i: i32| (69.5 - 0.35 * f64::from(i)) * MM;
    let lines: String = (0..=370)
        .map(|i| {
            format!(
                "{:.7E}\t{:.7E}\n",
                place(i) / MM,
                WheelProfile::S1002.at(-place(i)).height / MM
            )
        })
        .collect();
    let text = format!(
        "! a comment\nheader.begin\n  type = 1 ! 0=rail profile, 1=wheel profile\nheader.end\n\
         spline.begin\n  mirror.y = 1 ! 5: y mirror mode\n  units.len.f = +1.000000e+03\n\
         point.begin\n{lines}point.end\nspline.end\n"
    );
    let file = tempfile::Builder::new().suffix(".prw").tempfile().unwrap();
    std::fs::write(file.path(), text).unwrap();
    let s1002 = pair("S1002", "60E1");
    let points = pair(file.path().to_str().unwrap(), "60E1");
    for y in [0.5, 2.0, 4.0, 6.0, 8.0] {
        let of = |pair| wheelset_geometry(pair, y * MM, 0.0).unwrap();
        let (expected, found) = (of(&s1002), of(&points));
        for (expected, found) in
            [(&expected.left[0], &found.left[0]), (&expected.right[0], &found.right[0])]
        {
            let case = |what: &str| format!("{what} in mm at {y} mm");
            let (rail, wheel) = (expected.rail_lateral / MM, expected.wheel_lateral / MM);
            near(&case("rail"), found.rail_lateral / MM, rail, 0.1);
            near(&case("wheel"), found.wheel_lateral / MM, wheel, 0.1);
        }
    }
}

#[test]
fn unknown_profiles_are_answered_with_the_known() {
    for name in ["S1001", "cone-1-", "cone-1-3", "cone-1-nan", ""] {
        let message = WheelProfile::named(name).unwrap_err().to_string();
        assert!(message.contains("S1002") && message.contains(name), "{message}");
    }
    let message = RailProfile::named("60E2").unwrap_err().to_string();
    assert!(message.contains("60E1") && message.contains("60E2"), "{message}");
}

#[test]
fn names_give_back_their_profile() {
    for name in ["S1002", "cone-1-20", "cone-1-40"] {
        assert_eq!(WheelProfile::named(name).unwrap().name(), name);
    }
    for name in ["60E1", "UIC60-manchester", "round-300"] {
        assert_eq!(RailProfile::named(name).unwrap().name(), name);
    }
}
