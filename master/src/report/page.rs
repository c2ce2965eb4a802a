//! The page of a train's run, from `templates/report.html`.

use minijinja::Environment;
use minijinja::value::Serde;
use serde::Serialize;

use super::data::{MainFigure, RailData, ReportData};
use super::error::ReportError;
use super::facts::{RailFacts, RunFacts};
use super::figures::{self, Figure};
use super::heat_map::{HeatMap, HeatMaps, warm_elements};
use super::line_chart::{LEFT, MARGIN, WIDTH};
use super::palette::{self, HEAT, HeatScale};
use super::quantity::{round_with_unit, seconds, with_unit};

/// Sensitivity of an uncooled thermal camera (paper, section 2), K.
const CAMERA: f64 = 0.015;

/// Pages and what they are made of.
const TEMPLATES: [(&str, &str); 4] = [
    ("page.html", include_str!("../../templates/page.html")),
    ("figure.html", include_str!("../../templates/figure.html")),
    ("report.html", include_str!("../../templates/report.html")),
    ("system.html", include_str!("../../templates/system.html")),
];

/// All that the template shows.
#[derive(Serialize)]
struct Page<'a> {
    facts: &'a RunFacts,
    caution: Option<&'static str>,
    main_figures: &'a [MainFigure],
    energy: Vec<(&'a str, String)>,
    figures: Vec<Figure>,
    rail_tables: Vec<RailTable<'a>>,
    rail_figures: Vec<Figure>,
    heat: Vec<HeatFigure>,
    surfaces: Vec<Figure>,
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

/// The heat maps with their colour bar.
#[derive(Serialize)]
struct HeatFigure {
    rail: String,
    maps: Vec<NamedMap>,
    stops: Vec<String>,
    ticks: Vec<Tick>,
    camera: Option<Tick>,
    left: u32,
    right: u32,
    width: u32,
}

#[derive(Serialize)]
struct NamedMap {
    name: String,
    map: HeatMap,
}

#[derive(Serialize)]
struct Tick {
    x: f64,
    label: String,
}

/// Makes the page.
///
/// # Errors
/// When a figure cannot be drawn or the template has an error.
pub fn render(data: &ReportData) -> Result<String, ReportError> {
    let energy = data.energy.iter();
    let mut page = Page {
        facts: &data.facts,
        caution: data.facts.rails.as_ref().and_then(RailFacts::caution),
        main_figures: &data.main_figures,
        energy: energy.map(|line| (line.name.as_str(), with_unit(line.joules, "J"))).collect(),
        figures: figures::over_time(data)?,
        rail_tables: rail_tables(&data.rails),
        rail_figures: vec![],
        heat: vec![],
        surfaces: vec![],
    };
    if let Some(facts) = &data.facts.rails {
        page.rail_figures.extend(figures::foot(&data.rails, facts)?);
        page.rail_figures.extend(figures::heat(&data.rails)?);
    }
    let scale = HeatScale::of(data.highest_of_fields());
    for rail in &data.rails {
        let Some(field) = rail.field.as_ref().filter(|f| !f.snapshots.is_empty()) else { continue };
        let elements = warm_elements(field, scale);
        page.surfaces.push(figures::surface(&rail.side, field, elements.clone())?);
        let locomotives = &data.facts.locomotives;
        let curves = &data.facts.curves_m;
        let maps = HeatMaps { field, scale, elements, locomotives, curves };
        page.heat.push(heat_figure(&rail.side, maps)?);
    }
    fill("report.html", &page)
}

/// Fills the template of this name.
pub(super) fn fill(template: &str, page: &impl Serialize) -> Result<String, ReportError> {
    let mut environment = Environment::new();
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

/// The heat maps, all with one scale of colours and chainages.
fn heat_figure(side: &str, maps: HeatMaps<'_>) -> Result<HeatFigure, ReportError> {
    let HeatMaps { field, scale, .. } = maps;
    let named = field.snapshots.iter().map(|snapshot| {
        Ok(NamedMap { name: format!("At {} s", seconds(snapshot.time)), map: maps.draw(snapshot)? })
    });
    let (left, right) = (LEFT + MARGIN, WIDTH - MARGIN);
    let tick = |rise: f64| Tick {
        x: f64::from(left) + scale.share(rise) * f64::from(right - left),
        label: round_with_unit(rise, "K"),
    };
    Ok(HeatFigure {
        rail: side.to_owned(),
        maps: named.collect::<Result<_, ReportError>>()?,
        stops: HEAT.map(palette::html).to_vec(),
        ticks: scale.ticks().map(tick).collect(),
        camera: (scale.lowest()..scale.highest).contains(&CAMERA).then(|| tick(CAMERA)),
        left,
        right,
        width: WIDTH,
    })
}
