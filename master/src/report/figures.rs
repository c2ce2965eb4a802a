//! The figures with curves: over time for the plotted vehicles, and along the track.

use std::borrow::Cow;
use std::ops::Range;

use serde::Serialize;

use super::data::{Curve, Foot, RailData, RailField, ReportData, VehicleSeries};
use super::error::ReportError;
use super::facts::RailFacts;
use super::heat_by_source;
use super::line_chart::LineChart;
use super::palette;
use super::quantity::seconds;
use super::rail_figures::SOURCES;

/// A figure: panels one below the other.
#[derive(Serialize)]
pub(super) struct Figure {
    pub title: Cow<'static, str>,
    pub caption: Cow<'static, str>,
    pub panels: Vec<Panel>,
}

/// A drawing with its legend.
#[derive(Serialize)]
pub(super) struct Panel {
    pub name: &'static str,
    pub legend: Vec<LegendEntry>,
    pub svg: String,
}

/// What the line of a colour is.
#[derive(Serialize)]
pub(super) struct LegendEntry {
    label: String,
    colour: String,
}

/// The figures over time.
pub(super) fn over_time(data: &ReportData) -> Result<Vec<Figure>, ReportError> {
    let of_vehicles = |title, caption, quantity, unit, pick| {
        vehicle_figure(data, title, caption, quantity, unit, pick)
    };
    let mut figures = vec![
        motion_figure(data)?,
        of_vehicles(
            "Coupler forces",
            "Force in the rear coupler of each vehicle, positive in tension (the paper's figure 8).",
            "Coupler force",
            "N",
            |vehicle| &vehicle.coupler_force,
        )?,
    ];
    if data.facts.train_alone {
        return Ok(figures);
    }
    figures.extend([
        of_vehicles(
            "Longitudinal creep forces",
            "Sum over all wheels of a vehicle, positive in traction (the paper's figure 9).",
            "Creep force",
            "N",
            |vehicle| &vehicle.creep_force,
        )?,
        of_vehicles(
            "Synchronisation forces",
            "Force that keeps each vehicle at its place in the train (the paper's figure 10).",
            "Force",
            "N",
            |vehicle| &vehicle.sync_force,
        )?,
        of_vehicles(
            "Position errors",
            "Position of the vehicle model less that of the train model (the paper's figure 6).",
            "Error",
            "m",
            |vehicle| &vehicle.position_error,
        )?,
    ]);
    Ok(figures)
}

/// Speed and notch over time.
fn motion_figure(data: &ReportData) -> Result<Figure, ReportError> {
    let (speed, notch) = (Curve::plain(data.speed.clone()), Curve::plain(data.notch.clone()));
    let chart = LineChart {
        title: "Speed",
        horizontal: "Time in s",
        abscissa: &data.time,
        quantity: "Speed in m/s",
        unit: "",
        height: 460,
        curves: vec![&speed],
        first_colour: 0,
        steps: false,
    };
    let mut panels = vec![Panel { name: "", legend: vec![], svg: chart.svg()? }];
    if !data.notch.is_empty() {
        let chart = LineChart {
            title: "Notch",
            quantity: "Notch",
            height: 340,
            curves: vec![&notch],
            steps: true,
            ..chart
        };
        panels.push(Panel { name: "", legend: vec![], svg: chart.svg()? });
    }
    Ok(Figure {
        title: "Speed and notch".into(),
        caption: "Speed of the leading vehicle, and notch of the locomotives.".into(),
        panels,
    })
}

/// A quantity of the plotted vehicles over time: locomotives and wagons have a panel each, as
/// their forces differ in size.
fn vehicle_figure(
    data: &ReportData,
    title: &'static str,
    caption: &'static str,
    quantity: &'static str,
    unit: &'static str,
    pick: fn(&VehicleSeries) -> &Curve,
) -> Result<Figure, ReportError> {
    let (locomotives, wagons): (Vec<_>, Vec<_>) =
        data.vehicles.iter().partition(|vehicle| vehicle.locomotive);
    let wagon_colour = locomotives.len();
    let groups = [("Locomotives", locomotives, 0), ("Wagons", wagons, wagon_colour)];
    let mut panels = vec![];
    for (name, vehicles, first_colour) in groups {
        if vehicles.is_empty() {
            continue;
        }
        let chart = LineChart {
            title,
            horizontal: "Time in s",
            abscissa: &data.time,
            quantity,
            unit,
            height: 460,
            curves: vehicles.iter().map(|vehicle| pick(vehicle)).collect(),
            first_colour,
            steps: false,
        };
        let labels = vehicles.iter().map(|vehicle| format!("vehicle {}", vehicle.number));
        panels.push(Panel { name, legend: legend(labels, first_colour), svg: chart.svg()? });
    }
    Ok(Figure { title: title.into(), caption: caption.into(), panels })
}

/// A threshold is drawn where it is less than so many times the highest value: beyond, the curve would be flat.
const NEAR: f64 = 20.0;

/// Rise of the foot over untouched rail: along the track over the whole time, and under the last
/// wheel while the train runs; `None` if no rail's model has it.
pub(super) fn foot(rails: &[RailData], facts: &RailFacts) -> Result<Option<Figure>, ReportError> {
    let feet: Vec<(&str, &Foot)> =
        rails.iter().filter_map(|rail| Some((rail.side.as_str(), rail.foot.as_ref()?))).collect();
    let Some(&(_, first)) = feet.first() else { return Ok(None) };
    let threshold = Curve::plain(vec![facts.detection_threshold_k; first.time.len()]);
    let panel = |name, quantity: &dyn Fn(&Foot) -> Vec<f64>, count: usize, unit: (&str, f64)| {
        let curves: Vec<Curve> =
            feet.iter().map(|(_, foot)| Curve::plain(quantity(foot)[..count].to_vec())).collect();
        let highest = curves.iter().flat_map(|curve| &curve.value).fold(0.0_f64, |a, b| a.max(*b));
        let is_near = facts.detection_threshold_k < NEAR * highest;
        let abscissa: Vec<f64> = first.time[..count].iter().map(|time| time / unit.1).collect();
        let chart = LineChart {
            title: "Rise of the foot",
            horizontal: &format!("Time in {}", unit.0),
            abscissa: &abscissa,
            quantity: "Rise",
            unit: "K",
            height: 460,
            curves: curves.iter().chain(is_near.then_some(&threshold)).collect(),
            first_colour: 0,
            steps: false,
        };
        let labels = feet.iter().map(|(side, _)| format!("{side} rail"));
        let labels = labels.chain(is_near.then(|| "threshold of detection".to_owned()));
        Ok::<_, ReportError>(Panel { name, legend: legend(labels, 0), svg: chart.svg()? })
    };
    let run = first.time.partition_point(|&time| time <= facts.last_train_end_s + 1e-9);
    Ok(Some(Figure {
        title: "Rise of the foot".into(),
        caption: "Rise over rail that no wheel has touched, at the same time. The threshold of detection is drawn \
                  where it is less than twenty times the highest rise. Where nothing but the train acts, what rises \
                  under the last wheel is the hysteresis of bending: friction's heat comes minutes later. Not in it is \
                  the reversible change by bending, which comes and goes with each axle and is several times the \
                  threshold (probe[1].foot.thermoelastic in series/rail)."
            .into(),
        panels: vec![
            panel(
                "Highest along the track",
                &|f| f.highest.clone(),
                first.time.len(),
                ("min", 60.0),
            )?,
            panel("Under the last wheel", &|f| f.under_train.clone(), run, ("s", 1.0))?,
        ],
    }))
}

/// Heat per metre by source, a panel for each rail; `None` if no rail's model has it.
pub(super) fn heat(rails: &[RailData]) -> Result<Option<Figure>, ReportError> {
    let mut panels = vec![];
    for rail in rails.iter().filter(|rail| !rail.heat.is_empty()) {
        let labels = SOURCES.iter().map(|(_, words)| (*words).to_owned());
        let svg = heat_by_source::svg(&rail.heat)?;
        panels.push(Panel { name: panel_name(&rail.side), legend: legend(labels, 0), svg });
    }
    Ok((!panels.is_empty()).then_some(Figure {
        title: "Heat per metre by source".into(),
        caption: "At the end, positive into the rail. The weather acts on the whole rail all the time, with \
                  and without a train."
            .into(),
        panels,
    }))
}

/// Rise on the surface along the track, a line for each time.
pub(super) fn surface(
    side: &str,
    field: &RailField,
    elements: Range<usize>,
) -> Result<Figure, ReportError> {
    let rises = |snapshot| {
        let rises = field.surface(snapshot).skip(elements.start).take(elements.len());
        Curve::plain(rises.map(f64::from).collect())
    };
    let curves: Vec<Curve> = field.snapshots.iter().map(rises).collect();
    let chart = LineChart {
        title: "Surface rise along the track",
        horizontal: "Chainage in m",
        abscissa: &field.chainage[elements.clone()],
        quantity: "Rise",
        unit: "K",
        height: 460,
        curves: curves.iter().collect(),
        first_colour: 0,
        steps: false,
    };
    let labels = field.snapshots.iter().map(|snapshot| format!("at {} s", seconds(snapshot.time)));
    Ok(Figure {
        title: "Surface rise along the track".into(),
        caption: "Rise in the uppermost cell; bands show the range of the elements within a pixel."
            .into(),
        panels: vec![Panel {
            name: panel_name(side),
            legend: legend(labels, 0),
            svg: chart.svg()?,
        }],
    })
}

/// The name of a rail's panel.
fn panel_name(side: &str) -> &'static str {
    if side == "left" { "Left rail" } else { "Right rail" }
}

/// The labels with the colours of their lines.
pub(super) fn legend(
    labels: impl Iterator<Item = String>,
    first_colour: usize,
) -> Vec<LegendEntry> {
    let entry = |(index, label)| LegendEntry {
        label,
        colour: palette::html(palette::line(first_colour + index)),
    };
    labels.enumerate().map(entry).collect()
}
