//! The report of a system's run, of which nothing is known but the variables of its components: what
//! was run, where the wall time went, and curves of what changed.

use std::path::Path;

use serde::{Deserialize, Serialize};

use super::data::Curve;
use super::error::ReportError;
use super::figures::{Figure, Panel, legend};
use super::line_chart::LineChart;
use super::page::fill;
use super::palette::LINES;
use super::provenance::Provenance;
use super::quantity::with_unit;
use super::wall_times::{WallTimes, wall_times};
use crate::recording::{RecordingError, SeriesReader, TIME};

/// What the run of a system writes as the table `system` of `manifest.toml`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SystemFacts {
    /// Name of the system.
    pub name: String,
    /// File of the package.
    pub package: String,
    /// Simulated time reached, s; 0 while the run has not ended.
    pub simulated_s: f64,
    /// Step of the exchange, s.
    pub step_s: f64,
    /// Number of threads.
    pub threads: usize,
    /// Wall time of the stepping, s; left out by a run that was killed.
    pub wall_time_s: Option<f64>,
    /// Wall time of the recording in it, s.
    pub recording_s: f64,
    /// Its components.
    pub component: Vec<ComponentFacts>,
}

/// What the run knows of a component.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ComponentFacts {
    /// Its name.
    pub name: String,
    /// Name of its FMU's file.
    pub fmu: String,
    /// Name of the table of its outputs; `None` if it has no numeric outputs.
    pub series: Option<String>,
    /// Wall time of its steps, s.
    pub wall_time_s: f64,
}

/// Drawings on a page; more would make it slow to open.
const MOST_PANELS: usize = 40;

/// Units whose numbers are shown with prefixes, such as kN.
const PREFIXED: [&str; 6] = ["N", "W", "J", "Pa", "m", "K"];

/// All that the template shows.
#[derive(Serialize)]
struct Page<'f> {
    facts: &'f SystemFacts,
    wall_time: String,
    recording: String,
    wall_times: WallTimes<'f>,
    provenance: &'f Provenance,
    figures: Vec<Figure>,
    /// Number of quantities that no figure shows.
    left_out: usize,
}

/// Makes the page for the results in `folder`.
pub(super) fn render(
    facts: &SystemFacts,
    provenance: &Provenance,
    folder: &Path,
) -> Result<String, ReportError> {
    let mut figures = vec![];
    let (mut panels, mut shown, mut quantities) = (0, 0, 0);
    for component in &facts.component {
        let Some(table) = &component.series else { continue };
        let series = SeriesReader::open(&folder.join("series"), table)?;
        quantities += outputs(&series).count();
        let figure = figure(component, &series, MOST_PANELS - panels)?;
        panels += figure.panels.len();
        shown += figure.panels.iter().map(|panel| panel.legend.len()).sum::<usize>();
        if !figure.panels.is_empty() {
            figures.push(figure);
        }
    }
    fill(
        "system.html",
        &Page {
            facts,
            wall_time: with_unit(facts.wall_time_s.unwrap_or(0.0), "s"),
            recording: with_unit(facts.recording_s, "s"),
            wall_times: wall_times(provenance),
            provenance,
            figures,
            left_out: quantities - shown,
        },
    )
}

/// The outputs of a component that changed, a drawing for each unit, with as many lines as there are
/// colours; at most so many drawings.
fn figure(
    component: &ComponentFacts,
    series: &SeriesReader,
    most_panels: usize,
) -> Result<Figure, ReportError> {
    let time = series.read(TIME, &[])?;
    let mut panels = vec![];
    for unit in units(series) {
        if panels.len() == most_panels {
            break;
        }
        let (names, curves) = changing(series, unit)?;
        if names.is_empty() {
            continue;
        }
        let (quantity, unit) = match unit {
            "1" => ("Number".to_owned(), ""),
            unit if PREFIXED.contains(&unit) => ("Value".to_owned(), unit),
            unit => (format!("Value in {unit}"), ""),
        };
        let chart = LineChart {
            title: &component.name,
            horizontal: "Time in s",
            abscissa: &time,
            quantity: &quantity,
            unit,
            height: 460,
            curves: curves.iter().collect(),
            first_colour: 0,
            steps: false,
        };
        let svg = chart.svg()?;
        panels.push(Panel { name: "".into(), legend: legend(names.into_iter(), 0), svg });
    }
    let caption = format!("Outputs of {} that changed.", component.fmu);
    Ok(Figure { title: component.name.clone().into(), caption: caption.into(), panels })
}

/// Name and unit of each output.
fn outputs(series: &SeriesReader) -> impl Iterator<Item = (&str, &str)> {
    // The first column is the time.
    series.columns().skip(1).map(|column| {
        let unit = column.metadata().get("unit").map_or("1", String::as_str);
        (column.name().as_str(), unit)
    })
}

/// The units of the outputs, each once.
fn units(series: &SeriesReader) -> Vec<&str> {
    let mut units = vec![];
    for (_, unit) in outputs(series) {
        if !units.contains(&unit) {
            units.push(unit);
        }
    }
    units
}

/// The first outputs in a unit that changed.
fn changing(
    series: &SeriesReader,
    unit: &str,
) -> Result<(Vec<String>, Vec<Curve>), RecordingError> {
    let (mut names, mut curves) = (vec![], vec![]);
    for (name, _) in outputs(series).filter(|(_, other)| *other == unit) {
        if names.len() == LINES.len() {
            break;
        }
        let values = series.read(name, &[])?;
        if values.windows(2).any(|pair| pair[0] != pair[1]) {
            names.push(name.to_owned());
            curves.push(Curve::plain(values));
        }
    }
    Ok((names, curves))
}
