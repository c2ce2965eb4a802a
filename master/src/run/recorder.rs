//! What is recorded of a run: tables that see the system after each step.

use std::path::Path;

use super::chosen_outputs::ChosenOutputs;
use super::observe_error::ObserveError;
use super::output_table::{OutputTable, table_name};
use super::step_table::StepTable;
use crate::fmi::watched;
use crate::interface::Variable;
use crate::recording::{SeriesWriter, TableState};
use crate::report::EnergyLine;
use crate::system::step::{System, WishToEnd};

/// Simulated time in a part of a series on disk, s; a killed run loses less than this.
pub const PART_S: f64 = 1.0;

/// Records the series of a run.
#[derive(Default)]
pub struct Recorder {
    /// Tables that see every step.
    pub tables: Vec<StepTable>,
    /// Tables of what components give at the records.
    pub outputs: Vec<OutputTable>,
    /// The table of what goes on after the run.
    pub after: Option<OutputTable>,
    /// Exchange steps per record.
    pub every: u64,
}

impl Recorder {
    /// Begins the series of a system in `folder`, with a record every so many steps: a table for each
    /// component with those of its outputs that are chosen and numbers.
    ///
    /// # Errors
    /// When the folder cannot be written.
    pub fn of_components(
        system: &System,
        (every, chosen): (u64, &ChosenOutputs),
        folder: &Path,
    ) -> Result<Self, ObserveError> {
        let interval = every as f64 * system.clock.length;
        let per_part = (PART_S / interval).ceil() as usize;
        let mut recorder = Self { every, ..Self::default() };
        for (number, part) in system.parts.iter().enumerate() {
            let unit = part.unit.as_ref();
            let Some(name) = table_name(unit, chosen) else { continue };
            let wanted = |output: &Variable| chosen.contain(unit.name(), &output.name);
            let series = (folder, name.as_str(), per_part);
            let table = OutputTable::create(series, vec![], system, &[number], wanted)?;
            recorder.outputs.extend(table);
        }
        Ok(recorder)
    }

    /// Takes the state at communication point `k`, and records it if it is due.
    ///
    /// # Errors
    /// When a file cannot be written.
    pub fn observe(&mut self, k: u64, system: &mut System) -> Result<(), ObserveError> {
        for table in &mut self.tables {
            table.observe(k, system);
        }
        if !k.is_multiple_of(self.every) {
            return Ok(());
        }
        let time = system.clock.at(k);
        for table in &mut self.tables {
            table.record(time)?;
        }
        for table in &mut self.outputs {
            table.record(time, system)?;
        }
        self.record_after(time, system)?;
        if let Some(page) = watched::own() {
            page.note_record();
        }
        Ok(())
    }

    /// Records the end of a run within the step from point `k`, at which a part wants it.
    ///
    /// # Errors
    /// When the unit does not give its outputs, or a file cannot be written.
    pub fn record_end(
        &mut self,
        k: u64,
        end: &WishToEnd,
        system: &mut System,
    ) -> Result<(), ObserveError> {
        if end.time == system.clock.at(k) && k.is_multiple_of(self.every) {
            return Ok(());
        }
        let part = &mut system.parts[end.part];
        part.outputs.get(part.unit.as_mut())?;
        for table in &mut self.tables {
            table.observe(k + 1, system);
            table.record(end.time)?;
        }
        self.outputs.iter_mut().try_for_each(|table| table.record(end.time, system))
    }

    /// Records only what goes on after the run.
    ///
    /// # Errors
    /// When a unit does not give its outputs, or a file cannot be written.
    pub fn record_after(&mut self, time: f64, system: &mut System) -> Result<(), ObserveError> {
        self.after.as_mut().map_or(Ok(()), |table| table.record(time, system))
    }

    /// The energies that the table of that name had at the last record.
    pub fn energy(&self, name: &str) -> Vec<EnergyLine> {
        let table = self.outputs.iter().find(|table| table.name() == name);
        table.map(OutputTable::energies).unwrap_or_default()
    }

    /// What another recorder needs to go on from here.
    pub fn save(&mut self) -> Vec<TableState> {
        self.series().map(|series| series.save()).collect()
    }

    /// Goes on with the tables on disk from where they were saved.
    ///
    /// # Errors
    /// When they are other tables, do not reach as far, or cannot be written.
    pub fn resume(&mut self, saved: Vec<TableState>) -> Result<(), ObserveError> {
        for (series, saved) in self.series().zip(saved) {
            series.resume(saved)?;
        }
        Ok(())
    }

    fn series(&mut self) -> impl Iterator<Item = &mut SeriesWriter> {
        let outputs = self.outputs.iter_mut().chain(&mut self.after).map(OutputTable::series);
        self.tables.iter_mut().map(StepTable::series).chain(outputs)
    }

    /// Completes the files.
    ///
    /// # Errors
    /// When a file cannot be written.
    pub fn finish(self) -> Result<(), ObserveError> {
        self.tables.into_iter().try_for_each(StepTable::finish)?;
        self.outputs.into_iter().chain(self.after).try_for_each(OutputTable::finish)
    }
}
