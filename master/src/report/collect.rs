//! Reads from the folder of a run what its report shows.

use std::path::Path;

use super::data::{MainFigure, RailData};
use super::error::ReportError;
use super::facts::{EnergyLine, RunFacts};
use super::instrument::Instrument;
use super::provenance::Provenance;
use super::results::Results;
use super::{main_figures, rail_figures, speed_limits};
use crate::recording::{KeyValue, RecordingError, SeriesReader};

/// All that a report shows.
#[derive(Debug)]
pub struct ReportData {
    /// Facts of the run.
    pub facts: RunFacts,
    /// What was run.
    pub provenance: Provenance,
    /// The table of main figures.
    pub main_figures: Vec<MainFigure>,
    /// The energy audit.
    pub energy: Vec<EnergyLine>,
    /// Times of the records, s.
    pub time: Vec<f64>,
    /// Speed of the leading vehicle at these times, m/s.
    pub speed: Vec<f64>,
    /// Speed in the logger's file at these times, m/s; empty without one.
    pub measured_speed: Vec<f64>,
    /// Lowest force in any coupler between two records, N, tension positive.
    pub lowest_coupler_force: Vec<f64>,
    /// Highest force in any coupler between two records, N.
    pub highest_coupler_force: Vec<f64>,
    /// The heated rails.
    pub rails: Vec<RailData>,
    /// The linked view.
    pub instrument: Instrument,
}

/// Reads the results of the run in `folder`.
///
/// # Errors
/// When one of them is missing or cannot be read.
pub fn collect(folder: &Path) -> Result<ReportData, ReportError> {
    let results = Results::open(folder)?;
    let Results { facts, provenance, train, vehicles, .. } = &results;
    let leading = [("vehicle", KeyValue::Integer(1))];
    let rails = match &facts.rails {
        Some(of_rails) => rail_figures::of_run(folder, of_rails)?,
        None => vec![],
    };
    let instrument = Instrument::of(folder, &results, &rails)?;
    let warnings = [facts.warnings.clone(), instrument.unread.clone()].concat();
    let notes = [facts.notes.clone(), speed_limits::exceeded(facts, vehicles)?].concat();
    Ok(ReportData {
        main_figures: main_figures::of_run(&results, instrument.residual.as_ref())?,
        energy: energy(facts, train),
        time: vehicles.read("time", &leading)?,
        speed: vehicles.read("velocity", &leading)?,
        measured_speed: results.measured_speed()?,
        lowest_coupler_force: extreme(vehicles, facts, "coupler_rear_force_min", f64::min)?,
        highest_coupler_force: extreme(vehicles, facts, "coupler_rear_force_max", f64::max)?,
        rails,
        provenance: provenance.clone(),
        facts: RunFacts { warnings, notes, ..facts.clone() },
        instrument,
    })
}

/// The energies of the run under the descriptions that their columns have.
fn energy(facts: &RunFacts, train: &SeriesReader) -> Vec<EnergyLine> {
    let described = |line: &EnergyLine| {
        let column = train.columns().find(|column| *column.name() == line.name);
        let description = column.and_then(|column| column.metadata().get("description"));
        EnergyLine { name: description.unwrap_or(&line.name).to_owned(), joules: line.joules }
    };
    facts.energy.iter().map(described).collect()
}

/// The extreme of a column over all vehicles, at each record.
fn extreme(
    vehicles: &SeriesReader,
    facts: &RunFacts,
    column: &str,
    better: fn(f64, f64) -> f64,
) -> Result<Vec<f64>, RecordingError> {
    let values = vehicles.read(column, &[])?;
    let records = values.chunks(facts.vehicles.max(1));
    Ok(records.map(|record| record.iter().copied().fold(f64::NAN, better)).collect())
}
