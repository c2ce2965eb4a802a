//! Friction by temperature, and the flash temperature of a contact that slips in part, against CONTACT.
//!
//! The rows are those of its example of a locomotive in a curve (`contact-temperature-friction.csv`): the
//! Eurosprinter's contact at 10 m/s, mu 0.33 up to 0 °C. Its head says 50 W/(m K); its temperatures at full
//! slip with constant friction are those of 40 W/(m K), with which they agree within 0.2 %, as with 50 they
//! would be 11 % lower. So the steel is the one that this program has.

use crate::{PAGE, eurosprinter};
use contact::flash::flash_rise;
use contact::{
    CreepForces, ExactRolling, FallingFriction, Friction, FrictionByTemperature, Reduction,
    SlipVelocity,
};
use validation::Row;

const SPEED: f64 = 10.0;

/// Series, creepage, force in N, power in W, highest temperature in K.
const ROWS: &str = include_str!("contact-temperature-friction.csv");

/// sqrt(k rho c) of the steel, W √s/(m² K).
const PENETRATION: f64 = 11_887.0;

struct Case {
    series: usize,
    creepage: f64,
    force: f64,
    temperature: f64,
}

fn cases() -> impl Iterator<Item = Case> {
    let rows = ROWS.lines().filter(|line| line.starts_with(|first: char| first.is_ascii_digit()));
    rows.map(|row| {
        let values: Vec<f64> = row.split(',').map(|value| value.parse().unwrap()).collect();
        let [series, creepage, force, _, temperature] = values[..] else { panic!("{row}") };
        Case { series: series as usize, creepage, force, temperature }
    })
}

/// Friction of a series: change over the reference coefficient, and range in K.
fn friction(series: usize) -> Friction {
    let (change, range) = match series {
        1 => return FallingFriction::constant(0.33).into(),
        2 => (0.19, 1200.0),
        3 => (-0.19, 1200.0),
        _ => (-0.19, 400.0),
    };
    FrictionByTemperature {
        reference_coefficient: 0.33,
        limit_ratio: 1.0 + change / 0.33,
        reference_temperature: 0.0,
        range,
        bulk_temperature: 0.0,
    }
    .into()
}

/// Highest rise of the surface, K.
fn flash(forces: &CreepForces) -> f64 {
    let patch = eurosprinter();
    let energy = 0.5 * forces.friction_power / SPEED;
    forces.flash_factor * flash_rise(energy, patch.a, patch.b, SPEED, PENETRATION)
}

fn found(series: usize, creepage: f64) -> CreepForces {
    let law = ExactRolling::new(Reduction::NONE, friction(series));
    let slip = SlipVelocity { longitudinal: SPEED * creepage, ..SlipVelocity::default() };
    law.force(&eurosprinter(), &slip, SPEED)
}

#[test]
fn benchmark_temperature_print() {
    for case in cases() {
        let forces = found(case.series, case.creepage);
        println!(
            "{} {} force {:.0} {:.0} {:+.2} % T {:.4} {:.4} {:+.2} % factor {:.3}",
            case.series,
            case.creepage,
            forces.force.longitudinal,
            case.force,
            100.0 * (forces.force.longitudinal / case.force - 1.0),
            flash(&forces),
            case.temperature,
            100.0 * (flash(&forces) / case.temperature - 1.0),
            forces.flash_factor
        );
    }
    let _ = (PAGE, |row: Row| row.value);
}
