//! What is wrong is named: parameters, files, inputs, and a wheel off the track.

use std::fs;
use std::path::Path;

use fmu::Instance;
use railheat::RailHeat;

use crate::bench::{Bench, WEATHER, chain};

#[test]
fn wrong_sites_and_days_are_named() {
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
        (WEATHER, "25,1,700,80,50,0", true, "of the 24 h before or after"),
        (
            "time_s,air_degC,wind_m_s,direct_W_m2,diffuse_W_m2",
            "25,1,700,80",
            false,
            "site.date_time",
        ),
        (WEATHER, "25,1,7000,80,50,0", false, "direct_W_m2 = 7000"),
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
fn wrong_parameters_of_the_papers_model_are_named() {
    for (name, value, wanted) in [
        ("conduction.interval", 5.0, "at most"),
        ("cell.size", 0.0033, "rail.height = 0.17 m and cell.size = 0.0033 m"),
        ("track.length", 1e9, "cells, more than"),
        ("track.length", 30.0, "chainage_m = 30.05: must lie on the modelled track"),
    ] {
        let mut bench = Bench::of_paper();
        bench.set(name, value);
        let sentence = bench.start().unwrap_err();
        assert!(sentence.contains(wanted), "{name}: {sentence}");
    }
}

#[test]
fn wrong_parameters_of_the_energy_model_are_named() {
    for (name, value, wanted) in [
        ("section.cell_size", 0.001, "cells: from 2 to 2400 are possible"),
        ("train.floor_height", 5.0, "train.floor_height = 5 and train.roof_height = 3.9"),
    ] {
        let mut bench = Bench::new();
        bench.set_texts(&[("model", "energy"), ("site.date_time", "2018-06-21T07:30:00+10:00")]);
        bench.set(name, value);
        let sentence = bench.start().unwrap_err();
        assert!(sentence.contains(wanted), "{name}: {sentence}");
    }
    let mut bench = Bench::new();
    bench.set_texts(&[("model", "energy"), ("section.rail", "/no/rail.toml")]);
    let sentence = bench.start().unwrap_err();
    assert!(sentence.contains("AS60, 60E1, 136RE"), "{sentence}");
}

/// What can be is said in the model description, and holds where the value is set.
#[test]
fn values_out_of_bounds_are_refused_at_the_setter() {
    let positive = "greater than 0";
    for (name, values, bound) in [
        ("element.length", vec![0.0, -1.0], positive),
        ("track.length", vec![0.0], positive),
        ("rail.height", vec![0.0], positive),
        ("rail.width", vec![0.0], positive),
        ("cell.size", vec![0.0], positive),
        ("conduction.interval", vec![0.0], positive),
        ("material.conductivity", vec![0.0], positive),
        ("material.density", vec![0.0], positive),
        ("material.specific_heat", vec![0.0], positive),
        ("friction.coefficient", vec![0.0], positive),
        ("initial.temperature", vec![0.0], positive),
        ("field_interval", vec![0.0], positive),
        ("section.cell_size", vec![0.0], positive),
        ("section.interval", vec![0.0], positive),
        ("detection.threshold", vec![0.0], positive),
        ("wheel.heat_capacity", vec![0.0], positive),
        ("wheel.contact_quality", vec![2.0, -0.1], "from 0 to 1"),
        ("rail.modulus", vec![0.0], positive),
        ("track.modulus", vec![0.0], positive),
        ("train.half_width", vec![0.0, -1.5], positive),
        ("train.floor_height", vec![0.0], positive),
        ("train.roof_height", vec![0.0], positive),
        ("site.latitude", vec![2.0, -1.6], "from -1.57"),
        ("site.longitude", vec![4.0, -3.2], "from -3.14"),
        ("ambient.temperature", vec![0.0, 400.0], "from 183.15 to 338.15 K"),
        ("wind.speed", vec![300.0], "from 0 to 115 m/s"),
        ("solar.irradiance", vec![14_000.0], "from 0 to 1500 W/m2"),
        ("solar.diffuse", vec![1400.0], "from 0 to 1000 W/m2"),
        ("vehicle[1].wheelset[1].speed", vec![f64::NAN, f64::INFINITY], "a finite number"),
    ] {
        for value in values {
            let sentence = Bench::new().try_set(name, value).unwrap_err();
            assert!(sentence.contains(name) && sentence.contains(bound), "{sentence}");
        }
    }
    for (name, text) in [("model", "magic"), ("section.model", "3d"), ("field_failure", "retry")] {
        let mut bench = Bench::new();
        let reference = bench.reference(name);
        let error = bench.instance.set_string(&[reference], [text]).unwrap_err();
        assert!(chain(&error).contains(name), "{}", chain(&error));
    }
}

/// A parameter of the other heat model that is set names the one that has the effect, or says that none has.
#[test]
fn parameters_of_the_other_model_are_refused() {
    let refused = |model: &str, name: &str, set: &dyn Fn(&mut Bench)| {
        let mut bench = Bench::new();
        bench.set_texts(&[("model", model)]);
        set(&mut bench);
        let sentence = bench.start().unwrap_err();
        assert!(sentence.contains(name) && sentence.contains(model), "{sentence}");
        sentence
    };
    for (model, name, value, instead) in [
        ("energy", "cell.size", 5.0, "section.cell_size"),
        ("energy", "rail.height", 0.2, "section.rail"),
        ("energy", "rail.width", 0.1, "section.rail"),
        ("energy", "conduction.interval", 0.1, "section.interval"),
        ("energy", "friction.coefficient", 0.3, "friction_power"),
        ("paper", "section.cell_size", 0.005, "cell.size"),
        ("paper", "section.interval", 2.0, "conduction.interval"),
        ("paper", "section.shortest_time", 0.1, "start value"),
        ("paper", "foot.conductance", 1.0, "start value"),
        ("paper", "train.wind_share", 0.2, "start value"),
        ("paper", "train.overhang", 2.0, "start value"),
        ("paper", "wheel.heat_capacity", 1e5, "start value"),
        ("paper", "wheel.cooling", 20.0, "start value"),
        ("paper", "wheel.initial_rise", 50.0, "start value"),
        ("paper", "wheel.contact_quality", 0.5, "start value"),
        ("paper", "rail.modulus", 2e11, "start value"),
        ("paper", "track.modulus", 2e7, "start value"),
        ("paper", "rail.expansion", 1e-5, "start value"),
        ("paper", "rail.loss_factor", 1e-3, "start value"),
        ("paper", "track.azimuth", 1.0, "start value"),
        ("paper", "site.latitude", 1.0, "start value"),
        ("paper", "site.longitude", 1.0, "start value"),
        ("paper", "train.half_width", 1.4, "start value"),
        ("paper", "train.floor_height", 1.0, "start value"),
        ("paper", "train.roof_height", 4.0, "start value"),
    ] {
        let sentence = refused(model, name, &|bench| bench.set(name, value));
        assert!(sentence.contains(instead), "{sentence}");
    }
    for (name, text, instead) in [
        ("section.rail", "60E1", "rail.height"),
        ("section.model", "column", "start value"),
        ("site.date_time", "2018-06-21T07:30:00+10:00", "start value"),
        ("track_file", "track.toml", "start value"),
    ] {
        let sentence = refused("paper", name, &|bench| bench.set_texts(&[(name, text)]));
        assert!(sentence.contains(instead), "{sentence}");
    }
    for (name, value, instead) in [
        ("section.along", true, "start value"),
        ("sky.cold", true, "start value"),
        ("initial.day", true, "initial.equilibrium"),
        ("train.shade", false, "start value"),
    ] {
        let sentence = refused("paper", name, &|bench| {
            let reference = bench.reference(name);
            bench.instance.set_boolean(&[reference], [value]).unwrap();
        });
        assert!(sentence.contains(instead), "{sentence}");
    }
}

/// A master sets what the camera sees and which rail this is without knowing the model.
#[test]
fn what_a_master_says_of_any_rail_is_not_refused() {
    let mut bench = Bench::new();
    bench.set("detection.threshold", 0.001);
    bench.set("rail.lateral_position", 0.7535);
    bench.start().unwrap();
}

#[test]
fn a_loaded_wheel_without_a_contact_is_named() {
    let mut bench = Bench::new();
    bench.start().unwrap();
    bench.step(0.0, 0.01, 50.0).unwrap();
    bench.set("vehicle[1].wheelset[2].contact.a", 0.0);
    let sentence = chain(&bench.instance.do_step(0.01, 0.01).unwrap_err());
    assert!(sentence.contains("vehicle[1].wheelset[2]: contact.a = 0 m"), "{sentence}");
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
fn a_wheel_off_the_track_is_warned_of_once() {
    let mut bench = Bench::new();
    bench.instance.set_debug_logging(true, &[]).unwrap();
    bench.start().unwrap();
    bench.step(0.0, 0.01, 15.0).unwrap();
    bench.step(0.01, 0.01, 15.2).unwrap();
    let messages = bench.messages.lock().unwrap().clone();
    let warnings: Vec<_> = messages.iter().filter(|text| text.contains("outside")).collect();
    assert_eq!(warnings.len(), 1, "{messages:?}");
    for part in ["vehicle[2].wheelset[1]", "-5.0 m", "0 m to 100 m"] {
        assert!(warnings[0].contains(part), "{}", warnings[0]);
    }
}
