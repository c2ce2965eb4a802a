//! Whether the lengths of a file are those of a wheel or rail, and in which unit they would be.

use super::parsed::{FilePoint, Parsed, ProfileFormat, in_line, millimetres, wrong};
use crate::error::ContactError;
use crate::profile::kind::ProfileKind;

/// Farthest lateral coordinate and height of a point, m. A wheel or rail head with all of its sides is smaller.
const FARTHEST: f64 = 0.2;

/// Most points of a profile: 10 µm apart.
const MOST_POINTS: usize = 20_000;

/// Fewest points of a profile.
const FEWEST_POINTS: usize = 5;

/// Units with their name, how many of them a metre has, and their name in `hotfoot profile --unit`.
const UNITS: [(&str, f64, &str); 5] = [
    ("metres", 1.0, "m"),
    ("centimetres", 100.0, "cm"),
    ("millimetres", 1e3, "mm"),
    ("inches", 1e3 / 25.4, "in"),
    ("micrometres", 1e6, "um"),
];

/// Refuses a file whose points are too few, too many, or far from the origin.
pub(super) fn check_points(parsed: &Parsed, name: &str) -> Result<(), ContactError> {
    let count = parsed.points.len();
    if count < FEWEST_POINTS {
        return Err(wrong(
            name,
            format!("only {count} points are there; at least {FEWEST_POINTS} are needed"),
        ));
    }
    if count > MOST_POINTS {
        let wanted = format!(
            "there are more than {MOST_POINTS} points, the last one that can be is this one"
        );
        return Err(in_line(name, parsed.points[MOST_POINTS - 1].line, wanted));
    }
    parsed.points.iter().try_for_each(|point| near(parsed, point, name))
}

/// Refuses a point that is far from the origin, as one in another unit is.
fn near(parsed: &Parsed, point: &FilePoint, name: &str) -> Result<(), ContactError> {
    for (what, value) in [("lateral coordinate", point.at[0]), ("height", point.at[1])] {
        if value.abs() <= FARTHEST {
            continue;
        }
        let far = parsed.points.iter().filter(|point| point.at.iter().any(|v| v.abs() > FARTHEST));
        let kinds = [ProfileKind::Wheel, ProfileKind::Rail];
        let all_are = 2 * far.count() > parsed.points.len();
        let likely = if all_are { unit(parsed, extent(&parsed.points), &kinds) } else { None };
        let hint = likely.unwrap_or_else(|| {
            "is the number right, and are the lengths in mm, with decimal points, or units.len.f as \
             many as a metre has (1000 for mm)?"
                .into()
        });
        let reason = format!(
            "the {what} is {}; it must lie within {} of the origin: {hint}",
            millimetres(value),
            millimetres(FARTHEST),
        );
        return Err(in_line(name, point.line, reason));
    }
    Ok(())
}

/// Refuses a file whose width is not that of its kind, with the unit in which it would be.
///
/// The outline's own width is checked later; what fails here is in another unit or lacks a side.
pub(super) fn check_unit(
    parsed: &Parsed,
    kind: ProfileKind,
    name: &str,
) -> Result<(), ContactError> {
    let width = extent(&parsed.points);
    if width >= *kind.widths().start() || width == 0.0 {
        return Ok(());
    }
    let Some(hint) = unit(parsed, width, &[kind]) else { return Ok(()) };
    let [first, last] = [parsed.points.first(), parsed.points.last()]
        .map(|point| point.map_or(0, |point| point.line));
    let reason = format!(
        "lines {first} to {last}: the {} is {}; it must lie between {} and {}: {hint}",
        kind.width(),
        millimetres(width),
        millimetres(*kind.widths().start()),
        millimetres(*kind.widths().end()),
    );
    Err(wrong(name, reason))
}

/// The kind of a profile of this width, m: wheels are wider than rails.
pub(super) fn kind(points: &[FilePoint]) -> ProfileKind {
    match extent(points) < *ProfileKind::Wheel.widths().start() {
        true => ProfileKind::Rail,
        false => ProfileKind::Wheel,
    }
}

/// Distance of the outermost points across the track, m.
fn extent(points: &[FilePoint]) -> f64 {
    let of = |point: &FilePoint| point.at[0];
    let least = points.iter().map(of).fold(f64::INFINITY, f64::min);
    let greatest = points.iter().map(of).fold(f64::NEG_INFINITY, f64::max);
    greatest - least
}

/// The unit in which a `width` that is too small or too great would be that of one of these `kinds`, as a
/// question with the remedy.
fn unit(parsed: &Parsed, width: f64, kinds: &[ProfileKind]) -> Option<String> {
    let lengths = width * parsed.per_metre;
    let fits = |per_metre: f64| {
        per_metre != parsed.per_metre
            && kinds.iter().any(|kind| kind.widths().contains(&(lengths / per_metre)))
    };
    let (unit, per_metre, option) = UNITS.iter().find(|(_, per_metre, _)| fits(*per_metre))?;
    let remedy = match parsed.format {
        ProfileFormat::Simpack => format!("write units.len.f = {per_metre}"),
        _ => format!(
            "write them in mm, or let `hotfoot profile FILE --unit {option} --write NEW` do it"
        ),
    };
    Some(format!("are the lengths {unit}? Then {remedy}"))
}
