//! Coordinates and attributes of a field.

use serde_json::Value;

/// Where the values of a snapshot lie.
#[derive(Clone, Debug, PartialEq)]
pub struct Axes {
    /// Chainage of the middle of each element, m.
    pub chainage: Vec<f64>,
    /// Depth of the middle of each cell below the running surface, m.
    pub depth: Vec<f64>,
    /// The cells of the whole section and where it is kept, if the rail has one.
    pub sections: Option<Sections>,
}

/// The cells of the section, and the places at which its rise is kept throughout.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sections {
    /// Chainage of each place, m; there may be none.
    pub chainage: Vec<f64>,
    /// Middle of each cell, to the right of the rail's middle, m.
    pub y: Vec<f64>,
    /// Middle of each cell, below the running surface, m.
    pub z: Vec<f64>,
    /// Area of steel in each cell, m².
    pub area: Vec<f64>,
}

/// The rises of sections in one snapshot; nothing of a rail without a whole section.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SectionRises {
    /// Rise at the places, K; the cells of the first place first.
    pub kept: Vec<f32>,
    /// Rise where the foot is warmest, K.
    pub warmest: Vec<f32>,
    /// Chainage at which that is, m.
    pub warmest_chainage: f64,
}

impl Sections {
    /// Number of values of one snapshot at the places.
    pub fn values(&self) -> usize {
        self.chainage.len() * self.y.len()
    }
}

impl Axes {
    /// Number of values of one snapshot.
    pub fn values(&self) -> usize {
        self.chainage.len() * self.depth.len()
    }
}

/// Something worth knowing about the whole field, such as the initial temperature.
#[derive(Clone, Debug, PartialEq)]
pub enum Attribute {
    /// A number; its unit belongs in the attribute's name, such as `initial_temperature_K`.
    Number(f64),
    /// Text.
    Text(String),
}

impl From<f64> for Attribute {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl From<&str> for Attribute {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

impl From<&Attribute> for Value {
    fn from(attribute: &Attribute) -> Self {
        match attribute {
            Attribute::Number(number) => Self::from(*number),
            Attribute::Text(text) => Self::from(text.as_str()),
        }
    }
}
