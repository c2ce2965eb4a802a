//! Whether an outline is that of a wheel or a rail.

use super::parsed::{millimetres, wrong};
use super::reading::Reading;
use crate::error::ContactError;
use crate::profile::kind::ProfileKind;
use crate::profile::points::PointProfile;
use std::ops::RangeInclusive;

/// Height of a flange above the running circle, m.
const FLANGE_HEIGHTS: RangeInclusive<f64> = 0.020..=0.040;

/// How far the flange back may lie from where it is said to be, m.
const AT_FLANGE_BACK: f64 = 0.002;

/// Slope with which an outline ends at the flange back, not at the flange's round.
const UPRIGHT: f64 = 3.0;

/// The profile of this outline, with the height 0 at a wheel's running circle; `from_flange_back` says
/// that the file's origin was the flange back.
///
/// # Errors
/// When its size is not that of its kind, or parts of it are not where they must be.
pub(super) fn checked(
    name: &str,
    kind: ProfileKind,
    outline: Vec<[f64; 2]>,
    reading: &Reading,
    from_flange_back: bool,
) -> Result<PointProfile, ContactError> {
    let profile = PointProfile::new(name.into(), kind, outline);
    if profile.count() < 5 {
        let reason = format!(
            "only {} points go on from the gauge side to the field side; at least 5 are needed",
            profile.count()
        );
        return Err(wrong(name, reason));
    }
    match kind {
        ProfileKind::Wheel => wheel(profile, reading.running_circle, from_flange_back),
        ProfileKind::Rail => rail(profile),
    }
}

fn wheel(
    profile: PointProfile,
    running_circle: f64,
    from_flange_back: bool,
) -> Result<PointProfile, ContactError> {
    let name = profile.name().to_owned();
    let (begin, end) = profile.range();
    if begin >= 0.0 || end <= 0.0 {
        let reason = format!(
            "the points reach from {:.1} to {:.1} mm; the running circle, at 0, must lie between",
            1e3 * begin,
            1e3 * end
        );
        return Err(wrong(&name, reason));
    }
    ensure(&name, ProfileKind::Wheel.width(), end - begin, ProfileKind::Wheel.widths())?;
    let level = profile.at(0.0).height;
    let lowest = profile.outline().iter().fold(level, |lowest, point| lowest.max(point[1]));
    ensure(&name, "height of the flange", lowest - level, FLANGE_HEIGHTS)?;
    let beside = -begin - running_circle;
    let upright = !from_flange_back && profile.at(begin).slope > UPRIGHT;
    if beside > AT_FLANGE_BACK || (upright && beside < -AT_FLANGE_BACK) {
        let reason = format!(
            "the flange back lies {:.1} mm from the origin, but {} are said to lie between the flange back \
             and the running circle: if the origin is the running circle of this wheel, say so with \
             running_circle_mm = {:.0} (option --running-circle-mm); else move the points",
            -1e3 * begin,
            millimetres(running_circle),
            -1e3 * begin
        );
        return Err(wrong(&name, reason));
    }
    Ok(profile.moved([0.0, -level]))
}

fn rail(profile: PointProfile) -> Result<PointProfile, ContactError> {
    let (begin, end) = profile.range();
    let [top, _] = profile.top();
    if top <= begin || top >= end {
        let reason = "the highest point is an end of the head: both sides of the head are needed";
        return Err(wrong(profile.name(), reason));
    }
    ensure(profile.name(), ProfileKind::Rail.width(), end - begin, ProfileKind::Rail.widths())?;
    Ok(profile)
}

/// Refuses a `length` in m that no wheel or rail has.
fn ensure(
    name: &str,
    what: &str,
    length: f64,
    possible: RangeInclusive<f64>,
) -> Result<(), ContactError> {
    match possible.contains(&length) {
        true => Ok(()),
        false => Err(wrong(
            name,
            format!(
                "the {what} is {}; it must lie between {} and {}: are the lengths in the unit that \
                 the file says, mm where it says none, and are all points there?",
                millimetres(length),
                millimetres(*possible.start()),
                millimetres(*possible.end())
            ),
        )),
    }
}
