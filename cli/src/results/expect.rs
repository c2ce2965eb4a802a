//! `hotfoot expect`: the figures of a run against those expected of its scenario.

use std::path::PathBuf;

use anyhow::{Result, bail};
use clap::Args;
use hotfoot::run::expected::{self, Comparison};
use serde::Serialize;

use crate::options::Quiet;
use crate::output::{print, print_json};
use crate::results::report::check_folder;

/// Arguments of `hotfoot expect`.
#[derive(Args)]
pub struct ExpectArguments {
    /// Folder that a run has written
    results: PathBuf,
    /// File of expected figures, such as `expected.toml` beside the scenario
    expected: PathBuf,
    /// Print the figures as JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    quiet: Quiet,
}

/// The answer for scripts.
#[derive(Serialize)]
struct Report<'a> {
    /// Whether all figures agree.
    ok: bool,
    figures: &'a [Comparison],
}

/// Says how the figures of a run compare with those expected of its scenario. Gives the exit code.
///
/// # Errors
/// When a file cannot be read, or a figure differs.
pub fn expect(arguments: &ExpectArguments) -> Result<u8> {
    check_folder(&arguments.results)?;
    let figures = expected::compare(&arguments.results, &arguments.expected)?;
    let differ = figures.iter().filter(|figure| !figure.agrees).count();
    if arguments.json {
        print_json(&Report { ok: differ == 0, figures: &figures })?;
        return Ok(u8::from(differ > 0));
    }
    let mut shown = figures.iter().filter(|figure| !figure.agrees || !arguments.quiet.quiet);
    shown.try_for_each(print)?;
    match differ {
        0 => Ok(0),
        count => bail!("{count} of {} figures differ", figures.len()),
    }
}
