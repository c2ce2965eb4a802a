//! What breaks a rule.

use std::fmt;
use std::path::{Path, PathBuf};

/// A line that breaks a rule.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Breach {
    /// File or folder relative to the root of the repository.
    pub path: PathBuf,
    /// Line, from 1; zero for a file as a whole.
    pub line: usize,
    /// What is wrong there.
    pub message: String,
}

impl Breach {
    /// A breach in a line of a file.
    pub fn new(path: &Path, line: usize, message: impl Into<String>) -> Self {
        Self { path: path.to_owned(), line, message: message.into() }
    }
}

impl fmt::Display for Breach {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}", self.path.display())?;
        if self.line > 0 {
            write!(f, ":{}", self.line)?;
        }
        write!(f, ": {}", self.message)
    }
}
