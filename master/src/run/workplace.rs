//! Where a run computes: its threads. And its name.

use std::path::Path;

use rayon::ThreadPool;

use crate::run::error::RunError;
use crate::system::parallel::{default_threads, pool};

/// The threads of a run.
pub(crate) struct Workplace {
    /// Number of threads.
    pub threads: usize,
    /// The threads.
    pub pool: ThreadPool,
}

impl Workplace {
    /// Starts the threads, by default one a core.
    ///
    /// # Errors
    /// When the system gives no threads.
    pub fn open(threads: Option<usize>) -> Result<Self, RunError> {
        let threads = threads.unwrap_or_else(default_threads);
        Ok(Self { threads, pool: pool(threads)? })
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
