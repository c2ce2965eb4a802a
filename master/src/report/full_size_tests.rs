//! The page of a run of full size stays small: 130 vehicles, records that fill every curve, two rails.

use std::fs;
use std::path::Path;

use field::{Axes, FieldWriter, SectionRises, Sections};
use track::SpeedLimit;

use super::instrument::OF_TRAIN;
use super::invented::{facts, write_run};
use super::{RunFacts, TrackFacts, write};
use crate::recording::{
    Column, Key, SeriesWriter, Side, VehicleRow, WheelRow, vehicle_keys, vehicle_keys_of,
    wheel_keys,
};

const VEHICLES: usize = 130;
/// As many as the longest curve of such a page has room for: of more records it shows fewer than all.
const RECORDS: u32 = 350;
const RECORDED: [usize; 5] = [1, 2, 3, 66, 130];

/// What is packed takes the same room whatever it is, so that a sine does for all.
fn write_table(series: &Path, name: &str, keys: Vec<Key>, columns: Vec<Column>, rows: usize) {
    let count = columns.len();
    let mut writer = SeriesWriter::create(series, name, keys, columns, 100).unwrap();
    for record in 0..RECORDS {
        let values = vec![f64::from(record).sin(); count];
        (0..rows).for_each(|row| writer.observe(row, &values));
        writer.record(0.1 * f64::from(record)).unwrap();
    }
    writer.finish().unwrap();
}

/// A field of more elements and snapshots than a page shows, with sections at three probes.
fn write_field(store: &Path) {
    let cells = 1316;
    let axes = Axes {
        chainage: (0..480).map(f64::from).collect(),
        depth: (0..69).map(|i| 2.5e-3 * (f64::from(i) + 0.5)).collect(),
        sections: Some(Sections {
            chainage: vec![20.0, 40.0, 60.0],
            y: (0..cells).map(|i| 1e-3 * f64::from(i % 50)).collect(),
            z: (0..cells).map(|i| 1e-3 * f64::from(i / 50)).collect(),
            area: vec![1e-6; cells as usize],
        }),
    };
    let rise = vec![0.1; axes.values()];
    let sections = SectionRises {
        kept: vec![0.2; 3 * cells as usize],
        warmest: vec![0.3; cells as usize],
        warmest_chainage: 30.0,
    };
    let mut writer = FieldWriter::create(store, &axes, &[]).unwrap();
    for time in 0..40 {
        writer.append(5.0 * f64::from(time), &rise, &sections).unwrap();
    }
}

#[test]
fn property_the_page_of_a_run_of_full_size_is_small() {
    let folder = tempfile::tempdir().unwrap();
    let limit = |from: u32| SpeedLimit {
        from_m: f64::from(from),
        to_m: f64::from(from + 1),
        speed_m_per_s: 20.0,
    };
    let facts = RunFacts {
        vehicles: VEHICLES,
        plotted: RECORDED.to_vec(),
        outputs: vec!["output[*]".to_owned()],
        heat_maps_at_s: vec![10.0, 60.0, 110.0, 160.0],
        track: TrackFacts { speed_limit: (0..50).map(limit).collect(), ..TrackFacts::default() },
        ..facts()
    };
    write_run(folder.path(), &facts);
    let series = folder.path().join("series");
    for name in ["train", "vehicles"] {
        fs::remove_file(series.join(format!("{name}.parquet"))).unwrap();
    }
    let of_train = OF_TRAIN.map(|name| Column::new(name, "1", "Test")).to_vec();
    write_table(&series, "train", vec![], of_train, 1);
    let keys = vehicle_keys(VEHICLES);
    write_table(&series, "vehicles", keys, VehicleRow::columns(), VEHICLES);
    let wheels: Vec<(usize, usize, Side)> = RECORDED
        .into_iter()
        .flat_map(|vehicle| (1..=6).map(move |wheelset| (vehicle, wheelset)))
        .flat_map(|(vehicle, set)| [Side::Left, Side::Right].map(|side| (vehicle, set, side)))
        .collect();
    write_table(&series, "wheels", wheel_keys(&wheels), WheelRow::columns(), wheels.len());
    let output = |i| Column::new(&format!("output[{i}]"), "N", "Test").mean().extremes();
    let outputs = (0..30).map(output).collect();
    write_table(&series, "outputs", vehicle_keys_of(RECORDED), outputs, RECORDED.len());
    for store in ["rail-left.zarr", "rail-right.zarr"] {
        write_field(&folder.path().join(store));
    }
    let (file, _) = write(folder.path()).unwrap();
    let size = fs::metadata(file).unwrap().len();
    println!("{size} bytes");
    assert!((1_300_000..2_000_000).contains(&size), "{size} bytes");
}
