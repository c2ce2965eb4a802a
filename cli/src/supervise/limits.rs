//! How long a call of an FMU may take.

use std::collections::HashMap;
use std::time::Duration;

use clap::Args;
use hotfoot::watched::Call;

/// Options of all commands that call FMUs.
#[derive(Args, Debug, Clone, PartialEq)]
pub struct Limits {
    /// Longest time by the clock for loading an FMU, for its instantiation and for each call of its
    /// initialisation, s; 0: any
    #[arg(long, value_name = "SECONDS", default_value_t = 600.0, value_parser = time)]
    start_limit: f64,
    /// Longest time by the clock for each call of an FMU in a step, s; 0: any
    #[arg(long, value_name = "SECONDS", default_value_t = 300.0, value_parser = time)]
    step_limit: f64,
    /// Longest time by the clock for the termination of an FMU, its freeing and its unloading, s; 0: any
    #[arg(long, value_name = "SECONDS", default_value_t = 300.0, value_parser = time)]
    end_limit: f64,
}

/// A time that may be zero.
fn time(text: &str) -> Result<f64, String> {
    let time = text.parse().ok().filter(|time: &f64| time.is_finite() && *time >= 0.0);
    time.ok_or_else(|| "must be a number of seconds, or zero for no limit".to_owned())
}

/// A call that has taken too long.
#[derive(Debug, Clone, PartialEq)]
pub struct Overdue {
    /// The call.
    pub call: Call,
    /// The limit, s.
    pub limit: f64,
    /// The option that sets the limit.
    pub option: &'static str,
}

impl Limits {
    /// The limit for a function and the option that sets it; `stepping` tells whether the run has begun
    /// to step, since variables are set and got before and after.
    fn of(&self, function: &str, stepping: bool) -> (f64, &'static str) {
        let (start, step) =
            ((self.start_limit, "--start-limit"), (self.step_limit, "--step-limit"));
        match function {
            "fmi2Terminate" | "fmi2FreeInstance" | "fmi2FreeFMUstate" => {
                (self.end_limit, "--end-limit")
            }
            _ if hotfoot::UNLOADING.to_str() == Ok(function) => (self.end_limit, "--end-limit"),
            "fmi2DoStep" => step,
            _ if stepping => step,
            _ => start,
        }
    }
}

/// For how long calls go on. What is not seen counts no more than the time between two looks, so that a
/// computer that sleeps or a run that is held makes no call overdue.
#[derive(Default)]
pub struct Stopwatch {
    /// The call of each thread, and how long it has gone on.
    calls: HashMap<usize, (u64, Duration)>,
}

impl Stopwatch {
    /// Counts `passed` on for the calls that go on, and gives one that is overdue.
    pub fn look(
        &mut self,
        calls: Vec<Call>,
        passed: Duration,
        limits: &Limits,
        stepping: bool,
    ) -> Option<Overdue> {
        let before = std::mem::take(&mut self.calls);
        let mut overdue = None;
        for call in calls {
            let same = before.get(&call.thread).filter(|(counter, _)| *counter == call.counter);
            let time = same.map_or(Duration::ZERO, |(_, time)| *time + passed);
            self.calls.insert(call.thread, (call.counter, time));
            let (limit, option) = limits.of(&call.function, stepping);
            if limit > 0.0 && time.as_secs_f64() >= limit {
                overdue = overdue.or(Some(Overdue { call, limit, option }));
            }
        }
        overdue
    }

    /// The longest time for which a call goes on.
    pub fn longest(&self) -> Duration {
        self.calls.values().map(|(_, time)| *time).max().unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LIMITS: Limits = Limits { start_limit: 4.0, step_limit: 2.0, end_limit: 0.0 };

    fn call(counter: u64, function: &str) -> Vec<Call> {
        let (function, subject) = (function.to_owned(), "a".to_owned());
        vec![Call { thread: 3, counter, function, subject }]
    }

    #[test]
    fn each_kind_of_call_has_its_limit() {
        for (function, stepping, limit) in [
            ("loading the binary", false, 4.0),
            ("fmi2Instantiate", false, 4.0),
            ("fmi2EnterInitializationMode", false, 4.0),
            ("fmi2SetReal", false, 4.0),
            ("fmi2SetReal", true, 2.0),
            ("fmi2DoStep", false, 2.0),
            ("fmi2Terminate", true, 0.0),
            ("unloading the binary", true, 0.0),
        ] {
            assert_eq!(LIMITS.of(function, stepping).0, limit, "{function}");
        }
    }

    #[test]
    fn a_call_is_overdue_when_it_is_the_same_for_too_long() {
        let mut watch = Stopwatch::default();
        let second = Duration::from_secs(1);
        let mut look =
            |counter, function| watch.look(call(counter, function), second, &LIMITS, true);
        for counter in [1, 1, 3, 3, 5] {
            assert_eq!(look(counter, "fmi2DoStep"), None);
        }
        assert_eq!(look(5, "fmi2DoStep"), None);
        let overdue = look(5, "fmi2DoStep").expect("for 2 s it was the same call");
        assert_eq!((overdue.limit, overdue.option), (2.0, "--step-limit"));
        for _ in 0..100 {
            assert_eq!(look(7, "fmi2Terminate"), None, "0 is no limit");
        }
    }
}
