//! Heat per metre of rail by source, as bars.

use plotters::element::Rectangle;
use plotters::prelude::{ChartBuilder, Color, IntoDrawingArea, SVGBackend, WHITE};
use plotters::series::LineSeries;
use plotters::style::IntoFont;

use super::ReportError;
use super::data::HeatAt;
use super::line_chart::{BELOW, FONT, INK, LEFT, MARGIN, WIDTH};
use super::palette;
use super::quantity::{Prefix, tick};

const HEIGHT: u32 = 560;
/// Room for a bar's neighbours: bars of a place take this share of its width.
const FILLED: f64 = 0.8;

/// Draws a group of bars for each place, a bar for each source.
pub(super) fn svg(places: &[HeatAt]) -> Result<String, ReportError> {
    let mut svg = String::new();
    draw(places, &mut svg).map_err(|error| ReportError::Drawing {
        figure: "heat by source".to_owned(),
        reason: error.to_string(),
    })?;
    Ok(svg)
}

fn draw<'s>(places: &[HeatAt], svg: &'s mut String) -> Result<(), Box<dyn std::error::Error + 's>> {
    let values = || places.iter().flat_map(|place| place.sources.iter().copied());
    let (lowest, highest) = (values().fold(0.0, f64::min), values().fold(0.0, f64::max));
    let prefix = Prefix::of(highest.max(-lowest));
    let room = 0.06 * (highest - lowest).max(f64::MIN_POSITIVE);
    let vertical = (lowest - if lowest < 0.0 { room } else { 0.0 }) / prefix.factor
        ..(highest + room) / prefix.factor;
    let count = places.len() as f64;

    let area = SVGBackend::with_string(svg, (WIDTH, HEIGHT)).into_drawing_area();
    area.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(&area)
        .margin(MARGIN)
        .x_label_area_size(BELOW)
        .y_label_area_size(LEFT)
        .build_cartesian_2d(0.0..count, vertical.clone())?;
    // The ticks of an axis of numbers lie at whole ones: twice as many as places, so that every
    // other one lies in the middle of a place and carries its name.
    let name = |x: &f64| {
        let place = places.get(*x as usize).filter(|_| (x.fract() - 0.5).abs() < 1e-6);
        place.map_or_else(String::new, |place| place.place.clone())
    };
    chart
        .configure_mesh()
        .disable_x_mesh()
        .light_line_style(WHITE.mix(0.0))
        .axis_style(INK)
        .label_style(FONT.into_font().color(&INK))
        .y_desc(format!("Heat in {}J/m", prefix.symbol))
        .x_labels(2 * places.len() + 1)
        .y_labels((HEIGHT / 60) as usize)
        .x_label_formatter(&name)
        .y_label_formatter(&|y| tick(*y, vertical.end - vertical.start))
        .draw()?;
    for (at, place) in places.iter().enumerate() {
        let width = FILLED / place.sources.len() as f64;
        let begin = at as f64 + 0.5 * (1.0 - FILLED);
        let bars = place.sources.iter().enumerate().map(|(source, heat)| {
            let left = begin + source as f64 * width;
            let corners = [(left, 0.0), (left + 0.92 * width, heat / prefix.factor)];
            Rectangle::new(corners, palette::line(source).filled())
        });
        chart.draw_series(bars)?;
    }
    chart.draw_series(LineSeries::new([(0.0, 0.0), (count, 0.0)], INK.stroke_width(2)))?;
    area.present()?;
    drop(chart);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_place_is_named_and_negative_heat_has_a_bar() {
        let places: Vec<HeatAt> = ["chainage 100 m", "chainage 200 m", "mean"]
            .map(|place| HeatAt {
                place: place.to_owned(),
                sources: vec![900.0, -300.0, 10.0, 0.0],
            })
            .into();
        let svg = svg(&places).unwrap();
        for place in &places {
            assert!(svg.contains(&place.place), "{} in {svg}", place.place);
        }
        assert_eq!(svg.matches(&palette::html(palette::line(1)).to_uppercase()).count(), 3);
    }
}
