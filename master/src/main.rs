//! The program `hotfoot`.

use std::path::PathBuf;

use clap::{Parser, Subcommand};
use hotfoot::{Role, commands};

/// Full-train co-simulation of in-train forces, wheel-rail contact and rail-foot heat.
#[derive(Parser)]
#[command(version)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Run a scenario and write its results and report
    Run(commands::RunArguments),
    /// Make the report of a results folder again
    Report {
        /// Folder that a run has written
        results: PathBuf,
    },
    /// Say whether an FMU can fill a role in the train, and what it lacks
    Check {
        /// FMU
        fmu: PathBuf,
        /// The role
        #[arg(long = "as", value_enum)]
        role: Role,
    },
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
        Command::Report { results } => commands::report(&results),
        Command::Check { fmu, role } => commands::check(&fmu, role),
        Command::Pack(arguments) => commands::pack(&arguments),
        Command::Interface { fmu, xml } => commands::interface(&fmu, xml),
        Command::Schema => commands::schema(),
        Command::Modes(arguments) => commands::tool("modes", &arguments),
        Command::Contact(arguments) => commands::tool("contact", &arguments),
        Command::Creep(arguments) => commands::tool("creep", &arguments),
        Command::CriticalSpeed(arguments) => commands::tool("critical-speed", &arguments),
    }
}
