//! What a field must hold on disk.

mod sections;

use std::fs;
use std::path::{Path, PathBuf};

use field::{Attribute, Axes, FieldError, FieldReader, FieldWriter, SectionRises};

/// More elements than one chunk has, and not a multiple of it.
fn axes() -> Axes {
    Axes {
        chainage: (0..2500).map(|i| 300.05 + 0.1 * f64::from(i)).collect(),
        depth: (0..5).map(|j| 0.0025 + 0.005 * f64::from(j)).collect(),
        sections: None,
    }
}

/// A value that is another in every cell: 0.1 mK steps, which f32 must keep.
fn rise(axes: &Axes, snapshot: usize) -> Vec<f32> {
    (0..axes.values()).map(|i| (snapshot as f32) + 1e-4 * i as f32).collect()
}

fn create(path: &Path) -> FieldWriter {
    let attributes = [
        ("title", Attribute::from("left rail")),
        ("initial_temperature_K", Attribute::from(293.15)),
    ];
    FieldWriter::create(path, &axes(), &attributes).unwrap()
}

/// A field with a second snapshot whose time is visible and whose values are not, as a writer leaves it that
/// is killed within an append.
fn half_appended(folder: &Path) -> PathBuf {
    let path = folder.join("rail.zarr");
    let mut writer = create(&path);
    writer.append(0.0, &rise(&axes(), 0), &SectionRises::default()).unwrap();
    let before = fs::read(path.join("temperature_rise/zarr.json")).unwrap();
    writer.append(1.0, &rise(&axes(), 1), &SectionRises::default()).unwrap();
    fs::write(path.join("temperature_rise/zarr.json"), before).unwrap();
    path
}

fn metadata(path: &Path) -> serde_json::Value {
    serde_json::from_str(&fs::read_to_string(path.join("zarr.json")).unwrap()).unwrap()
}

/// The group's copy of the metadata says what those of the arrays say.
fn assert_consolidated(path: &Path) {
    let copies = &metadata(path)["consolidated_metadata"]["metadata"];
    for array in ["chainage", "depth", "temperature_rise", "time"] {
        assert_eq!(copies[array], metadata(&path.join(array)), "{array}");
    }
}

/// A reader that trusts the copy sees every snapshot, while the field grows and after it was completed.
#[test]
fn property_the_copy_of_the_metadata_is_always_right() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("rail.zarr");
    let mut writer = create(&path);
    assert_consolidated(&path);
    for snapshot in 0..2 {
        writer.append(snapshot as f64, &rise(&axes(), snapshot), &SectionRises::default()).unwrap();
        assert_consolidated(&path);
    }
    drop(writer);
    FieldWriter::resume(&path, 1).unwrap();
    assert_consolidated(&path);
    let other = tempfile::tempdir().unwrap();
    let path = half_appended(other.path());
    field::complete(&path).unwrap();
    assert_consolidated(&path);
}

#[test]
fn property_what_is_written_is_read_to_the_last_bit() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("rail.zarr");
    let mut writer = create(&path);
    for snapshot in 0..3 {
        writer
            .append(10.0 * snapshot as f64, &rise(&axes(), snapshot), &SectionRises::default())
            .unwrap();
    }
    let reader = FieldReader::open(&path).unwrap();
    assert_eq!(reader.axes(), &axes());
    assert_eq!(reader.times(), [0.0, 10.0, 20.0]);
    let nearest = reader.at_time(11.0).unwrap();
    assert_eq!(nearest.time, 10.0);
    assert_eq!(nearest.rise, rise(&axes(), 1));
    assert_eq!(reader.at_time(1e9).unwrap().rise, rise(&axes(), 2));
}

/// A writer that was killed after its time had become visible and before its snapshot had: other readers
/// refuse a field with more times than snapshots.
#[test]
fn a_field_that_was_cut_within_an_append_is_completed() {
    let folder = tempfile::tempdir().unwrap();
    let path = half_appended(folder.path());
    let snapshots = |array: &str| metadata(&path.join(array))["shape"][0].as_u64().unwrap();
    assert_eq!((snapshots("time"), snapshots("temperature_rise")), (2, 1));
    field::complete(&path).unwrap();
    assert_eq!((snapshots("time"), snapshots("temperature_rise")), (1, 1));
    assert_eq!(FieldReader::open(&path).unwrap().times(), [0.0]);
}

/// A process that is killed runs no destructor: the writer is forgotten, not dropped.
#[test]
fn property_a_killed_run_leaves_all_appended_snapshots() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("rail.zarr");
    let mut writer = create(&path);
    for snapshot in 0..2 {
        writer.append(snapshot as f64, &rise(&axes(), snapshot), &SectionRises::default()).unwrap();
        let reader = FieldReader::open(&path).unwrap();
        assert_eq!(reader.times().len(), snapshot + 1, "readable while it is written");
    }
    std::mem::forget(writer);
    let reader = FieldReader::open(&path).unwrap();
    assert_eq!(reader.at_time(1.0).unwrap().rise, rise(&axes(), 1));
}

/// The kill comes between the steps of an append: values are there, shapes not or half grown.
#[test]
fn property_a_half_appended_snapshot_is_not_seen() {
    let folder = tempfile::tempdir().unwrap();
    let path = half_appended(folder.path());
    let reader = FieldReader::open(&path).unwrap();
    assert_eq!(reader.times(), [0.0]);
    assert_eq!(reader.at_time(1.0).unwrap().rise, rise(&axes(), 0));
}

/// A field that goes on behind some of its snapshots is, byte for byte, one that was written at once.
#[test]
fn property_a_field_goes_on_as_if_it_had_never_stopped() {
    let folder = tempfile::tempdir().unwrap();
    let [once, twice] = ["once.zarr", "twice.zarr"].map(|name| folder.path().join(name));
    let append = |writer: &mut FieldWriter, from: usize, to: usize| {
        for snapshot in from..to {
            writer
                .append(snapshot as f64, &rise(&axes(), snapshot), &SectionRises::default())
                .unwrap();
        }
    };
    append(&mut create(&once), 0, 4);
    append(&mut create(&twice), 0, 6);
    let mut resumed = FieldWriter::resume(&twice, 2).unwrap();
    assert_eq!(FieldReader::open(&twice).unwrap().times(), [0.0, 1.0]);
    assert_eq!(resumed.last_time(), Some(1.0));
    append(&mut resumed, 2, 4);
    assert_eq!(files(&once), files(&twice));
    let refused = FieldWriter::resume(&twice, 5).err().unwrap().to_string();
    assert!(refused.contains("has 4 snapshots") && refused.contains("written 5"), "{refused}");
}

/// All files below a folder with their bytes.
fn files(folder: &Path) -> Vec<(PathBuf, Vec<u8>)> {
    let mut found = vec![];
    let mut folders = vec![folder.to_owned()];
    while let Some(next) = folders.pop() {
        for entry in fs::read_dir(next).unwrap() {
            let path = entry.unwrap().path();
            match path.is_dir() {
                true => folders.push(path),
                false => {
                    let name = path.strip_prefix(folder).unwrap().to_owned();
                    found.push((name, fs::read(&path).unwrap()));
                }
            }
        }
    }
    found.sort();
    found
}

/// A store that is removed while it is written is not begun again in halves.
#[test]
fn property_a_store_that_is_gone_stays_gone() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("rail.zarr");
    let mut writer = create(&path);
    writer.append(0.0, &rise(&axes(), 0), &SectionRises::default()).unwrap();
    fs::remove_dir_all(&path).unwrap();
    let refused = writer.append(1.0, &rise(&axes(), 1), &SectionRises::default()).unwrap_err();
    assert!(matches!(refused, FieldError::Gone { .. }), "{refused}");
    assert!(refused.to_string().contains("rail.zarr: is no longer there"), "{refused}");
    assert!(!path.exists());
}

#[test]
fn property_the_store_describes_itself() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("rail.zarr");
    create(&path).append(0.0, &rise(&axes(), 0), &SectionRises::default()).unwrap();
    let group = metadata(&path);
    assert_eq!(group["zarr_format"], 3);
    assert_eq!(group["attributes"]["initial_temperature_K"], 293.15);
    let field = metadata(&path.join("temperature_rise"));
    assert_eq!(field["shape"], serde_json::json!([1, 2500, 5]));
    assert_eq!(field["data_type"], "float32");
    assert_eq!(field["attributes"]["units"], "K");
    assert_eq!(field["dimension_names"], serde_json::json!(["time", "chainage", "depth"]));
    assert_eq!(metadata(&path.join("depth"))["attributes"]["positive"], "down");
}

#[test]
fn property_an_older_field_is_replaced_and_nothing_else() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("rail.zarr");
    create(&path).append(5.0, &rise(&axes(), 0), &SectionRises::default()).unwrap();
    create(&path);
    assert!(FieldReader::open(&path).unwrap().times().is_empty());

    let foreign = folder.path().join("thesis");
    fs::create_dir(&foreign).unwrap();
    fs::write(foreign.join("chapter1.txt"), "precious").unwrap();
    let refused = FieldWriter::create(&foreign, &axes(), &[]).err().unwrap();
    assert!(matches!(refused, FieldError::Occupied { .. }));
    assert!(refused.to_string().contains("thesis"));
    assert!(foreign.join("chapter1.txt").exists());
}

#[test]
fn wrong_snapshots_are_refused_and_the_earlier_ones_stay() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("rail.zarr");
    let mut writer = create(&path);
    writer.append(2.0, &rise(&axes(), 0), &SectionRises::default()).unwrap();
    let size = writer.append(3.0, &[0.0; 7], &SectionRises::default()).unwrap_err();
    assert!(matches!(size, FieldError::Size { found: 7, wanted: 12500, .. }));
    let late = writer.append(2.0, &rise(&axes(), 1), &SectionRises::default()).unwrap_err();
    assert!(matches!(late, FieldError::NotLater { .. }));
    assert_eq!(FieldReader::open(&path).unwrap().times(), [2.0]);
}

#[test]
fn missing_stores_and_unwritable_places_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let missing = folder.path().join("nowhere.zarr");
    let error = FieldReader::open(&missing).err().unwrap();
    assert!(error.to_string().contains("nowhere.zarr"), "{error}");
    let file = folder.path().join("file");
    fs::write(&file, "not a folder").unwrap();
    let error = FieldWriter::create(&file.join("rail.zarr"), &axes(), &[]).err().unwrap();
    assert!(error.to_string().contains("rail.zarr"), "{error}");
    let path = folder.path().join("rail.zarr");
    create(&path);
    let error = FieldReader::open(&path).unwrap().at_time(0.0).unwrap_err();
    assert!(matches!(error, FieldError::NoSnapshot { .. }));
}

/// Metadata that was damaged must cost neither memory nor the program.
#[test]
fn a_field_whose_arrays_have_another_shape_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("rail.zarr");
    create(&path).append(0.0, &rise(&axes(), 0), &SectionRises::default()).unwrap();
    let chainage = path.join("chainage");
    let mut long = metadata(&chainage);
    long["shape"] = serde_json::json!([100_000_000_000_000_u64]);
    let kept = fs::read(chainage.join("zarr.json")).unwrap();
    fs::write(chainage.join("zarr.json"), long.to_string()).unwrap();
    let message = FieldReader::open(&path).err().unwrap().to_string();
    let wanted = "array /chainage has 100000000000000 values; it must have 10000000 at most";
    assert!(message.contains(wanted), "{message}");
    let rise = path.join("temperature_rise/zarr.json");
    fs::write(rise, &kept).unwrap();
    fs::write(chainage.join("zarr.json"), kept).unwrap();
    for error in [FieldReader::open(&path).err(), field::complete(&path).err()] {
        let message = error.unwrap().to_string();
        let wanted = "array /temperature_rise must have 3 dimensions, not 1";
        assert!(message.contains(wanted), "{message}");
    }
}
