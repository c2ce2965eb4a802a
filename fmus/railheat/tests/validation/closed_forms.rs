//! Conduction of `model = "energy"` against closed forms: what comes in through the surface,
//! and what runs through the section.

use std::f64::consts::PI;

use numerics::constants::ZERO_CELSIUS;
use railheat::HeatModel;
use railheat::contact::{Material, Wheel};
use railheat::energy::{EnergyModel, Parameters, Resolution, Start};
use railheat::line::Line;
use railheat::section::{Outline, RailFile};
use railheat::weather::{Exchange, Sun, Weather};

use validation::Row;

use crate::PAGE;
use crate::common::SPEED;
use crate::energy_common::{INSULATED, NIGHT, parameters, run, slab, wheel};
use crate::exact::{cooling_slab, half_space_under_flux, impulse};

/// A block with right angles, m.
fn block(height: f64, half_width: f64) -> Outline {
    let (h, w) = (1e3 * height, 1e3 * half_width);
    let text = format!(
        "name = \"block\"\nsource = \"test\"\nheight_mm = {h:.1}\narea_mm2 = {:.1}\n\
         centroid_above_foot_mm = {:.1}\nsecond_moment_mm4 = 1\n\
         corners_mm = [[0, {h:.1}, 0], [{w:.1}, {h:.1}, 0], [{w:.1}, 0, 0], [0, 0, 0]]",
        2.0 * h * w,
        0.5 * h
    );
    RailFile::from_toml(&text, "block").unwrap().outline()
}

/// Takes up all sunlight and gives nothing away; with the sun straight above that is a flux on the top.
const BLACK: Exchange = Exchange { absorptivity: 1.0, filter: 1.0, ..INSULATED };

fn sun(flux: f64) -> Weather {
    Weather { direct: flux, sun: Sun { elevation: 0.5 * PI, azimuth: 0.0 }, ..NIGHT }
}

/// A slab of 172 mm in cells of 1 mm that is read at these depths, m.
fn fine_slab(depths: &[f64]) -> Parameters {
    let base = parameters(slab(), Resolution::Column, 0.001);
    let line = Line { begin: 0.0, element_length: 0.1, elements: 10 };
    Parameters { line, depths: depths.to_vec(), exchange: BLACK, ..base }
}

/// V2: flux of 1e5 W/m² for 1 to 100 s, at 0 (read in the middle of the first cell, 0.5 mm), 5, 10, 20, 60 mm.
/// The closed form meets the table of `docs/reference/conduction.md` (eight digits), the model meets it with cells of 1 mm to 0.2 %
/// and what reading linearly between them leaves, h²/8 of the curvature: 0.03 K after 1 s at 5 mm, and as much
/// of the cells' own. The far side, 172 mm away, does not matter: 2 ierfc(2.6), 2e-4 of the surface's rise.
#[test]
fn analytic_v2_half_space_under_constant_flux() {
    let depths = [0.005, 0.010, 0.020, 0.060];
    let mut model = EnergyModel::new(fine_slab(&depths), &[1], &sun(0.0), 0.0).unwrap();
    let mut now = 0.0;
    for (time, table) in [
        (1.0, [9.4925737, 1.7984218, 0.15334115, 6.794e-5, 0.0]),
        (10.0, [30.018154, 19.15994, 11.412088, 3.2198259, 5.6946e-4]),
        (60.0, [73.52916, 61.704535, 51.218331, 34.093856, 4.0117842]),
        (100.0, [94.925737, 82.949201, 72.013842, 53.187623, 11.767762]),
    ] {
        let depths_of_table = [0.0, 0.005, 0.010, 0.020, 0.060];
        for (depth, wanted) in depths_of_table.into_iter().zip(table) {
            let found = half_space_under_flux(1e5, depth, time);
            assert!((found - wanted).abs() < 1e-6 * wanted + 1e-7, "{time} s, {depth} m: {found}");
        }
        model.step(&[], &sun(1e5), now, time - now);
        now = time;
        for (level, depth) in [0.0005, 0.005, 0.010, 0.020, 0.060].into_iter().enumerate() {
            let (found, wanted) = (model.rise(5, level), half_space_under_flux(1e5, depth, time));
            Row {
                case: &format!("half-space under 1e5 W/m²: {} mm deep after {time} s", 1e3 * depth),
                value: found,
                expected: if wanted < 1e-9 { 0.0 } else { wanted },
                unit: "K",
                source: "V2, docs/reference/conduction.md",
                tolerance: (2e-3 * wanted + 0.06, "cells of 1 mm, read linearly"),
            }
            .holds(&PAGE);
        }
    }
}

/// V12: an instantaneous line source of 1 kJ/m on a half-space, in the section's two dimensions: a block of
/// 280 x 110 mm that a wheel with a contact 1 mm wide heats in 20 ms, before the far sides matter (e^-35), read
/// in the middles of cells of 5 mm, 7.5 and 27.5 mm deep. The differences of second order are off by
/// 6 h²/(48 α t) at these points: 3 % after 10 s, 1 % after 30 s.
#[test]
fn analytic_v12_line_source() {
    let base = parameters(block(0.110, 0.140), Resolution::Plane, 0.005);
    let depths = vec![0.0075, 0.0275];
    let mut model =
        EnergyModel::new(Parameters { depths, interval: 0.02, ..base }, &[1], &NIGHT, 0.0).unwrap();
    let table = |time: f64, r: f64| {
        let alpha = Material::PAPER.diffusivity();
        1000.0 / (2.0 * PI * 40.0 * time) * (-r * r / (4.0 * alpha * time)).exp()
    };
    for (time, wanted) in [
        (1.0, [3.9788736, 0.43744087, 9.34e-9]),
        (10.0, [0.39788736, 0.31906272, 0.05455109]),
        (100.0, [0.039788736, 0.038919901, 0.032618536]),
    ] {
        for (r, wanted) in [0.0, 0.010, 0.030].into_iter().zip(wanted) {
            assert!((table(time, r) - wanted).abs() < 1e-6 * wanted + 1e-10);
        }
    }
    let mut narrow = wheel(10.05);
    narrow.contact.b = 0.0005;
    // Half of 10 kW for 20 ms in 0.1 m: 1 kJ/m.
    let burst = vec![Wheel { speed: 0.0, friction_power: 10e3, ..narrow }];
    model.step(&burst, &NIGHT, 0.0, 0.02);
    let mut now = 0.02;
    for (time, allowed) in [(10.0, 0.03), (30.0, 0.01)] {
        model.step(&[Wheel::default()], &NIGHT, now, time + 0.01 - now);
        now = time + 0.01;
        for (level, r) in [(1, 0.0075), (2, 0.0275)] {
            let (found, wanted) = (model.excess(100, level), table(time, r));
            Row {
                case: &format!("line source of 1 kJ/m: {} mm deep after {time} s", 1e3 * r),
                value: found,
                expected: wanted,
                unit: "K",
                source: "V12, docs/reference/conduction.md",
                tolerance: (allowed * wanted, "cells of 5 mm, 6 h²/(48 α t)"),
            }
            .holds(&PAGE);
        }
    }
}

/// V14: sunlight q₀ cos ωt at 0.01 Hz: at a depth x the amplitude is q₀/(β√ω) e^(-x/μ) and the phase lags by x/μ + π/4, with
/// μ = 18.985 mm. Read over the eighth period, when what began at the start has died away; cells of 1 mm, steps of 0.5 s
/// (whose middle the weather is taken at): 0.5 % and 0.005 rad.
#[test]
fn analytic_v14_harmonic_flux() {
    let (period, steps) = (100.0, 200);
    let omega = 2.0 * PI / period;
    let depths = [0.010, 0.020, 0.060];
    let mut model = EnergyModel::new(fine_slab(&depths), &[1], &sun(0.0), 0.0).unwrap();
    let step = period / f64::from(steps);
    let mut sums = [[0.0; 2]; 4];
    for number in 0..8 * steps {
        let begin = step * f64::from(number);
        let flux = 1e4 * (omega * (begin + 0.5 * step)).cos();
        model.step(&[], &sun(flux), begin, step);
        if number >= 7 * steps {
            let angle = omega * (begin + step);
            for (level, sum) in sums.iter_mut().enumerate() {
                let rise = model.rise(5, level) * 2.0 / f64::from(steps);
                *sum = [sum[0] + rise * angle.cos(), sum[1] + rise * angle.sin()];
            }
        }
    }
    let reach = (Material::PAPER.diffusivity() / (PI * 0.01)).sqrt();
    assert!((reach - 0.018985).abs() < 5e-7, "penetration {reach} m");
    for ([cosine, sine], depth) in sums.into_iter().zip([0.0005, 0.010, 0.020, 0.060]) {
        let amplitude = 1e4 / (Material::PAPER.penetration() * omega.sqrt());
        let wanted = (amplitude * (-depth / reach).exp(), depth / reach + 0.25 * PI);
        let found = (cosine.hypot(sine), sine.atan2(cosine).rem_euclid(2.0 * PI));
        let source = "V14, docs/reference/conduction.md";
        Row {
            case: &format!("sunlight of 0.01 Hz: amplitude {} mm deep", 1e3 * depth),
            value: found.0,
            expected: wanted.0,
            unit: "K",
            source,
            tolerance: (5e-3 * wanted.0, "cells of 1 mm, steps of 0.5 s"),
        }
        .holds(&PAGE);
        Row {
            case: &format!("sunlight of 0.01 Hz: lag {} mm deep", 1e3 * depth),
            value: found.1,
            expected: wanted.1,
            unit: "rad",
            source,
            tolerance: (5e-3, "cells of 1 mm, steps of 0.5 s"),
        }
        .holds(&PAGE);
    }
}

/// V16: a bar of 180 x 60 mm that cools on all sides is the product of two slabs: 60 and 90 mm below the middle of
/// its top, after 60 and 300 s. The exchange acts at the middle of the outermost cells, half a cell within the
/// surface. That is of first order, h dx/(2 k) of the exchange, and while the cold arrives in the middle it counts
/// about twice there: h dx/k of the excess lost is allowed, 2.5 % at 200 W/(m²·K) and 0.2 % in air (15), and 1 % for
/// the rest, of second order (the middle is read 2.5 mm beside it). Half the cells must leave half or less.
#[test]
fn analytic_v16_cooling_bar() {
    for convection in [200.0, 15.0] {
        let errors = |size: f64| {
            let base = parameters(block(0.180, 0.030), Resolution::Plane, size);
            let exchange = Exchange { convection, pad: convection, ..INSULATED };
            let start = Start::Uniform(NIGHT.ambient + 100.0);
            let depths = vec![0.060, 0.090];
            let parameters = Parameters { exchange, start, depths, ..base };
            let mut model = EnergyModel::new(parameters, &[1], &NIGHT, 0.0).unwrap();
            [(0.0, 60.0), (60.0, 300.0)].map(|(now, time)| {
                model.step(&[], &NIGHT, now, time - now);
                [(1, 0.060), (2, 0.090)].map(|(level, depth)| {
                    let exact = 100.0
                        * cooling_slab(0.090, 0.090 - depth, time, convection)
                        * cooling_slab(0.030, 0.0, time, convection);
                    (model.rise(100, level) + 100.0 - exact) / (100.0 - exact)
                })
            })
        };
        let (coarse, fine) = (errors(0.010), errors(0.005));
        println!("h = {convection}: errors of the excess lost {coarse:.5?} {fine:.5?}");
        for (coarse, fine) in coarse.as_flattened().iter().zip(fine.as_flattened()) {
            assert!(fine.abs() < convection * 0.005 / 40.0 + 0.01, "{fine}");
            assert!(fine.abs() < 0.55 * coarse.abs(), "{coarse} {fine}");
        }
    }
}

/// A train of pulses: 36 wheels, 6 of each of 6 vehicles, pass a point in 7 s; each leaves 50 J/m at its own
/// time, and later the rise is the sum of 36 impulses (V8). The rail is the slab, read at the foot, 60 mm deep
/// and in the uppermost cell of 1 mm. The heat comes in over intervals of 0.25 s instead of at once, of second order:
/// 0.5 % of the rise, and 0.02 mK where heat just arrives (2 % there, by cells of 1 mm).
#[test]
fn analytic_pulse_train() {
    let offsets = [7.2, 5.4, 3.6, -3.6, -5.4, -7.2];
    let behind = |wheel: usize| 20.0 * (wheel / 6) as f64 - offsets[wheel % 6];
    let parameters = Parameters { interval: 0.25, ..fine_slab(&[0.060]) };
    let mut model = EnergyModel::new(parameters, &[36], &NIGHT, 0.0).unwrap();
    let at = |time: f64| -> Vec<Wheel> {
        (0..36).map(|index| wheel(-10.0 + SPEED * time - behind(index))).collect()
    };
    run(&mut model, &NIGHT, at, 0.0, 1000, 0.01);
    let mixture = 50.0 / (Material::PAPER.heat_capacity() * slab().properties().area);
    let passes = |index: usize| (0.55 + 10.0 + behind(index)) / SPEED;
    let mut now = 10.0;
    for time in [15.0, 60.0, 156.0, 600.0] {
        model.step(&vec![Wheel::default(); 36], &NIGHT, now, time - now);
        now = time;
        for (level, depth) in [0.0005, 0.060, 0.172].into_iter().enumerate() {
            let pulses = (0..36).map(|index| impulse(depth, time - passes(index)));
            let wanted = mixture * pulses.sum::<f64>();
            let found = model.excess(5, level);
            Row {
                case: &format!("36 wheels: {} mm deep after {time} s", 1e3 * depth),
                value: 1e3 * found,
                expected: if wanted < 1e-9 { 0.0 } else { 1e3 * wanted },
                unit: "mK",
                source: "sum of V8, docs/reference/conduction.md",
                tolerance: (5.0 * wanted + 0.02, "heat over 0.25 s, cells of 1 mm"),
            }
            .holds(&PAGE);
        }
    }
}

/// `docs/reference/conduction.md`: the paper's Table 4 with air of 15 to 50 °C, top surface only, filtered and in full sun (five and four
/// digits given). The rail is a plate 200 m wide and 20 mm thick on an insulating pad, whose sides are 2e-4 of the
/// surface: they take 4e-4 of what the top gets, 0.02 K.
#[test]
fn analytic_weather_equilibrium_of_the_energy_model() {
    for (air, filtered, unfiltered) in [
        (15.0, 60.938, 98.86),
        (25.0, 69.115, 105.72),
        (40.0, 81.458, 116.13),
        (50.0, 89.743, 123.17),
    ] {
        for (filter, wanted) in [(0.5, filtered), (1.0, unfiltered)] {
            let base = parameters(block(0.020, 100.0), Resolution::Column, 0.010);
            let exchange = Exchange { filter, ..Exchange::TYPICAL };
            let parameters = Parameters { exchange, start: Start::Equilibrium, ..base };
            let weather = Weather { ambient: air + ZERO_CELSIUS, ..sun(1366.0) };
            let model = EnergyModel::new(parameters, &[1], &weather, 0.0).unwrap();
            let found = model.initial_temperature() - ZERO_CELSIUS;
            Row {
                case: &format!("energy model in balance, air of {air} °C, filter {filter}"),
                value: found,
                expected: wanted,
                unit: "°C",
                source: "closed form, docs/reference/conduction.md",
                tolerance: (0.03, "sides of the plate"),
            }
            .holds(&PAGE);
        }
    }
}
