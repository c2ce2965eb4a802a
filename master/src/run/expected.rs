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

use files::{Document, Mistake};
use numerics::seconds;
use schemars::{JsonSchema, Schema, schema_for};
use serde::{Deserialize, Serialize};

use crate::files::file_error::{FileError, read_toml};
use crate::report::{Limit, LimitFacts};

/// Why figures cannot be compared.
#[derive(Debug, thiserror::Error)]
pub enum ExpectedError {
    /// The manifest cannot be read, or is not what it should be.
    #[error(transparent)]
    File(#[from] FileError),
    /// The file of expected figures cannot be read, or is not what it should be.
    #[error(transparent)]
    Expected(#[from] Mistake),
    /// The run is another one.
    #[error(
        "the run came to {} s, but the figures are expected after {} s",
        seconds(*found),
        seconds(*expected)
    )]
    Time {
        /// Time that the run came to, s.
        found: f64,
        /// Time for which the figures are, s.
        expected: f64,
    },
}

/// Figures that a scenario is expected to give.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Expected {
    /// Simulated time of the run, s; a shorter one is not compared.
    simulated_s: f64,
    /// The figures.
    figure: Vec<ExpectedFigure>,
}

/// A figure with a value, with limits, or with neither: then there must be none.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ExpectedFigure {
    /// Key in the manifest.
    key: String,
    /// Value in the manifest's unit.
    value: Option<f64>,
    /// Largest difference from the value.
    #[serde(default)]
    tolerance: f64,
    /// Limit from below, in place of a value.
    at_least: Option<f64>,
    /// Limit from above, in place of a value.
    at_most: Option<f64>,
    /// Where the value or limit comes from.
    source: String,
}

/// The JSON schema of files of expected figures.
pub fn schema() -> Schema {
    schema_for!(Expected)
}

impl Expected {
    fn read(file: &Path) -> Result<Self, Mistake> {
        let document = Document::read(file)?;
        let expected: Self = document.parse()?;
        for (i, figure) in expected.figure.iter().enumerate() {
            let check = document.check().element("figure", i);
            if figure.value.is_some() && figure.has_limits() {
                let wanted = "leave value or the limits out; give each an entry of its own";
                return Err(check.refuse("value", wanted));
            }
        }
        Ok(expected)
    }
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

/// How a figure compares.
#[derive(Debug, PartialEq, Serialize)]
pub struct Comparison {
    /// Key of the figure.
    pub key: String,
    /// Whether the run gave what was expected.
    pub agrees: bool,
    /// Whether the run has a figure of that key.
    pub is_there: bool,
    /// What the run gave; nothing where it has come to no value.
    pub found: Option<f64>,
    /// Unit of the values; empty where there is no such figure.
    pub unit: String,
    /// Value that is expected.
    pub value: Option<f64>,
    /// Largest difference from it.
    pub tolerance: Option<f64>,
    /// Limit from below.
    pub at_least: Option<f64>,
    /// Limit from above.
    pub at_most: Option<f64>,
    /// Where the value or limit comes from.
    pub source: String,
}

impl Comparison {
    fn of(expected: ExpectedFigure, figures: &[FoundFigure]) -> Self {
        let ExpectedFigure { key, value, tolerance, at_least, at_most, source } = expected;
        let figure = figures.iter().find(|found| found.key == key);
        let found = figure.and_then(|figure| figure.value);
        let has_limits = at_least.is_some() || at_most.is_some();
        let agrees = match (value, found) {
            (Some(value), Some(found)) => (found - value).abs() <= tolerance,
            (None, Some(found)) if has_limits => {
                at_least.is_none_or(|least| found >= least)
                    && at_most.is_none_or(|most| found <= most)
            }
            (None, None) => figure.is_some() && !has_limits,
            _ => false,
        };
        Self {
            key,
            agrees,
            is_there: figure.is_some(),
            found,
            unit: figure.map(|figure| figure.unit.clone()).unwrap_or_default(),
            value,
            tolerance: value.map(|_| tolerance),
            at_least,
            at_most,
            source,
        }
    }

    /// What is expected, in words.
    fn wanted(&self) -> String {
        match (self.value, self.at_least, self.at_most) {
            (Some(value), ..) => format!("{value} ± {}", self.tolerance.unwrap_or_default()),
            (None, None, None) => "none".to_owned(),
            (None, None, Some(most)) => format!("at most {most}"),
            (None, Some(least), None) => format!("at least {least}"),
            (None, Some(least), Some(most)) => format!("{least} to {most}"),
        }
    }
}

impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let found = match self.found {
            _ if !self.is_there => "no such figure".to_owned(),
            None => "none".to_owned(),
            Some(found) => found.to_string(),
        };
        let verdict = if self.agrees { "agrees " } else { "DIFFERS" };
        let Self { key, unit, source, .. } = self;
        write!(f, "{verdict} {key}: {found} {unit}, expected {} ({source})", self.wanted())
    }
}

/// Compares the figures of the run in the folder `results` with those expected in `file`.
///
/// # Errors
/// When a file cannot be read, or the run is not the one of the file.
pub fn compare(results: &Path, file: &Path) -> Result<Vec<Comparison>, ExpectedError> {
    let manifest: Manifest = read_toml(&results.join("manifest.toml"))?;
    let expected = Expected::read(file)?;
    let (found, wanted) = (manifest.simulated_s, expected.simulated_s);
    if (found - wanted).abs() > 1e-6 * wanted {
        return Err(ExpectedError::Time { found, expected: wanted });
    }
    let compared = |figure| Comparison::of(figure, &manifest.figure);
    Ok(expected.figure.into_iter().map(compared).collect())
}

/// The limits in `expected.toml` beside a scenario's file.
///
/// There are none where there is no such file, or where it cannot be read, which `hotfoot expect` tells.
pub(super) fn limits(scenario: &Path) -> LimitFacts {
    let Ok(expected) = Expected::read(&scenario.with_file_name("expected.toml")) else {
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
            assert_eq!(comparisons[0].agrees, agrees, "{}", comparisons[0]);
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
        assert!(sentence.contains("expected.toml:4:9: figure[1].value: leave"), "{sentence}");
        let sentence = compared("simulated_s = 1.0\nfigures = []").unwrap_err().to_string();
        assert!(sentence.contains("expected.toml:2:1: there is no key `figures`"), "{sentence}");
    }
}
