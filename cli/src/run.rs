//! `hotfoot run`: a scenario or a package, in a child process.

use std::path::{Path, PathBuf};

use anyhow::{Result, anyhow, bail};
use clap::Args;
use hotfoot::recording;
use hotfoot::run::{self, Options, workplace};
use hotfoot::scenario::Times;
use tools::number::{count, positive};

use crate::supervise;

/// Arguments of `hotfoot run`.
#[derive(Args)]
pub struct RunArguments {
    /// Scenario: its folder or file; or an SSP package of any FMUs
    #[arg(required_unless_present = "resume")]
    scenario: Option<PathBuf>,
    /// Go on with the run in this folder of results from its last checkpoint, as it was ordered
    #[arg(
        long,
        value_name = "RESULTS",
        conflicts_with_all = ["scenario", "results", "fmus", "duration", "step", "interval", "checkpoint"]
    )]
    resume: Option<PathBuf>,
    /// Threads for the vehicles; left out: all cores
    #[arg(long, value_parser = count)]
    threads: Option<usize>,
    /// Folder of the results; left out: a new one in `results`
    #[arg(long, short, alias = "output", short_alias = 'o')]
    results: Option<PathBuf>,
    /// Folder of Hotfoot's own FMUs; left out: `fmus` beside the folder of the program
    #[arg(long)]
    fmus: Option<PathBuf>,
    /// Simulated time in place of the scenario's or package's, s
    #[arg(long, value_name = "SECONDS", value_parser = positive)]
    duration: Option<f64>,
    /// Step of the exchange in place of the scenario's or package's, s
    #[arg(long, value_name = "SECONDS", value_parser = positive)]
    step: Option<f64>,
    /// Time between two records in place of the scenario's, s; of an SSP package, left out: 0.1
    #[arg(long, value_name = "SECONDS", value_parser = positive)]
    interval: Option<f64>,
    /// Simulated time between two checkpoints, in place of the scenario's, s; left out by both: none is
    /// written
    #[arg(long, value_name = "SECONDS", value_parser = positive)]
    checkpoint: Option<f64>,
    /// Show no progress
    #[arg(long)]
    quiet: bool,
}

impl RunArguments {
    /// The scenario or package, which is there where no run is resumed.
    fn scenario(&self) -> &Path {
        self.scenario.as_deref().unwrap_or(Path::new(""))
    }
}

/// Runs a scenario in a child process, tells where the results are, and the main figures.
///
/// # Errors
/// When the scenario is wrong, a unit fails or crashes.
pub fn run(arguments: &RunArguments) -> Result<()> {
    if let Some(results) = arguments.results.as_ref().filter(|results| results.is_file()) {
        bail!("--results {}: is a file, where a folder is needed", results.display());
    }
    if supervise::is_child() {
        return run_here(arguments);
    }
    let stated = arguments.results.as_ref().or(arguments.resume.as_ref());
    let results = stated.cloned().unwrap_or_else(|| workplace::new_results(arguments.scenario()));
    let further = match stated {
        Some(_) => vec![],
        None => vec!["--results".into(), results.clone().into_os_string()],
    };
    supervise::in_child(&further, || {
        let series = results.join("series");
        if !series.exists() {
            bail!("an FMU has crashed the run before anything was recorded");
        }
        recording::complete(&series)?;
        Err(anyhow!(
            "an FMU has crashed the run; the results until then are in {}",
            results.display()
        ))
    })
}

fn run_here(arguments: &RunArguments) -> Result<()> {
    let options = Options {
        threads: arguments.threads,
        results: arguments.results.clone(),
        fmus: arguments.fmus.clone().unwrap_or_else(default_fmus),
        times: Times {
            duration: arguments.duration,
            step: arguments.step,
            interval: arguments.interval,
            checkpoint: arguments.checkpoint,
        },
        quiet: arguments.quiet,
    };
    let finished = match &arguments.resume {
        Some(results) => run::resume(results, &options)?,
        None => run::run(arguments.scenario(), &options)?,
    };
    println!("{finished}");
    Ok(())
}

/// `fmus` beside the folder of the program: `target/fmus` for `target/release/hotfoot`.
pub fn default_fmus() -> PathBuf {
    let program = std::env::current_exe().unwrap_or_default();
    let folder = program.parent().and_then(Path::parent).unwrap_or(Path::new("."));
    folder.join("fmus")
}
