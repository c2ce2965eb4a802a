//! The program `hotfoot`: its commands, which the libraries of the master and of the tools carry out.
//!
//! | file | commands |
//! |---|---|
//! | `run.rs` | `run` |
//! | `supervise.rs` | a command in a child process, which an FMU may crash |
//! | `export_ssp.rs`, `pack.rs`, `check.rs` | the commands of the same names |
//! | `results.rs` | `report`, `expect` |
//! | `interface.rs` | `interface`, `schema` |
//!
//! `modes`, `contact`, `creep` and `critical-speed` stand in the library `tools` (`crates/tools`).

mod check;
mod export_ssp;
mod interface;
mod pack;
mod results;
mod run;
mod supervise;

use std::path::PathBuf;

use clap::{Parser, Subcommand};
use tools::{contact, creep, critical_speed, modes};

/// Full-train co-simulation of in-train forces, wheel-rail contact and rail-foot heat.
#[derive(Parser)]
#[command(version)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Run a scenario and write its results and report, or run an SSP package
    Run(run::RunArguments),
    /// Write a scenario's train as an SSP package for other tools
    ExportSsp(export_ssp::ExportArguments),
    /// Make the report of a results folder again
    Report {
        /// Folder that a run has written
        results: PathBuf,
    },
    /// Compare the figures of a run with those expected of its scenario
    Expect {
        /// Folder that a run has written
        results: PathBuf,
        /// File of expected figures, such as `expected.toml` beside the scenario
        expected: PathBuf,
    },
    /// Check an FMU against the rules of FMI 2.0, for a role in the train, and against the
    /// reference result that it carries
    Check(check::CheckArguments),
    /// Pack an FMU: a binary with resources and the model description for them
    Pack(pack::PackArguments),
    /// List the variables of an FMU
    Interface {
        /// FMU
        fmu: PathBuf,
        /// Print the modelDescription.xml as it is
        #[arg(long)]
        xml: bool,
    },
    /// Print the JSON schema of scenario files, for editors
    Schema,
    /// Natural frequencies, damping and shapes of a vehicle on its suspension
    Modes(modes::ModesArguments),
    /// How a wheelset touches its rails over the lateral displacement
    Contact(contact::ContactArguments),
    /// Creep forces, friction power and flash temperature of one contact
    Creep(creep::CreepArguments),
    /// Speed at which a vehicle on straight track becomes unstable
    CriticalSpeed(critical_speed::CriticalSpeedArguments),
}

fn main() -> miette::Result<()> {
    // Wrapped lines would break the names of files.
    miette::set_hook(Box::new(|_| {
        Box::new(miette::MietteHandlerOpts::new().wrap_lines(false).build())
    }))?;
    match Arguments::parse().command {
        Command::Run(arguments) => run::run(&arguments),
        Command::ExportSsp(arguments) => export_ssp::export_ssp(&arguments),
        Command::Report { results } => results::report(&results),
        Command::Expect { results, expected } => results::expect(&results, &expected),
        Command::Check(arguments) => check::check(&arguments),
        Command::Pack(arguments) => pack::pack(&arguments),
        Command::Interface { fmu, xml } => interface::interface(&fmu, xml),
        Command::Schema => interface::schema(),
        Command::Modes(arguments) => modes::modes(&arguments),
        Command::Contact(arguments) => contact::contact(&arguments),
        Command::Creep(arguments) => creep::creep(&arguments),
        Command::CriticalSpeed(arguments) => critical_speed::critical_speed(&arguments),
    }
}
