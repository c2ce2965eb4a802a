//! The resources that Hotfoot's own FMUs need for a scenario: what is in the `resources` folder
//! of each, so that the packed FMUs run in any tool without further files.

use std::path::{Path, PathBuf};

use serde::Serialize;

use crate::files::file_error::FileError;
use crate::fmi::Origins;
use crate::fmi::pack::{PackError, copy_folder, write};
use crate::scenario::{Heat, Scenario, Value};

/// Writes the resources of the train: consist, driver, track and stock library.
///
/// # Errors
/// When a file cannot be read or written.
pub fn write_longitudinal(scenario: &Scenario, folder: &Path) -> Result<Origins, PackError> {
    #[derive(Serialize)]
    struct Consist<'a> {
        vehicle: &'a [crate::scenario::VehicleGroup],
    }
    let consist = Consist { vehicle: &scenario.train.vehicles };
    write(&folder.join("consist.toml"), to_toml(&consist).as_bytes())?;
    copy_file(&scenario.driver.file, &folder.join("driver.toml"))?;
    for file in &scenario.driver.with {
        copy_file(file, &folder.join(file.file_name().unwrap_or_default()))?;
    }
    let mut origins = write_track_and_stock(scenario, folder)?;
    origins.add("driver.toml", &scenario.driver.file);
    Ok(origins)
}

/// Writes the resources of a vehicle of type `kind`: vehicle, track and stock library.
///
/// # Errors
/// When a file cannot be read or written.
pub fn write_vehicle(scenario: &Scenario, kind: &str, folder: &Path) -> Result<Origins, PackError> {
    #[derive(Serialize)]
    struct Vehicle<'a> {
        extends: &'a str,
    }
    write(&folder.join("vehicle.toml"), to_toml(&Vehicle { extends: kind }).as_bytes())?;
    let mut origins = write_track_and_stock(scenario, folder)?;
    origins.add("vehicle.toml", &scenario.vehicle_file(kind));
    Ok(origins)
}

/// Where the file that a parameter names lies in the resources, with its own name behind.
pub fn parameter_file(parameter: &str, file: &Path) -> PathBuf {
    Path::new("parameters").join(parameter).join(file.file_name().unwrap_or_default())
}

/// Writes the resources of the rail: what shapes its interface, the track, whose curves turn the
/// rail in the sun, and the files that its parameters name.
///
/// # Errors
/// When a file cannot be read or written.
pub fn write_railheat(
    scenario: &Scenario,
    heat: &Heat,
    wheelsets: &[usize],
    folder: &Path,
) -> Result<Origins, PackError> {
    #[derive(Serialize)]
    struct RailHeat<'a> {
        wheelsets_per_vehicle: &'a [usize],
        depths_mm: &'a [f64],
        probe: &'a [crate::scenario::Probe],
    }
    let file = RailHeat {
        wheelsets_per_vehicle: wheelsets,
        depths_mm: &heat.depths_mm,
        probe: &heat.probe,
    };
    write(&folder.join("railheat.toml"), to_toml(&file).as_bytes())?;
    copy_file(&scenario.track.file, &folder.join("track.toml"))?;
    let mut origins = Origins::default();
    origins.add("track.toml", &scenario.track.file);
    for (name, value) in &heat.parameters {
        if let Value::File(original) = value {
            let copy = parameter_file(name, original);
            copy_file(original, &folder.join(&copy))?;
            origins.add(copy.display().to_string(), original);
        }
    }
    Ok(origins)
}

fn write_track_and_stock(scenario: &Scenario, folder: &Path) -> Result<Origins, PackError> {
    copy_file(&scenario.track.file, &folder.join("track.toml"))?;
    let mut origins = Origins::default();
    origins.add("track.toml", &scenario.track.file);
    // A track file that cannot be read is answered by the models, with all that is wrong in it.
    let track = track::TrackFile::read(&scenario.track.file);
    if let Some(irregularities) = track.ok().and_then(|track| track.measured()) {
        let name = irregularities.file_name().unwrap_or_default();
        copy_file(&irregularities, &folder.join(name))?;
        origins.add(name.display().to_string(), &irregularities);
    }
    copy_folder(&scenario.stock, &folder.join("stock"))?;
    for group in &scenario.train.vehicles {
        if let Some(file) = &group.file {
            let copy = format!("stock/vehicles/{}.toml", group.kind);
            copy_file(file, &folder.join(&copy))?;
            origins.add(copy, file);
        }
    }
    origins.add("stock", &scenario.stock);
    Ok(origins)
}

fn copy_file(from: &Path, to: &Path) -> Result<(), PackError> {
    let bytes = std::fs::read(from).map_err(FileError::at(from))?;
    write(to, &bytes)
}

/// Our own small structures always have a TOML form.
fn to_toml(value: &impl Serialize) -> String {
    toml::to_string(value).expect("tables of numbers and texts")
}
