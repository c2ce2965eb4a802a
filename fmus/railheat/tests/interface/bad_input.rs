//! What is wrong is named: parameters, files, inputs, and a wheel off the track.

use std::fs;
use std::path::Path;

use fmu::Instance;
use railheat::RailHeat;

use crate::bench::{Bench, chain};

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
        (railheat::weather::HEADER, "25,1,700,80,50,0", true, "of the 24 h before or after"),
        (
            "time_s,air_degC,wind_m_s,direct_W_m2,diffuse_W_m2",
            "25,1,700,80",
            false,
            "site.date_time",
        ),
        (railheat::weather::HEADER, "25,1,7000,80,50,0", false, "direct_W_m2 = 7000"),
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
    bench.set_texts(&[("model", "magic")]);
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
        bench.set_texts(&[("model", "energy"), ("site.date_time", "2018-06-21T07:30:00+10:00")]);
        bench.set(name, value);
        let sentence = bench.start().unwrap_err();
        assert!(sentence.contains(wanted), "{name}: {sentence}");
    }
    for (name, value, wanted) in [
        ("section.rail", "/no/rail.toml", "AS60, 60E1 and 136RE"),
        ("section.model", "3d", "section.model = \"3d\": must be"),
    ] {
        let mut bench = Bench::new();
        bench.set_texts(&[("model", "energy"), (name, value)]);
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
