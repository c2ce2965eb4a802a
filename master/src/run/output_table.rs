//! A table of all outputs of a component, or of several that have the same, at the records.

use std::collections::HashMap;
use std::path::Path;

use super::chosen_outputs::{ChosenOutputs, numbers};
use super::observe_error::ObserveError;
use crate::interface::{Variable, VariableType};
use crate::recording::{Column, Key, SeriesWriter, TIME};
use crate::report::EnergyLine;
use crate::system::signals::Signals;
use crate::system::step::System;
use crate::system::unit::Unit;

/// Records outputs that are numbers.
pub struct OutputTable {
    name: String,
    series: SeriesWriter,
    columns: Vec<Column>,
    rows: Vec<Row>,
}

/// The outputs of a part.
struct Row {
    part: usize,
    outputs: Signals,
    /// Type and index of each column.
    columns: Vec<(VariableType, usize)>,
    /// Values at the last record.
    values: Vec<f64>,
}

impl OutputTable {
    /// Begins a table in `folder` with a row for each of these parts, of those outputs of the first that
    /// are `wanted`; none where there are none.
    ///
    /// # Errors
    /// When the folder cannot be written.
    pub fn create(
        (folder, name, per_part): (&Path, &str, usize),
        keys: Vec<Key>,
        system: &System,
        parts: &[usize],
        wanted: impl Fn(&Variable) -> bool,
    ) -> Result<Option<Self>, ObserveError> {
        let unit = |part: &usize| system.parts[*part].unit.as_ref();
        let Some(first) = parts.first() else { return Ok(None) };
        let columns: Vec<_> = numbers(unit(first), &wanted).into_iter().map(column).collect();
        if columns.is_empty() {
            return Ok(None);
        }
        let series = SeriesWriter::create(folder, name, keys, columns.clone(), per_part)?;
        let row = |&part: &usize| Row::new(part, &numbers(unit(&part), &wanted));
        let rows = parts.iter().map(row).collect();
        Ok(Some(Self { name: name.to_owned(), series, columns, rows }))
    }

    /// Its name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Records the parts at a time.
    ///
    /// # Errors
    /// When a unit does not give its outputs, or a file cannot be written.
    pub fn record(&mut self, time: f64, system: &mut System) -> Result<(), ObserveError> {
        for (number, row) in self.rows.iter_mut().enumerate() {
            system.parts[row.part].take(&mut row.outputs, time)?;
            row.values.clear();
            row.values.extend(row.columns.iter().map(|&(kind, i)| row.outputs.number(kind, i)));
            self.series.observe(number, &row.values);
        }
        Ok(self.series.record(time)?)
    }

    /// The energies of the first row at the last record.
    pub fn energies(&self) -> Vec<EnergyLine> {
        let values = self.columns.iter().zip(self.series.last(0));
        let energies = values.filter(|(column, _)| column.unit() == "J");
        let line = |(column, joules): (&Column, &f64)| EnergyLine {
            name: column.name().to_owned(),
            joules: *joules,
        };
        energies.map(line).collect()
    }

    /// Its series.
    pub fn series(&mut self) -> &mut SeriesWriter {
        &mut self.series
    }

    /// Completes the table.
    ///
    /// # Errors
    /// When a file cannot be written.
    pub fn finish(self) -> Result<(), ObserveError> {
        Ok(self.series.finish()?)
    }
}

impl Row {
    fn new(part: usize, variables: &[&Variable]) -> Self {
        let mut outputs = Signals::default();
        let mut column = |variable: &&Variable| {
            let index = outputs.index(variable.kind, variable.reference)?;
            Some((variable.kind, index))
        };
        let columns = variables.iter().filter_map(&mut column).collect();
        Self { part, outputs, columns, values: vec![] }
    }
}

fn column(variable: &Variable) -> Column {
    let unit = variable.unit.as_deref().unwrap_or("1");
    Column::new(column_name(variable), unit, &variable.description).double()
}

/// Name of an output's column: its own, except where the column of times has that.
fn column_name(output: &Variable) -> &str {
    match output.name.as_str() {
        TIME => "time (output)",
        name => name,
    }
}

/// Says which of the chosen outputs of a system have columns of another name.
pub fn renamed(system: &System, chosen: &ChosenOutputs) -> Vec<String> {
    let sentence = |unit: &dyn Unit| {
        let output = unit.interface().variable(TIME)?;
        let other = column_name(output);
        let component = unit.name();
        let is_recorded = output.causality == "output"
            && output.kind != VariableType::Text
            && chosen.contain(component, TIME);
        is_recorded.then(|| {
            format!(
                "the output '{TIME}' of {component} is recorded as '{other}', since '{TIME}' is the \
                 column of the simulated time"
            )
        })
    };
    system.units().filter_map(sentence).collect()
}

/// Says which components of a system would have tables of the same name, of their chosen outputs.
pub fn same_tables(system: &System, chosen: &ChosenOutputs) -> Vec<String> {
    let mut first: HashMap<String, &str> = HashMap::new();
    let mut problems = vec![];
    for unit in system.units() {
        let Some(table) = table_name(unit, chosen) else { continue };
        // Folders of some systems do not tell capitals from small letters.
        match first.get(&table.to_lowercase()) {
            Some(other) => problems.push(format!(
                "the components '{other}' and '{}' would both have the table '{table}' in the results; \
                 give one of them another name",
                unit.name()
            )),
            None => drop(first.insert(table.to_lowercase(), unit.name())),
        }
    }
    problems
}

/// Name of the table of a component: its own, as that of a file; none if none of its chosen outputs is
/// a number.
pub fn table_name(component: &dyn Unit, chosen: &ChosenOutputs) -> Option<String> {
    let plain = |c: char| if c.is_alphanumeric() || "._-[]".contains(c) { c } else { '_' };
    let name = component.name();
    let wanted = |output: &Variable| chosen.contain(name, &output.name);
    let has_numbers = !numbers(component, &wanted).is_empty();
    has_numbers.then(|| name.chars().map(plain).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recording::SeriesReader;
    use crate::system::clock::Clock;
    use crate::system::mock::Mock;
    use crate::system::part::Part;

    /// Many FMUs have an output for the time, whose name the column of times has already.
    #[test]
    fn an_output_named_time_is_recorded_beside_the_column_of_times() {
        let variables = [("time".to_owned(), "output"), ("work".to_owned(), "output")];
        let unit = Mock::new("m", &variables, &Default::default(), |values, time, length| {
            values[0] = 100.0;
            values[1] = time + length;
        });
        let clock = Clock { start: 0.0, length: 0.5 };
        let mut system = System::new(clock, vec![Part::new(Box::new(unit), 0, 1)]);
        let folder = tempfile::tempdir().unwrap();
        crate::system::parallel::pool(1).unwrap().install(|| {
            system.initialize(|_| 1.0).unwrap();
            let series = (folder.path(), "m", 1);
            let table = OutputTable::create(series, vec![], &system, &[0], |_| true).unwrap();
            let mut table = table.unwrap();
            system.step(0).unwrap();
            table.record(0.5, &mut system).unwrap();
            assert_eq!(table.energies(), [], "none of the outputs is in joules");
            table.finish().unwrap();
        });
        let table = SeriesReader::open(folder.path(), "m").unwrap();
        assert_eq!(table.read("time", &[]).unwrap(), [0.5]);
        assert_eq!(table.read("time (output)", &[]).unwrap(), [100.0]);
        assert_eq!(table.read("work", &[]).unwrap(), [0.5]);
        let sentences = renamed(&system, &ChosenOutputs::default());
        assert!(
            sentences[0].contains("'time' of m is recorded as 'time (output)'"),
            "{sentences:?}"
        );
    }

    #[test]
    fn components_whose_tables_would_have_one_name_are_both_named() {
        let part = |name| {
            let output = [("y".to_owned(), "output")];
            Part::new(Box::new(Mock::new(name, &output, &Default::default(), |_, _, _| {})), 0, 1)
        };
        let parts = vec![part("wagon 1"), part("wagon_2"), part("Wagon/1")];
        let system = System::new(Clock { start: 0.0, length: 0.5 }, parts);
        let [problem] = same_tables(&system, &ChosenOutputs::default()).try_into().unwrap();
        assert!(problem.contains("'wagon 1' and 'Wagon/1' would both have the table"), "{problem}");
    }
}
