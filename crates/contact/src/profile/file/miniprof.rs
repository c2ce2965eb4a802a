//! Files of MiniProf (`.whl`, `.ban`).
//!
//! The header has a line `Key=value` for each entry; older files have free text, which a blank line
//! ends. The points follow, a line each; `ColumnDef` names the columns (`X,Y,A,C`: coordinate, height,
//! angle, curvature). Lengths are in mm; `XOffset` and `YOffset` are added. Lines that begin with `"`
//! are comments, as those with `#`, `!` and `%`. The format is known from files and readers of it that
//! are public (CONTACT's, Apache licence); there is no published description.
//!
//! A wheel's X counts from the flange back to the field side, Y towards the tip of the flange. Of a
//! rail neither the side of the gauge nor the sense of Y is the same in all files.

use super::columns::without_comment;
use super::parsed::{self, Parsed, ProfileFormat, in_line};
use crate::error::ContactError;

/// Keys of which one stands in every header.
const KEYS: [&str; 4] = ["xypoints", "columndef", "mptypeno", "mpserno"];

/// Lines within which the header begins.
const BEGINNING: usize = 40;

/// Whether `text` begins with a header of MiniProf.
pub(super) fn is_header(text: &str) -> bool {
    let known = |line: &str| {
        let line = line.trim().to_ascii_lowercase();
        line.trim_start_matches('#').starts_with("mini")
            || line.split_once('=').is_some_and(|(key, _)| KEYS.contains(&key.trim()))
    };
    text.lines().take(BEGINNING).any(known)
}

/// Reads a file of MiniProf.
///
/// # Errors
/// When an entry of the header that counts has no value that it can have, or a line no two numbers.
pub(super) fn parse(
    text: &str,
    name: &str,
    per_metre: Option<f64>,
) -> Result<Parsed, ContactError> {
    let mut header = Header::default();
    let mut begin = 0;
    for (i, line) in text.lines().enumerate() {
        begin = i;
        if header.ends_before(line) {
            break;
        }
        header.take(line).map_err(|reason| in_line(name, i + 1, reason))?;
    }
    let comment = |line: &&str| !line.trim_start().starts_with('"');
    let lines = text.lines().enumerate().skip(begin).filter(|(_, line)| comment(line));
    let lines = lines.map(|(i, line)| (i, without_comment(line)));
    let lines = lines.filter(|(_, line)| !line.is_empty());
    let per_metre = per_metre.unwrap_or(parsed::PER_METRE);
    let mut points = parsed::points(name, lines, header.columns, per_metre)?;
    for point in &mut points {
        point.at = [0, 1].map(|i| point.at[i] + header.offset[i] / per_metre);
    }
    let mut notes = vec![];
    if let Some(count) = header.count.filter(|&count| count != points.len()) {
        notes.push(format!("XYPoints = {count}, but {} points are there", points.len()));
    }
    let format = ProfileFormat::MiniProf;
    Ok(Parsed {
        format,
        kind: None,
        per_metre,
        clean: false,
        points,
        from_flange_back: false,
        notes,
    })
}

/// What the header says.
struct Header {
    /// Which columns have coordinate and height.
    columns: [usize; 2],
    /// What is added to both, in mm.
    offset: [f64; 2],
    /// Number of points.
    count: Option<usize>,
    /// Whether a line `Key=value` was there, and whether one of free text.
    keys: bool,
    free: bool,
}

impl Default for Header {
    fn default() -> Self {
        Self { columns: [0, 1], offset: [0.0; 2], count: None, keys: false, free: false }
    }
}

impl Header {
    /// Whether `line` is the first one after the header.
    fn ends_before(&self, line: &str) -> bool {
        let line = line.trim();
        if line.is_empty() {
            return self.keys || self.free;
        }
        // Numbers within free text, such as a date, are none of the profile.
        let number = |part: &str| part.replace(',', ".").parse::<f64>().is_ok();
        let mut parts = line.split([' ', '\t', ';']).filter(|part| !part.is_empty()).peekable();
        !self.free && !line.contains('=') && parts.by_ref().all(number)
    }

    fn take(&mut self, line: &str) -> Result<(), String> {
        let line = line.trim();
        if line.is_empty() || line.starts_with('"') {
            return Ok(());
        }
        let Some((key, value)) = line.split_once('=') else {
            self.free |= !self.keys;
            return Ok(());
        };
        self.keys = true;
        let (key, value) = (key.trim().to_ascii_lowercase(), value.trim());
        let number = || {
            let number = value.replace(',', ".").parse().ok().filter(|v: &f64| v.is_finite());
            number.ok_or_else(|| format!("{line}: expected a number"))
        };
        match &*key {
            _ if value.is_empty() => {}
            "xoffset" => self.offset[0] = number()?,
            "yoffset" => self.offset[1] = number()?,
            "xypoints" => self.count = value.parse().ok(),
            "columndef" => {
                let names: Vec<_> =
                    value.split(',').map(|name| name.trim().to_uppercase()).collect();
                let column = |wanted: &str| names.iter().position(|name| name == wanted);
                let (Some(x), Some(y)) = (column("X"), column("Y")) else {
                    return Err(format!("{line}: the columns X and Y are needed"));
                };
                self.columns = [x, y];
            }
            _ => {}
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn coordinates(text: &str) -> Vec<[f64; 2]> {
        parse(text, "w.whl", None).unwrap().points.iter().map(|point| point.at).collect()
    }

    /// The styles of header that public files have.
    #[test]
    fn every_style_of_header_is_read() {
        let expected = [[-0.0001, -0.022], [0.07, 0.0]];
        for header in [
            "",
            "ProgramName=MiniProf for Windows\nXoffset=0.0000\nColumnDef=X,Y\nXYPoints=2\nSd=36.14\n\n",
            "Rail=low\nXYPoints=2\nGauge=1436.91\n",
            "Filename=a.trc\nTilt=\n\"RefPoint1=\"\nRefPoint2=10.0000, 0.0000\n\n",
            "#MINIWHEELPROF\nCar_1.whl\nMINIPROF 2020\nStock.......:\n\" 32.58 37.11 14.71\n(Sd/Sh/qR)\n\n",
            "MINIPROF 101 148 1994 3 24\navg.prd\nWheel ID....:\n32.58 37.11 14.71  (Sd/Sh/qR)\n\n",
        ] {
            assert_eq!(
                coordinates(&format!("{header}-0.1 -22.0\n 70.0\t0\n")),
                expected,
                "{header}"
            );
        }
    }

    #[test]
    fn columns_and_offsets_are_those_of_the_header() {
        let text = "XOffset=1,5\nYOffset=-2\nColumnDef=A,Y,X,C\n\n0.1 3.0 70.0 0.2\n\" 9 9 9 9\n";
        let [[x, y]] = coordinates(text)[..] else { panic!("one point") };
        assert!((x - 0.0715).abs() < 1e-15 && (y - 0.001).abs() < 1e-15);
        let message = parse("ColumnDef=A,C\n\n1 2", "w.whl", None).unwrap_err().to_string();
        assert!(message.contains("w.whl: line 1: ColumnDef=A,C: the columns X and Y"), "{message}");
        let cut = parse("XYPoints=3\n\n1 2\n2 3\n", "w.whl", None).unwrap();
        assert_eq!(cut.notes, ["XYPoints = 3, but 2 points are there"]);
    }
}
