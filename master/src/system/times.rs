//! Where the wall time of a run goes.

use std::time::{Duration, Instant};

/// Wall time of the parts of all steps so far, and of what follows.
#[derive(Debug, Clone, Copy, Default)]
pub struct StepTimes {
    /// Steps of the train.
    pub train: Duration,
    /// Steps of the vehicles, all threads together from the first to the last.
    pub vehicles: Duration,
    /// Steps of the rail.
    pub rail: Duration,
    /// The master's own work between them.
    pub exchange: Duration,
    /// Recording.
    pub recording: Duration,
    /// The rails after the run, with recording.
    pub rails_after: Duration,
}

impl StepTimes {
    /// All parts of the steps.
    pub fn of_steps(&self) -> Duration {
        self.train + self.vehicles + self.rail + self.exchange + self.recording
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
