//! Reads from the folder of a run what its report shows.

use std::path::Path;

use field::{FieldError, FieldReader};

use super::data::{Curve, RailField, ReportData, Snapshot, VehicleSeries};
use super::error::ReportError;
use super::facts::{EnergyLine, RunFacts};
use super::results::Results;
use super::{main_figures, rail_figures};
use crate::recording::{KeyValue, RecordingError, SeriesReader};

/// Column of the train in which the notch stands.
const NOTCH: &str = "driver.in_force.notch";

/// Reads the results of the run in `folder`.
///
/// # Errors
/// When one of them is missing or cannot be read.
pub fn collect(folder: &Path) -> Result<ReportData, ReportError> {
    let results = Results::open(folder)?;
    let Results { facts, train, vehicles, .. } = &results;
    let mut unread = vec![];
    let leading = [("vehicle", KeyValue::Integer(1))];
    let time = vehicles.read("time", &leading)?;
    let positions = vehicles.read("position", &[])?;
    let mut rails = vec![];
    if let Some(of_rails) = &facts.rails {
        rails = rail_figures::of_run(folder, of_rails)?;
        for (rail, store) in rails.iter_mut().zip(&of_rails.fields) {
            let store = folder.join(store);
            if store.is_dir() {
                // A field that was damaged, as by a full disk, must not cost the rest of the report.
                match rail_field(&store, facts, &time, &positions) {
                    Ok(field) => rail.field = Some(field),
                    Err(error) => unread.push(format!("{error}; the report goes without it")),
                }
            }
        }
    }
    let plotted = facts.plotted.iter().filter(|number| (1..=facts.vehicles).contains(number));
    let plotted = plotted.map(|&number| vehicle(vehicles, facts, number));
    Ok(ReportData {
        main_figures: main_figures::of_run(&results)?,
        energy: energy(facts, train),
        speed: vehicles.read("velocity", &leading)?,
        notch: match train.columns().any(|column| column.name() == NOTCH) {
            true => train.read(NOTCH, &[])?,
            false => vec![],
        },
        time,
        vehicles: plotted.collect::<Result<_, _>>()?,
        rails,
        facts: RunFacts { warnings: [facts.warnings.clone(), unread].concat(), ..facts.clone() },
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

fn vehicle(
    vehicles: &SeriesReader,
    facts: &RunFacts,
    number: usize,
) -> Result<VehicleSeries, RecordingError> {
    let key = KeyValue::Integer(i32::try_from(number).unwrap_or(i32::MAX));
    let curve = |column: &str| {
        let read = |suffix: &str| vehicles.read(&format!("{column}{suffix}"), &[("vehicle", key)]);
        Ok::<_, RecordingError>(Curve {
            value: read("")?,
            lowest: read("_min")?,
            highest: read("_max")?,
        })
    };
    Ok(VehicleSeries {
        number,
        locomotive: facts.locomotives.contains(&number),
        coupler_force: curve("coupler_rear_force")?,
        creep_force: curve("creep_force")?,
        sync_force: curve("sync_force")?,
        position_error: curve("position_error")?,
    })
}

/// The field at the wanted times, each with the positions of the vehicles at that time.
///
/// `positions` holds the vehicles' positions record by record, and ends with the run. A
/// wanted time that the field has not reached is left out, as is one that falls on the same
/// snapshot as another.
fn rail_field(
    store: &Path,
    facts: &RunFacts,
    time: &[f64],
    positions: &[f64],
) -> Result<RailField, FieldError> {
    let reader = FieldReader::open(store)?;
    let mut field = RailField {
        chainage: reader.axes().chainage.clone(),
        depth: reader.axes().depth.clone(),
        snapshots: vec![],
    };
    let reached = reader.times().last().copied().unwrap_or(f64::NEG_INFINITY);
    let reached = reached.max(time.last().copied().unwrap_or(reached));
    for &wanted in facts.heat_maps_at_s.iter().filter(|&&wanted| wanted <= reached) {
        let snapshot = reader.at_time(wanted)?;
        if field.snapshots.iter().any(|other| other.time == snapshot.time) {
            continue;
        }
        let record = time.partition_point(|&t| t < snapshot.time - 1e-9);
        let mut instants = positions.chunks(facts.vehicles.max(1));
        field.snapshots.push(Snapshot {
            time: snapshot.time,
            rise: snapshot.rise,
            vehicles: instants.nth(record).unwrap_or_default().to_vec(),
        });
    }
    Ok(field)
}
