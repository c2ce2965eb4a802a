//! Conduction over the depth.

use railheat::contact::Material;
use railheat::paper::{Level, Rail, RunningSurface, fourier_number};
use railheat::weather::Weather;

use validation::Row;

use crate::PAGE;
use crate::common::{ADIABATIC, exchange, grid};
use crate::exact::{SLAB as LENGTH, impulse, slab_under_flux};

/// Response to an impulse on a grid: the temperature of the whole slab when mixed is 1 K.
/// The step of time follows the cells, s = 0.4.
fn impulse_on_grid(cells: u32, time: f64) -> [f64; 3] {
    let cell_size = LENGTH / f64::from(cells);
    let grid = grid(cell_size, 1);
    let interval = 0.4 * cell_size * cell_size / Material::PAPER.diffusivity();
    let steps = (time / interval).round() as u32;
    let interval = time / f64::from(steps);
    let number = fourier_number(&Material::PAPER, interval, cell_size).unwrap();
    let calm = Weather { direct: 0.0, ..Weather::still(300.0) };
    let mut rail = Rail::new(&grid);
    rail.heat_surface(0, LENGTH / cell_size);
    for _ in 0..steps {
        rail.step(&grid, &exchange(&ADIABATIC, &calm, interval, cell_size), number, &[], &mut []);
    }
    let middle = Level::at_depth(&grid, 0.06);
    [Level::SURFACE, middle, Level::foot(&grid)].map(|level| rail.rise(0, &level))
}

/// What [`impulse_on_grid`] reads.
const LEVELS: [&str; 3] = ["top", "60 mm", "foot"];

/// V8 at 156 s (the passage of the train) and 600 s. The cells' middles lie half a cell within
/// the slab, and the impulse is spread over a cell: errors of second order, so that each halving
/// of the cells must leave a quarter. 128 cells of 1.3 mm: within 0.05 %
/// at the top, 60 mm and foot.
#[test]
fn analytic_slab_impulse_converges_with_second_order() {
    for time in [156.0, 600.0] {
        let exact = [0.0, 0.06, LENGTH].map(|depth| impulse(depth, time));
        let error = |cells: u32| {
            let found = impulse_on_grid(cells, time);
            [0, 1, 2].map(|i| found[i] / exact[i] - 1.0)
        };
        let (coarse, middle, fine) = (error(32), error(64), error(128));
        for i in 0..3 {
            let orders = [coarse[i] / middle[i], middle[i] / fine[i]].map(f64::log2);
            println!(
                "{time} s, depth {i}: errors {:.2e} {:.2e} {:.2e}, orders {orders:.2?}",
                coarse[i], middle[i], fine[i]
            );
            Row {
                case: &format!("impulse on the paper's column: {} after {time} s", LEVELS[i]),
                value: exact[i] * (1.0 + fine[i]),
                expected: exact[i],
                unit: "of the mixture",
                source: "V8, docs/reference/conduction.md",
                tolerance: (5e-4 * exact[i], "cells of 1.3 mm"),
            }
            .holds(&PAGE);
            assert!(orders.iter().all(|order| (order - 2.0).abs() < 0.2), "{orders:?}");
        }
    }
}

/// V5: constant flux, at the middles of cells of 2 mm. The weather acts before the conduction of
/// the same interval, which leaves the surface cell q Δt/(ρ c Δx) short, 7 mK here; besides that
/// 0.2 % of the rise, and 0.1 mK where almost nothing has arrived yet.
#[test]
fn analytic_slab_constant_flux() {
    let (cell_size, interval) = (0.002, 0.05);
    let grid = grid(cell_size, 1);
    let capacity = Material::PAPER.heat_capacity();
    let number = fourier_number(&Material::PAPER, interval, cell_size).unwrap();
    let sun = RunningSurface { absorptivity: 1.0, filter: 1.0, ..ADIABATIC };
    let weather = Weather { direct: 1000.0, ..Weather::still(300.0) };
    let exchange = exchange(&sun, &weather, interval, cell_size);
    let in_surface_cell = 1000.0 * interval / (capacity * cell_size);
    let cells = [(0, in_surface_cell), (30, 1e-4), (grid.cells - 1, 1e-4)];
    let mut rail = Rail::new(&grid);
    let mut steps = 0;
    for time in [60.0, 156.0, 200.0, 600.0] {
        while f64::from(steps) * interval < time - 1e-9 {
            rail.step(&grid, &exchange, number, &[], &mut []);
            steps += 1;
        }
        for (cell, allowed) in cells {
            let depth = grid.depth(cell);
            let found = rail.rise(0, &Level::at_depth(&grid, depth));
            let exact = slab_under_flux(depth, time);
            Row {
                case: &format!(
                    "paper's column under 1 kW/m²: {:.0} mm deep after {time} s",
                    1e3 * depth
                ),
                value: found,
                expected: exact,
                unit: "K",
                source: "V5, docs/reference/conduction.md",
                tolerance: (2e-3 * exact + allowed, "weather before conduction, cells of 2 mm"),
            }
            .holds(&PAGE);
        }
        let mean = 1000.0 * time / (capacity * LENGTH);
        assert!((rail.sum(0) / grid.cells as f64 / mean - 1.0).abs() < 1e-10);
    }
}

/// Eq. 1 is stable up to s = 1/2: V16, 2 mm allow 0.177 s.
#[test]
fn property_an_unstable_interval_is_refused() {
    assert!(fourier_number(&Material::PAPER, 0.1766, 0.002).is_ok());
    let refused = fourier_number(&Material::PAPER, 0.1767, 0.002).unwrap_err();
    assert!((refused.longest - 0.17662).abs() < 1e-5);
    let sentence = refused.to_string();
    for part in ["conduction.interval = 0.1767", "0.002", "0.5002", "0.176625"] {
        assert!(sentence.contains(part), "{sentence}");
    }
}
