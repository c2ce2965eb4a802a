//! Which way round a file has a wheel or rail.
//!
//! Here the lateral coordinate counts towards the field side, from the running circle of a wheel, and
//! the height downwards. Other programs have it otherwise: MiniProf's wheels begin at the flange back,
//! GENSYS counts towards the middle of the track. The flange tells both
//! senses of a wheel, the crown the sense of a rail's height. Which side of a rail is that of the gauge
//! can be seen only if it reaches deeper than the other.

use super::parsed::{Parsed, ProfileFormat};
use super::reading::Reading;
use crate::profile::kind::ProfileKind;

/// How much deeper the gauge side of a measured rail must reach than the field side to be known by it, m.
const DEEPER: f64 = 0.005;

/// Where the tip of the flange lies if the flange back is the origin, m.
const TIP_FROM_BACK: std::ops::RangeInclusive<f64> = 0.005..=0.032;

/// How near to its origin a flange back is, m.
const AT_BACK: f64 = 0.003;

/// Slope from which on an outline is a side of the wheel, no part of its profile.
const SIDE: f64 = 20.0;

/// Turns the points round and moves their origin, and notes it.
pub(super) fn orient(parsed: &mut Parsed, kind: ProfileKind, reading: &Reading) {
    if heights_count_upwards(parsed, kind) {
        parsed.points.iter_mut().for_each(|point| point.at[1] = -point.at[1]);
        parsed.notes.push("heights count upwards in the file".into());
    }
    let mirrored = match kind {
        ProfileKind::Wheel => flange_is_positive(parsed),
        ProfileKind::Rail => gauge_is_positive(parsed) != reading.mirrored,
    };
    if mirrored {
        parsed.points.iter_mut().for_each(|point| point.at[0] = -point.at[0]);
        parsed
            .notes
            .push("lateral coordinates count towards the middle of the track in the file".into());
    }
    if kind == ProfileKind::Wheel {
        from_running_circle(parsed, reading.running_circle);
    }
}

/// Whether the flange or the sides of the head point the wrong way.
fn heights_count_upwards(parsed: &Parsed, kind: ProfileKind) -> bool {
    let points = &parsed.points;
    // Sides of a wheel reach as far up as the flange does down.
    let steep = |i: usize| {
        let [p, q] = [points[i].at, points[i + 1].at];
        (q[1] - p[1]).abs() > SIDE * (q[0] - p[0]).abs()
    };
    let count = points.len();
    let (begin, end) = match kind {
        ProfileKind::Wheel => (
            (0..count - 1).find(|&i| !steep(i)).unwrap_or(0),
            (0..count - 1).rev().find(|&i| !steep(i)).map_or(count, |i| i + 2),
        ),
        ProfileKind::Rail => (0, count),
    };
    let mut heights: Vec<f64> = points[begin..end].iter().map(|point| point.at[1]).collect();
    heights.sort_by(f64::total_cmp);
    let median = heights[heights.len() / 2];
    let (least, greatest) = (heights[0], heights[heights.len() - 1]);
    median - least > greatest - median
}

/// Whether the tip of the flange, the lowest point, lies on the greater half of the coordinates.
fn flange_is_positive(parsed: &Parsed) -> bool {
    let [least, greatest] = bounds(parsed);
    tip(parsed) > 0.5 * (least + greatest)
}

/// Whether the side of the gauge is that of the greater coordinates.
fn gauge_is_positive(parsed: &mut Parsed) -> bool {
    match parsed.format {
        ProfileFormat::Gensys => return true,
        ProfileFormat::MiniProf => {}
        ProfileFormat::Columns | ProfileFormat::Simpack => return false,
    }
    let [least, greatest] = bounds(parsed);
    let middle = 0.5 * (least + greatest);
    let deepest = |positive: bool| {
        let side = parsed.points.iter().filter(|point| (point.at[0] > middle) == positive);
        side.map(|point| point.at[1]).fold(f64::NEG_INFINITY, f64::max)
    };
    let deeper = deepest(true) - deepest(false);
    if deeper.abs() < DEEPER {
        parsed.notes.push(
            "both sides are equally deep: the negative one is taken as that of the gauge".into(),
        );
    }
    deeper >= DEEPER
}

/// Moves the origin from the flange back to the running circle, if it is there.
fn from_running_circle(parsed: &mut Parsed, running_circle: f64) {
    let [least, _] = bounds(parsed);
    let tip_fits = TIP_FROM_BACK.contains(&tip(parsed));
    if tip_fits && (parsed.format == ProfileFormat::MiniProf || least.abs() < AT_BACK) {
        parsed.points.iter_mut().for_each(|point| point.at[0] -= running_circle);
        parsed.from_flange_back = true;
        parsed.notes.push("lateral coordinates count from the flange back in the file".into());
    }
}

/// Lateral coordinate of the lowest point, m.
fn tip(parsed: &Parsed) -> f64 {
    let lowest = parsed.points.iter().max_by(|a, b| a.at[1].total_cmp(&b.at[1]));
    lowest.map_or(0.0, |point| point.at[0])
}

/// Least and greatest lateral coordinate, m.
fn bounds(parsed: &Parsed) -> [f64; 2] {
    let start = [f64::INFINITY, f64::NEG_INFINITY];
    parsed
        .points
        .iter()
        .fold(start, |[least, greatest], point| [least.min(point.at[0]), greatest.max(point.at[0])])
}
