use std::path::Path;

use field::{Axes, FieldWriter};

use super::data::ReportData;
use super::*;
use crate::recording::{Column, SeriesWriter, VehicleRow, vehicle_keys};

const VEHICLES: usize = 10;
const LOCOMOTIVES: usize = 2;
const SECONDS: usize = 20;
const SPEED: f64 = 15.0;

/// Writes the results of an invented run: the shapes of a train in a curve, by formulas.
fn write_run(folder: &Path, facts: &RunFacts) {
    let series = folder.join("series");
    let columns = vec![
        Column::new("driver.in_force.notch", "1", "Notch in force"),
        Column::new("energy.traction", "J", "Work of traction since the start"),
        Column::new("rail.highest.surface.rise", "K", "Highest rise at the surface").double(),
        Column::new("rail.highest.surface.chainage", "m", "Chainage of it").double(),
    ];
    let mut train = SeriesWriter::create(&series, "train", vec![], columns, 10).unwrap();
    let keys = vehicle_keys(VEHICLES);
    let mut vehicles =
        SeriesWriter::create(&series, "vehicles", keys, VehicleRow::columns(), 10).unwrap();
    for record in 0..=10 * SECONDS {
        let time = record as f64 / 10.0;
        let position = SPEED * time;
        let rise = if (50.0..150.0).contains(&position) { 2.0 - 0.1 * time } else { 0.0 };
        train.observe(0, &[5.0, 1e3 * time, rise, position]);
        train.record(time).unwrap();
        for index in 0..VEHICLES {
            let position = position - 20.0 * index as f64;
            let in_curve = (50.0..150.0).contains(&position);
            let swing = if in_curve { (3.0 * time).sin() } else { 0.0 };
            let row = VehicleRow {
                position,
                velocity: SPEED,
                coupler_rear_force: 1e4 * (VEHICLES - 1 - index) as f64,
                creep_force: if index < LOCOMOTIVES { 5e4 } else { 200.0 * swing },
                sync_force: 1e3 * swing,
                position_error: -1e-3 * swing,
                ..VehicleRow::default()
            };
            vehicles.observe(index, &row.values());
        }
        vehicles.record(time).unwrap();
    }
    train.finish().unwrap();
    vehicles.finish().unwrap();
    write_field(&folder.join("rail.zarr"));
    let manifest = toml::Table::from_iter(
        [("run", toml::Value::try_from(facts).unwrap())]
            .map(|(key, value)| (key.to_owned(), value)),
    );
    std::fs::write(folder.join("manifest.toml"), manifest.to_string()).unwrap();
}

/// Rises that fall with depth, between chainages 50 m and 150 m, of 2 K at the end of the run.
fn write_field(store: &Path) {
    let axes = Axes {
        chainage: (0..300).map(|i| f64::from(i) + 0.5).collect(),
        depth: (0..40).map(|i| 4e-3 * f64::from(i) + 2e-3).collect(),
    };
    let mut writer = FieldWriter::create(store, &axes, &[]).unwrap();
    for time in [10.0, 20.0] {
        let rise = |chainage: f64, depth: f64| match (50.0..150.0).contains(&chainage) {
            true => 2.0 * time / 20.0 * (-depth / 0.01).exp(),
            false => 0.0,
        };
        let along = axes.chainage.iter();
        let values = along.flat_map(|&x| axes.depth.iter().map(move |&z| rise(x, z) as f32));
        writer.append(time, &values.collect::<Vec<f32>>()).unwrap();
    }
}

fn facts() -> RunFacts {
    RunFacts {
        train_alone: false,
        title: "Curve <test> & more".to_owned(),
        vehicles: VEHICLES,
        locomotives: (1..=LOCOMOTIVES).collect(),
        plotted: vec![1, 2, 3, 10, 99],
        rail: "left".to_owned(),
        heat_maps_at_s: vec![10.0, 20.0, 160.0],
        curves_m: vec![[50.0, 150.0]],
        step_s: 1e-3,
        threads: 2,
        wall_time_s: Some(4.0),
        energy: vec![EnergyLine { name: "energy.traction".to_owned(), joules: 1.5e6 }],
    }
}

fn report(facts: &RunFacts) -> (ReportData, String) {
    let folder = tempfile::tempdir().unwrap();
    write_run(folder.path(), facts);
    let data = collect(folder.path()).unwrap();
    let page = render(&data).unwrap();
    (data, page)
}

#[test]
fn the_page_has_every_section_and_stands_alone() {
    let (_, page) = report(&facts());
    for section in [
        "Main figures",
        "Energy audit",
        "Speed and notch",
        "Coupler forces",
        "Longitudinal creep forces",
        "Synchronisation forces",
        "Position errors",
        "Rail temperature rise",
        "At 10 s",
        "At 20 s",
        "Surface rise along the track",
    ] {
        assert!(page.contains(&format!(">{section}<")), "{section} is missing");
    }
    assert_eq!(page.matches("<image href=\"data:image/png;base64,").count(), 2);
    assert!(page.contains("Curve &lt;test&gt; &amp; more"), "the title is escaped");
    for attribute in ["src=", "href="] {
        for place in page.match_indices(attribute) {
            let target = &page[place.0 + attribute.len() + 1..];
            assert!(target.starts_with("data:"), "refers to {}", &target[..40]);
        }
    }
    for outside in ["@import", "url(http", "<script", "<link"] {
        assert!(!page.contains(outside), "{outside}");
    }
}

/// 20 s at 15 m/s are 300 m; 20 s in 4 s of wall time are 5 times real time; the rise is highest
/// where the train has just come to chainage 50 m: at the first record after 50/15 s.
#[test]
fn analytic_main_figures_of_an_invented_run() {
    let (data, _) = report(&facts());
    let figure = |name: &str| {
        let found = data.main_figures.iter().find(|figure| figure.name == name);
        let found = found.unwrap_or_else(|| panic!("{name} is missing"));
        (found.value.as_str(), found.place.as_str())
    };
    assert_eq!(figure("Distance run"), ("300.0 m", "in 20 s"));
    assert_eq!(figure("Speed at start and end").0, "15.00 and 15.00 m/s");
    let tension = figure("Largest coupler tension");
    assert_eq!(tension, ("90.0 kN", "rear coupler of vehicle 1 at 0 s"));
    assert_eq!(figure("Largest coupler compression").0, "0 N");
    let creep = figure("Largest longitudinal creep force of a vehicle");
    assert_eq!(creep, ("50.0 kN", "vehicle 1 at 0 s"));
    assert!(figure("Wall time").1.starts_with("5.00 times real time"));
    let surface = figure("Highest rise at the surface");
    assert_eq!(surface, ("1.66 K", "chainage 51.0 m at 3.4 s"));
}

#[test]
fn what_is_collected_is_what_the_run_has() {
    let (data, _) = report(&facts());
    let places: Vec<_> = data.vehicles.iter().map(|vehicle| vehicle.place).collect();
    assert_eq!(places, [1, 2, 3, 10], "a vehicle that the train has not is left out");
    assert_eq!(data.energy[0].name, "Work of traction since the start");
    assert_eq!(data.vehicles[0].coupler_force.value.len(), data.time.len());
    let field = data.field.unwrap();
    let times: Vec<_> = field.snapshots.iter().map(|snapshot| snapshot.time).collect();
    assert_eq!(times, [10.0, 20.0], "a time that the run has not reached is left out");
    assert_eq!(field.snapshots[0].vehicles[1], 10.0 * SPEED - 20.0);
    assert_eq!(field.surface(&field.snapshots[0]).count(), field.chainage.len());
}

#[test]
fn a_run_without_rail_heat_or_locomotives_has_a_report() {
    let facts = RunFacts { locomotives: vec![], wall_time_s: None, energy: vec![], ..facts() };
    let folder = tempfile::tempdir().unwrap();
    write_run(folder.path(), &facts);
    std::fs::remove_dir_all(folder.path().join("rail.zarr")).unwrap();
    let page = render(&collect(folder.path()).unwrap()).unwrap();
    assert!(page.contains("this run has not finished"));
    assert!(!page.contains("Rail temperature rise"));
    assert!(!page.contains("Locomotives<"));
}

#[test]
fn property_a_report_is_the_same_each_time_it_is_made() {
    assert!(report(&facts()).1 == report(&facts()).1);
}

#[test]
fn a_folder_without_manifest_is_refused_by_name() {
    let folder = tempfile::tempdir().unwrap();
    let error = collect(folder.path()).unwrap_err().to_string();
    assert!(error.contains("manifest.toml: No such file"), "{error}");
    std::fs::write(folder.path().join("manifest.toml"), "[run]\ntitle = 3\n").unwrap();
    let error = collect(folder.path()).unwrap_err().to_string();
    assert!(error.contains("line 2") && error.contains("manifest.toml"), "{error}");
}

#[test]
fn what_is_written_is_what_is_rendered() {
    let folder = tempfile::tempdir().unwrap();
    write_run(folder.path(), &facts());
    let (file, figures) = write(folder.path()).unwrap();
    let page = render(&collect(folder.path()).unwrap()).unwrap();
    assert!(std::fs::read_to_string(file).unwrap() == page);
    assert_eq!(figures[0].name, "Distance run");
}
