//! `hotfoot schema`: what may stand in the files that people write.

use anyhow::Result;
use clap::{Args, ValueEnum};
use hotfoot::check::reference::Experiment;
use hotfoot::run::expected;
use hotfoot::scenario;
use tools::schema as files;

use crate::output::print_json;

/// Arguments of `hotfoot schema`.
#[derive(Args)]
pub struct SchemaArguments {
    /// Kind of file
    #[arg(value_enum, default_value_t = Kind::Scenario)]
    kind: Kind,
}

/// A kind of file that people write.
#[derive(Debug, Clone, Copy, ValueEnum)]
enum Kind {
    /// Scenario: a JSON schema of its TOML, as of the next ones
    Scenario,
    /// Track
    Track,
    /// Driver
    Driver,
    /// Vehicle type
    Vehicle,
    /// Draft gear
    DraftGear,
    /// Rail section
    Rail,
    /// Expected figures of a scenario, for `hotfoot expect`
    Expected,
    /// Consist, in the resources of the train's FMU
    Consist,
    /// Wheels and probes, `railheat.toml` in the resources of the rail's FMU
    RailHeat,
    /// Experiment of an FMU's reference result, `experiment.toml`
    Experiment,
    /// Columns of a weather file: a Table Schema, as of the next ones
    Weather,
    /// Columns of a logger's file, which a driver replays
    Logger,
    /// Columns of measured irregularities of the rails
    Irregularity,
    /// Columns of a profile of a wheel or rail
    Profile,
}

/// Prints the schema of a kind of file.
///
/// # Errors
/// When it cannot be written.
pub fn schema(arguments: &SchemaArguments) -> Result<()> {
    match arguments.kind {
        Kind::Scenario => print_json(&schemars::schema_for!(scenario::Scenario)),
        Kind::Track => print_json(&files::track()),
        Kind::Driver => print_json(&files::driver()),
        Kind::Vehicle => print_json(&files::vehicle()),
        Kind::DraftGear => print_json(&files::draft_gear()),
        Kind::Rail => print_json(&files::rail()),
        Kind::Expected => print_json(&expected::schema()),
        Kind::Consist => print_json(&files::consist()),
        Kind::RailHeat => print_json(&files::rail_heat()),
        Kind::Experiment => print_json(&schemars::schema_for!(Experiment)),
        Kind::Weather => print_json(&files::weather()),
        Kind::Logger => print_json(&files::logger()),
        Kind::Irregularity => print_json(&files::irregularity()),
        Kind::Profile => print_json(&files::profile()),
    }
}
