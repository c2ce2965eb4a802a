//! Where a run computes and where it writes: threads, and a folder for the results.

use std::path::{Path, PathBuf};

use rayon::ThreadPool;

use crate::files::file_error::FileError;
use crate::run::error::RunError;
use crate::scenario;
use crate::system::parallel::{default_threads, pool};

/// Threads and the folder of the results.
pub(crate) struct Workplace {
    /// Number of threads.
    pub threads: usize,
    /// The threads.
    pub pool: ThreadPool,
    /// Absolute path of the folder, which is there.
    pub results: PathBuf,
}

impl Workplace {
    /// Starts the threads, by default one a core, and makes the folder if it is not there, by
    /// default a new one for the scenario or package that is run.
    ///
    /// # Errors
    /// When the system gives no threads, or the folder cannot be made.
    pub fn open(
        threads: Option<usize>,
        results: Option<&Path>,
        file: &Path,
    ) -> Result<Self, RunError> {
        let threads = threads.unwrap_or_else(default_threads);
        let pool = pool(threads)?;
        let results = results.map_or_else(|| new_results(file), Path::to_owned);
        std::fs::create_dir_all(&results).map_err(FileError::at(&results))?;
        let results = std::path::absolute(&results).map_err(FileError::at(&results))?;
        Ok(Self { threads, pool, results })
    }
}

/// The scenario's folder names the run, or its file if it is not called `scenario.toml`.
pub fn scenario_name(file: &Path) -> String {
    let stem = file.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let absolute = std::path::absolute(file).unwrap_or_else(|_| file.to_owned());
    let folder = absolute.parent().and_then(Path::file_name);
    match (stem.as_str(), folder) {
        ("scenario" | "SystemStructure", Some(folder)) => folder.to_string_lossy().into_owned(),
        _ => stem,
    }
}

/// The folder for the results of a scenario or a package whose user names none: `results/<name>`, or
/// with a number behind it if that is there: no run overwrites another.
pub fn new_results(file: &Path) -> PathBuf {
    let name = scenario_name(&scenario::file_of(file));
    let candidate = |n: u32| match n {
        1 => PathBuf::from("results").join(&name),
        n => PathBuf::from("results").join(format!("{name}-{n}")),
    };
    (1..).map(candidate).find(|folder| !folder.exists()).unwrap_or_default()
}
