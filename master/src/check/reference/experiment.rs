//! How a reference run is made.

use std::collections::BTreeMap;
use std::path::Path;

use files::{Document, Mistake};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// By how much a value may differ where the FMU does not say, in parts of the largest magnitude of
/// its signal: what solvers with another step may differ by.
const DEFAULT_TOLERANCE: f64 = 1e-3;

/// A run from zero to a stop time.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Experiment {
    /// End of the run, s.
    pub stop_time_s: f64,
    /// Communication step, s.
    pub step_s: f64,
    /// Steps between two rows of the result.
    pub record_every: u64,
    /// By how much a value may differ, in parts of the largest magnitude of its signal.
    pub relative_tolerance: f64,
    /// The Real outputs in the result.
    pub outputs: Vec<String>,
    /// Start values of Real parameters, where they are not those of the model description.
    #[serde(default)]
    pub start_values: BTreeMap<String, f64>,
}

impl Experiment {
    /// Reads an experiment.
    ///
    /// # Errors
    /// When the file cannot be read, or makes no sense.
    pub fn read(file: &Path) -> Result<Self, Mistake> {
        let document = Document::read(file)?;
        let experiment: Self = document.parse()?;
        let check = document.check();
        let Self { stop_time_s, step_s, record_every, relative_tolerance, .. } = experiment;
        check.positive("stop_time_s", stop_time_s)?;
        check.positive("step_s", step_s)?;
        let wanted = format!("must be at most stop_time_s = {stop_time_s} s");
        check.ensure(step_s <= stop_time_s, "step_s", step_s, &wanted)?;
        let wanted = "must be 1 or more: steps between two rows of the result";
        check.ensure(record_every > 0, "record_every", record_every, wanted)?;
        check.positive("relative_tolerance", relative_tolerance)?;
        Ok(experiment)
    }

    /// The experiment that made a result, from its rows: its outputs at its times, with a step that
    /// divides the time between two rows. An FMU that ends itself has its last row before its time.
    pub fn of_result(names: &[String], times: &[f64], default_step: Option<f64>) -> Option<Self> {
        let (first, second, last) = (times.first()?, times.get(1)?, times.last()?);
        let (rows, length) = (times.len() as f64 - 1.0, last - first);
        let (even, first_interval) = (length / rows, second - first);
        let is_even = (even - first_interval).abs() <= 1e-6 * even;
        let interval = if is_even { even } else { first_interval };
        let stop = if is_even { *last } else { first + interval * (length / interval).ceil() };
        let step = default_step.filter(|step| *step > 0.0 && *step <= interval).unwrap_or(interval);
        let record_every = (interval / step).round().max(1.0);
        (interval > 0.0).then(|| Self {
            stop_time_s: stop,
            step_s: interval / record_every,
            record_every: record_every as u64,
            relative_tolerance: DEFAULT_TOLERANCE,
            outputs: names.to_vec(),
            start_values: BTreeMap::new(),
        })
    }

    /// Number of steps.
    pub fn steps(&self) -> u64 {
        (self.stop_time_s / self.step_s).round() as u64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const EXPERIMENT: &str = "stop_time_s = 2.0\nstep_s = 0.001\nrecord_every = 100\n\
                              relative_tolerance = 1e-6\noutputs = [\"h\", \"v\"]\n";

    fn read(text: &str) -> Result<Experiment, String> {
        let file = tempfile::NamedTempFile::new().unwrap();
        std::fs::write(file.path(), text).unwrap();
        Experiment::read(file.path()).map_err(|error| error.to_string())
    }

    #[test]
    fn an_experiment_is_read_with_what_may_be_left_out() {
        let experiment = read(EXPERIMENT).unwrap();
        assert_eq!((experiment.steps(), experiment.record_every), (2000, 100));
        assert!(experiment.start_values.is_empty());
        let with_start = format!("{EXPERIMENT}[start_values]\ne = 0.7\n");
        assert_eq!(read(&with_start).unwrap().start_values["e"], 0.7);
    }

    /// The whole message, as of every file that people write.
    #[test]
    fn a_mistake_in_an_experiment_is_told_with_its_place() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("experiment.toml");
        std::fs::write(&file, EXPERIMENT.replace("record_every = 100", "record_every = 0"))
            .unwrap();
        let message = Experiment::read(&file).unwrap_err().to_string();
        let wanted = format!(
            "{}:3:16: record_every = 0: must be 1 or more: steps between two rows of the result\n  |\n\
             3 | record_every = 0\n  |                ^",
            file.display()
        );
        assert_eq!(message, wanted);
    }

    #[test]
    fn an_experiment_that_makes_no_sense_is_refused_by_its_key() {
        for (from, to, wanted) in [
            ("step_s = 0.001", "step_s = 0.0", ":2:10: step_s = 0.0: must be greater than zero"),
            (
                "step_s = 0.001",
                "step_s = 3",
                ":2:10: step_s = 3: must be at most stop_time_s = 2 s",
            ),
            (
                "stop_time_s = 2.0",
                "stop_time_s = -1.0",
                ":1:15: stop_time_s = -1.0: must be greater than zero",
            ),
            (
                "relative_tolerance = 1e-6",
                "relative_tolerance = inf",
                ":4:22: relative_tolerance = inf: must be greater than zero",
            ),
            ("stop_time_s = 2.0", "stop_time = 2.0", ":1:1: there is no key `stop_time`"),
            ("step_s = 0.001\n", "", "step_s"),
            ("step_s = 0.001", "step_s = \"1 ms\"", ":2:10: step_s = \"1 ms\": must be a number"),
            (
                "record_every = 100",
                "record_every = 0.1",
                ":3:16: record_every = 0.1: must be a whole number",
            ),
            ("[\"h\", \"v\"]", "\"h\"", ":5:11: outputs = \"h\": must be a list"),
        ] {
            assert!(EXPERIMENT.contains(from), "{from}");
            let error = read(&EXPERIMENT.replace(from, to)).unwrap_err();
            assert!(error.contains(wanted), "{to}: {error}");
        }
    }

    /// A reference result of the Reference-FMUs has no experiment beside it: its rows say how it was made.
    #[test]
    fn a_result_without_experiment_is_run_at_its_own_times() {
        let times: Vec<f64> = (0..=300).map(|row| 0.01 * f64::from(row)).collect();
        let names = ["h".to_owned()];
        let steps = |default| {
            let experiment = Experiment::of_result(&names, &times, default).unwrap();
            assert!((experiment.stop_time_s - 3.0).abs() < 1e-12);
            assert!((experiment.step_s * experiment.record_every as f64 - 0.01).abs() < 1e-12);
            (experiment.steps(), experiment.record_every)
        };
        assert_eq!(steps(None), (300, 1));
        assert_eq!(steps(Some(1e-3)), (3000, 10), "the step of the FMU divides the interval");
        assert_eq!(
            steps(Some(3e-3)),
            (900, 3),
            "one that does not is rounded to the next that does"
        );
        assert_eq!(steps(Some(0.5)), (300, 1), "a longer one than the interval is not used");
        let ended = Experiment::of_result(&names, &[0.0, 0.1, 0.2, 0.25], None).unwrap();
        assert_eq!(ended.steps(), 3, "in the third step it ended itself");
        assert_eq!(Experiment::of_result(&names, &[0.0], None), None, "one row has no interval");
        assert_eq!(Experiment::of_result(&names, &[], None), None);
    }
}
