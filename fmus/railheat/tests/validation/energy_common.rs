//! What the tests of `model = "energy"` need.

use railheat::HeatModel;
use railheat::contact::{Contact, Wheel, WheelHeat};
use railheat::energy::{Beam, EnergyModel, Parameters, Resolution, Start, TrainWeather};
use railheat::line::Line;
use railheat::section::{Outline, RailFile};
use railheat::weather::{Exchange, Sun, Weather};

use crate::common::SPEED;

/// Air of 300 K, no wind, no sun.
pub const NIGHT: Weather = Weather::still(300.0);

/// Weather that changes everything at once: sun from the side, wind, warm air.
pub const DAY: Weather = Weather {
    ambient: 295.0,
    wind: 2.0,
    direct: 900.0,
    diffuse: 120.0,
    sky: None,
    sun: Sun { elevation: 0.8, azimuth: 1.0 },
};

/// Exchanges nothing.
pub const INSULATED: Exchange = Exchange {
    convection: 0.0,
    emissivity: 0.0,
    absorptivity: 0.0,
    filter: 0.0,
    cold_sky: false,
    pad: 0.0,
};

/// An upright slab 172 mm high and 40 mm wide: the one-dimensional closed forms.
pub fn slab() -> Outline {
    slab_of(20.0)
}

/// An upright slab 172 mm high with this half width in mm.
pub fn slab_of(half_width: f64) -> Outline {
    let area = 2.0 * half_width * 172.0;
    let text = format!(
        "name = \"slab\"\nsource = \"test\"\nheight_mm = 172\narea_mm2 = {area:?}\n\
         centroid_above_foot_mm = 86\nsecond_moment_mm4 = 1\ncorners_mm = [[0, 172, 0], \
         [{half_width:?}, 172, 0], [{half_width:?}, 0, 0], [0, 0, 0]]"
    );
    RailFile::from_toml(&text, "slab").unwrap().outline()
}

pub fn outline(rail: &str) -> Outline {
    RailFile::open(rail).unwrap().outline()
}

/// An insulated rail of 20 m that gets friction heat only.
pub fn parameters(outline: Outline, resolution: Resolution, cell_size: f64) -> Parameters {
    let line = Line { begin: 0.0, element_length: 0.1, elements: 200 };
    let base = Parameters::new(outline, line);
    Parameters {
        resolution,
        cell_size,
        wheel: WheelHeat { contact_quality: 0.0, ..base.wheel },
        beam: Beam { loss_factor: 0.0, ..base.beam },
        exchange: INSULATED,
        train: TrainWeather { shade: None, ..base.train },
        start: Start::Uniform(NIGHT.ambient),
        depths: vec![0.06],
        ..base
    }
}

/// Rail and air differ in everything: weather, chill, bending, shade, wind of the train.
pub fn all_effects(outline: Outline, resolution: Resolution) -> Parameters {
    let base = parameters(outline, resolution, 0.008);
    Parameters {
        wheel: WheelHeat { contact_quality: 1.0, initial_rise: 20.0, ..base.wheel },
        beam: Beam { loss_factor: 5e-4, ..base.beam },
        exchange: Exchange {
            convection: 6.0,
            emissivity: 0.75,
            absorptivity: 0.75,
            filter: 0.6,
            pad: 20.0,
            ..INSULATED
        },
        train: TrainWeather { wind_share: 0.3, ..TrainWeather::TYPICAL },
        start: Start::Equilibrium,
        ..base
    }
}

/// A wheel on the rail with 1.67 kW of friction power: 100 J/m, of which the rail gets half.
pub fn wheel(position: f64) -> Wheel {
    Wheel {
        position,
        speed: SPEED,
        contact: Contact { normal_force: 109_500.0, a: 0.0063, b: 0.0063 },
        friction_power: 100.0 * SPEED,
        ..Wheel::default()
    }
}

/// The model from the time zero on.
pub fn energy(parameters: Parameters, wheelsets: &[usize], weather: &Weather) -> EnergyModel {
    EnergyModel::new(parameters, wheelsets, weather, 0.0).unwrap()
}

/// Runs one vehicle whose wheels are `at` the end of each step.
pub fn run(
    model: &mut EnergyModel,
    weather: &Weather,
    at: impl Fn(f64) -> Vec<Wheel>,
    from: f64,
    steps: u32,
    length: f64,
) {
    for step in 0..steps {
        let start = from + f64::from(step) * length;
        model.step(&at(start + length), weather, start, length);
    }
}
