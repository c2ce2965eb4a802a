//! The energy model through its variables and files.

use std::fs;

use crate::bench::{Bench, WEATHER, chain};

/// `model = "energy"` through its variables: the heat at the probe is that of the friction power, and a
/// saved and restored run gives the same bits.
#[test]
fn property_the_energy_model_runs_as_an_fmu() {
    let mut bench = Bench::new();
    bench.set_texts(&[("model", "energy")]);
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

/// Site, time and day as the FMU's parameters: the winter sun over Townsville warms the rail in the morning
/// (its light does not change here, so that half an hour later it has risen by some kelvin).
#[test]
fn property_site_and_time_are_parameters() {
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
fn the_weather_file_stands_for_the_inputs() {
    let mut bench = Bench::new();
    let path = bench.folder.path().join("day.csv");
    fs::write(&path, format!("{WEATHER}\n0,10,0,0,0,0,0\n100,30,0,0,0,0,0\n")).unwrap();
    bench.set_texts(&[("model", "energy"), ("weather_file", path.to_str().unwrap())]);
    bench.set("section.cell_size", 0.012);
    bench.start().unwrap();
    bench.instance.do_step(0.0, 50.0).unwrap();
    assert!(bench.get("untouched.surface.rise") > 0.0, "the air has become warmer");
    let sentence = chain(&bench.instance.do_step(50.0, 200.0).unwrap_err());
    assert!(sentence.contains("from 0 s to 100 s, but the run needs 150 s"), "{sentence}");
}
