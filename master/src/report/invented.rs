//! Results of an invented run, for the tests: the shapes of a train in a curve, by formulas.

use std::path::Path;

use field::{Axes, FieldWriter, SectionRises, Sections};

use super::{EnergyLine, LimitFacts, RailFacts, RunFacts, TrackFacts};
use crate::recording::{Column, Key, KeyValues, SeriesWriter, VehicleRow, vehicle_keys};

const VEHICLES: usize = 10;
const LOCOMOTIVES: usize = 2;
const SECONDS: usize = 20;
pub const SPEED: f64 = 15.0;

/// Writes the results of an invented run: the shapes of a train in a curve, by formulas.
pub fn write_run(folder: &Path, facts: &RunFacts) {
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

/// Rises that fall with depth, between chainages 50 m and 150 m, of 2 K at the end of the run; the foot is
/// warmest at 99 m then.
fn write_field(store: &Path) {
    let axes = Axes {
        chainage: (0..300).map(|i| f64::from(i) + 0.5).collect(),
        depth: (0..40).map(|i| 4e-3 * f64::from(i) + 2e-3).collect(),
        sections: Some(sections()),
    };
    let mut writer = FieldWriter::create(store, &axes, &[]).unwrap();
    for time in [10.0, 20.0] {
        let rise = |chainage: f64, depth: f64| match (50.0..150.0).contains(&chainage) {
            true => 2.0 * time / 20.0 * (-depth / 0.01).exp(),
            false => 0.0,
        };
        let along = axes.chainage.iter();
        let values = along.flat_map(|&x| axes.depth.iter().map(move |&z| rise(x, z) as f32));
        let sections = SectionRises {
            kept: (0..6).map(|cell| (time / 20.0) as f32 * cell as f32).collect(),
            warmest: vec![0.5, 1.0, (time / 4.0) as f32],
            warmest_chainage: 89.0 + 0.5 * time,
        };
        writer.append(time, &values.collect::<Vec<f32>>(), &sections).unwrap();
    }
}

/// Two probes with three cells each, of 4 mm.
fn sections() -> Sections {
    Sections {
        chainage: vec![100.5, 120.5],
        y: vec![-0.004, 0.0, 0.004],
        z: vec![0.002, 0.002, 0.006],
        area: vec![1.6e-5; 3],
    }
}

pub fn facts() -> RunFacts {
    RunFacts {
        outputs: vec![],
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
        track: TrackFacts {
            chainage_m: vec![0.0, 50.0, 50.0, 150.0, 150.0],
            curvature_per_m: vec![0.0, 0.0, 0.002, 0.002, 0.0],
            cant_angle_rad: vec![0.0; 5],
            gradient: vec![0.0; 5],
            speed_limit: vec![],
        },
        limits: LimitFacts::default(),
        step_s: 1e-3,
        threads: 2,
        wall_time_s: Some(4.0),
        energy: vec![EnergyLine { name: "energy.traction".to_owned(), joules: 1.5e6 }],
    }
}
