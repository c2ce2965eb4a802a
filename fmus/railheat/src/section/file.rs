//! The rail file: a rail section by its dimensions (`stock/rails`).

use std::path::Path;

use files::{Check, Document, Mistake, did_you_mean};
use schemars::JsonSchema;
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

/// A rail section as its file has it.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
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
    pub fn open(name: &str) -> Result<Self, Mistake> {
        if let Some((_, text)) = KNOWN.iter().find(|(known, _)| *known == name) {
            return Self::from_toml(text, name);
        }
        let document = Document::read(Path::new(name)).map_err(|mistake| {
            let known = KNOWN.map(|(known, _)| known);
            let meant = did_you_mean(name, known);
            let known = known.join(", ");
            let sentence = format!("{}; known without a file are {known}{meant}", mistake.sentence);
            Mistake { sentence, ..mistake }
        })?;
        Self::of(&document)
    }

    /// Reads the text of a file; `name` stands in the error messages.
    ///
    /// # Errors
    /// When a value in it is not possible.
    pub fn from_toml(text: &str, name: &str) -> Result<Self, Mistake> {
        Self::of(&Document::new(name, text))
    }

    fn of(document: &Document) -> Result<Self, Mistake> {
        let file: Self = document.parse()?;
        file.check(&document.check())?;
        Ok(file)
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

    /// Refuses corners that are no closed section of the published area.
    fn check(&self, check: &Check) -> Result<(), Mistake> {
        let corners = &self.corners_mm;
        let (Some(first), Some(last)) = (corners.first(), corners.last()) else {
            return Err(check.refuse("corners_mm", "must lead from the crown to the foot"));
        };
        let value = |corner: usize, column: usize| {
            (format!("corners_mm[{}][{}]", corner + 1, column + 1), corners[corner][column])
        };
        for i in 0..corners.len() {
            for column in 0..3 {
                let (key, value) = value(i, column);
                let possible = value.is_finite() && value >= 0.0;
                check.ensure(possible, &key, value, "must be a number that is not negative")?;
            }
            let (key, height) = value(i, 1);
            let wanted =
                format!("is above the crown: must be at most height_mm = {}", self.height_mm);
            check.ensure(height <= self.height_mm, &key, height, &wanted)?;
        }
        let closed = [first[0], first[1] - self.height_mm, last[0], last[1]];
        if closed.iter().any(|gap| gap.abs() > 1e-9) {
            let why = format!(
                "the section is not closed: must begin at [0, {}] (the crown) and end at [0, 0] (the \
                 middle of the foot), but begins at [{}, {}] and ends at [{}, {}]",
                self.height_mm, first[0], first[1], last[0], last[1]
            );
            return Err(check.refuse("corners_mm", why));
        }
        let outline = self.try_outline().map_err(|corner| {
            let (key, radius) = value(corner, 2);
            let wanted = "the radius in mm does not fit between the corners before and after it";
            check.error(&key, radius, wanted)
        })?;
        let area = outline.properties().area * 1e6;
        let wanted = format!(
            "the corners enclose {area:.0} mm2: they must agree within {} %",
            100.0 * AREA_TOLERANCE
        );
        let possible = (area / self.area_mm2 - 1.0).abs() <= AREA_TOLERANCE;
        check.ensure(possible, "area_mm2", self.area_mm2, &wanted)
    }
}
