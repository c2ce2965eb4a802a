//! Kinds of traction.

use longitudinal::drive::traction::Traction;

use crate::support::*;

fn traction(text: &str) -> Traction {
    let text = format!("without = ['traction']\n[traction]\nramp_s = 0\n{text}");
    let vehicle = vehicle_of(&text);
    Traction::new(vehicle.traction.as_ref().unwrap(), vehicle.mass_kg).unwrap()
}

/// A table for each notch: linear in the speed, and in the lever between two notches; low notches
/// that hold a speed give nothing beyond it.
#[test]
fn analytic_effort_by_notch() {
    let rows: Vec<String> = (1..=8).map(|notch| format!("[{0}0, {0}, 0]", notch * 8)).collect();
    let by_notch = traction(&format!(
        "[traction.by_notch]\nspeed_kmh = [0, 36, 72]\neffort_kn = [{}]",
        rows.join(", ")
    ));
    // Notch 2 has 160, 16 and 0 kN at 0, 10 and 20 m/s; notch 3 has 240, 24 and 0.
    let cases = [
        (2.0, 0.0, 160e3),
        (2.0, 15.0, 8e3),
        (2.5, 10.0, 20e3),
        (0.5, 0.0, 40e3),
        (8.0, 5.0, 352e3),
        (8.0, 30.0, 0.0),
    ];
    for (notch, speed, expected) in cases {
        let force = by_notch.force(notch / 8.0, speed);
        assert!((force - expected).abs() < 1e-6, "notch {notch} at {speed} m/s: {force}");
    }
}

/// A continuous throttle takes its share of the full effort; power and adhesion limit it only where
/// they are given.
#[test]
fn analytic_limits_of_the_effort() {
    let effort = "[traction.effort]\nspeed_kmh = [0]\neffort_kn = [400]\n";
    let power = "power_kw = 2000\nefficiency = 0.9\nnotch_power = [0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1]\n";
    let adhesion = "[traction.adhesion]\nspeed_kmh = [0]\nvalue = [0.2]\n";
    let weight = 134e3 * 9.80665;
    for (text, lever, speed, expected) in [
        (effort.to_owned(), 0.3, 30.0, 120e3),
        (format!("{power}{effort}"), 0.5, 2.0, 200e3),
        (format!("{power}{effort}"), 0.5, 20.0, 0.4 * 1.8e6 / 20.0),
        (format!("{effort}{adhesion}"), 1.0, 5.0, 0.2 * weight),
    ] {
        let force = traction(&text).force(lever, speed);
        assert!((force - expected).abs() < 1e-6, "{text}: {force}");
    }
}

/// A spline with a corner goes through its points and stays level before the corner.
#[test]
fn analytic_effort_by_a_spline_with_a_corner() {
    let spline = traction(
        "[traction.effort]\ninterpolation = 'cubic'\nspeed_kmh = [0, 36, 36, 72, 108]\n\
         effort_kn = [600, 600, 600, 300, 200]\n",
    );
    for (speed, expected) in
        [(0.0, 600e3), (5.0, 600e3), (10.0, 600e3), (20.0, 300e3), (30.0, 200e3)]
    {
        assert!((spline.force(1.0, speed) - expected).abs() < 1e-6);
    }
    // By hand: slopes -30, m, -10 kN s/m with -30/10 + 2 m (2/10) - 10/10 = 3 (-30/10 - 10/10)
    // give m = -20; in the middle of the first piece 450 + 10 (-30 + 20)/8 = 437.5 kN.
    let middle = spline.force(1.0, 15.0);
    assert!((middle - 437.5e3).abs() < 1e-6, "{middle}");
}
