//! What a run writes into its folder; nothing else there is ever touched.

use std::ffi::OsString;
use std::fs;
use std::io;
use std::path::Path;

/// Name of the folder of checkpoints.
pub const CHECKPOINTS: &str = "checkpoint";

/// Names of what a run writes, besides the fields of the rails.
const NAMES: [&str; 7] = [MANIFEST, "report.html", "series", CSV, "fmus", "package", CHECKPOINTS];

/// Name of the folder of the tables as CSV files.
pub const CSV: &str = "csv";

/// Name of the manifest.
pub const MANIFEST: &str = "manifest.toml";

/// The names in a folder that a run writes.
///
/// # Errors
/// When the folder cannot be read.
pub fn names_of_a_run(folder: &Path) -> io::Result<Vec<OsString>> {
    let entries: io::Result<Vec<_>> =
        fs::read_dir(folder)?.map(|entry| Ok(entry?.file_name())).collect();
    let mut names = entries?;
    names.retain(|name| {
        let is_named = NAMES.iter().any(|of_run| name == of_run);
        is_named || field::is_rail_field(&folder.join(name))
    });
    Ok(names)
}

/// Removes what a run has written.
///
/// # Errors
/// When something cannot be removed.
pub fn remove(folder: &Path) -> io::Result<()> {
    for name in names_of_a_run(folder)? {
        let path = folder.join(name);
        match path.is_dir() {
            true => fs::remove_dir_all(path)?,
            false => fs::remove_file(path)?,
        }
    }
    Ok(())
}

/// Whether a run has written the manifest of a folder.
pub fn has_manifest(folder: &Path) -> bool {
    let text = fs::read_to_string(folder.join(MANIFEST)).unwrap_or_default();
    text.lines().any(|line| line.starts_with("hotfoot_version"))
}
