//! Error measures of a column.

use std::collections::HashMap;

use serde::Serialize;

use super::grid::{Grid, How};
use super::run::Curves;
use super::texts::{percent, shown};

/// How far a column of a run is from that of another, over all rows that both have.
///
/// A difference is the other's value less the first's. What is infinite is `null` in JSON.
#[derive(Debug, Clone, Serialize)]
pub struct ColumnErrors {
    /// Name of the table.
    pub table: String,
    /// Name of the column.
    pub column: String,
    /// Unit of the values.
    pub unit: String,
    /// How the times come together.
    pub times: How,
    /// Number of these times.
    pub count: usize,
    /// Number of rows of an instant that both have.
    pub rows: usize,
    /// Largest size of a difference; infinite where only one has a finite value.
    pub max_abs: f64,
    /// Keys of the row in which it is; empty in a table without keys.
    pub row: String,
    /// When, s.
    pub at_s: f64,
    /// Root of the mean square of all differences.
    pub rms: f64,
    /// The difference of the largest size at the last of the times.
    #[serde(rename = "final")]
    pub last: f64,
    /// `max_abs` over the largest size in the first run; infinite where that is zero.
    pub relative: f64,
}

impl ColumnErrors {
    /// The relative, the largest, the mean square and the final difference as people read them.
    pub fn texts(&self) -> [String; 4] {
        let text = |value| shown(value, &self.unit);
        [percent(self.relative), text(self.max_abs), text(self.rms), text(self.last)]
    }

    /// Name of the signal that differs most, such as `wheels[1,2,left].force_normal`.
    pub fn signal(&self) -> String {
        signal(&self.table, &self.row, &self.column)
    }
}

/// Name of a signal: a column in the row with these keys.
pub(super) fn signal(table: &str, row: &str, column: &str) -> String {
    match row {
        "" => format!("{table}.{column}"),
        row => format!("{table}[{row}].{column}"),
    }
}

/// The errors of a column, of a name and a unit; none where there is no row or no time in common.
pub(super) fn of_column(
    (table, column, unit): (&str, &str, &str),
    first: &Curves,
    other: &Curves,
) -> Option<ColumnErrors> {
    let grid = Grid::of(&first.time, &other.time);
    let others: HashMap<&str, &[f64]> =
        other.rows.iter().map(|(row, values)| (row.as_str(), values.as_slice())).collect();
    let mut errors = ColumnErrors {
        table: table.to_owned(),
        column: column.to_owned(),
        unit: unit.to_owned(),
        times: grid.how,
        count: grid.time.len(),
        rows: 0,
        max_abs: -1.0,
        row: String::new(),
        at_s: grid.time.last().copied()?,
        rms: 0.0,
        last: 0.0,
        relative: 0.0,
    };
    let (mut squares, mut values, mut scale) = (0.0, 0_usize, 0.0_f64);
    for (row, own) in &first.rows {
        let Some(found) = others.get(row.as_str()) else { continue };
        errors.rows += 1;
        let (own, found) = (grid.values(0, own), grid.values(1, found));
        for ((a, b), time) in own.iter().zip(&found).zip(&grid.time) {
            let difference = difference(*a, *b);
            if difference.abs() > errors.max_abs {
                (errors.max_abs, errors.at_s) = (difference.abs(), *time);
                errors.row.clone_from(row);
            }
            squares += difference * difference;
            values += 1;
            scale = if a.is_finite() { scale.max(a.abs()) } else { scale };
            if time == grid.time.last()? && difference.abs() > errors.last.abs() {
                errors.last = difference;
            }
        }
    }
    if values == 0 {
        return None;
    }
    errors.rms = (squares / values as f64).sqrt();
    errors.relative = match errors.max_abs == 0.0 {
        true => 0.0,
        false => errors.max_abs / scale,
    };
    Some(errors)
}

/// The difference of two values; where both are no number there is none.
pub(super) fn difference(first: f64, other: f64) -> f64 {
    match (first.is_finite(), other.is_finite()) {
        (true, true) => other - first,
        (false, false) => 0.0,
        _ => f64::INFINITY,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curves(rows: &[(&str, &[f64])]) -> Curves {
        let rows = rows.iter().map(|(row, values)| ((*row).to_owned(), values.to_vec())).collect();
        Curves { time: vec![0.0, 1.0, 2.0], rows }
    }

    /// By hand: differences 0, 3, -1 and 0, 0, 2 in the rows that both have.
    #[test]
    fn analytic_errors_over_all_rows() {
        let first = curves(&[("1", &[0.0, 1.0, -4.0]), ("2", &[1.0, 1.0, 1.0]), ("3", &[9.0; 3])]);
        let other = curves(&[("2", &[1.0, 1.0, 3.0]), ("1", &[0.0, 4.0, -5.0])]);
        let errors = of_column(("t", "x", "N"), &first, &other).unwrap();
        assert_eq!((errors.rows, errors.count, errors.times), (2, 3, How::Shared));
        assert_eq!((errors.max_abs, errors.at_s, errors.signal().as_str()), (3.0, 1.0, "t[1].x"));
        assert!((errors.rms - (14.0_f64 / 6.0).sqrt()).abs() < 1e-12);
        assert_eq!((errors.last, errors.relative), (2.0, 0.75));
    }

    #[test]
    fn a_value_that_one_run_lacks_is_no_agreement() {
        let first = curves(&[("", &[0.0, f64::NAN, f64::NAN])]);
        let same = of_column(("t", "x", "N"), &first, &first).unwrap();
        assert_eq!((same.max_abs, same.relative), (0.0, 0.0));
        let other = curves(&[("", &[0.0, f64::NAN, 1.0])]);
        let errors = of_column(("t", "x", "N"), &first, &other).unwrap();
        assert!(errors.max_abs.is_infinite() && errors.relative.is_infinite());
        assert!(of_column(("t", "x", "N"), &first, &curves(&[("1", &[0.0; 3])])).is_none());
    }
}
