//! The pictures of the first screen, without JavaScript: what warms, by which source, and the train.

use std::borrow::Cow;

use numerics::constants::KILOMETRES_PER_HOUR;
use serde::Serialize;

use super::collect::ReportData;
use super::data::{Curve, Foot, RailData};
use super::error::ReportError;
use super::facts::RailFacts;
use super::heat_by_source;
use super::line_chart::LineChart;
use super::palette;
use super::rail_figures::SOURCES;

/// A figure: panels beside each other.
#[derive(Serialize)]
pub(super) struct Figure {
    pub title: Cow<'static, str>,
    pub caption: Cow<'static, str>,
    pub panels: Vec<Panel>,
}

/// A drawing with its legend.
#[derive(Serialize)]
pub(super) struct Panel {
    pub name: Cow<'static, str>,
    pub legend: Vec<LegendEntry>,
    pub svg: String,
}

/// What the line of a colour is.
#[derive(Serialize)]
pub(super) struct LegendEntry {
    label: String,
    colour: String,
    dashes: &'static str,
}

/// Height of the drawings.
const HEIGHT: u32 = 400;

/// A threshold is drawn where it is less than so many times the highest value: beyond, the curve would be flat.
const NEAR: f64 = 20.0;

/// All pictures of a run.
pub(super) fn pictures(data: &ReportData) -> Result<Vec<Panel>, ReportError> {
    let mut panels = vec![];
    if let Some(facts) = &data.facts.rails {
        let foot = foot(&data.rails, facts)?;
        if foot.is_empty() {
            panels.extend(surface(&data.rails)?);
        }
        panels.extend(foot);
        panels.extend(heat(&data.rails)?);
    }
    panels.push(speed(data)?);
    if data.facts.vehicles > 1 {
        panels.push(coupler_forces(data)?);
    }
    Ok(panels)
}

/// Speed of the leading vehicle, beside that of a logger.
fn speed(data: &ReportData) -> Result<Panel, ReportError> {
    let in_kmh = |speeds: &[f64]| {
        Curve::plain(speeds.iter().map(|speed| speed * KILOMETRES_PER_HOUR).collect())
    };
    let curves = [in_kmh(&data.speed), in_kmh(&data.measured_speed)];
    let shown = if data.measured_speed.is_empty() { 1 } else { 2 };
    let labels = ["simulated", "measured"].map(str::to_owned);
    let chart = LineChart {
        quantity: "Speed in km/h",
        curves: curves.iter().take(shown).collect(),
        ..chart("Speed of the leading vehicle", "Time in s", &data.time)
    };
    panel(chart, labels.into_iter().take(shown))
}

/// Lowest and highest force in any coupler.
fn coupler_forces(data: &ReportData) -> Result<Panel, ReportError> {
    let curves = [&data.highest_coupler_force, &data.lowest_coupler_force]
        .map(|force| Curve::plain(force.clone()));
    let chart = LineChart {
        quantity: "Force",
        unit: "N",
        curves: curves.iter().collect(),
        ..chart("Coupler forces of the whole train", "Time in s", &data.time)
    };
    let labels = ["highest (tension positive)", "lowest"].map(str::to_owned);
    panel(chart, labels.into_iter())
}

/// Rise of the foot over untouched rail: along the track over the whole time, and under the last
/// wheel while the train runs; none if no rail's model has it.
fn foot(rails: &[RailData], facts: &RailFacts) -> Result<Vec<Panel>, ReportError> {
    let feet: Vec<(&str, &Foot)> =
        rails.iter().filter_map(|rail| Some((rail.side.as_str(), rail.foot.as_ref()?))).collect();
    let Some(&(_, first)) = feet.first() else { return Ok(vec![]) };
    let threshold = Curve::plain(vec![facts.detection_threshold_k; first.time.len()]);
    let drawn = |title, quantity: fn(&Foot) -> &Vec<f64>, count: usize, unit: (&str, f64)| {
        let curves: Vec<Curve> =
            feet.iter().map(|(_, foot)| Curve::plain(quantity(foot)[..count].to_vec())).collect();
        let highest = curves.iter().flat_map(|curve| &curve.value).fold(0.0_f64, |a, b| a.max(*b));
        let is_near = facts.detection_threshold_k < NEAR * highest;
        let abscissa: Vec<f64> = first.time[..count].iter().map(|time| time / unit.1).collect();
        let chart = LineChart {
            quantity: "Rise",
            unit: "K",
            curves: curves.iter().chain(is_near.then_some(&threshold)).collect(),
            ..chart(title, unit.0, &abscissa)
        };
        let labels = feet.iter().map(|(side, _)| format!("{side} rail"));
        panel(chart, labels.chain(is_near.then(|| "threshold of detection".to_owned())))
    };
    let run = first.time.partition_point(|&time| time <= facts.last_train_end_s + 1e-9);
    let all = first.time.len();
    Ok(vec![
        drawn(
            "Rise of the foot: highest along the track",
            |f| &f.highest,
            all,
            ("Time in min", 60.0),
        )?,
        drawn(
            "Rise of the foot: under the last wheel",
            |f| &f.under_train,
            run,
            ("Time in s", 1.0),
        )?,
    ])
}

/// Highest rise of the surface along the track; none if no rail's model has it.
fn surface(rails: &[RailData]) -> Result<Option<Panel>, ReportError> {
    let rails: Vec<_> = rails.iter().filter(|rail| !rail.surface.is_empty()).collect();
    let Some(first) = rails.first() else { return Ok(None) };
    let abscissa: Vec<f64> = first.surface.iter().map(|(time, _)| *time).collect();
    let curve =
        |rail: &&RailData| Curve::plain(rail.surface.iter().map(|(_, rise)| *rise).collect());
    let curves: Vec<Curve> = rails.iter().map(curve).collect();
    let chart = LineChart {
        quantity: "Rise",
        unit: "K",
        curves: curves.iter().collect(),
        ..chart("Rise of the surface: highest along the track", "Time in s", &abscissa)
    };
    panel(chart, rails.iter().map(|rail| format!("{} rail", rail.side))).map(Some)
}

/// Heat per metre by source, a panel for each rail; none if no rail's model has it.
fn heat(rails: &[RailData]) -> Result<Vec<Panel>, ReportError> {
    let panel = |rail: &RailData| {
        let labels = SOURCES.iter().map(|(_, words)| (*words).to_owned());
        Ok(Panel {
            name: format!("Heat per metre by source, {} rail", rail.side).into(),
            // Bars have no patterns.
            legend: legend(labels, 0)
                .into_iter()
                .map(|e| LegendEntry { dashes: "solid", ..e })
                .collect(),
            svg: heat_by_source::svg(&rail.heat)?,
        })
    };
    rails.iter().filter(|rail| !rail.heat.is_empty()).map(panel).collect()
}

/// A chart without curves.
fn chart<'a>(title: &'a str, horizontal: &'a str, abscissa: &'a [f64]) -> LineChart<'a> {
    LineChart {
        title,
        horizontal,
        abscissa,
        quantity: "",
        unit: "",
        height: HEIGHT,
        curves: vec![],
        first_colour: 0,
        steps: false,
    }
}

/// A chart under its title, with what its lines are.
fn panel(chart: LineChart<'_>, labels: impl Iterator<Item = String>) -> Result<Panel, ReportError> {
    let name = chart.title.to_owned().into();
    Ok(Panel { name, legend: legend(labels, 0), svg: chart.svg()? })
}

/// The labels with the colours and patterns of their lines.
pub(super) fn legend(
    labels: impl Iterator<Item = String>,
    first_colour: usize,
) -> Vec<LegendEntry> {
    let entry = |(index, label)| LegendEntry {
        label,
        colour: palette::html(palette::line(first_colour + index)),
        dashes: ["solid", "dashed", "dotted"][(first_colour + index) % 3],
    };
    labels.enumerate().map(entry).collect()
}
