//! What the resources of an FMU are copies of.
//!
//! Messages of an FMU name the copies in its resources; with their origins, the user reads the names of
//! the files that he wrote.

use std::path::{Path, PathBuf};

/// Names in a resources folder, and the files or folders that they are copies of.
#[derive(Debug, Clone, Default)]
pub struct Origins(Vec<(String, PathBuf)>);

impl Origins {
    /// Notes that `name` in the resources is a copy of a file or folder.
    pub fn add(&mut self, name: impl Into<String>, original: &Path) {
        self.0.push((name.into(), original.to_owned()));
    }

    /// The message with the names of the originals instead of the copies in `folder`.
    pub fn rename(&self, message: &str, folder: &Path) -> String {
        let copy = |name: &str| folder.join(name).display().to_string();
        self.0.iter().fold(message.to_owned(), |text, (name, original)| {
            text.replace(&copy(name), &original.display().to_string())
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_message_names_the_file_that_the_user_wrote() {
        let mut origins = Origins::default();
        origins.add("track.toml", Path::new("lines/curve.toml"));
        origins.add("stock", Path::new("/home/user/stock"));
        let message =
            "/tmp/x/resources/track.toml:3: no radius; /tmp/x/resources/stock/vehicles/w.toml";
        assert_eq!(
            origins.rename(message, Path::new("/tmp/x/resources")),
            "lines/curve.toml:3: no radius; /home/user/stock/vehicles/w.toml"
        );
        let other = "/tmp/y/resources/track.toml";
        assert_eq!(origins.rename(other, Path::new("/tmp/x/resources")), other);
    }
}
