//! `hotfoot run`: a scenario or a package, in a child process.

use std::path::{Path, PathBuf};

use anyhow::{Error, Result, anyhow};
use clap::builder::{PathBufValueParser, TypedValueParser};
use clap::{Args, ValueEnum};
use files::Setting;
use hotfoot::run::folder::claim::Claim;
use hotfoot::run::folder::complete::complete;
use hotfoot::run::{self, Ended, Options, is_system};
use hotfoot::scenario::Times;
use hotfoot::shipped;
use tools::number::{count, positive};

use crate::check::scenario_files;
use crate::options::{Fmus, Settings};
use crate::output::{self, tell};
use crate::results::report::write_csv;
use crate::supervise::child::{self, Child};
use crate::supervise::limits::Limits;
use crate::supervise::{self, Blame, End, exit_code};

/// Arguments of `hotfoot run`.
#[derive(Args)]
pub struct RunArguments {
    /// Scenario: its folder or file, or the name of a shipped one, such as first-look; or any FMUs: an SSP package
    /// (.ssp, its folder, or .ssd), or one .fmu
    #[arg(required_unless_present = "resume", value_parser = scenario_path())]
    scenario: Option<PathBuf>,
    /// Go on with the run in this folder of results from its last checkpoint, as it was ordered
    #[arg(
        long,
        value_name = "RESULTS",
        conflicts_with_all = [
            "scenario", "results", "overwrite", "fmus", "settings", "duration", "step", "interval", "checkpoint",
            "tolerance", "checks", "same_thread", "isolate", "record",
        ]
    )]
    resume: Option<PathBuf>,
    /// Threads for the vehicles; left out: all cores
    #[arg(long, value_parser = count)]
    threads: Option<usize>,
    /// Folder of the results; left out: a new one in `results`
    #[arg(long, short, alias = "output", short_alias = 'o')]
    results: Option<PathBuf>,
    /// Replace the results of an earlier run in that folder
    #[arg(long)]
    overwrite: bool,
    #[command(flatten)]
    fmus: Fmus,
    #[command(flatten)]
    settings: Settings,
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
    /// Run the FMU of this component in a process of its own, such as `vehicle[2]`; `all` stands for all
    #[arg(long, value_name = "NAME")]
    isolate: Vec<String>,
    /// Record the outputs that fit this pattern, in which `*` stands for any text; can be given more than once
    ///
    /// Of a package or an FMU: `component.output`, such as 'vehicle_1.*' (write the quotes); left out: the
    /// outputs that are connected, and of a component of which none is, all. Of a scenario: outputs of the
    /// vehicles whose wheels are recorded, such as '*.derailment_quotient', in place of its `record.outputs`.
    #[arg(long, value_name = "PATTERN")]
    record: Vec<String>,
    /// Also write each table as a CSV file into the folder `csv` of the results
    #[arg(long)]
    csv: bool,
    /// Print the figures of the run as JSON
    #[arg(long)]
    json: bool,
    /// Show no progress
    #[arg(long)]
    quiet: bool,
    #[command(flatten)]
    limits: Limits,
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

impl RunArguments {
    /// The scenario or package, which is there where no run is resumed.
    fn scenario(&self) -> &Path {
        self.scenario.as_deref().unwrap_or(Path::new(""))
    }

    /// The values of the scenario's keys, of which the outputs that are recorded are one.
    fn settings(&self) -> Result<Vec<Setting>> {
        let mut settings = self.settings.settings.clone();
        if !self.record.is_empty() && !is_system(self.scenario()) {
            let outputs = format!("record.outputs={:?}", self.record);
            settings.push(outputs.parse().map_err(Error::msg)?);
        }
        Ok(settings)
    }
}

/// Runs a scenario in a child process, tells where the results are, and the main figures.
/// Gives the exit code.
///
/// # Errors
/// When the scenario is wrong, or a unit fails or crashes.
pub fn run(arguments: &RunArguments) -> Result<u8> {
    match child::own() {
        Some(child) => run_here(arguments, child),
        None => run_in_child(arguments),
    }
}

fn run_in_child(arguments: &RunArguments) -> Result<u8> {
    let claim = match (&arguments.resume, &arguments.results) {
        (Some(folder), _) => Claim::to_resume(folder)?,
        (None, Some(folder)) => Claim::of(folder, arguments.overwrite)?,
        (None, None) => Claim::of_new(arguments.scenario())?,
    };
    match supervise::in_child(&arguments.limits, Some(claim.folder())) {
        Ok(End { finished: Some(code), blame, records }) => {
            // A start that has failed leaves nothing.
            if records > 0 {
                claim.release()
            } else {
                claim.undo()
            }
            blame.iter().for_each(Blame::warn);
            Ok(code)
        }
        Ok(End { finished: None, blame, records }) => {
            complete_results(claim, &blame.unwrap_or_default(), records)
        }
        Err(error) => {
            claim.undo();
            Err(error)
        }
    }
}

/// Completes what a child has left that has not done so itself, and tells why.
fn complete_results(claim: Claim, blame: &Blame, records: u64) -> Result<u8> {
    let Blame { sentence, interrupted, at_once } = blame;
    let folder = claim.folder().display().to_string();
    let answer = |sentence: String| match interrupted {
        Some(signal) => {
            tell(sentence);
            Ok(exit_code(*signal))
        }
        None => Err(anyhow!(sentence)),
    };
    if *at_once && records > 0 {
        return answer(format!("{sentence}; `hotfoot report {folder}` completes its results"));
    }
    let end = if interrupted.is_some() { run::End::Interrupted } else { run::End::Failed };
    let completed = match records {
        0 if !claim.goes_on() => Ok(None),
        _ => complete(claim.folder(), Ended::because(end, sentence)),
    };
    match completed {
        Ok(Some(_)) => {
            claim.release();
            answer(format!("{sentence}; the results until then are in {folder}"))
        }
        Ok(None) => {
            claim.undo();
            answer(format!("{sentence}; nothing was recorded before"))
        }
        Err(error) => answer(format!(
            "{sentence}; the results until then are in {folder}, but they could not be completed, which \
             `hotfoot report {folder}` tries again: {error}"
        )),
    }
}

fn run_here(arguments: &RunArguments, child: &Child) -> Result<u8> {
    let options = Options {
        threads: arguments.threads,
        fmus: arguments.fmus.folder(),
        settings: arguments.settings()?,
        record: match is_system(arguments.scenario()) {
            true => arguments.record.clone(),
            false => vec![],
        },
        times: Times {
            duration: arguments.duration,
            step: arguments.step,
            interval: arguments.interval,
            checkpoint: arguments.checkpoint,
        },
        tolerance: arguments.tolerance,
        checks: arguments.checks.map(Into::into),
        same_thread: arguments.same_thread,
        isolate: arguments.isolate.clone(),
        quiet: arguments.quiet,
    };
    let results = child.results().ok_or_else(|| anyhow!("the parent has given no folder"))?;
    let finished = match &arguments.resume {
        Some(_) => run::resume(results, &options)?,
        None => {
            note_files(arguments)?;
            run::run(arguments.scenario(), results, &options)?
        }
    };
    let mut code = 0;
    if let Some(stopped) = finished.stopped() {
        tell(format_args!("{stopped}; the results until then are in {}", results.display()));
        code = exit_code(stopped.signal);
    }
    if arguments.csv {
        write_csv(results)?;
    }
    match arguments.json {
        true => output::print_json(&finished.summary(results))?,
        false => output::print(&finished)?,
    }
    // All is done; what the FMUs do when they are freed can only be a reason for a warning.
    child.finish(code);
    Ok(code)
}

/// Checks the files of a scenario, and tells what is hardly meant.
fn note_files(arguments: &RunArguments) -> Result<()> {
    let path = arguments.scenario();
    if is_system(path) {
        return Ok(());
    }
    let (mut scenario, file, _) = hotfoot::scenario::load(path, &arguments.settings()?)?;
    let times = Times { duration: arguments.duration, ..Times::default() };
    times.replace_in(&mut scenario, &file)?;
    for note in scenario_files::check(&scenario)? {
        tell(format_args!("note: {note}"));
    }
    Ok(())
}

/// Takes the path of a scenario, or the name of a shipped one.
pub fn scenario_path() -> impl TypedValueParser<Value = PathBuf> {
    PathBufValueParser::new().map(shipped::scenario)
}
