//! `hotfoot check`: a scenario with all its files, or an FMU.
//!
//! An FMU is checked against the rules of FMI 2.0, for a role, and against its reference result.
//!
//! | file | part |
//! |---|---|
//! | `answer.rs` | what is printed of it, as text or JSON |
//! | `scenario_files.rs` | the files of a scenario |

mod answer;
pub mod scenario_files;

use std::path::{Path, PathBuf};

use answer::{Answer, Problems};
use anyhow::{Result, bail};
use clap::{Args, ValueEnum};
use hotfoot::Import;
use hotfoot::check::reference::{self, Verdict};
use hotfoot::check::{self, Finding, Severity, rules};
use hotfoot::roles;

use crate::options::{Fmus, Quiet, Settings};
use crate::output::print;
use crate::run::scenario_path;
use crate::supervise::command_in_child;
use crate::supervise::limits::Limits;

/// Arguments of `hotfoot check`.
#[derive(Args)]
pub struct CheckArguments {
    /// Scenario: its folder or file, or the name of a shipped one, which is checked up to the first step of its run; or
    /// an FMU
    #[arg(
        value_name = "SCENARIO|FMU",
        required_unless_present = "rules",
        value_parser = scenario_path()
    )]
    fmu: Option<PathBuf>,
    /// Also say whether the FMU can fill this role in the train, and what it lacks
    #[arg(long = "as", value_enum)]
    role: Option<Role>,
    /// Also run the reference result that the FMU carries, and compare
    #[arg(long)]
    replay: bool,
    #[command(flatten)]
    fmus: Fmus,
    #[command(flatten)]
    settings: Settings,
    /// Print what was found as JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    quiet: Quiet,
    /// List the rules for a modelDescription.xml and do nothing else
    #[arg(long)]
    rules: bool,
    #[command(flatten)]
    limits: Limits,
}

/// What an FMU does in a run.
#[derive(Debug, Clone, Copy, ValueEnum)]
enum Role {
    /// The train: one degree of freedom a vehicle
    Longitudinal,
    /// One vehicle in three dimensions
    Vehicle,
    /// One rail's temperature
    Railheat,
}

impl From<Role> for roles::Role {
    fn from(role: Role) -> Self {
        match role {
            Role::Longitudinal => Self::Longitudinal,
            Role::Vehicle => Self::Vehicle,
            Role::Railheat => Self::Railheat,
        }
    }
}

/// Checks an FMU against the rules of FMI 2.0, for a role, and against its reference result.
///
/// # Errors
/// When a rule is broken, the FMU does not fit the role, or it gives another result; the error
/// says all that was found.
pub fn check(arguments: &CheckArguments) -> Result<u8> {
    if arguments.rules {
        for rule in rules() {
            print(format_args!("{:<32} {}", rule.name, rule.wants))?;
        }
        return Ok(0);
    }
    let Some(fmu) = &arguments.fmu else { return Ok(0) };
    let answer = Answer::new(fmu, arguments.json, arguments.quiet.quiet);
    let checked = files::exists(fmu).map_err(Into::into).and_then(|()| {
        let is_scenario = fmu.is_dir() || fmu.extension().is_some_and(|end| end == "toml");
        if is_scenario {
            return check_scenario(fmu, arguments, &answer);
        }
        if let Some(setting) = arguments.settings.settings.first() {
            bail!("{setting}: sets a key of a scenario; an FMU has none");
        }
        command_in_child(&arguments.limits, || answer.of(check_here(fmu, arguments)))
    });
    checked.or_else(|error| answer.of(Err(error)).map(|()| 0))
}

/// Checks a scenario: first the files in this process, then all that FMUs say up to the first step.
fn check_scenario(path: &Path, arguments: &CheckArguments, answer: &Answer<'_>) -> Result<u8> {
    let settings = &arguments.settings.settings;
    let (scenario, file, _) = hotfoot::scenario::load(path, settings)?;
    let notes = scenario_files::check(&scenario)?;
    let fmus = arguments.fmus.folder();
    command_in_child(&arguments.limits, || {
        let started = hotfoot::run::check_until_start(&file, settings, &fmus);
        let found = started.map_err(Into::into).map(|foreseen| {
            let notes = notes.iter().chain(&foreseen).map(|note| format!("note: {note}"));
            notes.chain([format!("{}: can be run", file.display())]).collect()
        });
        answer.of(found)
    })
}

/// What is right with an FMU, in sentences; what is wrong is an error.
fn check_here(fmu: &Path, arguments: &CheckArguments) -> Result<Vec<String>> {
    let (mut right, mut problems) = broken_rules(fmu);
    if problems.is_empty() {
        right.push(format!("{} keeps the rules of FMI 2.0", fmu.display()));
    }
    if let Some(role) = arguments.role {
        match unfit(fmu, role)?.as_slice() {
            [] => right.push(format!("{} can be used as {role:?}", fmu.display())),
            missing => problems.extend_from_slice(missing),
        }
    }
    if arguments.replay {
        match reference::compare(fmu)? {
            Verdict::Same(agreement) => right.push(agreement.to_string()),
            Verdict::Different(differences) => problems.extend(differences),
        }
    }
    match problems.is_empty() {
        true => Ok(right),
        false => Err(Problems { of: fmu.display().to_string(), right, problems }.into()),
    }
}

/// Advice, which makes no FMU wrong, and the rules that are broken.
fn broken_rules(fmu: &Path) -> (Vec<String>, Vec<String>) {
    let (advice, errors): (Vec<_>, Vec<_>) =
        check::check(fmu).into_iter().partition(|finding| finding.severity == Severity::Advice);
    let texts = |findings: &[Finding]| findings.iter().map(ToString::to_string).collect();
    (texts(&advice), texts(&errors))
}

/// What the FMU lacks for a role.
fn unfit(fmu: &Path, role: Role) -> Result<Vec<String>> {
    let missing = roles::missing(&Import::interface_of(fmu)?, role.into());
    if missing.is_empty() {
        return Ok(vec![]);
    }
    let heading = format!("it cannot be used as {role:?}:");
    Ok(std::iter::once(heading).chain(missing).collect())
}
