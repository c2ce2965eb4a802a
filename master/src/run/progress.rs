//! How far a run is: simulated time, speed against real time, time left, and live figures.
//!
//! A terminal shows a bar; what else reads the standard error gets a line now and then.

use std::io::{self, IsTerminal};
use std::time::{Duration, Instant};

use indicatif::{HumanDuration, ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Wall time between two updates of a bar.
const UPDATE: Duration = Duration::from_millis(200);

/// Wall time between two lines.
const LINE: Duration = Duration::from_secs(10);

/// Tells how far a run is.
pub struct Progress {
    shown: Shown,
    begin: Instant,
    updated: Instant,
    steps: u64,
    duration: f64,
    /// Steps and time from which the run goes on, s.
    from: (u64, f64),
}

/// What is shown.
enum Shown {
    /// A bar on the terminal.
    Bar(ProgressBar),
    /// Lines on the standard error, which is no terminal.
    Lines,
    /// Nothing.
    Nothing,
}

impl Progress {
    /// Tells of a run of `steps` steps and `duration` seconds; nothing if it shall be `quiet`.
    pub fn new(steps: u64, duration: f64, quiet: bool) -> Self {
        let shown = match io::stderr().is_terminal() {
            _ if quiet => Shown::Nothing,
            true => Shown::Bar(bar(steps)),
            false => Shown::Lines,
        };
        let now = Instant::now();
        Self { shown, begin: now, updated: now, steps, duration, from: (0, 0.0) }
    }

    /// The run goes on from `done` steps and a time in s.
    pub fn continue_from(&mut self, done: u64, time: f64) {
        if let Shown::Bar(bar) = &self.shown {
            bar.set_position(done);
            bar.reset_eta();
        }
        self.from = (done, time);
    }

    /// Tells something that the user should know before the run is over.
    pub fn tell(&self, sentence: &str) {
        let tell = || eprintln!("note: {sentence}");
        match &self.shown {
            Shown::Bar(bar) => bar.suspend(tell),
            Shown::Lines | Shown::Nothing => tell(),
        }
    }

    /// Shows the time after `done` steps and what `figures` says, if it is due.
    pub fn show(&mut self, done: u64, time: f64, figures: impl FnOnce() -> String) {
        if !self.is_due() {
            return;
        }
        let elapsed = self.begin.elapsed();
        let real_time = (time - self.from.1) / elapsed.as_secs_f64();
        let message =
            format!("{time:.1} of {:.0} s, {real_time:.2} x real time{}", self.duration, figures());
        match &self.shown {
            Shown::Bar(bar) => {
                bar.set_position(done);
                bar.set_message(message);
            }
            Shown::Lines => {
                let left = left(elapsed, done - self.from.0, self.steps - done);
                eprintln!("{message}, {} left", HumanDuration(left));
            }
            Shown::Nothing => {}
        }
    }

    /// Shows the time to which the rails have come alone, if it is due.
    pub fn show_rails(&mut self, time: f64) {
        if !self.is_due() {
            return;
        }
        let message = format!("the rails alone, {:.1} min", time / 60.0);
        match &self.shown {
            Shown::Bar(bar) => bar.set_message(message),
            Shown::Lines => eprintln!("{message}"),
            Shown::Nothing => {}
        }
    }

    /// Whether it is time to show something, and then not again at once.
    fn is_due(&mut self) -> bool {
        let interval = match self.shown {
            Shown::Bar(_) => UPDATE,
            Shown::Lines => LINE,
            Shown::Nothing => return false,
        };
        let now = Instant::now();
        let is_due = now - self.updated >= interval;
        if is_due {
            self.updated = now;
        }
        is_due
    }

    /// Removes the bar.
    pub fn finish(self) {
        if let Shown::Bar(bar) = self.shown {
            bar.finish_and_clear();
        }
    }
}

fn bar(steps: u64) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(Some(steps), ProgressDrawTarget::stderr());
    let style = ProgressStyle::with_template("{bar:30} {percent:>3} %  {msg}, {eta} left");
    bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    bar
}

/// Wall time that so many steps will take if as many as are `done` took so long.
fn left(elapsed: Duration, done: u64, steps: u64) -> Duration {
    elapsed.mul_f64(steps as f64 / done.max(1) as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_the_time_left_is_that_of_the_steps_left() {
        assert_eq!(left(Duration::from_secs(30), 1000, 3000), Duration::from_secs(90));
        assert_eq!(left(Duration::from_secs(30), 1000, 0), Duration::ZERO);
    }

    #[test]
    fn a_quiet_run_shows_nothing() {
        let mut progress = Progress::new(10, 1.0, true);
        progress.updated -= LINE;
        progress.show(5, 0.5, || unreachable!("nobody asks for the figures"));
    }

    #[test]
    fn a_line_comes_at_its_interval() {
        let mut progress = Progress::new(10, 1.0, false);
        progress.shown = Shown::Lines;
        assert!(!progress.is_due());
        progress.updated -= LINE;
        assert!(progress.is_due() && !progress.is_due());
    }
}
