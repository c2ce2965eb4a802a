//! Where the wall time of a run goes.

use std::time::{Duration, Instant};

/// Wall time of the parts of all steps so far, and of what follows.
#[derive(Debug, Clone, Default)]
pub struct StepTimes {
    /// Steps of the units of each stage, all threads together from the first to the last.
    pub stages: Vec<Duration>,
    /// The exchange between them.
    pub exchange: Duration,
    /// Recording.
    pub recording: Duration,
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
