//! Rows of comma-separated values below a line with the names of the columns.

use std::iter::once;
use std::ops::Range;

use csv::{Position, Reader, ReaderBuilder, StringRecord, Trim};

use crate::document::Document;
use crate::mistake::Mistake;

/// The rows of a document.
#[derive(Debug)]
pub struct Table<'a> {
    document: &'a Document,
    names: StringRecord,
    /// The byte at which each row begins, and its values.
    rows: Vec<(usize, StringRecord)>,
}

impl<'a> Table<'a> {
    /// Takes a document apart; every row must have as many values as there are names.
    ///
    /// # Errors
    /// When one has not, or there is no row.
    pub fn new(document: &'a Document) -> Result<Self, Mistake> {
        let text = document.text();
        let mut reader = ReaderBuilder::new().trim(Trim::All).from_reader(text.as_bytes());
        let names = reader.headers().map_err(|error| broken(document, 0, &error))?.clone();
        let separators = text.lines().next().unwrap_or_default();
        if names.len() == 1 && separators.contains([';', '\t']) {
            let sentence = "values are separated by commas and have decimal points";
            let at = separators.find([';', '\t']).unwrap_or_default();
            return Err(document.mistake(at..at + 1, sentence));
        }
        let rows = rows(document, 0, reader)?;
        match rows.is_empty() {
            true => {
                let sentence = "has no rows below the names of its columns";
                Err(Mistake::in_file(document.name(), sentence))
            }
            false => Ok(Self { document, names, rows }),
        }
    }

    /// Takes these lines of a document apart, counted from 0, whose columns the file does not name.
    ///
    /// `names` are those of the first columns, in order; there may be none of such lines.
    ///
    /// # Errors
    /// When a row has not as many values as the first one.
    pub fn without_names(
        document: &'a Document,
        lines: Range<usize>,
        names: &[&str],
    ) -> Result<Self, Mistake> {
        let text = document.text();
        let ends = text.match_indices('\n').map(|(newline, _)| newline + 1);
        let begins: Vec<usize> = once(0).chain(ends).collect();
        let begin = |line: usize| begins.get(line).copied().unwrap_or(text.len());
        let bytes = begin(lines.start)..begin(lines.end);
        let reader = ReaderBuilder::new()
            .trim(Trim::All)
            .has_headers(false)
            .from_reader(&text.as_bytes()[bytes.clone()]);
        Ok(Self { document, names: names.into(), rows: rows(document, bytes.start, reader)? })
    }

    /// The names of the columns in order.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.names.iter()
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Whether there are no rows, which [`Table::new`] refuses.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// The number of the column with this name, from 0.
    pub fn column(&self, name: &str) -> Option<usize> {
        self.names().position(|own| own == name)
    }

    /// The value in a row and a column, both counted from 0, as the file has it.
    pub fn text(&self, row: usize, column: usize) -> &str {
        self.rows[row].1.get(column).unwrap_or_default()
    }

    /// The number in a row and a column, both counted from 0.
    ///
    /// # Errors
    /// When it is not a finite number.
    pub fn number(&self, row: usize, column: usize) -> Result<f64, Mistake> {
        match self.text(row, column).parse::<f64>() {
            Ok(value) if value.is_finite() => Ok(value),
            _ => Err(self.error(row, column, "must be a number")),
        }
    }

    /// The number in a row and a column, both counted from 0, of a `unit` and between `bounds`.
    ///
    /// # Errors
    /// When it is no number, or out of the bounds.
    pub fn number_within(
        &self,
        row: usize,
        column: usize,
        [low, high]: [f64; 2],
        unit: &str,
    ) -> Result<f64, Mistake> {
        let value = self.number(row, column)?;
        match (low..=high).contains(&value) {
            true => Ok(value),
            false => {
                let wanted = format!("must lie between {low} and {high} {unit}");
                Err(self.error(row, column, wanted))
            }
        }
    }

    /// A mistake in a value: its column and it as the file has it, and what would be right.
    pub fn error(&self, row: usize, column: usize, wanted: impl AsRef<str>) -> Mistake {
        let (begin, record) = &self.rows[row];
        let name = self.names.get(column).unwrap_or_default();
        let value = record.get(column).unwrap_or_default();
        let sentence = format!("{name} = {value}: {}", wanted.as_ref());
        self.document.mistake(cell(self.document.text(), *begin, column), sentence)
    }

    /// A mistake in the names of the columns.
    pub fn error_in_names(&self, sentence: impl Into<String>) -> Mistake {
        let end = self.document.text().lines().next().map_or(0, str::len);
        self.document.mistake(0..end, sentence)
    }
}

/// The rows of a reader that begins at a byte of the document, each with the byte at which it begins.
fn rows(
    document: &Document,
    from: usize,
    reader: Reader<&[u8]>,
) -> Result<Vec<(usize, StringRecord)>, Mistake> {
    let rows = reader.into_records().map(|record| {
        let record = record.map_err(|error| broken(document, from, &error))?;
        Ok((from + record.position().map_or(0, byte), record))
    });
    rows.collect()
}

/// A file that is no table, read from a byte on.
fn broken(document: &Document, from: usize, error: &csv::Error) -> Mistake {
    let begin = from + error.position().map_or(0, byte);
    let sentence = match error.kind() {
        csv::ErrorKind::UnequalLengths { expected_len, len, .. } => {
            format!("this row has {len} values, but the rows above it have {expected_len}")
        }
        _ => error.to_string(),
    };
    let line = document.text()[begin..].lines().next().unwrap_or_default();
    document.mistake(begin..begin + line.len(), sentence)
}

fn byte(position: &Position) -> usize {
    position.byte() as usize
}

/// The bytes of a value in the row that begins at byte `begin`, without the spaces around it.
fn cell(text: &str, begin: usize, column: usize) -> Range<usize> {
    // A row may begin behind line ends that the reader has passed over.
    let begin = begin + text[begin..].len() - text[begin..].trim_start_matches(['\r', '\n']).len();
    let mut in_quotes = false;
    let mut ends = text[begin..].char_indices().filter_map(|(i, c)| {
        in_quotes ^= c == '"';
        (!in_quotes && [',', '\n', '\r'].contains(&c)).then_some(begin + i)
    });
    let from = match column.checked_sub(1) {
        None => begin,
        Some(before) => ends.nth(before).map_or(text.len(), |comma| comma + 1),
    };
    let to = ends.next().unwrap_or(text.len());
    let value = &text[from..to];
    let from = from + value.len() - value.trim_start().len();
    from..from + value.trim().len()
}

#[cfg(test)]
mod tests {
    use super::*;

    const LOG: &str = "time_s,\"speed, GPS\",notch\n0, 50.5,5\n\n1.0,\"51\",x\n";

    #[test]
    fn values_are_found_by_row_and_column() {
        let log = Document::new("log.csv", LOG);
        let table = Table::new(&log).unwrap();
        assert_eq!(table.names().collect::<Vec<_>>(), ["time_s", "speed, GPS", "notch"]);
        assert_eq!((table.len(), table.is_empty()), (2, false));
        assert_eq!(table.column("notch"), Some(2));
        assert_eq!(table.column("throttle"), None);
        assert_eq!((table.number(0, 1).unwrap(), table.number(1, 1).unwrap()), (50.5, 51.0));
    }

    #[test]
    fn mistakes_have_the_line_and_the_column_of_the_value() {
        let log = Document::new("log.csv", LOG);
        let table = Table::new(&log).unwrap();
        let text = table.number(1, 2).unwrap_err().to_string();
        let wanted =
            "log.csv:4:10: notch = x: must be a number\n  |\n4 | 1.0,\"51\",x\n  |          ^";
        assert_eq!(text, wanted);
        let speed = table.error(0, 1, "is too fast").to_string();
        assert!(speed.starts_with("log.csv:2:4: speed, GPS = 50.5: is too fast"), "{speed}");
        let names = table.error_in_names("must be others").to_string();
        assert!(names.starts_with("log.csv:1:1: must be others"), "{names}");
    }

    #[test]
    fn rows_of_another_length_and_other_separators_are_answered() {
        let answer = |text: &str| {
            let file = Document::new("log.csv", text);
            Table::new(&file).unwrap_err().to_string()
        };
        let short = answer("a,b\n1,2\n3\n");
        assert!(
            short.starts_with("log.csv:3:1: this row has 1 values, but the rows above it have 2")
        );
        let semicolons = answer("time;speed\n0;12,5\n");
        assert!(
            semicolons.starts_with("log.csv:1:5: values are separated by commas"),
            "{semicolons}"
        );
        assert_eq!(answer("a,b\n"), "log.csv: has no rows below the names of its columns");
    }

    /// Weather files have lines of other kinds first, and columns without names.
    #[test]
    fn lines_without_names_keep_their_place_in_the_file() {
        let file = Document::new("year.epw", "LOCATION,Rockhampton\n\nPERIODS,1\n1,7.5\n2,x\n");
        let table = Table::without_names(&file, 3..usize::MAX, &["hour", "air"]).unwrap();
        assert_eq!((table.len(), table.number(0, 1).unwrap()), (2, 7.5));
        let text = table.number(1, 1).unwrap_err().to_string();
        assert!(text.starts_with("year.epw:5:3: air = x: must be a number"), "{text}");
        let first = Table::without_names(&file, 0..1, &["", "city"]).unwrap();
        assert_eq!((first.len(), first.text(0, 1)), (1, "Rockhampton"));
        assert!(Table::without_names(&file, 9..10, &[]).unwrap().is_empty());
        let uneven = Document::new("year.epw", "PERIODS,1\n1,7.5\n2\n");
        let text = Table::without_names(&uneven, 1..9, &[]).unwrap_err().to_string();
        assert!(text.starts_with("year.epw:3:1: this row has 1 values"), "{text}");
    }

    /// Numbers that the program cannot compute with are refused as well.
    #[test]
    fn infinite_numbers_are_no_numbers() {
        let file = Document::new("log.csv", "a\ninf\nNaN\n1e3\n");
        let table = Table::new(&file).unwrap();
        assert!(table.number(0, 0).is_err() && table.number(1, 0).is_err());
        assert_eq!(table.number(2, 0).unwrap(), 1000.0);
    }
}
