//! What is run, as it was ordered, and of which files it was made: a run can go on only as it was.

use std::fs;
use std::path::{Path, PathBuf};

use files::Setting;
use serde::{Deserialize, Serialize};

use super::error::CheckpointError;
use super::file::write_whole;
use crate::files::file_error::{FileError, read_toml};
use crate::run::manifest::sha256;
use crate::run::options::Options;
use crate::scenario::Times;
use crate::system::checks::Checks;

/// Name of the file in the folder of the checkpoints.
pub const NAME: &str = "run.toml";

/// This program.
const PROGRAM: &str = concat!(env!("CARGO_PKG_VERSION"), " ", env!("HOTFOOT_GIT_COMMIT"));

/// What was ordered.
#[derive(Debug, Serialize, Deserialize)]
pub struct Order {
    /// Version of the program.
    hotfoot: String,
    /// Folder of the results, absolute.
    pub results: PathBuf,
    /// Folder of Hotfoot's own FMUs.
    fmus: PathBuf,
    /// What is run.
    pub subject: Subject,
    /// Relative tolerance that the FMUs are told instead of their own.
    tolerance: Option<f64>,
    /// What becomes of values that cannot be.
    checks: Option<Checks>,
    /// Whether FMUs have a thread of their own.
    same_thread: bool,
    /// Components that have processes of their own.
    isolate: Vec<String>,
    /// Outputs that are recorded.
    record: Vec<String>,
    /// Values of the scenario's keys of the command line.
    settings: Vec<Setting>,
    /// Times of the command line, and how often a checkpoint is written.
    pub times: Times,
    input: Vec<Input>,
}

/// A scenario or a package.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Subject {
    /// Its file or folder, absolute.
    pub path: PathBuf,
    /// The same as the user has written it.
    pub written: String,
}

/// A file that a run is made of.
#[derive(Debug, Serialize, Deserialize)]
struct Input {
    file: PathBuf,
    sha256: String,
}

impl Subject {
    /// What the user names so.
    ///
    /// # Errors
    /// When there is no current folder.
    pub fn new(path: &Path) -> Result<Self, FileError> {
        let absolute = std::path::absolute(path).map_err(FileError::at(path))?;
        Ok(Self { path: absolute, written: path.display().to_string() })
    }
}

impl Order {
    /// An order to run this into a folder, as the options of the command line say.
    ///
    /// `files` are those that the run is made of.
    ///
    /// # Errors
    /// When one of them cannot be read.
    pub fn new(
        subject: &Subject,
        options: &Options,
        results: &Path,
        files: Vec<PathBuf>,
    ) -> Result<Self, FileError> {
        let Options {
            fmus, settings, times, tolerance, checks, same_thread, isolate, record, ..
        } = options;
        let mut order = Self {
            hotfoot: PROGRAM.to_owned(),
            results: results.to_owned(),
            fmus: std::path::absolute(fmus).map_err(FileError::at(fmus))?,
            subject: subject.clone(),
            tolerance: *tolerance,
            checks: *checks,
            same_thread: *same_thread,
            isolate: isolate.clone(),
            record: record.clone(),
            settings: settings.clone(),
            times: *times,
            input: vec![],
        };
        if times.checkpoint.is_some() {
            let input = |file: PathBuf| Ok(Input { sha256: digest(&file)?, file });
            order.input = files.into_iter().map(input).collect::<Result<_, FileError>>()?;
        }
        Ok(order)
    }

    /// The options as they were ordered, with the threads of others, which change nothing of the results.
    pub fn options(&self, others: &Options) -> Options {
        Options {
            threads: others.threads,
            fmus: self.fmus.clone(),
            settings: self.settings.clone(),
            times: self.times,
            tolerance: self.tolerance,
            checks: self.checks,
            same_thread: self.same_thread,
            isolate: self.isolate.clone(),
            record: self.record.clone(),
            quiet: others.quiet,
        }
    }

    /// Writes it.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub(super) fn write(&self, file: &Path) -> Result<(), FileError> {
        let text = toml::to_string(self).expect("an order is a TOML table");
        write_whole(file, &[text.as_bytes()])
    }

    /// Reads that of the run in a folder.
    pub(super) fn read(file: &Path, results: &Path) -> Result<Self, CheckpointError> {
        if !file.exists() {
            return Err(CheckpointError::None { results: results.display().to_string() });
        }
        Ok(read_toml(file)?)
    }

    /// Refuses to go on in that folder if something is not as it was.
    pub(super) fn check(&self, results: &Path) -> Result<(), CheckpointError> {
        let changed =
            |what| Err(CheckpointError::Changed { results: results.display().to_string(), what });
        if self.hotfoot != PROGRAM {
            return changed(format!("it was begun by hotfoot {}, this is {PROGRAM}", self.hotfoot));
        }
        let folder = |path: &Path| fs::canonicalize(path).map_err(FileError::at(path));
        if folder(&self.results).ok() != Some(folder(results)?) {
            let before = self.results.display();
            return changed(format!("its folder was {before}; move it back there"));
        }
        for Input { file, sha256 } in &self.input {
            if digest(file).ok().as_ref() != Some(sha256) {
                let file = file.display();
                return changed(format!(
                    "{file} is not what it was when the run began; put it back, or begin a new run"
                ));
            }
        }
        Ok(())
    }
}

fn digest(file: &Path) -> Result<String, FileError> {
    Ok(sha256(&fs::read(file).map_err(FileError::at(file))?))
}
