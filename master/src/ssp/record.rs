//! What is recorded of a system: a table for each component with all its outputs that are
//! numbers.

use std::path::Path;

use crate::interface::{Variable, VariableType};
use crate::recording::{Column, SeriesWriter, TIME};
use crate::run::observe::ObserveError;
use crate::system::links::Signals;
use crate::system::step::System;
use crate::system::unit::Unit;

/// Recorded time in a part of a series on disk, s; a killed run loses less than this.
const PART_S: f64 = 1.0;

/// Records the series of a system.
pub struct Recorder {
    tables: Vec<Table>,
    /// Exchange steps per record.
    every: u64,
}

/// The table of a component.
struct Table {
    /// Number of the component.
    part: usize,
    outputs: Signals,
    writer: SeriesWriter,
}

impl Recorder {
    /// Begins the series of a system in `folder`, with a record every so many steps.
    ///
    /// # Errors
    /// When the folder cannot be written.
    pub fn new(system: &System, every: u64, folder: &Path) -> Result<Self, ObserveError> {
        let interval = every as f64 * system.clock.length;
        let per_part = (PART_S / interval).ceil() as usize;
        let mut tables = vec![];
        for (part, of_system) in system.parts.iter().enumerate() {
            let (outputs, columns) = outputs(of_system.unit.interface());
            let Some(name) = table_name(of_system.unit.as_ref()) else { continue };
            let writer = SeriesWriter::create(folder, &name, vec![], columns, per_part)?;
            tables.push(Table { part, outputs, writer });
        }
        Ok(Self { tables, every })
    }

    /// Records the state at communication point `k` if it is due.
    ///
    /// # Errors
    /// When a file cannot be written or a unit does not give its outputs.
    pub fn observe(&mut self, k: u64, system: &mut System) -> Result<(), ObserveError> {
        if !k.is_multiple_of(self.every) {
            return Ok(());
        }
        let time = system.clock.at(k);
        for table in &mut self.tables {
            table.outputs.get(system.parts[table.part].unit.as_mut())?;
            let Signals { reals, integers, booleans } = &table.outputs;
            let whole = integers.values.iter().chain(&booleans.values).map(|&v| f64::from(v));
            let values: Vec<f64> = reals.values.iter().copied().chain(whole).collect();
            table.writer.observe(0, &values);
            table.writer.record(time)?;
        }
        Ok(())
    }

    /// Completes the files.
    ///
    /// # Errors
    /// When a file cannot be written.
    pub fn finish(self) -> Result<(), ObserveError> {
        for table in self.tables {
            table.writer.finish()?;
        }
        Ok(())
    }
}

/// All outputs of a unit that are numbers, and their columns: Real, Integer, Boolean.
fn outputs(interface: &crate::Interface) -> (Signals, Vec<Column>) {
    let mut signals = Signals::default();
    let mut columns = vec![];
    for variable in interface.variables().into_iter().filter(|v| v.causality == "output") {
        if signals.place(variable.kind, variable.reference).is_none() {
            continue;
        }
        let unit = variable.unit.as_deref().unwrap_or("1");
        columns.push(Column::new(column_name(variable), unit, &variable.description).double());
    }
    (signals, columns)
}

/// Name of an output's column: its own, except where the column of times has that.
fn column_name(output: &Variable) -> &str {
    match output.name.as_str() {
        TIME => "time (output)",
        name => name,
    }
}

/// Says which outputs of a system have columns of another name.
pub fn renamed(system: &System) -> Vec<String> {
    let parts = system.parts.iter().filter_map(|part| {
        let output = part.unit.interface().variable(TIME)?;
        let other = column_name(output);
        (output.causality == "output" && output.kind != VariableType::Text).then(|| {
            let component = part.unit.name();
            format!(
                "the output '{TIME}' of {component} is recorded as '{other}', since '{TIME}' is the \
                 column of the simulated time"
            )
        })
    });
    parts.collect()
}

/// Name of the table of a component: its own, as that of a file; none if it has no output that is a
/// number.
pub fn table_name(component: &dyn Unit) -> Option<String> {
    let plain = |c: char| if c.is_alphanumeric() || "._-[]".contains(c) { c } else { '_' };
    let (_, columns) = outputs(component.interface());
    (!columns.is_empty()).then(|| component.name().chars().map(plain).collect())
}
