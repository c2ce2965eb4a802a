//! The page, from `templates/report.html`.

use minijinja::Environment;
use minijinja::value::Serde;
use serde::Serialize;

use super::ReportError;
use super::data::{MainFigure, ReportData};
use super::facts::RunFacts;
use super::figures::{self, Figure};
use super::heat_map::{HeatMap, HeatMaps, warm_elements};
use super::line_chart::{LEFT, MARGIN, WIDTH};
use super::palette::{self, HEAT, HeatScale};
use super::quantity::{round_with_unit, seconds, with_unit};

/// Sensitivity of an uncooled thermal camera (paper, section 2), K.
const CAMERA: f64 = 0.015;

/// All that the template shows.
#[derive(Serialize)]
struct Page<'a> {
    facts: &'a RunFacts,
    main_figures: &'a [MainFigure],
    energy: Vec<(&'a str, String)>,
    figures: Vec<Figure>,
    heat: Option<HeatFigure>,
    surface: Option<Figure>,
}

/// The heat maps with their colour bar.
#[derive(Serialize)]
struct HeatFigure {
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
        main_figures: &data.main_figures,
        energy: energy.map(|line| (line.name.as_str(), with_unit(line.joules, "J"))).collect(),
        figures: figures::over_time(data)?,
        heat: None,
        surface: None,
    };
    if let Some(field) = data.field.as_ref().filter(|field| !field.snapshots.is_empty()) {
        let rises = field.snapshots.iter().flat_map(|snapshot| &snapshot.rise);
        let scale = HeatScale::of(rises.copied().fold(0.0, f32::max).into());
        let elements = warm_elements(field, scale);
        page.surface = Some(figures::surface(field, elements.clone())?);
        let locomotives = &data.facts.locomotives;
        let curves = &data.facts.curves_m;
        page.heat = Some(heat_figure(HeatMaps { field, scale, elements, locomotives, curves })?);
    }
    let mut environment = Environment::new();
    environment.add_template("report.html", include_str!("../../templates/report.html"))?;
    let template = environment.get_template("report.html")?;
    Ok(template.render(Serde(&page))?)
}

/// The heat maps, all with one scale of colours and chainages.
fn heat_figure(maps: HeatMaps<'_>) -> Result<HeatFigure, ReportError> {
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
        maps: named.collect::<Result<_, ReportError>>()?,
        stops: HEAT.map(palette::html).to_vec(),
        ticks: scale.ticks().map(tick).collect(),
        camera: (scale.lowest()..scale.highest).contains(&CAMERA).then(|| tick(CAMERA)),
        left,
        right,
        width: WIDTH,
    })
}
