//! Panels of curves on one page, as SVG.
//!
//! Drawings have twice the size at which a page shows them, because the backend places points on whole
//! pixels. Values have the units of the comma-separated values.

use std::error::Error;
use std::ops::Range;
use std::path::Path;

use plotters::coord::Shift;
use plotters::prelude::{
    ChartBuilder, Circle, Color, DrawingArea, IntoDrawingArea, RGBColor, SVGBackend, Text, WHITE,
};
use plotters::series::LineSeries;
use plotters::style::{IntoFont, TextStyle};

use crate::error::{ToolError, ensure};

/// Width of the page.
const WIDTH: u32 = 1800;
/// Height of a row of panels.
const PANEL_HEIGHT: u32 = 520;
/// Height of the title and of the legend.
const HEAD: u32 = 60;
/// Panels beside each other.
const COLUMNS: usize = 2;
/// Room to the left of the axes, for numbers and the name of the axis.
const LEFT: u32 = 150;
/// Room below the axes.
const BELOW: u32 = 80;
/// Room around each panel.
const MARGIN: u32 = 24;
/// Font of the axes.
const FONT: (&str, u32) = ("sans-serif", 28);
/// Font of the title.
const TITLE: (&str, u32) = ("sans-serif", 36);
/// Radius of a dot.
const DOT: i32 = 6;
/// Colour of axes and text.
const INK: RGBColor = RGBColor(60, 60, 60);
/// Colour of the grid.
const GRID: RGBColor = RGBColor(225, 225, 225);

/// Colours that colour-blind readers can tell apart (Okabe and Ito 2008).
pub(crate) const BLUE: RGBColor = RGBColor(0, 114, 178);
/// See [`BLUE`].
pub(crate) const SKY: RGBColor = RGBColor(86, 180, 233);
/// See [`BLUE`].
pub(crate) const VERMILION: RGBColor = RGBColor(213, 94, 0);
/// See [`BLUE`].
pub(crate) const ORANGE: RGBColor = RGBColor(230, 159, 0);
/// See [`BLUE`].
pub(crate) const BLACK: RGBColor = RGBColor(0, 0, 0);

/// Points of one kind in a panel; those that are not numbers are left out.
pub(crate) struct Curve {
    /// Its colour.
    pub colour: RGBColor,
    /// Whether a line joins the points, which then are not marked.
    pub joined: bool,
    /// Horizontal and vertical value of each point.
    pub points: Vec<(f64, f64)>,
}

/// Curves over the same axis.
pub(crate) struct Panel {
    /// Name and unit of the horizontal axis.
    pub horizontal: String,
    /// Name and unit of the vertical axis.
    pub vertical: &'static str,
    /// What it shows.
    pub curves: Vec<Curve>,
}

/// A page.
pub(crate) struct Page {
    /// What it is about.
    pub title: String,
    /// What the colours mean.
    pub legend: Vec<(RGBColor, &'static str)>,
    /// Its panels, row by row.
    pub panels: Vec<Panel>,
}

impl Page {
    /// Draws the page into `file` and gives its name as the line that is printed.
    ///
    /// # Errors
    /// When the file is no SVG file by its name or cannot be written.
    pub fn write(&self, file: &Path) -> Result<String, ToolError> {
        let name = file.display().to_string();
        let is_svg = file.extension().is_some_and(|extension| extension == "svg");
        ensure(is_svg, format!("--plot {name}: the name must end in .svg"))?;
        let mut svg = String::new();
        self.draw(&mut svg).map_err(|error| ToolError::Plot(error.to_string()))?;
        match std::fs::write(file, svg) {
            Ok(()) => Ok(format!("{name}\n")),
            Err(reason) => Err(ToolError::Write { file: name, reason }),
        }
    }

    fn draw(&self, svg: &mut String) -> Result<(), Box<dyn Error>> {
        let rows = self.panels.len().div_ceil(COLUMNS);
        let height = 2 * HEAD + rows as u32 * PANEL_HEIGHT;
        let page = SVGBackend::with_string(svg, (WIDTH, height)).into_drawing_area();
        page.fill(&WHITE)?;
        let (head, body) = page.split_vertically(2 * HEAD);
        head.draw(&Text::new(
            self.title.as_str(),
            (LEFT as i32, MARGIN as i32),
            TextStyle::from(TITLE.into_font()).color(&INK),
        ))?;
        let width = (WIDTH - LEFT) as usize / self.legend.len().max(1);
        for (i, &(colour, name)) in self.legend.iter().enumerate() {
            let (x, y) = (LEFT as i32 + (i * width) as i32, (HEAD + MARGIN) as i32);
            head.draw(&Circle::new((x + DOT, y), DOT, colour.filled()))?;
            // The backend shows text at 1/1.24 of its size.
            let beside = (x + 4 * DOT, y - (0.5 / 1.24 * f64::from(FONT.1)) as i32);
            head.draw(&Text::new(name, beside, TextStyle::from(FONT.into_font()).color(&INK)))?;
        }
        for (panel, area) in self.panels.iter().zip(body.split_evenly((rows, COLUMNS))) {
            panel.draw(&area)?;
        }
        page.present()?;
        Ok(())
    }
}

impl Panel {
    fn draw(&self, area: &DrawingArea<SVGBackend<'_>, Shift>) -> Result<(), Box<dyn Error>> {
        let points = || self.curves.iter().flat_map(|curve| &curve.points);
        let horizontal = range(points().map(|point| point.0), 0.0);
        let vertical = range(points().map(|point| point.1), 0.06);
        let mut chart = ChartBuilder::on(area)
            .margin(MARGIN)
            .margin_right(3 * MARGIN)
            .x_label_area_size(BELOW)
            .y_label_area_size(LEFT)
            .build_cartesian_2d(horizontal, vertical)?;
        chart
            .configure_mesh()
            .light_line_style(WHITE.mix(0.0))
            .bold_line_style(GRID)
            .axis_style(INK)
            .label_style(FONT.into_font().color(&INK))
            .x_desc(&self.horizontal)
            .y_desc(self.vertical)
            .x_labels(8)
            .y_labels(7)
            .x_label_formatter(&tick)
            .y_label_formatter(&tick)
            .draw()?;
        for curve in &self.curves {
            let points = curve.points.iter().copied().filter(|(x, y)| (x + y).is_finite());
            if curve.joined {
                chart.draw_series(LineSeries::new(points, curve.colour.stroke_width(3)))?;
            } else {
                let dot = |point| Circle::new(point, DOT, curve.colour.filled());
                chart.draw_series(points.map(dot))?;
            }
        }
        Ok(())
    }
}

/// A number beside an axis, without the rounding errors of its step.
fn tick(value: &f64) -> String {
    let rounded = (value * 1e9).round() / 1e9;
    // Adding zero takes the sign off a negative zero.
    (rounded + 0.0).to_string()
}

/// The range of an axis: that of the finite values and `room` of it more on both sides; never nothing.
fn range(values: impl Iterator<Item = f64>, room: f64) -> Range<f64> {
    let finite = values.filter(|value| value.is_finite());
    let (low, high) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        (low.min(value), high.max(value))
    });
    match high - low {
        span if span > 1e-9 * high.abs().max(low.abs()) => low - room * span..high + room * span,
        _ if low.is_finite() && low != 0.0 => low - 0.5 * low.abs()..low + 0.5 * low.abs(),
        _ => -0.5..0.5,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_have_no_more_digits_than_they_need() {
        let text = [100_000.0, -0.0, 0.1 + 0.2, -2.5e-4].map(|value| tick(&value));
        assert_eq!(text, ["100000", "0", "0.3", "-0.00025"]);
    }

    #[test]
    fn axes_hold_all_values_and_are_never_empty() {
        assert_eq!(range([1.0, 3.0, f64::NAN].into_iter(), 0.5), 0.0..4.0);
        assert_eq!(range([-4.0, -4.0].into_iter(), 0.06), -6.0..-2.0);
        assert_eq!(range([].into_iter(), 0.06), -0.5..0.5);
    }
}
