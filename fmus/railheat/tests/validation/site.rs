//! Sun, direction of the track, shadow of the train, a day that comes again.

use std::f64::consts::{FRAC_PI_2, TAU};

use railheat::HeatModel;
use railheat::contact::Wheel;
use railheat::energy::{
    Azimuth, Day, EnergyModel, Parameters, Resolution, SECTOR, Start, TrainWeather, sectors,
};
use railheat::weather::{Body, Ephemeris, Exchange, Sun, Weather};

use validation::Row;

use crate::PAGE;
use crate::energy_common::{INSULATED, NIGHT, outline, parameters, run, wheel};

const MORNING: Weather =
    Weather { direct: 800.0, sun: Sun { elevation: 0.5, azimuth: FRAC_PI_2 }, ..NIGHT };

fn energy(parameters: Parameters, weather: &Weather) -> EnergyModel {
    EnergyModel::new(parameters, &[1], weather, 0.0).unwrap()
}

/// Reda and Andreas, *Solar Energy* 76 (2004) 577, table A5.1: Golden, 17 October 2003, 12:30:30 at -7 h: elevation
/// without refraction 39.872046°, azimuth 194.340241°. The example stands 1830 m high, which is 1e-6° here;
/// its ΔT is 67 s, the crate's estimate 64.5 s: 1e-4°. 0.0003° is what the algorithm promises.
#[test]
fn benchmark_sun_position() {
    let (latitude, longitude) = (39.742476_f64.to_radians(), (-105.1786_f64).to_radians());
    let golden = Ephemeris::new("2003-10-17T12:00:00-07:00", latitude, longitude).unwrap();
    let sun = golden.at(1830.0);
    for (what, value, expected) in [
        ("elevation", sun.elevation.to_degrees(), 39.872046),
        ("azimuth", sun.azimuth.to_degrees(), 194.340241),
    ] {
        Row {
            case: &format!("{what} of the sun over Golden, 17 October 2003"),
            value,
            expected,
            unit: "°",
            source: "Reda and Andreas, Solar Energy 76 (2004) 577, table A5.1",
            tolerance: (3e-4, "what the algorithm promises"),
        }
        .holds(&PAGE);
    }
}

#[test]
fn wrong_places_and_times_are_named() {
    for (text, latitude, wanted) in [
        ("yesterday", 0.0, "site.date_time = \"yesterday\""),
        ("2018-06-21T14:30:00", 0.0, "such as 2018-06-21T14:30:00+10:00"),
        ("2018-06-21T14:30:00+10:00", 2.0, "site.latitude = 114.59"),
    ] {
        let sentence = Ephemeris::new(text, latitude, 0.0).unwrap_err().to_string();
        assert!(sentence.contains(wanted), "{sentence}");
    }
}

/// By the model's own clock: at the equinox on the equator the sun stands straight above at noon and is
/// down at midnight (equation of time 7.5 min, declination under 0.4°: 2.5°).
#[test]
fn analytic_noon_and_midnight_on_the_equator() {
    let ephemeris = Ephemeris::new("2018-03-20T00:00:00Z", 0.0, 0.0).unwrap();
    let (noon, midnight) = (ephemeris.at(43_200.0), ephemeris.at(0.0));
    assert!((noon.elevation - FRAC_PI_2).abs() < 2.5_f64.to_radians(), "{noon:?}");
    assert!((midnight.elevation + FRAC_PI_2).abs() < 2.5_f64.to_radians(), "{midnight:?}");
    let base = parameters(outline("AS60"), Resolution::Column, 0.012);
    let exchange = Exchange { convection: 10.0, absorptivity: 0.8, filter: 1.0, ..INSULATED };
    let parameters = Parameters { exchange, ephemeris: Some(ephemeris), ..base };
    // The sun of the weather, low in the east, does not count.
    let mut model = energy(parameters, &MORNING);
    run(&mut model, &MORNING, |_| vec![], 0.0, 10, 1800.0);
    assert!(model.untouched_surface().abs() < 1e-9, "dark until 5 h");
    run(&mut model, &MORNING, |_| vec![], 18_000.0, 14, 1800.0);
    assert!(model.untouched_surface() > 10.0, "{} K at noon", model.untouched_surface());
}

/// A quarter circle falls into sectors of at most 5°, all elements within half of it of their mean, and a full
/// turn comes back to the first.
#[test]
fn property_sectors_of_a_curve() {
    let along: Vec<f64> = (0..200).map(|i| 0.3 + FRAC_PI_2 * f64::from(i) / 200.0).collect();
    let (found, of_element) = sectors(&Azimuth::Along(along.clone()), 200);
    assert!((18..=19).contains(&found.len()), "{}", found.len());
    assert_eq!(found.iter().map(|sector| sector.elements).sum::<usize>(), 200);
    for (azimuth, sector) in along.iter().zip(&of_element) {
        assert!((azimuth - found[usize::from(*sector)].azimuth).abs() <= SECTOR);
    }
    let turn = sectors(&Azimuth::Along(vec![1.0, 1.0 + TAU, 1.0 - TAU]), 3);
    assert_eq!((turn.0.len(), turn.1), (1, vec![0, 0, 0]));
}

/// What counts is the angle between sun and track: rail where the track has turned is as warm as that of
/// a track that runs there from the beginning. To rounding.
#[test]
fn analytic_the_suns_light_follows_the_curve() {
    let base = parameters(outline("AS60"), Resolution::Plane, 0.012);
    let exchange = Exchange { convection: 10.0, absorptivity: 0.8, filter: 1.0, ..INSULATED };
    let with = |azimuth| Parameters { azimuth, exchange, ..base.clone() };
    let bend = (0..200).map(|i| if i < 100 { 0.2 } else { 1.3 }).collect();
    let mut bent = energy(with(Azimuth::Along(bend)), &MORNING);
    let mut straight = [0.2, 1.3].map(|azimuth| energy(with(Azimuth::Constant(azimuth)), &MORNING));
    run(&mut bent, &MORNING, |_| vec![], 0.0, 60, 60.0);
    for (model, element) in straight.iter_mut().zip([50, 150]) {
        run(model, &MORNING, |_| vec![], 0.0, 60, 60.0);
        for level in 0..3 {
            let (found, wanted) = (bent.rise(element, level), model.rise(element, level));
            assert!((found - wanted).abs() < 1e-11, "level {level}: {found} against {wanted}");
        }
        let heat = bent.heat_per_metre(element) - bent.sources_per_metre(element).weather;
        assert!(heat.abs() < 1e-9 * bent.heat_per_metre(element));
    }
    let difference = bent.rise(50, 1) - bent.rise(150, 1);
    assert!(difference > 0.3, "{difference} K by the direction");
    assert!(bent.ledger().error().abs() < 1e-9 * bent.ledger().sources.moved());
}

/// The body of 3 m from 1.1 to 3.9 m above the left rail: below the sun its shadow is itself; with the sun ahead
/// at 45° it lies behind by the roof's and the floor's height; the sun from the left gets below the floor under
/// atan(1.1/0.7465), that from the right under atan(1.1/2.2535).
#[test]
fn analytic_shadow_of_a_vehicle() {
    let body = [100.0, 120.0];
    let shadow = |elevation: f64, azimuth: f64| {
        let sun = Sun { elevation, azimuth: azimuth.to_radians() };
        Body::WAGON.shadow(&sun, 0.0, body)
    };
    let [from, to] = shadow(FRAC_PI_2, 0.0).unwrap();
    assert!((from - 100.0).abs() < 1e-12 && (to - 120.0).abs() < 1e-12);
    let [from, to] = shadow(FRAC_PI_2 / 2.0, 0.0).unwrap();
    assert!((from - 96.1).abs() < 1e-12 && (to - 118.9).abs() < 1e-12, "{from} {to}");
    for (azimuth, across) in [(-90.0, 1.5_f64 - 0.7535), (90.0, 1.5 + 0.7535)] {
        let limit = (1.1_f64 / across).atan();
        assert!(shadow(limit - 0.01, azimuth).is_none() && shadow(limit + 0.01, azimuth).is_some());
    }
    assert!(shadow(-0.1, 0.0).is_none(), "night");
}

/// Under a standing vehicle the rail loses the direct sun on its surface, 800 W/m² on all that is lit, once even
/// where the shadows of two vehicles overlap, and nothing when the sun shines in below the floor.
#[test]
fn analytic_shade_takes_the_direct_sun() {
    let base = parameters(outline("AS60"), Resolution::Plane, 0.012);
    let exchange = Exchange { absorptivity: 1.0, filter: 1.0, ..INSULATED };
    let train = TrainWeather { shade: Some(Body::WAGON), ..base.train };
    let of = |elevation: f64| {
        let weather = Weather { sun: Sun { elevation, azimuth: 0.7 }, ..MORNING };
        let parameters = Parameters { exchange, train, ..base.clone() };
        let mut model = EnergyModel::new(parameters, &[1, 1], &weather, 0.0).unwrap();
        let at = |position: f64| Wheel { speed: 0.0, friction_power: 0.0, ..wheel(position) };
        let standing = |_| vec![at(10.0), at(11.0)];
        run(&mut model, &weather, standing, 0.0, 60, 1.0);
        (model.heat_per_metre(100), model.heat_per_metre(10))
    };
    let (under, beside) = of(1.2);
    assert!(beside > 1000.0 && under.abs() < 1e-9 * beside, "{under} under, {beside} beside");
    let (under, beside) = of(0.2);
    assert_eq!(under, beside, "the sun shines in below the floor");
}

/// A day of air temperature A cos ωt over a rail that only convects: amplitude A/√(1 + (ωτ)²), later by
/// atan ωτ/ω, with τ = m c/(h P) (lumped: Biot number h A/(P k) = 0.004, so 1 %). The start is that of the
/// periodic state, and a day later the rail is back there, but for the steps of a minute in the day and of 10 s
/// in the run: 0.01 K.
#[test]
fn analytic_a_day_that_comes_again() {
    let omega = TAU / 86_400.0;
    let air = |time: f64| Weather { ambient: 290.0 + 10.0 * (omega * time).cos(), ..NIGHT };
    let base = parameters(outline("AS60"), Resolution::Plane, 0.012);
    let section = base.outline.properties();
    let capacity = base.material.heat_capacity() * section.area;
    let exchange = Exchange { convection: 15.0, ..INSULATED };
    let lag = omega * capacity / (15.0 * (section.perimeter - 0.142));
    for hour in [0.0, 6.0, 15.0] {
        let start = 3600.0 * hour;
        let weather = (0..1440).map(|i| air(start - 86_400.0 + 60.0 * (f64::from(i) + 0.5)));
        let day = Day { weather: weather.collect(), step: 60.0 };
        let parameters = Parameters { exchange, start: Start::Day(day), ..base.clone() };
        let mut model = EnergyModel::new(parameters, &[1], &air(start), start).unwrap();
        let wanted = 10.0 * (omega * start - lag.atan()).cos() / (1.0 + lag * lag).sqrt();
        let found = model.initial_temperature() - 290.0;
        Row {
            case: &format!("day that comes again: rail at {hour} h"),
            value: found,
            expected: wanted,
            unit: "K",
            source: "lumped rail in closed form",
            tolerance: (0.1, "Biot number of 0.004, 1 %"),
        }
        .holds(&PAGE);
        let mut noticed = 0.0_f64;
        for step in 0..1440 {
            let begin = start + 60.0 * f64::from(step);
            model.step(&[], &air(begin + 30.0), begin, 60.0);
            noticed = noticed.max(model.rise(50, 2).abs());
        }
        assert!(noticed > 9.0, "the day matters: {noticed} K");
        println!("a day later {:.1e} K, foot {:.1e} K", model.rise(50, 0), model.rise(50, 2));
        assert!(model.rise(50, 0).abs() < 0.01 && model.rise(50, 2).abs() < 0.01);
        assert!(model.ledger().error().abs() < 1e-9 * model.ledger().sources.moved().max(1e5));
    }
}

/// With weather that does not change the periodic day is the equilibrium, and the rail stays there.
#[test]
fn property_a_constant_day_is_the_equilibrium() {
    let base = parameters(outline("60E1"), Resolution::Plane, 0.012);
    let exchange = Exchange { pad: 20.0, filter: 0.6, ..Exchange::TYPICAL };
    let model = |start| energy(Parameters { exchange, start, ..base.clone() }, &MORNING);
    let day = Day { weather: vec![MORNING; 1440], step: 60.0 };
    let (mut after_days, still) = (model(Start::Day(day)), model(Start::Equilibrium));
    let difference = after_days.initial_temperature() - still.initial_temperature();
    assert!(difference.abs() < 1e-5, "{difference} K");
    run(&mut after_days, &MORNING, |_| vec![], 0.0, 60, 60.0);
    assert!(after_days.rise(50, 0).abs() < 1e-5 && after_days.rise(50, 2).abs() < 1e-5);
}

#[test]
fn a_rail_that_never_settles_is_named() {
    let base = parameters(outline("60E1"), Resolution::Column, 0.02);
    let exchange = Exchange { absorptivity: 0.5, filter: 1.0, ..INSULATED };
    let day = Day { weather: vec![MORNING; 24], step: 3600.0 };
    let parameters = Parameters { exchange, start: Start::Day(day), ..base };
    let sentence = EnergyModel::new(parameters, &[1], &MORNING, 0.0).err().unwrap().to_string();
    assert!(sentence.contains("initial.day") && sentence.contains("exchange heat"), "{sentence}");
}
