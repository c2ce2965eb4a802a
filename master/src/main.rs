//! The program `hotfoot`.

use std::path::PathBuf;

use clap::{Parser, Subcommand};
use hotfoot::{check, commands};

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
    Run(commands::RunArguments),
    /// Write a scenario's train as an SSP package for other tools
    ExportSsp(commands::ExportArguments),
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
    Pack(commands::PackArguments),
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
    #[command(disable_help_flag = true)]
    Modes(commands::ToolArguments),
    /// How a wheelset touches its rails over the lateral displacement
    #[command(disable_help_flag = true)]
    Contact(commands::ToolArguments),
    /// Creep forces, friction power and flash temperature of one contact
    #[command(disable_help_flag = true)]
    Creep(commands::ToolArguments),
    /// Speed at which a vehicle on straight track becomes unstable
    #[command(disable_help_flag = true)]
    CriticalSpeed(commands::ToolArguments),
}

fn main() -> miette::Result<()> {
    // Wrapped lines would break the names of files.
    miette::set_hook(Box::new(|_| {
        Box::new(miette::MietteHandlerOpts::new().wrap_lines(false).build())
    }))?;
    match Arguments::parse().command {
        Command::Run(arguments) => commands::run(&arguments),
        Command::ExportSsp(arguments) => commands::export_ssp(&arguments),
        Command::Report { results } => commands::report(&results),
        Command::Expect { results, expected } => commands::expect(&results, &expected),
        Command::Check(arguments) => check::command(&arguments),
        Command::Pack(arguments) => commands::pack(&arguments),
        Command::Interface { fmu, xml } => commands::interface(&fmu, xml),
        Command::Schema => commands::schema(),
        Command::Modes(arguments) => commands::tool("modes", &arguments),
        Command::Contact(arguments) => commands::tool("contact", &arguments),
        Command::Creep(arguments) => commands::tool("creep", &arguments),
        Command::CriticalSpeed(arguments) => commands::tool("critical-speed", &arguments),
    }
}
