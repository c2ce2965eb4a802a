//! What the line does to a vehicle.

use longitudinal::Command;
use longitudinal::resistance::curve::CurveResistance;
use longitudinal::resistance::propulsion::Resistance;
use longitudinal::{Couplers, Wind};
use track::Track;

use crate::support::*;

/// Sources, in N/t: 0.8 lb a short ton and degree (0.0004 m g deg) is 6853/R, with the degree over an
/// arc of 100 ft and g = 9.81; Röckl 650/(R − 55) and 500/(R − 30) N/kN; 6116/R, which is 0.8 lb a long
/// ton and degree.
#[test]
fn benchmark_curve_resistance_by_formula() {
    let without = "without = ['resistance']\n[resistance]\ncurve_formula";
    let cases = [
        (format!("{without} = 'degree'"), 400.0, 6853.0 / 400.0, "0.8 lb a short ton and degree"),
        (
            format!("{without} = 'roeckl'"),
            400.0,
            9.80665 * 650.0 / 345.0,
            "Röckl's formula by hand",
        ),
        (
            format!("{without} = 'roeckl'"),
            250.0,
            9.80665 * 500.0 / 220.0,
            "Röckl's formula by hand",
        ),
        (
            format!("{without} = 'radius'\ncurve_n_m_per_t = 6116.0"),
            400.0,
            6116.0 / 400.0,
            "6116/R by hand",
        ),
        (
            format!(
                "{without} = 'table'\ncurve_table.per_km = [0, 2, 4]\n\
                     curve_table.resistance_n_per_t = [0, 10, 40]"
            ),
            400.0,
            17.5,
            "the table's points by hand",
        ),
    ];
    for (text, radius, expected, source) in cases {
        let curve = CurveResistance::new(&vehicle_of(&text)).unwrap();
        Row {
            case: &format!("curve resistance at {radius} m, {}", text.lines().last().unwrap()),
            value: curve.force(-1.0 / radius) / 134.0,
            expected,
            unit: "N/t",
            source,
            tolerance: (5e-4 * expected, "rounding of 6853 and of g there"),
        }
        .holds(&PAGE);
        assert_eq!(curve.force(0.0), 0.0);
    }
}

#[test]
fn analytic_starting_resistance_fades_out() {
    let text = "[resistance]\nstarting_n_per_t = 50.0\nstarting_until_kmh = 3.6";
    let (with, without) =
        (Resistance::new(&vehicle_of(text)).unwrap(), Resistance::new(&vehicle_of("")).unwrap());
    for (speed, expected) in [(0.0, 6700.0), (0.25, 5025.0), (1.0, 0.0), (9.0, 0.0)] {
        assert!((with.force(speed) - without.force(speed) - expected).abs() < 1e-9);
    }
}

/// A wagon that stands is held by its starting resistance: 5.5 permille ask for 54 N/t, 56 hold.
#[test]
fn analytic_starting_resistance_holds_on_a_gradient() {
    let text = "without = ['traction']\n[resistance]\nstarting_n_per_t = 50.0";
    for (permille, stands) in [(5.5, true), (6.5, false)] {
        let mut train = train(&[vehicle_of(text)], &friction_gear(), gradient(permille));
        let mut state = start(&mut train, 0.0, Couplers::Unstressed, Command::default());
        train.advance(&mut state, &Command::default(), 5.0);
        assert_eq!(state.vehicles[0].velocity == 0.0, stands);
    }
}

/// The air's part at the speed against the air: by hand 0.12187 N/(km/h)² · 3.6² for 10 m/s against
/// 5 m/s of head wind is 1.5794 (15² − 10²).
#[test]
fn analytic_wind_counts_against_the_heading() {
    let curve = "alignment = [{ length_m = 314.159265358979, radius_m = 100 }]";
    let track = Track::from_toml(curve, "curve").unwrap();
    let mut train = train(&[wagon()], &friction_gear(), track);
    train.wind = Wind { speed: 5.0, direction: 0.0 };
    for (position, expected) in [(0.0, -197.42), (314.1592, 118.45)] {
        let state = train.start(&longitudinal::Start {
            position,
            velocity: 10.0,
            couplers: Couplers::Unstressed,
            applied: Command::default(),
        });
        let wind = state.vehicles[0].forces.wind;
        // Half a turn later the same wind pushes: 1.5794 (10² − 5²).
        assert!((wind - expected).abs() < 0.02, "{wind}");
    }
}

/// A vehicle that reaches over a step of the gradient has the mean over its length.
#[test]
fn analytic_gradient_over_the_length_of_a_vehicle() {
    let text = "gradient = [{ chainage_m = -500, permille = 0 }, { chainage_m = 0, permille = 0 },
                            { chainage_m = 0, permille = 10 }]";
    let track = Track::from_toml(text, "step").unwrap();
    let vehicle = vehicle_of("along_its_length = true");
    let mut train = train(&[vehicle], &friction_gear(), track);
    for (position, share) in [(-15.0, 0.0), (-5.0, 0.25), (0.0, 0.5), (20.0, 1.0)] {
        let state = train.start(&longitudinal::Start {
            position,
            velocity: 10.0,
            couplers: Couplers::Unstressed,
            applied: Command::default(),
        });
        let expected = -134e3 * 9.80665 * 10e-3 * share;
        assert!((state.vehicles[0].forces.gravity - expected).abs() < 1e-6);
    }
}

/// The potential energy of vehicles with a length belongs to their force: the audit closes.
#[test]
fn analytic_energy_balance_over_a_crest_with_long_vehicles() {
    let text = "gradient_interpolation = 'cubic'
        gradient = [{ chainage_m = 0, permille = 10 }, { chainage_m = 200, permille = -10 },
                    { chainage_m = 500, permille = 5 }]";
    let vehicles = vec![vehicle_of("along_its_length = true"); 5];
    let mut train = train(&vehicles, &friction_gear(), Track::from_toml(text, "crest").unwrap());
    let mut state = start(&mut train, 12.0, Couplers::InBalance, notch(4.0));
    train.advance(&mut state, &notch(4.0), 50.0);
    Row {
        case: "energy residual of long vehicles over a crest",
        value: train.energy_residual(&state, &train.energy(&state)) / state.work.traction,
        expected: 0.0,
        unit: "of the work of traction",
        source: "conservation of energy",
        tolerance: (1e-4, "integration errors only"),
    }
    .holds(&PAGE);
}

/// Static sag: the force changes from coupler to coupler by the weight of the vehicle between them
/// along the gradient under it. The train hangs on its first vehicle, which is braked.
#[test]
fn analytic_static_forces_in_a_sag() {
    let text =
        "gradient = [{ chainage_m = -400, permille = -20 }, { chainage_m = 0, permille = 20 }]";
    let gear = gear_of(
        "name = 'damped'\nsource = 'test'\ndamping_kn_s_m = 3000\nstructure_stiffness_mn_m = 20\n\
         [loading]\ndeflection_mm = [0, 50]\nforce_kn = [0, 1000]\n",
    );
    let mut vehicles = vec![without_resistance(wagon()); 16];
    vehicles.iter_mut().for_each(|vehicle| vehicle.coupler.slack_mm = 0.0);
    vehicles[0] = vehicle_of("coupler.slack_mm = 0.0\nbrake.net_braking_ratio = 0.9");
    for vehicle in &mut vehicles[1..] {
        vehicle.brake.net_braking_ratio = 0.0;
    }
    let mut train = train(&vehicles, &gear, Track::from_toml(text, "sag").unwrap());
    let mut state = start(&mut train, 0.0, Couplers::Unstressed, train_brake(1.0));
    train.advance(&mut state, &train_brake(1.0), 300.0);
    for i in [1, 8, 14] {
        let vehicle = &state.vehicles[i];
        let gradient = 20e-3 + vehicle.position * 1e-4;
        Row {
            case: &format!("change of the coupler force over vehicle {} in a sag", i + 1),
            value: state.connections[i - 1].force - state.connections[i].force,
            expected: 134e3 * 9.80665 * gradient,
            unit: "N",
            source: "closed form",
            tolerance: (0.1, "what is left of the swinging after 300 s, of forces of 1e4 N"),
        }
        .holds(&PAGE);
    }
}
