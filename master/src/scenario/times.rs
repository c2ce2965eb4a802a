//! Times of the command line in place of those of a scenario's file.

use std::path::Path;

use files::{Document, Mistake};
use serde::{Deserialize, Serialize};

use super::check::check;
use super::file::Scenario;

/// Times in place of those of a scenario's file; those that are not stated stay.
#[derive(Debug, Clone, Copy, Default, Serialize, Deserialize)]
pub struct Times {
    /// Simulated time, s.
    pub duration: Option<f64>,
    /// Step of the exchange between the models, s.
    pub step: Option<f64>,
    /// Time between two records, s.
    pub interval: Option<f64>,
    /// Time between two checkpoints, s.
    pub checkpoint: Option<f64>,
}

impl Times {
    /// The options of the command line that are stated, with their values.
    pub fn stated(&self) -> impl Iterator<Item = (&'static str, f64)> {
        let options = [
            ("--duration", self.duration),
            ("--step", self.step),
            ("--interval", self.interval),
            ("--checkpoint", self.checkpoint),
        ];
        options.into_iter().filter_map(|(option, value)| Some((option, value?)))
    }

    /// Puts them into a scenario.
    ///
    /// # Errors
    /// When the scenario of this file is wrong with them: an interval that is no multiple of the step.
    pub fn replace_in(&self, scenario: &mut Scenario, file: &Path) -> Result<(), Mistake> {
        for (key, time) in [
            (&mut scenario.duration_s, self.duration),
            (&mut scenario.step_s, self.step),
            (&mut scenario.record.interval_s, self.interval),
        ] {
            *key = time.unwrap_or(*key);
        }
        scenario.record.checkpoint_s = self.checkpoint.or(scenario.record.checkpoint_s);
        // The times of the command line have no line in the file.
        check(scenario, &Document::new("", "").check()).map_err(|wrong| {
            let options = self.stated().map(|(option, value)| format!("{option} {value}"));
            let options = options.collect::<Vec<_>>().join(" ");
            Mistake::in_file(format!("{} with {options}", file.display()), wrong.sentence)
        })
    }
}
