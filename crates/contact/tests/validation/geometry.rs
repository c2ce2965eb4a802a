//! Laws that every geometry table keeps.

use crate::{near, pair};
use contact::{ContactError, GeometryTable, ProfilePair};
use std::sync::Arc;

const MM: f64 = 1e-3;

const PAIRS: [(&str, &str); 5] = [
    ("S1002", "AS60"),
    ("S1002", "60E1"),
    ("S1002", "UIC60-manchester"),
    ("cone-1-20", "60E1"),
    ("cone-1-20", "round-300"),
];

fn table(wheel: &str, rail: &str) -> Arc<GeometryTable> {
    GeometryTable::shared(&pair(wheel, rail)).unwrap()
}

/// The normal force does no work while the wheel slides along its path: d drop/d shift is the slope
/// given, within every row of the table. Central difference over 0.02 um: the steepest row (from the
/// flange root to its face) has a third derivative of 1e10 1/m^2, which gives 2e-7.
#[test]
fn property_slope_is_the_derivative_of_drop() {
    for (wheel, rail) in PAIRS {
        let table = table(wheel, rail);
        let step = 1e-8;
        for row in -400..600 {
            for part in [0.1, 0.5, 0.9] {
                let shift = (f64::from(row) + part) * 0.05 * MM;
                let rise = table.at(shift + step).drop - table.at(shift - step).drop;
                let case = format!("{wheel} on {rail} at {shift} m");
                near(&case, table.at(shift).slope, 0.5 * rise / step, 1e-6);
            }
        }
    }
}

/// sin and cos of the contact angle belong to the slope.
#[test]
fn property_contact_angle() {
    let table = table("S1002", "60E1");
    for shift in [-10.0, 0.0, 3.0, 6.0, 8.0] {
        let point = table.at(shift * MM);
        near("sine", point.sin_angle, point.angle().sin(), 1e-15);
        near("cosine", point.cos_angle, point.angle().cos(), 1e-15);
        assert!(point.sin_angle > 0.0, "the rail pushes the wheel inwards");
    }
}

/// Whatever the shift: a wheel that moves towards its flange rises and touches nearer to the flange;
/// ellipse, stiffness and creep coefficients are positive numbers.
#[test]
fn property_every_contact_makes_sense() {
    for (wheel, rail) in PAIRS {
        let table = table(wheel, rail);
        let mut before = table.at(-20.0 * MM);
        for i in 1..5_000 {
            let point = table.at((-20.0 + f64::from(i) * 0.01) * MM);
            let case = format!("{wheel} on {rail}, {i}: {point:?}");
            assert!(point.drop < before.drop, "{case}");
            assert!(point.wheel_lateral < before.wheel_lateral + 1e-6, "{case}");
            let (hertz, kalker) = (point.hertz, point.kalker);
            for value in [
                hertz.semi_axis_rolling,
                hertz.semi_axis_lateral,
                hertz.stiffness,
                kalker.c11,
                kalker.c22,
                kalker.c23,
                kalker.c33,
            ] {
                assert!(value > 0.0 && value.is_finite(), "{case}");
            }
            before = point;
        }
    }
}

/// On a cone r_R - r_L = 2 lambda y exactly, its angle is lambda, and the contact stays at one place
/// of the rail. Tolerance: the rail is sampled every 0.01 mm, symmetrically, so that only rounding
/// and the linear interpolation of a straight line remain.
#[test]
fn analytic_cone_rolling_radii() {
    for rail in ["60E1", "round-300"] {
        let table = table("cone-1-20", rail);
        for y in [0.1, 1.0, 2.5] {
            let (right, left) = (table.at(y * MM), table.at(-y * MM));
            let difference = right.radius_change - left.radius_change;
            near("r_R - r_L", difference, 2.0 * 0.05 * y * MM, 1e-9);
            near("tan of the angle", right.slope, -0.05, 1e-6);
            near("rail contact", right.rail_lateral, left.rail_lateral, 1e-6);
        }
    }
}

/// On a crown of radius R a cone touches where the rail has its slope, relative curvature 1/R: the
/// contact ellipse is that of a roller of radius r/cos on a cylinder R.
/// Tolerance 1e-3: softness s curves the weights by s/R only; the sampling leaves 1e-4.
#[test]
fn analytic_cone_on_crown() {
    let point = table("cone-1-20", "round-300").at(0.0);
    let lateral = 0.300 * ((0.05_f64).atan() - (1.0_f64 / 40.0).atan()).sin();
    // Measured from the top of the rail inclined 1:40, which lies beside its axis.
    let from_axis = 0.300 * (1.0_f64 / 40.0).atan().sin() + lateral;
    near("rail contact", -point.rail_lateral, from_axis, 2e-5);
    let radius = (0.460 + point.radius_change) / point.cos_angle;
    let hertz = contact::hertz::UnitContact::new(0.5 / radius, 0.5 / 0.300, &contact::STEEL);
    near("a", point.hertz.semi_axis_rolling / hertz.semi_axis_rolling, 1.0, 1e-3);
    near("b", point.hertz.semi_axis_lateral / hertz.semi_axis_lateral, 1.0, 1e-3);
    near("stiffness", point.hertz.stiffness / hertz.stiffness, 1.0, 1e-3);
}

/// A climbing or derailed wheel gets the outermost contact and is told so; so does a broken number.
#[test]
fn property_beyond_the_table() {
    let table = table("S1002", "60E1");
    let (begin, end) = table.range();
    for (shift, at) in [(end + 0.01, end), (begin - 0.01, begin), (f64::NAN, begin)] {
        let point = table.at(shift);
        assert!(point.beyond);
        assert!(!table.at(at).beyond);
        near("drop", point.drop, table.at(at).drop, 1e-15);
    }
}

/// The wheel's drop counts from the middle of the track.
#[test]
fn property_drop_is_zero_in_the_middle() {
    for (wheel, rail) in PAIRS {
        assert_eq!(table(wheel, rail).at(0.0).drop, 0.0);
    }
}

#[test]
fn one_table_serves_all_who_ask_for_the_same_pair() {
    let tables: Vec<_> = std::thread::scope(|scope| {
        let asked: Vec<_> = (0..4).map(|_| scope.spawn(|| table("cone-1-40", "60E1"))).collect();
        asked.into_iter().map(|t| t.join().unwrap()).collect()
    });
    assert!(tables.iter().all(|t| Arc::ptr_eq(t, &tables[0])));
    assert!(!Arc::ptr_eq(&tables[0], &table("cone-1-20", "60E1")));
}

#[test]
fn impossible_dimensions_are_named() {
    let good = pair("S1002", "60E1");
    for (pair, word) in [
        (ProfilePair { nominal_radius: -0.5, ..good.clone() }, "radius"),
        (ProfilePair { nominal_radius: f64::NAN, ..good.clone() }, "radius"),
        (ProfilePair { gauge: 1435.0, ..good.clone() }, "gauge"),
        (ProfilePair { flange_back_distance: 1.5, ..good.clone() }, "flange-back"),
        (ProfilePair { rail_inclination: 20.0, ..good.clone() }, "inclination"),
    ] {
        let error = GeometryTable::shared(&pair).unwrap_err();
        assert!(matches!(error, ContactError::OutOfRange { .. }));
        assert!(error.to_string().contains(word), "{error}");
    }
}
