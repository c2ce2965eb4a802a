//! How warm the foot of an AS60 rail gets under a train of 130 six-axle vehicles at 60 km/h, and when it
//! first rises by 15 mK: the cases of `docs/foot-heating.md`.
//!
//! ```text
//! cargo run --release -p railheat --example foot_study
//! ```
//!
//! The friction power of each wheel is put in by its energy per metre (T-gamma), an assumption of each case;
//! everything else is the model. The middle of 5 m of track is read, 30 min after the train.

#[path = "../benches/train/mod.rs"]
mod train;

use railheat::HeatModel;
use railheat::contact::{Wheel, WheelHeat};
use railheat::energy::{Beam, EnergyModel, Parameters, TrainWeather};
use railheat::line::Line;
use railheat::section::RailFile;
use railheat::weather::{Sun, Weather};
use train::{SPEED, VEHICLES};

/// A clear night, and a summer's day with the sun high at the side.
const NIGHT: Weather = Weather { wind: 1.0, ..Weather::still(288.15) };
const DAY: Weather = Weather {
    direct: 900.0,
    diffuse: 100.0,
    sun: Sun { elevation: 1.0, azimuth: 1.2 },
    ambient: 303.15,
    ..NIGHT
};

/// One case: friction energy per metre of locomotives' and wagons' wheels in N, temperature of
/// the wheels above the air in K, weather, and what of the rest takes part.
struct Case {
    name: &'static str,
    locomotives: f64,
    wagons: f64,
    wheel_rise: f64,
    weather: Weather,
    conduction: f64,
    loss_factor: f64,
    wind_share: f64,
}

const FRICTION: Case = Case {
    name: "",
    locomotives: 0.0,
    wagons: 0.0,
    wheel_rise: 0.0,
    weather: NIGHT,
    conduction: 0.0,
    loss_factor: 0.0,
    wind_share: 0.0,
};

const CASES: [Case; 11] = [
    Case { name: "straight, 1 N", locomotives: 10.0, wagons: 1.0, ..FRICTION },
    Case { name: "12 locomotive wheels, 380 N (1 %)", locomotives: 380.0, ..FRICTION },
    Case { name: "12 locomotive wheels, 1140 N (3 %)", locomotives: 1140.0, ..FRICTION },
    Case { name: "R 800 m, 8 N", locomotives: 8.0, wagons: 8.0, ..FRICTION },
    Case { name: "R 800 m, 25 N", locomotives: 25.0, wagons: 25.0, ..FRICTION },
    Case { name: "R 300 m, 90 N", locomotives: 90.0, wagons: 90.0, ..FRICTION },
    Case { name: "wheels 5 K warmer", wheel_rise: 5.0, conduction: 1.0, ..FRICTION },
    Case { name: "wheels 100 K warmer", wheel_rise: 100.0, conduction: 1.0, ..FRICTION },
    Case { name: "hysteresis alone, loss factor 1e-3", loss_factor: 1e-3, ..FRICTION },
    Case {
        name: "R 800 m, 25 N, all effects, night",
        locomotives: 25.0,
        wagons: 25.0,
        conduction: 1.0,
        loss_factor: 2e-4,
        wind_share: 0.2,
        ..FRICTION
    },
    Case {
        name: "R 800 m, 25 N, all effects, day",
        locomotives: 25.0,
        wagons: 25.0,
        conduction: 1.0,
        loss_factor: 2e-4,
        wind_share: 0.2,
        weather: DAY,
        ..FRICTION
    },
];

fn model(case: &Case) -> EnergyModel {
    let outline = RailFile::open("AS60").expect("a section that is built in").outline();
    let base = Parameters::new(outline, Line { begin: 0.0, element_length: 0.1, elements: 50 });
    let parameters = Parameters {
        wheel: WheelHeat {
            initial_rise: case.wheel_rise,
            contact_quality: case.conduction,
            ..base.wheel
        },
        beam: Beam { loss_factor: case.loss_factor, ..base.beam },
        train: TrainWeather { wind_share: case.wind_share, ..base.train },
        depths: vec![0.06],
        ..base
    };
    EnergyModel::new(parameters, &[6; VEHICLES], &case.weather, 0.0)
        .expect("a section of the default cells")
}

/// All wheels at a time; the leading wheel comes to the track's beginning at its start.
fn train(case: &Case, time: f64) -> Vec<Wheel> {
    train::wheels(SPEED * time, |vehicle, wheel| {
        let per_metre = if vehicle < 2 { case.locomotives } else { case.wagons };
        Wheel { friction_power: per_metre * SPEED, ..wheel }
    })
}

fn main() {
    let passage = (20.0 * VEHICLES as f64 / SPEED).ceil() as u32;
    println!(
        "passage {passage} s; heat per metre: friction, chill, bending; foot over untouched rail"
    );
    for case in &CASES {
        let mut model = model(case);
        for second in 0..passage + 1 {
            let start = f64::from(second);
            model.step(&train(case, start + 1.0), &case.weather, start, 1.0);
        }
        let at_tail = model.excess(25, 2);
        let gone = vec![Wheel { position: -1.0, ..Wheel::default() }; 6 * VEHICLES];
        for step in 0..360 {
            let start = f64::from(passage + 1) + 10.0 * f64::from(step);
            model.step(&gone, &case.weather, start, 10.0);
        }
        let heat = model.sources_per_metre(25);
        let answer = model.answer();
        let detected = answer.detected.map_or("never".to_owned(), |f| format!("{:.0} s", f.time));
        let error = model.ledger().error() / model.ledger().sources.moved();
        println!(
            "{:36} {:7.3} {:7.3} {:6.3} kJ/m | tail {:8.3} mK, highest {:8.2} mK at {:5.0} s, 15 mK: {detected}; audit {error:.0e}",
            case.name,
            heat.friction / 1e3,
            heat.chill / 1e3,
            heat.bending / 1e3,
            1e3 * at_tail,
            1e3 * answer.highest.rise,
            answer.highest.time,
        );
    }
}
