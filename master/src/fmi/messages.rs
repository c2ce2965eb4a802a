//! What FMUs log: a store for each instance, and to which of them a message belongs.
//!
//! FMUs hand back a null pointer or one of their own for the environment, log from threads of their
//! own, and after they were freed. So the pointer is only looked up, and the stores live as long as the
//! process.

use std::cell::Cell;
use std::ffi::c_int;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

use numerics::seconds;
use serde::{Deserialize, Serialize};

use super::binding::OK;
use crate::files::printable::printable;

/// Warnings kept per instance; an FMU that warns in each step must not fill the memory.
const MAX_WARNINGS: usize = 20;

/// All stores, in the order in which they were made.
static STORES: Mutex<Vec<&'static Messages>> = Mutex::new(vec![]);

thread_local! {
    /// The messages of the instance that this thread calls.
    static CALLED: Cell<Option<&'static Messages>> = const { Cell::new(None) };
}

/// Collects the messages of one instance: the last one for error messages, and warnings.
pub struct Messages {
    /// Name and file of the instance.
    label: String,
    /// The loaded binary.
    binary: PathBuf,
    content: Mutex<Content>,
    /// Whether the instance was freed: nobody asks for its messages any more.
    freed: AtomicBool,
    /// Time to which the instance has come, s, as bits; NaN before its initialisation.
    time: AtomicU64,
}

/// What an instance has said so far, and to which time it has come.
#[derive(Serialize, Deserialize)]
pub struct Said {
    content: Content,
    time: f64,
}

impl Said {
    /// The same with the warnings that another has kept, and no others.
    #[cfg(target_os = "linux")]
    pub fn with_warnings_of(mut self, other: Self) -> Self {
        (self.content.warnings, self.content.more) = (other.content.warnings, other.content.more);
        self
    }
}

#[derive(Clone, Default, Serialize, Deserialize)]
struct Content {
    last: Option<String>,
    warnings: Vec<String>,
    /// Warnings that were not kept.
    more: usize,
    /// Whether a message has come that explains a warning not yet noted.
    warned: bool,
    /// Whether it was noted that the instance changes how the processor computes.
    changes_environment: bool,
}

impl Content {
    fn warn(&mut self, text: String) {
        match self.warnings.len() < MAX_WARNINGS {
            true => self.warnings.push(text),
            false => self.more += 1,
        }
    }
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Messages {
    /// A store for an instance of a binary, whose name and file `label` tells. It is never freed, as the
    /// FMU may log at any time.
    pub fn of(label: &str, binary: &Path) -> &'static Self {
        let messages: &'static Self = Box::leak(Box::new(Self {
            label: label.to_owned(),
            binary: binary.to_owned(),
            content: Mutex::default(),
            freed: AtomicBool::new(false),
            time: AtomicU64::new(f64::NAN.to_bits()),
        }));
        lock(&STORES).push(messages);
        messages
    }

    /// Notes that this thread calls the instance; gives what it called before, for [`Self::leave`].
    pub fn enter(&'static self) -> Option<&'static Self> {
        CALLED.try_with(|called| called.replace(Some(self))).ok().flatten()
    }

    /// Notes that the call has ended.
    pub fn leave(outer: Option<&'static Self>) {
        let _ = CALLED.try_with(|called| called.set(outer));
    }

    /// The store that a message belongs to: that of the environment, if it is one; else that of the
    /// instance which this thread calls; else that of the last instance of the binary `caller`; else that
    /// of the last instance of all.
    fn addressed(environment: usize, caller: &Path) -> Option<&'static Self> {
        let stores = lock(&STORES);
        let known =
            || stores.iter().find(|store| std::ptr::from_ref(**store).addr() == environment);
        let of_binary = || stores.iter().rev().find(|store| store.binary == caller);
        let called = CALLED.try_with(Cell::get).ok().flatten();
        let found = known().copied().or(called);
        found.or_else(|| of_binary().or(stores.last()).copied())
    }

    /// Takes in a message of an FMU, wherever it comes from.
    pub fn take_in(environment: usize, caller: &Path, status: c_int, text: &str) {
        if let Some(messages) = Self::addressed(environment, caller) {
            messages.add(status, printable(text));
        }
    }

    /// The last message.
    pub fn last(&self) -> Option<String> {
        lock(&self.content).last.clone()
    }

    /// Takes the warnings out: the first, and how many more there were.
    pub fn take_warnings(&self) -> Vec<String> {
        let mut content = lock(&self.content);
        let mut warnings = std::mem::take(&mut content.warnings);
        match std::mem::take(&mut content.more) {
            0 => {}
            more => warnings.push(format!("and {more} more messages")),
        }
        warnings
    }

    /// Keeps a warning that has come from elsewhere.
    #[cfg(target_os = "linux")]
    pub fn warn(&self, text: String) {
        lock(&self.content).warn(text);
    }

    /// What the instance has said so far.
    pub fn save(&self) -> Said {
        Said {
            content: lock(&self.content).clone(),
            time: f64::from_bits(self.time.load(Ordering::Relaxed)),
        }
    }

    /// Goes on from what another instance had said.
    pub fn restore(&self, said: Said) {
        *lock(&self.content) = said.content;
        self.reached(said.time);
    }

    /// Notes the time to which the instance has come, s.
    pub fn reached(&self, time: f64) {
        self.time.store(time.to_bits(), Ordering::Relaxed);
    }

    /// That time as part of a sentence.
    fn when(&self) -> String {
        let time = f64::from_bits(self.time.load(Ordering::Relaxed));
        if time.is_nan() { String::new() } else { format!(" at {} s", seconds(time)) }
    }

    /// Keeps a warning that came without a message since the one before.
    pub fn note_warning(&self, action: &str) {
        let mut content = lock(&self.content);
        if !std::mem::take(&mut content.warned) {
            content.warn(format!("{action} returned fmi2Warning without a message"));
        }
    }

    /// Keeps, the first time, what the instance did to how the processor computes.
    pub fn note_environment(&self, what: &str) {
        let mut content = lock(&self.content);
        if !std::mem::replace(&mut content.changes_environment, true) {
            let when = self.when();
            content.warn(format!(
                "{what}{when}, which would change what other units compute; it was put back, as after \
                 every later call"
            ));
        }
    }

    /// Notes that the instance is freed: what it logs from now on is told at once.
    pub fn free(&self) {
        self.freed.store(true, Ordering::Relaxed);
    }

    fn add(&self, status: c_int, message: String) {
        let mut content = lock(&self.content);
        if status != OK {
            content.warned = true;
            if self.freed.load(Ordering::Relaxed) && content.warnings.len() < MAX_WARNINGS {
                let line = format!("warning: {}: {message} (after fmi2FreeInstance)", self.label);
                let _ = writeln!(std::io::stderr(), "{line}");
            }
            content.warn(message.clone());
        }
        content.last = Some(message);
    }
}

#[cfg(test)]
mod tests {
    use super::super::binding::WARNING;
    use super::*;

    fn store(binary: &str) -> &'static Messages {
        Messages::of("vehicle[1] (wagon.fmu)", Path::new(binary))
    }

    #[test]
    fn a_warning_without_message_is_noted_and_one_with_a_message_is_not_noted_twice() {
        let messages = store("a.so");
        messages.note_warning("fmi2DoStep");
        assert_eq!(messages.take_warnings(), ["fmi2DoStep returned fmi2Warning without a message"]);
        messages.add(WARNING, "low oil".to_owned());
        messages.note_warning("fmi2DoStep");
        assert_eq!(messages.take_warnings(), ["low oil"]);
    }

    #[test]
    fn an_fmu_that_warns_in_each_step_does_not_fill_the_memory() {
        let messages = store("a.so");
        for step in 0..1000 {
            messages.add(WARNING, format!("step {step}"));
        }
        let warnings = messages.take_warnings();
        assert_eq!(warnings.len(), MAX_WARNINGS + 1);
        assert_eq!(warnings[MAX_WARNINGS], "and 980 more messages");
        assert_eq!(messages.last().as_deref(), Some("step 999"), "the last one explains an error");
    }

    #[test]
    fn an_ordinary_message_is_no_warning() {
        let messages = store("a.so");
        messages.add(OK, "started".to_owned());
        assert_eq!(messages.last().as_deref(), Some("started"));
        assert!(messages.take_warnings().is_empty());
    }

    /// Null, a pointer of the FMU's own, and one of another instance.
    #[test]
    fn a_message_finds_its_instance_by_pointer_by_call_and_by_binary() {
        let (one, two, other) = (store("find-1.so"), store("find-1.so"), store("find-2.so"));
        let taken = |messages: &Messages| messages.take_warnings();
        let address = std::ptr::from_ref(one).addr();
        Messages::take_in(address, Path::new(""), WARNING, "by pointer");
        assert_eq!(taken(one), ["by pointer"]);
        let outer = one.enter();
        for foreign in [0, 1] {
            Messages::take_in(foreign, Path::new("find-2.so"), WARNING, "by call");
            assert_eq!(taken(one), ["by call"]);
        }
        Messages::leave(outer);
        Messages::take_in(0, Path::new("find-1.so"), WARNING, "by binary");
        assert_eq!((taken(two), taken(other)), (vec!["by binary".to_owned()], vec![]));
    }

    #[test]
    fn a_change_of_the_processor_is_told_once_with_its_time() {
        let messages = store("a.so");
        messages.reached(0.05);
        messages.note_environment("fmi2DoStep left the processor with another rounding");
        messages.note_environment("fmi2DoStep left the processor with another rounding");
        let [warning] = messages.take_warnings().try_into().unwrap();
        assert!(warning.contains("another rounding at 0.05 s, which"), "{warning}");
    }
}
