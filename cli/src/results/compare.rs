//! `hotfoot compare`: runs beside each other, or beside a measurement.

use std::path::PathBuf;

use anyhow::{Result, ensure};
use clap::Args;
use hotfoot::report::compare::{
    Compared, Comparison, FieldErrors, How, Mapping, MeasurementOptions,
    compare as compare_results, write_page,
};
use numerics::seconds;
use tools::number::positive;

use crate::output::{print, print_json};
use crate::results::report::check_folder;

/// Name of the page where none is given.
const PAGE: &str = "comparison.html";

/// Most columns that the terminal shows.
const MOST_LINES: usize = 25;

/// Arguments of `hotfoot compare`.
#[derive(Args)]
pub struct CompareArguments {
    /// Folder of the run that others are compared with
    #[arg(value_name = "RESULTS")]
    first: PathBuf,
    /// Folders of other runs, or CSV files of measurements
    #[arg(required = true, value_name = "RESULTS|CSV")]
    others: Vec<PathBuf>,
    /// Signal that a column of a measurement stands for, such as V_GPS=vehicles[1].velocity; can be given more
    /// than once
    ///
    /// Needed where the column's name is none of TABLE.COLUMN, TABLE[ROW].COLUMN, or that of a column that is in
    /// one table and one row only. A unit behind the name is converted: `V_GPS [km/h]`; left out: SI.
    #[arg(long = "map", value_name = "COLUMN=SIGNAL")]
    mappings: Vec<Mapping>,
    /// Column with the times of measurements; left out: time, time_s or t
    #[arg(long, value_name = "COLUMN")]
    time: Option<String>,
    /// Added to the times of measurements, s
    #[arg(long, value_name = "SECONDS", default_value_t = 0.0, allow_negative_numbers = true)]
    shift: f64,
    /// Largest relative difference of a column that is taken as agreement, such as 1e-6; a larger one makes the
    /// exit code 1
    #[arg(long, value_name = "RELATIVE", value_parser = positive)]
    tolerance: Option<f64>,
    /// Page with the curves; left out: comparison.html in the current folder, and none with --json
    #[arg(long, short, value_name = "HTML")]
    output: Option<PathBuf>,
    /// Print what differs as JSON
    #[arg(long)]
    json: bool,
    /// Show no table
    #[arg(long)]
    quiet: bool,
}

/// Compares runs, writes the page, and prints the table. Gives the exit code.
///
/// # Errors
/// When a folder or file cannot be read, or there is nothing in common.
pub fn compare(arguments: &CompareArguments) -> Result<u8> {
    check_folder(&arguments.first)?;
    for other in &arguments.others {
        match other.is_dir() {
            true => check_folder(other)?,
            false => files::exists(other)?,
        }
    }
    let is_measured = arguments.others.iter().any(|other| !other.is_dir());
    let is_about_columns =
        arguments.time.is_some() || arguments.shift != 0.0 || !arguments.mappings.is_empty();
    ensure!(
        is_measured || !is_about_columns,
        "--map, --time and --shift are of the columns of a measurement; name a CSV file, or leave them out"
    );
    let options = MeasurementOptions {
        mappings: arguments.mappings.clone(),
        time: arguments.time.clone(),
        shift: arguments.shift,
    };
    let comparison = compare_results(&arguments.first, &arguments.others, &options)?;
    let page = match (&arguments.output, arguments.json) {
        (Some(page), _) => Some(page.clone()),
        (None, true) => None,
        (None, false) => Some(PAGE.into()),
    };
    if let Some(page) = &page {
        write_page(&comparison, page)?;
    }
    if arguments.json {
        print_json(&comparison)?;
    } else {
        if !arguments.quiet {
            print_tables(&comparison)?;
        }
        print(format_args!("page: {}", page.unwrap_or_default().display()))?;
    }
    let is_exceeded =
        arguments.tolerance.is_some_and(|tolerance| comparison.largest_relative() > tolerance);
    Ok(u8::from(is_exceeded))
}

fn print_tables(comparison: &Comparison) -> Result<()> {
    let first = &comparison.first.name;
    for compared in &comparison.compared {
        let other = &compared.with.name;
        print(format_args!("{other} against {first}"))?;
        for input in &compared.inputs {
            print(format_args!("  {input}"))?;
        }
        print_errors(compared)?;
        print_fields(compared)?;
        for (name, columns) in [(first, &compared.only_in_first), (other, &compared.only_in_other)]
        {
            if columns.len() > 5 {
                print(format_args!("only in {name}: {} columns", columns.len()))?;
            } else if !columns.is_empty() {
                print(format_args!("only in {name}: {}", columns.join("; ")))?;
            }
        }
    }
    Ok(())
}

/// The columns that differ most for their sizes.
fn print_errors(compared: &Compared) -> Result<()> {
    let mut different: Vec<_> = compared.columns.iter().filter(|c| c.max_abs > 0.0).collect();
    different.sort_by(|a, b| b.relative.total_cmp(&a.relative));
    let (all, differ) = (compared.columns.len(), different.len());
    let interpolated = compared.columns.iter().filter(|c| c.times == How::Interpolated).count();
    let times = match interpolated {
        0 => "at the times that both have".to_owned(),
        some if some == all => "the finer one interpolated at the times of the coarser".to_owned(),
        some => format!("{some} of them interpolated at the times of the coarser"),
    };
    print(format_args!("{differ} of {all} columns differ, {times}"))?;
    if different.is_empty() {
        return Ok(());
    }
    let [column, relative, largest, rms, last, line] =
        ["column", "relative", "largest", "RMS", "final", "where and when it is largest"];
    let shown = different.len().min(MOST_LINES);
    let width = different[..shown].iter().map(|c| c.table.len() + c.column.len() + 1).max();
    let width = width.unwrap_or(0).max(column.len());
    print(format_args!(
        "  {column:<width$} {relative:>11} {largest:>11} {rms:>11} {last:>11}  {line}"
    ))?;
    for errors in &different[..shown] {
        let name = format!("{}.{}", errors.table, errors.column);
        let [relative, largest, rms, last] = errors.texts();
        let (signal, at) = (errors.signal(), seconds(errors.at_s));
        print(format_args!(
            "  {name:<width$} {relative:>11} {largest:>11} {rms:>11} {last:>11}  {signal} at {at} s"
        ))?;
    }
    match differ - shown {
        0 => Ok(()),
        more => print(format_args!("  and {more} more, which the page and --json have")),
    }
}

/// The fields of the rails.
fn print_fields(compared: &Compared) -> Result<()> {
    for field in &compared.fields {
        let FieldErrors { field: name, variable, count, .. } = field;
        let [relative, largest, rms] = field.texts();
        let difference = match field.max_abs == 0.0 {
            true => "no difference".to_owned(),
            false => format!("largest {largest} ({relative}) at {}; RMS {rms}", field.position()),
        };
        print(format_args!("{name} {variable}: {difference}, in {count} snapshots"))?;
    }
    compared.fields_not_compared.iter().try_for_each(print)
}
