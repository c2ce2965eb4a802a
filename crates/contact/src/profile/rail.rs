//! The profiles a rail can have.

use super::file::{self, Reading};
use super::kind::ProfileKind;
use super::point::ProfilePoint;
use super::points::PointProfile;
use super::rail_head::RailHead;
use super::{rail_60e1, rail_as60, round_head, uic60_manchester};
use crate::error::ContactError;
use std::sync::Arc;

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
        Self::read(name, &Reading::default())
    }

    /// The same, with a file read in this way.
    ///
    /// # Errors
    /// As [`Self::named`].
    pub fn read(name: &str, reading: &Reading) -> Result<Self, ContactError> {
        match name {
            "60E1" => Ok(Self::Rail60E1),
            "AS60" => Ok(Self::RailAs60),
            "UIC60-manchester" => Ok(Self::Uic60Manchester),
            "round-300" => Ok(Self::Round300),
            _ => match file::named(name, ProfileKind::Rail, reading) {
                Some(points) => Ok(Self::Points(Arc::new(points?))),
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
