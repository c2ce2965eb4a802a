//! What a thread calls: written by the thread, read by the parent at any time.

use std::ffi::CStr;
use std::sync::atomic::{AtomicU32, AtomicU64, Ordering};

use super::labels::Label;

/// Bytes that are kept of a function's name.
const NAME: usize = 32;

/// What a thread calls. The counter goes up at the beginning and at the end of each call, so it is odd
/// while a call goes on; who reads the rest compares it before and after. No clock is read here: the
/// parent sees how long the counter stands still.
#[repr(C, align(128))]
pub struct Slot {
    pub(super) counter: AtomicU64,
    label: AtomicU32,
    name: [AtomicU64; NAME / 8],
}

/// A call that goes on.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Call {
    /// Number of the thread, from 0.
    pub thread: usize,
    /// Counts the calls of the thread: another number is another call.
    pub counter: u64,
    /// Name of the function, or what else is done with the FMU.
    pub function: String,
    /// The instance with its file, or the file.
    pub subject: String,
}

impl Slot {
    /// Notes that the thread begins a call.
    pub(super) fn begin(&self, label: Label, function: &CStr) {
        let mut bytes = [0; NAME];
        let name = function.to_bytes();
        let length = name.len().min(NAME);
        bytes[..length].copy_from_slice(&name[..length]);
        for (stored, word) in self.name.iter().zip(bytes.as_chunks::<8>().0) {
            stored.store(u64::from_ne_bytes(*word), Ordering::Relaxed);
        }
        self.label.store(label.0, Ordering::Relaxed);
        self.count();
    }

    /// Notes that the call has returned.
    pub(super) fn end(&self) {
        self.count();
    }

    /// Only the thread itself writes, so that this needs no locked instruction.
    fn count(&self) {
        let counter = self.counter.load(Ordering::Relaxed);
        self.counter.store(counter.wrapping_add(1), Ordering::Release);
    }

    /// The counter, the label and the name of the call that goes on, if there is one.
    pub(super) fn read(&self) -> Option<(u64, Label, String)> {
        let counter = self.counter.load(Ordering::Acquire);
        if counter.is_multiple_of(2) {
            return None;
        }
        let label = Label(self.label.load(Ordering::Relaxed));
        let words = self.name.iter().map(|word| word.load(Ordering::Relaxed).to_ne_bytes());
        let bytes: Vec<u8> = words.flatten().take_while(|&byte| byte != 0).collect();
        std::sync::atomic::fence(Ordering::Acquire);
        let same = self.counter.load(Ordering::Relaxed) == counter;
        same.then(|| (counter, label, String::from_utf8_lossy(&bytes).into_owned()))
    }
}
