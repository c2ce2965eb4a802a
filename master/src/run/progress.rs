//! The progress bar: simulated time, speed against real time, time left, and live figures.

use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Wall time between two updates.
const UPDATE: Duration = Duration::from_millis(200);

/// A progress bar for a run.
pub struct Progress {
    bar: ProgressBar,
    begin: Instant,
    updated: Instant,
    duration: f64,
    /// Time from which the run goes on, s.
    from: f64,
}

impl Progress {
    /// A bar for a run of `steps` steps and `duration` seconds; hidden where the terminal is
    /// none, or when asked to be.
    pub fn new(steps: u64, duration: f64, quiet: bool) -> Self {
        let target =
            if quiet { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
        let bar = ProgressBar::with_draw_target(Some(steps), target);
        let style = ProgressStyle::with_template("{bar:30} {percent:>3} %  {msg}, {eta} left");
        bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
        let now = Instant::now();
        Self { bar, begin: now, updated: now, duration, from: 0.0 }
    }

    /// The run goes on from `done` steps and a time in s.
    pub fn continue_from(&mut self, done: u64, time: f64) {
        self.bar.set_position(done);
        self.bar.reset_eta();
        self.from = time;
    }

    /// Tells something that the user should know before the run is over.
    pub fn tell(&self, sentence: &str) {
        self.bar.suspend(|| eprintln!("note: {sentence}"));
    }

    /// Shows the time after `done` steps and what `figures` says, if it is due.
    pub fn show(&mut self, done: u64, time: f64, figures: impl FnOnce() -> String) {
        let now = Instant::now();
        if now - self.updated < UPDATE {
            return;
        }
        self.updated = now;
        self.bar.set_position(done);
        let real_time = (time - self.from) / (now - self.begin).as_secs_f64();
        self.bar.set_message(format!(
            "{time:.1} of {:.0} s, {real_time:.2} x real time{}",
            self.duration,
            figures(),
        ));
    }

    /// Shows the time to which the rails have come alone, if it is due.
    pub fn show_rails(&mut self, time: f64) {
        let now = Instant::now();
        if now - self.updated < UPDATE {
            return;
        }
        self.updated = now;
        self.bar.set_message(format!("the rails alone, {:.1} min", time / 60.0));
    }

    /// Removes the bar.
    pub fn finish(self) {
        self.bar.finish_and_clear();
    }
}
