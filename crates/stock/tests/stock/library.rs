//! The shipped rolling stock, and what the library says about files that are wrong.

use std::path::Path;

use stock::Library;

use crate::scratch::{ROOT, Scratch, message, shipped};

/// Source: Bosomworth et al. 2018, tables 1 and 2: 134 t, 20 m, six axles; the wagon is the
/// locomotive without traction.
#[test]
fn benchmark_vehicles_of_the_paper() {
    let locomotive = shipped().vehicle("locomotive-coco-134t").unwrap();
    let wagon = shipped().vehicle("wagon-coco-134t-unpowered").unwrap();
    for vehicle in [&locomotive, &wagon] {
        let size = (vehicle.mass_kg, vehicle.length_m, vehicle.axles);
        assert_eq!(size, (134_000.0, 20.0, 6));
    }
    assert!(locomotive.traction.is_some() && wagon.traction.is_none());
    assert_eq!(locomotive.brake, wagon.brake);
}

/// Source: Miner TF-880 data sheet, 61.7 kJ and 2518 kN at 74.4 mm. Two per cent is what the
/// polyline through rounded points may add; the power law itself has the capacity exactly.
#[test]
fn benchmark_official_capacity_of_the_friction_gear() {
    let gear = shipped().draft_gear("friction-gear-m901e").unwrap();
    let energy = gear.draft.loading.energy_to_kj(74.4);
    assert!((energy / 61.7 - 1.0).abs() < 0.02, "{energy} kJ");
    assert_eq!(gear.draft.loading.force_at_kn(74.4), 2518.0);
}

/// Everything that is shipped can be used.
#[test]
fn property_every_shipped_file_is_read() {
    let names = |part: &str| -> Vec<String> {
        let files = std::fs::read_dir(Path::new(ROOT).join(part)).unwrap();
        let files = files.map(|file| file.unwrap().path());
        files.map(|file| file.file_stem().unwrap().to_str().unwrap().to_owned()).collect()
    };
    for name in names("vehicles") {
        let vehicle = shipped().vehicle(&name).unwrap();
        shipped().draft_gear(&vehicle.coupler.draft_gear).unwrap();
    }
    for name in names("draft_gears") {
        shipped().draft_gear(&name).unwrap();
    }
}

#[test]
fn a_vehicle_changes_single_values_of_the_one_it_extends() {
    let text = "extends = 'locomotive-coco-134t'\n[brake]\nlag_s = 2.0\n";
    let changed = Scratch::with("changed", text).vehicle("changed").unwrap();
    let mut expected = shipped().vehicle("locomotive-coco-134t").unwrap();
    expected.brake.lag_s = 2.0;
    assert_eq!(changed, expected);
}

#[test]
fn a_vehicle_file_finds_the_library_it_lies_in() {
    let scratch =
        Scratch::with("changed", "extends = 'wagon-coco-134t-unpowered'\nlength_m = 19.0\n");
    let file = scratch.file("changed");
    let vehicle = Library::of(&file).unwrap().vehicle_from_file(&file).unwrap();
    assert_eq!(vehicle.length_m, 19.0);
}

/// A profile with an ending is a file of the library; its path stands in the vehicle. A vehicle that
/// extends another one has its file from the same place.
#[test]
fn profiles_that_are_files_are_found_in_the_library() {
    let text = "extends = 'locomotive-coco-134t'\nmultibody.contact.wheel = 'profiles/worn.prw'\n";
    let scratch = Scratch::with("worn", text);
    let again = scratch.file("again");
    std::fs::write(&again, "extends = 'worn'\nmultibody.contact.rail = 'AS60'\n").unwrap();
    let missing = scratch.vehicle("again").unwrap_err().to_string();
    assert!(
        missing
            .contains("worn.toml:2:27: multibody.contact.wheel = 'profiles/worn.prw': cannot read")
    );

    let profile = scratch.folder.path().join("profiles/worn.prw");
    std::fs::create_dir(profile.parent().unwrap()).unwrap();
    std::fs::write(&profile, "0 0").unwrap();
    for name in ["worn", "again"] {
        let contact = scratch.vehicle(name).unwrap().multibody.unwrap().contact;
        assert_eq!(Path::new(&contact.wheel), profile);
    }
}

#[test]
fn a_profile_outside_of_the_library_is_refused() {
    for path in ["../worn.prw", "/tmp/worn.prw"] {
        let message = message(&format!("multibody.contact.wheel = '{path}'"));
        assert!(
            message.contains("must be a path inside of the rolling-stock library"),
            "{message}"
        );
    }
}

#[test]
fn a_negative_mass_is_refused_with_file_key_and_remedy() {
    let message = message("mass_kg = -134000.0");
    assert!(message.contains("changed.toml:2:11: mass_kg = -134000.0: must lie between 100"));
}

#[test]
fn bodies_must_weigh_what_the_vehicle_weighs() {
    let message = message("mass_kg = 130000.0");
    assert!(message.contains("mass_kg = 130000.0: must be 134000 kg, the sum of"), "{message}");
}

#[test]
fn an_unknown_key_is_refused_by_name() {
    assert!(message("lenght_m = 20.0").contains("lenght_m"));
}

#[test]
fn an_unknown_key_is_refused_with_its_line_in_a_file_of_its_own() {
    let own = std::fs::read_to_string(Path::new(ROOT).join("vehicles/locomotive-coco-134t.toml"));
    let text = format!("lenght_m = 20.0\n{}", own.unwrap());
    let error = Scratch::with("own", &text).vehicle("own").unwrap_err().to_string();
    assert!(
        error.contains("own.toml:1:1: there is no key `lenght_m`; did you mean `length_m`?"),
        "{error}"
    );
}

#[test]
fn a_table_that_does_not_rise_is_refused_with_its_row() {
    let message = message("[dynamic_brake.effort]\nspeed_kmh = [0, 10, 10]\neffort_kn = [0, 1, 1]");
    let expected = "dynamic_brake.effort.speed_kmh[3] = 10: must be greater than the value before";
    assert!(message.contains(expected), "{message}");
}

#[test]
fn efforts_given_twice_are_refused() {
    let rows = "[[1], [2], [3], [4], [5], [6], [7], [8]]";
    let message = message(&format!("[traction.by_notch]\nspeed_kmh = [0]\neffort_kn = {rows}"));
    assert!(
        message.contains("changed.toml:2:1: traction.by_notch: leave either [traction.effort]"),
        "{message}"
    );
}

#[test]
fn a_table_without_all_notches_is_refused() {
    let text = "extends = 'locomotive-coco-134t'\nwithout = ['traction']\n[traction]\nramp_s = 1\n\
                [traction.by_notch]\nspeed_kmh = [0]\neffort_kn = [[1], [2]]";
    let error = Scratch::with("changed", text).vehicle("changed").unwrap_err().to_string();
    assert!(error.contains("traction.by_notch.effort_kn = 2 rows: needs eight rows"), "{error}");
}

#[test]
fn an_air_brake_without_its_section_is_refused() {
    let message = message("brake.control = 'air'");
    assert!(message.contains("brake.control = 'air': needs the section [brake.air]"), "{message}");
}

#[test]
fn a_section_to_leave_out_must_exist() {
    let message = message("without = ['tracton']");
    assert!(
        message.contains("changed.toml:2:11: without = \"tracton\": locomotive-coco-134t has only"),
        "{message}"
    );
}

#[test]
fn a_vehicle_that_extends_itself_is_refused() {
    let error = Scratch::with("loop", "extends = 'loop'\n").vehicle("loop").unwrap_err();
    assert!(error.to_string().contains("must not extend itself"));
}

#[test]
fn a_missing_file_is_named() {
    let message = shipped().vehicle("no-such").unwrap_err().to_string();
    assert!(message.contains("no-such.toml"));
}
