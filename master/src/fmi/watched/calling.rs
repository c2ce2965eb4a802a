//! The page of this process, and its calls of FMUs, which are noted there.

use std::ffi::CStr;
use std::io;
use std::path::Path;
use std::sync::OnceLock;

use super::culprit;
use super::labels::Label;
use super::page::Page;
use super::slot::Slot;

/// The page of this process, if it has a parent that watches it.
static OWN: OnceLock<Page> = OnceLock::new();

thread_local! {
    /// Where this thread notes its calls.
    static SLOT: Option<&'static Slot> = take_slot();
}

/// The page of this process, if it has a parent that watches it.
pub fn own() -> Option<&'static Page> {
    OWN.get()
}

/// Lets the parent, which has made the page in `file`, watch this process from now on.
///
/// # Errors
/// When the file cannot be mapped.
pub fn watch(file: &Path) -> io::Result<&'static Page> {
    let opened = Page::open(file)?;
    let page = OWN.get_or_init(|| opened);
    culprit::watch(page.record());
    // The thread that begins is no unknown one, even if it calls no FMU.
    SLOT.with(|_| ());
    Ok(page)
}

/// The name of what is called, on the page of this process.
pub(in crate::fmi) fn label(name: &str) -> Label {
    own().map_or(Label::default(), |page| page.labels().add(name))
}

/// Notes that this thread calls `function` of what `label` names, while `call` runs.
pub(in crate::fmi) fn calling<T>(label: Label, function: &CStr, call: impl FnOnce() -> T) -> T {
    let Some(slot) = SLOT.try_with(|slot| *slot).ok().flatten() else { return call() };
    slot.begin(label, function);
    let result = call();
    slot.end();
    result
}

/// Notes that the program ends now, and what this thread calls until it has ended.
pub(in crate::fmi) fn call_until_the_end(label: Label, function: &CStr) {
    culprit::expect_exit();
    if let Some(slot) = SLOT.try_with(|slot| *slot).ok().flatten() {
        slot.begin(label, function);
    }
}

/// A slot for this thread, which the handler of crashes knows too.
fn take_slot() -> Option<&'static Slot> {
    let (number, slot) = own()?.take_slot()?;
    culprit::watch_thread(number, &slot.counter);
    Some(slot)
}
