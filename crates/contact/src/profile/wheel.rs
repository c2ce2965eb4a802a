//! The profiles a wheel can have.

use super::cone::Cone;
use super::file::{self, Reading};
use super::kind::ProfileKind;
use super::point::ProfilePoint;
use super::points::PointProfile;
use super::s1002;
use crate::error::ContactError;
use std::sync::Arc;

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
        Self::read(name, &Reading::default())
    }

    /// The same, with a file read in this way.
    ///
    /// # Errors
    /// As [`Self::named`].
    pub fn read(name: &str, reading: &Reading) -> Result<Self, ContactError> {
        if name == "S1002" {
            return Ok(Self::S1002);
        }
        if let Some(points) = file::named(name, ProfileKind::Wheel, reading) {
            return Ok(Self::Points(Arc::new(points?)));
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

    /// Lateral coordinates, in m from the running circle, between which the profile is given.
    ///
    /// From the back of the flange (negative) to the field side (positive).
    pub fn range(&self) -> (f64, f64) {
        match self {
            Self::S1002 | Self::Cone(_) => s1002::RANGE,
            Self::Points(points) => points.range(),
        }
    }

    /// The profile at `lateral` metres from the running circle.
    ///
    /// Outside [`Self::range`] it is the value at its end.
    pub fn at(&self, lateral: f64) -> ProfilePoint {
        match self {
            Self::S1002 => s1002::at(lateral),
            Self::Cone(cone) => cone.at(lateral),
            Self::Points(points) => points.at(lateral),
        }
    }
}
