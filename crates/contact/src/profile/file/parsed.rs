//! What stands in a file, before it is known where the wheel or rail lies in it.

use std::fmt;

use super::columns::Columns;
use crate::error::ContactError;
use crate::profile::kind::ProfileKind;

/// How a file is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ProfileFormat {
    /// Two or more columns: lateral coordinate and height.
    Columns,
    /// Columns of GENSYS: lateral coordinates count towards the middle of the track.
    Gensys,
    /// MiniProf, with a header of keys or of the old style.
    MiniProf,
    /// SIMPACK, also CONTACT: sections with keys.
    Simpack,
}

impl fmt::Display for ProfileFormat {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Columns => "columns",
            Self::Gensys => "columns of GENSYS",
            Self::MiniProf => "MiniProf",
            Self::Simpack => "SIMPACK",
        })
    }
}

/// A point of a file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct FilePoint {
    /// Its line, from 1.
    pub line: usize,
    /// Lateral coordinate and height, m.
    pub at: [f64; 2],
}

/// A file, read.
#[derive(Clone, Debug)]
pub(super) struct Parsed {
    pub format: ProfileFormat,
    /// What the header says that it is.
    pub kind: Option<ProfileKind>,
    /// Lengths in the file for a metre.
    pub per_metre: f64,
    /// Whether the points are smooth already, as the first line of a clean file says.
    pub clean: bool,
    pub points: Vec<FilePoint>,
    /// Whether the origin of the file is the flange back, not the running circle.
    pub from_flange_back: bool,
    /// What a reader should know.
    pub notes: Vec<String>,
}

/// First words of a file whose points are smooth already.
pub(super) const CLEAN: &str = "# clean profile";

/// Millimetres: what a file without a unit has.
pub(super) const PER_METRE: f64 = 1e3;

/// The points in these lines, each with its index from 0.
///
/// `at` are the columns of coordinate and height.
///
/// # Errors
/// When a line has no number in each of these columns.
pub(super) fn points<'a>(
    name: &str,
    lines: impl Iterator<Item = (usize, &'a str)> + Clone,
    at: [usize; 2],
    per_metre: f64,
) -> Result<Vec<FilePoint>, ContactError> {
    let columns = Columns::of(lines.clone().map(|(_, line)| line)).map_err(|(i, reason)| {
        in_line(name, lines.clone().nth(i).map_or(0, |line| line.0) + 1, reason)
    })?;
    let point = |(i, line): (usize, &str)| {
        let numbers = columns.numbers(line);
        let found = numbers.as_ref().and_then(|numbers| {
            Some([numbers.get(at[0])? / per_metre, numbers.get(at[1])? / per_metre])
        });
        match found {
            Some(at) => Ok(FilePoint { line: i + 1, at }),
            None => Err(in_line(name, i + 1, format!("expected two numbers, found \"{line}\""))),
        }
    };
    lines.map(point).collect()
}

/// The error of a line of the file `name`.
pub(super) fn in_line(name: &str, line: usize, reason: impl fmt::Display) -> ContactError {
    wrong(name, format!("line {line}: {reason}"))
}

/// The error of the file `name`.
pub(super) fn wrong(name: &str, reason: impl Into<String>) -> ContactError {
    ContactError::ProfileFile { file: name.into(), reason: reason.into() }
}

/// A length in m as messages have it, in mm to the nanometre.
pub(super) fn millimetres(length: f64) -> String {
    let exact = 1e3 * length;
    let rounded = (1e6 * exact).round() / 1e6;
    format!("{:?} mm", if rounded.is_finite() { rounded } else { exact })
}
