//! Drawings read back: the positions of curves in SVG.

use plotters::style::RGBColor;

use super::data::Curve;
use super::line_chart::{LineChart, WIDTH};
use super::palette;

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

/// Lines that lie on each other differ in width and pattern.
#[test]
fn lines_that_lie_on_each_other_all_show() {
    let curve = Curve::plain(vec![1.0, 2.0, 3.0]);
    let svg = chart(&[0.0, 1.0, 2.0], vec![&curve, &curve, &curve]).svg().unwrap();
    let document = roxmltree::Document::parse(&svg).unwrap();
    let styles: Vec<_> = (0..3)
        .map(|index| {
            let colour = palette::html(palette::line(index));
            let line = document.descendants().find(|node| {
                node.has_tag_name("polyline")
                    && node.attribute("stroke").is_some_and(|s| s.eq_ignore_ascii_case(&colour))
            });
            let line = line.expect("a line of that colour");
            (line.attribute("stroke-width").unwrap(), line.attribute("stroke-dasharray"))
        })
        .collect();
    assert_eq!(styles, [("7", None), ("5", Some("18 10")), ("3", Some("4 8"))]);
}
