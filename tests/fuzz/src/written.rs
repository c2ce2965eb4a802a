//! The files that people write: scenario, track, driver, stock, profiles, rails, weather.

use contact::{ProfilePair, RailProfile, WheelProfile};
use longitudinal::driver::Driver;
use railheat::section::RailFile;
use railheat::weather::{Ephemeris, WeatherFile};
use stock::{Consist, Library};
use track::TrackFile;

use crate::scratch::Scratch;

/// Radius of the wheel that stands on a rail, m.
const RADIUS: f64 = 0.46;

pub fn scenario(bytes: &[u8]) {
    let scratch = Scratch::with("scenario.toml", bytes);
    for file in ["track.toml", "driver.toml", "stock/vehicles/wagon.toml"] {
        scratch.write(file, "");
    }
    let _ = hotfoot::scenario::load(scratch.folder(), &[]);
}

pub fn track(bytes: &[u8]) {
    all_of_track(&Scratch::with("track.toml", bytes));
}

/// Measured irregularities, which a track file names.
pub fn irregularity(bytes: &[u8]) {
    let scratch = Scratch::with("measured.csv", bytes);
    scratch.write("track.toml", "irregularity.file = \"measured.csv\"");
    all_of_track(&scratch);
}

fn all_of_track(scratch: &Scratch) {
    if let Ok(file) = TrackFile::read(&scratch.path("track.toml")) {
        let _ = file.track();
        let _ = file.irregularity();
        let _ = file.support();
        let _ = file.friction();
    }
}

pub fn driver(bytes: &[u8]) {
    let _ = Driver::from_file(&Scratch::with("driver.toml", bytes).path("driver.toml"));
}

/// The record of a locomotive's logger, which a driver file names.
pub fn logger(bytes: &[u8]) {
    const REPLAY: &str = "[replay]\nfile = \"log.csv\"\ntime = \"time_s\"\nspeed = \"speed\"\n\
                          speed_unit = \"km/h\"\nthrottle = \"notch\"\ntrain_brake = \"brake\"\n";
    let scratch = Scratch::with("log.csv", bytes);
    scratch.write("driver.toml", REPLAY);
    let _ = Driver::from_file(&scratch.path("driver.toml"));
}

pub fn consist(bytes: &[u8]) {
    let _ = Consist::from_file(&Scratch::with("consist.toml", bytes).path("consist.toml"));
}

pub fn draft_gear(bytes: &[u8]) {
    let scratch = Scratch::with("draft_gears/read.toml", bytes);
    scratch.write("vehicles/wagon.toml", "");
    let _ = Library::open(scratch.folder()).map(|library| library.draft_gear("read"));
}

/// A vehicle file with all its sections, which may extend a shipped one.
pub fn vehicle(bytes: &[u8]) {
    const WAGON: &str = include_str!("../../../stock/vehicles/wagon-coco-134t-air.toml");
    const LOCOMOTIVE: &str = include_str!("../../../stock/vehicles/locomotive-coco-134t.toml");
    let scratch = Scratch::with("vehicles/read.toml", bytes);
    scratch.write("vehicles/wagon-coco-134t-air.toml", WAGON);
    scratch.write("vehicles/locomotive-coco-134t.toml", LOCOMOTIVE);
    let _ = Library::open(scratch.folder()).map(|library| library.vehicle("read"));
}

pub fn wheel_profile(bytes: &[u8]) {
    let scratch = Scratch::with("read.prw", bytes);
    let _ = WheelProfile::named(&scratch.path("read.prw").to_string_lossy());
}

/// A rail's profile, also as it leans.
pub fn rail_profile(bytes: &[u8]) {
    let scratch = Scratch::with("read.prr", bytes);
    if let Ok(rail) = RailProfile::named(&scratch.path("read.prr").to_string_lossy()) {
        let pair = ProfilePair::standard_gauge(WheelProfile::S1002, rail, 1.0 / 40.0, RADIUS);
        assert!(pair.rail_top().is_finite());
    }
}

pub fn rail_section(bytes: &[u8]) {
    let scratch = Scratch::with("rail.toml", bytes);
    if let Ok(file) = RailFile::open(&scratch.path("rail.toml").to_string_lossy()) {
        let _ = file.outline();
    }
}

/// What a rail's FMU reads from its resources.
pub fn rail_shape(bytes: &[u8]) {
    let scratch = Scratch::with(railheat::FILE_NAME, bytes);
    let _ = railheat::Shape::from_resources(scratch.folder());
}

/// A file of EnergyPlus begins with its line LOCATION.
pub fn weather(bytes: &[u8]) {
    let name = if bytes.starts_with(b"LOCATION") { "weather.epw" } else { "weather.csv" };
    let noon = Ephemeris::new("2018-06-30T12:00:00+10:00", -0.4, 2.6).ok();
    if let Ok(file) = WeatherFile::open(&Scratch::with(name, bytes).path(name)) {
        let _ = file.at(0.0, noon.as_ref());
    }
}
