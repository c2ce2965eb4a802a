//! Asks a binary of Hotfoot's own to describe itself for the files in a resources folder. These
//! functions are no part of FMI; `fmu::export!` adds them.

use std::ffi::{CStr, CString, c_char, c_int};
use std::path::Path;

use super::import::ImportError;
use super::library::LoadedLibrary;
use crate::interface::Interface;

/// `hotfoot_model_description` and its like: 0 and the text, or the reason.
type Describe = unsafe extern "C" fn(*const c_char, *mut *mut c_char) -> c_int;
/// `hotfoot_free_text`.
type Free = unsafe extern "C" fn(*mut c_char);

/// What a binary says of itself.
#[derive(Debug, Clone)]
pub struct Description {
    /// `modelIdentifier`.
    pub identifier: String,
    /// Text of modelDescription.xml.
    pub xml: String,
    /// Text of documentation/index.html.
    pub html: String,
    /// Text of terminalsAndIcons/terminalsAndIcons.xml; empty: there are no terminals.
    pub terminals: String,
}

/// The description of `binary`, which messages of a crash call `subject`, for the files in the folder
/// `resources`.
///
/// # Errors
/// When the binary cannot be loaded, is not one of Hotfoot's, or refuses the resources.
pub fn describe(
    binary: &Path,
    subject: &str,
    resources: &Path,
) -> Result<Description, ImportError> {
    let file = binary.display().to_string();
    let not_ours = |cause| ImportError::Binary {
        file: file.clone(),
        binary: "that describes itself (only Hotfoot's own can be packed)".to_owned(),
        cause,
    };
    let library = LoadedLibrary::load(binary, subject).map_err(not_ours)?;
    // SAFETY: `fmu::export!` gives the function this type.
    let free = unsafe { library.get::<Free>(b"hotfoot_free_text") }.map_err(not_ours)?;
    let text = |name: &CStr| {
        // SAFETY: `fmu::export!` gives the function this type.
        let function = unsafe { library.get::<Describe>(name.to_bytes()) }.map_err(not_ours)?;
        // SAFETY: both functions belong to the library, which is loaded.
        library
            .calling(name, || unsafe { ask(function, free, resources) })
            .map_err(|message| ImportError::Describe { file: file.clone(), message })
    };
    let xml = text(c"hotfoot_model_description")?;
    let html = text(c"hotfoot_documentation")?;
    let terminals = text(c"hotfoot_terminals")?;
    let interface = Interface::from_xml(&xml)
        .map_err(|source| ImportError::ModelDescription { file: file.clone(), source })?;
    Ok(Description { identifier: interface.identifier, xml, html, terminals })
}

/// Calls `function` and frees its text.
///
/// # Safety
/// The functions are those of one loaded binary that `fmu::export!` has made.
unsafe fn ask(function: Describe, free: Free, resources: &Path) -> Result<String, String> {
    let folder = CString::new(resources.to_string_lossy().as_bytes()).unwrap_or_default();
    let mut answer = std::ptr::null_mut();
    // SAFETY: the path is a C string and the answer has room for one pointer.
    let code = unsafe { function(folder.as_ptr(), &raw mut answer) };
    if answer.is_null() {
        return Err("the binary gave no answer".to_owned());
    }
    // SAFETY: the binary answers with a C string, which it frees after the copy.
    let text = unsafe {
        let text = CStr::from_ptr(answer).to_string_lossy().into_owned();
        free(answer);
        text
    };
    if code == 0 { Ok(text) } else { Err(text) }
}
