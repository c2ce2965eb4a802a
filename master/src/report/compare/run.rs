//! The tables of a run as curves over time.

use std::collections::HashSet;
use std::path::{Path, PathBuf};

use arrow_schema::{DataType, Field};
use serde::Deserialize;

use super::about::About;
use super::error::CompareError;
use crate::files::file_error::read_toml;
use crate::recording::{SeriesReader, TIME, table_names};
use crate::report::provenance::Provenance;

/// A run.
pub(super) struct Run {
    /// Its folder.
    pub folder: PathBuf,
    /// What it is.
    pub about: About,
    /// What its manifest says of where it comes from.
    pub provenance: Provenance,
    /// Step of the exchange, s.
    pub step: Option<f64>,
    /// Its tables.
    pub tables: Vec<Table>,
}

/// The part of a manifest that is needed here.
#[derive(Deserialize)]
struct Manifest {
    #[serde(flatten)]
    provenance: Provenance,
    run: Option<Step>,
    system: Option<Step>,
}

#[derive(Deserialize)]
struct Step {
    step_s: f64,
}

/// A table.
pub(super) struct Table {
    /// Its name.
    pub name: String,
    reader: SeriesReader,
    /// Keys of the rows of an instant, such as `2,1,left`.
    rows: Vec<String>,
    /// Times of the records, s.
    time: Vec<f64>,
}

/// A column of a table: a curve for each row of an instant.
pub(super) struct Curves {
    /// Times, s.
    pub time: Vec<f64>,
    /// Keys of the rows, with their values at these times.
    pub rows: Vec<(String, Vec<f64>)>,
}

impl Run {
    /// Opens a folder of results.
    pub fn open(folder: &Path) -> Result<Self, CompareError> {
        let Manifest { provenance, run, system } = read_toml(&folder.join("manifest.toml"))?;
        let series = folder.join("series");
        let open = |name: String| Table::open(&series, name);
        let tables = table_names(&series)?.into_iter().map(open).collect::<Result<_, _>>()?;
        let about = About {
            name: folder.display().to_string(),
            command: provenance.command.clone(),
            begun: provenance.begun.clone(),
            version: format!("{} ({})", provenance.hotfoot_version, provenance.git_commit),
            simulated_s: Some(provenance.simulated_s),
            end: provenance.end.clone(),
        };
        let step = run.or(system).map(|facts| facts.step_s);
        Ok(Self { folder: folder.to_owned(), about, provenance, step, tables })
    }

    /// Number of columns that can be compared.
    pub fn column_count(&self) -> usize {
        self.tables.iter().map(|table| table.columns().count()).sum()
    }

    /// The curves of a column; none where there is no such table or column.
    pub fn curves(&self, table: &str, column: &str) -> Result<Option<Curves>, CompareError> {
        let table = self.tables.iter().find(|own| own.name == table);
        let Some(table) = table.filter(|table| table.columns().any(|(own, _)| own == column))
        else {
            return Ok(None);
        };
        table.curves(column).map(Some)
    }

    /// Columns that another run has not.
    pub fn columns_beyond(&self, other: &Self) -> Vec<String> {
        let others: HashSet<String> = other.columns().collect();
        self.columns().filter(|column| !others.contains(column)).collect()
    }

    fn columns(&self) -> impl Iterator<Item = String> {
        self.tables
            .iter()
            .flat_map(|table| table.columns().map(|(column, _)| format!("{}.{column}", table.name)))
    }
}

impl Table {
    fn open(series: &Path, name: String) -> Result<Self, CompareError> {
        let reader = SeriesReader::open(series, &name)?;
        let rows = reader.rows()?;
        let time = reader.read(TIME, &[])?.into_iter().step_by(rows.len().max(1)).collect();
        Ok(Self { name, reader, rows, time })
    }

    /// Names and units of the columns that are no keys.
    pub fn columns(&self) -> impl Iterator<Item = (String, String)> {
        let is_value = |field: &&Field| {
            *field.name() != TIME
                && matches!(field.data_type(), DataType::Float64 | DataType::Float32)
        };
        self.reader.columns().filter(is_value).map(|field| {
            let unit = field.metadata().get("unit").map_or("1", String::as_str);
            (field.name().clone(), unit.to_owned())
        })
    }

    /// Keys of the rows of an instant.
    pub fn rows(&self) -> &[String] {
        &self.rows
    }

    /// The curves of a column.
    pub fn curves(&self, column: &str) -> Result<Curves, CompareError> {
        let values = self.reader.read(column, &[])?;
        let count = self.rows.len().max(1);
        let of_row = |(number, row): (usize, &String)| {
            (row.clone(), values.iter().copied().skip(number).step_by(count).collect())
        };
        let rows = self.rows.iter().enumerate().map(of_row).collect();
        Ok(Curves { time: self.time.clone(), rows })
    }
}
