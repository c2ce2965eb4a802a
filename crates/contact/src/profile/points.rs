//! Profiles given by points (`point_file.rs` reads them).
//!
//! Between the points the profile is a cubic with the slopes of the parabolas through three points. Where
//! the points go back or straight down, as at the flank of a rail, the profile ends.

use super::point::ProfilePoint;
use super::point_file::{self, FilePoint, millimetres};
use crate::error::ContactError;
use std::ops::RangeInclusive;
use std::path::Path;

/// Ends of names that are files of points.
const FILES: [&str; 4] = [".prw", ".prr", ".txt", ".csv"];

/// Least distance of two points across the track that counts as going on, in m.
const LEAST_STEP: f64 = 1e-6;

/// Greatest distance of two points across the track, m: over a longer one the profile would be invented.
const GREATEST_STEP: f64 = 0.020;

/// Width of a wheel from its flange back to its field side, m.
const WHEEL_WIDTHS: RangeInclusive<f64> = 0.100..=0.160;

/// Height of a flange above the running circle, m.
const FLANGE_HEIGHTS: RangeInclusive<f64> = 0.020..=0.040;

/// Width of a rail's head, m.
const HEAD_WIDTHS: RangeInclusive<f64> = 0.050..=0.090;

/// Points in m, from the gauge side or flange to the field side, with the slope at each.
#[derive(Clone, Debug, PartialEq)]
pub struct PointProfile {
    name: String,
    points: Vec<(f64, f64)>,
    slopes: Vec<f64>,
}

impl PointProfile {
    /// The points of a `name` that is a file; nothing if it is none.
    pub(super) fn named(name: &str) -> Option<Result<Self, ContactError>> {
        let is_file = FILES.iter().any(|end| name.ends_with(end));
        is_file.then(|| Self::from_file(Path::new(name)))
    }

    /// Reads a file of points.
    ///
    /// # Errors
    /// When the file cannot be read, a line has no two numbers or leaves a gap, or fewer than five points
    /// are left.
    pub fn from_file(path: &Path) -> Result<Self, ContactError> {
        let file = path.display().to_string();
        let text = std::fs::read_to_string(path).map_err(|error| ContactError::ProfileFile {
            file: file.clone(),
            reason: error.to_string(),
        })?;
        Self::from_text(&text, &file)
    }

    /// The profile that `text` gives; `name` is for messages.
    ///
    /// # Errors
    /// As [`Self::from_file`].
    pub fn from_text(text: &str, name: &str) -> Result<Self, ContactError> {
        let points = point_file::read(text, name)?;
        refuse_gaps(&points, name)?;
        let profile =
            Self::new(name.into(), points.iter().map(|point| point.coordinates).collect());
        match profile.points.len() {
            0..5 => Err(profile.wrong(format!(
                "only {} points go on from the gauge side to the field side; at least 5 are needed",
                profile.points.len()
            ))),
            _ => Ok(profile),
        }
    }

    /// The error of a file that cannot be used.
    fn wrong(&self, reason: impl Into<String>) -> ContactError {
        ContactError::ProfileFile { file: self.name.clone(), reason: reason.into() }
    }

    /// Refuses a `length` in m that no wheel or rail has.
    fn ensure(
        &self,
        what: &str,
        length: f64,
        possible: RangeInclusive<f64>,
    ) -> Result<(), ContactError> {
        match possible.contains(&length) {
            true => Ok(()),
            false => Err(self.wrong(format!(
                "the {what} is {}; it must lie between {} and {}: are the lengths in the unit that \
                 the file says, mm where it says none, and are all points there?",
                millimetres(length),
                millimetres(*possible.start()),
                millimetres(*possible.end())
            ))),
        }
    }

    /// The part of the outline on which a wheel can run: from the highest point both ways as far as the
    /// lateral coordinate goes on.
    fn new(name: String, mut points: Vec<(f64, f64)>) -> Self {
        if points.first().map(|p| p.0) > points.last().map(|p| p.0) {
            points.reverse();
        }
        let mut going_on: Vec<(f64, f64)> = Vec::with_capacity(points.len());
        for point in points {
            if going_on.last().is_none_or(|last| point.0 > last.0 + LEAST_STEP) {
                going_on.push(point);
            }
        }
        let slopes = slopes(&going_on);
        Self { name, points: going_on, slopes }
    }

    /// Name of the file.
    pub(super) fn name(&self) -> &str {
        &self.name
    }

    /// First and last lateral coordinate, in m.
    pub(super) fn range(&self) -> (f64, f64) {
        let last = self.points.len() - 1;
        (self.points[0].0, self.points[last].0)
    }

    /// The profile at `lateral` metres, outside the points the value at the end.
    pub(super) fn at(&self, lateral: f64) -> ProfilePoint {
        let (begin, end) = self.range();
        let y = lateral.clamp(begin, end);
        let i = self.points.partition_point(|point| point.0 <= y);
        let i = i.clamp(1, self.points.len() - 1) - 1;
        let ((y0, z0), (y1, z1)) = (self.points[i], self.points[i + 1]);
        let (width, t) = (y1 - y0, (y - y0) / (y1 - y0));
        let (begin, end) = (width * self.slopes[i], width * self.slopes[i + 1]);
        let c2 = 3.0 * (z1 - z0) - 2.0 * begin - end;
        let c3 = begin + end - 2.0 * (z1 - z0);
        ProfilePoint {
            height: z0 + t * (begin + t * (c2 + t * c3)),
            slope: (begin + t * (2.0 * c2 + t * 3.0 * c3)) / width,
        }
    }

    /// The profile of a wheel, whose height is 0 at the running circle.
    ///
    /// # Errors
    /// When the running circle or the flange is not where a wheel has it, or its size is not a wheel's.
    pub(super) fn of_wheel(mut self) -> Result<Self, ContactError> {
        let (begin, end) = self.range();
        if begin >= 0.0 || end <= 0.0 {
            return Err(self.wrong(format!(
                "the points reach from {:.1} to {:.1} mm; the running circle, at 0, must lie between",
                1e3 * begin,
                1e3 * end
            )));
        }
        if self.lateral_of(|a, b| a > b) >= 0.0 {
            return Err(self.wrong(
                "the lowest point, the tip of the flange, must lie at a negative lateral coordinate, which \
                 counts towards the field side; heights count downwards",
            ));
        }
        self.ensure("width of the wheel", end - begin, WHEEL_WIDTHS)?;
        let level = self.at(0.0).height;
        let lowest = self.points.iter().fold(level, |lowest, point| lowest.max(point.1));
        self.ensure("height of the flange", lowest - level, FLANGE_HEIGHTS)?;
        self.points.iter_mut().for_each(|point| point.1 -= level);
        Ok(self)
    }

    /// The profile of a rail.
    ///
    /// # Errors
    /// When its highest point is an end, or its width is not that of a rail's head.
    pub(super) fn of_rail(self) -> Result<Self, ContactError> {
        let (begin, end) = self.range();
        let top = self.lateral_of(|a, b| a < b);
        if top <= begin || top >= end {
            return Err(self.wrong(
                "the highest point is an end of the head: heights count downwards, and both sides of \
                 the head are needed",
            ));
        }
        self.ensure("width of the rail's head", end - begin, HEAD_WIDTHS)?;
        Ok(self)
    }

    /// Lateral coordinate of the point that `beats` all others in height.
    fn lateral_of(&self, beats: impl Fn(f64, f64) -> bool) -> f64 {
        let best = self.points.iter().reduce(|a, b| if beats(b.1, a.1) { b } else { a });
        best.map_or(0.0, |point| point.0)
    }

    /// The profile leaning by `inclination`, with its highest point as the origin.
    pub(super) fn inclined(&self, inclination: f64) -> Self {
        let (sine, cosine) = libm::sincos(libm::atan(inclination));
        let turn = |&(y, z): &(f64, f64)| (y * cosine + z * sine, z * cosine - y * sine);
        let turned = Self::new(self.name.clone(), self.points.iter().map(turn).collect());
        let top = turned.points.iter().copied().min_by(|a, b| a.1.total_cmp(&b.1));
        let (y, z) = top.unwrap_or_default();
        let moved = turned.points.iter().map(|point| (point.0 - y, point.1 - z)).collect();
        Self::new(turned.name, moved)
    }

    /// Lateral coordinate of the gauge face `depth` metres below the top, or the gauge side's end above it.
    pub(super) fn gauge_face(&self, depth: f64) -> f64 {
        let outer = self.points.iter().zip(&self.points[1..]);
        let crossing =
            outer.take_while(|(point, _)| point.0 < 0.0).find(|(_, next)| next.1 <= depth);
        match crossing {
            Some((a, b)) if a.1 > depth => a.0 + (b.0 - a.0) * (a.1 - depth) / (a.1 - b.1),
            _ => self.points[0].0,
        }
    }
}

/// Refuses two points one after the other that are far apart across the track.
fn refuse_gaps(points: &[FilePoint], name: &str) -> Result<(), ContactError> {
    let gap = |pair: &[FilePoint]| (pair[1].coordinates.0 - pair[0].coordinates.0).abs();
    // A step may be the longest possible one as it is written, and longer by a rounding in metres.
    let Some(pair) = points.windows(2).find(|pair| gap(pair) > GREATEST_STEP + LEAST_STEP) else {
        return Ok(());
    };
    let reason = format!(
        "{} across the track from the point before; points must be at most {} apart: is the number \
         right, and are there points missing?",
        millimetres(gap(pair)),
        millimetres(GREATEST_STEP)
    );
    Err(point_file::in_line(name, pair[1].line, reason))
}

/// Slopes of the parabolas through each point and its neighbours.
fn slopes(points: &[(f64, f64)]) -> Vec<f64> {
    let count = points.len();
    let chord = |i: usize| (points[i + 1].1 - points[i].1) / (points[i + 1].0 - points[i].0);
    (0..count)
        .map(|i| match i {
            _ if count < 2 => 0.0,
            0 => chord(0),
            _ if i == count - 1 => chord(i - 1),
            _ => {
                let (before, after) =
                    (points[i].0 - points[i - 1].0, points[i + 1].0 - points[i].0);
                (after * chord(i - 1) + before * chord(i)) / (before + after)
            }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A parabola z = y²/600 mm in both formats: cubics with these slopes follow a parabola exactly on
    /// equal steps. Rounding of the four decimals written.
    #[test]
    fn analytic_points_of_a_parabola() {
        let mut lines = String::new();
        for i in -30..=30 {
            lines += &format!("{i} {:.6}\n", f64::from(i * i) / 600.0);
        }
        let plain = PointProfile::from_text(&format!("# y z\n{lines}"), "plain").unwrap();
        let block = format!(
            "header.begin\nheader.end\nunits.len.f = 1000 ! mm\npoint.begin\n{lines}point.end\n"
        );
        let simpack = PointProfile::from_text(&block, "plain").unwrap();
        assert_eq!(plain, simpack);
        for y in [-20.5e-3, 0.3e-3, 7.7e-3] {
            assert!((plain.at(y).height - y * y / 0.6).abs() < 1e-9);
            assert!((plain.at(y).slope - 2.0 * y / 0.6).abs() < 1e-6);
        }
        let leaning = plain.inclined(1.0 / 40.0);
        assert_eq!(leaning.at(0.0).height, 0.0);
        assert!((leaning.at(0.0).slope).abs() < 2e-3);
    }

    #[test]
    fn wrong_files_are_named_with_reason() {
        let message = |text: &str| PointProfile::from_text(text, "p.prw").unwrap_err().to_string();
        assert!(message("0 0\n1 1\n").contains("p.prw: only 2 points"));
        assert!(message("0 0\n0 1\n0 2\n0 3\n0 4\n0 5\n").contains("only 1 points"));
        let missing = PointProfile::from_file(Path::new("/nowhere/p.prr")).unwrap_err();
        assert!(missing.to_string().contains("/nowhere/p.prr"));
    }

    /// Places that count to the wrong side and heights that count upwards are the usual mistakes.
    #[test]
    fn profiles_the_wrong_way_round_are_told() {
        let profile = |text| PointProfile::from_text(text, "p").unwrap();
        let wheel = "-60 25\n-40 20\n-20 9\n0 0\n20 -1\n40 -2\n60 -3";
        assert_eq!(profile(wheel).of_wheel().unwrap().at(0.0).height, 0.0);
        let mirrored = "60 25\n40 20\n20 9\n0 0\n-20 -1\n-40 -2\n-60 -3";
        let message = profile(mirrored).of_wheel().unwrap_err().to_string();
        assert!(message.contains("tip of the flange"), "{message}");
        let aside = "10 25\n30 20\n50 9\n70 0\n90 -1\n110 -2";
        let message = profile(aside).of_wheel().unwrap_err().to_string();
        assert!(message.contains("from 10.0 to 110.0 mm"), "{message}");
        let upwards = "-30 -9\n-20 -4\n0 0\n20 -4\n30 -9";
        let message = profile(upwards).of_rail().unwrap_err().to_string();
        assert!(message.contains("heights count downwards"), "{message}");
    }

    /// A profile in metres is a thousandth of one, and a wheel is no rail.
    #[test]
    fn sizes_that_no_wheel_and_no_rail_has_are_told() {
        let text = |scale: f64| -> String {
            let points = [(-60, 25), (-40, 20), (-20, 9), (0, 0), (20, -1), (40, -2), (60, -3)];
            let line = |(y, z)| format!("{} {}\n", scale * f64::from(y), scale * f64::from(z));
            points.map(line).concat()
        };
        let wheel = |text: &str| {
            let profile = PointProfile::from_text(text, "p.txt")?;
            profile.of_wheel()
        };
        assert!(wheel(&text(1.0)).is_ok());
        let small = wheel(&text(0.5)).unwrap_err().to_string();
        let wanted =
            "p.txt: the width of the wheel is 60.0 mm; it must lie between 100.0 mm and 160.0 mm";
        assert!(small.starts_with(wanted), "{small}");
        let flat = wheel(&text(1.0).replace("-60 25", "-60 15").replace("-40 20", "-40 14"));
        let flat = flat.unwrap_err().to_string();
        assert!(flat.contains("the height of the flange is 15.0 mm"), "{flat}");
        let wide = "-60 9\n-40 4\n-20 1\n0 0\n20 1\n40 4\n60 9";
        let wide = PointProfile::from_text(wide, "p.prr").unwrap().of_rail().unwrap_err();
        assert!(wide.to_string().contains("the width of the rail's head is 120.0 mm"), "{wide}");
        let gap = PointProfile::from_text("-30 4\n-20 2\n0 0\n21 2\n30 4", "p.prr").unwrap_err();
        let wanted = "p.prr: line 4: 21.0 mm across the track from the point before";
        assert!(gap.to_string().starts_with(wanted), "{gap}");
    }
}
