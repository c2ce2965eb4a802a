//! Tables as comma-separated values.

use std::path::Path;

use arrow_array::RecordBatch;

use super::RecordingError;
use super::parts::table_names;
use super::reader::{SeriesReader, cell};

/// Name of the file that says what the columns are.
pub const COLUMNS: &str = "columns.csv";

/// Writes each table in the folder `series` as a CSV file into the folder `target`, anew.
///
/// The first row has the names of the columns; units and descriptions are in the file `columns.csv`.
/// Numbers have all the digits that they have in the table.
///
/// # Errors
/// When a table cannot be read, or a file not be written.
pub fn copy_as_csv(series: &Path, target: &Path) -> Result<(), RecordingError> {
    std::fs::create_dir_all(target).map_err(RecordingError::file(target))?;
    let list = target.join(COLUMNS);
    let mut columns = writer(&list)?;
    let failed = RecordingError::csv(&list);
    columns.write_record(["table", "column", "unit", "description"]).map_err(&failed)?;
    for name in table_names(series)? {
        let table = SeriesReader::open(series, &name)?;
        for field in table.columns() {
            let said = |key| field.metadata().get(key).map_or("", String::as_str);
            let row = [&name, field.name(), said("unit"), said("description")];
            columns.write_record(row).map_err(&failed)?;
        }
        copy(&table, &target.join(format!("{name}.csv")))?;
    }
    columns.flush().map_err(RecordingError::file(&list))
}

fn copy(table: &SeriesReader, file: &Path) -> Result<(), RecordingError> {
    let mut output = writer(file)?;
    let names = table.columns().map(|column| column.name());
    output.write_record(names).map_err(RecordingError::csv(file))?;
    table.each_batch(|batch| {
        let mut rows = (0..batch.num_rows()).map(|row| cells(batch, row));
        rows.try_for_each(|row| output.write_record(row)).map_err(RecordingError::csv(file))
    })?;
    output.flush().map_err(RecordingError::file(file))
}

fn writer(file: &Path) -> Result<csv::Writer<std::fs::File>, RecordingError> {
    csv::Writer::from_path(file).map_err(RecordingError::csv(file))
}

/// The values of a row.
fn cells(batch: &RecordBatch, row: usize) -> impl Iterator<Item = String> {
    batch.columns().iter().map(move |column| cell(column.as_ref(), row))
}
