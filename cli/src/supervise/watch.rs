//! Waits for the end of the child, hands signals on to it, and ends it when a call takes too long.

use std::io;
use std::process::{Child, ExitStatus};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::{Duration, Instant};

use hotfoot::watched::Page;

use super::limits::{Limits, Overdue, Stopwatch};

/// Time between two looks at the calls.
const LOOK: Duration = Duration::from_millis(50);
/// How long a call may still take when the run is to stop.
pub const GRACE: Duration = Duration::from_secs(10);

/// Why this program has ended its child.
#[derive(Debug, Clone, PartialEq)]
pub enum Ended {
    /// It has ended itself, or something else has ended it.
    NotByUs,
    /// A call took too long.
    Overdue(Overdue),
    /// A signal came before anything was recorded.
    BeforeRecords(i32),
    /// A signal came, but a call did not return for the time of [`GRACE`].
    Stuck(i32),
    /// The signal came again.
    AtOnce(i32),
}

/// Watches a child.
pub struct Watch<'w> {
    /// What is shared with it.
    pub page: &'w Page,
    /// How long its calls may take.
    pub limits: &'w Limits,
}

impl Watch<'_> {
    /// Waits until the child has ended, and tells whether it was ended by this program.
    ///
    /// # Errors
    /// When the system does not tell.
    pub fn until_end(
        &self,
        child: &mut Child,
        signals: &Signals,
    ) -> io::Result<(ExitStatus, Ended)> {
        let mut stopwatch = Stopwatch::default();
        let mut first: Option<i32> = None;
        let mut looked = Instant::now();
        loop {
            let signal = signals.wait(LOOK);
            if let Some(status) = child.try_wait()? {
                return Ok((status, Ended::NotByUs));
            }
            if let Some(signal) = signal {
                if let Some(ended) = self.stop(signal, first) {
                    return end(child, ended);
                }
                first = first.or(Some(signal));
                stopwatch = Stopwatch::default();
            }
            if looked.elapsed() < LOOK {
                continue;
            }
            let passed = looked.elapsed().min(2 * LOOK);
            looked = Instant::now();
            let stepping = self.page.records() > 0;
            let overdue = stopwatch.look(self.page.calls(), passed, self.limits, stepping);
            if let Some(overdue) = overdue {
                return end(child, Ended::Overdue(overdue));
            }
            if let Some(signal) = first.or(self.page.stop()).filter(|_| stopwatch.longest() > GRACE)
            {
                return end(child, Ended::Stuck(signal));
            }
        }
    }

    /// What a signal means: the run stops at its next step, or the child ends now.
    fn stop(&self, signal: i32, first: Option<i32>) -> Option<Ended> {
        self.page.request_stop(signal);
        match first {
            // Who closes a terminal may send several.
            Some(before) if before == signal && signal != HANGUP => Some(Ended::AtOnce(signal)),
            _ if self.page.records() == 0 => Some(Ended::BeforeRecords(signal)),
            _ => None,
        }
    }
}

/// Ends the child, unless it has just done all it had to do.
fn end(child: &mut Child, ended: Ended) -> io::Result<(ExitStatus, Ended)> {
    child.kill()?;
    Ok((child.wait()?, ended))
}

/// SIGHUP.
const HANGUP: i32 = 1;

/// The signals that this process gets.
pub struct Signals(Receiver<i32>);

impl Signals {
    /// Handles the signals that end a program, and the one that tells the end of a child.
    ///
    /// # Errors
    /// When the system refuses.
    #[cfg(unix)]
    pub fn new() -> io::Result<Self> {
        use signal_hook::consts::{SIGCHLD, SIGXFSZ};

        let (sender, receiver) = channel();
        // A file that may not grow is an error of the one who writes it.
        let wanted: Vec<i32> = ending().chain([SIGCHLD, SIGXFSZ]).collect();
        let mut signals = signal_hook::iterator::Signals::new(wanted)?;
        std::thread::Builder::new().name("signals".to_owned()).spawn(move || {
            for signal in signals.forever().filter(|&signal| signal != SIGXFSZ) {
                if sender.send(signal).is_err() {
                    return;
                }
            }
        })?;
        Ok(Self(receiver))
    }

    /// Handles none: the system ends this program, and with it the child.
    #[cfg(not(unix))]
    pub fn new() -> io::Result<Self> {
        let (sender, receiver) = channel();
        std::mem::forget(sender);
        Ok(Self(receiver))
    }

    /// Waits for a signal, no longer than a time; the end of a child ends the waiting too.
    fn wait(&self, time: Duration) -> Option<i32> {
        match self.0.recv_timeout(time) {
            #[cfg(unix)]
            Ok(signal_hook::consts::SIGCHLD) => None,
            Ok(signal) => Some(signal),
            Err(RecvTimeoutError::Timeout) => None,
            Err(RecvTimeoutError::Disconnected) => {
                std::thread::sleep(time);
                None
            }
        }
    }
}

/// The signals that end a program, without SIGHUP where that is ignored, as `nohup` does it.
#[cfg(unix)]
pub fn ending() -> impl Iterator<Item = i32> {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};

    let hangup = (!is_ignored(SIGHUP)).then_some(SIGHUP);
    [SIGINT, SIGTERM].into_iter().chain(hangup)
}

/// Whether a signal was ignored when this program was started (proc_pid_status(5)).
#[cfg(unix)]
fn is_ignored(signal: i32) -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let mask = mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).unwrap_or(0);
    mask >> (signal - 1) & 1 == 1
}
