//! The thread that has ended the program, by a crash or by `exit`.

use std::path::PathBuf;
use std::sync::atomic::{AtomicU8, AtomicU32, AtomicU64, Ordering};

unsafe extern "C" {
    /// These are defined in `crash.c`.
    fn hotfoot_watch_crashes(record: *const Record);
    fn hotfoot_watch_thread(thread: u32, counter: *const AtomicU64);
    fn hotfoot_expect_exit();
}

/// Bytes that are kept of a library's path.
const PATH: usize = 512;
/// `EXIT` of `crash.c`.
const EXIT: u32 = 1 << 16;
/// `OUTSIDE` of `crash.c`.
const OUTSIDE: u32 = 1 << 17;
/// `UNKNOWN_THREAD` of `crash.c`.
const UNKNOWN_THREAD: u32 = u32::MAX;

/// What `crash.c` writes: `struct record` there.
#[repr(C)]
pub(super) struct Record {
    /// A signal with `EXIT` or `OUTSIDE`; 0 while nothing has happened.
    event: AtomicU32,
    /// Number of the thread, from 1, if it was in a call; 0 if it was in none.
    thread: AtomicU32,
    /// Path of the library or program whose code ran.
    library: [AtomicU8; PATH],
}

/// How a thread has ended the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EndedBy {
    /// It called `exit`.
    Exit,
    /// It crashed with this signal.
    Crash(i32),
    /// Another process sent this signal.
    SignalFromOutside(i32),
}

/// What a crash is, with the name of its signal; none for signals that are no crash.
pub fn crash_name(signal: i32) -> Option<&'static str> {
    Some(match signal {
        4 => "an illegal instruction (SIGILL)",
        6 => "abort (SIGABRT)",
        7 => "a memory error (SIGBUS)",
        8 => "an arithmetic error (SIGFPE)",
        11 => "a memory error (SIGSEGV)",
        _ => return None,
    })
}

/// The thread that has ended the program.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Culprit {
    /// How.
    pub by: EndedBy,
    /// Number of the thread, from 0, if it was calling an FMU.
    pub caller: Option<usize>,
    /// Whether it is a thread that has never called an FMU, such as one that an FMU has started.
    pub is_unknown_thread: bool,
    /// The library or program whose code ran at a crash, if that is known.
    pub library: Option<PathBuf>,
}

impl Record {
    /// Who has ended the program, if it was one of its threads.
    pub fn culprit(&self) -> Option<Culprit> {
        let event = self.event.load(Ordering::Acquire);
        let signal = (event & 0xffff) as i32;
        let by = match event {
            0 => return None,
            EXIT => EndedBy::Exit,
            _ if event & OUTSIDE != 0 => EndedBy::SignalFromOutside(signal),
            _ => EndedBy::Crash(signal),
        };
        let thread = self.thread.load(Ordering::Relaxed);
        let path = self.library.iter().map(|byte| byte.load(Ordering::Relaxed));
        let path: Vec<u8> = path.take_while(|&byte| byte != 0).collect();
        let is_unknown_thread = thread == UNKNOWN_THREAD;
        Some(Culprit {
            by,
            caller: (!is_unknown_thread)
                .then(|| thread.checked_sub(1))
                .flatten()
                .map(|n| n as usize),
            is_unknown_thread,
            library: (!path.is_empty()).then(|| String::from_utf8_lossy(&path).as_ref().into()),
        })
    }
}

/// Writes from now on into `record` who ends the program.
pub(super) fn watch(record: &'static Record) {
    // SAFETY: it sets handlers that call nothing but what handlers may call, and the record lives as
    // long as the process.
    unsafe { hotfoot_watch_crashes(record) };
}

/// Notes that the program ends now by itself.
pub(super) fn expect_exit() {
    // SAFETY: it only sets a flag of `crash.c`.
    unsafe { hotfoot_expect_exit() };
}

/// Lets the handlers know the number of this thread and its counter of calls.
pub(super) fn watch_thread(number: usize, counter: &'static AtomicU64) {
    // SAFETY: the counter lives as long as the process.
    unsafe { hotfoot_watch_thread(number as u32 + 1, counter) };
}
