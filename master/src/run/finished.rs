//! What a finished run tells on the terminal.

use std::fmt;
use std::path::{Path, PathBuf};
use std::time::Duration;

use serde::Serialize;

use super::stop::Stopped;
use crate::report::MainFigure;
use crate::system::step::System;

/// What a finished run tells.
pub struct Finished {
    /// Name of the system, where it is not a train of a scenario.
    pub(crate) name: Option<String>,
    pub(crate) report: PathBuf,
    pub(crate) done: Done,
    /// The stages by name, with their number of units.
    pub(crate) stages: Vec<(String, usize)>,
    pub(crate) threads: usize,
    pub(crate) figures: Vec<MainFigure>,
    /// What not to read from the figures.
    pub(crate) caution: Option<&'static str>,
    pub(crate) warnings: Vec<String>,
    /// The units, which are freed with this.
    pub(crate) system: System,
}

impl Finished {
    /// Why the run has stopped before its end, if it has.
    pub fn stopped(&self) -> Option<Stopped> {
        self.done.stopped
    }

    /// The same for a script, of a run in this folder of results.
    pub fn summary(&self, results: &Path) -> Summary<'_> {
        Summary {
            results: results.display().to_string(),
            report: self.report.display().to_string(),
            name: self.name.as_deref(),
            end: if self.stopped().is_some() { "interrupted" } else { "complete" },
            simulated_s: self.done.simulated,
            wall_time_s: self.done.wall.as_secs_f64(),
            threads: self.threads,
            figures: &self.figures,
            caution: self.caution,
            warnings: &self.warnings,
        }
    }
}

/// What a finished run tells a script.
#[derive(Debug, Serialize)]
pub struct Summary<'f> {
    results: String,
    report: String,
    /// Name of the system, where it is not a train of a scenario.
    name: Option<&'f str>,
    /// `complete` or `interrupted`.
    end: &'static str,
    simulated_s: f64,
    wall_time_s: f64,
    threads: usize,
    figures: &'f [MainFigure],
    caution: Option<&'static str>,
    warnings: &'f [String],
}

/// How far a run has come, and in which wall time.
#[derive(Debug)]
pub(crate) struct Done {
    /// Simulated time, s.
    pub simulated: f64,
    /// Time of the rails, s.
    pub rails: f64,
    /// Wall time of the steps of the run.
    pub wall: Duration,
    /// Number of those steps.
    pub steps: u64,
    /// Whether it was stopped.
    pub stopped: Option<Stopped>,
}

impl fmt::Display for Finished {
    /// First the physics, then what was hardly meant, and at last where the time went.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(caution) = self.caution {
            writeln!(f, "{caution}\n")?;
        }
        let width =
            self.figures.iter().map(|figure| figure.name.chars().count()).max().unwrap_or(0);
        for MainFigure { name, text, location, .. } in &self.figures {
            writeln!(f, "{}", format!("{name:<width$} {text:<14} {location}").trim_end())?;
        }
        for warning in &self.warnings {
            writeln!(f, "warning: {warning}")?;
        }
        self.write_times(f)?;
        write!(f, "report: {}", self.report.display())
    }
}

impl Finished {
    fn write_times(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Done { simulated, rails, wall, steps, .. } = &self.done;
        let wall = wall.as_secs_f64();
        if let Some(name) = &self.name {
            write!(f, "{name}: ")?;
        }
        writeln!(
            f,
            "{simulated:.1} s simulated in {wall:.1} s: {:.2} times real time with {} threads",
            simulated / wall,
            self.threads
        )?;
        let times = &self.system.times;
        if rails > simulated {
            let after = times.after.as_secs_f64();
            writeln!(f, "rails alone or under further trains until {rails:.1} s: {after:.1} s")?;
        }
        let per_step = |time: Duration| time.as_secs_f64() * 1e6 / *steps as f64;
        let all = per_step(times.of_steps());
        write!(f, "per step: ")?;
        for ((stage, units), time) in self.stages.iter().zip(&times.stages) {
            let time = per_step(*time);
            write!(f, "{stage} {time:.1} µs ({:.1} % of all", 100.0 * time / all)?;
            if *units > self.threads {
                let each = time * self.threads as f64 / *units as f64;
                write!(f, ", {each:.2} µs a unit and thread")?;
            }
            write!(f, "), ")?;
        }
        let (exchange, recording) = (per_step(times.exchange), per_step(times.recording));
        writeln!(f, "exchange {exchange:.1} µs, recording {recording:.1} µs")
    }
}
