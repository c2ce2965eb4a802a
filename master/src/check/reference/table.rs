//! Signals over time: CSV with names in the first line and the time in the first column.

use std::path::Path;

use super::ReferenceError;
use crate::files::file_error::FileError;
use crate::interface::{Interface, VariableType};
use crate::system::structure::Value;

/// A signal of a table.
#[derive(Debug, Clone, PartialEq)]
pub struct Signal {
    /// Its name.
    pub name: String,
    /// Type of its values.
    pub kind: VariableType,
    /// Whether it keeps its value between rows.
    pub discrete: bool,
}

impl Signal {
    /// The variable of that name; a text where there is none.
    pub fn of(interface: &Interface, name: &str) -> Self {
        let variable = interface.variable(name);
        Self {
            name: name.to_owned(),
            kind: variable.map_or(VariableType::Text, |variable| variable.kind),
            discrete: variable.is_none_or(|variable| variable.discrete),
        }
    }
}

/// Signals over time.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Table {
    /// The signals.
    pub signals: Vec<Signal>,
    /// Times of the rows, s.
    pub times: Vec<f64>,
    /// Values of the rows, in the order of the signals.
    pub rows: Vec<Vec<Value>>,
}

impl Table {
    /// Reads a table of variables of an interface.
    ///
    /// # Errors
    /// When the file cannot be read, or a cell is no value of its variable.
    pub fn read(file: &Path, interface: &Interface) -> Result<Self, ReferenceError> {
        let wrong = |error: csv::Error| ReferenceError::content(file, error);
        let mut reader =
            csv::ReaderBuilder::new().trim(csv::Trim::All).from_path(file).map_err(wrong)?;
        let header = reader.headers().map_err(wrong)?.clone();
        let signals = header.iter().skip(1).map(|name| Signal::of(interface, name)).collect();
        let mut table = Self { signals, ..Self::default() };
        for record in reader.records() {
            let record = record.map_err(wrong)?;
            let line = record.position().map_or(0, csv::Position::line);
            let cell = |text: &str, kind| {
                let problem = || format!("line {line}: '{text}' is no {}", kind_name(kind));
                Value::parse(text, kind).ok_or_else(|| ReferenceError::content(file, problem()))
            };
            let mut cells = record.iter();
            let Value::Real(time) = cell(cells.next().unwrap_or_default(), VariableType::Real)?
            else {
                continue;
            };
            let values = cells.zip(&table.signals).map(|(text, signal)| cell(text, signal.kind));
            let values = values.collect::<Result<_, _>>()?;
            table.times.push(time);
            table.rows.push(values);
        }
        match table.times.windows(2).all(|pair| pair[0] <= pair[1]) {
            true => Ok(table),
            false => Err(ReferenceError::content(file, "the times must not decrease")),
        }
    }

    /// The names of the signals.
    pub fn names(&self) -> Vec<String> {
        self.signals.iter().map(|signal| signal.name.clone()).collect()
    }

    /// Leaves only the signals that are `wanted`.
    pub fn retain(&mut self, wanted: impl Fn(&Signal) -> bool) {
        let wanted: Vec<bool> = self.signals.iter().map(wanted).collect();
        let mut keep = wanted.iter().cycle();
        self.signals.retain(|_| *keep.next().unwrap_or(&true));
        for row in &mut self.rows {
            let mut keep = wanted.iter();
            row.retain(|_| *keep.next().unwrap_or(&true));
        }
    }

    /// Writes the table; every number is read back as it is, to the bit.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn write(&self, file: &Path) -> Result<(), ReferenceError> {
        let wrong = |error: csv::Error| ReferenceError::content(file, error);
        let mut writer = csv::Writer::from_path(file).map_err(wrong)?;
        let header = std::iter::once("time").chain(self.signals.iter().map(|s| s.name.as_str()));
        writer.write_record(header).map_err(wrong)?;
        for (time, row) in self.times.iter().zip(&self.rows) {
            let cells = std::iter::once(time.to_string()).chain(row.iter().map(Value::to_string));
            writer.write_record(cells).map_err(wrong)?;
        }
        Ok(writer.flush().map_err(FileError::at(file))?)
    }

    /// Values at a time: on the line between the rows around it, those that are discrete as in the row
    /// before it, and those of the first or last row outside; where two rows have the same time, the
    /// later holds.
    pub fn at(&self, time: f64) -> Vec<Value> {
        let after = self.times.partition_point(|row| *row <= time);
        match (after.checked_sub(1), self.rows.get(after)) {
            (None, None) => vec![],
            (None, Some(first)) => first.clone(),
            (Some(last), None) => self.rows[last].clone(),
            (Some(before), Some(next)) => {
                let (from, to) = (self.times[before], self.times[after]);
                let share = (time - from) / (to - from);
                let between = |(signal, (a, b)): (&Signal, (&Value, &Value))| match (a, b) {
                    (Value::Real(a), Value::Real(b)) if !signal.discrete => {
                        Value::Real(a + share * (b - a))
                    }
                    _ => a.clone(),
                };
                let pairs = self.rows[before].iter().zip(next);
                self.signals.iter().zip(pairs).map(between).collect()
            }
        }
    }
}

fn kind_name(kind: VariableType) -> &'static str {
    match kind {
        VariableType::Real => "number",
        VariableType::Integer => "whole number",
        VariableType::Boolean => "true or false",
        VariableType::Text => "text",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn interface() -> Interface {
        let variable = |name: &str, kind, discrete| crate::interface::Variable {
            name: name.to_owned(),
            reference: 0,
            kind,
            causality: "output".to_owned(),
            discrete,
            unit: None,
            si: None,
            range: crate::interface::range::Range::FINITE,
            start: None,
            description: String::new(),
        };
        Interface::of([
            variable("force", VariableType::Real, false),
            variable("notch", VariableType::Real, true),
            variable("a[1,2]", VariableType::Real, false),
            variable("count", VariableType::Integer, true),
            variable("on", VariableType::Boolean, true),
            variable("word", VariableType::Text, true),
        ])
    }

    fn table(names: &[&str], times: &[f64], rows: Vec<Vec<Value>>) -> Table {
        let signals = names.iter().map(|name| Signal::of(&interface(), name)).collect();
        Table { signals, times: times.to_vec(), rows }
    }

    #[test]
    fn values_lie_on_the_line_between_rows_or_stay_until_the_next() {
        let row = |value| vec![Value::Real(value), Value::Real(value)];
        let rows = vec![row(0.0), row(10.0), row(50.0), row(60.0)];
        let table = table(&["force", "notch"], &[0.0, 1.0, 1.0, 2.0], rows);
        for (time, force, notch) in [
            (-1.0, 0.0, 0.0),
            (0.5, 5.0, 0.0),
            (1.0, 50.0, 50.0),
            (1.5, 55.0, 50.0),
            (9.0, 60.0, 60.0),
        ] {
            assert_eq!(table.at(time), [Value::Real(force), Value::Real(notch)], "{time} s");
        }
        assert!(Table::default().at(0.0).is_empty());
    }

    #[test]
    fn values_of_all_types_survive_a_file() {
        let file = tempfile::NamedTempFile::new().unwrap();
        let text = |text: &str| Value::Text(text.to_owned());
        let rows = vec![
            vec![
                Value::Real(1.0 / 3.0),
                Value::Integer(-7),
                Value::Boolean(true),
                text("a, \"b\""),
            ],
            vec![Value::Real(5e-324), Value::Integer(0), Value::Boolean(false), text("")],
        ];
        let table = table(&["a[1,2]", "count", "on", "word"], &[0.0, 0.1 + 0.2], rows);
        table.write(file.path()).unwrap();
        assert_eq!(Table::read(file.path(), &interface()).unwrap(), table);
        let mut words = table;
        words.retain(|signal| signal.kind == VariableType::Text);
        assert_eq!((words.names(), &words.rows[1]), (vec!["word".to_owned()], &vec![text("")]));
    }

    #[test]
    fn what_is_no_value_is_named_with_its_line() {
        let file = tempfile::NamedTempFile::new().unwrap();
        for (content, wanted) in [
            ("time,force\n0,1\n1,x\n", "line 3: 'x' is no number"),
            ("time,count\n0,1.5\n", "line 2: '1.5' is no whole number"),
            ("time,on\n0,yes\n", "'yes' is no true or false"),
            ("time,force\n1,1\n0,1\n", "must not decrease"),
        ] {
            std::fs::write(file.path(), content).unwrap();
            let error = Table::read(file.path(), &interface()).unwrap_err().to_string();
            assert!(error.contains(wanted), "{error}");
        }
    }
}
