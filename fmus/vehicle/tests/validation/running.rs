//! Wheelsets and the locomotive in steady running: balances of force, moment and energy, Klingel,
//! free curving.

use crate::common::*;
use numerics::constants::STANDARD_GRAVITY;
use vehicle::dynamics::Dynamics;
use vehicle::dynamics::inputs::Inputs;

/// Twelve longitudinal creep forces carry the traction: on straight track they differ from it by
/// the vehicle's own acceleration force only, so 1 % is ample.
#[test]
fn analytic_creep_forces_carry_the_traction() {
    let inputs = Inputs { traction: 200e3, rear_coupler: 200e3, ..Inputs::none(FRICTION) };
    let mut vehicle = started(locomotive(), "", 16.67, &inputs);
    run(&mut vehicle, 5.0, &inputs);
    let sum: f64 =
        vehicle.wheels.iter().flatten().map(|wheel| wheel.total.force.longitudinal).sum();
    Row {
        case: "locomotive, 12 creep forces at 200 kN of traction",
        value: sum / 1e3,
        expected: 200.0,
        unit: "kN",
        source: "Newton's second law",
        tolerance: (2.0, "the vehicle's own acceleration"),
    }
    .holds(&PAGE);
}

/// In a level curve of 800 m the rails give all bodies their centripetal force m v²/R, here to
/// first order in the small yaw angles; 0.1 %.
#[test]
fn analytic_guiding_forces_balance_the_centrifugal_force() {
    let inputs = Inputs::none(FRICTION);
    let mut vehicle = started(locomotive(), CURVE_800, 16.67, &inputs);
    run(&mut vehicle, 1.0, &inputs);
    let lateral: f64 = vehicle
        .wheels
        .iter()
        .zip(&vehicle.structure.wheelsets)
        .flat_map(|(wheels, data)| {
            let yaw = vehicle.state.bodies[data.body].rotation.z;
            wheels.iter().map(move |wheel| wheel.guiding + yaw * wheel.total.force.longitudinal)
        })
        .sum();
    Row {
        case: "locomotive, R 800 m, lateral forces over m v²/R",
        value: lateral / (134e3 * vehicle.velocity().powi(2) / 800.0),
        expected: 1.0,
        unit: "1",
        source: "Newton's second law",
        tolerance: (1e-3, "first order in the yaw angles"),
    }
    .holds(&PAGE);
}

/// Moments about the track's tangent at the vehicle's middle in the same curve: the wheels hold
/// m v²/R at the height of each body, the weight of all displaced bodies, where a body that lies `x`
/// from the middle is x²/2R to the inside, and the gyroscopic moment I w v/R of the wheelsets.
/// 0.1 % of the moment that all wheels could hold.
#[test]
fn analytic_wheel_loads_balance_the_overturning_moment() {
    let inputs = Inputs::none(FRICTION);
    let mut vehicle = started(locomotive(), CURVE_800, 16.67, &inputs);
    run(&mut vehicle, 1.0, &inputs);
    let acceleration = vehicle.velocity().powi(2) / 800.0;
    let structure = &vehicle.structure;
    let inside = |body: usize| structure.bodies[body].along.powi(2) / 1600.0;
    let mut overturning = 0.0;
    for (i, (body, state)) in structure.bodies.iter().zip(&vehicle.state.bodies).enumerate() {
        let height = body.height - state.position.z;
        let aside = state.position.y + inside(i);
        overturning += body.mass * (acceleration * height - STANDARD_GRAVITY * aside);
        overturning -= body.inertia.y * state.angular_velocity.y * vehicle.velocity() / 800.0;
    }
    let (mut held, mut possible) = (0.0, 0.0);
    for (wheels, data) in vehicle.wheels.iter().zip(&structure.wheelsets) {
        for (wheel, sign) in wheels.iter().zip([-1.0, 1.0]) {
            let head = sign * (half_rail_distance(data) + wheel.total.ellipse.lateral_position);
            held -= wheel.vertical * (head + inside(data.body));
            possible += wheel.vertical * data.wheel.half_distance;
        }
    }
    assert!((held - overturning).abs() < 1e-3 * possible, "{held} Nm, {overturning} Nm");
}

/// Klingel's wavelength 2 pi sqrt(r0 e0/lambda) of free wheelsets with cones 1:20: 16.505 m for
/// r0 = 0.46 m, e0 = 0.75 m and lambda = 1/20, here 16.376 m with r0 and e0 where the wheels touch
/// the round rails. Creep is not quite nil and the load pulls a little; 0.5 %.
#[test]
fn analytic_klingel_wavelength() {
    let inputs = Inputs::none(FRICTION);
    let mut vehicle = started(free_wheelsets(), "", 1.0, &inputs);
    for data in vehicle.structure.clone().wheelsets.iter() {
        vehicle.state.bodies[data.body].position.y = 1e-3;
    }
    let front = vehicle.structure.wheelsets[0].body;
    let mut crossings = vec![];
    let mut before = 1e-3;
    while crossings.len() < 5 && vehicle.position() < 1100.0 {
        vehicle.step(1e-3, &inputs);
        let now = vehicle.state.bodies[front].position.y;
        if before * now < 0.0 {
            crossings.push(vehicle.position());
        }
        before = now;
    }
    assert_eq!(crossings.len(), 5, "the wheelset does not oscillate");
    let (radius, half) = rolling(&vehicle.structure.wheelsets[0]);
    let expected = std::f64::consts::TAU * (radius * half / CONICITY).sqrt();
    Row {
        case: "free wheelsets, cones 1:20, wavelength over 2π√(r₀e₀/λ)",
        value: (crossings[4] - crossings[0]) / 2.0 / expected,
        expected: 1.0,
        unit: "1",
        source: "Klingel 1883",
        tolerance: (5e-3, "creep and a load that pulls a little"),
    }
    .holds(&PAGE);
}

/// Free wheelsets of cones run in a curve of R = 3000 m with their wheels at r0 e0/(lambda R) to the
/// outside, 2.26 mm. The middle of the axle lies closer by r0 times the roll, lambda/e0 of that. The
/// load hangs a little to the outside and presses the outer wheels deeper; 1 %.
#[test]
fn analytic_free_curving_offset() {
    let curve = "alignment = [{ length_m = 1e5, radius_m = 3000.0 }]";
    let vehicle = started(free_wheelsets(), curve, 1.0, &Inputs::none(FRICTION));
    let (radius, half) = rolling(&vehicle.structure.wheelsets[0]);
    let front = vehicle.structure.wheelsets[0].body;
    let offset = vehicle.state.bodies[front].position.y;
    let at_the_wheels = radius * half / (CONICITY * 3000.0);
    Row {
        case: "free wheelsets, R 3000 m, offset over r₀e₀/(λR) less the roll",
        value: -offset / (at_the_wheels * (1.0 - radius * CONICITY / half)),
        expected: 1.0,
        unit: "1",
        source: "rolling without slip",
        tolerance: (1e-2, "the load presses the outer wheels deeper"),
    }
    .holds(&PAGE);
}

/// All energy is accounted for: traction, coupler, resistance, gradient, curve and brake over 30 s.
/// 0.01 % of the energy that was turned over; the error stems from what the frames neglect.
#[test]
fn property_energy_balance() {
    let track = "
        alignment = [
            { length_m = 1100.0 },
            { length_m = 50.0, transition = true },
            { length_m = 200.0, radius_m = 800.0, cant_mm = 60.0 },
            { length_m = 50.0, transition = true },
        ]
        gradient = [
            { chainage_m = 1000.0, permille = 0.0 },
            { chainage_m = 1100.0, permille = 10.0 },
        ]";
    let driving = Inputs {
        traction: 300e3,
        rear_coupler: 150e3,
        resistance: -3e3,
        synchronisation: 1e3,
        ..Inputs::none(FRICTION)
    };
    let braking = Inputs { brake: 60e3, ..Inputs::none(FRICTION) };
    let mut vehicle = started(locomotive(), track, 15.0, &driving);
    let before = vehicle.stored_energy().sum();
    run(&mut vehicle, 20.0, &driving);
    run(&mut vehicle, 10.0, &braking);
    let account = vehicle.state.account;
    let gained = vehicle.stored_energy().sum() - before;
    let error = gained - account.work() + account.heat();
    let turned_over = account.traction.abs() + account.couplers.abs() + account.heat();
    assert!(error.abs() < 1e-4 * turned_over, "{error} J of {turned_over} J: {account:?}");
}

/// What the track's factor and the input make of friction is their product: halved rails under friction
/// 0.4 are rails of 0.2, bit by bit. Where the factor steps, each wheelset has that of its own chainage.
#[test]
fn property_friction_of_the_track_is_a_factor_of_the_input() {
    let half = "friction = [{ chainage_m = 0.0, factor = 0.5 }]";
    let pulling = |friction| Inputs { traction: 100e3, ..Inputs::none(friction) };
    let mut product = started(locomotive(), half, 10.0, &pulling(0.4));
    let mut plain = started(locomotive(), "", 10.0, &pulling(0.2));
    run(&mut product, 1.0, &pulling(0.4));
    run(&mut plain, 1.0, &pulling(0.2));
    assert_eq!(product.state, plain.state);

    let step = "friction = [{ chainage_m = 0.0, factor = 0.5 },
                            { chainage_m = 1000.0, factor = 0.5 },
                            { chainage_m = 1000.0, factor = 1.0 }]";
    let vehicle = started(locomotive(), step, 10.0, &pulling(0.36));
    let creepage = |i: usize| vehicle.wheels[i][0].total.creepages.longitudinal;
    // The leading bogie stands beyond 1000 m, on rails with twice the friction of the other's.
    for leading in 0..3 {
        assert!(creepage(leading) < 0.95 * creepage(5 - leading), "{leading}");
    }
}

/// A wheelset that is driven harder than friction holds it spins, and the more friction falls with slip
/// the less it pulls: from a creepage of 1 % on the force must fall while the creepage grows. With sand,
/// friction raised during the run, it comes back to rolling.
#[test]
fn property_sand_brings_a_spinning_locomotive_back() {
    let pulling = |friction| Inputs { traction: 240e3, ..Inputs::none(friction) };
    let mut vehicle = started(locomotive(), "", 10.0, &pulling(0.36));
    let creepage = |vehicle: &Dynamics| vehicle.wheels[0][0].total.creepages.longitudinal;
    let force = |vehicle: &Dynamics| vehicle.wheels[0][0].total.force.longitudinal;
    let wet = pulling(0.15);
    run(&mut vehicle, 0.2, &wet);
    let (spinning, pull) = (creepage(&vehicle), force(&vehicle));
    assert!(spinning > 0.01, "{spinning}");
    run(&mut vehicle, 0.1, &wet);
    assert!(creepage(&vehicle) > spinning && force(&vehicle) < pull);
    run(&mut vehicle, 3.0, &pulling(0.5));
    assert!(creepage(&vehicle) < 0.005, "{}", creepage(&vehicle));
    // 20 kN a wheel, less what turns the wheelsets faster: 134 t of 134 t + 16.3 t of rotating mass.
    assert_close(force(&vehicle), 20e3 * 134.0 / 150.3, 1e-2);
}

/// Name, radius, speed, friction, traction, time: a case of `property_energy_in_tight_curves`.
type TightCurve = (&'static str, f64, f64, f64, f64, f64);

const TIGHT_CURVES: [TightCurve; 6] = [
    ("locomotive-coco-134t", 150.0, 0.0, 0.36, 100e3, 5.0),
    ("locomotive-coco-134t", 150.0, 0.0, 0.5, 100e3, 5.0),
    ("locomotive-coco-134t", 150.0, 10.0, 0.36, 0.0, 2.0),
    ("manchester-vehicle-1", 150.0, 10.0, 0.3, 0.0, 2.0),
    ("manchester-vehicle-1", 150.0, 10.0, 0.5, 0.0, 2.0),
    ("wagon-ore-40t-empty", 200.0, 10.0, 0.36, 0.0, 2.0),
];

/// Wheels that lie on their flange root with much friction neither bounce nor gain energy: contact forces
/// and damper speeds are exact derivatives, so the account closes to 1e-4 of what is turned over. That is
/// five times the largest error found. No wheel ever leaves its rail or carries three times its load at rest.
#[test]
fn property_energy_in_tight_curves() {
    for (name, radius, speed, friction, traction, time) in TIGHT_CURVES {
        let inputs = Inputs { traction, ..Inputs::none(friction) };
        let curve = format!("alignment = [{{ length_m = 1e6, radius_m = {radius} }}]");
        let mut vehicle = started(from_stock(name), &curve, speed, &inputs);
        let before = vehicle.stored_energy().sum();
        let case = format!("{name}, R {radius} m, {speed} m/s, friction {friction}");
        for _ in 0..(time * 1e3) as usize {
            run(&mut vehicle, 1e-3, &inputs);
            for (wheels, data) in vehicle.wheels.iter().zip(&vehicle.structure.wheelsets) {
                for wheel in wheels {
                    let load = wheel.vertical / data.static_wheel_load;
                    assert!(load > 0.0 && load < 3.0, "{case}: {load} of the load at rest");
                }
            }
        }
        let account = vehicle.state.account;
        let error = vehicle.stored_energy().sum() - before - account.work() + account.heat();
        let turned_over = account.work() + account.heat();
        assert!(error.abs() < 1e-4 * turned_over, "{case}: {error} J of {turned_over} J");
    }
}
