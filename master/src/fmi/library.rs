//! The binary of an FMU, loaded: its code runs when it is loaded and when it is let go, so both are
//! noted as calls.

use std::ffi::CStr;
use std::path::Path;

use libloading::{Error, Library};

use super::watched::{Label, calling, label};

/// Name of the loading in what the parent sees.
const LOADING: &CStr = c"loading the binary";
/// Name of the unloading in what the parent sees.
pub const UNLOADING: &CStr = c"unloading the binary";

/// A loaded binary.
pub(super) struct LoadedLibrary {
    /// Taken out when it is let go.
    library: Option<Library>,
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
        Ok(Self { library: Some(library), label })
    }

    /// A function of the binary by its name.
    ///
    /// # Safety
    /// The function has the type `T`, and is not called when the library has gone.
    ///
    /// # Errors
    /// When there is none.
    pub unsafe fn get<T: Copy>(&self, name: &[u8]) -> Result<T, Error> {
        let library = self.library.as_ref().expect("it is taken out only when this is dropped");
        // SAFETY: as the caller promises.
        unsafe { library.get::<T>(name) }.map(|function| *function)
    }

    /// Calls code of the binary that is no function of FMI.
    pub fn calling<T>(&self, function: &CStr, call: impl FnOnce() -> T) -> T {
        calling(self.label, function, call)
    }
}

impl Drop for LoadedLibrary {
    fn drop(&mut self) {
        let library = self.library.take();
        calling(self.label, UNLOADING, || drop(library));
    }
}
