use std::path::Path;

use field::{Axes, FieldWriter};

use super::data::ReportData;
use super::*;
use crate::recording::{Column, Key, KeyValues, SeriesWriter, VehicleRow, vehicle_keys};

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
    ];
    let mut train = SeriesWriter::create(&series, "train", vec![], columns, 10).unwrap();
    let mut rails = rail_table(&series);
    let keys = vehicle_keys(VEHICLES);
    let mut vehicles =
        SeriesWriter::create(&series, "vehicles", keys, VehicleRow::columns(), 10).unwrap();
    for record in 0..=10 * SECONDS {
        let time = record as f64 / 10.0;
        let position = SPEED * time;
        let rise = if (50.0..150.0).contains(&position) { 2.0 - 0.1 * time } else { 0.0 };
        train.observe(0, &[5.0, 1e3 * time]);
        train.record(time).unwrap();
        for (row, share) in [1.0, 0.5].into_iter().enumerate() {
            rails.observe(row, &rail_row(share, time, rise, position));
        }
        rails.record(time).unwrap();
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
    for minute in 1..=30 {
        let time = SECONDS as f64 + 60.0 * f64::from(minute);
        for (row, share) in [1.0, 0.5].into_iter().enumerate() {
            rails.observe(row, &rail_row(share, time, 0.0, -1.0));
        }
        rails.record(time).unwrap();
    }
    rails.finish().unwrap();
    write_field(&folder.join("rail-left.zarr"));
    let manifest = toml::Table::from_iter(
        [("run", toml::Value::try_from(facts).unwrap())]
            .map(|(key, value)| (key.to_owned(), value)),
    );
    std::fs::write(folder.join("manifest.toml"), manifest.to_string()).unwrap();
}

/// The table of two rails with the outputs that the report looks for.
fn rail_table(series: &Path) -> SeriesWriter {
    let column =
        |&(name, unit): &(&str, &str)| Column::new(name, unit, &format!("The {name}")).double();
    let mut columns: Vec<Column> = RAIL_COLUMNS.iter().map(column).collect();
    columns.push(Column::new(
        "probe[1].heat",
        "J/m",
        "Heat above the initial state at chainage 100 m",
    ));
    let keys = vec![Key {
        name: "rail".to_owned(),
        description: "Rail".to_owned(),
        values: KeyValues::Text(vec!["left".to_owned(), "right".to_owned()]),
    }];
    SeriesWriter::create(series, "rail", keys, columns, 10).unwrap()
}

const RAIL_COLUMNS: [(&str, &str); 21] = [
    ("highest.surface.rise", "K"),
    ("highest.surface.chainage", "m"),
    ("foot.present.rise", "K"),
    ("foot.present.chainage", "m"),
    ("foot.highest.rise", "K"),
    ("foot.highest.chainage", "m"),
    ("foot.highest.time", "s"),
    ("foot.detection.chainage", "m"),
    ("foot.detection.time", "s"),
    ("camera.train.rise", "K"),
    ("camera.train.highest.rise", "K"),
    ("camera.train.highest.chainage", "m"),
    ("camera.train.highest.time", "s"),
    ("energy.friction", "J"),
    ("energy.chill", "J"),
    ("energy.bending", "J"),
    ("energy.weather", "J"),
    ("probe[1].heat.friction", "J/m"),
    ("probe[1].heat.chill", "J/m"),
    ("probe[1].heat.bending", "J/m"),
    ("probe[1].heat.weather", "J/m"),
];

/// The foot of the left rail rises by 1 mK a minute until minute 25 and falls by as much then; the
/// right rail has half of it, so that it stays below 15 mK.
fn rail_row(share: f64, time: f64, surface: f64, position: f64) -> Vec<f64> {
    let minutes = time / 60.0;
    let foot = share * 1e-3 * (25.0 - (minutes - 25.0).abs());
    let highest = share * 1e-3 * minutes.min(25.0);
    let detection = if share == 1.0 && minutes >= 15.0 { [88.0, 900.0] } else { [-1.0, -1.0] };
    let camera = [share * 1e-4, share * 1e-4, 77.0, 19.0];
    let mut row = vec![share * surface, position, foot, 99.0];
    row.extend([highest, 99.0, 60.0 * minutes.min(25.0)]);
    row.extend(detection);
    row.extend(camera);
    row.extend([6e3, -3e3, 3e2, 0.0].map(|energy| share * energy));
    row.extend([60.0, -30.0, 3.0, 0.0].map(|heat| share * heat));
    row.push(33.0);
    row
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
        rails: Some(RailFacts {
            sides: vec!["left".to_owned(), "right".to_owned()],
            fields: vec!["rail-left.zarr".to_owned(), "rail-right.zarr".to_owned()],
            model: "energy".to_owned(),
            length_m: 300.0,
            detection_threshold_k: 0.015,
            trains: 1,
            last_train_end_s: SECONDS as f64,
        }),
        notes: vec!["wheels <outside> heat nothing".to_owned()],
        warnings: vec!["the disk is full".to_owned()],
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
        "Temperature of the rail",
        "Energy audit of the rail",
        "Rise of the foot",
        "Heat per metre by source",
        "Rail temperature rise: left rail",
        "At 10 s",
        "At 20 s",
        "Surface rise along the track",
    ] {
        assert!(page.contains(&format!(">{section}<")), "{section} is missing");
    }
    assert_eq!(page.matches("<image href=\"data:image/png;base64,").count(), 2);
    assert!(page.contains("Curve &lt;test&gt; &amp; more"), "the title is escaped");
    assert!(page.contains("wheels &lt;outside&gt; heat nothing"), "the note is shown");
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
        (found.text.as_str(), found.place.as_str())
    };
    assert_eq!(figure("Distance run"), ("300.0 m", "in 20 s"));
    assert_eq!(figure("Speed at the end"), ("15.00 m/s", "change +0.00 m/s"));
    let tension = figure("Largest coupler tension");
    assert_eq!(tension, ("90.0 kN", "rear coupler of vehicle 1 at 0 s"));
    assert_eq!(figure("Largest coupler compression").0, "0 N");
    let creep = figure("Largest longitudinal creep force of a vehicle");
    assert_eq!(creep, ("50.0 kN", "vehicle 1 at 0 s"));
    assert!(figure("Wall time").1.starts_with("5.00 times real time"));
}

/// The rows are those of [`rail_row`]: the left foot reaches 15 mK after 15 min, and 25 mK after
/// 25 min; the record nearest to that is that of 25 min and 20 s.
#[test]
fn analytic_the_answer_on_the_foot_of_each_rail() {
    let (data, page) = report(&facts());
    let figure = |rail: usize, key: &str| {
        let found = data.rails[rail].figures.iter().find(|figure| figure.key == key);
        found.unwrap_or_else(|| panic!("{key} is missing")).clone()
    };
    let surface = figure(0, "left.highest.surface");
    assert_eq!(
        (surface.text.as_str(), surface.place.as_str()),
        ("1.66 K", "chainage 51.0 m at 3.4 s")
    );
    let highest = figure(0, "left.foot.highest");
    assert_eq!((highest.text.as_str(), highest.time_s), ("25.0 mK", Some(1500.0)));
    let detection = figure(0, "left.foot.detection");
    assert_eq!((detection.value, detection.chainage_m), (Some(900.0), Some(88.0)));
    let never = figure(1, "right.foot.detection");
    assert_eq!((never.value, never.text.as_str()), (None, "never"));
    assert_eq!(figure(1, "right.camera.train").text, "50.0 µK");
    let side = figure(0, "left.camera.track_side");
    assert_eq!((side.text.as_str(), side.time_s), ("24.7 mK", Some(1520.0)));
    assert!(side.place.ends_with("25.0 min after the run of the last train"), "{}", side.place);
    assert_eq!(data.rails[1].heat[0].place, "chainage 100 m");
    assert_eq!(data.rails[1].heat[1].sources, [10.0, -5.0, 0.5, 0.0], "the mean over 300 m");
    assert_eq!(data.rails[0].energy[1].joules, -3e3);
    assert!(page.contains("chainage 88.0 m at 900 s") && page.contains("never"));
}

/// The paper's model has no answer on the foot, and a run without time after the train says that a
/// camera at the track side was not simulated.
#[test]
fn what_a_run_does_not_tell_is_not_made_up() {
    let of_rails = facts().rails.unwrap();
    let paper = RailFacts { model: "paper".to_owned(), ..of_rails.clone() };
    let (data, page) = report(&RunFacts { rails: Some(paper), ..facts() });
    assert!(data.rails.iter().all(|rail| rail.foot.is_none() && rail.heat.is_empty()));
    assert!(!page.contains("Rise of the foot") && page.contains("Temperature of the rail"));
    let no_cooling = RailFacts { last_train_end_s: 1e9, ..of_rails };
    let (_, page) = report(&RunFacts { rails: Some(no_cooling), ..facts() });
    assert!(page.contains("not simulated") && page.contains("heat.cool_down_minutes"));
}

#[test]
fn what_is_collected_is_what_the_run_has() {
    let (data, _) = report(&facts());
    let places: Vec<_> = data.vehicles.iter().map(|vehicle| vehicle.place).collect();
    assert_eq!(places, [1, 2, 3, 10], "a vehicle that the train has not is left out");
    assert_eq!(data.energy[0].name, "Work of traction since the start");
    assert_eq!(data.vehicles[0].coupler_force.value.len(), data.time.len());
    let field = data.rails[0].field.as_ref().unwrap();
    assert!(data.rails[1].field.is_none(), "no field was written of the right rail");
    let times: Vec<_> = field.snapshots.iter().map(|snapshot| snapshot.time).collect();
    assert_eq!(times, [10.0, 20.0], "a time that the run has not reached is left out");
    assert_eq!(field.snapshots[0].vehicles[1], 10.0 * SPEED - 20.0);
    assert_eq!(field.surface(&field.snapshots[0]).count(), field.chainage.len());
}

#[test]
fn a_run_without_rail_heat_or_locomotives_has_a_report() {
    let facts = RunFacts { locomotives: vec![], wall_time_s: None, energy: vec![], ..facts() };
    let facts = RunFacts { rails: None, ..facts };
    let folder = tempfile::tempdir().unwrap();
    write_run(folder.path(), &facts);
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
