//! The figures that a scenario is expected to give, in a file beside it, against those in the
//! manifest of a run.
//!
//! ```toml
//! simulated_s = 106.0                 # a shorter run is not compared
//! [[figure]]
//! key = "left.foot.highest"           # as in the manifest
//! value = 0.126                       # in the manifest's unit; left out: there must be none
//! tolerance = 0.001                   # largest difference
//! source = "where the value comes from"
//! [[figure]]
//! key = "outputs.*.derailment_quotient.highest"
//! at_most = 0.8                       # a limit, or at_least, or both, instead of a value
//! source = "where the limit comes from"
//! ```

use std::fmt;
use std::path::Path;

use serde::Deserialize;

use crate::files::file_error::{FileError, read_toml};
use crate::report::{Limit, LimitFacts};

/// Why figures cannot be compared.
#[derive(Debug, thiserror::Error)]
pub enum ExpectedError {
    /// A file cannot be read, or is not what it should be.
    #[error(transparent)]
    File(#[from] FileError),
    /// A figure has a value and a limit.
    #[error("{file}: figure \"{key}\" has a value and a limit; give each an entry of its own")]
    Both {
        /// File.
        file: String,
        /// Key of the figure.
        key: String,
    },
    /// The run is another one.
    #[error("the run came to {found} s, but the figures are expected after {expected} s")]
    Time {
        /// Time that the run came to, s.
        found: f64,
        /// Time for which the figures are, s.
        expected: f64,
    },
}

/// The file of expected figures.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Expected {
    simulated_s: f64,
    figure: Vec<ExpectedFigure>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct ExpectedFigure {
    key: String,
    value: Option<f64>,
    #[serde(default)]
    tolerance: f64,
    at_least: Option<f64>,
    at_most: Option<f64>,
    source: String,
}

/// What of a manifest is compared.
#[derive(Debug, Deserialize)]
struct Manifest {
    simulated_s: f64,
    #[serde(default)]
    figure: Vec<FoundFigure>,
}

#[derive(Debug, Deserialize)]
struct FoundFigure {
    key: String,
    value: Option<f64>,
    unit: String,
}

/// What a figure must be.
#[derive(Debug, PartialEq)]
enum Wanted {
    /// There must be no such value.
    None,
    /// A value, and the largest difference from it.
    Value(f64, f64),
    /// Between limits.
    Limits(f64, f64),
}

/// How a figure compares.
#[derive(Debug, PartialEq)]
pub struct Comparison {
    key: String,
    wanted: Wanted,
    /// None if the run has no figure of that key.
    found: Option<Option<f64>>,
    unit: String,
    source: String,
}

impl Comparison {
    /// Whether the run gave what was expected.
    pub fn agrees(&self) -> bool {
        match (&self.wanted, self.found) {
            (Wanted::Value(value, tolerance), Some(Some(found))) => {
                (found - value).abs() <= *tolerance
            }
            (Wanted::Limits(least, most), Some(Some(found))) => (*least..=*most).contains(&found),
            (Wanted::None, Some(None)) => true,
            _ => false,
        }
    }
}

impl fmt::Display for Wanted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::None => write!(f, "none"),
            Self::Value(value, tolerance) => write!(f, "{value} ± {tolerance}"),
            Self::Limits(f64::NEG_INFINITY, most) => write!(f, "at most {most}"),
            Self::Limits(least, f64::INFINITY) => write!(f, "at least {least}"),
            Self::Limits(least, most) => write!(f, "{least} to {most}"),
        }
    }
}

impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let number = |value: Option<f64>| value.map_or("none".to_owned(), |v| v.to_string());
        let found = self.found.map_or("no such figure".to_owned(), number);
        let verdict = if self.agrees() { "agrees " } else { "DIFFERS" };
        let Self { key, unit, wanted, source, .. } = self;
        write!(f, "{verdict} {key}: {found} {unit}, expected {wanted} ({source})")
    }
}

/// Compares the figures of the run in the folder `results` with those expected in `file`.
///
/// # Errors
/// When a file cannot be read, or the run is not the one of the file.
pub fn compare(results: &Path, file: &Path) -> Result<Vec<Comparison>, ExpectedError> {
    let manifest: Manifest = read_toml(&results.join("manifest.toml"))?;
    let expected: Expected = read_toml(file)?;
    let (found, wanted) = (manifest.simulated_s, expected.simulated_s);
    if (found - wanted).abs() > 1e-6 * wanted {
        return Err(ExpectedError::Time { found, expected: wanted });
    }
    let compared = |figure: ExpectedFigure| {
        let found = manifest.figure.iter().find(|found| found.key == figure.key);
        Comparison {
            found: found.map(|found| found.value),
            unit: found.map(|found| found.unit.clone()).unwrap_or_default(),
            wanted: figure.wanted(),
            key: figure.key,
            source: figure.source,
        }
    };
    let file_name = file.display().to_string();
    let both = expected.figure.iter().find(|figure| figure.value.is_some() && figure.has_limits());
    if let Some(figure) = both {
        return Err(ExpectedError::Both { file: file_name, key: figure.key.clone() });
    }
    Ok(expected.figure.into_iter().map(compared).collect())
}

/// The limits in `expected.toml` beside a scenario's file.
///
/// There are none where there is no such file, or where it cannot be read, which `hotfoot expect` tells.
pub(super) fn limits(scenario: &Path) -> LimitFacts {
    let Ok(expected) = read_toml::<Expected>(&scenario.with_file_name("expected.toml")) else {
        return LimitFacts::default();
    };
    let figures = expected.figure.into_iter().filter(ExpectedFigure::has_limits);
    let limit = |ExpectedFigure { key, at_least, at_most, source, .. }| Limit {
        key,
        at_least,
        at_most,
        source,
    };
    LimitFacts { simulated_s: expected.simulated_s, figures: figures.map(limit).collect() }
}

impl ExpectedFigure {
    fn has_limits(&self) -> bool {
        self.at_least.is_some() || self.at_most.is_some()
    }

    fn wanted(&self) -> Wanted {
        let limits =
            [self.at_least.unwrap_or(f64::NEG_INFINITY), self.at_most.unwrap_or(f64::INFINITY)];
        match self.value {
            Some(value) => Wanted::Value(value, self.tolerance),
            None if self.has_limits() => Wanted::Limits(limits[0], limits[1]),
            None => Wanted::None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MANIFEST: &str = "simulated_s = 106.0\n\
        [[figure]]\nkey = \"left.foot.highest\"\nvalue = 0.126\nunit = \"K\"\n\
        [[figure]]\nkey = \"right.foot.detection\"\nunit = \"s\"\n";

    fn compared(expected: &str) -> Result<Vec<Comparison>, ExpectedError> {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("manifest.toml"), MANIFEST).unwrap();
        let file = folder.path().join("expected.toml");
        std::fs::write(&file, expected).unwrap();
        compare(folder.path(), &file)
    }

    fn figure(key: &str, value: &str) -> String {
        format!(
            "simulated_s = 106.0\n[[figure]]\nkey = \"{key}\"\n{value}\ntolerance = 0.001\n\
             source = \"test\"\n"
        )
    }

    /// Of the expected figures beside a scenario those with limits are for the report.
    #[test]
    fn limits_beside_a_scenario_are_found() {
        let folder = tempfile::tempdir().unwrap();
        let scenario = folder.path().join("scenario.toml");
        assert_eq!(limits(&scenario), LimitFacts::default());
        let text =
            figure("a", "at_most = 0.8") + "[[figure]]\nkey = \"b\"\nvalue = 1\nsource = \"x\"\n";
        std::fs::write(folder.path().join("expected.toml"), text).unwrap();
        let limits = limits(&scenario);
        assert_eq!(limits.simulated_s, 106.0);
        assert_eq!(limits.figures.len(), 1);
        assert_eq!((limits.figures[0].key.as_str(), limits.figures[0].at_most), ("a", Some(0.8)));
    }

    #[test]
    fn a_figure_agrees_within_its_tolerance_and_no_farther() {
        for (key, value, agrees) in [
            ("left.foot.highest", "value = 0.1265", true),
            ("left.foot.highest", "value = 0.128", false),
            ("left.foot.highest", "", false),
            ("right.foot.detection", "", true),
            ("right.foot.detection", "value = 236.0", false),
            ("right.foot.dtection", "", false),
            ("left.foot.highest", "at_most = 0.126", true),
            ("left.foot.highest", "at_most = 0.125", false),
            ("left.foot.highest", "at_least = 0.127\nat_most = 0.2", false),
            ("right.foot.detection", "at_most = 300.0", false),
        ] {
            let comparisons = compared(&figure(key, value)).unwrap();
            assert_eq!(comparisons[0].agrees(), agrees, "{}", comparisons[0]);
        }
        let sentence =
            compared(&figure("left.foot.highest", "value = 0.128")).unwrap()[0].to_string();
        assert_eq!(sentence, "DIFFERS left.foot.highest: 0.126 K, expected 0.128 ± 0.001 (test)");
    }

    #[test]
    fn another_run_and_a_typo_are_refused() {
        let shorter = figure("left.foot.highest", "").replace("106.0", "3.0");
        let sentence = compared(&shorter).unwrap_err().to_string();
        assert!(sentence.contains("came to 106 s") && sentence.contains("after 3 s"), "{sentence}");
        let both = figure("left.foot.highest", "value = 0.1\nat_most = 0.2");
        let sentence = compared(&both).unwrap_err().to_string();
        assert!(sentence.contains("a value and a limit"), "{sentence}");
        let sentence = compared("simulated_s = 1.0\nfigures = []").unwrap_err().to_string();
        assert!(sentence.contains("expected.toml") && sentence.contains("figures"), "{sentence}");
    }
}
