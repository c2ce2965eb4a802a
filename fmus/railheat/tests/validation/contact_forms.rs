//! What happens in the contact itself, against closed forms: Jaeger's moving band, the contact of two bodies of
//! different temperature, and the case of Ertz and Knothe with what CONTACT makes of it.

use std::f64::consts::PI;

use railheat::contact::chill::conductance;
use railheat::contact::{Contact, Material, Wheel, WheelHeat};
use railheat::energy::{EnergyModel, Parameters, Resolution};

use validation::Row;

use crate::PAGE;
use crate::common::SPEED;
use crate::energy_common::{NIGHT, outline, parameters, run, wheel};

/// e^u K₀(|u|) by the integral of exp(u - |u| cosh t).
fn kernel(u: f64) -> f64 {
    let far = (1.0 + 40.0 / u.abs()).acosh();
    let points = 200;
    let step = far / f64::from(points);
    let value = |i: u32| (u - u.abs() * (step * f64::from(i)).cosh()).exp();
    step * (0.5 * value(0) + (1..=points).map(value).sum::<f64>())
}

/// V10: steady rise under a moving band with a flux of some shape over -1 to 1, in 2 α q/(π k v), at X behind
/// its middle, both over 2 α/v; L is the half width. Substitution u = ±w² for the singularity there.
fn band(half: f64, at: f64, shape: impl Fn(f64) -> f64) -> f64 {
    let points = 400;
    let side = |end: f64, sign: f64| {
        let root = end.max(0.0).sqrt();
        let step = root / f64::from(points);
        let value = |i: u32| {
            let w = (f64::from(i) + 0.5) * step;
            let u = sign * w * w;
            2.0 * w * shape((at - u) / half) * kernel(u)
        };
        step * (0..points).map(value).sum::<f64>()
    };
    side(at + half, 1.0) + side(half - at, -1.0)
}

/// The highest value of a function with one maximum between 0 and 1, and where it is.
fn highest(value: impl Fn(f64) -> f64) -> (f64, f64) {
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..40 {
        let third = (high - low) / 3.0;
        if value(low + third) < value(high - third) { low += third } else { high -= third }
    }
    (value(0.5 * (low + high)), 0.5 * (low + high))
}

/// V10 (Jaeger): highest rise of a uniform band, where it is and the share of the fast limit 2 √(πL); five
/// and four digits are given, the quadrature is good to 1e-4.
#[test]
fn analytic_v10_moving_band() {
    for (half, wanted, wanted_at, of_limit) in [
        (0.5, 2.04859, 0.5367, 0.8173),
        (1.0, 3.11599, 0.6664, 0.8790),
        (5.0, 7.61271, 0.8759, 0.9604),
        (10.0, 10.94844, 0.9244, 0.9767),
        (100.0, 35.32293, 0.9877, 0.9964),
    ] {
        let (found, at) = highest(|x| band(half, x * half, |_| 1.0));
        let source = "V10 (Jaeger 1942), docs/reference/conduction.md";
        Row {
            case: &format!("moving band, L = {half}: highest rise"),
            value: found,
            expected: wanted,
            unit: "2αq/(πkv)",
            source,
            tolerance: (2e-4 * wanted, "quadrature of the test"),
        }
        .holds(&PAGE);
        Row {
            case: &format!("moving band, L = {half}: where"),
            value: at,
            expected: wanted_at,
            unit: "a",
            source,
            tolerance: (5e-3, "quadrature of the test"),
        }
        .holds(&PAGE);
        assert!((found / (2.0 * (PI * half).sqrt()) - of_limit).abs() < 3e-4);
    }
}

/// The model's flash rise is the fast limit of a Hertz-shaped band. The exact moving band lies below it by 0.1 % at
/// L = 10, 0.04 m/s here, and by less above; a wheel at 60 km/h has L = 4600. The quadrature is good to 1e-4.
#[test]
fn analytic_v10_the_flash_rise_is_the_fast_limit() {
    let steel = Material::PAPER;
    let hertz = |s: f64| (1.0 - s * s).max(0.0).sqrt();
    for (half, low, high) in [(10.0, 0.998, 1.0), (100.0, 0.9995, 1.0001)] {
        let speed = half * 2.0 * steel.diffusivity() / 0.0063;
        let wheel = Wheel { speed, friction_power: 1000.0, ..wheel(0.0) };
        let flash = WheelHeat::TYPICAL.flash(&wheel, &steel);
        let peak_flux = 0.5 * 1.5 * 1000.0 / (PI * 0.0063 * 0.0063);
        let unit = 2.0 * steel.diffusivity() * peak_flux / (PI * steel.conductivity * speed);
        let (exact, _) = highest(|x| band(half, x * half, hertz));
        println!("L = {half}: exact over flash {:.5}", unit * exact / flash);
        assert!((low..high).contains(&(unit * exact / flash)));
    }
    assert!(SPEED * 0.0063 / (2.0 * steel.diffusivity()) > 4600.0);
}

/// V13, release law of Ertz and Knothe (eq. 47): behind the contact the rail's surface has (2/π) ε ΔT asin √(2a/(a+x)). Far
/// behind, that is the rise β⁻¹ E/√(πx/v) of the heat E per area; summed over the strips of the ellipse it must be what the
/// model's conductance leaves. The sum over 2000 strips is good to 1e-4 at the ends of the ellipse.
#[test]
fn analytic_v13_release_law_has_the_heat_of_the_conductance() {
    let beta = Material::PAPER.penetration();
    let (a, b) = (0.00588, 0.01054);
    let strips = 2000;
    let heat = |strip: u32| {
        let u = (f64::from(strip) + 0.5) / f64::from(strips) * 2.0 - 1.0;
        let half = a * (1.0 - u * u).sqrt();
        let far = 1e6 * half;
        let rise = 2.0 / PI * 0.5 * (2.0 * half / (half + far)).sqrt().asin();
        rise * beta * (PI * far / SPEED).sqrt() * 2.0 * b / f64::from(strips)
    };
    let of_release: f64 = (0..strips).map(heat).sum();
    let of_model = conductance(beta, a, b, SPEED) / SPEED;
    Row {
        case: "heat through a contact of 5.88 x 10.54 mm at 60 km/h",
        value: of_model,
        expected: of_release,
        unit: "J/(m K)",
        source: "V13, release law of Ertz and Knothe 2002",
        tolerance: (2e-4 * of_release, "sum over 2000 strips"),
    }
    .holds(&PAGE);
    // In contact both surfaces have the mean of their temperatures, as the law has it at its begin.
    assert!((2.0 / PI * 0.5 * 1.0_f64.asin() - 0.5).abs() < 1e-15);
}

/// A wheel 20 K warmer than the rail leaves G ΔT/v in each metre: 2.03 J/m per kelvin at 60 km/h for a contact of 6.3 mm
/// (`docs/reference/conduction.md`). The wheel itself cools by 0.5 mK meanwhile.
#[test]
fn benchmark_chill_heat_per_metre() {
    let base = parameters(outline("AS60"), Resolution::Plane, 0.012);
    let wheel_heat = WheelHeat { contact_quality: 1.0, initial_rise: 20.0, ..base.wheel };
    let parameters = Parameters { wheel: wheel_heat, ..base };
    let mut model = EnergyModel::new(parameters, &[1], &NIGHT, 0.0).unwrap();
    let rolling = |t: f64| vec![Wheel { friction_power: 0.0, ..wheel(5.0 + SPEED * t) }];
    run(&mut model, &NIGHT, rolling, 0.0, 50, 0.01);
    let per_kelvin = model.sources_per_metre(80).chill / 20.0;
    Row {
        case: "rail chill of a wheel 20 K warmer, 6.3 x 6.3 mm, 60 km/h",
        value: per_kelvin,
        expected: 2.03,
        unit: "J/(m K)",
        source: "closed form, docs/reference/conduction.md",
        tolerance: (0.005, "three digits are given"),
    }
    .holds(&PAGE);
}

/// The Ertz-Knothe case, full slip: 150.30 K in closed form, 166.8 K in print from CONTACT. Its sum over cells of
/// q 2(√(x - x_j + h) - √(x - x_j - h)) takes 2√h for the cell itself, to which the factor 2 comes again, where the
/// integral gives √h. The right sum gives 150.27 K with its cells of 0.2 mm and stays with smaller ones; the doubled one
/// gives 164.4, 160.1 and 157.2 K with 0.2, 0.1 and 0.05 mm (`docs/reference/conduction.md`), so that it has no limit but the integral. What
/// is left to 166.8 is elastic slip, 1.4 %. Four digits are given: 0.1 K.
#[test]
fn benchmark_ertz_knothe_and_what_contact_makes_of_it() {
    let steel = Material { conductivity: 50.0, ..Material::PAPER };
    let (a, b, speed) = (0.00588, 0.01054, 30.0);
    let peak_flux = 0.3 * 1.5 * 100e3 / (PI * a * b) * 1.0;
    let rise = |cell: f64, own: f64| {
        let half = 0.5 * cell;
        let count = (a / cell) as i32;
        let flux = |j: i32| (1.0 - (f64::from(j) * cell / a).powi(2)).max(0.0).sqrt() * peak_flux;
        let at = |i: i32| {
            let before = |j: i32| {
                let x = f64::from(i - j) * cell;
                2.0 * flux(j) * ((x + half).sqrt() - (x - half).sqrt())
            };
            let sum = (-count..i).map(before).sum::<f64>() + 2.0 * flux(i) * own * half.sqrt();
            0.5 * sum / (steel.penetration() * (PI * speed).sqrt())
        };
        (-count..=count).map(at).fold(0.0, f64::max)
    };
    let contact = Contact { normal_force: 100e3, a, b };
    let model = Wheel { speed, friction_power: 30e3, contact, ..Wheel::default() };
    let exact = WheelHeat::TYPICAL.flash(&model, &steel);
    for (cell, wanted) in [(0.2e-3, 164.4), (0.1e-3, 160.1), (0.05e-3, 157.2)] {
        let (right, doubled) = (rise(cell, 1.0), rise(cell, 2.0));
        Row {
            case: &format!("Ertz-Knothe case against sums over cells of {} mm", 1e3 * cell),
            value: exact,
            expected: right,
            unit: "K",
            source: "CONTACT's sum with the cell's own term once",
            tolerance: (0.1, "four digits are given"),
        }
        .holds(&PAGE);
        Row {
            case: &format!("CONTACT's sum over cells of {} mm, own term twice", 1e3 * cell),
            value: doubled,
            expected: wanted,
            unit: "K",
            source: "CONTACT, user guide, `ertz_temperature`",
            tolerance: (0.1, "four digits are given"),
        }
        .holds(&PAGE);
    }
}
