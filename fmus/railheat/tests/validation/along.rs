//! Conduction along the track.

use railheat::HeatModel;
use railheat::contact::Wheel;
use railheat::energy::{EnergyModel, Parameters, Resolution};
use railheat::line::Line;
use railheat::weather::Exchange;

use validation::Row;

use crate::PAGE;
use crate::energy_common::{INSULATED, NIGHT, outline, parameters, run, wheel};

/// 4 m of rail in elements of 20 mm that conducts along the track.
fn model(exchange: Exchange, interval: f64) -> EnergyModel {
    let base = parameters(outline("60E1"), Resolution::Plane, 0.012);
    let line = Line { begin: 0.0, element_length: 0.02, elements: 200 };
    let parameters = Parameters { line, exchange, interval, conducts_along: true, ..base };
    EnergyModel::new(parameters, &[1], &NIGHT, 0.0).unwrap()
}

/// A wheel that spins without moving.
fn spinning(power: f64) -> Vec<Wheel> {
    vec![Wheel { speed: 0.0, friction_power: power, ..wheel(2.01) }]
}

/// Mean square distance of the heat from where it came in, m², and its sum, J.
fn spread(model: &EnergyModel) -> (f64, f64) {
    let mut heat = 0.0;
    let mut moment = 0.0;
    for element in 0..200 {
        let here = 0.02 * model.heat_per_metre(element);
        heat += here;
        moment += here * (0.02 * element as f64 + 0.01 - 2.01).powi(2);
    }
    (moment / heat, heat)
}

/// A wheel burn of 5 kJ: whatever the section does meanwhile, the heat's mean square distance grows by 2 α t,
/// which differences of second order give exactly, and none is lost. With steps of 1 s the heat comes in evenly
/// over the first, half a second late; with steps of a minute the method must be as exact: 1e-6 of both (what lies
/// beyond the reach of a step).
#[test]
fn analytic_along_the_spread_of_a_burn() {
    let alpha = 40.0 / (7850.0 * 450.0);
    for (steps, length) in [(600, 1.0), (10, 60.0)] {
        let mut model = model(INSULATED, 1.0);
        run(&mut model, &NIGHT, |_| spinning(10e3), 0.0, 1, 1.0);
        let (begin, _) = spread(&model);
        run(&mut model, &NIGHT, |_| vec![Wheel::default()], 1.0, steps, length);
        let (end, heat) = spread(&model);
        let grown = (end - begin) / (2.0 * alpha * 600.0);
        println!("heat {heat:.9} J");
        Row {
            case: &format!("spread of a wheel burn along the track, steps of {length} s"),
            value: grown,
            expected: 1.0,
            unit: "of 2αt",
            source: "closed form",
            tolerance: (1e-5, "what lies beyond the reach of a step"),
        }
        .holds(&PAGE);
        assert!((heat / 5000.0 - 1.0).abs() < 1e-9);
        let ledger = model.ledger();
        assert!(ledger.error().abs() < 1e-9 * ledger.sources.moved());
    }
}

/// The method is of second order in its step: each half leaves a quarter of the error at the burn, in a
/// rail that cools meanwhile.
#[test]
fn property_along_second_order_in_the_step() {
    let exchange = Exchange { convection: 15.0, ..INSULATED };
    let at_burn = |interval: f64| {
        let mut model = model(exchange, interval);
        run(&mut model, &NIGHT, |_| spinning(10e3), 0.0, 1, 64.0);
        run(&mut model, &NIGHT, |_| spinning(0.0), 64.0, 1, 128.0);
        model.excess(100, 2)
    };
    let exact = at_burn(0.25);
    let errors = [16.0, 8.0, 4.0].map(|interval| at_burn(interval) / exact - 1.0);
    let orders = [0, 1].map(|i| (errors[i] / errors[i + 1]).log2());
    println!("errors {errors:?}, orders {orders:.2?}");
    assert!(orders.iter().all(|order| (order - 2.0).abs() < 0.2), "{orders:?}");
}

/// V17: beside rail that is kept warm the excess falls as exp(-x/l) with l = √(k A/(h P)), 0.174 m at
/// h = 15 all round with the area and perimeter of `docs/reference/section.md` (1 % of area to ours). In the section's slowest mode it is
/// √(α/λ) exactly, but for elements of 20 mm: (0.02/l)²/24 = 0.05 %; 0.9 to 1.1 m aside the next mode, e^-4 of the
/// slowest there, holds next to no heat.
#[test]
fn analytic_along_the_length_of_a_fin() {
    let exchange = Exchange { convection: 15.0, pad: 15.0, ..INSULATED };
    let mut model = model(exchange, 60.0);
    run(&mut model, &NIGHT, |_| spinning(100.0), 0.0, 600, 60.0);
    let length = 0.2 / (model.heat_per_metre(145) / model.heat_per_metre(155)).ln();
    let of_mode = (40.0 / (7850.0 * 450.0) / model.modes().rates[0]).sqrt();
    let section = outline("60E1").properties();
    let lumped = (40.0 * section.area / (15.0 * section.perimeter)).sqrt();
    let of_reference = (40.0 * 7.67e-3 / (15.0 * 0.676_f64)).sqrt();
    let published = "V17, docs/reference/conduction.md";
    for (case, value, expected, source, tolerance) in [
        ("fin length of 60E1, lumped", lumped, of_reference, published, (0.015, "1 % of area")),
        (
            "fin length beside warm rail",
            length,
            lumped,
            "fin in closed form",
            (0.015, "Biot number"),
        ),
        ("the same in the slowest mode", length, of_mode, "√(α/λ)", (1e-3, "elements of 20 mm")),
    ] {
        let tolerance = (tolerance.0 * expected, tolerance.1);
        Row { case, value, expected, unit: "m", source, tolerance }.holds(&PAGE);
    }
}

/// Where heat does not come, no element is touched: the run ends where the excess is nothing.
#[test]
fn property_along_far_rail_costs_nothing() {
    let mut model = model(INSULATED, 1.0);
    run(&mut model, &NIGHT, |_| spinning(10e3), 0.0, 1, 1.0);
    run(&mut model, &NIGHT, |_| vec![Wheel::default()], 1.0, 60, 1.0);
    assert!(model.touched() > 10 && model.touched() < 60, "{} touched", model.touched());
    assert_eq!(model.excess(0, 2), 0.0);
}
