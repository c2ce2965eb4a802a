//! Where the wall time of a run goes.

use std::time::{Duration, Instant};

use serde::{Deserialize, Serialize};

/// Wall time of the parts of all steps so far, and of what follows.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct StepTimes {
    /// All steps of the run.
    pub run: Duration,
    /// Steps of the units of each stage, all threads together from the first to the last.
    pub stages: Vec<Duration>,
    /// The exchange between them.
    pub exchange: Duration,
    /// Recording.
    pub recording: Duration,
    /// Checkpoints.
    pub checkpoints: Duration,
    /// What goes on after the run, with recording.
    pub after: Duration,
}

impl StepTimes {
    /// No time yet for so many stages.
    pub fn of(stages: usize) -> Self {
        Self { stages: vec![Duration::ZERO; stages], ..Self::default() }
    }

    /// All parts of the steps.
    pub fn of_steps(&self) -> Duration {
        self.stages.iter().sum::<Duration>() + self.exchange + self.recording
    }
}

/// Measures the time of what may have begun in another run.
pub struct Timer {
    before: Duration,
    begin: Instant,
}

impl Timer {
    /// Goes on behind a time.
    pub fn after(before: Duration) -> Self {
        Self { before, begin: Instant::now() }
    }

    /// The time until now.
    pub fn elapsed(&self) -> Duration {
        self.before + self.begin.elapsed()
    }
}

/// Measures laps.
pub struct Stopwatch(Instant);

impl Stopwatch {
    /// Starts now.
    pub fn start() -> Self {
        Self(Instant::now())
    }

    /// The time since the last lap or the start.
    pub fn lap(&mut self) -> Duration {
        let now = Instant::now();
        let lap = now - self.0;
        self.0 = now;
        lap
    }
}
