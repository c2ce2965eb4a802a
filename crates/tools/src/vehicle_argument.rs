//! The vehicle that a command is about.

use std::path::PathBuf;

use clap::Args;
use stock::Library;
use vehicle::structure::Structure;

use crate::error::ToolError;

/// A vehicle of the rolling-stock library, or a vehicle file.
#[derive(Args)]
pub struct VehicleArgument {
    /// Vehicle: a name in the library, or a file that ends in .toml
    vehicle: PathBuf,
    /// Rolling-stock library; left out: `stock` here, else the one that is shipped
    #[arg(long, default_value = HERE)]
    stock: PathBuf,
}

/// The library where none is named.
const HERE: &str = "stock";

impl VehicleArgument {
    /// Takes the shipped library where none is named and there is none here.
    pub fn or_library(&mut self, shipped: PathBuf) {
        if self.stock.as_os_str() == HERE && !self.stock.is_dir() {
            self.stock = shipped;
        }
    }

    /// Reads and compiles the vehicle.
    ///
    /// # Errors
    /// When its file cannot be read or has no usable multibody section.
    pub fn structure(&self) -> Result<Structure, ToolError> {
        let file = match self.vehicle.extension().is_some_and(|extension| extension == "toml") {
            true => self.vehicle.clone(),
            false => self.stock.join("vehicles").join(&self.vehicle).with_added_extension("toml"),
        };
        let library = Library::of(&file).or_else(|_| Library::open(&self.stock));
        let vehicle = library.and_then(|library| library.vehicle_from_file(&file))?;
        Ok(Structure::new(&vehicle)?)
    }
}
