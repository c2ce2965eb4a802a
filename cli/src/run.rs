//! `hotfoot run`: a scenario or a package, in a child process.

use std::path::{Path, PathBuf};

use anyhow::{Result, anyhow, bail};
use clap::{Args, ValueEnum};
use hotfoot::recording;
use hotfoot::run::{self, Options, workplace};
use hotfoot::scenario::Times;
use tools::number::{count, positive};

use crate::supervise;

/// Arguments of `hotfoot run`.
#[derive(Args)]
pub struct RunArguments {
    /// Scenario: its folder or file; or any FMUs: an SSP package (.ssp, its folder, or .ssd), or one .fmu
    scenario: PathBuf,
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
    /// Relative tolerance for the solvers of the FMUs in place of what each proposes, such as 1e-6
    #[arg(long, value_name = "TOLERANCE", value_parser = positive)]
    tolerance: Option<f64>,
    /// What becomes of values that FMUs give and that cannot be, in place of the scenario's `checks`; left out:
    /// a value that is not finite ends the run, and one out of its range is a warning
    #[arg(long, value_enum)]
    checks: Option<Checks>,
    /// Call each FMU of an SSP package, and each that the scenario names, on a thread of its own
    #[arg(long)]
    same_thread: bool,
    /// Show no progress
    #[arg(long)]
    quiet: bool,
}

/// What becomes of values that cannot be.
#[derive(Debug, Clone, Copy, ValueEnum)]
enum Checks {
    /// They end the run
    Error,
    /// They are warnings, the first time for each variable
    Warn,
    /// They are not looked for
    Off,
}

impl From<Checks> for hotfoot::Checks {
    fn from(checks: Checks) -> Self {
        match checks {
            Checks::Error => Self::Error,
            Checks::Warn => Self::Warn,
            Checks::Off => Self::Off,
        }
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
    let results =
        arguments.results.clone().unwrap_or_else(|| workplace::new_results(&arguments.scenario));
    let further = match arguments.results {
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
        },
        tolerance: arguments.tolerance,
        checks: arguments.checks.map(Into::into),
        same_thread: arguments.same_thread,
        quiet: arguments.quiet,
    };
    println!("{}", run::run(&arguments.scenario, &options)?);
    Ok(())
}

/// `fmus` beside the folder of the program: `target/fmus` for `target/release/hotfoot`.
pub fn default_fmus() -> PathBuf {
    let program = std::env::current_exe().unwrap_or_default();
    let folder = program.parent().and_then(Path::parent).unwrap_or(Path::new("."));
    folder.join("fmus")
}
