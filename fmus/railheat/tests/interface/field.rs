//! The store of the temperature field, and saved states.

use std::fs;

use field::FieldReader;

use crate::bench::Bench;

#[test]
fn property_the_field_file_holds_the_run() {
    let mut bench = Bench::of_paper();
    let path = bench.folder.path().join("rail.zarr");
    bench.set_texts(&[("field_file", path.to_str().unwrap())]);
    bench.set("field_interval", 0.2);
    bench.start().unwrap();
    bench.steps(0, 50);
    let reader = FieldReader::open(&path).unwrap();
    let times = reader.times();
    assert_eq!(times.len(), 3);
    assert!((times[2] - 0.4).abs() < 1e-12);
    assert!(reader.at_time(0.0).unwrap().rise.iter().all(|rise| *rise == 0.0));
    let axes = reader.axes();
    assert_eq!((axes.chainage.len(), axes.depth.len()), (1000, 34));
    let snapshot = reader.at_time(0.4).unwrap().rise;
    let at_probe = snapshot[300 * 34];
    assert!(at_probe > 1.0, "30.05 m was passed after 0.12 s: {at_probe}");
}

/// What a field that can no longer be written does to the run is the user's choice.
#[test]
fn a_field_that_cannot_be_written_stops_the_run_or_not() {
    for (choice, goes_on) in [("stop", false), ("go_on", true)] {
        let mut bench = Bench::of_paper();
        let path = bench.folder.path().join("rail.zarr");
        bench.set_texts(&[("field_file", path.to_str().unwrap()), ("field_failure", choice)]);
        bench.set("field_interval", 0.02);
        bench.start().unwrap();
        bench.instance.set_debug_logging(true, &[]).unwrap();
        fs::remove_dir_all(&path).unwrap();
        fs::write(&path, "a file where the store was").unwrap();
        let result = bench.step(0.0, 0.02, 28.0);
        assert_eq!(result.is_ok(), goes_on, "{choice}: {result:?}");
        if goes_on {
            bench.step(0.02, 0.02, 28.3).unwrap();
        }
        let messages = bench.messages.lock().unwrap().clone();
        let warnings = messages.iter().filter(|text| text.contains("goes on without")).count();
        assert_eq!(warnings, usize::from(goes_on), "{messages:?}");
    }
}

/// A folder that can never be made, as on a disk that is read-only.
#[test]
fn a_field_that_cannot_begin_stops_the_run_or_not() {
    for (choice, goes_on) in [("stop", false), ("go_on", true)] {
        let mut bench = Bench::of_paper();
        bench.instance.set_debug_logging(true, &[]).unwrap();
        bench.set_texts(&[("field_file", "/proc/no/rail.zarr"), ("field_failure", choice)]);
        let result = bench.start();
        assert_eq!(result.is_ok(), goes_on, "{choice}: {result:?}");
        if let Err(sentence) = result {
            assert!(sentence.contains("/proc/no/rail.zarr"), "{sentence}");
            continue;
        }
        bench.step(0.0, 0.02, 28.0).unwrap();
        let messages = bench.messages.lock().unwrap().clone();
        let warnings = messages.iter().filter(|text| text.contains("goes on without")).count();
        assert_eq!(warnings, 1, "{messages:?}");
    }
}

/// The state goes on bit for bit; the file stays as it is until the run is past its last snapshot.
#[test]
fn property_a_restored_run_gives_the_same_and_appends_later() {
    let mut bench = Bench::of_paper();
    let path = bench.folder.path().join("rail.zarr");
    bench.set_texts(&[("field_file", path.to_str().unwrap())]);
    bench.set("field_interval", 0.2);
    bench.start().unwrap();
    bench.steps(0, 10);
    let bytes = bench.instance.save().unwrap().to_bytes();
    bench.steps(10, 50);
    let wanted = bench.get("energy.stored");
    let state = bench.instance.deserialize_state(&bytes).unwrap();
    bench.instance.restore(&state).unwrap();
    bench.steps(10, 50);
    assert_eq!(bench.get("energy.stored"), wanted);
    assert_eq!(FieldReader::open(&path).unwrap().times().len(), 3);
    bench.steps(50, 65);
    assert_eq!(FieldReader::open(&path).unwrap().times().len(), 4);
}

/// With the energy model the field has the section at each probe, and it goes on with a restored run.
#[test]
fn property_the_field_has_the_sections_of_the_probes() {
    let mut bench = Bench::new();
    let path = bench.folder.path().join("rail.zarr");
    bench.set_texts(&[("field_file", path.to_str().unwrap())]);
    bench.set("field_interval", 1.0);
    bench.set("section.cell_size", 0.012);
    bench.start().unwrap();
    for wheel in ["vehicle[1].wheelset[1]", "vehicle[1].wheelset[2]", "vehicle[2].wheelset[1]"] {
        bench.set(&format!("{wheel}.friction_power"), 1667.0);
        bench.set(&format!("{wheel}.contact.lateral_position"), 0.01);
    }
    bench.steps(0, 150);
    let bytes = bench.instance.save().unwrap().to_bytes();
    bench.steps(150, 210);
    let reader = || FieldReader::open(&path).unwrap();
    let sections = reader().axes().sections.clone().expect("the plane section is kept");
    assert!((sections.chainage[0] - 30.05).abs() < 1e-9);
    let found = reader().sections_at_time(2.0).unwrap();
    assert_eq!(found.len(), sections.values());
    let warmest = reader().warmest_at_time(2.0).unwrap().expect("the plane section is there");
    assert_eq!(warmest.rise.len(), sections.y.len());
    assert!(warmest.rise.iter().any(|rise| *rise > 0.01), "{:?}", warmest.rise);
    let heat = |side: f64| -> f64 {
        let cells = sections.y.iter().zip(&sections.area).zip(&found);
        let of_side = cells.filter(|((y, _), _)| side * **y > 1e-3);
        of_side.map(|((_, area), rise)| area * f64::from(*rise)).sum()
    };
    assert!(heat(-1.0) > 1.2 * heat(1.0), "on the left rail the field side is the left one");
    let state = bench.instance.deserialize_state(&bytes).unwrap();
    bench.instance.restore(&state).unwrap();
    bench.steps(150, 210);
    assert_eq!(reader().sections_at_time(2.0).unwrap(), found);
    assert_eq!(reader().warmest_at_time(2.0).unwrap(), Some(warmest));
    assert_eq!(reader().times().len(), 3);
}

/// The section where the foot is warmest is that of the element that the outputs name: its lowest cells in the
/// middle have the foot's rise, less than 1 % higher on cells of 6 mm than the parabola at the underside.
#[test]
fn property_the_warmest_section_is_where_the_outputs_say() {
    let mut bench = Bench::new();
    let path = bench.folder.path().join("rail.zarr");
    bench.set_texts(&[("field_file", path.to_str().unwrap())]);
    bench.set("field_interval", 100.0);
    bench.set("section.cell_size", 0.006);
    bench.start().unwrap();
    let reader = || FieldReader::open(&path).unwrap();
    assert!((reader().warmest_at_time(0.0).unwrap().unwrap().chainage - 0.05).abs() < 1e-9);
    bench.set("vehicle[1].wheelset[1].friction_power", 5e4);
    bench.steps(0, 100);
    for wheel in ["vehicle[1].wheelset[1]", "vehicle[1].wheelset[2]", "vehicle[2].wheelset[1]"] {
        bench.set(&format!("{wheel}.friction_power"), 0.0);
        bench.set(&format!("{wheel}.force.normal"), 0.0);
    }
    bench.instance.do_step(1.0, 199.0).unwrap();
    let sections = reader().axes().sections.clone().unwrap();
    let warmest = reader().warmest_at_time(200.0).unwrap().unwrap();
    assert_eq!(warmest.chainage, bench.get("foot.present.chainage"));
    let lowest = sections.z.iter().copied().fold(0.0, f64::max);
    let cells = sections.y.iter().zip(&sections.z).zip(&warmest.rise);
    let foot = cells.filter(|((y, z), _)| **z == lowest && y.abs() < 0.006);
    let (count, sum) =
        foot.fold((0.0, 0.0), |(n, sum), (_, rise)| (n + 1.0, sum + f64::from(*rise)));
    let (found, wanted) = (sum / count, bench.get("highest.foot.rise"));
    assert!(wanted > 1e-3 && (found / wanted - 1.0).abs() < 0.01, "{found} of {wanted} K");
}
