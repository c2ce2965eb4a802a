//! Why the child has ended: an FMU, somebody else, or this program itself.

use std::path::Path;
use std::process::ExitStatus;

use hotfoot::run::signal_name;
use hotfoot::watched::{Call, Culprit, EndedBy, Page, crash_name};
use numerics::seconds;

use super::resources::{Resources, memory_limit, spent_processor_time};
use super::watch::{Ended, GRACE};
use crate::output::tell;

/// Exit code of a Rust program that has panicked.
const PANIC: i32 = 101;
/// SIGABRT and SIGKILL.
const ABORT: i32 = 6;
const KILL: i32 = 9;
/// SIGXCPU.
const PROCESSOR_TIME: i32 = 24;
/// Calls that a sentence names.
const NAMED_CALLS: usize = 5;

/// Why a child has ended.
#[derive(Debug, Default)]
pub struct Blame {
    /// The reason.
    pub sentence: String,
    /// The signal, if it is what somebody wanted.
    pub interrupted: Option<i32>,
    /// Whether it was to end at once, without completing anything.
    pub at_once: bool,
}

impl Blame {
    /// Tells what was wrong after all was done.
    pub fn warn(&self) {
        tell(format_args!("warning: all is complete, but afterwards {}", self.sentence));
    }

    /// Tells the reason, and gives the exit code for it.
    pub fn tell(&self) -> u8 {
        tell(&self.sentence);
        self.interrupted.map_or(1, exit_code)
    }
}

/// The exit code of a program that a signal has stopped.
pub fn exit_code(signal: i32) -> u8 {
    128 + u8::try_from(signal).unwrap_or(0)
}

/// All that is known of the end of a child.
pub struct Death<'d> {
    /// Its status.
    pub status: ExitStatus,
    /// Whether this program has ended it.
    pub ended: Ended,
    /// What it has written.
    pub page: &'d Page,
    /// What the system had counted before.
    pub before: &'d Resources,
}

impl Death<'_> {
    /// Why the child has ended, where it did not do so in order; `finished` is its exit code if all was
    /// done before, and its libraries lie in the folder `temporary`.
    pub fn blame(&self, temporary: &Path, finished: Option<u8>) -> Option<Blame> {
        let culprit = self.page.culprit();
        if finished.is_some() && culprit.is_none() && self.ended == Ended::NotByUs {
            return signal_of(self.status).map(|_| self.by_the_status().into());
        }
        Some(match &self.ended {
            Ended::AtOnce(signal) => Blame { at_once: true, ..interrupted(*signal, " again") },
            Ended::BeforeRecords(signal) => interrupted(*signal, ""),
            Ended::Stuck(signal) => {
                let calls = calls(&self.page.calls());
                interrupted(
                    *signal,
                    &format!("; {calls} did not return within {GRACE:?} after that"),
                )
            }
            Ended::Overdue(overdue) => {
                let Call { subject, function, .. } = &overdue.call;
                let (limit, option) = (overdue.limit, overdue.option);
                let sentence =
                    format!("{subject}: {function} did not return within {limit} s ({option})");
                self.in_step(sentence).into()
            }
            Ended::NotByUs => match culprit {
                Some(culprit) => self.in_step(self.by_a_thread(&culprit, temporary)).into(),
                None => self.in_step(self.by_the_status()).into(),
            },
        })
    }

    /// The sentence with the time of the step, if there was one.
    fn in_step(&self, sentence: String) -> String {
        match self.page.records() {
            0 => sentence,
            _ => format!("at {} s: {sentence}", seconds(self.page.step().1)),
        }
    }

    /// An end by one of the child's threads.
    fn by_a_thread(&self, culprit: &Culprit, temporary: &Path) -> String {
        let calls = self.page.calls();
        let call = calls.iter().find(|call| Some(call.thread) == culprit.caller);
        let library = culprit.library.as_ref().filter(|library| library.starts_with(temporary));
        let library = library.and_then(|library| library.file_name());
        let own_thread = if culprit.is_unknown_thread { " in a thread of its own" } else { "" };
        let subject = match (call, library) {
            (Some(Call { subject, function, .. }), _) => format!("{subject}: {function}"),
            (None, Some(library)) => format!("{}{own_thread}", library.display()),
            (None, None) if culprit.is_unknown_thread => {
                "a thread that an FMU has started".to_owned()
            }
            (None, None) => "Hotfoot itself".to_owned(),
        };
        match culprit.by {
            EndedBy::Exit => {
                let code = self.status.code().unwrap_or(0);
                format!("{subject} has ended the program by exit({code})")
            }
            EndedBy::Crash(signal) => format!("{subject} {}", crash(signal)),
            EndedBy::SignalFromOutside(signal) => from_outside(signal),
        }
    }

    /// An end of which only the status is known.
    fn by_the_status(&self) -> String {
        let calls = self.page.calls();
        match (signal_of(self.status), self.status.code()) {
            (Some(KILL | PROCESSOR_TIME), _) if spent_processor_time().is_some() => format!(
                "the system has killed the program at the limit of {} s of processor time (ulimit -t)",
                spent_processor_time().unwrap_or_default()
            ),
            (Some(KILL), _) if self.before.memory_ran_out() => {
                "the system has killed the program (SIGKILL) because memory ran out".to_owned()
            }
            // One from outside would have been noted, unless an FMU handles signals itself.
            (Some(signal), _) if crash_name(signal).is_some() => match calls.as_slice() {
                [] => format!("the program {} while no FMU was called", crash(signal)),
                calls => format!("{} {}", self::calls(calls), crash(signal)),
            },
            (Some(signal), _) => from_outside(signal),
            (None, Some(PANIC)) => {
                "Hotfoot itself has failed, with the message above; this is a fault of \
                                    Hotfoot, not of an FMU"
                    .to_owned()
            }
            (None, code) if calls.is_empty() => format!(
                "the program has ended with code {} before it was done, while no FMU was called; a \
                 thread that an FMU has started may have ended it",
                code.unwrap_or(0)
            ),
            (None, code) => {
                let calls = self::calls(&calls);
                format!("{calls} has ended the program by _exit({})", code.unwrap_or(0))
            }
        }
    }
}

impl From<String> for Blame {
    fn from(sentence: String) -> Self {
        Self { sentence, ..Self::default() }
    }
}

fn interrupted(signal: i32, further: &str) -> Blame {
    let sentence = format!("interrupted by {}{further}", signal_name(signal));
    Blame { sentence, interrupted: Some(signal), at_once: false }
}

/// Calls that go on, of which one is meant.
fn calls(calls: &[Call]) -> String {
    let name = |call: &Call| format!("{}: {}", call.subject, call.function);
    match calls {
        [] => "something".to_owned(),
        [call] => name(call),
        several => {
            let names: Vec<_> = several.iter().take(NAMED_CALLS).map(name).collect();
            let more = several.len().saturating_sub(NAMED_CALLS);
            let more = if more > 0 { format!(" and {more} more") } else { String::new() };
            format!("one of {}{more}", names.join(", "))
        }
    }
}

/// That something crashed, with the signal.
fn crash(signal: i32) -> String {
    let memory = memory_limit().filter(|_| signal == ABORT).map(|limit| {
        format!("; memory may have run out, of which it may have {:.0} MB (ulimit -v)", limit / 1e6)
    });
    let name = crash_name(signal).unwrap_or("a signal");
    format!("crashed with {name}{}", memory.unwrap_or_default())
}

fn from_outside(signal: i32) -> String {
    format!("the program was ended from outside, by {}; no FMU is to blame", name_of(signal))
}

#[cfg(unix)]
fn name_of(signal: i32) -> &'static str {
    signal_hook::low_level::signal_name(signal).unwrap_or("a signal")
}

#[cfg(not(unix))]
fn name_of(_: i32) -> &'static str {
    "an exception"
}

#[cfg(unix)]
fn signal_of(status: ExitStatus) -> Option<i32> {
    std::os::unix::process::ExitStatusExt::signal(&status)
}

/// On Windows an exception is a code beyond those of programs.
#[cfg(not(unix))]
fn signal_of(status: ExitStatus) -> Option<i32> {
    status.code().filter(|code| !(0..=255).contains(code))
}
