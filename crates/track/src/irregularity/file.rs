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

use serde::Deserialize;

use super::Irregularity;
use super::grid::{Grid, Row};
use super::shape::{Direction, Form, Rails, Shape};
use super::spectrum::{Quality, Spectrum};
use crate::TrackError;

/// Columns of a file with measured irregularities.
const COLUMNS: &str =
    "chainage_m,left_lateral_mm,left_vertical_mm,right_lateral_mm,right_vertical_mm";

/// Greatest irregularity, mm.
const GREATEST: f64 = 200.0;

#[derive(Deserialize, Default)]
#[serde(deny_unknown_fields)]
pub(crate) struct Section {
    file: Option<PathBuf>,
    spectrum: Option<SpectrumSection>,
    #[serde(default)]
    shape: Vec<ShapeSection>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct SpectrumSection {
    quality: Quality,
    seed: u64,
    begin_m: f64,
    length_m: f64,
    #[serde(default = "wavelengths")]
    wavelengths_m: [f64; 2],
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ShapeSection {
    form: Form,
    rails: Rails,
    direction: Direction,
    begin_m: f64,
    length_m: f64,
    amplitude_mm: f64,
    #[serde(default = "one")]
    waves: f64,
}

/// The part of a track file that is read here; the rest is the track's.
#[derive(Deserialize)]
struct TrackFile {
    #[serde(default)]
    irregularity: Section,
}

fn wavelengths() -> [f64; 2] {
    [3.0, 80.0]
}

fn one() -> f64 {
    1.0
}

/// The file with measured irregularities that a track file names, if it names one.
///
/// # Errors
/// When the track file cannot be read.
pub fn file_beside(track_file: &Path) -> Result<Option<PathBuf>, TrackError> {
    let name = track_file.display().to_string();
    let text = std::fs::read_to_string(track_file)
        .map_err(|source| TrackError::Read { file: name.clone(), source })?;
    let folder = track_file.parent().unwrap_or(Path::new(""));
    Ok(Section::of(&text, &name)?.file.map(|file| folder.join(file)))
}

impl Section {
    /// The section of a track file's text.
    pub fn of(text: &str, name: &str) -> Result<Self, TrackError> {
        let file: TrackFile = toml::from_str(text).map_err(|source| TrackError::Syntax {
            file: name.to_owned(),
            source: Box::new(source),
        })?;
        Ok(file.irregularity)
    }

    /// The irregularities; `folder` is that of the track file.
    pub fn compile(self, name: &str, folder: &Path) -> Result<Irregularity, TrackError> {
        let grid = match (&self.file, &self.spectrum) {
            (None, None) => None,
            (Some(file), None) if file.components().count() == 1 => {
                Some(measured(&folder.join(file))?)
            }
            (Some(file), None) => {
                return Err(TrackError::Elsewhere {
                    file: name.to_owned(),
                    value: file.display().to_string(),
                });
            }
            (None, Some(spectrum)) => Some(spectrum.checked(name)?.grid()),
            (Some(_), Some(spectrum)) => {
                let wanted = "leave either irregularity.file or irregularity.spectrum out";
                return Err(error(
                    name,
                    "irregularity.spectrum.seed",
                    spectrum.seed as f64,
                    wanted,
                ));
            }
        };
        let shapes = self.shape.iter().enumerate();
        let shapes =
            shapes.map(|(i, shape)| shape.checked(name, i + 1)).collect::<Result<_, _>>()?;
        Ok(Irregularity { grid, shapes })
    }
}

impl SpectrumSection {
    fn checked(&self, file: &str) -> Result<Spectrum, TrackError> {
        let key = |key: &str| format!("irregularity.spectrum.{key}");
        if !self.begin_m.is_finite() {
            return Err(error(file, &key("begin_m"), self.begin_m, "must be a finite chainage"));
        }
        if !(50.0..=1e6).contains(&self.length_m) {
            let wanted = "must lie between 50 and 1e6 m";
            return Err(error(file, &key("length_m"), self.length_m, wanted));
        }
        let [shortest, longest] = self.wavelengths_m;
        if !(shortest >= 1.0 && longest > shortest && longest <= 1000.0) {
            let wanted = "must be two rising wavelengths between 1 and 1000 m";
            return Err(error(file, &key("wavelengths_m"), shortest, wanted));
        }
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
    fn checked(&self, file: &str, number: usize) -> Result<Shape, TrackError> {
        let key = |key: &str| format!("irregularity.shape[{number}].{key}");
        if !self.begin_m.is_finite() {
            return Err(error(file, &key("begin_m"), self.begin_m, "must be a finite chainage"));
        }
        if !(0.01..=1e5).contains(&self.length_m) {
            return Err(error(file, &key("length_m"), self.length_m, "must be at least 0.01 m"));
        }
        if !(-GREATEST..=GREATEST).contains(&self.amplitude_mm) {
            let wanted = "must lie between -200 and 200 mm";
            return Err(error(file, &key("amplitude_mm"), self.amplitude_mm, wanted));
        }
        if !(0.1..=1e4).contains(&self.waves) {
            return Err(error(file, &key("waves"), self.waves, "must be at least 0.1"));
        }
        Ok(Shape {
            form: self.form,
            rails: self.rails,
            direction: self.direction,
            begin: self.begin_m,
            length: self.length_m,
            amplitude: self.amplitude_mm * 1e-3,
            waves: self.waves,
        })
    }
}

fn error(file: &str, key: &str, value: f64, wanted: &'static str) -> TrackError {
    TrackError::Value { file: file.to_owned(), key: key.to_owned(), value, wanted }
}

/// Reads a file with measured irregularities.
fn measured(file: &Path) -> Result<Grid, TrackError> {
    let name = file.display().to_string();
    let text = std::fs::read_to_string(file)
        .map_err(|source| TrackError::Read { file: name.clone(), source })?;
    let mut lines = text.lines();
    if lines.next().map(str::trim) != Some(COLUMNS) {
        return Err(TrackError::Columns { file: name, wanted: COLUMNS });
    }
    let mut chainages: Vec<f64> = vec![];
    let mut rows: Vec<Row> = vec![];
    for (i, line) in lines.filter(|line| !line.trim().is_empty()).enumerate() {
        let row = row(line).ok_or_else(|| TrackError::Row { file: name.clone(), line: i + 2 })?;
        let [chainage, values @ ..] = row;
        let distance = chainages.first().zip(chainages.get(1)).map(|(a, b)| b - a);
        let regular = match (chainages.last(), distance) {
            (None, _) => true,
            (Some(before), None) => chainage > *before,
            (Some(before), Some(d)) => (chainage - before - d).abs() <= 1e-3 * d,
        };
        if !regular {
            let wanted = "chainages must rise in equal distances";
            return Err(error(&name, &format!("line {}", i + 2), chainage, wanted));
        }
        chainages.push(chainage);
        rows.push(values.map(|value| value * 1e-3));
    }
    match chainages[..] {
        [first, second, ..] => Ok(Grid::new(first, second - first, rows)),
        _ => Err(error(&name, "number of rows", rows.len() as f64, "must be at least 2")),
    }
}

/// Five finite numbers, none of them a greater irregularity than there is.
fn row(line: &str) -> Option<[f64; 5]> {
    let values: Vec<f64> =
        line.split(',').map(|value| value.trim().parse().ok()).collect::<Option<_>>()?;
    let row: [f64; 5] = values.try_into().ok()?;
    let possible = row[0].is_finite() && row[1..].iter().all(|value| value.abs() <= GREATEST);
    possible.then_some(row)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shapes(text: &str) -> Irregularity {
        Irregularity::from_toml(text, "t.toml").unwrap()
    }

    /// Half way up a ramp of 5 mm over 0.1 m, and behind it; a dip in its middle.
    #[test]
    fn analytic_ramp_and_dip() {
        let track = shapes(
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
        );
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
        let message = |text: &str| Irregularity::from_toml(text, "t.toml").unwrap_err().to_string();
        let spectrum = "irregularity.spectrum = { quality = 'erri-low', seed = 1, begin_m = 0, \
                        length_m = 1 }";
        assert!(message(spectrum).contains("t.toml: irregularity.spectrum.length_m = 1: must lie"));
        let missing = "irregularity.file = 'nowhere.csv'";
        assert!(message(missing).contains("nowhere.csv"));
    }

    #[test]
    fn analytic_measured_values_between_rows() {
        let folder = tempfile::tempdir().unwrap();
        let rows = "0,0,0,0,0\n1,1,0,1,2\n2,2,0,2,4\n3,3,0,3,6\n";
        std::fs::write(folder.path().join("m.csv"), format!("{COLUMNS}\n{rows}")).unwrap();
        std::fs::write(folder.path().join("t.toml"), "irregularity.file = 'm.csv'").unwrap();
        let track = Irregularity::from_track_file(&folder.path().join("t.toml")).unwrap();
        // A straight line stays one between inner rows.
        let [left, right] = track.at(1.5);
        assert!((left.lateral - 1.5e-3).abs() < 1e-15 && (right.vertical - 3e-3).abs() < 1e-15);
        assert!((right.vertical_slope - 2e-3).abs() < 1e-15);
        let beside = file_beside(&folder.path().join("t.toml")).unwrap();
        assert_eq!(beside, Some(folder.path().join("m.csv")));
        let crooked = "0,0,0,0,0\n1,1,0,1,2\n3,2,0,2,4\n";
        std::fs::write(folder.path().join("m.csv"), format!("{COLUMNS}\n{crooked}")).unwrap();
        let message = Irregularity::from_track_file(&folder.path().join("t.toml")).unwrap_err();
        assert!(message.to_string().contains("line 4 = 3: chainages must rise"), "{message}");
    }
}
