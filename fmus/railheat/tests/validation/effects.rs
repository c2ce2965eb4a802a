//! Single effects of `model = "energy"` against closed forms and published numbers.

use railheat::contact::chill::conductance;
use railheat::contact::{MEAN_OVER_PEAK, Material, Wheel, WheelHeat};
use railheat::energy::Beam;
use railheat::section::Cells;
use railheat::weather::{Exchange, Sun, Surface};

use validation::Row;

use crate::PAGE;
use crate::energy_common::{INSULATED, outline, parameters, slab};

/// Rail chill in `docs/reference/conduction.md`: conductance for two contacts at five speeds (three digits given).
#[test]
fn benchmark_chill_conductance() {
    let beta = Material::PAPER.penetration();
    for (speed, wide, round) in [
        (5.56, 31.6, 19.5),
        (11.11, 44.7, 27.6),
        (16.67, 54.7, 33.8),
        (22.22, 63.2, 39.1),
        (30.0, 73.4, 45.4),
    ] {
        for (contact, [a, b], wanted) in [
            ("5.88 x 10.54 mm", [0.00588, 0.01054], wide),
            ("6.3 x 6.3 mm", [0.0063, 0.0063], round),
        ] {
            Row {
                case: &format!("conductance of a contact of {contact} at {speed} m/s"),
                value: conductance(beta, a, b, speed),
                expected: wanted,
                unit: "W/K",
                source: "closed form, docs/reference/conduction.md",
                tolerance: (0.06, "three digits are given"),
            }
            .holds(&PAGE);
        }
    }
}

/// Ertz and Knothe, *Wear* 253 (2002) 498: full slip, 30 kW at 30 m/s; closed form 150.30 K
/// (CONTACT prints 166.8, for a doubled term and elastic slip). The mean over the patch is
/// 0.6765 of the same unit. Five digits are given.
#[test]
fn analytic_flash_of_the_ertz_knothe_case() {
    let heat = parameters(slab(), railheat::energy::Resolution::Column, 0.02).wheel;
    let wheel = Wheel {
        speed: 30.0,
        friction_power: 30e3,
        contact: railheat::contact::Contact { normal_force: 1e5, a: 0.00588, b: 0.01054 },
        ..Wheel::default()
    };
    let steel = Material { conductivity: 50.0, ..Material::PAPER };
    let peak = WheelHeat { partition: 0.5, ..heat }.flash(&wheel, &steel);
    let source = "Ertz and Knothe, Wear 253 (2002) 498";
    Row {
        case: "flash rise of the Ertz-Knothe case by its friction power",
        value: peak,
        expected: 150.30,
        unit: "K",
        source,
        tolerance: (0.02, "five digits are given"),
    }
    .holds(&PAGE);
    Row {
        case: "mean of it over the contact",
        value: peak * MEAN_OVER_PEAK,
        expected: 150.30 * 0.6765063 / 1.2346198,
        unit: "K",
        source: "closed form, docs/reference/conduction.md",
        tolerance: (0.017, "the same digits"),
    }
    .holds(&PAGE);
    let in_a_part = Wheel { flash_factor: 1.5, ..wheel };
    assert_eq!(heat.flash(&in_a_part, &steel), 1.5 * heat.flash(&wheel, &steel));
}

/// `docs/reference/section.md`, Winkler beam of AS60 with E I = 6.15 MN m²: highest moment (three digits, and 40 t are
/// 196.2 kN: 0.3 %) and thermoelastic change at the foot (whole mK); two wheel loads, three track moduli.
#[test]
fn benchmark_bending() {
    let steel = Material::PAPER.heat_capacity();
    for (load, rows) in [
        (109_500.0, [(20e6, 28.8, -74.0), (35e6, 25.1, -65.0), (60e6, 21.9, -57.0)]),
        (196_000.0, [(20e6, 51.7, -133.0), (35e6, 44.9, -116.0), (60e6, 39.3, -101.0)]),
    ] {
        for (track_modulus, moment, change) in rows {
            let beam = Beam {
                modulus: 6.15e6 / 29.3e-6,
                second_moment: 29.3e-6,
                to_foot: 0.07923,
                track_modulus,
                expansion: 11.5e-6,
                loss_factor: 1e-3,
            };
            let highest = beam.moment([(load, 0.0)]);
            let source = "Winkler's beam by hand, docs/reference/section.md";
            let of_wheel = format!("{} kN on {} MPa", load / 1e3, track_modulus / 1e6);
            Row {
                case: &format!("bending moment under {of_wheel}"),
                value: highest / 1000.0,
                expected: moment,
                unit: "kN m",
                source,
                tolerance: (0.003 * moment, "three digits, and 40 t are 196.2 kN"),
            }
            .holds(&PAGE);
            let found = 1000.0 * beam.thermoelastic(highest, 293.0, steel);
            Row {
                case: &format!("thermoelastic change of the foot under {of_wheel}"),
                value: found,
                expected: change,
                unit: "mK",
                source,
                tolerance: (1.0, "whole mK are given"),
            }
            .holds(&PAGE);
            let uplift = beam.moment([(load, 0.5 * std::f64::consts::PI / beam.decay())]) / highest;
            Row {
                case: &format!("uplift over the moment under {of_wheel}"),
                value: uplift,
                expected: -0.208,
                unit: "1",
                source,
                tolerance: (5e-4, "three digits are given"),
            }
            .holds(&PAGE);
        }
    }
}

/// `docs/reference/section.md`, hysteresis of 780 wheels of 22.3 t axles on 35 MPa: 5.5 mK in the outermost fibre
/// of the foot with η = 1e-3 (two digits).
#[test]
fn benchmark_hysteresis() {
    let beam = Beam {
        modulus: 6.15e6 / 29.3e-6,
        second_moment: 29.3e-6,
        to_foot: 0.07923,
        track_modulus: 35e6,
        expansion: 0.0,
        loss_factor: 1e-3,
    };
    // Heat per volume in the outermost fibre: the total by the second moment times its distance squared.
    let per_volume = beam.hysteresis(109_500.0) * beam.to_foot.powi(2) / beam.second_moment;
    let rise = 780.0 * per_volume / Material::PAPER.heat_capacity();
    Row {
        case: "rise of the foot by hysteresis under 780 wheels",
        value: 1000.0 * rise,
        expected: 5.5,
        unit: "mK",
        source: "by hand, docs/reference/section.md",
        tolerance: (0.1, "two digits are given"),
    }
    .holds(&PAGE);
}

/// The sun in the east above a track to the north lights the right sides, at 30° the crown by one
/// half; the web below the head's overhang is in the shade when it stands high. At night nothing.
#[test]
fn analytic_sun_on_the_surfaces() {
    let outline = outline("AS60");
    let cells = Cells::grid(&outline, 0.006);
    let surface = Surface::new(&cells);
    let lit = |degrees: f64| {
        let sun = Sun { elevation: degrees.to_radians(), azimuth: 90_f64.to_radians() };
        sun.lit(&outline, surface.facets(), 0.0)
    };
    let at = |lit: &[f64], y: f64, z: f64| {
        let distance = |i: &usize| {
            let middle = surface.facets()[*i].middle();
            (middle.y - y).hypot(middle.z - z)
        };
        let nearest = (0..lit.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)));
        lit[nearest.unwrap()]
    };
    let low = lit(30.0);
    assert!((at(&low, 0.0, 0.0) - 0.5).abs() < 0.02, "{}", at(&low, 0.0, 0.0));
    assert!(at(&low, 0.035, 0.025) > 0.8 && at(&low, -0.035, 0.025) == 0.0);
    assert!(at(&low, 0.008, 0.1) > 0.8, "the low sun reaches the web");
    let high = lit(80.0);
    assert_eq!(at(&high, 0.008, 0.06), 0.0, "the head shades the web");
    assert!(at(&high, 0.05, 0.16) > 0.8, "the foot is in the sun");
    assert!(lit(-1.0).iter().all(|lit| *lit == 0.0));
}

/// McAdams as used by Hong et al. 2019: 5.6 in still air, 25.6 at 5 m/s, 7.2 W^0.78 above.
#[test]
fn benchmark_convection_by_wind() {
    let exchange = Exchange { convection: 5.6, ..INSULATED };
    for (wind, wanted) in [(0.0, 5.6), (5.0, 25.6), (10.0, 7.2 * 10_f64.powf(0.78))] {
        Row {
            case: &format!("convection in a wind of {wind} m/s"),
            value: exchange.coefficient(wind),
            expected: wanted,
            unit: "W/(m² K)",
            source: "McAdams as used by Hong et al. 2019",
            tolerance: (1e-12, "rounding"),
        }
        .holds(&PAGE);
    }
}
