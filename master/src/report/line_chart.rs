//! Curves over time or chainage, as SVG.
//!
//! Drawings have twice the size at which the page shows them, because the backend places
//! points on whole pixels. They have no background, so that they suit a dark page too.

use std::ops::Range;

use plotters::element::Polygon;
use plotters::prelude::{ChartBuilder, Color, IntoDrawingArea, RGBColor, SVGBackend, WHITE};
use plotters::series::LineSeries;

use super::data::Curve;
use super::error::ReportError;
use super::palette;
use super::quantity::{Prefix, tick};

/// Width of all drawings.
pub(super) const WIDTH: u32 = 900;
/// Room to the left of the axes, for numbers and the name of the axis.
pub(super) const LEFT: u32 = 130;
/// Room below the axes.
pub(super) const BELOW: u32 = 76;
/// Room above and to the right, where half of the last number stands.
pub(super) const MARGIN: u32 = 36;
/// Font of all text; the backend shows it at 1/1.24 of this size.
pub(super) const FONT: (&str, u32) = ("sans-serif", 32);
/// Colour of axes and text.
pub(super) const INK: RGBColor = RGBColor(60, 60, 60);
/// Colour of the grid.
const GRID: RGBColor = RGBColor(225, 225, 225);
/// A curve has no more points than this; more would not show.
const MOST_POINTS: usize = 800;

/// A drawing of one or more curves over the same abscissa.
pub(super) struct LineChart<'a> {
    /// What it shows.
    pub title: &'a str,
    /// Name and unit of the horizontal axis.
    pub horizontal: &'a str,
    /// Where the values lie on the horizontal axis.
    pub abscissa: &'a [f64],
    /// Name of the vertical axis.
    pub quantity: &'a str,
    /// SI unit of the values; the axis gets a prefix. Empty for a plain number.
    pub unit: &'a str,
    /// Height of the drawing.
    pub height: u32,
    /// The curves.
    pub curves: Vec<&'a Curve>,
    /// Number of the first curve's colour.
    pub first_colour: usize,
    /// Whether values hold until the next abscissa, as a notch does.
    pub steps: bool,
}

impl LineChart<'_> {
    /// Draws the chart.
    pub fn svg(&self) -> Result<String, ReportError> {
        let mut svg = String::new();
        self.draw(&mut svg).map_err(|error| ReportError::Drawing {
            figure: self.title.to_owned(),
            reason: error.to_string(),
        })?;
        let lines = (0..self.curves.len()).map(|index| self.first_colour + index);
        Ok(titled(&dashed(svg, lines), self.title))
    }

    fn draw(&self, svg: &mut String) -> Result<(), Box<dyn std::error::Error + '_>> {
        let (lowest, highest) = self.extent();
        let prefix = match self.unit {
            "" => Prefix::of(1.0),
            _ => Prefix::of(highest.abs().max(lowest.abs())),
        };
        let vertical = padded(lowest / prefix.factor, highest / prefix.factor);
        let horizontal = self.horizontal_range();

        let area = SVGBackend::with_string(svg, (WIDTH, self.height)).into_drawing_area();
        let mut chart = ChartBuilder::on(&area)
            .margin(MARGIN)
            .x_label_area_size(BELOW)
            .y_label_area_size(LEFT)
            .build_cartesian_2d(horizontal.clone(), vertical.clone())?;
        let name = match self.unit {
            "" => self.quantity.to_owned(),
            unit => format!("{} in {}{unit}", self.quantity, prefix.symbol),
        };
        chart
            .configure_mesh()
            .light_line_style(WHITE.mix(0.0))
            .bold_line_style(GRID)
            .axis_style(INK)
            .label_style(plotters::style::IntoFont::into_font(FONT).color(&INK))
            .x_desc(self.horizontal)
            .y_desc(name)
            .x_labels(7)
            .y_labels((self.height / 60) as usize)
            .x_label_formatter(&|x| tick(*x, horizontal.end - horizontal.start))
            .y_label_formatter(&|y| tick(*y, vertical.end - vertical.start))
            .draw()?;
        for (index, curve) in self.curves.iter().enumerate() {
            let colour = palette::line(self.first_colour + index);
            let thin = thinned(self.abscissa, curve, prefix.factor);
            let band = thin.iter().map(|point| (point.abscissa, point.highest));
            let back = thin.iter().rev().map(|point| (point.abscissa, point.lowest));
            let outline: Vec<(f64, f64)> = band.chain(back).collect();
            if thin.iter().any(|point| point.highest > point.lowest) {
                chart.draw_series([Polygon::new(outline, colour.mix(0.25).filled())])?;
            }
            let line = self.line(&thin);
            // A line below others is wider, so that it shows where they lie on it.
            let width = 3 + 2 * (self.curves.len() - 1 - index).min(2) as u32;
            chart.draw_series(LineSeries::new(line, colour.stroke_width(width)))?;
        }
        area.present()?;
        drop(chart);
        Ok(())
    }

    /// Lowest and highest of all values.
    fn extent(&self) -> (f64, f64) {
        let values = |pick: fn(&Curve) -> &Vec<f64>| {
            let values = self.curves.iter().flat_map(move |curve| pick(curve));
            values.copied().filter(|value| value.is_finite())
        };
        let lowest = values(|curve| &curve.lowest).fold(f64::INFINITY, f64::min);
        let highest = values(|curve| &curve.highest).fold(f64::NEG_INFINITY, f64::max);
        if lowest <= highest { (lowest, highest) } else { (0.0, 0.0) }
    }

    fn horizontal_range(&self) -> Range<f64> {
        match (self.abscissa.first(), self.abscissa.last()) {
            (Some(&first), Some(&last)) if first < last => first..last,
            (Some(&first), _) => first..first + 1.0,
            _ => 0.0..1.0,
        }
    }

    /// The points of the line, with the corners of its steps where it has some.
    fn line(&self, thin: &[Point]) -> Vec<(f64, f64)> {
        let mut line: Vec<(f64, f64)> = vec![];
        for point in thin {
            if let (true, Some(&(_, before))) = (self.steps, line.last()) {
                line.push((point.abscissa, before));
            }
            line.push((point.abscissa, point.value));
        }
        line
    }
}

/// The drawing with a title that screen readers say.
pub(super) fn titled(svg: &str, title: &str) -> String {
    let title = title.replace('&', "&amp;").replace('<', "&lt;");
    svg.replacen("<svg ", "<svg role=\"img\" ", 1).replacen(
        '>',
        &format!("><title>{title}</title>"),
        1,
    )
}

/// The drawing with the patterns of these lines, which the backend cannot draw: they are those of their
/// colours.
fn dashed(mut svg: String, lines: impl Iterator<Item = usize>) -> String {
    for index in lines.filter(|&index| !palette::dashes(index).is_empty()) {
        let stroke = format!("stroke=\"{}\"", palette::html(palette::line(index)).to_uppercase());
        let pattern = palette::dashes(index);
        svg = svg.replace(&stroke, &format!("{stroke} stroke-dasharray=\"{pattern}\""));
    }
    svg
}

/// A point of a thinned curve.
struct Point {
    abscissa: f64,
    value: f64,
    lowest: f64,
    highest: f64,
}

/// A curve with so few points that all of them show: the extremes hold what lies between them.
/// Points that are not numbers are left out.
fn thinned(abscissa: &[f64], curve: &Curve, factor: f64) -> Vec<Point> {
    let size = abscissa.len().div_ceil(MOST_POINTS).max(1);
    let count = abscissa.len().min(curve.value.len());
    let bins = (0..count).step_by(size);
    bins.map(|begin| {
        let bin = begin..(begin + size).min(count);
        let lowest = curve.lowest[bin.clone()].iter().copied().fold(f64::NAN, f64::min);
        let highest = curve.highest[bin.clone()].iter().copied().fold(f64::NAN, f64::max);
        Point {
            abscissa: abscissa[bin.end - 1],
            value: curve.value[bin.end - 1] / factor,
            lowest: lowest / factor,
            highest: highest / factor,
        }
    })
    .filter(|point| point.value.is_finite())
    .collect()
}

/// The range of an axis: a little more than that of its values, and never empty.
fn padded(lowest: f64, highest: f64) -> Range<f64> {
    let span = highest - lowest;
    let least = 1e-3 * highest.abs().max(lowest.abs());
    let room = match span > least {
        true => 0.06 * span,
        false => least.max(0.5),
    };
    lowest - room..highest + room
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn property_thinning_keeps_the_extremes() {
        let abscissa: Vec<f64> = (0..100_000).map(f64::from).collect();
        let mut value = vec![0.0; abscissa.len()];
        (value[777], value[54_321]) = (5.0, -7.0);
        let thin = thinned(&abscissa, &Curve::plain(value), 1.0);
        assert!(thin.len() <= MOST_POINTS);
        assert_eq!(thin.iter().map(|point| point.highest).fold(0.0, f64::max), 5.0);
        assert_eq!(thin.iter().map(|point| point.lowest).fold(0.0, f64::min), -7.0);
        assert_eq!(thin.last().unwrap().abscissa, 99_999.0);
    }

    #[test]
    fn a_constant_gets_an_axis_with_room() {
        assert_eq!(padded(5.0, 5.0), 4.5..5.5);
        assert_eq!(padded(0.0, 0.0), -0.5..0.5);
    }
}
