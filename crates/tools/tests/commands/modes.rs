//! `hotfoot modes`, of a body on springs whose frequencies are known.

use std::f64::consts::TAU;
use std::path::PathBuf;

use tools::modes::{ModesArguments, modes};

use crate::table::{STOCK, Table, assert_near, refusal};

/// A body of 9 t on two wheelsets, with a spring at each end of each axle, all at the height of the
/// body's centre of mass, so that no direction moves another. Each spring has 1, 2 and 4 MN/m along,
/// across and down, and a damper of 30 kN s/m down.
const VEHICLE: &str = "
extends = 'wagon-coco-134t-unpowered'
without = ['multibody']
mass_kg = 12000.0
axles = 2
[multibody]
source = 'test'
coupler.height_m = 0.9
[multibody.contact]
wheel = 'S1002'
rail = '60E1'
rail_inclination = 0.025
gauge_mm = 1435.0
flange_back_distance_mm = 1360.0
damping_s_m = 0.9
[multibody.contact.creep]
source = 'test'
friction = 0.3
limit_ratio = 1.0
decay_s_m = 0.0
[[multibody.body]]
name = 'body'
mass_kg = 9000.0
inertia_kg_m2 = [8e3, 60e3, 60e3]
x_m = 0.0
height_m = 0.46
[[multibody.wheelset]]
name = 'front'
mass_kg = 1500.0
inertia_kg_m2 = [800.0, 100.0, 800.0]
x_m = 4.0
wheel_radius_m = 0.46
frame = 'body'
[[multibody.wheelset]]
name = 'rear'
mass_kg = 1500.0
inertia_kg_m2 = [800.0, 100.0, 800.0]
x_m = -4.0
wheel_radius_m = 0.46
frame = 'body'
[[multibody.spring]]
name = 'front'
between = ['body', 'front']
points_m = [[4.0, -1.0, 0.46], [4.0, 1.0, 0.46]]
stiffness_n_m = [1e6, 2e6, 4e6]
damping_n_s_m = [0.0, 0.0, 30e3]
[[multibody.spring]]
name = 'rear'
between = ['body', 'rear']
points_m = [[-4.0, -1.0, 0.46], [-4.0, 1.0, 0.46]]
stiffness_n_m = [1e6, 2e6, 4e6]
damping_n_s_m = [0.0, 0.0, 30e3]
";

/// A file with a vehicle, which lies in a folder of its own.
fn file(text: &str) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("vehicle.toml");
    std::fs::write(&file, text).unwrap();
    (folder, file)
}

fn table(text: &str, words: &[&str]) -> Table {
    let (_folder, file) = file(text);
    let words = [&[file.to_str().unwrap(), "--stock", STOCK, "--csv"], words].concat();
    Table::of::<ModesArguments>(modes, &words)
}

/// f = √(k/m)/2π along, across and down; √(Σ k r²/J)/2π about each axis.
#[test]
fn analytic_a_body_on_springs_has_its_frequencies() {
    let frequency = |stiffness: f64, inertia: f64| (stiffness / inertia).sqrt() / TAU;
    let mut expected = [
        frequency(4.0 * 1e6, 9e3),
        frequency(4.0 * 2e6, 9e3),
        frequency(4.0 * 4e6, 9e3),
        // Roll by the springs 1 m beside the middle, pitch by those 4 m before and behind it, yaw by both.
        frequency(4.0 * 4e6, 8e3),
        frequency(4.0 * 4e6 * 16.0, 60e3),
        frequency(4.0 * (2e6 * 16.0 + 1e6), 60e3),
    ];
    expected.sort_by(f64::total_cmp);
    let found = table(VEHICLE, &["--undamped"]).column("frequency_hz");
    assert_eq!(found.len(), expected.len(), "{found:?}");
    for (found, expected) in found.into_iter().zip(expected) {
        assert_near(found, expected, 1e-6);
    }
}

/// The bounce has ζ = c/(2 √(k m)) and the frequency f √(1 − ζ²).
#[test]
fn analytic_dampers_give_the_bounce_its_damping_ratio() {
    let (stiffness, damping, mass): (f64, f64, f64) = (4.0 * 4e6, 4.0 * 30e3, 9e3);
    let ratio = damping / (2.0 * (stiffness * mass).sqrt());
    let frequency = (stiffness / mass).sqrt() / TAU * (1.0 - ratio * ratio).sqrt();
    let table = table(VEHICLE, &[]);
    let found = table.column("frequency_hz").into_iter().zip(table.column("damping_ratio"));
    let near = |(f, zeta): &(f64, f64)| {
        (f / frequency - 1.0).abs() < 1e-6 && (zeta / ratio - 1.0).abs() < 1e-6
    };
    assert_eq!(found.filter(near).count(), 1, "{frequency} Hz with {ratio}");
}

/// A mode has its shape in every coordinate of the bodies that can move: here one body.
#[test]
fn golden_columns() {
    let names = "frequency_hz,damping_ratio,body.x.re,body.x.im,body.y.re,body.y.im,body.z.re,body.z.im,\
                 body.roll.re,body.roll.im,body.pitch.re,body.pitch.im,body.yaw.re,body.yaw.im";
    let found = table(VEHICLE, &["--undamped"]).names();
    assert!(found.starts_with(names), "{found}");
}

/// For people the coordinates that hold the energy are named with their share.
#[test]
fn a_table_for_people_names_what_moves() {
    let (_folder, file) = file(VEHICLE);
    let words = [file.to_str().unwrap(), "--stock", STOCK, "--undamped"];
    let arguments: ModesArguments = crate::table::arguments(&words).unwrap();
    let text = modes(&arguments).unwrap();
    assert!(text.starts_with("frequency  damping  share of the kinetic energy\n"), "{text}");
    for moves in ["body x 100 %", "body z 100 %", "body yaw 100 %"] {
        assert!(text.contains(moves), "{moves}: {text}");
    }
}

#[test]
fn a_vehicle_that_cannot_be_read_is_answered() {
    let refused = |words: &[&str]| refusal::<ModesArguments>(modes, words);
    let message = refused(&["wagon-ore-40", "--stock", STOCK]);
    assert!(
        message.contains("there is no such file; did you mean `wagon-ore-40t.toml`?"),
        "{message}"
    );
    let message = refused(&["any", "--stock", "/nowhere"]);
    assert!(message.contains("/nowhere: is no rolling-stock library"), "{message}");
    let (_folder, file) = file("extends = 'wagon-coco-134t-unpowered'\nwithout = ['multibody']\n");
    let message = refused(&[file.to_str().unwrap(), "--stock", STOCK]);
    assert!(message.contains("has no section [multibody]"), "{message}");
}
