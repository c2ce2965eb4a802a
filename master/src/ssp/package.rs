//! The files of an unpacked package, and what is said of them without being wrong.

use std::cell::RefCell;
use std::path::{Component as PathPart, Path, PathBuf};

use percent_encoding::percent_decode_str;
use roxmltree::{Document, Error};

use super::error::SspError;
use crate::files::file_error::FileError;
use crate::files::xml_text;

/// The namespace that libcosim, and ecos after it, take the prefix `osp` for where a file does not say.
pub const OSP_NAMESPACE: &str = "http://opensimulationplatform.com/SSP/OSPAnnotations";

/// An unpacked package while its structure is read.
pub struct Package<'p> {
    folder: &'p Path,
    notes: RefCell<Vec<String>>,
}

impl<'p> Package<'p> {
    /// The package in a folder.
    pub fn new(folder: &'p Path) -> Self {
        Self { folder, notes: RefCell::default() }
    }

    /// Keeps a sentence on what the user should know.
    pub fn note(&self, sentence: String) {
        self.notes.borrow_mut().push(sentence);
    }

    /// The sentences that were kept.
    pub fn into_notes(self) -> Vec<String> {
        self.notes.into_inner()
    }

    /// The text of an XML file by its `source`; none if that is no path inside of the package.
    ///
    /// # Errors
    /// When the file cannot be read.
    pub fn xml(&self, source: &str) -> Result<Option<String>, SspError> {
        let Some(path) = path_of(self.folder, source) else { return Ok(None) };
        let text = xml_text::read(&path).map_err(FileError::at(&path))?;
        match Document::parse(&text) {
            Err(Error::UnknownNamespace(prefix, _)) if prefix == "osp" => {
                self.note(format!(
                    "{source} uses the prefix 'osp' without declaring it; it is read as that of {OSP_NAMESPACE}"
                ));
                Ok(Some(with_osp(&text)))
            }
            _ => Ok(Some(text)),
        }
    }
}

/// The file that an attribute `source` names: a relative reference of a URI (SSP 1.0, 4.3), so that
/// other characters may be written by percent. None where that is no path inside of the package.
pub fn path_of(package: &Path, source: &str) -> Option<PathBuf> {
    let inside = |path: &str| {
        let mut inside = PathBuf::new();
        for part in Path::new(path).components() {
            match part {
                PathPart::Normal(part) => inside.push(part),
                PathPart::CurDir => {}
                _ => return None,
            }
        }
        (!inside.as_os_str().is_empty()).then(|| package.join(inside))
    };
    let decoded = inside(&percent_decode_str(source).decode_utf8_lossy())?;
    // Some tools write the name as it is.
    let plain = inside(source).filter(|plain| plain.is_file() && !decoded.is_file());
    Some(plain.unwrap_or(decoded))
}

/// The text with the prefix `osp` declared in its first element, in the same line.
fn with_osp(text: &str) -> String {
    let mut at = 0;
    while let Some(begin) = text[at..].find('<').map(|found| at + found) {
        let rest = &text[begin..];
        let end = match () {
            () if rest.starts_with("<?") => "?>",
            () if rest.starts_with("<!--") => "-->",
            () => {
                let is_end = |c: char| c.is_whitespace() || c == '>' || c == '/';
                let name = begin + rest.find(is_end).unwrap_or(rest.len());
                return format!("{} xmlns:osp=\"{OSP_NAMESPACE}\"{}", &text[..name], &text[name..]);
            }
        };
        at = begin + rest.find(end).unwrap_or(rest.len());
    }
    text.to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_source_names_a_file_inside_of_the_package_by_percent_or_as_it_is() {
        let folder = tempfile::tempdir().unwrap();
        let path = |source| path_of(folder.path(), source);
        let inside = |name: &str| Some(folder.path().join(name));
        assert_eq!(path("./resources/./a%20b.ssv"), inside("resources/a b.ssv"));
        assert_eq!(path("a b.ssv"), inside("a b.ssv"));
        for outside in ["../a", "/a", "a/../../b", "%2e%2e/a", "", "."] {
            assert_eq!(path(outside), None, "{outside}");
        }
        std::fs::write(folder.path().join("a%20b.ssv"), "").unwrap();
        assert_eq!(path("a%20b.ssv"), inside("a%20b.ssv"));
    }

    #[test]
    fn a_prefix_is_declared_in_the_first_element() {
        let text = "<?xml version=\"1.0\"?>\n<!-- <a> -->\n<b:c\n x=\"1\"><osp:d/></b:c>";
        let declared = with_osp(text);
        let expected = format!("\n<b:c xmlns:osp=\"{OSP_NAMESPACE}\"\n x");
        assert!(declared.contains(&expected), "{declared}");
        assert_eq!(declared.lines().count(), text.lines().count());
    }
}
