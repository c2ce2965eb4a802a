//! Exchange with the weather.

use numerics::constants::ZERO_CELSIUS;
use railheat::paper::{Level, Rail, RunningSurface};
use railheat::weather::Weather;

use validation::Row;

use crate::PAGE;
use crate::common::{exchange, grid};

/// `docs/reference/conduction.md`: Table 4 of the paper with air of 15 to 50 °C, and with the unfiltered sun
/// (five and four digits are given).
#[test]
fn analytic_weather_equilibrium() {
    for (air, filtered, unfiltered) in [
        (15.0, 60.938, 98.86),
        (25.0, 69.115, 105.72),
        (40.0, 81.458, 116.13),
        (50.0, 89.743, 123.17),
    ] {
        let weather = Weather { direct: 1366.0, ..Weather::still(air + ZERO_CELSIUS) };
        for (filter, expected, tolerance) in [
            (0.5, filtered, (6e-4, "five digits are given")),
            (1.0, unfiltered, (6e-3, "four or five digits are given")),
        ] {
            let surface = RunningSurface { filter, ..RunningSurface::PAPER };
            Row {
                case: &format!("paper's model in balance, air of {air} °C, filter {filter}"),
                value: surface.equilibrium(&weather) - ZERO_CELSIUS,
                expected,
                unit: "°C",
                source: "closed form, docs/reference/conduction.md",
                tolerance,
            }
            .holds(&PAGE);
        }
    }
}

#[test]
fn property_without_exchange_the_air_gives_the_temperature() {
    let insulated = RunningSurface { convection: 0.0, emissivity: 0.0, ..RunningSurface::PAPER };
    let weather = Weather { direct: 0.0, ..Weather::still(290.0) };
    assert_eq!(insulated.equilibrium(&weather), 290.0);
}

/// From 300 K in the paper's sun at 300 K of air the column tends to the equilibrium, all over
/// its depth. The slowest time constant is near ρ c L / (h + 4 ε σ T³) = 45 000 s, so that ten of
/// them leave e⁻¹⁰ of 43 K, 2 mK.
#[test]
fn property_the_rail_tends_to_the_equilibrium() {
    let (cell_size, interval) = (0.0215, 2.0);
    let grid = grid(cell_size, 1);
    let weather = Weather { direct: 1366.0, ..Weather::still(300.0) };
    let exchange = exchange(&RunningSurface::PAPER, &weather, interval, cell_size);
    let number =
        railheat::paper::fourier_number(&railheat::contact::Material::PAPER, interval, cell_size)
            .unwrap();
    let mut rail = Rail::new(&grid);
    for _ in 0..225_000 {
        rail.step(&grid, &exchange, number, &[], &mut []);
    }
    let wanted = RunningSurface::PAPER.equilibrium(&weather) - 300.0;
    for level in [Level::SURFACE, Level::foot(&grid)] {
        assert!((rail.rise(0, &level) - wanted).abs() < 5e-3);
    }
}
