//! Heat per metre of rail by source, as bars.

use plotters::element::Rectangle;
use plotters::prelude::{ChartBuilder, Color, IntoDrawingArea, SVGBackend, WHITE};
use plotters::series::LineSeries;
use plotters::style::IntoFont;

use super::data::HeatAt;
use super::error::ReportError;
use super::line_chart::{BELOW, FONT, INK, LEFT, MARGIN, WIDTH, titled};
use super::palette;
use super::quantity::{Prefix, tick};

const HEIGHT: u32 = 400;
/// Room for a bar's neighbours: bars of a location take this share of its width.
const FILLED: f64 = 0.8;

/// Draws a group of bars for each location, a bar for each source.
pub(super) fn svg(locations: &[HeatAt]) -> Result<String, ReportError> {
    let mut svg = String::new();
    draw(locations, &mut svg).map_err(|error| ReportError::Drawing {
        figure: "heat by source".to_owned(),
        reason: error.to_string(),
    })?;
    Ok(titled(&svg, "Heat per metre by source"))
}

fn draw<'s>(
    locations: &[HeatAt],
    svg: &'s mut String,
) -> Result<(), Box<dyn std::error::Error + 's>> {
    let values = || locations.iter().flat_map(|location| location.sources.iter().copied());
    let (lowest, highest) = (values().fold(0.0, f64::min), values().fold(0.0, f64::max));
    let prefix = Prefix::of(highest.max(-lowest));
    let room = 0.06 * (highest - lowest).max(f64::MIN_POSITIVE);
    let vertical = (lowest - if lowest < 0.0 { room } else { 0.0 }) / prefix.factor
        ..(highest + room) / prefix.factor;
    let count = locations.len() as f64;

    let area = SVGBackend::with_string(svg, (WIDTH, HEIGHT)).into_drawing_area();
    let mut chart = ChartBuilder::on(&area)
        .margin(MARGIN)
        .x_label_area_size(BELOW)
        .y_label_area_size(LEFT)
        .build_cartesian_2d(0.0..count, vertical.clone())?;
    // The ticks of an axis of numbers lie at whole ones: twice as many as locations, so that every
    // other one lies in the middle of a location and carries its name.
    let name = |x: &f64| {
        let location = locations.get(*x as usize).filter(|_| (x.fract() - 0.5).abs() < 1e-6);
        // "mean of the modelled rail" has no room.
        let words = location.and_then(|location| location.location.split(" of ").next());
        words.unwrap_or_default().to_owned()
    };
    chart
        .configure_mesh()
        .disable_x_mesh()
        .light_line_style(WHITE.mix(0.0))
        .axis_style(INK)
        .label_style(FONT.into_font().color(&INK))
        .y_desc(format!("Heat in {}J/m", prefix.symbol))
        .x_labels(2 * locations.len() + 1)
        .y_labels((HEIGHT / 60) as usize)
        .x_label_formatter(&name)
        .y_label_formatter(&|y| tick(*y, vertical.end - vertical.start))
        .draw()?;
    for (at, location) in locations.iter().enumerate() {
        let width = FILLED / location.sources.len() as f64;
        let begin = at as f64 + 0.5 * (1.0 - FILLED);
        let bars = location.sources.iter().enumerate().map(|(source, heat)| {
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
    fn every_location_is_named_and_negative_heat_has_a_bar() {
        let locations: Vec<HeatAt> = ["chainage 100 m", "chainage 200 m", "mean"]
            .map(|location| HeatAt {
                location: location.to_owned(),
                sources: vec![900.0, -300.0, 10.0, 0.0],
            })
            .into();
        let svg = svg(&locations).unwrap();
        for location in &locations {
            assert!(svg.contains(&location.location), "{} in {svg}", location.location);
        }
        assert_eq!(svg.matches(&palette::html(palette::line(1)).to_uppercase()).count(), 3);
    }
}
