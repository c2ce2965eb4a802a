//! Temperature rise over chainage and depth, as a picture with axes.

use std::ops::Range;

use base64::Engine;
use plotters::element::Rectangle;
use plotters::prelude::{ChartBuilder, Color, IntoDrawingArea, IntoFont, RGBColor, SVGBackend};
use plotters::series::{DashedLineSeries, LineSeries};

use super::data::{RailField, Snapshot};
use super::error::ReportError;
use super::line_chart::{BELOW, FONT, INK, LEFT, MARGIN, WIDTH};
use super::palette::{self, HeatScale};
use super::quantity::tick;

const HEIGHT: u32 = 620;
/// Size of the picture in its own pixels: the page shows it at about half of its width.
const MOST_COLUMNS: usize = 1600;
const ROWS: usize = 320;
/// Share of the depth by which the strips with curves and train stand above the surface.
const STRIPS: f64 = 0.2;
/// Depth of which the paper speaks (section 5.1), mm.
const MARKED_DEPTH: f64 = 60.0;

const TRAIN: RGBColor = RGBColor(165, 165, 165);
const LOCOMOTIVE: RGBColor = RGBColor(40, 40, 40);
const CURVE: RGBColor = RGBColor(86, 180, 233);

/// A picture, and the axes drawn over it.
#[derive(Debug, serde::Serialize)]
pub(super) struct HeatMap {
    /// Axes, marks and strips, without background.
    pub axes: String,
    /// The picture as a data URI.
    pub picture: String,
    /// Left edge of the picture in the drawing.
    pub x: i32,
    /// Its upper edge.
    pub y: i32,
    /// Its width.
    pub width: i32,
    /// Its height.
    pub height: i32,
}

/// Where the picture belongs in the drawing.
struct Corners {
    upper_left: (i32, i32),
    lower_right: (i32, i32),
}

/// What the heat maps of a run have in common, so that they can be compared.
pub(super) struct HeatMaps<'a> {
    /// The field.
    pub field: &'a RailField,
    /// Colours.
    pub scale: HeatScale,
    /// Elements that are shown.
    pub elements: Range<usize>,
    /// Places of locomotives in the train, from 1.
    pub locomotives: &'a [usize],
    /// Chainages at which curves begin and end, m.
    pub curves: &'a [[f64; 2]],
}

/// The elements between the first and the last that shows a colour at some time, and a little
/// more; all if none does.
pub(super) fn warm_elements(field: &RailField, scale: HeatScale) -> Range<usize> {
    let depths = field.depth.len().max(1);
    let warm = |column: &[f32]| column.iter().any(|&rise| f64::from(rise) > scale.lowest());
    let columns = |snapshot: &'_ Snapshot| -> Vec<bool> {
        snapshot.rise.chunks_exact(depths).map(warm).collect()
    };
    let warm: Vec<Vec<bool>> = field.snapshots.iter().map(columns).collect();
    let first = warm.iter().filter_map(|columns| columns.iter().position(|&warm| warm)).min();
    let last = warm.iter().filter_map(|columns| columns.iter().rposition(|&warm| warm)).max();
    match (first, last) {
        (Some(first), Some(last)) => {
            let room = (last - first) / 20 + 1;
            first.saturating_sub(room)..(last + room + 1).min(field.chainage.len())
        }
        _ => 0..field.chainage.len(),
    }
}

impl HeatMaps<'_> {
    /// Draws the map of one time.
    pub fn draw(&self, snapshot: &Snapshot) -> Result<HeatMap, ReportError> {
        let failed = |reason: String| ReportError::Drawing {
            figure: format!("temperature rise at {} s", snapshot.time),
            reason,
        };
        let mut axes = String::new();
        let Corners { upper_left: (x, y), lower_right } =
            self.draw_axes(snapshot, &mut axes).map_err(|error| failed(error.to_string()))?;
        let picture = self.picture(snapshot).map_err(|error| failed(error.to_string()))?;
        Ok(HeatMap { axes, picture, x, y, width: lower_right.0 - x, height: lower_right.1 - y })
    }

    /// Height of the column of rail, m.
    fn bottom(&self) -> f64 {
        match self.field.depth.as_slice() {
            [.., before, last] => last + 0.5 * (last - before),
            [only] => 2.0 * only,
            [] => 1.0,
        }
    }

    /// Chainages at which the shown elements begin and end, m.
    fn chainages(&self) -> Range<f64> {
        match &self.field.chainage[self.elements.clone()] {
            [first, .., last] => *first..*last,
            [only] => only - 0.5..only + 0.5,
            [] => 0.0..1.0,
        }
    }

    /// Draws axes and strips; gives the corners of the area for the picture.
    ///
    /// Depth counts downwards, so that the vertical axis shows the depth less its sign.
    fn draw_axes<'svg>(
        &self,
        snapshot: &Snapshot,
        svg: &'svg mut String,
    ) -> Result<Corners, Box<dyn std::error::Error + 'svg>> {
        let chainages = self.chainages();
        let bottom = 1e3 * self.bottom();
        let area = SVGBackend::with_string(svg, (WIDTH, HEIGHT)).into_drawing_area();
        let mut chart = ChartBuilder::on(&area)
            .margin(MARGIN)
            .x_label_area_size(BELOW)
            .y_label_area_size(LEFT)
            .build_cartesian_2d(chainages.clone(), -bottom..STRIPS * bottom)?;
        chart
            .configure_mesh()
            .disable_mesh()
            .axis_style(INK)
            .label_style(FONT.into_font().color(&INK))
            .x_desc("Chainage in m")
            .y_desc("Depth in mm")
            .x_labels(12)
            .y_labels(8)
            .x_label_formatter(&|x| tick(*x, chainages.end - chainages.start))
            .y_label_formatter(&|y| if *y > 0.0 { String::new() } else { tick(-y, bottom) })
            .draw()?;

        let strip = |ends: [f64; 2], from: f64, to: f64, colour: RGBColor| {
            let [begin, end] = ends.map(|end| end.clamp(chainages.start, chainages.end));
            Rectangle::new([(begin, from * bottom), (end, to * bottom)], colour.filled())
        };
        let curves = self.curves.iter();
        chart.draw_series(curves.map(|&curve| strip(curve, 0.02, 0.07, CURVE)))?;
        let train = train_strip(snapshot, self.locomotives);
        chart.draw_series(train.map(|(ends, colour)| strip(ends, 0.10, 0.16, colour)))?;

        let across = |depth: f64| [(chainages.start, depth), (chainages.end, depth)];
        chart.draw_series(LineSeries::new(across(0.0), INK.stroke_width(2)))?;
        if MARKED_DEPTH < bottom {
            let style = INK.mix(0.7).stroke_width(2);
            chart.draw_series(DashedLineSeries::new(across(-MARKED_DEPTH), 10, 8, style))?;
        }
        let corners = Corners {
            upper_left: chart.backend_coord(&(chainages.start, 0.0)),
            lower_right: chart.backend_coord(&(chainages.end, -bottom)),
        };
        area.present()?;
        Ok(corners)
    }

    /// The picture: each pixel is the highest rise of its elements, interpolated over the depth.
    fn picture(&self, snapshot: &Snapshot) -> Result<String, png::EncodingError> {
        let columns = self.elements.len().clamp(1, MOST_COLUMNS);
        let mut pixels = vec![0; columns * ROWS];
        for column in 0..columns {
            let begin = self.elements.start + column * self.elements.len() / columns;
            let end = self.elements.start + (column + 1) * self.elements.len() / columns;
            let profile = self.highest(snapshot, begin..end);
            for row in 0..ROWS {
                let depth = (row as f64 + 0.5) / ROWS as f64 * self.bottom();
                let rise = interpolated(&self.field.depth, &profile, depth);
                pixels[row * columns + column] = (self.scale.share(rise) * 255.0).round() as u8;
            }
        }
        let mut file = vec![];
        let mut encoder = png::Encoder::new(&mut file, columns as u32, ROWS as u32);
        encoder.set_color(png::ColorType::Indexed);
        encoder.set_depth(png::BitDepth::Eight);
        let colours = (0..=255).map(|index| palette::heat(f64::from(index) / 255.0));
        encoder.set_palette(colours.flat_map(|c| [c.0, c.1, c.2]).collect::<Vec<u8>>());
        let mut writer = encoder.write_header()?;
        writer.write_image_data(&pixels)?;
        writer.finish()?;
        let text = base64::engine::general_purpose::STANDARD.encode(&file);
        Ok(format!("data:image/png;base64,{text}"))
    }

    /// Highest rise of some elements at each depth, K.
    fn highest(&self, snapshot: &Snapshot, elements: Range<usize>) -> Vec<f64> {
        let depths = self.field.depth.len();
        let mut highest = vec![0.0_f64; depths];
        for element in elements {
            let column = snapshot.rise.iter().skip(element * depths);
            for (highest, &rise) in highest.iter_mut().zip(column) {
                *highest = highest.max(rise.into());
            }
        }
        highest
    }
}

/// Where the train and its locomotives stand: from half a vehicle before the first middle to
/// half a vehicle behind the last.
fn train_strip(
    snapshot: &Snapshot,
    locomotives: &[usize],
) -> impl Iterator<Item = ([f64; 2], RGBColor)> {
    let vehicles = &snapshot.vehicles;
    let half = match vehicles.as_slice() {
        [first, .., last] => 0.5 * (first - last) / (vehicles.len() - 1) as f64,
        _ => 10.0,
    };
    let around = move |tail: f64, head: f64| [tail - half, head + half];
    let train = vehicles.first().zip(vehicles.last());
    let train = train.map(|(&head, &tail)| (around(tail, head), TRAIN));
    let locomotives = locomotives.iter().filter_map(|number| vehicles.get(number.checked_sub(1)?));
    let locomotives = locomotives.map(move |&middle| (around(middle, middle), LOCOMOTIVE));
    train.into_iter().chain(locomotives)
}

/// The value at `depth` between the cell middles; constant above the first and below the last.
fn interpolated(depths: &[f64], values: &[f64], depth: f64) -> f64 {
    let after = depths.partition_point(|&other| other <= depth);
    match (after.checked_sub(1), depths.get(after)) {
        (Some(before), Some(next)) => {
            let weight = (depth - depths[before]) / (next - depths[before]);
            values[before] + weight * (values[after] - values[before])
        }
        (Some(before), None) => values[before],
        (None, _) => values.first().copied().unwrap_or(0.0),
    }
}
