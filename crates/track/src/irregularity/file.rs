//! The section `[irregularity]` of a track file.
//!
//! ```toml
//! [irregularity]
//! file = "measured.csv"        # chainage_m and left and right rail in mm, at equal distances, or
//! spectrum = { quality = "erri-low", seed = 1, begin_m = 100.0, length_m = 2000.0 }
//! [[irregularity.shape]]       # besides, as many single defects as you like
//! form = "ramp"                # or "sine", "dip"
//! rails = "both"               # or "left", "right", "opposite"
//! direction = "lateral"        # or "vertical" (down)
//! begin_m = 50.0
//! length_m = 0.1
//! amplitude_mm = 5.0
//! waves = 1.0                  # of a sine or dip
//! ```

use std::path::{Path, PathBuf};

use files::{Check, Column, Document, Mistake, Table};
use schemars::JsonSchema;
use serde::Deserialize;

use super::Irregularity;
use super::grid::{Grid, Row};
use super::shape::{Direction, Form, Rails, Shape};
use super::spectrum::{Quality, Spectrum};

/// Greatest irregularity, mm.
const GREATEST: f64 = 200.0;

/// Columns of a file with measured irregularities.
pub const COLUMNS: [Column; 5] = [
    Column {
        name: "chainage_m",
        unit: "m",
        required: true,
        bounds: None,
        description: "Chainage, at equal distances",
    },
    offset("left_lateral_mm", "Left rail to the right"),
    offset("left_vertical_mm", "Left rail down"),
    offset("right_lateral_mm", "Right rail to the right"),
    offset("right_vertical_mm", "Right rail down"),
];

const fn offset(name: &'static str, description: &'static str) -> Column {
    Column { name, unit: "mm", required: true, bounds: Some([-GREATEST, GREATEST]), description }
}

/// The section as it stands in the file.
#[derive(Debug, Deserialize, JsonSchema, Default)]
#[serde(deny_unknown_fields)]
pub(crate) struct Section {
    /// CSV file of measured irregularities, beside the track file.
    file: Option<PathBuf>,
    /// Random irregularities of a spectrum.
    spectrum: Option<SpectrumSection>,
    /// Single defects.
    #[serde(default)]
    shape: Vec<ShapeSection>,
}

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct SpectrumSection {
    /// Quality of the track.
    quality: Quality,
    /// Seed of the random numbers.
    seed: u64,
    /// Where they begin, m.
    begin_m: f64,
    /// Length, m.
    length_m: f64,
    /// Shortest and longest wavelength, m.
    #[serde(default = "wavelengths")]
    wavelengths_m: [f64; 2],
}

#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ShapeSection {
    /// Form of the defect.
    form: Form,
    /// Rails that have it.
    rails: Rails,
    /// Its direction.
    direction: Direction,
    /// Where it begins, m.
    begin_m: f64,
    /// Length, m.
    length_m: f64,
    /// Amplitude, mm.
    amplitude_mm: f64,
    /// Number of waves of a sine or a dip.
    #[serde(default = "one")]
    waves: f64,
}

fn wavelengths() -> [f64; 2] {
    [3.0, 80.0]
}

fn one() -> f64 {
    1.0
}

impl Section {
    /// The file with measured irregularities, if it names one.
    pub fn file(&self) -> Option<&Path> {
        self.file.as_deref()
    }

    /// The irregularities; `folder` is that of the track file.
    pub fn compile(&self, check: &Check, folder: &Path) -> Result<Irregularity, Mistake> {
        let grid = match (&self.file, &self.spectrum) {
            (None, None) => None,
            (Some(file), None) if file.components().count() == 1 => {
                let path = folder.join(file);
                if let Err(missing) = files::exists(&path) {
                    return Err(check.error("file", file.display(), missing.sentence));
                }
                Some(measured(&path)?)
            }
            (Some(file), None) => {
                let wanted = "must be the name of a file in the folder of the track file";
                return Err(check.error("file", file.display(), wanted));
            }
            (None, Some(spectrum)) => Some(spectrum.compile(&check.section("spectrum"))?.grid()),
            (Some(_), Some(_)) => {
                let why = "leave either irregularity.file or irregularity.spectrum out";
                return Err(check.refuse("spectrum", why));
            }
        };
        let shapes = self.shape.iter().enumerate();
        let shapes = shapes.map(|(i, shape)| shape.compile(&check.element("shape", i)));
        Ok(Irregularity { grid, shapes: shapes.collect::<Result<_, _>>()? })
    }
}

impl SpectrumSection {
    fn compile(&self, check: &Check) -> Result<Spectrum, Mistake> {
        let finite = self.begin_m.is_finite();
        check.ensure(finite, "begin_m", self.begin_m, "must be a finite chainage")?;
        let possible = (50.0..=1e6).contains(&self.length_m);
        check.ensure(possible, "length_m", self.length_m, "must lie between 50 and 1e6 m")?;
        let [shortest, longest] = self.wavelengths_m;
        let possible = shortest >= 1.0 && longest > shortest && longest <= 1000.0;
        let wanted = "must be two rising wavelengths between 1 and 1000 m";
        check.ensure(possible, "wavelengths_m", format!("{:?}", self.wavelengths_m), wanted)?;
        Ok(Spectrum {
            quality: self.quality,
            seed: self.seed,
            begin: self.begin_m,
            length: self.length_m,
            wavelengths: self.wavelengths_m,
        })
    }
}

impl ShapeSection {
    fn compile(&self, check: &Check) -> Result<Shape, Mistake> {
        let Self { begin_m, length_m, amplitude_mm, waves, .. } = *self;
        check.ensure(begin_m.is_finite(), "begin_m", begin_m, "must be a finite chainage")?;
        let possible = (0.01..=1e5).contains(&length_m);
        check.ensure(possible, "length_m", length_m, "must be at least 0.01 m")?;
        let possible = (-GREATEST..=GREATEST).contains(&amplitude_mm);
        check.ensure(possible, "amplitude_mm", amplitude_mm, "must lie between -200 and 200 mm")?;
        check.ensure((0.1..=1e4).contains(&waves), "waves", waves, "must be at least 0.1")?;
        Ok(Shape {
            form: self.form,
            rails: self.rails,
            direction: self.direction,
            begin: begin_m,
            length: length_m,
            amplitude: amplitude_mm * 1e-3,
            waves,
        })
    }
}

/// Reads a file with measured irregularities.
fn measured(file: &Path) -> Result<Grid, Mistake> {
    let document = Document::read(file)?;
    let table = Table::new(&document)?;
    let names = COLUMNS.map(|column| column.name);
    if !table.names().eq(names) {
        return Err(table.error_in_names(format!("the columns must be {}", names.join(","))));
    }
    let mut chainages: Vec<f64> = Vec::with_capacity(table.len());
    let mut rows: Vec<Row> = Vec::with_capacity(table.len());
    for i in 0..table.len() {
        let chainage = table.number(i, 0)?;
        let regular = match chainages[..] {
            [] => true,
            [before] => chainage > before,
            [first, second, ..] => {
                let distance = second - first;
                (chainage - chainages[i - 1] - distance).abs() <= 1e-3 * distance
            }
        };
        if !regular {
            return Err(table.error(i, 0, "chainages must rise in equal distances"));
        }
        let mut row = Row::default();
        for (number, value) in row.iter_mut().enumerate() {
            let column = number + 1;
            *value = COLUMNS[column].value(&table, i, column)? * 1e-3;
        }
        chainages.push(chainage);
        rows.push(row);
    }
    match chainages[..] {
        [first, second, ..] => Ok(Grid::new(first, second - first, rows)),
        _ => Err(table.error(0, 0, "there must be at least two rows")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::TrackFile;

    fn irregularity(text: &str) -> Result<Irregularity, Mistake> {
        TrackFile::new(text, "t.toml")?.irregularity()
    }

    /// Half way up a ramp of 5 mm over 0.1 m, and behind it; a dip in its middle.
    #[test]
    fn analytic_ramp_and_dip() {
        let track = irregularity(
            "[[irregularity.shape]]
            form = 'ramp'
            rails = 'both'
            direction = 'lateral'
            begin_m = 50.0
            length_m = 0.1
            amplitude_mm = 5.0
            [[irregularity.shape]]
            form = 'dip'
            rails = 'left'
            direction = 'vertical'
            begin_m = 60.0
            length_m = 10.0
            amplitude_mm = 20.0",
        )
        .unwrap();
        let [left, right] = track.at(50.05);
        assert!((left.lateral - 2.5e-3).abs() < 1e-12 && (left.lateral_slope - 0.05).abs() < 1e-12);
        assert_eq!(left, right);
        let [left, right] = track.at(65.0);
        assert!((left.vertical - 0.02).abs() < 1e-12 && left.vertical_slope.abs() < 1e-12);
        assert_eq!((right.vertical, right.lateral), (0.0, 5e-3));
        assert_eq!(track.at(49.0), [crate::RailOffset::default(); 2]);
    }

    #[test]
    fn wrong_values_are_named_with_file_and_key() {
        let message = |text: &str| irregularity(text).unwrap_err().to_string();
        let spectrum = "irregularity.spectrum = { quality = 'erri-low', seed = 1, begin_m = 0, \
                        length_m = 1 }";
        let told = message(spectrum);
        let wanted = "t.toml:1:83: irregularity.spectrum.length_m = 1: must lie between 50 and";
        assert!(told.starts_with(wanted), "{told}");
        let missing = "irregularity.file = 'nowhere.csv'";
        assert!(message(missing).contains("nowhere.csv"));
    }

    #[test]
    fn analytic_measured_values_between_rows() {
        let folder = tempfile::tempdir().unwrap();
        let rows = "0,0,0,0,0\n1,1,0,1,2\n2,2,0,2,4\n3,3,0,3,6\n";
        let measured = folder.path().join("m.csv");
        let names = COLUMNS.map(|column| column.name).join(",");
        std::fs::write(&measured, format!("{names}\n{rows}")).unwrap();
        std::fs::write(folder.path().join("t.toml"), "irregularity.file = 'm.csv'").unwrap();
        let file = TrackFile::read(&folder.path().join("t.toml")).unwrap();
        let track = file.irregularity().unwrap();
        // A straight line stays one between inner rows.
        let [left, right] = track.at(1.5);
        assert!((left.lateral - 1.5e-3).abs() < 1e-15 && (right.vertical - 3e-3).abs() < 1e-15);
        assert!((right.vertical_slope - 2e-3).abs() < 1e-15);
        assert_eq!(file.measured(), Some(measured.clone()));
        for (rows, wanted) in [
            (
                "0,0,0,0,0\n1,1,0,1,2\n3,2,0,2,4\n",
                "m.csv:4:1: chainage_m = 3: chainages must rise in",
            ),
            ("0,0,0,0,0\n1,n/a,0,1,2\n", "m.csv:3:3: left_lateral_mm = n/a: must be a number"),
            (
                "0,0,0,0,0\n1,0,0,1,900\n",
                "right_vertical_mm = 900: must lie between -200 and 200 mm",
            ),
            ("0,0,0,0,0\n", "m.csv:2:1: chainage_m = 0: there must be at least two rows"),
        ] {
            std::fs::write(&measured, format!("{names}\n{rows}")).unwrap();
            let message = file.irregularity().unwrap_err().to_string();
            assert!(message.contains(wanted), "{message}");
        }
    }
}
