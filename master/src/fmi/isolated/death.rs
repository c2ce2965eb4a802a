//! Why the process of an isolated FMU has ended.

use std::os::unix::process::ExitStatusExt;
use std::process::ExitStatus;
use std::time::Duration;

use crate::fmi::watched::{EndedBy, Limit, Page, crash_name};

/// Exit code of a Rust program that has panicked.
const PANIC: i32 = 101;

/// The end of a process.
#[derive(Debug, PartialEq)]
pub struct Death {
    /// The function in which it was.
    pub function: String,
    /// The reason.
    pub reason: String,
}

impl Death {
    /// That of a process which has ended with a status.
    pub fn of(page: &Page, status: ExitStatus) -> Self {
        let code = status.code().unwrap_or(0);
        let by = page.culprit().map(|culprit| culprit.by);
        let reason = match (by, status.signal()) {
            (Some(EndedBy::Exit), _) => format!("it has ended its process by exit({code})"),
            (Some(EndedBy::SignalFromOutside(signal)), _) => from_outside(signal),
            (Some(EndedBy::Crash(signal)), _) | (None, Some(signal)) => crash_name(signal)
                .map_or_else(|| from_outside(signal), |name| format!("it crashed with {name}")),
            (None, None) if code == PANIC => {
                "its process has failed with the message above, which is a fault of Hotfoot"
                    .to_owned()
            }
            (None, None) => format!("it has ended its process by _exit({code})"),
        };
        Self { function: function(page), reason }
    }

    /// That of a process which was ended because a call took longer than `limit`.
    pub fn overdue(page: &Page, longest: Duration, limit: Limit) -> Self {
        let (seconds, option) = (longest.as_secs_f64(), limit.option());
        let reason =
            format!("it did not return within {seconds} s ({option}), so its process was ended");
        Self { function: function(page), reason }
    }

    /// That of a process which was ended because nobody understands what it answers.
    pub fn senseless(page: &Page) -> Self {
        let reason =
            "it has damaged the memory by which it answers, so its process was ended".to_owned();
        Self { function: function(page), reason }
    }
}

fn from_outside(signal: i32) -> String {
    format!("its process was ended from outside, by signal {signal}")
}

/// The function that is being called.
fn function(page: &Page) -> String {
    let call = page.calls().into_iter().next();
    call.map_or_else(|| "what it does between two calls".to_owned(), |call| call.function)
}
