//! The rail heat as an FMU: names, files, messages, saved states.

use std::fs;
use std::path::Path;
use std::sync::{Arc, Mutex};

use field::FieldReader;
use fmu::{Instance, Kind};
use railheat::RailHeat;

const FILE: &str = "wheelsets_per_vehicle = [2, 1]\ndepths_mm = [20.0, 60.0]\n\
                    [[probe]]\nchainage_m = 30.05\n";

/// An FMU with its messages; files in a folder of its own.
struct Bench {
    instance: Instance<RailHeat>,
    messages: Arc<Mutex<Vec<String>>>,
    folder: tempfile::TempDir,
}

impl Bench {
    fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("railheat.toml"), FILE).unwrap();
        let messages = Arc::new(Mutex::new(Vec::new()));
        let sink = messages.clone();
        let keep = Box::new(move |_, message: &str| sink.lock().unwrap().push(message.to_owned()));
        let mut instance = Instance::new(folder.path(), "left rail", keep).unwrap();
        instance.setup_experiment(0.0, None).unwrap();
        let mut bench = Self { instance, messages, folder };
        bench.set("track.length", 100.0);
        bench
    }

    fn reference(&self, name: &str) -> u32 {
        let variables = self.instance.declaration().variables();
        let found = variables.iter().find(|variable| variable.name == name);
        found.unwrap_or_else(|| panic!("no variable {name}")).reference
    }

    fn set(&mut self, name: &str, value: f64) {
        let reference = self.reference(name);
        self.instance.set_real(&[reference], [value]).unwrap();
    }

    fn set_texts(&mut self, texts: &[(&str, &str)]) {
        for (name, text) in texts {
            let reference = self.reference(name);
            self.instance.set_string(&[reference], [*text]).unwrap();
        }
    }

    fn get(&mut self, name: &str) -> f64 {
        let reference = self.reference(name);
        self.instance.get_real(&[reference]).unwrap().next().unwrap()
    }

    fn start(&mut self) -> Result<(), String> {
        self.instance.enter_initialization_mode().map_err(|error| error.to_string())?;
        self.instance.exit_initialization_mode().map_err(|error| chain(&error))
    }

    /// One step in which all wheels end at these chainages.
    fn step(&mut self, start: f64, length: f64, head: f64) -> Result<(), String> {
        for (wheel, offset) in [
            ("vehicle[1].wheelset[1]", 0.0),
            ("vehicle[1].wheelset[2]", 1.83),
            ("vehicle[2].wheelset[1]", 20.0),
        ] {
            for (signal, value) in [
                ("position", head - offset),
                ("speed", 16.67),
                ("creepage.longitudinal", 0.003),
                ("force.normal", 109_500.0),
                ("contact.a", 0.0063),
                ("contact.b", 0.0063),
            ] {
                self.set(&format!("{wheel}.{signal}"), value);
            }
        }
        self.instance.do_step(start, length).map_err(|error| chain(&error))
    }

    /// Steps of 10 ms from one step to another, with the first wheel at 28 m at the start.
    fn steps(&mut self, from: u32, to: u32) {
        for step in from..to {
            let start = 0.01 * f64::from(step);
            self.step(start, 0.01, 28.003 + 16.67 * (start + 0.01)).unwrap();
        }
    }
}

/// An error with its causes.
fn chain(error: &dyn std::error::Error) -> String {
    match error.source() {
        Some(source) => format!("{error}: {}", chain(source)),
        None => error.to_string(),
    }
}

/// `design.md` §3 fixes the names.
#[test]
fn property_the_signals_have_the_designs_names() {
    let bench = Bench::new();
    for signal in [
        "position",
        "speed",
        "creepage.longitudinal",
        "force.normal",
        "friction_power",
        "contact.a",
        "contact.b",
        "contact.lateral_position",
        "brake_power",
    ] {
        bench.reference(&format!("vehicle[2].wheelset[1].{signal}"));
    }
    for name in [
        "ambient.temperature",
        "wind.speed",
        "solar.irradiance",
        "solar.elevation",
        "solar.azimuth",
        "field_file",
        "field_interval",
        "model",
        "highest.surface.rise",
        "highest.foot.chainage",
        "highest.depth[2].rise",
        "probe[1].surface.rise",
        "probe[1].depth[1].rise",
        "probe[1].foot.rise",
        "probe[1].heat",
        "energy.stored",
    ] {
        bench.reference(name);
    }
    let variables = bench.instance.declaration().variables();
    let positions = variables.iter().filter(|variable| variable.name.ends_with("].position"));
    assert_eq!(positions.count(), 3, "two wheelsets and one");
    let paper = Kind::Text { start: "paper".to_owned() };
    assert!(variables.iter().any(|variable| variable.name == "model" && variable.kind == paper));
}

#[test]
fn property_a_passing_wheel_warms_the_probe() {
    let mut bench = Bench::new();
    bench.start().unwrap();
    assert_eq!(bench.get("probe[1].surface.rise"), 0.0);
    bench.steps(0, 50);
    let (surface, deep) = (bench.get("probe[1].surface.rise"), bench.get("probe[1].depth[2].rise"));
    assert!(surface > 1.0 && (0.0..1e-3).contains(&deep));
    assert!(bench.get("probe[1].heat") > 0.0);
    assert!(bench.get("highest.surface.rise") >= surface);
    let place = bench.get("highest.surface.chainage");
    assert!((28.0..=36.4).contains(&place), "{place}");
    let (stored, imposed) = (bench.get("energy.stored"), bench.get("energy.imposed"));
    let error = stored - imposed - bench.get("energy.weather");
    assert!(error.abs() < 1e-10 * imposed);
}

/// `model = "energy"` through its variables: the heat at the probe is that of the friction power, and a
/// saved and restored run gives the same bits.
#[test]
fn property_the_energy_model_runs_as_an_fmu() {
    let mut bench = Bench::new();
    let model = bench.reference("model");
    bench.instance.set_string(&[model], ["energy"]).unwrap();
    bench.set("section.cell_size", 0.012);
    bench.set("wheel.contact_quality", 0.0);
    bench.set("rail.loss_factor", 0.0);
    bench.start().unwrap();
    for wheel in ["vehicle[1].wheelset[1]", "vehicle[1].wheelset[2]", "vehicle[2].wheelset[1]"] {
        bench.set(&format!("{wheel}.friction_power"), 1667.0);
    }
    bench.steps(0, 200);
    let bytes = bench.instance.save().unwrap().to_bytes();
    bench.steps(200, 300);
    // All three wheels have passed; each leaves half of 100 J/m.
    let (friction, stored) = (bench.get("probe[1].heat.friction"), bench.get("energy.stored"));
    assert!((friction / 150.0 - 1.0).abs() < 1e-11, "{friction} J/m");
    assert_eq!(bench.get("foot.detection.time"), -1.0);
    assert!(bench.get("probe[1].surface.rise") > 0.0);
    assert!(bench.get("energy.error").abs() < 1e-9 * bench.get("energy.friction"));
    let state = bench.instance.deserialize_state(&bytes).unwrap();
    bench.instance.restore(&state).unwrap();
    bench.steps(200, 300);
    assert_eq!(bench.get("energy.stored"), stored);
    // Heat has reached the foot, and more comes.
    bench.instance.do_step(3.0, 60.0).unwrap();
    assert_eq!(bench.get("foot.highest.time"), 63.0);
}

#[test]
fn property_the_field_file_holds_the_run() {
    let mut bench = Bench::new();
    let path = bench.folder.path().join("rail.zarr");
    let reference = bench.reference("field_file");
    bench.instance.set_string(&[reference], [path.to_str().unwrap()]).unwrap();
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
        let mut bench = Bench::new();
        let path = bench.folder.path().join("rail.zarr");
        let references = [bench.reference("field_file"), bench.reference("field_failure")];
        bench.instance.set_string(&references, [path.to_str().unwrap(), choice]).unwrap();
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
        let told = messages.iter().filter(|text| text.contains("goes on without")).count();
        assert_eq!(told, usize::from(goes_on), "{messages:?}");
    }
}

/// A folder that can never be made, as on a disk that is read-only.
#[test]
fn a_field_that_cannot_begin_stops_the_run_or_not() {
    for (choice, goes_on) in [("stop", false), ("go_on", true)] {
        let mut bench = Bench::new();
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
        let told = messages.iter().filter(|text| text.contains("goes on without")).count();
        assert_eq!(told, 1, "{messages:?}");
    }
}

/// Place, time and day as the FMU's parameters: the winter sun over Townsville warms the rail in the morning
/// (its light does not change here, so that half an hour later it has risen by some kelvin).
#[test]
fn property_place_and_time_are_parameters() {
    let mut bench = Bench::new();
    let track = bench.folder.path().join("curve.toml");
    fs::write(&track, "[[alignment]]\nlength_m = 1000.0\nradius_m = 300.0\n").unwrap();
    let header = "time_s,air_degC,wind_m_s,direct_W_m2,diffuse_W_m2";
    let day = bench.folder.path().join("day.csv");
    let rows = (0..=24).map(|hour| format!("{},25,1,700,80\n", 3600 * (hour - 24)));
    fs::write(&day, format!("{header}\n{}3600,25,1,700,80\n", rows.collect::<String>())).unwrap();
    bench.set_texts(&[
        ("model", "energy"),
        ("site.date_time", "2018-06-21T07:30:00+10:00"),
        ("weather_file", day.to_str().unwrap()),
        ("track_file", track.to_str().unwrap()),
    ]);
    let reference = bench.reference("initial.day");
    bench.instance.set_boolean(&[reference], [true]).unwrap();
    bench.set("site.latitude", -0.336);
    bench.set("site.longitude", 2.562);
    bench.set("section.cell_size", 0.012);
    bench.start().unwrap();
    bench.instance.do_step(0.0, 1800.0).unwrap();
    let warmed = bench.get("untouched.surface.rise");
    assert!((0.5..10.0).contains(&warmed), "{warmed} K");
    assert!(bench.get("energy.error").abs() < 1e-9 * bench.get("energy.weather").abs());
}

#[test]
fn wrong_places_and_days_are_named() {
    for (texts, wanted) in [
        (vec![("site.date_time", "noon")], "site.date_time = \"noon\""),
        (vec![("track_file", "/no/track.toml")], "/no/track.toml"),
        (vec![("weather_file", "/no/day.csv")], "/no/day.csv"),
    ] {
        let mut bench = Bench::new();
        bench.set_texts(&[("model", "energy")]);
        bench.set_texts(&texts);
        let sentence = bench.start().unwrap_err();
        assert!(sentence.contains(wanted), "{sentence}");
    }
    for (header, row, day, wanted) in [
        (railheat::weather_file::HEADER, "25,1,700,80,50,0", true, "of the 24 h before or after"),
        (
            "time_s,air_degC,wind_m_s,direct_W_m2,diffuse_W_m2",
            "25,1,700,80",
            false,
            "site.date_time",
        ),
        (railheat::weather_file::HEADER, "25,1,7000,80,50,0", false, "direct_W_m2 = 7000"),
    ] {
        let mut bench = Bench::new();
        let file = bench.folder.path().join("day.csv");
        fs::write(&file, format!("{header}\n0,{row}\n600,{row}\n")).unwrap();
        bench.set_texts(&[("model", "energy"), ("weather_file", file.to_str().unwrap())]);
        let reference = bench.reference("initial.day");
        bench.instance.set_boolean(&[reference], [day]).unwrap();
        let sentence = bench.start().unwrap_err();
        assert!(sentence.contains(wanted), "{sentence}");
    }
}

#[test]
fn the_weather_file_takes_the_place_of_the_inputs() {
    let mut bench = Bench::new();
    let path = bench.folder.path().join("day.csv");
    let header = railheat::weather_file::HEADER;
    fs::write(&path, format!("{header}\n0,10,0,0,0,0,0\n100,30,0,0,0,0,0\n")).unwrap();
    let references = [bench.reference("model"), bench.reference("weather_file")];
    bench.instance.set_string(&references, ["energy", path.to_str().unwrap()]).unwrap();
    bench.set("section.cell_size", 0.012);
    bench.start().unwrap();
    bench.instance.do_step(0.0, 50.0).unwrap();
    assert!(bench.get("untouched.surface.rise") > 0.0, "the air has become warmer");
    let sentence = chain(&bench.instance.do_step(50.0, 200.0).unwrap_err());
    assert!(sentence.contains("from 0 s to 100 s, but the run needs 150 s"), "{sentence}");
}

/// The state goes on bit for bit; the file stays as it is until the run is past its last snapshot.
#[test]
fn property_a_restored_run_gives_the_same_and_appends_later() {
    let mut bench = Bench::new();
    let path = bench.folder.path().join("rail.zarr");
    let reference = bench.reference("field_file");
    bench.instance.set_string(&[reference], [path.to_str().unwrap()]).unwrap();
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

#[test]
fn a_wheel_off_the_track_is_told_of_once() {
    let mut bench = Bench::new();
    bench.instance.set_debug_logging(true, &[]).unwrap();
    bench.start().unwrap();
    bench.step(0.0, 0.01, 15.0).unwrap();
    bench.step(0.01, 0.01, 15.2).unwrap();
    let messages = bench.messages.lock().unwrap().clone();
    let told: Vec<_> = messages.iter().filter(|text| text.contains("outside")).collect();
    assert_eq!(told.len(), 1, "{messages:?}");
    for part in ["vehicle[2].wheelset[1]", "-5.0 m", "0 m to 100 m"] {
        assert!(told[0].contains(part), "{}", told[0]);
    }
}

#[test]
fn wrong_parameters_are_named() {
    for (name, value, wanted) in [
        ("conduction.interval", 5.0, "at most"),
        ("cell.size", 0.0033, "rail.height = 0.17 m and cell.size = 0.0033 m"),
        ("element.length", 0.0, "element.length = 0: must be greater than zero"),
        ("track.length", 1e9, "cells, more than"),
        ("track.length", 30.0, "chainage_m = 30.05: must lie on the modelled track"),
        ("material.specific_heat", 0.0, "material.specific_heat = 0: must be greater than zero"),
    ] {
        let mut bench = Bench::new();
        bench.set(name, value);
        let sentence = bench.start().unwrap_err();
        assert!(sentence.contains(wanted), "{name}: {sentence}");
    }
    let mut bench = Bench::new();
    let reference = bench.reference("model");
    bench.instance.set_string(&[reference], ["magic"]).unwrap();
    assert!(
        bench.start().unwrap_err().contains("model = \"magic\": must be \"paper\" or \"energy\"")
    );
}

#[test]
fn wrong_parameters_of_the_energy_model_are_named() {
    for (name, value, wanted) in [
        ("section.cell_size", 0.0, "section.cell_size = 0: must be greater than zero"),
        ("section.cell_size", 0.001, "cells: from 2 to 2400 are possible"),
        ("train.floor_height", 5.0, "train.floor_height = 5 and train.roof_height = 3.9"),
        ("site.latitude", 2.0, "site.latitude = 114.59"),
        ("wheel.contact_quality", 2.0, "wheel.contact_quality = 2: must be from 0 to 1"),
        ("material.specific_heat", 0.0, "material.specific_heat = 0: must be greater than zero"),
    ] {
        let mut bench = Bench::new();
        let model = bench.reference("model");
        bench.instance.set_string(&[model], ["energy"]).unwrap();
        bench.set_texts(&[("site.date_time", "2018-06-21T07:30:00+10:00")]);
        bench.set(name, value);
        let sentence = bench.start().unwrap_err();
        assert!(sentence.contains(wanted), "{name}: {sentence}");
    }
    for (name, value, wanted) in [
        ("section.rail", "/no/rail.toml", "AS60, 60E1 and 136RE"),
        ("section.model", "3d", "section.model = \"3d\": must be"),
    ] {
        let mut bench = Bench::new();
        let references = [bench.reference("model"), bench.reference(name)];
        bench.instance.set_string(&references, ["energy", value]).unwrap();
        let sentence = bench.start().unwrap_err();
        assert!(sentence.contains(wanted), "{name}: {sentence}");
    }
}

#[test]
fn wrong_inputs_are_named() {
    for (name, value, wanted) in [
        ("vehicle[1].wheelset[2].contact.a", 0.0, "contact.a = 0 m"),
        ("ambient.temperature", 0.0, "ambient.temperature = 0: must lie between 183.1"),
        ("wind.speed", 300.0, "wind.speed = 300: must lie between 0 and 115"),
        ("solar.irradiance", 14_000.0, "solar.irradiance = 14000: must lie between 0 and 1500"),
    ] {
        let mut bench = Bench::new();
        bench.start().unwrap();
        bench.step(0.0, 0.01, 50.0).unwrap();
        bench.set(name, value);
        let sentence = chain(&bench.instance.do_step(0.01, 0.01).unwrap_err());
        assert!(sentence.contains(wanted), "{name}: {sentence}");
    }
}

#[test]
fn a_missing_file_of_shape_is_named() {
    let quiet = Box::new(|_, _: &str| ());
    let error = Instance::<RailHeat>::new(Path::new("/nowhere"), "rail", quiet).err().unwrap();
    let sentence = chain(&error);
    assert!(sentence.contains("/nowhere/railheat.toml"), "{sentence}");
    assert!(sentence.contains("wheelsets_per_vehicle"), "{sentence}");
}
