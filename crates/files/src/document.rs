//! The text of a file with its name.

use std::io::{self, ErrorKind};
use std::ops::Range;
use std::path::Path;

use crate::mistake::{Mark, Mistake};
use crate::nearest::did_you_mean;

/// The text of a file that a person wrote, with the name that messages give it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Document {
    name: String,
    text: String,
}

impl Document {
    /// A text that is there already.
    pub fn new(name: impl ToString, text: impl Into<String>) -> Self {
        Self { name: name.to_string(), text: text.into() }
    }

    /// Reads a file.
    ///
    /// # Errors
    /// When there is no such file, it cannot be read, or it is no text in UTF-8.
    pub fn read(path: &Path) -> Result<Self, Mistake> {
        let name = path.display().to_string();
        let bytes = std::fs::read(path)
            .map_err(|error| Mistake::in_file(&name, unreadable(path, &error)))?;
        match String::from_utf8(bytes) {
            Ok(text) => Ok(Self { name, text }),
            Err(error) => {
                let good = error.utf8_error().valid_up_to();
                let text = String::from_utf8_lossy(error.as_bytes()).into_owned();
                let sentence = "is no text in UTF-8 from here on; save the file as UTF-8";
                Err(Self { name, text }.mistake(good..good + 1, sentence))
            }
        }
    }

    /// Name of the file.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Its text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// A mistake in these bytes of the text.
    pub fn mistake(&self, bytes: Range<usize>, sentence: impl Into<String>) -> Mistake {
        let mark = Some(Mark::new(&self.text, bytes));
        Mistake { mark, ..Mistake::in_file(&self.name, sentence) }
    }
}

/// Says of a file or folder that is not there which one may be meant.
///
/// # Errors
/// When it is not there.
pub fn exists(path: &Path) -> Result<(), Mistake> {
    match std::fs::metadata(path) {
        Ok(_) => Ok(()),
        Err(error) => Err(Mistake::in_file(path.display(), unreadable(path, &error))),
    }
}

/// Why a file cannot be read, in words, with the name of the file beside it that may be meant.
fn unreadable(path: &Path, error: &io::Error) -> String {
    match error.kind() {
        ErrorKind::NotFound => {
            let folder = match path.parent() {
                Some(folder) if folder.as_os_str().is_empty() => Path::new("."),
                Some(folder) => folder,
                None => return "there is no such file".to_owned(),
            };
            let Ok(entries) = std::fs::read_dir(folder) else {
                return format!(
                    "there is no such file, as there is no folder {}",
                    folder.display()
                );
            };
            let names = entries.filter_map(|entry| entry.ok()?.file_name().into_string().ok());
            let mut names: Vec<String> = names.collect();
            names.sort();
            let wanted = path.file_name().unwrap_or_default().to_string_lossy();
            let meant = did_you_mean(&wanted, names.iter().map(String::as_str));
            format!("there is no such file{meant}")
        }
        ErrorKind::IsADirectory => "is a folder, not a file".to_owned(),
        _ => format!("cannot be read: {error}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn message(path: &Path) -> String {
        Document::read(path).unwrap_err().to_string()
    }

    #[test]
    fn a_folder_exists_as_well_as_a_file() {
        let folder = tempfile::tempdir().unwrap();
        assert_eq!(exists(folder.path()), Ok(()));
        let text = exists(&folder.path().join("none.fmu")).unwrap_err().to_string();
        assert!(text.ends_with("none.fmu: there is no such file"), "{text}");
    }

    #[test]
    fn a_missing_file_is_answered_with_the_one_that_is_meant() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("track.toml"), "").unwrap();
        let text = message(&folder.path().join("trak.toml"));
        assert!(text.ends_with("trak.toml: there is no such file; did you mean `track.toml`?"));
        let text = message(&folder.path().join("weather.csv"));
        assert!(text.ends_with("weather.csv: there is no such file"), "{text}");
        let text = message(&folder.path().join("nowhere/track.toml"));
        assert!(text.contains("there is no folder") && text.ends_with("nowhere"), "{text}");
        let text = message(folder.path());
        assert!(text.ends_with("is a folder, not a file"), "{text}");
    }

    #[test]
    fn a_text_that_is_not_utf_8_is_answered_with_line_and_column() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("latin1.toml");
        std::fs::write(&file, b"a = 1\nname = \"M\xfcller\"\n").unwrap();
        let text = message(&file);
        assert!(text.contains("latin1.toml:2:10: is no text in UTF-8"), "{text}");
        assert!(text.contains("save the file as UTF-8"), "{text}");
    }
}
