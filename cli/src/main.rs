//! The program `hotfoot`: its commands, which the libraries of the master and of the tools carry out.
//!
//! | file | commands |
//! |---|---|
//! | `run.rs` | `run` |
//! | `scenario/` | `new`, `wiring`, `export-ssp` |
//! | `check/` | `check` |
//! | `results/` | `report`, `expect`, `compare` |
//! | `fmu/` | `interface`, `pack` |
//! | `reference/` | `stock`, `schema`, `completions`, `man` |
//! | `supervise/` | a command in a child process, which an FMU may crash |
//! | `examples.rs` | the examples in their help |
//! | `options.rs` | the options that several commands have |
//! | `output.rs` | what is printed, and the message of an error |
//!
//! `modes`, `contact`, `profile`, `creep` and `critical-speed` stand in the library `tools` (`crates/tools`).

mod check;
mod examples;
mod fmu;
mod options;
mod output;
mod reference;
mod results;
mod run;
mod scenario;
mod supervise;

use std::path::PathBuf;
use std::process::ExitCode;

use anyhow::{Context, Result};
use clap::{CommandFactory, Parser, Subcommand};
use hotfoot::shipped;
use tools::{ToolError, contact, creep, critical_speed, modes, profile};

use crate::fmu::{interface, pack};
use crate::output::{Reported, is_closed_pipe, message, tell};
use crate::reference::{schema, shells, stock};
use crate::results::{compare, expect, report};
use crate::scenario::{export_ssp, new, wiring};
use crate::supervise::child;

/// Full-train co-simulation of in-train forces, wheel-rail contact and rail-foot heat.
#[derive(Parser)]
#[command(version, after_help = examples::ALL)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Run a scenario and write its results and report, or run an SSP package
    #[command(after_help = examples::RUN)]
    Run(run::RunArguments),
    /// Make the folder of a new scenario from a template with comments
    #[command(after_help = examples::NEW)]
    New(new::NewArguments),
    /// Write a scenario's train as an SSP package for other tools
    #[command(after_help = examples::EXPORT_SSP)]
    ExportSsp(export_ssp::ExportArguments),
    /// Show the components of a scenario or an SSP package, when they step, and what flows between
    #[command(after_help = examples::WIRING)]
    Wiring(wiring::WiringArguments),
    /// Make the report of a results folder again
    #[command(after_help = examples::REPORT)]
    Report(report::ReportArguments),
    /// List the rolling stock that is shipped, show the figures of an entry, or where they are from
    #[command(after_help = examples::STOCK)]
    Stock(stock::StockArguments),
    /// Compare runs with each other or with measurements: inputs, errors of every column, a page of curves
    #[command(after_help = examples::COMPARE)]
    Compare(compare::CompareArguments),
    /// Compare the figures of a run with those expected of its scenario
    #[command(after_help = examples::EXPECT)]
    Expect(expect::ExpectArguments),
    /// Check a scenario with all its files, or an FMU against FMI 2.0, for a role and its reference result
    #[command(after_help = examples::CHECK)]
    Check(check::CheckArguments),
    /// Pack an FMU: a binary with resources and the model description for them
    #[command(after_help = examples::PACK)]
    Pack(pack::PackArguments),
    /// List the variables of an FMU
    #[command(after_help = examples::INTERFACE)]
    Interface(interface::InterfaceArguments),
    /// Print the JSON schema of a kind of file, for editors
    #[command(after_help = examples::SCHEMA)]
    Schema(schema::SchemaArguments),
    /// Print what a shell needs to complete the commands and options
    #[command(after_help = examples::COMPLETIONS)]
    Completions(shells::CompletionsArguments),
    /// Write the manual pages of all commands
    #[command(after_help = examples::MAN)]
    Man {
        /// Folder of the pages, which is made
        folder: PathBuf,
    },
    /// Natural frequencies, damping and shapes of a vehicle on its suspension
    #[command(after_help = examples::MODES)]
    Modes(modes::ModesArguments),
    /// How a wheelset touches its rails over the lateral displacement
    #[command(after_help = examples::CONTACT)]
    Contact(contact::ContactArguments),
    /// What is understood of a file of points of a wheel or rail, and a clean file of it
    #[command(after_help = examples::PROFILE)]
    Profile(profile::ProfileArguments),
    /// Creep forces, friction power and flash temperature of one contact
    #[command(after_help = examples::CREEP)]
    Creep(creep::CreepArguments),
    /// Speed at which a vehicle on straight track becomes unstable
    #[command(after_help = examples::CRITICAL_SPEED)]
    CriticalSpeed(critical_speed::CriticalSpeedArguments),
}

fn main() -> ExitCode {
    #[cfg(target_os = "linux")]
    if let Some(code) = hotfoot::serve() {
        return code;
    }
    if let Err(reason) = child::begin() {
        tell(format_args!("Error: {reason}"));
        return ExitCode::FAILURE;
    }
    let code = match Arguments::try_parse() {
        Ok(arguments) => outcome(carry_out(arguments.command)),
        // Help, the version, or what is wrong with the arguments.
        Err(answer) => {
            let code = u8::try_from(answer.exit_code()).unwrap_or(1);
            outcome(answer.print().context("the answer cannot be written").map(|()| code))
        }
    };
    if let Some(child) = child::own() {
        child.finish(code);
        hotfoot::note_unloading();
    }
    ExitCode::from(code)
}

/// The exit code of what was done; an error is told. That nobody reads any more is none.
fn outcome(done: Result<u8>) -> u8 {
    match done {
        Ok(code) => code,
        Err(error) if is_closed_pipe(&error) => 0,
        Err(error) if error.is::<Reported>() => 1,
        Err(error) => {
            tell(format_args!("Error: {}", message(&error)));
            1
        }
    }
}

/// Carries a command out, and gives its exit code.
fn carry_out(command: Command) -> Result<u8> {
    let done = match command {
        Command::Run(arguments) => return run::run(&arguments),
        Command::ExportSsp(arguments) => return export_ssp::export_ssp(&arguments),
        Command::Wiring(arguments) => return wiring::print(&arguments),
        Command::Check(arguments) => return check::check(&arguments),
        Command::Expect(arguments) => return expect::expect(&arguments),
        Command::Pack(arguments) => return pack::pack(&arguments),
        Command::Stock(arguments) => stock::stock(&arguments),
        Command::Compare(arguments) => return compare::compare(&arguments),
        Command::New(arguments) => new::new(&arguments),
        Command::Report(arguments) => report::report(&arguments),
        Command::Interface(arguments) => interface::interface(&arguments),
        Command::Schema(arguments) => schema::schema(&arguments),
        Command::Completions(arguments) => {
            shells::completions(&arguments, &mut Arguments::command())
        }
        Command::Man { folder } => shells::man(&folder, Arguments::command()),
        Command::Modes(mut arguments) => {
            arguments.vehicle.or_library(shipped::folder("stock"));
            print(modes::modes(&arguments))
        }
        Command::Contact(arguments) => print(contact::contact(&arguments)),
        Command::Profile(arguments) => print(profile::profile(&arguments)),
        Command::Creep(arguments) => print(creep::creep(&arguments)),
        Command::CriticalSpeed(mut arguments) => {
            arguments.vehicle.or_library(shipped::folder("stock"));
            print(critical_speed::critical_speed(&arguments))
        }
    };
    done.map(|()| 0)
}

/// Prints what an engineering command answers.
fn print(answer: Result<String, ToolError>) -> Result<()> {
    output::write(answer?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_options_of_all_commands_go_together() {
        Arguments::command().debug_assert();
    }

    /// Whoever asks for help sees what every option does, and an example that can be typed.
    #[test]
    fn every_command_explains_its_options_and_shows_an_example() {
        for command in Arguments::command().get_subcommands() {
            let name = command.get_name();
            assert!(command.get_about().is_some(), "{name} does not say what it does");
            let example = command.get_after_help().map(ToString::to_string).unwrap_or_default();
            assert!(example.contains(&format!("hotfoot {name}")), "{name} shows no example");
            for option in command.get_arguments() {
                assert!(option.get_help().is_some(), "{name} does not explain {}", option.get_id());
            }
        }
    }

    /// Each example is a command that the program takes.
    #[test]
    fn every_example_can_be_typed() {
        for command in Arguments::command().get_subcommands() {
            let text = command.get_after_help().map(ToString::to_string).unwrap_or_default();
            let examples = text.lines().map(str::trim).filter(|line| line.starts_with("hotfoot "));
            for example in examples {
                let words = example.split_whitespace();
                let parsed = Arguments::try_parse_from(words);
                assert!(parsed.is_ok(), "{example}: {}", parsed.err().unwrap());
            }
        }
    }
}
