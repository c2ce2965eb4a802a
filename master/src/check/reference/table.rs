//! Signals over time: CSV with names in the first line and the time in the first column.

use std::path::Path;

use super::ReferenceError;
use crate::files::file_error::FileError;

/// Signals over time.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Table {
    /// Names of the signals.
    pub names: Vec<String>,
    /// Times of the rows, s.
    pub times: Vec<f64>,
    /// Values of the rows, in the order of the names.
    pub rows: Vec<Vec<f64>>,
}

impl Table {
    /// Reads a table.
    ///
    /// # Errors
    /// When the file cannot be read, or a cell is no number.
    pub fn read(file: &Path) -> Result<Self, ReferenceError> {
        let wrong = |error: csv::Error| ReferenceError::content(file, error);
        let mut reader =
            csv::ReaderBuilder::new().trim(csv::Trim::All).from_path(file).map_err(wrong)?;
        let header = reader.headers().map_err(wrong)?.clone();
        let mut table =
            Self { names: header.iter().skip(1).map(str::to_owned).collect(), ..Self::default() };
        for record in reader.records() {
            let record = record.map_err(wrong)?;
            let cells: Result<Vec<f64>, _> = record.iter().map(str::parse).collect();
            let cells = cells.map_err(|error| {
                let line = record.position().map_or(0, csv::Position::line);
                ReferenceError::content(file, format!("line {line}: {error}"))
            })?;
            let [time, values @ ..] = cells.as_slice() else { continue };
            table.times.push(*time);
            table.rows.push(values.to_vec());
        }
        match table.times.windows(2).all(|pair| pair[0] <= pair[1]) {
            true => Ok(table),
            false => Err(ReferenceError::content(file, "the times must not decrease")),
        }
    }

    /// Writes the table; every number is read back as it is, to the bit.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn write(&self, file: &Path) -> Result<(), ReferenceError> {
        let wrong = |error: csv::Error| ReferenceError::content(file, error);
        let mut writer = csv::Writer::from_path(file).map_err(wrong)?;
        let header = std::iter::once("time").chain(self.names.iter().map(String::as_str));
        writer.write_record(header).map_err(wrong)?;
        for (time, row) in self.times.iter().zip(&self.rows) {
            let cells = std::iter::once(time).chain(row).map(f64::to_string);
            writer.write_record(cells).map_err(wrong)?;
        }
        Ok(writer.flush().map_err(FileError::at(file))?)
    }

    /// Values at a time: on the line between the rows around it, and those of the first or last
    /// row outside; where two rows have the same time, the later holds.
    pub fn at(&self, time: f64) -> Vec<f64> {
        let after = self.times.partition_point(|row| *row <= time);
        match (after.checked_sub(1), self.rows.get(after)) {
            (None, None) => vec![],
            (None, Some(first)) => first.clone(),
            (Some(last), None) => self.rows[last].clone(),
            (Some(before), Some(next)) => {
                let (from, to) = (self.times[before], self.times[after]);
                let share = (time - from) / (to - from);
                let between = |(a, b): (&f64, &f64)| a + share * (b - a);
                self.rows[before].iter().zip(next).map(between).collect()
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_lie_on_the_line_between_rows() {
        let table = Table {
            names: vec!["force".to_owned()],
            times: vec![0.0, 1.0, 1.0, 2.0],
            rows: vec![vec![0.0], vec![10.0], vec![50.0], vec![60.0]],
        };
        let at = |time| table.at(time)[0];
        assert_eq!([at(-1.0), at(0.5), at(1.0), at(1.5), at(9.0)], [0.0, 5.0, 50.0, 55.0, 60.0]);
        assert!(Table::default().at(0.0).is_empty());
    }

    #[test]
    fn numbers_survive_a_file() {
        let file = tempfile::NamedTempFile::new().unwrap();
        let table = Table {
            names: vec!["a[1,2]".to_owned(), "b".to_owned()],
            times: vec![0.0, 0.1 + 0.2],
            rows: vec![vec![1.0 / 3.0, -1e300], vec![5e-324, 0.0]],
        };
        table.write(file.path()).unwrap();
        assert_eq!(Table::read(file.path()).unwrap(), table);
    }

    #[test]
    fn what_is_no_number_is_named_with_its_line() {
        let file = tempfile::NamedTempFile::new().unwrap();
        std::fs::write(file.path(), "time,a\n0,1\n1,x\n").unwrap();
        assert!(Table::read(file.path()).unwrap_err().to_string().contains("line 3"));
        std::fs::write(file.path(), "time,a\n1,1\n0,1\n").unwrap();
        assert!(Table::read(file.path()).unwrap_err().to_string().contains("must not decrease"));
    }
}
