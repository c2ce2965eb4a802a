use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use super::*;

const STEPS: usize = 2000;
const STEPS_PER_RECORD: usize = 100;

fn columns() -> Vec<Column> {
    vec![
        Column::new("position", "m", "Chainage").double(),
        Column::new("force", "N", "Coupler force").extremes(),
    ]
}

/// A position that needs all digits, and a force that swings faster than it is recorded.
fn values(row: usize, step: usize) -> [f64; 2] {
    let time = step as f64 * 1e-3;
    let force = 1e5 * (row + 1) as f64 * (time * 40.0).sin();
    [1000.0 + 16.67 * time - 20.0 * row as f64, force]
}

fn begin(folder: &Path) -> SeriesWriter {
    SeriesWriter::create(folder, "vehicles", vehicle_keys(3), columns(), 10).unwrap()
}

fn step_through(writer: &mut SeriesWriter, steps: usize) {
    step_from(writer, 0, steps);
}

fn step_from(writer: &mut SeriesWriter, first: usize, last: usize) {
    for step in first..=last {
        for row in 0..writer.rows() {
            writer.observe(row, &values(row, step));
        }
        if step % STEPS_PER_RECORD == 0 {
            writer.record(step as f64 * 1e-3).unwrap();
        }
    }
}

fn run(folder: &Path) {
    let mut writer = begin(folder);
    step_through(&mut writer, STEPS);
    writer.finish().unwrap();
}

fn contents(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let files = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    files
        .map(|file| (file.strip_prefix(folder).unwrap().to_owned(), fs::read(&file).unwrap()))
        .collect()
}

#[test]
fn two_columns_of_one_name_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["time", "vehicle", "force_max"] {
        let columns = [columns(), vec![Column::new(name, "1", "Another")]].concat();
        let table = SeriesWriter::create(folder.path(), "vehicles", vehicle_keys(3), columns, 10);
        let message = table.err().expect("the names clash").to_string();
        assert!(message.contains("table vehicles") && message.contains(name), "{message}");
    }
}

#[test]
fn property_what_is_recorded_is_read_back() {
    let folder = tempfile::tempdir().unwrap();
    run(folder.path());
    let reader = SeriesReader::open(folder.path(), "vehicles").unwrap();

    let third = [("vehicle", KeyValue::Integer(3))];
    let instants: Vec<usize> = (0..=STEPS).step_by(STEPS_PER_RECORD).collect();
    let times: Vec<f64> = instants.iter().map(|&step| step as f64 * 1e-3).collect();
    assert_eq!(reader.read("time", &third).unwrap(), times);
    let positions: Vec<f64> = instants.iter().map(|&step| values(2, step)[0]).collect();
    assert_eq!(reader.read("position", &third).unwrap(), positions, "kept in double precision");
    let forces: Vec<f64> =
        instants.iter().map(|&step| f64::from(values(2, step)[1] as f32)).collect();
    assert_eq!(reader.read("force", &third).unwrap(), forces, "kept in single precision");
    assert_eq!(reader.read("vehicle", &[]).unwrap().len(), 3 * instants.len());
    assert!(reader.read("force", &[("vehicle", KeyValue::Text("3"))]).unwrap().is_empty());
}

/// The extremes of a record are those of all steps since the record before, both included.
#[test]
fn property_extremes_between_records_are_kept() {
    let folder = tempfile::tempdir().unwrap();
    run(folder.path());
    let reader = SeriesReader::open(folder.path(), "vehicles").unwrap();
    let first = [("vehicle", KeyValue::Integer(1))];
    let lowest = reader.read("force_min", &first).unwrap();
    let highest = reader.read("force_max", &first).unwrap();
    for record in 1..lowest.len() {
        let steps = (record - 1) * STEPS_PER_RECORD..=record * STEPS_PER_RECORD;
        let forces = steps.map(|step| values(0, step)[1] as f32);
        let (low, high) = forces
            .fold((f32::MAX, f32::MIN), |(low, high), force| (low.min(force), high.max(force)));
        assert_eq!((lowest[record], highest[record]), (low.into(), high.into()));
    }
}

/// A killed run never comes to `finish`, and may leave a half-written hidden file.
#[test]
fn property_a_killed_run_leaves_every_complete_second() {
    let folder = tempfile::tempdir().unwrap();
    let mut writer = begin(folder.path());
    step_through(&mut writer, STEPS);
    drop(writer);
    let half = folder.path().join("vehicles.parts/.part-00002.parquet");
    fs::write(half, b"PAR1 cut short").unwrap();

    let reader = SeriesReader::open(folder.path(), "vehicles").unwrap();
    let times = reader.read("time", &[("vehicle", KeyValue::Integer(2))]).unwrap();
    assert_eq!(times.len(), 20, "2 parts of 10 records; the 21st record was not yet written");
    assert_eq!(times[19], 1900.0 * 1e-3);
}

/// A run whose program died is completed to the bytes of one that ended there: in the middle of a
/// part, at the end of one, and before the first.
#[test]
fn property_a_completed_run_has_every_record() {
    for steps in [2000, 1900, 300] {
        let folders = [tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap()];
        let mut died = begin(folders[0].path());
        step_through(&mut died, steps);
        drop(died);
        complete(folders[0].path(), false).unwrap();
        let mut ended = begin(folders[1].path());
        step_through(&mut ended, steps);
        ended.finish().unwrap();
        let read = |folder: &Path| {
            let reader = SeriesReader::open(folder, "vehicles").unwrap();
            ["time", "position", "force"].map(|column| reader.read(column, &[]).unwrap())
        };
        assert_eq!(read(folders[0].path()), read(folders[1].path()), "{steps} steps");
        let files = contents(folders[0].path());
        assert_eq!(files.keys().collect::<Vec<_>>(), [Path::new("vehicles.parquet")]);
    }
}

/// A record that the death of the program cut short is left out.
#[test]
fn property_a_record_that_is_not_whole_is_passed_over() {
    let folder = tempfile::tempdir().unwrap();
    let mut writer = begin(folder.path());
    step_through(&mut writer, 300);
    drop(writer);
    let open = folder.path().join("vehicles.parts/.open.arrows");
    let bytes = fs::read(&open).unwrap();
    fs::write(&open, &bytes[..bytes.len() - 100]).unwrap();
    complete(folder.path(), false).unwrap();
    let reader = SeriesReader::open(folder.path(), "vehicles").unwrap();
    let times = reader.read("time", &[("vehicle", KeyValue::Integer(1))]).unwrap();
    assert_eq!(times, [0.0, 0.1, 0.2]);
}

/// Another run goes on with a table from the middle of its second part, and of an interval, and from the end
/// of that part: with that of a run that was killed later, and of one that has ended. One that ends before is
/// refused.
#[test]
fn property_a_table_goes_on_byte_for_byte() {
    let unbroken = tempfile::tempdir().unwrap();
    run(unbroken.path());
    let (second, both) =
        ([".open.arrows", "part-00000.parquet"], ["part-00000.parquet", "part-00001.parquet"]);
    for (ended, until, left) in
        [(false, 1550, second), (true, 1550, second), (false, 1950, both), (true, 1950, both)]
    {
        let folder = tempfile::tempdir().unwrap();
        let mut writer = begin(folder.path());
        step_through(&mut writer, until);
        let bytes = postcard::to_allocvec(&writer.save()).unwrap();
        let saved = || postcard::from_bytes(&bytes).unwrap();
        step_from(&mut writer, until + 1, STEPS);
        match ended {
            true => writer.finish().unwrap(),
            false => drop(writer),
        }
        let mut resumed = begin(folder.path());
        resumed.resume(saved()).unwrap();
        let parts: Vec<_> = contents(&folder.path().join("vehicles.parts")).into_keys().collect();
        assert_eq!(parts, left.map(Path::new));
        step_from(&mut resumed, until + 1, STEPS);
        resumed.finish().unwrap();
        assert!(contents(folder.path()) == contents(unbroken.path()), "ended: {ended}");

        let empty = tempfile::tempdir().unwrap();
        let refused = begin(empty.path()).resume(saved()).unwrap_err().to_string();
        assert!(refused.contains("vehicles: the table ends before"), "{refused}");
    }
}

/// A part whose pages are damaged gives one error, and the run's other files stay as they are.
#[test]
fn a_damaged_part_is_answered_once() {
    let folder = tempfile::tempdir().unwrap();
    let mut writer = begin(folder.path());
    step_through(&mut writer, 1500);
    drop(writer);
    let part = folder.path().join("vehicles.parts/part-00000.parquet");
    let mut bytes = fs::read(&part).unwrap();
    bytes[10..200].fill(0xff);
    fs::write(&part, bytes).unwrap();
    let message = complete(folder.path(), false).unwrap_err().to_string();
    assert!(message.contains("vehicles.parts"), "{message}");
    assert!(part.exists());
}

/// Lengths in a damaged record may be any; the records before it are kept.
#[test]
fn a_damaged_record_ends_the_open_stream() {
    let folder = tempfile::tempdir().unwrap();
    let mut writer = begin(folder.path());
    step_through(&mut writer, 300);
    drop(writer);
    let open = folder.path().join("vehicles.parts/.open.arrows");
    let kept = fs::read(&open).unwrap();
    for begin in (kept.len() / 2..kept.len() - 8).step_by(64) {
        let mut bytes = kept.clone();
        bytes[begin..begin + 8].fill(0x7f);
        fs::write(&open, bytes).unwrap();
        let found = open_part::left_records(&folder.path().join("vehicles.parts"));
        assert!(found.is_none_or(|(_, records)| records.len() <= 4));
    }
}

#[test]
fn property_identical_runs_give_identical_bytes() {
    let folders = [tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap()];
    for folder in &folders {
        run(folder.path());
    }
    let [one, other] = folders.each_ref().map(|folder| contents(folder.path()));
    assert_eq!(one.keys().collect::<Vec<_>>(), [Path::new("vehicles.parquet")]);
    assert!(one == other, "the files differ");
}

#[test]
fn columns_carry_unit_and_description() {
    let folder = tempfile::tempdir().unwrap();
    run(folder.path());
    let reader = SeriesReader::open(folder.path(), "vehicles").unwrap();
    let described: Vec<_> = reader
        .columns()
        .map(|field| (field.name().as_str(), field.metadata()["unit"].as_str()))
        .collect();
    let wanted = [
        ("time", "s"),
        ("vehicle", "1"),
        ("position", "m"),
        ("force", "N"),
        ("force_min", "N"),
        ("force_max", "N"),
    ];
    assert_eq!(described, wanted);
    let lowest = reader.columns().nth(4).unwrap();
    assert_eq!(lowest.metadata()["description"], "Coupler force, lowest since the last record");
}

#[test]
fn a_new_run_replaces_the_tables_of_an_earlier_one() {
    let folder = tempfile::tempdir().unwrap();
    run(folder.path());
    let mut writer = begin(folder.path());
    step_through(&mut writer, 1000);
    drop(writer);
    let reader = SeriesReader::open(folder.path(), "vehicles").unwrap();
    assert_eq!(reader.read("time", &[]).unwrap().len(), 3 * 10);
}

#[test]
fn the_wheels_of_a_vehicle_are_told_apart() {
    let folder = tempfile::tempdir().unwrap();
    let rows = [(7, 1, Side::Left), (7, 1, Side::Right), (7, 2, Side::Left)];
    let mut writer =
        SeriesWriter::create(folder.path(), "wheels", wheel_keys(&rows), WheelRow::columns(), 1)
            .unwrap();
    for row in 0..writer.rows() {
        let wheel = WheelRow { force_normal: 1000.0 * row as f64, ..WheelRow::default() };
        writer.observe(row, &wheel.values());
    }
    writer.record(0.0).unwrap();
    writer.finish().unwrap();

    let reader = SeriesReader::open(folder.path(), "wheels").unwrap();
    let wheel = [("wheelset", KeyValue::Integer(1)), ("side", KeyValue::Text("right"))];
    assert_eq!(reader.read("force_normal", &wheel).unwrap(), [1000.0]);
}

#[test]
fn errors_name_what_is_missing_and_what_there_is() {
    let folder = tempfile::tempdir().unwrap();
    let missing = SeriesReader::open(folder.path(), "vehicles").unwrap_err();
    assert!(missing.to_string().ends_with("no run has recorded it there"));

    run(folder.path());
    let reader = SeriesReader::open(folder.path(), "vehicles").unwrap();
    let unknown = reader.read("velocity", &[]).unwrap_err().to_string();
    assert!(unknown.ends_with(
        "has no column velocity; it has time, vehicle, position, force, force_min, force_max"
    ));

    let mut keys = vehicle_keys(3);
    keys.extend(wheel_keys(&[(1, 1, Side::Left)]));
    let uneven = SeriesWriter::create(folder.path(), "wheels", keys, vec![], 1).err().unwrap();
    assert_eq!(
        uneven.to_string(),
        "table wheels: key vehicle has 1 values where the keys before have 3"
    );
}
