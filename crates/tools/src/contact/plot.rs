//! The plot of `hotfoot contact`: a panel for each quantity over the lateral displacement.

use plotters::style::RGBColor;

use super::arguments::ContactArguments;
use super::placement::{LoadedContact, Placement};
use crate::plot::{BLACK, BLUE, Curve, ORANGE, Page, Panel, SKY, VERMILION};

/// Colours of the first contact of a wheel and of its further ones: left, right.
const COLOURS: [[RGBColor; 2]; 2] = [[BLUE, SKY], [VERMILION, ORANGE]];

/// The page for a wheelset at these placements.
pub(super) fn page(arguments: &ContactArguments, placements: &[Placement]) -> Page {
    let ContactArguments { wheel, rail, inclination, load, .. } = arguments;
    let title = match *inclination > 0.0 {
        true => format!("{wheel} on {rail} 1:{:.0}, {} kN a wheel", 1.0 / inclination, load / 1e3),
        false => format!("{wheel} on {rail} upright, {} kN a wheel", load / 1e3),
    };
    let [[left, left_others], [right, right_others]] = COLOURS;
    Page {
        title,
        legend: vec![
            (left, "left wheel, first contact"),
            (left_others, "left wheel, further contacts"),
            (right, "right wheel, first contact"),
            (right_others, "right wheel, further contacts"),
        ],
        panels: vec![
            radii(placements),
            conicity(placements),
            contacts("contact angle in mrad", placements, |contact| contact.angle_mrad),
            contacts("normal force in N", placements, |contact| contact.normal_force_n),
            contacts("contact on the rail in mm", placements, |contact| contact.rail_mm),
            contacts("contact on the wheel in mm", placements, |contact| contact.wheel_mm),
            contacts("semi-axis a along in mm", placements, |contact| contact.a_mm),
            contacts("semi-axis b across in mm", placements, |contact| contact.b_mm),
        ],
    }
}

fn radii(placements: &[Placement]) -> Panel {
    let points = placements.iter().map(|p| (p.lateral_mm, p.radius_difference_mm));
    Panel {
        horizontal: displacement(),
        vertical: "rolling radii, right less left, in mm",
        curves: vec![Curve { colour: BLACK, joined: true, points: points.collect() }],
    }
}

/// The conicity over the amplitude; displacements to the left and to the right give the same.
fn conicity(placements: &[Placement]) -> Panel {
    let known = |p: &Placement| Some((p.lateral_mm.abs(), p.equivalent_conicity?));
    let mut points: Vec<(f64, f64)> = placements.iter().filter_map(known).collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    Panel {
        horizontal: "amplitude in mm".to_owned(),
        vertical: "equivalent conicity",
        curves: vec![Curve { colour: BLACK, joined: true, points }],
    }
}

/// A quantity of each contact that bears a load.
fn contacts(
    vertical: &'static str,
    placements: &[Placement],
    quantity: fn(&LoadedContact) -> f64,
) -> Panel {
    let curve = |side: usize, others: usize| {
        let points = placements.iter().flat_map(|placement| {
            let contacts = placement.wheels[side].iter().enumerate();
            let wanted = contacts.filter(move |(number, _)| (*number > 0) == (others > 0));
            let loaded = wanted.filter(|(_, contact)| contact.normal_force_n > 0.0);
            loaded.map(|(_, contact)| (placement.lateral_mm, quantity(contact)))
        });
        Curve { colour: COLOURS[side][others], joined: false, points: points.collect() }
    };
    let curves = vec![curve(0, 0), curve(0, 1), curve(1, 0), curve(1, 1)];
    Panel { horizontal: displacement(), vertical, curves }
}

fn displacement() -> String {
    "displacement to the right in mm".to_owned()
}
