//! The binary of an FMU, loaded: its code runs when it is loaded and when the program ends, so both
//! are noted as calls.

use std::ffi::CStr;
use std::path::Path;
use std::sync::{Mutex, PoisonError};

use libloading::{Error, Library};

use super::watched::{Label, call_until_the_end, calling, label};

/// Name of the loading in what the parent sees.
const LOADING: &CStr = c"loading the binary";
/// Name of the unloading in what the parent sees.
pub const UNLOADING: &CStr = c"unloading the binary";
/// FMUs whose unloading is noted by their names.
const NAMED: usize = 5;

/// What has been loaded, as messages call it.
static LOADED: Mutex<Vec<String>> = Mutex::new(vec![]);

/// A loaded binary. It stays loaded as long as the process: threads that it has started, and what it
/// has left with the system for the end, outlive its instances.
pub(super) struct LoadedLibrary {
    library: &'static Library,
    label: Label,
}

impl LoadedLibrary {
    /// Loads a binary of the FMU that messages call `subject`.
    ///
    /// # Errors
    /// When the system cannot load it.
    pub fn load(binary: &Path, subject: &str) -> Result<Self, Error> {
        let label = label(subject);
        // A bare name would be looked for among the system's libraries.
        let path = std::path::absolute(binary).unwrap_or_else(|_| binary.to_owned());
        // SAFETY: loading runs the binary's initialisers; to run a foreign binary is what importing an
        // FMU means, and the user has chosen the file.
        let library = calling(label, LOADING, || unsafe { Library::new(&path) })?;
        let mut loaded = LOADED.lock().unwrap_or_else(PoisonError::into_inner);
        if !loaded.iter().any(|other| other == subject) {
            loaded.push(subject.to_owned());
        }
        Ok(Self { library: Box::leak(Box::new(library)), label })
    }

    /// A function of the binary by its name.
    ///
    /// # Safety
    /// The function has the type `T`.
    ///
    /// # Errors
    /// When there is none.
    pub unsafe fn get<T: Copy>(&self, name: &[u8]) -> Result<T, Error> {
        // SAFETY: as the caller promises; the library stays.
        unsafe { self.library.get::<T>(name) }.map(|function| *function)
    }

    /// Calls code of the binary that is no function of FMI.
    pub fn calling<T>(&self, function: &CStr, call: impl FnOnce() -> T) -> T {
        calling(self.label, function, call)
    }
}

/// Notes that the program ends now, at which the system lets the binaries go.
pub fn note_unloading() {
    let loaded = LOADED.lock().unwrap_or_else(PoisonError::into_inner);
    if loaded.is_empty() {
        return;
    }
    let mut names = loaded[..loaded.len().min(NAMED)].join(", ");
    if loaded.len() > NAMED {
        names += &format!(" or one of {} more", loaded.len() - NAMED);
    }
    call_until_the_end(label(&names), UNLOADING);
}
