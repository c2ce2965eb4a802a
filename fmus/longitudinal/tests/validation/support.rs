//! Trains for the tests, from the shipped rolling stock.

use longitudinal::Command;
use longitudinal::{Couplers, Start, TrainDynamics, TrainState};
use stock::{DraftGear, Library, Vehicle};
use track::Track;
pub use validation::{Bound, Page, Row};

/// Folder of the shipped rolling stock.
const STOCK: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../stock");

/// The page that has the table of all comparisons.
pub const PAGE: Page = Page {
    path: "docs/validation/longitudinal.md",
    text: include_str!("../../../../docs/validation/longitudinal.md"),
};

/// The shipped rolling stock.
pub fn library() -> Library {
    Library::open(STOCK).expect("the repository has a stock folder")
}

/// The paper's locomotive.
pub fn locomotive() -> Vehicle {
    library().vehicle("locomotive-coco-134t").unwrap()
}

/// The paper's wagon.
pub fn wagon() -> Vehicle {
    library().vehicle("wagon-coco-134t-unpowered").unwrap()
}

/// A shipped draft gear.
pub fn gear(name: &str) -> DraftGear {
    library().draft_gear(name).unwrap()
}

/// The friction gear of the paper's train.
pub fn friction_gear() -> DraftGear {
    gear("friction-gear-m901e")
}

/// A vehicle that nothing resists.
pub fn without_resistance(mut vehicle: Vehicle) -> Vehicle {
    vehicle.resistance.factor = 0.0;
    vehicle.resistance.curve_n_m_per_t = 0.0;
    vehicle
}

/// A train with one kind of draft gear.
pub fn train(vehicles: &[Vehicle], gear: &DraftGear, track: Track) -> TrainDynamics {
    TrainDynamics::new(vehicles.iter().map(|vehicle| (vehicle, gear)), track).unwrap()
}

/// Locomotives at the head of wagons.
pub fn block_train(locomotives: usize, wagons: usize) -> Vec<Vehicle> {
    let locomotives = std::iter::repeat_n(locomotive(), locomotives);
    locomotives.chain(std::iter::repeat_n(wagon(), wagons)).collect()
}

/// Track with one gradient throughout.
pub fn gradient(permille: f64) -> Track {
    let text = format!("gradient = [{{ chainage_m = 0.0, permille = {permille:?} }}]");
    Track::from_toml(&text, "gradient").unwrap()
}

/// The state at the beginning of a run at `velocity` with `applied` in force.
pub fn start(
    train: &mut TrainDynamics,
    velocity: f64,
    couplers: Couplers,
    applied: Command,
) -> TrainState {
    train.start(&Start { position: 0.0, velocity, couplers, applied })
}

/// Traction in a notch.
pub fn notch(notch: f64) -> Command {
    Command { notch, ..Command::default() }
}

/// Friction brake.
pub fn train_brake(train_brake: f64) -> Command {
    Command { train_brake, ..Command::default() }
}

/// A draft gear from the text of its file.
pub fn gear_of(text: &str) -> DraftGear {
    let folder = tempfile::tempdir().unwrap();
    let gears = folder.path().join("draft_gears");
    std::fs::create_dir(folder.path().join("vehicles")).unwrap();
    std::fs::create_dir(&gears).unwrap();
    std::fs::write(gears.join("gear.toml"), text).unwrap();
    Library::open(folder.path()).unwrap().draft_gear("gear").unwrap()
}

/// A vehicle that extends the paper's locomotive with the text of a file.
pub fn vehicle_of(text: &str) -> Vehicle {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("vehicle.toml");
    std::fs::write(&file, format!("extends = 'locomotive-coco-134t'\n{text}")).unwrap();
    library().vehicle_from_file(&file).unwrap()
}

/// Wagons that nothing resists, coupled without slack on straight track at 10 m/s, the first faster by
/// `ahead`, m/s.
pub fn wagons_without_slack(
    count: usize,
    gear: &DraftGear,
    ahead: f64,
) -> (TrainDynamics, TrainState) {
    let mut vehicles = vec![without_resistance(wagon()); count];
    vehicles.iter_mut().for_each(|vehicle| vehicle.coupler.slack_mm = 0.0);
    let mut train = train(&vehicles, gear, Track::straight());
    let mut state = start(&mut train, 10.0, Couplers::Unstressed, Command::default());
    state.vehicles[0].velocity += ahead;
    (train, state)
}

/// The argument from 0 to `greatest` at which a rising function has a value.
pub fn inverse(function: impl Fn(f64) -> f64, value: f64, greatest: f64) -> f64 {
    let (mut low, mut high) = (0.0, greatest);
    for _ in 0..80 {
        let middle = (low + high) / 2.0;
        match function(middle) < value {
            true => low = middle,
            false => high = middle,
        }
    }
    low
}
