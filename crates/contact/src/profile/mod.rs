//! Profiles of wheel and rail across the track.

pub(crate) mod cone;
mod point_file;
pub(crate) mod points;
mod rail_60e1;
mod rail_as60;
pub(crate) mod rail_head;
mod round_head;
mod s1002;
mod uic60_manchester;

use crate::ContactError;
use cone::Cone;
use points::PointProfile;
use rail_head::RailHead;
use std::path::Path;
use std::sync::Arc;

/// Ends of names that are files of points.
const FILES: [&str; 4] = [".prw", ".prr", ".txt", ".csv"];

/// The points of a name that is a file; nothing if it is none.
fn points_named(name: &str) -> Option<Result<PointProfile, ContactError>> {
    let is_file = FILES.iter().any(|end| name.ends_with(end));
    is_file.then(|| PointProfile::from_file(Path::new(name)))
}

/// Height and slope of a profile at one lateral place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProfilePoint {
    /// Height in m, positive downwards; 0 at the running circle of a wheel and at the top of a rail.
    pub height: f64,
    /// d height / d lateral.
    pub slope: f64,
}

/// Profile of a wheel's tread and flange, measured from the running circle.
#[derive(Clone, Debug, PartialEq)]
pub enum WheelProfile {
    /// S1002 of EN 13715.
    S1002,
    /// A conical tread with the flange of S1002.
    Cone(Cone),
    /// Points from a file.
    Points(Arc<PointProfile>),
}

impl WheelProfile {
    /// The profile of this name: `S1002`, `cone-1-20`, or a file of points.
    ///
    /// # Errors
    /// When no profile has this name; the message lists the names. When a file has no usable points.
    pub fn named(name: &str) -> Result<Self, ContactError> {
        if name == "S1002" {
            return Ok(Self::S1002);
        }
        if let Some(points) = points_named(name) {
            return Ok(Self::Points(Arc::new(points?.of_wheel()?)));
        }
        name.strip_prefix("cone-1-")
            .and_then(|ratio| ratio.parse().ok())
            .and_then(Cone::new)
            .map(Self::Cone)
            .ok_or_else(|| ContactError::UnknownWheelProfile { name: name.into() })
    }

    /// Name of the profile.
    pub fn name(&self) -> String {
        match self {
            Self::S1002 => "S1002".into(),
            Self::Cone(cone) => format!("cone-1-{}", cone.ratio()),
            Self::Points(points) => points.name().into(),
        }
    }

    /// Lateral places between which the profile is given, in m from the running circle, from the
    /// back of the flange (negative) to the field side (positive).
    pub fn range(&self) -> (f64, f64) {
        match self {
            Self::S1002 | Self::Cone(_) => s1002::RANGE,
            Self::Points(points) => points.range(),
        }
    }

    /// The profile at `lateral` metres from the running circle; outside [`Self::range`] the value
    /// at its end.
    pub fn at(&self, lateral: f64) -> ProfilePoint {
        match self {
            Self::S1002 => s1002::at(lateral),
            Self::Cone(cone) => cone.at(lateral),
            Self::Points(points) => points.at(lateral),
        }
    }

    /// Distance from the flange back to the running circle, in m (EN 13715).
    pub fn running_circle_from_flange_back(&self) -> f64 {
        0.070
    }
}

/// Profile of a rail's head, measured from its top.
#[derive(Clone, Debug, PartialEq)]
pub enum RailProfile {
    /// 60E1 of EN 13674-1, formerly UIC60.
    Rail60E1,
    /// 60 kg/m of AS 1085.1; representative (`rail_as60.rs`).
    RailAs60,
    /// UIC60 as in the points of the Manchester contact benchmark, for validation.
    Uic60Manchester,
    /// One crown radius of 300 mm and corners of 13 mm, for tests.
    Round300,
    /// Points from a file.
    Points(Arc<PointProfile>),
}

impl RailProfile {
    /// The profile of this name: `60E1`, `AS60`, `UIC60-manchester`, `round-300`, or
    /// a file of points.
    ///
    /// # Errors
    /// When no profile has this name; the message lists the names.
    pub fn named(name: &str) -> Result<Self, ContactError> {
        match name {
            "60E1" => Ok(Self::Rail60E1),
            "AS60" => Ok(Self::RailAs60),
            "UIC60-manchester" => Ok(Self::Uic60Manchester),
            "round-300" => Ok(Self::Round300),
            _ => match points_named(name) {
                Some(points) => Ok(Self::Points(Arc::new(points?.of_rail()?))),
                None => Err(ContactError::UnknownRailProfile { name: name.into() }),
            },
        }
    }

    /// Name of the profile.
    pub fn name(&self) -> String {
        match self {
            Self::Rail60E1 => "60E1",
            Self::RailAs60 => "AS60",
            Self::Uic60Manchester => "UIC60-manchester",
            Self::Round300 => "round-300",
            Self::Points(points) => points.name(),
        }
        .into()
    }

    /// The head of this rail, upright.
    pub(crate) fn head(&self) -> RailHead {
        match self {
            Self::Rail60E1 => RailHead::symmetric(&rail_60e1::ARCS),
            Self::RailAs60 => RailHead::symmetric(&rail_as60::ARCS),
            Self::Uic60Manchester => RailHead::symmetric(&uic60_manchester::ARCS),
            Self::Round300 => RailHead::symmetric(&round_head::ARCS),
            Self::Points(points) => RailHead::of_points(points),
        }
    }

    /// The upright profile at `lateral` metres from the top; outside the head the value at its end.
    pub fn at(&self, lateral: f64) -> ProfilePoint {
        self.head().at(lateral)
    }
}
