//! Files of points.
//!
//! A file has a point on each line: lateral coordinate and height in millimetres, parted by blanks, commas or
//! semicolons. The lateral coordinate is measured towards the field side, from the running circle of a wheel
//! or from the middle of a rail; the height downwards. Lines that begin with `#`, `%` or `!` are comments.
//!
//! Files of CONTACT and SIMPACK (`.prw`, `.prr`) have their points between `point.begin` and `point.end`
//! in the order of a wheel or rail on the right-hand side. What their header says is done in its order:
//!
//! | key | what it does |
//! |---|---|
//! | `shift.y`, `shift.z` | are added to the coordinates and heights |
//! | `bound.y.min`, `.max`, `bound.z.min`, `.max` | leave out what lies outside, where the greater is the maximum |
//! | `mirror.y`, `mirror.z` | 1 changes the sign |
//! | `units.len.f` | lengths in the file for a metre |
//! | `inversion` | order of the points, which does not matter here |
//! | `approx.smooth`, `point.dist.min`, `rotate` | must be 0: a file is read as it is, not made smooth |

use crate::error::ContactError;

/// Farthest lateral coordinate and height of a point, m. A wheel or rail head with all of its sides is smaller.
const FARTHEST: f64 = 0.2;

/// Keys of a header that have to be zero.
const ZERO: [&str; 3] = ["approx.smooth", "point.dist.min", "rotate"];

/// What a header does to the points.
struct Header {
    shift: [f64; 2],
    /// Least and greatest coordinate and height; no bound where the least is the greater.
    bounds: [[f64; 2]; 2],
    sign: [f64; 2],
    per_metre: f64,
}

impl Header {
    /// Of a file without one.
    const NONE: Self =
        Self { shift: [0.0; 2], bounds: [[1.0, 0.0]; 2], sign: [1.0; 2], per_metre: 1e3 };

    /// Takes a line `key = value` in; lines of other keys have no effect.
    fn take(&mut self, line: &str) -> Result<(), String> {
        let Some((key, text)) = line.split_once('=') else { return Ok(()) };
        let (key, text) = (key.trim(), text.trim());
        let bound = match key {
            "shift.y" => &mut self.shift[0],
            "shift.z" => &mut self.shift[1],
            "bound.y.min" => &mut self.bounds[0][0],
            "bound.y.max" => &mut self.bounds[0][1],
            "bound.z.min" => &mut self.bounds[1][0],
            "bound.z.max" => &mut self.bounds[1][1],
            "mirror.y" => &mut self.sign[0],
            "mirror.z" => &mut self.sign[1],
            "units.len.f" => &mut self.per_metre,
            _ if ZERO.contains(&key) => &mut 0.0,
            _ => return Ok(()),
        };
        let number = text.parse().ok().filter(|number: &f64| number.is_finite());
        let value = number.ok_or_else(|| format!("{key} = {text}: expected a number"))?;
        *bound = match key {
            "mirror.y" | "mirror.z" if value == 0.0 || value == 1.0 => 1.0 - 2.0 * value,
            "mirror.y" | "mirror.z" => return Err(format!("{key} = {text}: must be 0 or 1")),
            "units.len.f" if value <= 0.0 => {
                return Err(format!("{key} = {text}: must be greater than zero"));
            }
            _ if ZERO.contains(&key) && value != 0.0 => {
                return Err(format!(
                    "{key} = {text}: must be 0; write the points as they shall be"
                ));
            }
            _ => value,
        };
        Ok(())
    }

    /// A point as the header wants it, in m; nothing if it leaves the point out.
    fn apply(&self, point: [f64; 2]) -> Option<(f64, f64)> {
        let shifted = [point[0] + self.shift[0], point[1] + self.shift[1]];
        let inside = shifted.iter().zip(&self.bounds).all(|(value, [least, greatest])| {
            least >= greatest || (least..=greatest).contains(&value)
        });
        let metres = |i: usize| self.sign[i] * shifted[i] / self.per_metre;
        inside.then(|| (metres(0), metres(1)))
    }
}

/// The points of a file in m, each with its line; `name` is for messages.
///
/// # Errors
/// When a line of points has no two numbers, a point is far from the profile's origin, or the header
/// wants what is not done here.
pub(super) fn read(text: &str, name: &str) -> Result<Vec<FilePoint>, ContactError> {
    let mut inside = !text.contains("point.begin");
    let mut header = Header::NONE;
    let mut points = Vec::new();
    for (number, line) in text.lines().enumerate() {
        let line = line.split(['!', '#', '%']).next().unwrap_or_default().trim();
        let read = match line {
            "" => continue,
            "point.begin" => {
                inside = true;
                continue;
            }
            "point.end" => {
                inside = false;
                continue;
            }
            _ if inside => point(line).map(|point| points.push((number + 1, point))),
            _ => header.take(line),
        };
        read.map_err(|reason| in_line(name, number + 1, reason))?;
    }
    let applied = points.into_iter().filter_map(|(line, point)| Some((line, header.apply(point)?)));
    applied.map(|(line, coordinates)| near(name, FilePoint { line, coordinates })).collect()
}

/// A point of a file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct FilePoint {
    /// Its line, from 1.
    pub line: usize,
    /// Lateral coordinate and height, m.
    pub coordinates: (f64, f64),
}

/// The error of a line of the file `name`.
pub(super) fn in_line(name: &str, line: usize, reason: impl std::fmt::Display) -> ContactError {
    ContactError::ProfileFile { file: name.into(), reason: format!("line {line}: {reason}") }
}

/// A length in m as messages have it, in mm to the nanometre.
pub(super) fn millimetres(length: f64) -> String {
    let exact = 1e3 * length;
    let rounded = (1e6 * exact).round() / 1e6;
    format!("{:?} mm", if rounded.is_finite() { rounded } else { exact })
}

/// Refuses a point that is far from the origin, as one in another unit is.
fn near(name: &str, point: FilePoint) -> Result<FilePoint, ContactError> {
    let (lateral, height) = point.coordinates;
    for (what, value) in [("lateral coordinate", lateral), ("height", height)] {
        if value.abs() > FARTHEST {
            return Err(in_line(
                name,
                point.line,
                format!(
                    "the {what} is {}; it must lie within {} of the origin: are the lengths in mm, with \
                     decimal points, or units.len.f as many as a metre has (1000 for mm)?",
                    millimetres(value),
                    millimetres(FARTHEST)
                ),
            ));
        }
    }
    Ok(point)
}

/// Lateral coordinate and height of a line.
fn point(line: &str) -> Result<[f64; 2], String> {
    let parted = line.split(|c: char| c.is_whitespace() || c == ',' || c == ';');
    let mut numbers = parted.filter(|part| !part.is_empty()).map(|part| part.parse::<f64>().ok());
    match (numbers.next().flatten(), numbers.next().flatten()) {
        (Some(y), Some(z)) if y.is_finite() && z.is_finite() => Ok([y, z]),
        _ => Err(format!("expected two numbers, found \"{line}\"")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEADER: &str = "header.begin\n  version = 1\nheader.end\nspline.begin\n";

    fn of_header(lines: &str) -> Result<Vec<(f64, f64)>, ContactError> {
        let text = format!("{HEADER}{lines}\npoint.begin\n10 2 ! 11 3\n-5 1\npoint.end\n");
        Ok(read(&text, "p.prw")?.iter().map(|point| point.coordinates).collect())
    }

    /// Shift, then bounds, then mirror, then units, as the header's own comments number them.
    #[test]
    fn a_header_changes_the_points_in_its_order() {
        assert_eq!(of_header("").unwrap(), [(0.01, 0.002), (-0.005, 0.001)]);
        assert_eq!(of_header("mirror.y = 1 ! 5").unwrap(), [(-0.01, 0.002), (0.005, 0.001)]);
        assert_eq!(of_header("units.len.f = +1.0e+02").unwrap(), [(0.1, 0.02), (-0.05, 0.01)]);
        let all = "shift.y = -10\nbound.y.min = -1\nbound.y.max = 1\nmirror.z = 1";
        assert_eq!(of_header(all).unwrap(), [(0.0, -0.002)]);
        let no_bounds = "bound.y.min = 1\nbound.y.max = 0\nmirror.z = 0\nrotate = 0.0";
        assert_eq!(of_header(no_bounds).unwrap().len(), 2);
    }

    #[test]
    fn what_a_header_wants_in_vain_is_answered_with_its_line() {
        let message = |lines: &str| of_header(lines).unwrap_err().to_string();
        assert!(message("rotate = 0.05").contains("p.prw: line 5: rotate = 0.05: must be 0"));
        assert!(message("approx.smooth = 2").contains("as they shall be"));
        assert!(message("mirror.y = 2").contains("must be 0 or 1"));
        assert!(message("units.len.f = -1").contains("greater than zero"));
        assert!(message("shift.y = left").contains("expected a number"));
        let words = read("0 0\n1 x\n", "p.txt").unwrap_err().to_string();
        assert!(words.contains("p.txt: line 2: expected two numbers, found \"1 x\""));
    }

    /// Such points made tables of gigabytes.
    #[test]
    fn a_point_in_another_unit_is_told_with_line_and_value() {
        let metres = of_header("units.len.f = 1").unwrap_err().to_string();
        let wanted =
            "p.prw: line 7: the lateral coordinate is 10000.0 mm; it must lie within 200.0 mm";
        assert!(metres.starts_with(wanted) && metres.contains("1000 for mm"), "{metres}");
        let height = read("0 0\n1 -1e308\n", "p.txt").unwrap_err().to_string();
        assert!(height.starts_with("p.txt: line 2: the height is -1e308 mm;"), "{height}");
        let far = read("0 0\n60000 1\n", "p.txt").unwrap_err().to_string();
        assert!(far.contains("line 2: the lateral coordinate is 60000.0 mm"), "{far}");
    }
}
