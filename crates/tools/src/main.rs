//! The program `hotfoot-tools`, which `hotfoot` starts for its engineering commands.

use clap::{Parser, Subcommand};
use tools::{contact, creep, critical_speed, modes};

/// Engineering commands of Hotfoot that ask a model directly.
#[derive(Parser)]
#[command(version, bin_name = "hotfoot")]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
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
        Command::Modes(arguments) => modes::modes(&arguments),
        Command::Contact(arguments) => contact::contact(&arguments),
        Command::Creep(arguments) => creep::creep(&arguments),
        Command::CriticalSpeed(arguments) => critical_speed::critical_speed(&arguments),
    }
}
