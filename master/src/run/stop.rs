//! Whether a run is to stop before its end: its parent says so after a signal, or one of its units.

use std::fmt;

use numerics::seconds;

use crate::fmi::watched;
use crate::system::step::WishToEnd;

/// Why a run that has not failed ends before its time.
#[derive(Debug)]
pub(super) enum Early {
    /// A signal has stopped it.
    Stopped(Stopped),
    /// One of its units wants it to end.
    Wished(WishToEnd),
    /// The program that steps it leaves it at a time, s.
    Left {
        /// Time to which it has come, s.
        time: f64,
    },
}

impl Early {
    /// Time to which the run has come, s.
    pub fn time(&self) -> f64 {
        match self {
            Self::Stopped(Stopped { time, .. })
            | Self::Wished(WishToEnd { time, .. })
            | Self::Left { time } => *time,
        }
    }
}

impl fmt::Display for Early {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Stopped(stopped) => stopped.fmt(f),
            Self::Wished(WishToEnd { of, time, .. }) => {
                let time = seconds(*time);
                write!(f, "the run ended at {time} s, because {of} wanted it to end")
            }
            Self::Left { time } => {
                write!(f, "the program that stepped it left it at {} s", seconds(*time))
            }
        }
    }
}

/// A run that was stopped by a signal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stopped {
    /// The signal.
    pub signal: i32,
    /// Time to which the run had come, s.
    pub time: f64,
}

impl fmt::Display for Stopped {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "interrupted by {} at {} s", signal_name(self.signal), seconds(self.time))
    }
}

/// The signal of Ctrl-C.
pub(super) const INTERRUPT: i32 = 2;

/// What stands for a signal when the parent of the run has ended.
pub const PARENT_GONE: i32 = 9;

/// What people call a signal that stops a run.
pub fn signal_name(signal: i32) -> String {
    match signal {
        1 => "the end of the terminal (SIGHUP)".to_owned(),
        INTERRUPT => "Ctrl-C (SIGINT)".to_owned(),
        15 => "SIGTERM".to_owned(),
        PARENT_GONE => "the end of its parent process".to_owned(),
        24 => "the limit of processor time (SIGXCPU)".to_owned(),
        other => format!("signal {other}"),
    }
}

/// Whether somebody wants the run to stop, before the step that begins at a time, s.
pub(super) fn stopped(step: u64, time: f64) -> Option<Stopped> {
    let page = watched::own()?;
    page.note_step(step, time);
    page.stop().map(|signal| Stopped { signal, time })
}
