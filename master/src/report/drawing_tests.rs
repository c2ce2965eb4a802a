//! Drawings read back: the positions of curves in SVG, and the colours of a heat map in PNG.

use base64::Engine;
use plotters::style::RGBColor;

use super::data::{Curve, RailField, Snapshot};
use super::heat_map::{HeatMap, HeatMaps, warm_elements};
use super::line_chart::{LineChart, WIDTH};
use super::palette::{self, HeatScale};

fn chart<'a>(abscissa: &'a [f64], curves: Vec<&'a Curve>) -> LineChart<'a> {
    LineChart {
        title: "Test",
        horizontal: "Time in s",
        abscissa,
        quantity: "Force",
        unit: "N",
        height: 460,
        curves,
        first_colour: 0,
        steps: false,
    }
}

/// Points of the first line of this colour.
fn points(svg: &str, colour: RGBColor) -> Vec<(f64, f64)> {
    let document = roxmltree::Document::parse(svg).expect("SVG is XML");
    let colour = palette::html(colour);
    let line = document
        .descendants()
        .filter(|node| node.has_tag_name("polyline"))
        .find(|line| line.attribute("stroke").is_some_and(|s| s.eq_ignore_ascii_case(&colour)))
        .expect("a line of that colour");
    let pairs = line.attribute("points").expect("a polyline has points").split_whitespace();
    pairs
        .map(|pair| {
            let (x, y) = pair.split_once(',').expect("x,y");
            (x.parse().expect("a number"), y.parse().expect("a number"))
        })
        .collect()
}

fn texts(svg: &str) -> Vec<String> {
    let document = roxmltree::Document::parse(svg).expect("SVG is XML");
    let texts = document.descendants().filter(|node| node.has_tag_name("text"));
    texts.filter_map(|node| node.text().map(|text| text.trim().to_owned())).collect()
}

/// A straight line is drawn straight and upwards: the middle lies in the middle, to the pixel on which
/// the backend puts every point.
#[test]
fn analytic_a_straight_line_is_straight() {
    let curve = Curve::plain(vec![0.0, 5e3, 10e3]);
    let svg = chart(&[0.0, 1.0, 2.0], vec![&curve]).svg().unwrap();
    let points = points(&svg, palette::line(0));
    assert_eq!(points.len(), 3);
    let middle = |pick: fn(&(f64, f64)) -> f64| {
        (pick(&points[1]) - 0.5 * (pick(&points[0]) + pick(&points[2]))).abs()
    };
    assert!(middle(|p| p.0) <= 1.0 && middle(|p| p.1) <= 1.0, "{points:?}");
    assert!(points[0].1 > points[2].1, "y counts downwards in SVG");
    assert!(points.iter().all(|p| (0.0..f64::from(WIDTH)).contains(&p.0)), "{points:?}");
    assert!(texts(&svg).iter().any(|text| text == "Force in kN"), "{:?}", texts(&svg));
}

/// Values that hold are drawn with corners: at the second time both the old and the new value.
#[test]
fn steps_have_corners() {
    let curve = Curve::plain(vec![0.0, 8.0]);
    let steps = LineChart { steps: true, unit: "", ..chart(&[0.0, 1.0], vec![&curve]) };
    let points = points(&steps.svg().unwrap(), palette::line(0));
    assert_eq!(points.len(), 3);
    assert_eq!(points[0].1, points[1].1, "the old value holds");
    assert_eq!(points[1].0, points[2].0, "until the new one");
}

#[test]
fn each_curve_has_its_colour_and_gaps_are_left_out() {
    let broken = Curve::plain(vec![1.0, f64::NAN, 3.0]);
    let whole = Curve::plain(vec![3.0, 2.0, 1.0]);
    let svg = chart(&[0.0, 1.0, 2.0], vec![&broken, &whole]).svg().unwrap();
    assert_eq!(points(&svg, palette::line(0)).len(), 2);
    assert_eq!(points(&svg, palette::line(1)).len(), 3);
}

/// Ten elements of 1 m with three cells; the fourth is 1 K warm in its upper cell at 20 s.
fn field() -> RailField {
    let mut rise = vec![0.0_f32; 30];
    rise[3 * 3] = 1.0;
    let chainage = (0..10).map(|element| 100.0 + f64::from(element)).collect();
    let snapshot = Snapshot { time: 20.0, rise, vehicles: vec![108.0, 104.0] };
    RailField { chainage, depth: vec![0.025, 0.075, 0.125], snapshots: vec![snapshot] }
}

fn map(field: &RailField) -> HeatMap {
    let scale = HeatScale::of(1.0);
    let (locomotives, curves) = (&[1][..], &[[102.0, 106.0]][..]);
    HeatMaps { field, scale, elements: 0..10, locomotives, curves }
        .draw(&field.snapshots[0])
        .unwrap()
}

/// Size of the picture and its pixels as RGB, by a decoder of PNG.
fn decoded(map: &HeatMap) -> (usize, usize, Vec<[u8; 3]>) {
    let text = map.picture.strip_prefix("data:image/png;base64,").expect("a data URI of PNG");
    let bytes = base64::engine::general_purpose::STANDARD.decode(text).expect("base64");
    let mut decoder = png::Decoder::new(std::io::Cursor::new(bytes));
    decoder.set_transformations(png::Transformations::EXPAND);
    let mut reader = decoder.read_info().expect("PNG");
    let mut pixels = vec![0; reader.output_buffer_size().expect("a small picture")];
    let info = reader.next_frame(&mut pixels).expect("a frame");
    let (width, height) = (info.width as usize, info.height as usize);
    (width, height, pixels.chunks_exact(3).map(|p| [p[0], p[1], p[2]]).collect())
}

/// The darkest colour stands where the highest rise is, white where there is none.
#[test]
fn a_heat_map_has_its_colours_where_the_heat_is() {
    let (width, height, pixels) = decoded(&map(&field()));
    assert_eq!(width, 10, "a column for each element");
    let rgb = |colour: RGBColor| [colour.0, colour.1, colour.2];
    assert_eq!(pixels[3], rgb(palette::heat(1.0)), "at the surface of the fourth element");
    for column in (0..10).filter(|&column| column != 3) {
        assert_eq!(pixels[column], rgb(palette::heat(0.0)), "column {column}");
    }
    assert_eq!(pixels[(height - 1) * width + 3], rgb(palette::heat(0.0)), "the foot is cold");
    // Half way between the upper and the middle cell, 50 mm deep of 150, the rise is 0.5 K: on four
    // decades below 1 K a share of 1 + log10(0.5)/4; the table of colours has 256 of them.
    let half = (1.0 + 0.5_f64.log10() / 4.0, height / 3 * width + 3);
    let expected = rgb(palette::heat(half.0));
    let found = pixels[half.1];
    let close = expected.iter().zip(found).all(|(a, b)| a.abs_diff(b) <= 6);
    assert!(close, "{found:?} where {expected:?} is wanted");
}

/// The picture lies where the axes say: 100 m at its left edge, 109 m at its right one.
#[test]
fn the_picture_fills_the_area_of_the_axes() {
    let map = map(&field());
    assert!(map.x > 0 && map.y > 0 && map.width > 0 && map.height > 0);
    assert!(map.x + map.width < WIDTH as i32, "a margin is left");
    let words = texts(&map.axes);
    for wanted in ["Chainage in m", "Depth in mm", "100", "109"] {
        assert!(words.iter().any(|word| word == wanted), "{wanted} in {words:?}");
    }
}

#[test]
fn only_what_is_warm_is_shown_with_a_little_more() {
    let scale = HeatScale::of(1.0);
    assert_eq!(warm_elements(&field(), scale), 2..5, "one element more at both sides");
    let mut cold = field();
    cold.snapshots[0].rise.fill(0.0);
    assert_eq!(warm_elements(&cold, scale), 0..10, "all where nothing is warm");
}
