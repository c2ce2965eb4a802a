//! An FMU file: unpacked and loaded once, instantiated as often as needed.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use percent_encoding::{AsciiSet, CONTROLS, utf8_percent_encode};

use super::binaries::{Binaries, PLATFORM};
use super::binding::{Functions, reason};
use super::guard::environment::Environment;
use super::messages::Messages;
use super::origins::Origins;
use crate::files::archive::{self, ArchiveError};
use crate::files::xml_text;
use crate::interface::{Interface, InterfaceError};

/// Characters that a file URI must not hold as they are.
const NOT_IN_URI: &AsciiSet = &CONTROLS
    .add(b' ')
    .add(b'"')
    .add(b'#')
    .add(b'%')
    .add(b'<')
    .add(b'>')
    .add(b'?')
    .add(b'[')
    .add(b']')
    .add(b'^')
    .add(b'`')
    .add(b'{')
    .add(b'|')
    .add(b'}');

/// Why an FMU cannot be imported.
#[derive(Debug, thiserror::Error)]
pub enum ImportError {
    /// The archive is damaged or unsafe.
    #[error(transparent)]
    Archive(#[from] ArchiveError),
    /// No model description.
    #[error("{file} is not an FMU: it has no modelDescription.xml ({source})")]
    NoModelDescription {
        /// FMU.
        file: String,
        /// Reason.
        source: std::io::Error,
    },
    /// The model description cannot be used.
    #[error("{file}: {source}")]
    ModelDescription {
        /// FMU.
        file: String,
        /// Reason.
        source: InterfaceError,
    },
    /// The binary is missing, or lacks a function.
    #[error("{file}: the binary {binary} cannot be loaded: {}", reason(cause))]
    Binary {
        /// FMU.
        file: String,
        /// Path inside of the FMU.
        binary: String,
        /// Reason; not a source, as its own sentence says less.
        cause: libloading::Error,
    },
    /// There is no binary for this platform.
    #[error("{file} has no binary {binary}, which this platform needs; {has}")]
    NoBinary {
        /// FMU.
        file: String,
        /// Path inside of the FMU.
        binary: String,
        /// What it has instead.
        has: String,
    },
    /// There is no room for unpacking.
    #[error("no temporary folder can be made for {file}: {source}")]
    NoFolder {
        /// FMU.
        file: String,
        /// Reason.
        source: std::io::Error,
    },
    /// The binary could not describe itself for the given resources.
    #[error("{file}: {message}")]
    Describe {
        /// FMU.
        file: String,
        /// What the model says.
        message: String,
    },
}

/// An FMU on disk and in memory.
pub struct Import {
    /// The FMU's file, for messages.
    file: String,
    interface: Interface,
    pub(super) functions: Functions,
    /// The loaded binary.
    binary: PathBuf,
    /// What loading it did to how the processor computes.
    change: Option<String>,
    /// Keeps the unpacked files.
    folder: tempfile::TempDir,
    /// What the resources are copies of.
    origins: Origins,
    /// Whether an instance has returned `fmi2Fatal`, after which no function may be called.
    fatal: AtomicBool,
}

impl Import {
    /// Unpacks and loads an FMU.
    ///
    /// # Errors
    /// When the file is not a usable FMI 2.0 co-simulation FMU for this platform.
    pub fn open(path: &Path) -> Result<Arc<Self>, ImportError> {
        Self::open_copy(path, Origins::default())
    }

    /// Unpacks and loads an FMU whose resources are copies of other files, which its messages
    /// shall name.
    ///
    /// # Errors
    /// When the file is not a usable FMI 2.0 co-simulation FMU for this platform.
    pub fn open_copy(path: &Path, origins: Origins) -> Result<Arc<Self>, ImportError> {
        let file = path.display().to_string();
        let folder = temporary_folder(&file)?;
        archive::unpack(path, folder.path())?;
        let interface = read_interface(folder.path(), &file)?;
        let binary = binary_path(&interface.identifier);
        let full = folder.path().join(&binary);
        if !full.is_file() {
            let (binary, has) =
                (binary.display().to_string(), Binaries::of(folder.path()).sentence());
            return Err(ImportError::NoBinary { file, binary, has });
        }
        let before = Environment::now();
        let functions = Functions::load(&full, &file);
        let change = before.put_back();
        let functions = functions.map_err(|cause| ImportError::Binary {
            file: file.clone(),
            binary: binary.display().to_string(),
            cause,
        })?;
        let (binary, fatal) = (full, AtomicBool::new(false));
        Ok(Arc::new(Self { file, interface, functions, binary, change, folder, origins, fatal }))
    }

    /// What the model description of an FMU says, whose binary is not needed.
    ///
    /// # Errors
    /// When the file is no FMI 2.0 co-simulation FMU.
    pub fn interface_of(path: &Path) -> Result<Interface, ImportError> {
        let file = path.display().to_string();
        let folder = temporary_folder(&file)?;
        archive::unpack(path, folder.path())?;
        read_interface(folder.path(), &file)
    }

    /// What the model description says.
    pub fn interface(&self) -> &Interface {
        &self.interface
    }

    /// The FMU's file.
    pub fn file(&self) -> &str {
        &self.file
    }

    /// The loaded binary.
    pub(super) fn binary(&self) -> &Path {
        &self.binary
    }

    /// Notes for an instance what loading the binary did to how the processor computes.
    pub(super) fn tell_loading(&self, messages: &Messages) {
        if let Some(change) = &self.change {
            messages.note_environment(&format!("loading its binary left {change}"));
        }
    }

    /// Notes that an instance has returned `fmi2Fatal`.
    pub(super) fn mark_fatal(&self) {
        self.fatal.store(true, Ordering::Relaxed);
    }

    /// Whether an instance has returned `fmi2Fatal`.
    pub(super) fn is_fatal(&self) -> bool {
        self.fatal.load(Ordering::Relaxed)
    }

    /// What `fmi2GetVersion` and `fmi2GetTypesPlatform` answer.
    pub fn version_and_platform(&self) -> (String, String) {
        self.functions.version_and_platform()
    }

    /// A message of the FMU with the files that the user knows.
    pub(super) fn in_words_of_the_user(&self, message: &str) -> String {
        self.origins.rename(message, &self.resources())
    }

    /// The unpacked folder of the FMU's resources.
    pub fn resources(&self) -> PathBuf {
        self.folder.path().join("resources")
    }

    /// The folder of the FMU's resources as a file URI.
    pub(super) fn resource_uri(&self) -> String {
        file_uri(&self.resources())
    }
}

/// A folder for what is unpacked of an FMU.
fn temporary_folder(file: &str) -> Result<tempfile::TempDir, ImportError> {
    let no_folder = |source| ImportError::NoFolder { file: file.to_owned(), source };
    tempfile::Builder::new().prefix("hotfoot-fmu-").tempdir().map_err(no_folder)
}

/// A path as a URI of the scheme `file` (RFC 8089), its other characters by percent (RFC 3986, 2.1).
fn file_uri(path: &Path) -> String {
    format!("file://{}", utf8_percent_encode(&path.to_string_lossy(), NOT_IN_URI))
}

/// Reads the model description of an unpacked FMU.
pub fn read_interface(folder: &Path, file: &str) -> Result<Interface, ImportError> {
    let xml = xml_text::read(&folder.join("modelDescription.xml"))
        .map_err(|source| ImportError::NoModelDescription { file: file.to_owned(), source })?;
    Interface::from_xml(&xml)
        .map_err(|source| ImportError::ModelDescription { file: file.to_owned(), source })
}

/// Path of the binary inside of an FMU.
pub fn binary_path(identifier: &str) -> PathBuf {
    let name = format!("{identifier}{}", std::env::consts::DLL_SUFFIX);
    Path::new("binaries").join(PLATFORM).join(name)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// RFC 8089, appendix B, and RFC 3986, 2.1: the octets of UTF-8 in hexadecimal.
    #[test]
    fn benchmark_a_path_is_a_uri() {
        for (path, uri) in [
            ("/path/to/file", "file:///path/to/file"),
            ("/a folder/100 %", "file:///a%20folder/100%20%25"),
            ("/Züge/#1?", "file:///Z%C3%BCge/%231%3F"),
        ] {
            assert_eq!(file_uri(Path::new(path)), uri);
        }
    }

    /// FMI 2.0 §2.3: the folder of the platform and the file's name.
    #[cfg(all(target_os = "linux", target_pointer_width = "64"))]
    #[test]
    fn a_binary_lies_in_the_folder_of_its_platform() {
        let path = binary_path("BouncingBall");
        assert_eq!(path, Path::new("binaries/linux64/BouncingBall.so"));
    }

    #[test]
    fn a_folder_without_description_is_no_fmu() {
        let folder = tempfile::tempdir().unwrap();
        let error = read_interface(folder.path(), "some.fmu").unwrap_err().to_string();
        assert!(
            error.contains("some.fmu is not an FMU: it has no modelDescription.xml"),
            "{error}"
        );
    }
}
