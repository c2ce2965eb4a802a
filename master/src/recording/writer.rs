//! Writes a table while the run goes on.

use std::collections::BTreeSet;
use std::path::Path;
use std::sync::Arc;

use arrow_array::{ArrayRef, Float64Array, RecordBatch};
use arrow_schema::{ArrowError, DataType, Schema, SchemaRef};
use serde::{Deserialize, Serialize};

use super::accumulator::Accumulator;
use super::column::{Column, Key, described};
use super::parts::Parts;
use super::{RecordingError, TIME};

/// All that changes of a table while it is written and is not in its parts.
#[derive(Serialize, Deserialize)]
pub struct TableState {
    /// Number of the parts.
    parts: usize,
    /// The records behind them.
    times: Vec<f64>,
    buffers: Vec<Vec<f64>>,
    accumulator: Accumulator,
}

/// Writes one table: a row for each key at each recorded instant.
///
/// Every step is observed, every so many steps are recorded: a record holds the last value of
/// each column and, where the column asks for it, the mean, the lowest and the highest value since
/// the record before. A table without keys has one row an instant.
pub struct SeriesWriter {
    parts: Parts,
    schema: SchemaRef,
    columns: Vec<Column>,
    keys: Vec<Key>,
    rows: usize,
    records_per_part: usize,
    accumulator: Accumulator,
    times: Vec<f64>,
    /// One buffer for each field after time and keys, in the order of the schema.
    buffers: Vec<Vec<f64>>,
}

impl SeriesWriter {
    /// The table `name` in `folder`, where it begins with its first record and removes what an earlier run
    /// left of it.
    ///
    /// After every `records_per_part` records the table on disk is complete up to there.
    ///
    /// # Errors
    /// When the keys differ in length, or two columns have one name.
    pub fn create(
        folder: &Path,
        name: &str,
        keys: Vec<Key>,
        columns: Vec<Column>,
        records_per_part: usize,
    ) -> Result<Self, RecordingError> {
        let rows = keys.first().map_or(1, Key::len);
        if let Some(key) = keys.iter().find(|key| key.len() != rows) {
            return Err(RecordingError::Keys {
                table: name.to_owned(),
                key: key.name.clone(),
                found: key.len(),
                wanted: rows,
            });
        }
        let time = described(TIME, DataType::Float64, "s", "Simulated time");
        let fields: Vec<_> = std::iter::once(time)
            .chain(keys.iter().map(Key::field))
            .chain(columns.iter().flat_map(Column::fields))
            .collect();
        let mut names = BTreeSet::new();
        if let Some(field) = fields.iter().find(|field| !names.insert(field.name())) {
            let (table, column) = (name.to_owned(), field.name().clone());
            return Err(RecordingError::OneName { table, column });
        }
        let indices = |has: fn(&Column) -> bool| -> Vec<usize> {
            let wanted = columns.iter().enumerate().filter(|(_, column)| has(column));
            wanted.map(|(index, _)| index).collect()
        };
        let (means, extremes) = (indices(Column::has_mean), indices(Column::has_extremes));
        Ok(Self {
            parts: Parts::new(folder, name),
            buffers: vec![vec![]; fields.len() - 1 - keys.len()],
            schema: Arc::new(Schema::new(fields)),
            accumulator: Accumulator::new(rows, columns.len(), means, extremes),
            columns,
            keys,
            rows,
            records_per_part: records_per_part.max(1),
            times: vec![],
        })
    }

    /// Number of rows of an instant.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Takes the values of a row after a step, in the order of the columns.
    ///
    /// # Panics
    /// When `row` or the number of values is not that of the table.
    pub fn observe(&mut self, row: usize, values: &[f64]) {
        self.accumulator.observe(row, values);
    }

    /// The last values of a row, in the order of the columns; not-a-number until observed.
    pub fn last(&self, row: usize) -> &[f64] {
        self.accumulator.last_of_row(row)
    }

    /// What another writer needs to go on with the table from here.
    pub fn save(&self) -> TableState {
        TableState {
            parts: self.parts.written,
            times: self.times.clone(),
            buffers: self.buffers.clone(),
            accumulator: self.accumulator.clone(),
        }
    }

    /// Goes on with the table on disk from where it was saved; what was recorded later is removed.
    ///
    /// # Errors
    /// When another table was saved, the one on disk does not reach as far, or it cannot be written.
    pub fn resume(&mut self, saved: TableState) -> Result<(), RecordingError> {
        let TableState { parts, times, buffers, accumulator } = saved;
        let values = times.len() * self.rows;
        let fits = buffers.len() == self.buffers.len()
            && buffers.iter().all(|buffer| buffer.len() == values)
            && accumulator.is_like(&self.accumulator);
        if !fits {
            return Err(RecordingError::OtherTable { table: self.parts.joined.with_extension("") });
        }
        (self.times, self.buffers, self.accumulator) = (times, buffers, accumulator);
        self.parts.cut(&self.schema, parts, self.records_per_part * self.rows)?;
        if self.times.is_empty() {
            return Ok(());
        }
        let records = self.batch(0).map_err(RecordingError::parquet(&self.parts.joined))?;
        (0..self.times.len()).try_for_each(|record| {
            let record = records.slice(record * self.rows, self.rows);
            self.parts.append(&self.schema, Ok(record))
        })
    }

    /// Records the instant: one row for each key.
    ///
    /// # Errors
    /// When a part is complete and cannot be written.
    pub fn record(&mut self, time: f64) -> Result<(), RecordingError> {
        self.times.push(time);
        let mut buffers = self.buffers.iter_mut();
        let mut store = |values: &mut dyn Iterator<Item = f64>| {
            if let Some(buffer) = buffers.next() {
                buffer.extend(values);
            }
        };
        let (mut mean, mut extreme) = (0, 0);
        for (index, column) in self.columns.iter().enumerate() {
            store(&mut self.accumulator.last(index));
            if column.has_mean() {
                store(&mut self.accumulator.mean(mean));
                mean += 1;
            }
            if column.has_extremes() {
                store(&mut self.accumulator.lowest(extreme));
                store(&mut self.accumulator.highest(extreme));
                extreme += 1;
            }
        }
        self.accumulator.restart();
        match self.times.len() >= self.records_per_part {
            true => self.flush(),
            false => self.parts.append(&self.schema, self.batch(self.times.len() - 1)),
        }
    }

    /// Writes what is left and joins the parts into one file.
    ///
    /// # Errors
    /// When a file cannot be written.
    pub fn finish(mut self) -> Result<(), RecordingError> {
        self.flush()?;
        self.parts.join(&self.schema)
    }

    /// Writes the buffered records as a part.
    fn flush(&mut self) -> Result<(), RecordingError> {
        if self.times.is_empty() {
            return Ok(());
        }
        let batch = self.batch(0);
        self.parts.write(&self.schema, batch)?;
        self.times.clear();
        self.buffers.iter_mut().for_each(Vec::clear);
        Ok(())
    }

    /// The buffered records from number `first` on as Arrow has them.
    fn batch(&self, first: usize) -> Result<RecordBatch, ArrowError> {
        let times = &self.times[first..];
        let count = times.len();
        let times = times.iter().flat_map(|&time| std::iter::repeat_n(time, self.rows));
        let mut arrays: Vec<ArrayRef> = vec![Arc::new(times.collect::<Float64Array>())];
        arrays.extend(self.keys.iter().map(|key| key.array(count)));

        let stored = self.columns.iter().flat_map(|column| {
            let count = 1 + usize::from(column.has_mean()) + 2 * usize::from(column.has_extremes());
            std::iter::repeat_n(column, count)
        });
        let values = stored.zip(&self.buffers);
        let from = first * self.rows;
        arrays.extend(values.map(|(column, buffer)| column.array(&buffer[from..])));
        RecordBatch::try_new(self.schema.clone(), arrays)
    }
}
