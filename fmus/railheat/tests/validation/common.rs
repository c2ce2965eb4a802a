//! What several tests need.

use railheat::HeatModel;
use railheat::contact::{Contact, Friction, Material, Wheel};
use railheat::line::Line;
use railheat::paper::{Grid, PaperModel, Parameters, RunningSurface, SurfaceStep};
use railheat::weather::Weather;

/// A surface that exchanges nothing.
pub const ADIABATIC: RunningSurface =
    RunningSurface { convection: 0.0, emissivity: 0.0, absorptivity: 0.0, filter: 0.0 };

/// Air of 25 °C in the paper's sun.
pub const SUNNY: Weather = Weather { direct: 1366.0, ..Weather::still(298.15) };

/// 60 km/h.
pub const SPEED: f64 = 16.67;

/// 22.3 t axle load on a round contact of 6.3 mm, as in the examples of `docs/reference/conduction.md`.
pub const CONTACT: Contact = Contact { normal_force: 109_500.0, a: 0.0063, b: 0.0063 };

/// A rail of 172 mm, cut into cells of this size, with elements of 0.1 m.
pub fn grid(cell_size: f64, elements: usize) -> Grid {
    Grid {
        line: Line { begin: 0.0, element_length: 0.1, elements },
        cell_size,
        cells: (0.172 / cell_size).round() as usize,
    }
}

/// The paper's constants on 100 m of an AS 60 rail, starting in equilibrium with the weather.
pub fn parameters() -> Parameters {
    let grid = Grid {
        line: Line { begin: 0.0, element_length: 0.1, elements: 1000 },
        cell_size: 0.005,
        cells: 34,
    };
    Parameters {
        grid,
        depths: vec![0.06],
        width: 0.075,
        conduction_interval: 0.05,
        material: Material::PAPER,
        friction: Friction::PAPER,
        surface: RunningSurface::PAPER,
        initial_temperature: RunningSurface::PAPER.equilibrium(&SUNNY),
    }
}

/// A wheel with enough creepage for a flash rise of about 20 K.
pub fn wheel(position: f64) -> Wheel {
    Wheel { position, speed: SPEED, creepage: 0.003, contact: CONTACT, ..Wheel::default() }
}

/// Runs wheels that stand at `at(0)` to `at(steps)` with a step of `length` in s.
pub fn run(model: &mut PaperModel, at: impl Fn(f64) -> Vec<Wheel>, steps: u32, length: f64) {
    for step in 0..steps {
        let start = f64::from(step) * length;
        let wheels = at(start + length);
        model.step(&wheels, &SUNNY, start, length);
    }
}

/// What a weather does to cells of a size in one interval, with a rail that starts at 300 K.
pub fn exchange<'w>(
    surface: &'w RunningSurface,
    weather: &'w Weather,
    interval: f64,
    cell_size: f64,
) -> SurfaceStep<'w> {
    SurfaceStep {
        surface,
        weather,
        initial: 300.0,
        rise_per_flux: interval / (Material::PAPER.heat_capacity() * cell_size),
    }
}
