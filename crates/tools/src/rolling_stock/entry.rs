//! An entry of the library with its figures.

use serde::Serialize;

/// What an entry is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Kind {
    /// A vehicle type.
    Vehicle,
    /// A draft gear.
    DraftGear,
    /// A rail as a body that heat flows through.
    RailSection,
    /// The head of a rail as wheels touch it.
    RailProfile,
    /// Tread and flange of a wheel.
    WheelProfile,
}

impl Kind {
    /// Its plural for people.
    pub fn plural(self) -> &'static str {
        match self {
            Self::Vehicle => "Vehicles",
            Self::DraftGear => "Draft gears",
            Self::RailSection => "Rail sections",
            Self::RailProfile => "Rail profiles",
            Self::WheelProfile => "Wheel profiles",
        }
    }
}

/// An entry of the library.
#[derive(Debug, Clone, Serialize)]
pub struct Entry {
    /// What it is.
    pub kind: Kind,
    /// Its name in files.
    pub name: String,
    /// Its name for people.
    pub title: String,
    /// The file; none for what needs none.
    pub file: Option<String>,
    /// Where the figures are from.
    pub source: String,
    /// Its figures, the main ones among them.
    pub figures: Vec<Figure>,
}

/// A figure with its unit.
#[derive(Debug, Clone, Serialize)]
pub struct Figure {
    /// What it is.
    pub name: &'static str,
    /// A number or words.
    pub value: Value,
    /// Unit of a number; "1" for a plain one, empty for words.
    pub unit: &'static str,
    /// Digits behind the point in texts.
    #[serde(skip)]
    decimals: usize,
    /// Whether a list of all entries shows it.
    #[serde(skip)]
    pub is_main: bool,
}

/// A number or words.
#[derive(Debug, Clone, Serialize)]
#[serde(untagged)]
pub enum Value {
    /// A number.
    Number(f64),
    /// Words.
    Text(String),
}

impl Figure {
    /// A number with so many digits behind the point.
    pub(super) fn number(
        name: &'static str,
        value: f64,
        unit: &'static str,
        decimals: usize,
    ) -> Self {
        Self { name, value: Value::Number(value), unit, decimals, is_main: false }
    }

    /// A count.
    pub(super) fn count(name: &'static str, value: usize) -> Self {
        Self::number(name, value as f64, "1", 0)
    }

    /// Words.
    pub(super) fn text(name: &'static str, value: impl Into<String>) -> Self {
        Self { name, value: Value::Text(value.into()), unit: "", decimals: 0, is_main: false }
    }

    /// The figure as one of the main ones.
    #[must_use]
    pub(super) fn main(self) -> Self {
        Self { is_main: true, ..self }
    }
}

impl std::fmt::Display for Figure {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { value, unit, decimals, .. } = self;
        let decimals = *decimals;
        match (value, *unit) {
            (Value::Text(text), _) => f.write_str(text),
            (Value::Number(number), "1" | "") => write!(f, "{number:.decimals$}"),
            (Value::Number(number), unit) => write!(f, "{number:.decimals$} {unit}"),
        }
    }
}
