//! The rail file: a rail section by its dimensions (`stock/rails`).

use std::path::Path;

use serde::Deserialize;

use super::outline::{Corner, Outline, Point};

/// How far the area of the corners may be from the published one.
const AREA_TOLERANCE: f64 = 0.02;

/// The sections that need no file.
const KNOWN: [(&str, &str); 3] = [
    ("AS60", include_str!("../../../../stock/rails/AS60.toml")),
    ("60E1", include_str!("../../../../stock/rails/60E1.toml")),
    ("136RE", include_str!("../../../../stock/rails/136RE.toml")),
];

/// Why a rail file cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum RailFileError {
    /// The file cannot be read.
    #[error("rail section {name}: {source}; known without a file are AS60, 60E1 and 136RE")]
    Read {
        /// Name or path.
        name: String,
        /// Reason.
        source: std::io::Error,
    },
    /// The file is not TOML, or has an unknown key or a wrong type.
    #[error("rail section {name}: {source}")]
    Syntax {
        /// Name or path.
        name: String,
        /// Reason, with line and caret.
        source: Box<toml::de::Error>,
    },
    /// A value is not possible.
    #[error("rail section {name}: {what}")]
    Value {
        /// Name or path.
        name: String,
        /// Key, value, what would be right.
        what: String,
    },
}

/// A rail section as its file has it.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RailFile {
    /// Name of the section.
    pub name: String,
    /// Where the numbers come from.
    pub source: String,
    /// Height, mm.
    pub height_mm: f64,
    /// Published area, mm².
    pub area_mm2: f64,
    /// Published height of the centroid above the foot, mm.
    pub centroid_above_foot_mm: f64,
    /// Published second moment about the horizontal axis, mm⁴.
    pub second_moment_mm4: f64,
    /// Corners of the right half from the crown to the middle of the foot, mm.
    ///
    /// Each has a half width, a height above the foot and the radius of its fillet.
    corners_mm: Vec<[f64; 3]>,
}

impl RailFile {
    /// A known section, or the file at a path.
    ///
    /// # Errors
    /// When there is no such section or file, or a value in it is not possible.
    pub fn open(name: &str) -> Result<Self, RailFileError> {
        if let Some((_, text)) = KNOWN.iter().find(|(known, _)| *known == name) {
            return Self::from_toml(text, name);
        }
        let text = std::fs::read_to_string(Path::new(name))
            .map_err(|source| RailFileError::Read { name: name.to_owned(), source })?;
        Self::from_toml(&text, name)
    }

    /// Reads the text of a file; `name` stands in the error messages.
    ///
    /// # Errors
    /// When a value in it is not possible.
    pub fn from_toml(text: &str, name: &str) -> Result<Self, RailFileError> {
        let file: Self = toml::from_str(text).map_err(|source| RailFileError::Syntax {
            name: name.to_owned(),
            source: Box::new(source),
        })?;
        match file.fault() {
            Some(what) => Err(RailFileError::Value { name: name.to_owned(), what }),
            None => Ok(file),
        }
    }

    /// The outline in metres.
    pub fn outline(&self) -> Outline {
        self.try_outline().expect("checked when the file was read")
    }

    fn try_outline(&self) -> Result<Outline, usize> {
        let corner = |[half_width, height, radius]: &[f64; 3]| Corner {
            point: Point { y: half_width * 1e-3, z: (self.height_mm - height) * 1e-3 },
            radius: radius * 1e-3,
        };
        Outline::from_right_half(&self.corners_mm.iter().map(corner).collect::<Vec<_>>())
    }

    /// What is wrong with the file, in words.
    fn fault(&self) -> Option<String> {
        let corners = &self.corners_mm;
        let (Some(first), Some(last)) = (corners.first(), corners.last()) else {
            return Some("corners_mm is empty: must lead from the crown to the foot".to_owned());
        };
        if corners.iter().flatten().any(|value| !(value.is_finite() && *value >= 0.0)) {
            return Some(
                "corners_mm: every value must be a number that is not negative".to_owned(),
            );
        }
        if let Some(index) = corners.iter().position(|corner| corner[1] > self.height_mm) {
            return Some(format!(
                "corners_mm[{}]: the height {} is above the crown: must be at most height_mm = {}",
                index + 1,
                corners[index][1],
                self.height_mm
            ));
        }
        let closed = [first[0], first[1] - self.height_mm, last[0], last[1]];
        if closed.iter().any(|gap| gap.abs() > 1e-9) {
            return Some(format!(
                "the section is not closed: corners_mm must begin at [0, {}] (the crown) and end \
                 at [0, 0] (the middle of the foot), but begins at [{}, {}] and ends at [{}, {}]",
                self.height_mm, first[0], first[1], last[0], last[1]
            ));
        }
        let outline = match self.try_outline() {
            Ok(outline) => outline,
            Err(index) => {
                let (number, radius) = (index + 1, corners[index][2]);
                return Some(format!(
                    "corners_mm[{number}]: the radius {radius} mm does not fit between the corners \
                     before and after it"
                ));
            }
        };
        let area = outline.properties().area * 1e6;
        if (area / self.area_mm2 - 1.0).abs() <= AREA_TOLERANCE {
            return None;
        }
        Some(format!(
            "the corners enclose {area:.0} mm2, but area_mm2 = {}: they must agree within {} %",
            self.area_mm2,
            100.0 * AREA_TOLERANCE
        ))
    }
}
