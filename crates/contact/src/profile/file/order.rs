//! The order of the points along the outline.

use super::parsed::{FilePoint, Parsed, in_line, millimetres};
use crate::error::ContactError;
use crate::profile::kind::ProfileKind;

/// Greatest distance of two points across the track, m: over a longer one the profile would be invented.
const GREATEST_STEP: f64 = 0.020;

/// Rounding of a step as it is written, m.
const ROUNDING: f64 = 1e-6;

/// Distance within the body from which a wheel or rail is seen, m.
const INSIDE: f64 = 0.3;

/// Brings the points into the order of the outline, from the gauge side or flange to the field side.
///
/// It is noted where the file has another one.
///
/// Seen from within the body the outline goes round from one side to the other, so that the angle sorts
/// its points. Where the points as they stand make the shorter line, they stay as they are: parts that
/// the angle would mix, such as the underside of a rail's head, are then outside of the profile.
pub(super) fn along_the_outline(parsed: &mut Parsed, kind: ProfileKind) {
    let points = &mut parsed.points;
    if points.first().map(|p| p.at[0]) > points.last().map(|p| p.at[0]) {
        points.reverse();
    }
    let middle = points.iter().map(|point| point.at[0]).sum::<f64>() / points.len() as f64;
    let towards = |point: &FilePoint| {
        // The body of a wheel is above its tread, that of a rail below its head.
        let away = match kind {
            ProfileKind::Wheel => point.at[1] + INSIDE,
            ProfileKind::Rail => INSIDE - point.at[1],
        };
        libm::atan2(point.at[0] - middle, away)
    };
    let mut sorted = points.clone();
    sorted.sort_by(|a, b| towards(a).total_cmp(&towards(b)));
    if length(&sorted) < length(points) {
        let moved = points.iter().zip(&sorted).filter(|(p, q)| p.line != q.line).count();
        parsed.points = sorted;
        parsed.notes.push(format!("{moved} points did not stand in the order of the outline"));
    }
}

/// Refuses two points one after the other that are far apart across the track.
pub(super) fn refuse_gaps(points: &[FilePoint], name: &str) -> Result<(), ContactError> {
    let gap = |pair: &[FilePoint]| (pair[1].at[0] - pair[0].at[0]).abs();
    let Some(pair) = points.windows(2).find(|pair| gap(pair) > GREATEST_STEP + ROUNDING) else {
        return Ok(());
    };
    let reason = format!(
        "{} across the track from the point before; points must be at most {} apart: is the number \
         right, and are there points missing?",
        millimetres(gap(pair)),
        millimetres(GREATEST_STEP)
    );
    Err(in_line(name, pair[0].line.max(pair[1].line), reason))
}

/// Length of the line through the points, m.
fn length(points: &[FilePoint]) -> f64 {
    let step = |pair: &[FilePoint]| {
        libm::hypot(pair[1].at[0] - pair[0].at[0], pair[1].at[1] - pair[0].at[1])
    };
    points.windows(2).map(step).sum()
}
