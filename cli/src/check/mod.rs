//! `hotfoot check`: a scenario with all its files, or an FMU.
//!
//! An FMU is checked against the rules of FMI 2.0, for a role, and against its reference result.
//!
//! | file | part |
//! |---|---|
//! | `scenario_files.rs` | the files of a scenario |

pub mod scenario_files;

use std::path::{Path, PathBuf};

use anyhow::{Result, anyhow};
use clap::{Args, ValueEnum};
use hotfoot::Import;
use hotfoot::check::reference::{self, Verdict};
use hotfoot::check::{self, Severity, rules};
use hotfoot::roles;

use crate::output::print;
use crate::run::{default_fmus, scenario_path};
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
    /// Folder of Hotfoot's own FMUs; left out: `fmus` beside the folder of the program
    #[arg(long)]
    fmus: Option<PathBuf>,
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
    files::exists(fmu)?;
    if fmu.is_dir() || fmu.extension().is_some_and(|extension| extension == "toml") {
        return check_scenario(fmu, arguments);
    }
    command_in_child(&arguments.limits, || check_here(fmu, arguments))
}

/// Checks a scenario: first the files in this process, then all that FMUs say up to the first step.
fn check_scenario(path: &Path, arguments: &CheckArguments) -> Result<u8> {
    let (scenario, file, _) = hotfoot::scenario::load(path, &[])?;
    let notes = scenario_files::check(&scenario)?;
    command_in_child(&arguments.limits, || {
        let fmus = arguments.fmus.clone().unwrap_or_else(default_fmus);
        let check_until_startn = hotfoot::run::check_until_start(&file, &fmus)?;
        for note in notes.iter().chain(&check_until_startn) {
            print(format_args!("note: {note}"))?;
        }
        print(format_args!("{}: can be run", file.display()))
    })
}

fn check_here(fmu: &Path, arguments: &CheckArguments) -> Result<()> {
    let mut problems = broken_rules(fmu)?;
    if problems.is_empty() {
        print(format_args!("{} keeps the rules of FMI 2.0", fmu.display()))?;
    }
    if let Some(role) = arguments.role {
        problems.extend(unfit(fmu, role)?);
    }
    if arguments.replay {
        match reference::compare(fmu)? {
            Verdict::Same(agreement) => print(agreement)?,
            Verdict::Different(differences) => problems.extend(differences),
        }
    }
    match problems.is_empty() {
        true => Ok(()),
        false => Err(anyhow!("{}:\n{}", fmu.display(), problems.join("\n"))),
    }
}

/// The rules that are broken; advice is printed at once, as it makes no FMU wrong.
fn broken_rules(fmu: &Path) -> Result<Vec<String>> {
    let (advice, errors): (Vec<_>, Vec<_>) =
        check::check(fmu).into_iter().partition(|finding| finding.severity == Severity::Advice);
    for finding in advice {
        print(finding)?;
    }
    Ok(errors.iter().map(ToString::to_string).collect())
}

/// What the FMU lacks for a role.
fn unfit(fmu: &Path, role: Role) -> Result<Vec<String>> {
    let missing = roles::missing(&Import::interface_of(fmu)?, role.into());
    if missing.is_empty() {
        print(format_args!("{} can be used as {role:?}", fmu.display()))?;
        return Ok(vec![]);
    }
    let heading = format!("it cannot be used as {role:?}:");
    Ok(std::iter::once(heading).chain(missing).collect())
}
