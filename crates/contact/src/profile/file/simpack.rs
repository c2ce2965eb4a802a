//! Files of SIMPACK and CONTACT (`.prw`, `.prr`).
//!
//! The points stand between `point.begin` and `point.end`, in the order of a wheel or rail on the
//! right-hand side. What the header says is done in its order:
//!
//! | key | what it does |
//! |---|---|
//! | `point.dist.min` | leaves out points nearer than this to the one before |
//! | `shift.y`, `shift.z` | are added to the coordinates and heights |
//! | `rotate` | turns the points about x, `units.ang.f` to a radian, from y towards z |
//! | `bound.y.min`, `.max`, `bound.z.min`, `.max` | leave out what lies outside, where the greater is the maximum |
//! | `mirror.y`, `mirror.z` | 1 changes the sign |
//! | `units.len.f` | lengths in the file for a metre |
//! | `type` | 0 a rail, 1 a wheel |
//! | `approx.smooth` | SIMPACK's own measure of smoothing: noted, the outline is smoothed to a wavelength |
//! | `inversion` | order of the points, which does not matter here |

use super::columns::without_comment;
use super::parsed::{self, FilePoint, PER_METRE, Parsed, ProfileFormat, in_line};
use crate::error::ContactError;
use crate::profile::kind::ProfileKind;

/// What a header does to the points; lengths as in the file.
struct Header {
    least_distance: f64,
    shift: [f64; 2],
    rotate: f64,
    /// Angles in the file for a radian.
    per_radian: f64,
    /// Least and greatest coordinate and height; no bound where the least is the greater.
    bounds: [[f64; 2]; 2],
    sign: [f64; 2],
    per_metre: f64,
    smooth: f64,
    kind: Option<ProfileKind>,
}

impl Header {
    /// Of a file without one.
    const NONE: Self = Self {
        least_distance: 0.0,
        shift: [0.0; 2],
        rotate: 0.0,
        per_radian: 1.0,
        bounds: [[1.0, 0.0]; 2],
        sign: [1.0; 2],
        per_metre: PER_METRE,
        smooth: 0.0,
        kind: None,
    };

    /// Takes a line `key = value` in; lines of other keys have no effect. `in_header` says whether the
    /// line stands in the section of that name, whose `type` is the kind of the profile.
    fn take(&mut self, line: &str, in_header: bool) -> Result<(), String> {
        let Some((key, text)) = line.split_once('=') else { return Ok(()) };
        let (key, text) = (key.trim(), text.trim());
        let mut kind = 0.0;
        let mut sign = 0.0;
        let value = match key {
            "point.dist.min" => &mut self.least_distance,
            "shift.y" => &mut self.shift[0],
            "shift.z" => &mut self.shift[1],
            "rotate" => &mut self.rotate,
            "units.ang.f" => &mut self.per_radian,
            "bound.y.min" => &mut self.bounds[0][0],
            "bound.y.max" => &mut self.bounds[0][1],
            "bound.z.min" => &mut self.bounds[1][0],
            "bound.z.max" => &mut self.bounds[1][1],
            "mirror.y" | "mirror.z" => &mut sign,
            "units.len.f" => &mut self.per_metre,
            "approx.smooth" => &mut self.smooth,
            "type" if in_header => &mut kind,
            _ => return Ok(()),
        };
        let number = text.parse().ok().filter(|number: &f64| number.is_finite());
        *value = number.ok_or_else(|| format!("{key} = {text}: expected a number"))?;
        let whole = |value: f64| match value {
            0.0 => Ok(false),
            1.0 => Ok(true),
            _ => Err(format!("{key} = {text}: must be 0 or 1")),
        };
        match key {
            "mirror.y" => self.sign[0] = if whole(sign)? { -1.0 } else { 1.0 },
            "mirror.z" => self.sign[1] = if whole(sign)? { -1.0 } else { 1.0 },
            "type" => {
                let kinds = [ProfileKind::Rail, ProfileKind::Wheel];
                self.kind = Some(kinds[usize::from(whole(kind)?)]);
            }
            "units.len.f" | "units.ang.f" if *value <= 0.0 => {
                return Err(format!("{key} = {text}: must be greater than zero"));
            }
            _ => {}
        }
        Ok(())
    }

    /// The points as the header wants them, in m.
    fn apply(&self, points: Vec<FilePoint>) -> Vec<FilePoint> {
        let (sine, cosine) = libm::sincos(self.rotate / self.per_radian);
        let mut kept: Vec<FilePoint> = Vec::with_capacity(points.len());
        let mut before: Option<[f64; 2]> = None;
        for point in points {
            let [y, z] = point.at;
            if before.is_some_and(|[p, q]| libm::hypot(y - p, z - q) < self.least_distance) {
                continue;
            }
            before = Some([y, z]);
            let [y, z] = [y + self.shift[0], z + self.shift[1]];
            let turned = [y * cosine - z * sine, y * sine + z * cosine];
            let inside = turned.iter().zip(&self.bounds).all(|(value, [least, greatest])| {
                least >= greatest || (least..=greatest).contains(&value)
            });
            if inside {
                let at = [0, 1].map(|i| self.sign[i] * turned[i] / self.per_metre);
                kept.push(FilePoint { at, ..point });
            }
        }
        kept
    }
}

/// Reads a file of SIMPACK. `per_metre` goes before `units.len.f`.
///
/// # Errors
/// When a key has no value that it can have, or a line of points no two numbers.
pub(super) fn parse(
    text: &str,
    name: &str,
    per_metre: Option<f64>,
) -> Result<Parsed, ContactError> {
    let (mut inside, mut in_header) = (false, false);
    let mut header = Header::NONE;
    let mut lines = vec![];
    for (i, line) in text.lines().enumerate() {
        match without_comment(line) {
            "" => {}
            "point.begin" => inside = true,
            "point.end" => inside = false,
            "header.begin" => in_header = true,
            "header.end" => in_header = false,
            line if inside => lines.push((i, line)),
            line => {
                header.take(line, in_header).map_err(|reason| in_line(name, i + 1, reason))?;
            }
        }
    }
    header.per_metre = per_metre.unwrap_or(header.per_metre);
    let points = parsed::points(name, lines.into_iter(), [0, 1], 1.0)?;
    let mut notes = vec![];
    if header.smooth != 0.0 {
        notes.push(format!(
            "approx.smooth = {} is SIMPACK's own measure, which is not followed",
            header.smooth
        ));
    }
    Ok(Parsed {
        format: ProfileFormat::Simpack,
        kind: header.kind,
        per_metre: header.per_metre,
        clean: false,
        points: header.apply(points),
        from_flange_back: false,
        notes,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEADER: &str = "header.begin\n  version = 1\nheader.end\nspline.begin\n";

    fn parsed(lines: &str) -> Result<Parsed, ContactError> {
        let text = format!("{HEADER}{lines}\npoint.begin\n10 2 ! 11 3\n-5 1 0.7\npoint.end\n");
        parse(&text, "p.prw", None)
    }

    fn of_header(lines: &str) -> Vec<[f64; 2]> {
        parsed(lines).unwrap().points.iter().map(|point| point.at).collect()
    }

    /// Shift, then rotation, bounds, mirror and units, as the header's own comments number them.
    #[test]
    fn a_header_changes_the_points_in_its_order() {
        assert_eq!(of_header(""), [[0.01, 0.002], [-0.005, 0.001]]);
        assert_eq!(of_header("mirror.y = 1 ! 5"), [[-0.01, 0.002], [0.005, 0.001]]);
        assert_eq!(of_header("units.len.f = +1.0e+02"), [[0.1, 0.02], [-0.05, 0.01]]);
        let all = "shift.y = -10\nbound.y.min = -1\nbound.y.max = 1\nmirror.z = 1";
        assert_eq!(of_header(all), [[0.0, -0.002]]);
        let no_bounds = "bound.y.min = 1\nbound.y.max = 0\nmirror.z = 0\nrotate = 0.0";
        assert_eq!(of_header(no_bounds).len(), 2);
        // A quarter turn, in degrees, takes y to z.
        let turned = of_header("units.ang.f = 57.29577951308232\nrotate = 90");
        for (found, expected) in turned.iter().zip([[-0.002, 0.01], [-0.001, -0.005]]) {
            assert!((0..2).all(|i| (found[i] - expected[i]).abs() < 1e-15), "{found:?}");
        }
        assert_eq!(of_header("point.dist.min = 16").len(), 1);
    }

    #[test]
    fn what_a_header_says_beside_the_points_is_kept() {
        let smooth = parsed("approx.smooth = 2").unwrap();
        assert!(smooth.notes[0].contains("approx.smooth = 2"), "{:?}", smooth.notes);
        let text = "header.begin\ntype = 1\nheader.end\nspline.begin\ntype = 0\npoint.begin\n1 2\npoint.end";
        assert_eq!(parse(text, "p", None).unwrap().kind, Some(ProfileKind::Wheel));
    }

    #[test]
    fn what_a_header_wants_in_vain_is_answered_with_its_line() {
        let message = |lines: &str| parsed(lines).unwrap_err().to_string();
        assert!(
            message("rotate = left").contains("p.prw: line 5: rotate = left: expected a number")
        );
        assert!(message("mirror.y = 2").contains("must be 0 or 1"));
        assert!(message("units.len.f = -1").contains("greater than zero"));
        assert!(message("shift.y = left").contains("expected a number"));
    }
}
