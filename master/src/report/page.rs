//! The page of a train's run, from `templates/report.html`.

use minijinja::Environment;
use minijinja::value::Serde;
use numerics::seconds;
use serde::Serialize;

use super::collect::ReportData;
use super::data::{MainFigure, RailData};
use super::error::ReportError;
use super::facts::{RailFacts, RunFacts};
use super::figures::{self, Panel};
use super::limits::{self, Judged};
use super::provenance::Provenance;
use super::quantity::{with_minus, with_unit};
use super::script;
use super::verdict::{Verdict, verdict};
use super::wall_times::{WallTimes, wall_times};

/// Pages and what they are made of.
const TEMPLATES: [(&str, &str); 7] = [
    ("page.html", include_str!("../../templates/page.html")),
    ("style.css", include_str!("../../templates/style.css")),
    ("compare.html", include_str!("../../templates/compare.html")),
    ("figure.html", include_str!("../../templates/figure.html")),
    ("provenance.html", include_str!("../../templates/provenance.html")),
    ("report.html", include_str!("../../templates/report.html")),
    ("system.html", include_str!("../../templates/system.html")),
];

/// All that the template shows.
#[derive(Serialize)]
struct Page<'a> {
    facts: &'a RunFacts,
    caution: Option<&'static str>,
    verdict: Verdict,
    limits: Vec<Judged>,
    pictures: Vec<Panel>,
    main_figures: &'a [MainFigure],
    energy: Vec<(&'a str, String)>,
    rail_tables: Vec<RailTable<'a>>,
    sections_elsewhere: &'a [String],
    wall_times: WallTimes<'a>,
    provenance: &'a Provenance,
    numbers: String,
    script: String,
    library: &'static str,
    library_style: &'static str,
}

/// A table with a column for each rail.
#[derive(Serialize)]
struct RailTable<'a> {
    title: &'a str,
    caption: &'a str,
    rows: Vec<(&'a str, Vec<Cell<'a>>)>,
}

/// A value with its location.
#[derive(Serialize)]
struct Cell<'a> {
    value: String,
    location: &'a str,
}

/// Makes the page.
///
/// # Errors
/// When a figure cannot be drawn or the template has an error.
pub fn render(data: &ReportData) -> Result<String, ReportError> {
    let energy = data.energy.iter();
    let limits = limits::judged(data);
    fill(
        "report.html",
        &Page {
            facts: &data.facts,
            caution: data.facts.rails.as_ref().and_then(RailFacts::caution),
            verdict: verdict(data, &limits),
            limits,
            pictures: figures::pictures(data)?,
            main_figures: &data.main_figures,
            energy: energy.map(|line| (line.name.as_str(), with_unit(line.joules, "J"))).collect(),
            rail_tables: rail_tables(&data.rails),
            sections_elsewhere: &data.instrument.sections_elsewhere,
            wall_times: wall_times(&data.provenance),
            provenance: &data.provenance,
            numbers: data.instrument.json(),
            script: script::instrument(),
            library: script::UPLOT,
            library_style: script::UPLOT_STYLE,
        },
    )
}

/// Fills the template of this name.
pub(super) fn fill(template: &str, page: &impl Serialize) -> Result<String, ReportError> {
    let mut environment = Environment::new();
    environment.add_filter("seconds", |time: f64| seconds(time).to_string());
    environment.add_filter("minus", |text: &str| with_minus(text));
    for (name, text) in TEMPLATES {
        environment.add_template(name, text)?;
    }
    Ok(environment.get_template(template)?.render(Serde(page))?)
}

/// The tables with what the run says of each rail: all rails have the same lines.
fn rail_tables(rails: &[RailData]) -> Vec<RailTable<'_>> {
    let Some(first) = rails.first() else { return vec![] };
    let figure = |row: usize| {
        let figures = rails.iter().map(|rail| &rail.figures[row]);
        let cells =
            figures.map(|figure| Cell { value: figure.text.clone(), location: &figure.location });
        (first.figures[row].name.as_str(), cells.collect())
    };
    let energy = |row: usize| {
        let energies = rails.iter().map(|rail| rail.energy[row].joules);
        let cells = energies.map(|energy| Cell { value: with_unit(energy, "J"), location: "" });
        (first.energy[row].name.as_str(), cells.collect())
    };
    vec![
        RailTable {
            title: "Temperature of the rail",
            caption: "Rises are above the initial state where nothing else is said.",
            rows: (0..first.figures.len()).map(figure).collect(),
        },
        RailTable {
            title: "Energy audit of the rail",
            caption: "At the end, for the whole modelled rail.",
            rows: (0..first.energy.len()).map(energy).collect(),
        },
    ]
}
