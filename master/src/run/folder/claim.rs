//! The claim of a run on its folder: in one step, so that of runs that start together one has it.
//!
//! A claim is a hidden file that comes into the folder complete and locked. The run and its parent hold
//! the lock, which the system lets go when both have ended, however that was: a claim without a lock is
//! that of a dead run.

use std::fs::{self, File, TryLockError};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::thread;
use std::time::{Duration, Instant};

use super::contents::{has_manifest, names_of_a_run, remove};
use crate::files::file_error::FileError;
use crate::run::workplace::scenario_name;
use crate::scenario;

/// Name of the claim.
const CLAIM: &str = ".hotfoot-run";

/// Stands in the claim of a run that goes on with the results of a folder, which stay whatever becomes of it.
const GOES_ON: &str = "goes on\n";

/// Longest time in which a run may let go of its folder that was killed.
const DYING: Duration = Duration::from_millis(200);
/// Time between two looks whether it has.
const PAUSE: Duration = Duration::from_millis(10);

/// Why a run cannot have a folder.
#[derive(Debug, thiserror::Error)]
pub enum ClaimError {
    /// It is no folder.
    #[error("{path}: is a file, where a folder for the results is needed")]
    IsFile {
        /// Path.
        path: String,
    },
    /// Another run has it.
    #[error("{path}: another run is writing its results there; name another folder by --results")]
    InUse {
        /// Folder.
        path: String,
    },
    /// There are results already.
    #[error(
        "{path}: has the results of a run already; name another folder by --results, or replace them by \
         --overwrite"
    )]
    HasResults {
        /// Folder.
        path: String,
    },
    /// There is something that a run would write, but none has written it.
    #[error(
        "{path}: has '{name}', which a run would write, but which is of no run; name another folder by \
         --results"
    )]
    Foreign {
        /// Folder.
        path: String,
        /// Name of a file or folder in it.
        name: String,
    },
    /// The file system refuses.
    #[error(transparent)]
    File(#[from] FileError),
}

/// A folder that this run has to itself.
#[derive(Debug)]
pub struct Claim {
    /// The folder.
    folder: PathBuf,
    /// The folders that were made for it, the innermost first.
    made: Vec<PathBuf>,
    /// Whether the run goes on with the results that are there.
    goes_on: bool,
    /// Locked, as long as this lives.
    _lock: File,
}

/// Whether a run has a folder now.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Owner {
    /// None has claimed it, or its run has ended in order.
    None,
    /// A run that goes on.
    Living,
    /// A run that was killed.
    Dead,
}

impl Claim {
    /// Claims a folder, which is made if it is not there; what an earlier run has left in it is removed
    /// first if that is to be overwritten.
    ///
    /// # Errors
    /// When another run has the folder, there are results, or the file system refuses.
    pub fn of(folder: &Path, overwrite: bool) -> Result<Self, ClaimError> {
        let path = || folder.display().to_string();
        let made = make(folder)?;
        if !overwrite && folder.is_dir() && owner(folder)? == Owner::Dead {
            return Err(ClaimError::HasResults { path: path() });
        }
        let (claim, is_dead) = Self::lock(folder, made, "")?;
        match claim.take_over(is_dead, overwrite) {
            Ok(()) => Ok(claim),
            Err(error) => {
                release(&claim.folder);
                Err(error)
            }
        }
    }

    /// Claims a folder for a run that goes on with the results in it, which stay whatever becomes of it.
    ///
    /// # Errors
    /// When another run has the folder, it is not there, or the file system refuses.
    pub fn to_resume(folder: &Path) -> Result<Self, ClaimError> {
        Ok(Self::lock(folder, vec![], GOES_ON)?.0)
    }

    /// Puts a claim with this text into a folder, in the place of that of a dead run; gives whether there was
    /// one.
    fn lock(folder: &Path, made: Vec<PathBuf>, text: &str) -> Result<(Self, bool), ClaimError> {
        let path = || folder.display().to_string();
        if folder.exists() && !folder.is_dir() {
            return Err(ClaimError::IsFile { path: path() });
        }
        let is_dead = match owner(folder)? {
            Owner::Living => return Err(ClaimError::InUse { path: path() }),
            owner => owner == Owner::Dead,
        };
        // While it is locked, no other run takes the place of the dead one.
        let old = match is_dead {
            true => Some(File::open(folder.join(CLAIM)).map_err(FileError::at(folder))?),
            false => None,
        };
        if old.as_ref().is_some_and(|old| old.try_lock().is_err()) {
            return Err(ClaimError::InUse { path: path() });
        }
        if is_dead {
            release(folder);
        }
        let lock = put_claim(folder, text)?;
        drop(old);
        let folder = std::path::absolute(folder).map_err(FileError::at(folder))?;
        Ok((Self { folder, made, goes_on: !text.is_empty(), _lock: lock }, is_dead))
    }

    /// Removes the results of an earlier run, or refuses a folder that has something a run would write.
    fn take_over(&self, is_dead: bool, overwrite: bool) -> Result<(), ClaimError> {
        let folder = &self.folder;
        let path = || folder.display().to_string();
        let has_results = is_dead || has_manifest(folder);
        if has_results && !overwrite {
            return Err(ClaimError::HasResults { path: path() });
        }
        let names = names_of_a_run(folder).map_err(FileError::at(folder))?;
        if let Some(name) = names.first().filter(|_| !has_results) {
            let name = name.to_string_lossy().into_owned();
            return Err(ClaimError::Foreign { path: path(), name });
        }
        Ok(remove(folder).map_err(FileError::at(folder))?)
    }

    /// Claims a new folder for the scenario or package in `file`: `results/<name>`, or with a number
    /// behind it, so that no run overwrites another.
    ///
    /// # Errors
    /// When the folder cannot be made.
    pub fn of_new(file: &Path) -> Result<Self, ClaimError> {
        let results = Path::new("results");
        let mut made = make(results)?;
        let name = scenario_name(&scenario::file_of(file));
        let mut candidates = (1_u32..).map(|number| match number {
            1 => results.join(&name),
            _ => results.join(format!("{name}-{number}")),
        });
        let folder = candidates.find_map(|folder| match fs::create_dir(&folder) {
            Ok(()) => Some(Ok(folder)),
            Err(error) if error.kind() == ErrorKind::AlreadyExists => None,
            Err(error) => Some(Err(FileError::at(&folder)(error))),
        });
        let folder = folder.unwrap_or_else(|| Ok(results.join(&name)))?;
        let claim = Self::of(&folder, false)?;
        made.insert(0, claim.folder.clone());
        Ok(Self { made, ..claim })
    }

    /// Takes part in the claim that the parent of this process has on a folder.
    ///
    /// # Errors
    /// When there is no claim.
    pub fn join(folder: &Path) -> Result<Self, ClaimError> {
        let file = folder.join(CLAIM);
        let lock = File::open(&file).map_err(FileError::at(&file))?;
        lock.lock_shared().map_err(FileError::at(&file))?;
        let goes_on = io::read_to_string(&lock).map_err(FileError::at(&file))? == GOES_ON;
        Ok(Self { folder: folder.to_owned(), made: vec![], goes_on, _lock: lock })
    }

    /// Absolute path of the folder.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// Ends the claim of a run that has ended: the results stay.
    pub fn release(self) {
        release(&self.folder);
    }

    /// Whether the run goes on with the results that are there.
    pub fn goes_on(&self) -> bool {
        self.goes_on
    }

    /// Ends the claim of a run that has recorded nothing, and removes what it has written:
    /// nothing of that was there when the folder was claimed, unless the run goes on with results.
    pub fn abandon(&self) {
        if !self.goes_on {
            let _ = remove(&self.folder);
        }
        release(&self.folder);
    }

    /// Gives a folder back as it was, since the run has failed before it recorded anything.
    pub fn undo(self) {
        self.abandon();
        // A folder in which something else has come stays.
        let _ = self.made.iter().try_for_each(fs::remove_dir);
    }
}

/// Whether a run has claimed a folder.
///
/// # Errors
/// When the claim cannot be read.
pub fn owner(folder: &Path) -> Result<Owner, FileError> {
    let file = folder.join(CLAIM);
    let lock = match File::open(&file) {
        Ok(lock) => lock,
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(Owner::None),
        Err(error) => return Err(FileError::at(&file)(error)),
    };
    // A process that was killed lets go of its files a little later.
    let begin = Instant::now();
    loop {
        match lock.try_lock() {
            // A run that has just come to its end was alive.
            Ok(()) if !file.exists() => return Ok(Owner::Living),
            Ok(()) => return Ok(Owner::Dead),
            Err(TryLockError::WouldBlock) if begin.elapsed() < DYING => thread::sleep(PAUSE),
            Err(TryLockError::WouldBlock) => return Ok(Owner::Living),
            Err(TryLockError::Error(error)) => return Err(FileError::at(&file)(error)),
        }
    }
}

/// Removes the claim on a folder.
pub fn release(folder: &Path) {
    let _ = fs::remove_file(folder.join(CLAIM));
}

/// Puts a claim with this text into a folder, which is locked already when it comes there.
fn put_claim(folder: &Path, text: &str) -> Result<File, ClaimError> {
    let error = || FileError::at(folder);
    let mut file = tempfile::Builder::new().prefix(CLAIM).tempfile_in(folder).map_err(error())?;
    file.write_all(text.as_bytes()).map_err(error())?;
    file.as_file().lock_shared().map_err(error())?;
    file.persist_noclobber(folder.join(CLAIM)).map_err(|refused| match refused.error.kind() {
        ErrorKind::AlreadyExists => ClaimError::InUse { path: folder.display().to_string() },
        _ => FileError::at(folder)(refused.error).into(),
    })
}

/// Makes a folder and those around it, and gives those that were not there, the innermost first.
fn make(folder: &Path) -> Result<Vec<PathBuf>, FileError> {
    let absolute = std::path::absolute(folder).map_err(FileError::at(folder))?;
    let missing = absolute.ancestors().take_while(|folder| !folder.exists());
    let mut made: Vec<PathBuf> = missing.map(Path::to_owned).collect();
    let mut ours = vec![];
    while let Some(next) = made.pop() {
        match fs::create_dir(&next) {
            Ok(()) => ours.insert(0, next),
            // Another run has made it at the same time.
            Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
            Err(error) => return Err(FileError::at(&next)(error)),
        }
    }
    Ok(ours)
}

#[cfg(test)]
#[path = "claim_tests.rs"]
mod tests;
