//! The profiles that need no file.

use contact::{RailProfile, WheelProfile};

use super::entry::{Entry, Figure, Kind};

/// Rail profiles with title and source.
const RAILS: [(&str, &str, &str); 4] = [
    (
        "60E1",
        "Head of the rail 60E1, formerly UIC60",
        "EN 13674-1: arcs of 300, 80 and 13 mm that join tangentially",
    ),
    (
        "AS60",
        "Head of the rail of 60 kg/m to AS 1085.1",
        "AS 1085.1: arcs of 190.5, 80 and 10 mm; where those of the crown meet is taken, so that the head is representative",
    ),
    (
        "UIC60-manchester",
        "Head of the rail UIC60 as in the Manchester contact benchmark",
        "Shackleton and Iwnicki 2006: arcs fitted to the points of the benchmark; for validation",
    ),
    ("round-300", "Crown of one radius, 300 mm, with corners of 13 mm", "made for tests"),
];

/// Wheel profiles with title and source.
const WHEELS: [(&str, &str, &str); 2] = [
    (
        "S1002",
        "Wheel profile S1002",
        "EN 13715, in the polynomials of H. Netter (DLR) that the Manchester contact benchmark uses",
    ),
    (
        "cone-1-20",
        "Cone of 1:20; any other ratio N as cone-1-N",
        "a conical tread with the flange of S1002",
    ),
];

/// Half width about the top of a rail, m, whose drop is told.
const HALF_WIDTH: f64 = 0.02;

/// The entries of all profiles.
pub(super) fn entries() -> Vec<Entry> {
    let rails = RAILS.iter().filter_map(|&(name, title, source)| {
        let drop = RailProfile::named(name).ok()?.at(HALF_WIDTH).height;
        let figures = vec![
            Figure::number("20 mm beside its top it is lower by", 1e3 * drop.abs(), "mm", 2).main(),
            Figure::text("shape", "arcs"),
        ];
        Some(entry(Kind::RailProfile, (name, title, source), figures))
    });
    let wheels = WHEELS.iter().filter_map(|&(name, title, source)| {
        let profile = WheelProfile::named(name).ok()?;
        let (from, to) = profile.range();
        let cone = profile.at(0.0).slope.abs();
        let figures = vec![
            Figure::number("slope at the running circle", cone, "1", 4).main(),
            Figure::number("from the running circle to the flange back", -1e3 * from, "mm", 1)
                .main(),
            Figure::number("from the running circle to the field side", 1e3 * to, "mm", 1).main(),
        ];
        Some(entry(Kind::WheelProfile, (name, title, source), figures))
    });
    rails.chain(wheels).collect()
}

fn entry(kind: Kind, (name, title, source): (&str, &str, &str), figures: Vec<Figure>) -> Entry {
    let [name, title, source] = [name, title, source].map(str::to_owned);
    Entry { kind, name, title, file: None, source, figures }
}
