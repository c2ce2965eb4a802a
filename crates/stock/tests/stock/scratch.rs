//! A library of its own for each test.

use std::path::{Path, PathBuf};

use files::Mistake;
use stock::{Library, Vehicle};

/// The shipped rolling stock.
pub const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../stock");

/// The shipped library.
pub fn shipped() -> Library {
    Library::open(ROOT).expect("the repository has a stock folder")
}

/// A library of the shipped vehicles in a folder of its own, with one more vehicle in it.
pub struct Scratch {
    /// The folder, which goes when this goes.
    pub folder: tempfile::TempDir,
}

impl Scratch {
    /// With a vehicle of this name and text.
    pub fn with(name: &str, text: &str) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let vehicles = folder.path().join("vehicles");
        std::fs::create_dir(&vehicles).unwrap();
        for file in std::fs::read_dir(Path::new(ROOT).join("vehicles")).unwrap() {
            let file = file.unwrap();
            std::fs::copy(file.path(), vehicles.join(file.file_name())).unwrap();
        }
        std::fs::write(vehicles.join(format!("{name}.toml")), text).unwrap();
        Self { folder }
    }

    /// The file of a vehicle.
    pub fn file(&self, name: &str) -> PathBuf {
        self.folder.path().join("vehicles").join(format!("{name}.toml"))
    }

    /// Reads a vehicle.
    pub fn vehicle(&self, name: &str) -> Result<Vehicle, Mistake> {
        Library::open(self.folder.path())?.vehicle(name)
    }
}

/// The message about a vehicle that extends the shipped locomotive with `text`.
pub fn message(text: &str) -> String {
    let text = format!("extends = 'locomotive-coco-134t'\n{text}");
    let error = Scratch::with("changed", &text).vehicle("changed").unwrap_err();
    error.to_string()
}
