//! The files that a scenario's run is made of.

use std::path::PathBuf;

use walkdir::WalkDir;

use super::file::Scenario;
use super::value::Value;

impl Scenario {
    /// All files that the scenario names, and those of its rolling-stock library.
    pub fn inputs(&self) -> Vec<PathBuf> {
        let Self { stock, train, track, driver, heat, fmus, .. } = self;
        let stock = WalkDir::new(stock).sort_by_file_name().into_iter().flatten();
        let stock =
            stock.filter(|entry| entry.file_type().is_file()).map(|entry| entry.into_path());
        let own_vehicles = train.vehicles.iter().filter_map(|group| group.file.as_ref());
        let named = [&track.file, &driver.file].into_iter().chain(own_vehicles);
        let of_fmus = [&fmus.longitudinal, &fmus.vehicle, &fmus.railheat].into_iter().flatten();
        let of_vehicles = fmus.vehicle_at.iter().filter_map(|other| other.file.as_ref());
        let of_rails = heat.iter().flat_map(|heat| heat.parameters.values());
        let parameters = fmus.vehicle_at.iter().flat_map(|other| other.parameters.values());
        let of_parameters = of_rails.chain(parameters).filter_map(|value| match value {
            Value::File(path) => Some(path),
            _ => None,
        });
        let named =
            named.chain(&driver.with).chain(of_fmus).chain(of_vehicles).chain(of_parameters);
        named.cloned().chain(stock).collect()
    }
}
