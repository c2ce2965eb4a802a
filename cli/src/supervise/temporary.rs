//! The temporary folder of a process and its child, which goes with them.
//!
//! One that was left by processes that were killed goes when the next begins.
//!
//! Its processes hold a lock in it, so that one without a lock is known to be left over.

use std::fs::{self, File};
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};

/// How the names of these folders begin; the number of the process follows.
const PREFIX: &str = "hotfoot-";
/// Name of the file that is locked.
const LOCK: &str = ".lock";

/// A temporary folder, which goes with this.
pub struct Temporary {
    folder: PathBuf,
    _lock: File,
}

impl Temporary {
    /// A new folder; those that were left by processes that have died are removed.
    ///
    /// # Errors
    /// When the system's temporary folder cannot be written.
    pub fn new() -> Result<Self> {
        let all = std::env::temp_dir();
        remove_stale(&all);
        let why = || format!("no temporary folder can be made in {}", all.display());
        let prefix = format!("{PREFIX}{}-", std::process::id());
        let folder =
            tempfile::Builder::new().prefix(&prefix).tempdir_in(&all).with_context(why)?.keep();
        match lock(&folder) {
            Ok(lock) => Ok(Self { folder, _lock: lock }),
            Err(error) => {
                remove(&folder);
                Err(error).with_context(why)
            }
        }
    }

    /// The folder.
    pub fn path(&self) -> &Path {
        &self.folder
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        remove(&self.folder);
    }
}

/// Makes and takes the lock of a new folder.
fn lock(folder: &Path) -> std::io::Result<File> {
    let lock = File::create(folder.join(LOCK))?;
    lock.lock_shared()?;
    Ok(lock)
}

/// Removes a folder with all that is in it, with one open file at a time: also where there are no more.
pub fn remove(folder: &Path) {
    // An entry keeps its folder open, a path does not.
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let paths: Vec<_> = entries
        .map(|entry| (entry.path(), entry.file_type().is_ok_and(|kind| kind.is_dir())))
        .collect();
    for (path, is_folder) in paths {
        match is_folder {
            true => remove(&path),
            false => drop(fs::remove_file(path)),
        }
    }
    let _ = fs::remove_dir(folder);
}

/// The lock of another process's folder, for its child.
///
/// # Errors
/// When there is none.
pub fn join(folder: &Path) -> std::io::Result<File> {
    let lock = File::open(folder.join(LOCK))?;
    lock.lock_shared()?;
    Ok(lock)
}

/// Removes what processes that have died have left in the system's temporary folder.
pub fn clean_up() {
    remove_stale(&std::env::temp_dir());
}

fn remove_stale(all: &Path) {
    for entry in fs::read_dir(all).into_iter().flatten().flatten() {
        let name = entry.file_name();
        let process = name.to_str().and_then(|name| name.strip_prefix(PREFIX)?.split_once('-'));
        let process = process.and_then(|(process, _)| process.parse().ok());
        // A folder that is just being made has no lock yet, but its process lives.
        if process.is_some_and(|process| !is_alive(process)) && is_left(&entry.path()) {
            remove(&entry.path());
        }
    }
}

/// Whether nobody holds the lock of a folder.
fn is_left(folder: &Path) -> bool {
    File::open(folder.join(LOCK)).is_ok_and(|lock| lock.try_lock().is_ok())
}

/// Whether there is a process of this number.
#[cfg(unix)]
fn is_alive(process: i32) -> bool {
    let process = rustix::process::Pid::from_raw(process);
    process.is_some_and(|process| {
        !matches!(rustix::process::test_kill_process(process), Err(rustix::io::Errno::SRCH))
    })
}

#[cfg(not(unix))]
fn is_alive(_: i32) -> bool {
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    /// More than any process number that Linux gives.
    const NOBODY: &str = "hotfoot-2000000000-abc";

    #[test]
    fn a_folder_goes_when_its_processes_have_died_and_no_other_does() {
        let all = tempfile::tempdir().unwrap();
        let folder = |name: &str| {
            let folder = all.path().join(name);
            fs::create_dir(&folder).unwrap();
            File::create(folder.join(LOCK)).unwrap();
            folder
        };
        let dead = folder(NOBODY);
        let (living, other) = (folder("hotfoot-2000000001-abc"), folder("hotfoot-notes"));
        let own = folder(&format!("hotfoot-{}-abc", std::process::id()));
        let lock = join(&living).unwrap();
        remove_stale(all.path());
        assert!(!dead.exists() && living.exists() && other.exists() && own.exists());
        drop(lock);
        remove_stale(all.path());
        assert!(!living.exists() && other.exists() && own.exists());
    }
}
