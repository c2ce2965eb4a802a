//! Profiles given by points (`point_file.rs` reads them).
//!
//! Between the points the profile is a cubic with the slopes of the parabolas through three points. Where
//! the points go back or straight down, as at the flank of a rail, the profile ends.

use super::point::ProfilePoint;
use super::point_file;
use crate::error::ContactError;
use std::path::Path;

/// Ends of names that are files of points.
const FILES: [&str; 4] = [".prw", ".prr", ".txt", ".csv"];

/// Least distance of two points across the track that counts as going on, in m.
const LEAST_STEP: f64 = 1e-6;

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
    /// When the file cannot be read, a line has no two numbers, or fewer than five points are left.
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
        let profile = Self::new(name.into(), point_file::read(text, name)?);
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
    /// When the running circle or the flange is not where a wheel has it.
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
        let level = self.at(0.0).height;
        self.points.iter_mut().for_each(|point| point.1 -= level);
        Ok(self)
    }

    /// The profile of a rail.
    ///
    /// # Errors
    /// When its highest point is an end.
    pub(super) fn of_rail(self) -> Result<Self, ContactError> {
        let (begin, end) = self.range();
        let top = self.lateral_of(|a, b| a < b);
        if top <= begin || top >= end {
            return Err(self.wrong(
                "the highest point is an end of the head: heights count downwards, and both sides of \
                 the head are needed",
            ));
        }
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
        let wheel = "-60 25\n-40 20\n0 0\n20 -1\n40 -2\n60 -3";
        assert_eq!(profile(wheel).of_wheel().unwrap().at(0.0).height, 0.0);
        let mirrored = "60 25\n40 20\n0 0\n-20 -1\n-40 -2\n-60 -3";
        let message = profile(mirrored).of_wheel().unwrap_err().to_string();
        assert!(message.contains("tip of the flange"), "{message}");
        let aside = "10 25\n30 20\n70 0\n90 -1\n110 -2";
        let message = profile(aside).of_wheel().unwrap_err().to_string();
        assert!(message.contains("from 10.0 to 110.0 mm"), "{message}");
        let upwards = "-30 -9\n-20 -4\n0 0\n20 -4\n30 -9";
        let message = profile(upwards).of_rail().unwrap_err().to_string();
        assert!(message.contains("heights count downwards"), "{message}");
    }
}
