//! The examples run as their READMEs say.

use std::path::Path;

use hotfoot::recording::{KeyValue, SeriesReader};
use hotfoot_tests::{hotfoot, library, root};

/// Packs an example's library into `file` in the folder.
fn pack(folder: &Path, package: &str, file: &str) {
    let library = library(package).display().to_string();
    succeeds(folder, &["pack", &library, "-o", file]);
}

fn succeeds(folder: &Path, arguments: &[&str]) {
    let output = hotfoot(folder, arguments);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn the_first_fmu_breaks_no_rule() {
    let folder = tempfile::tempdir().unwrap();
    pack(folder.path(), "first_fmu", "first.fmu");
    succeeds(folder.path(), &["check", "first.fmu"]);
}

/// The train with the point mass: the stranger keeps its place, with less force than the 3D wagon
/// ahead of it, whose wheelsets turn.
#[test]
fn a_vehicle_is_swapped_for_a_point_mass() {
    let (folder, example) = (tempfile::tempdir().unwrap(), root().join("examples/swap-a-vehicle"));
    for name in ["scenario.toml", "track.toml", "driver.toml"] {
        let text = std::fs::read_to_string(example.join(name)).unwrap();
        let stock = root().join("stock").display().to_string();
        std::fs::write(folder.path().join(name), text.replace("../../stock", &stock)).unwrap();
    }
    pack(folder.path(), "swap_a_vehicle", "point-mass.fmu");
    succeeds(folder.path(), &["check", "point-mass.fmu", "--as", "vehicle"]);
    succeeds(folder.path(), &["run", "scenario.toml", "--quiet", "--results", "results"]);

    let series = folder.path().join("results/series");
    let vehicles = SeriesReader::open(&series, "vehicles").unwrap();
    let column = |name: &str, vehicle: i32| {
        vehicles.read(name, &[("vehicle", KeyValue::Integer(vehicle))]).unwrap()
    };
    let greatest = |values: Vec<f64>| values.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
    assert!(greatest(column("position_error", 3)) < 0.01);
    assert!(greatest(column("sync_force", 3)) < greatest(column("sync_force", 2)));
    assert_eq!(greatest(column("creep_force", 3)), 0.0);
}
