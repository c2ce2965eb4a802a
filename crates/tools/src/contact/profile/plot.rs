//! The plot of `hotfoot profile`: the profile, its slope, and what smoothing took away.

use contact::{ProfileFile, ProfileKind};

use super::arguments::ProfileArguments;
use super::dimensions::gauge_point;
use crate::contact::outline::MM;
use crate::plot::{BLACK, BLUE, Curve, Page, Panel, SKY, VERMILION};

/// Points of the curve that are drawn.
const DRAWN: usize = 1000;

/// The page for a file.
pub(super) fn page(arguments: &ProfileArguments, file: &ProfileFile) -> Page {
    let (begin, end) = file.profile.range();
    let at = |i: usize| begin + (end - begin) * i as f64 / DRAWN as f64;
    let curve: Vec<_> = (0..=DRAWN).map(|i| (at(i), file.profile.at(at(i)))).collect();
    let joined = |points: Vec<(f64, f64)>| Curve { colour: BLUE, joined: true, points };
    let dots = |colour, points| Curve { colour, joined: false, points };
    // Heights count downwards; a picture has what is high above.
    let point = |[y, z]: [f64; 2]| (y / MM, -z / MM);
    let level = match file.kind {
        ProfileKind::Wheel => level(file),
        ProfileKind::Rail => 0.0,
    };
    let measured = file.points.iter().map(|[y, z]| point([*y, z - level])).collect();
    let outline = file.profile.outline();
    let off = file.points.iter().zip(outline).map(|(read, smooth)| {
        let down = read[1] - level - smooth[1];
        let slope = file.profile.at(smooth[0]).slope;
        let across = (down - slope * (read[0] - smooth[0])) / (1.0 + slope * slope).sqrt();
        (smooth[0] / MM, -1e6 * across)
    });
    let marks = match file.kind {
        ProfileKind::Wheel => {
            vec![
                (-arguments.outline.running_circle_mm, -file.profile.at(begin).height / MM),
                (0.0, 0.0),
            ]
        }
        ProfileKind::Rail => {
            let [top, height] = file.profile.top();
            let depth = arguments.outline.gauge_depth_mm * MM;
            let gauge = gauge_point(outline, [top, height], depth);
            let gauge = gauge.map(|lateral| point([lateral, height + depth]));
            gauge.into_iter().chain([point([top, height])]).collect()
        }
    };
    let marked = match file.kind {
        ProfileKind::Wheel => "flange back, running circle",
        ProfileKind::Rail => "gauge point, top",
    };
    Page {
        title: format!("{}: {} of a {}", arguments.file.display(), file.format, file.kind),
        legend: vec![
            (SKY, "points of the file"),
            (BLUE, "curve"),
            (VERMILION, marked),
            (BLACK, "removed"),
        ],
        panels: vec![
            Panel {
                horizontal: lateral(),
                vertical: "height in mm",
                curves: vec![
                    dots(SKY, measured),
                    joined(curve.iter().map(|(y, at)| point([*y, at.height])).collect()),
                    dots(VERMILION, marks),
                ],
            },
            Panel {
                horizontal: lateral(),
                vertical: "angle in degrees",
                curves: vec![joined(
                    curve.iter().map(|(y, at)| (y / MM, at.slope.atan().to_degrees())).collect(),
                )],
            },
            Panel {
                horizontal: lateral(),
                vertical: "removed by smoothing in µm",
                curves: vec![Curve { colour: BLACK, joined: true, points: off.collect() }],
            },
        ],
    }
}

/// Height of the running circle in the points as they were read, m.
fn level(file: &ProfileFile) -> f64 {
    let nearest = file.points.iter().zip(file.profile.outline());
    let nearest = nearest.min_by(|a, b| a.1[0].abs().total_cmp(&b.1[0].abs()));
    nearest.map_or(0.0, |(read, smooth)| read[1] - smooth[1])
}

fn lateral() -> String {
    "lateral, towards the field side, in mm".to_owned()
}
