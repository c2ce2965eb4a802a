//! The files of a train and its line, read and checked by the models that a run gives them to.
//!
//! `standing.rs` says whether its vehicles stand on both rails where it starts.

mod standing;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use files::{Check, Mistake};
use longitudinal::driver::{Driver, check_groups};
use numerics::seconds;
use railheat::section::RailFile;
use railheat::weather::WeatherFile;
use stock::Library;
use track::TrackFile;

pub use standing::Start;

/// The files of a train and its line.
#[derive(Debug)]
pub struct TrainFiles<'a> {
    /// Folder of the rolling-stock library.
    pub stock: &'a Path,
    /// Files of the types of its vehicles, each with the group of locomotives whose commands it follows.
    pub vehicles: Vec<(PathBuf, usize)>,
    /// Track file.
    pub track: &'a Path,
    /// Driver file.
    pub driver: &'a Path,
    /// Files that the driver file may name.
    pub with: &'a [PathBuf],
    /// Time for which the train runs, s.
    pub duration: f64,
}

impl TrainFiles<'_> {
    /// Reads and checks all of them; gives what is possible and yet hardly meant, in sentences.
    ///
    /// # Errors
    /// When one cannot be read or has a value that is not possible.
    pub fn check(&self) -> Result<Vec<String>, Mistake> {
        check_track(self.track)?;
        let has_traction = self.check_vehicles()?;
        self.check_driver(has_traction)
    }

    /// Checks vehicles and draft gears; says whether one of the vehicles has traction.
    fn check_vehicles(&self) -> Result<bool, Mistake> {
        let library = Library::open(self.stock)?;
        let types: BTreeSet<&Path> = self.vehicles.iter().map(|(file, _)| &**file).collect();
        let mut has_traction = false;
        for file in types {
            let vehicle = library.vehicle_from_file(file)?;
            library.draft_gears_of(file, &vehicle)?;
            has_traction |= vehicle.traction.is_some();
        }
        Ok(has_traction)
    }

    fn check_driver(&self, has_traction: bool) -> Result<Vec<String>, Mistake> {
        let driver = Driver::from_files(self.driver, self.with)?;
        let groups: BTreeSet<usize> = self.vehicles.iter().map(|(_, group)| *group).collect();
        check_groups(self.driver, &groups.into_iter().collect::<Vec<_>>())?;
        let (file, duration) = (self.driver.display(), self.duration);
        let mut notes = vec![];
        if driver.pulls() && !has_traction {
            notes.push(format!(
                "{file}: the throttle does nothing, since no vehicle has [traction]; a locomotive has it, as those that \
                 `hotfoot stock list` shows"
            ));
        }
        if let Some(end) = driver.recorded_time().filter(|end| *end < duration) {
            notes.push(format!(
                "{file}: the record that it replays ends after {} s, the run after {duration} s; the last row \
                 is held",
                seconds(end)
            ));
        }
        Ok(notes)
    }
}

/// Reads and checks a track file and the file with irregularities that it may name.
fn check_track(file: &Path) -> Result<(), Mistake> {
    let file = TrackFile::read(file)?;
    file.track()?;
    file.irregularity()?;
    file.support()?;
    file.friction().map(|_| ())
}

/// Reads and checks a file of the weather.
///
/// # Errors
/// When it cannot be read or has a value that is not possible.
pub fn check_weather(file: &Path) -> Result<(), Mistake> {
    WeatherFile::open(file).map(|_| ())
}

/// Reads and checks a rail section by its name or file, which stands as the value of a key.
///
/// # Errors
/// When there is no such section, or a value in its file is not possible.
pub fn check_rail(name: &str, check: &Check, key: &str) -> Result<(), Mistake> {
    let is_file = Path::new(name).is_file();
    match RailFile::open(name) {
        Ok(_) => Ok(()),
        Err(mistake) if is_file => Err(mistake),
        Err(mistake) => Err(check.error(key, format!("\"{name}\""), mistake.sentence)),
    }
}
