//! The rolling-stock library as a list.
//!
//! Vehicles, draft gears, rail sections and profiles, with their main figures and where these are from.
//!
//! | file | part |
//! |---|---|
//! | `entry.rs` | an entry with its figures |
//! | `vehicle.rs` | figures of a vehicle |
//! | `draft_gear.rs` | figures of a draft gear |
//! | `rail.rs` | figures of a rail section |
//! | `profile.rs` | the profiles that need no file |

mod draft_gear;
mod entry;
mod profile;
mod rail;
mod vehicle;

use std::path::Path;

pub use entry::{Entry, Figure, Kind};
use files::{Mistake, did_you_mean};
use stock::Library;

/// All entries of the library in a folder, by kind and name.
///
/// # Errors
/// When it is no library, or a file in it has a mistake.
pub fn entries(folder: &Path) -> Result<Vec<Entry>, Mistake> {
    let library = Library::open(folder)?;
    let vehicles = library.vehicle_names();
    let vehicles = vehicles.iter().map(|name| vehicle::entry(&library, name));
    let gears = library.draft_gear_names();
    let gears = gears.iter().map(|name| draft_gear::entry(&library, name));
    let mut entries: Vec<Entry> = vehicles.chain(gears).collect::<Result<_, Mistake>>()?;
    entries.extend(rail::entries(&folder.join("rails"))?);
    entries.extend(profile::entries());
    Ok(entries)
}

/// The entries of a name: a rail section and its profile have the same.
///
/// # Errors
/// When there is none.
pub fn named(folder: &Path, name: &str) -> Result<Vec<Entry>, Mistake> {
    let mut entries = entries(folder)?;
    if !entries.iter().any(|entry| entry.name == name) {
        let meant = did_you_mean(name, entries.iter().map(|entry| entry.name.as_str()));
        let sentence = format!("has no entry {name}{meant}; `hotfoot stock list` has all names");
        return Err(Mistake::in_file(folder.display(), sentence));
    }
    entries.retain(|entry| entry.name == name);
    Ok(entries)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shipped() -> &'static Path {
        Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../stock"))
    }

    fn value(entry: &Entry, name: &str) -> String {
        let figure = entry.figures.iter().find(|figure| figure.name == name);
        figure.unwrap_or_else(|| panic!("{} has no {name}", entry.name)).to_string()
    }

    /// Every shipped file is there, with figures and a source.
    #[test]
    fn every_file_of_the_library_is_an_entry() {
        let entries = entries(shipped()).unwrap();
        for folder in ["vehicles", "draft_gears", "rails"] {
            for file in std::fs::read_dir(shipped().join(folder)).unwrap() {
                let file = file.unwrap().path();
                let name = file.file_stem().unwrap().to_str().unwrap();
                assert!(entries.iter().any(|entry| entry.name == name), "{folder}/{name}");
            }
        }
        for entry in &entries {
            assert!(entry.source.len() > 10 && entry.figures.len() > 1, "{}", entry.name);
            assert!(entry.figures.iter().any(|figure| figure.is_main), "{}", entry.name);
        }
    }

    /// A wagon of 159998.2 kg on four axles: 40.0 t each, so 392.3 kN; the gear's file says 74.4 mm and
    /// 2518 kN; a mass of 7670 mm² of steel of 7850 kg/m³ is 60.2 kg/m.
    #[test]
    fn analytic_figures_are_those_of_the_files() {
        let wagon = named(shipped(), "wagon-ore-40t").unwrap().remove(0);
        assert_eq!(value(&wagon, "mass"), "160.0 t");
        assert_eq!(value(&wagon, "axle load"), "40.0 t");
        assert_eq!(value(&wagon, "wheelsets"), "4");
        let gear = named(shipped(), "friction-gear-m901e").unwrap().remove(0);
        assert_eq!(value(&gear, "travel"), "74.4 mm");
        assert_eq!(value(&gear, "force at the travel"), "2518 kN");
        let rail = named(shipped(), "60E1").unwrap();
        assert_eq!(
            rail.iter().map(|entry| entry.kind).collect::<Vec<_>>(),
            [Kind::RailSection, Kind::RailProfile]
        );
        assert_eq!(value(&rail[0], "mass"), "60.2 kg/m");
        assert!(rail[0].source.contains("EN 13674-1"));
    }

    #[test]
    fn a_name_that_is_not_there_is_answered_with_the_nearest() {
        let message = named(shipped(), "wagon-ore-40").unwrap_err().to_string();
        assert!(message.contains("did you mean `wagon-ore-40t`?"), "{message}");
    }
}
