//! The page of a comparison, from `templates/compare.html`.

use std::path::Path;

use numerics::seconds;
use serde::Serialize;

use super::about::About;
use super::along::AlongRail;
use super::comparison::Comparison;
use super::curves::Curve;
use super::error::CompareError;
use super::errors::ColumnErrors;
use super::field_errors::FieldErrors;
use super::grid::How;
use super::inputs::InputDifference;
use super::texts::{percent, shown};
use crate::files::file_error::write_whole;
use crate::report::error::ReportError;
use crate::report::page::fill;
use crate::report::script;

/// All that the template shows.
#[derive(Serialize)]
struct Page<'a> {
    first: &'a About,
    others: Vec<Other<'a>>,
    /// The first and the others.
    all: Vec<&'a About>,
    /// Number of columns that have no curve.
    without_curve: usize,
    numbers: String,
    script: String,
    library: &'static str,
    library_style: &'static str,
}

/// One of the others.
#[derive(Serialize)]
struct Other<'a> {
    about: &'a About,
    sentence: String,
    inputs: &'a [InputDifference],
    /// Those that differ, the largest relative difference first.
    columns: Vec<Line<'a>>,
    /// The others.
    same: Vec<String>,
    fields: Vec<FieldLine<'a>>,
    fields_not_compared: &'a [String],
    only_in_first: &'a [String],
    only_in_other: &'a [String],
}

/// A line of the table of errors.
#[derive(Serialize)]
struct Line<'a> {
    table: &'a str,
    column: &'a str,
    signal: String,
    at: String,
    max_abs: String,
    rms: String,
    last: String,
    relative: String,
    times: String,
}

/// A line of the table of fields.
#[derive(Serialize)]
struct FieldLine<'a> {
    field: &'a str,
    variable: &'a str,
    max_abs: String,
    rms: String,
    relative: String,
    position: String,
    snapshots: usize,
}

/// The numbers of the curves.
#[derive(Serialize)]
struct Numbers<'a> {
    names: Vec<&'a str>,
    curves: &'a [Curve],
    along: &'a [AlongRail],
}

/// Writes the page with the curves.
///
/// # Errors
/// When it cannot be written.
pub fn write_page(comparison: &Comparison, file: &Path) -> Result<(), CompareError> {
    Ok(write_whole(file, &render(comparison)?)?)
}

/// Makes the page.
///
/// # Errors
/// When the template has an error.
fn render(comparison: &Comparison) -> Result<String, ReportError> {
    let Comparison { first, compared, curves, along } = comparison;
    let others = compared.iter().map(|compared| Other {
        about: &compared.with,
        sentence: sentence(&compared.columns),
        inputs: &compared.inputs,
        columns: different(&compared.columns),
        same: same(&compared.columns),
        fields: compared.fields.iter().map(field_line).collect(),
        fields_not_compared: &compared.fields_not_compared,
        only_in_first: &compared.only_in_first,
        only_in_other: &compared.only_in_other,
    });
    let all: Vec<&About> = [first].into_iter().chain(compared.iter().map(|c| &c.with)).collect();
    let names = all.iter().map(|about| about.name.as_str()).collect();
    let numbers = Numbers { names, curves, along };
    let numbers = serde_json::to_string(&numbers).expect("numbers and texts are JSON");
    let columns = compared.iter().map(|compared| compared.columns.len()).max().unwrap_or(0);
    fill(
        "compare.html",
        &Page {
            first,
            others: others.collect(),
            all,
            without_curve: columns.saturating_sub(curves.len()),
            numbers: numbers.replace('<', "\\u003c"),
            script: script::comparison(),
            library: script::UPLOT,
            library_style: script::UPLOT_STYLE,
        },
    )
}

/// The columns that differ, those most that do so most.
fn different(columns: &[ColumnErrors]) -> Vec<Line<'_>> {
    let mut different: Vec<_> = columns.iter().filter(|column| column.max_abs > 0.0).collect();
    different.sort_by(|a, b| b.relative.total_cmp(&a.relative));
    different.into_iter().map(line).collect()
}

fn same(columns: &[ColumnErrors]) -> Vec<String> {
    let same = columns.iter().filter(|column| column.max_abs == 0.0);
    same.map(|column| format!("{}.{}", column.table, column.column)).collect()
}

/// What the errors come to.
fn sentence(columns: &[ColumnErrors]) -> String {
    let different = columns.iter().filter(|column| column.max_abs > 0.0).count();
    let worst = columns.iter().max_by(|a, b| a.relative.total_cmp(&b.relative));
    let of = columns.len();
    match worst.filter(|worst| worst.max_abs > 0.0) {
        None => format!("All {of} columns are the same."),
        Some(worst) => format!(
            "{different} of {of} columns differ, most for its size {}: by {} at {} s ({}).",
            worst.signal(),
            shown(worst.max_abs, &worst.unit),
            seconds(worst.at_s),
            percent(worst.relative)
        ),
    }
}

fn line(column: &ColumnErrors) -> Line<'_> {
    let times = match column.times {
        How::Shared => format!("{} shared", column.count),
        How::Interpolated => format!("{} interpolated", column.count),
    };
    let [relative, max_abs, rms, last] = column.texts();
    Line {
        table: &column.table,
        column: &column.column,
        signal: column.signal(),
        at: format!("{} s", seconds(column.at_s)),
        max_abs,
        rms,
        last,
        relative,
        times,
    }
}

fn field_line(field: &FieldErrors) -> FieldLine<'_> {
    let [relative, max_abs, rms] = field.texts();
    FieldLine {
        field: &field.field,
        variable: field.variable,
        max_abs,
        rms,
        relative,
        position: field.position(),
        snapshots: field.count,
    }
}
