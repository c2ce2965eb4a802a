//! Further outputs of the recorded vehicles: those that the scenario names.

use std::collections::BTreeMap;
use std::path::Path;

use crate::interface::name_pattern::matches;
use crate::interface::{Variable, VariableType};
use crate::recording::{Column, SeriesWriter, vehicle_keys_of};
use crate::run::observe::ObserveError;
use crate::system::port::{Port, Signal};
use crate::train::lockstep::Vehicle;

/// Why outputs cannot be recorded.
#[derive(Debug, thiserror::Error)]
pub enum OutputsError {
    /// No vehicle has such an output.
    #[error(
        "record.outputs: no Real output of vehicles {vehicles:?} has the name \"{pattern}\"; \
         `hotfoot interface FILE.fmu` lists what an FMU has"
    )]
    None {
        /// The name, as the scenario has it.
        pattern: String,
        /// Places in the train of the recorded vehicles, from one.
        vehicles: Vec<usize>,
    },
    /// Two vehicles have it in two units.
    #[error(
        "record.outputs: \"{name}\" is in \"{unit}\" in vehicle {vehicle}, but in \"{other}\" in one \
         before; one column cannot have both"
    )]
    Units {
        /// Name of the output.
        name: String,
        /// Its unit in a vehicle.
        unit: String,
        /// Place of that vehicle.
        vehicle: usize,
        /// Its unit before.
        other: String,
    },
}

/// Records the table `outputs`: a row for each recorded vehicle, a column for each output; outputs
/// that a vehicle lacks are not-a-number there.
pub struct OutputRecorder {
    series: SeriesWriter,
    /// Place in the train, from zero, and port of each row.
    rows: Vec<(usize, Port)>,
}

impl OutputRecorder {
    /// Begins the table in `folder`, for the vehicles at `places` (from one); none if no output is
    /// wanted.
    ///
    /// # Errors
    /// When a name fits no output, or the folder cannot be written.
    pub fn new(
        patterns: &[String],
        places: &[usize],
        vehicles: &[Vehicle],
        folder: &Path,
        per_part: usize,
    ) -> Result<Option<Self>, ObserveError> {
        let recorded: Vec<_> =
            places.iter().filter_map(|&place| Some((place, vehicles.get(place - 1)?))).collect();
        if patterns.is_empty() || recorded.is_empty() {
            return Ok(None);
        }
        let columns = columns(patterns, &recorded)?;
        let signals: Vec<_> =
            columns.iter().map(|column| Signal::optional(column.name())).collect();
        let port = |(place, vehicle): &(usize, &Vehicle)| {
            let interface = vehicle.unit.interface();
            let mut port =
                Port::connect(interface, &signals, "output", &BTreeMap::new()).unwrap_or_default();
            port.values = vec![f64::NAN; signals.len()];
            (place - 1, port)
        };
        let keys = vehicle_keys_of(recorded.iter().map(|(place, _)| *place));
        let series = SeriesWriter::create(folder, "outputs", keys, columns, per_part)?;
        Ok(Some(Self { series, rows: recorded.iter().map(port).collect() }))
    }

    /// Takes the outputs after a step.
    ///
    /// # Errors
    /// When a vehicle does not give them.
    pub fn observe(&mut self, vehicles: &mut [Vehicle]) -> Result<(), ObserveError> {
        for (row, (place, port)) in self.rows.iter_mut().enumerate() {
            port.get(vehicles[*place].unit.as_mut())?;
            self.series.observe(row, &port.values);
        }
        Ok(())
    }

    /// Records the instant.
    ///
    /// # Errors
    /// When a file cannot be written.
    pub fn record(&mut self, time: f64) -> Result<(), ObserveError> {
        Ok(self.series.record(time)?)
    }

    /// Completes the files.
    ///
    /// # Errors
    /// When a file cannot be written.
    pub fn finish(self) -> Result<(), ObserveError> {
        Ok(self.series.finish()?)
    }
}

/// The outputs of all these vehicles that fit one of the names, in the order of the first vehicle
/// that has them.
fn columns(
    patterns: &[String],
    vehicles: &[(usize, &Vehicle)],
) -> Result<Vec<Column>, OutputsError> {
    let mut columns: Vec<Column> = vec![];
    let mut fitting = vec![false; patterns.len()];
    for (place, vehicle) in vehicles {
        let variables = vehicle.unit.interface().variables().into_iter();
        let is_output = |v: &&Variable| v.causality == "output" && v.kind == VariableType::Real;
        for output in variables.filter(is_output) {
            let mut wanted = false;
            for (pattern, fits) in patterns.iter().zip(&mut fitting) {
                let matching = matches(pattern, &output.name);
                *fits |= matching;
                wanted |= matching;
            }
            if wanted {
                add(&mut columns, output, *place)?;
            }
        }
    }
    match fitting.iter().position(|fits| !fits) {
        None => Ok(columns),
        Some(lonely) => Err(OutputsError::None {
            pattern: patterns[lonely].clone(),
            vehicles: vehicles.iter().map(|(place, _)| *place).collect(),
        }),
    }
}

/// Adds the column of an output, unless it is there.
fn add(columns: &mut Vec<Column>, output: &Variable, vehicle: usize) -> Result<(), OutputsError> {
    let unit = output.unit.as_deref().unwrap_or("1");
    match columns.iter().find(|column| column.name() == output.name) {
        None => {
            let column = Column::new(&output.name, unit, &output.description);
            columns.push(column.double().mean().extremes());
            Ok(())
        }
        Some(other) if other.unit() == unit => Ok(()),
        Some(other) => Err(OutputsError::Units {
            name: output.name.clone(),
            unit: unit.to_owned(),
            vehicle,
            other: other.unit().to_owned(),
        }),
    }
}
