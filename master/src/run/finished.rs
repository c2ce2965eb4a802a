//! What a finished run tells on the terminal.

use std::fmt;
use std::path::PathBuf;
use std::time::Duration;

use crate::report::MainFigure;
use crate::system::times::StepTimes;

/// What a finished run tells.
#[derive(Debug)]
pub struct Finished {
    pub(crate) report: PathBuf,
    pub(crate) done: Done,
    pub(crate) times: StepTimes,
    pub(crate) vehicles: usize,
    pub(crate) threads: usize,
    pub(crate) figures: Vec<MainFigure>,
    pub(crate) warnings: Vec<String>,
}

/// How far a run has come, and in which wall time.
#[derive(Debug)]
pub(crate) struct Done {
    /// Time of the train, s.
    pub simulated: f64,
    /// Time of the rails, s.
    pub rails: f64,
    /// Wall time of the steps of the run.
    pub wall: Duration,
    /// Number of those steps.
    pub steps: u64,
}

impl fmt::Display for Finished {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Done { simulated, rails, wall, steps } = &self.done;
        let wall = wall.as_secs_f64();
        writeln!(
            f,
            "{simulated:.1} s simulated in {wall:.1} s: {:.2} times real time with {} threads",
            simulated / wall,
            self.threads
        )?;
        if rails > simulated {
            let after = self.times.rails_after.as_secs_f64();
            writeln!(f, "rails alone or under further trains until {rails:.1} s: {after:.1} s")?;
        }
        let per_step = |time: Duration| time.as_secs_f64() * 1e6 / *steps as f64;
        let times = &self.times;
        write!(f, "per step: train {:.1} µs, ", per_step(times.train))?;
        if self.vehicles > 0 {
            let vehicles = per_step(times.vehicles);
            let each = vehicles * self.threads as f64 / self.vehicles as f64;
            write!(f, "vehicles {vehicles:.1} µs ({each:.2} µs a vehicle and thread), ")?;
            let rail = per_step(times.rail);
            let share = 100.0 * rail / per_step(times.of_steps());
            write!(f, "rail {rail:.1} µs ({share:.1} % of all), ")?;
        }
        writeln!(
            f,
            "exchange {:.1} µs, recording {:.1} µs",
            per_step(times.exchange),
            per_step(times.recording)
        )?;
        let width =
            self.figures.iter().map(|figure| figure.name.chars().count()).max().unwrap_or(0);
        for MainFigure { name, text, location, .. } in &self.figures {
            writeln!(f, "{name:<width$} {text:<14} {location}")?;
        }
        for warning in &self.warnings {
            writeln!(f, "warning: {warning}")?;
        }
        write!(f, "report: {}", self.report.display())
    }
}
