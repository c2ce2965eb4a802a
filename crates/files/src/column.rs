//! What stands in a column of comma-separated values.

use crate::mistake::Mistake;
use crate::table::Table;

/// A column that a reader knows: its schema and the bounds of its values are made of this.
#[derive(Clone, Copy, Debug)]
pub struct Column {
    /// Name in the first line of the file.
    pub name: &'static str,
    /// Unit of its values.
    pub unit: &'static str,
    /// Whether a file must have it.
    pub required: bool,
    /// Lowest and highest value that is possible.
    pub bounds: Option<[f64; 2]>,
    /// What it is.
    pub description: &'static str,
}

impl Column {
    /// The number in a row of this column, which is the `column`-th of the table, both counted from 0.
    ///
    /// # Errors
    /// When it is no number, or out of the bounds.
    pub fn value(&self, table: &Table, row: usize, column: usize) -> Result<f64, Mistake> {
        match self.bounds {
            Some(bounds) => table.number_within(row, column, bounds, self.unit),
            None => table.number(row, column),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Document;

    const SPEED: Column = Column {
        name: "speed",
        unit: "m/s",
        required: true,
        bounds: Some([0.0, 100.0]),
        description: "Speed of the train",
    };

    #[test]
    fn a_value_out_of_the_bounds_of_its_column_is_refused() {
        let document = Document::new("log.csv", "speed\n50\n101\n");
        let table = Table::new(&document).unwrap();
        assert_eq!(SPEED.value(&table, 0, 0).unwrap(), 50.0);
        let text = SPEED.value(&table, 1, 0).unwrap_err().to_string();
        assert!(
            text.starts_with("log.csv:3:1: speed = 101: must lie between 0 and 100 m/s"),
            "{text}"
        );
    }
}
