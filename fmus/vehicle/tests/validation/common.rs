//! Vehicles and tracks of the tests.

use std::path::Path;
use std::sync::Arc;

use track::TrackFile;
pub use validation::{Page, Row};
use vehicle::dynamics::Dynamics;
use vehicle::dynamics::inputs::Inputs;
use vehicle::structure::{Structure, WheelsetData};
use vehicle::track::Line;

/// Friction coefficient of the locomotive's file.
pub const FRICTION: f64 = 0.36;

/// Every vehicle with a multibody section of its own.
pub const VEHICLES: [&str; 4] =
    ["locomotive-coco-134t", "manchester-vehicle-1", "wagon-ore-40t", "wagon-ore-40t-empty"];

/// A level curve without end.
pub const CURVE_800: &str = "alignment = [{ length_m = 1e6, radius_m = 800.0 }]";

/// A level curve for high speed.
pub const CURVE_3000: &str = "alignment = [{ length_m = 1e6, radius_m = 3000.0 }]";

/// Straight track with a curve from chainage 1010 m.
pub const TRANSITION: &str = "
    start_m = 1010.0
    alignment = [
        { length_m = 50.0, transition = true },
        { length_m = 600.0, radius_m = 800.0, cant_mm = 40.0 },
        { length_m = 50.0, transition = true },
    ]";

/// Elastic support of the rails.
pub const SUPPORT: &str = "[support]
    lateral_stiffness_n_m = 25e6
    lateral_damping_n_s_m = 50e3
    vertical_stiffness_n_m = 60e6
    vertical_damping_n_s_m = 100e3";

/// The locomotive, whose linear behaviour docs/reference/locomotive.md has.
pub fn locomotive() -> Arc<Structure> {
    from_stock("locomotive-coco-134t")
}

/// A vehicle of the stock library.
pub fn from_stock(name: &str) -> Arc<Structure> {
    let stock = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../stock");
    let library = stock::Library::open(stock).unwrap();
    Arc::new(Structure::new(&library.vehicle(name).unwrap()).unwrap())
}

/// Two wheelsets of cones 1:20 far apart under a load that rests on them so softly sideways and
/// against yaw that each of them is free.
pub fn free_wheelsets() -> Arc<Structure> {
    let stock = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../stock");
    let library = stock::Library::open(stock).unwrap();
    let mut vehicle = library.vehicle("locomotive-coco-134t").unwrap();
    vehicle.multibody = Some(toml::from_str(FREE_WHEELSETS).unwrap());
    Arc::new(Structure::new(&vehicle).unwrap())
}

const FREE_WHEELSETS: &str = r#"
    source = "free wheelsets for Klingel's test"
    coupler.height_m = 0.46
    body = [{ name = "load", mass_kg = 20000.0, inertia_kg_m2 = [1e4, 1e5, 1e5],
              x_m = 0.0, height_m = 0.46 }]
    [[wheelset]]
    name = "front"
    mass_kg = 1000.0
    inertia_kg_m2 = [600.0, 80.0, 600.0]
    x_m = 5.0
    wheel_radius_m = 0.46
    frame = "load"
    [[wheelset]]
    name = "rear"
    mass_kg = 1000.0
    inertia_kg_m2 = [600.0, 80.0, 600.0]
    x_m = -5.0
    wheel_radius_m = 0.46
    frame = "load"
    [[spring]]
    name = "load front"
    between = ["load", "front"]
    points_m = [[5.0, -1.0, 0.46], [5.0, 1.0, 0.46]]
    stiffness_n_m = [0.0, 10e3, 1e6]
    damping_n_s_m = [0.0, 1e3, 1e4]
    [[spring]]
    name = "load rear"
    between = ["load", "rear"]
    points_m = [[-5.0, -1.0, 0.46], [-5.0, 1.0, 0.46]]
    stiffness_n_m = [0.0, 10e3, 1e6]
    damping_n_s_m = [0.0, 1e3, 1e4]
    [[spring]]
    name = "guide front"
    between = ["load", "front"]
    points_m = [[5.0, 0.0, 0.46]]
    stiffness_n_m = [1e6, 0.0, 0.0]
    damping_n_s_m = [1e4, 0.0, 0.0]
    [[spring]]
    name = "guide rear"
    between = ["load", "rear"]
    points_m = [[-5.0, 0.0, 0.46]]
    stiffness_n_m = [1e6, 0.0, 0.0]
    damping_n_s_m = [1e4, 0.0, 0.0]
    [contact]
    wheel = "cone-1-20"
    rail = "round-300"
    rail_inclination = 0.0
    gauge_mm = 1435.0
    flange_back_distance_mm = 1360.0
    damping_s_m = 0.9
    [contact.creep]
    source = "Kalker, constant friction"
    law = "polach"
    adhesion_factor = 1.0
    slip_factor = 1.0
    friction = 0.36
    limit_ratio = 1.0
    decay_s_m = 0.0
"#;

/// A vehicle that starts at chainage 1000 m.
pub fn started(structure: Arc<Structure>, track: &str, speed: f64, inputs: &Inputs) -> Dynamics {
    let line = Line::new(&TrackFile::new(track, "test").unwrap()).unwrap();
    let mut vehicle = Dynamics::new(structure, Arc::new(line));
    let equilibrium = vehicle.start(1000.0, speed, inputs);
    assert!(equilibrium.reached, "{speed} m/s: {equilibrium:?}");
    vehicle
}

/// Runs on in steps of at most 1 ms.
pub fn run(vehicle: &mut Dynamics, time: f64, inputs: &Inputs) {
    let step = 1e-3 / (1e-3 / vehicle.longest_step()).ceil();
    for _ in 0..(time / step).round() as usize {
        vehicle.step(step, inputs);
    }
}

/// Vertical forces of left and right wheel of each wheelset, N.
pub fn vertical_loads(vehicle: &Dynamics) -> Vec<[f64; 2]> {
    let loads = vehicle.wheels.iter();
    loads.map(|wheels| wheels.each_ref().map(|wheel| wheel.vertical)).collect()
}

/// Conicity of the wheels of `free_wheelsets`.
pub const CONICITY: f64 = 1.0 / 20.0;

/// Rolling radius r0 and half distance of the contacts e0 of a centred wheelset.
pub fn rolling(data: &WheelsetData) -> (f64, f64) {
    let point = data.tables[0].at(0.0);
    let radius = data.wheel.radius + point.radius_change;
    (radius, data.wheel.half_distance + point.wheel_lateral)
}

/// Distance of the rail's top from the track's middle, m.
pub fn half_rail_distance(data: &WheelsetData) -> f64 {
    data.tables[0].pair().rail_top()
}

/// The page that has the table of all comparisons with numbers.
pub const PAGE: Page = Page {
    path: "docs/validation/vehicle.md",
    text: include_str!("../../../../docs/validation/vehicle.md"),
};

/// Source of what was computed for the locomotive besides this model.
pub const LINEAR_PROGRAM: &str =
    "separate linear program, [locomotive](../reference/locomotive.md)";

/// Within a relative tolerance.
#[track_caller]
pub fn assert_close(found: f64, expected: f64, tolerance: f64) {
    let error = (found - expected).abs();
    assert!(error <= tolerance * expected.abs(), "{found}, expected {expected} within {tolerance}");
}
