//! What is said of wrong files, word for word: file, line, column, key, value and what is right.

use files::{Document, Mistake};
use stock::{Consist, Library};

use crate::scratch::{ROOT, Scratch};

/// The first line of what is said of a vehicle that extends the shipped locomotive with `text`.
fn said(text: &str) -> String {
    let text = format!("extends = 'locomotive-coco-134t'\n{text}");
    first_line(&Scratch::with("changed", &text).vehicle("changed").unwrap_err())
}

/// The message without its folder and its picture of the line.
fn first_line(mistake: &Mistake) -> String {
    let message = mistake.to_string();
    let line = message.lines().next().unwrap();
    let begin = line.find(".toml").map_or(0, |end| line[..end].rfind('/').map_or(0, |i| i + 1));
    line[begin..].to_owned()
}

/// What is said of a gear.
fn said_of_gear(text: &str) -> String {
    let folder = tempfile::tempdir().unwrap();
    let gears = folder.path().join("draft_gears");
    std::fs::create_dir(folder.path().join("vehicles")).unwrap();
    std::fs::create_dir(&gears).unwrap();
    std::fs::write(gears.join("gear.toml"), text).unwrap();
    first_line(&Library::open(folder.path()).unwrap().draft_gear("gear").unwrap_err())
}

#[test]
fn golden_whole_message() {
    let text = "extends = 'locomotive-coco-134t'\n[brake]\nlag_s = 0.0      # quick\n";
    let scratch = Scratch::with("changed", text);
    let message = scratch.vehicle("changed").unwrap_err().to_string();
    let file = scratch.file("changed").display().to_string();
    let expected = format!(
        "{file}:3:9: brake.lag_s = 0.0: must lie between 0.1 and 60\n  |\n3 | lag_s = 0.0      # quick\n  \
         |         ^^^"
    );
    assert_eq!(message, expected);
}

#[test]
fn golden_values_of_a_vehicle() {
    for (text, expected) in [
        ("axles = 1", "2:9: axles = 1: must lie between 2 and 64"),
        ("length_m = 2000", "2:12: length_m = 2000: must lie between 1 and 200"),
        ("rotating_mass_kg = -1", "2:20: rotating_mass_kg = -1: must lie between 0 and 100000"),
        ("coupler.slack_mm = -3.5", "2:20: coupler.slack_mm = -3.5: must lie between 0 and 500"),
        ("resistance.factor = 11", "2:21: resistance.factor = 11: must lie between 0 and 10"),
        ("traction.efficiency = 85", "2:23: traction.efficiency = 85: must lie between 0.1 and 1"),
        (
            "traction.notch_effort = [0, 1]",
            "2:25: traction.notch_effort = [0.0, 1.0]: needs nine values, for idle and the notches 1 to 8",
        ),
        (
            "traction.notch_effort = [0, 0.1, 0.2, 0.3, 0.2, 0.5, 0.6, 0.7, 1]",
            "2:44: traction.notch_effort[5] = 0.2: must lie between 0.3 and 1",
        ),
        ("traction.power_kw = 0", "2:21: traction.power_kw = 0: must be greater than zero"),
        (
            "[brake.shoe_friction]\nspeed_kmh = [0, 50]\nvalue = [0.3, 1.3]",
            "4:15: brake.shoe_friction.value[2] = 1.3: must lie between 0 and 1",
        ),
        (
            "[brake.shoe_friction]\nspeed_kmh = [5, 50]\nvalue = [0.3, 0.2]",
            "3:14: brake.shoe_friction.speed_kmh[1] = 5: must be zero",
        ),
        (
            "hand_brake.net_braking_ratio = 2",
            "2:32: hand_brake.net_braking_ratio = 2: must lie between 0 and 1",
        ),
        (
            "[locomotive_brake]\nnet_braking_ratio = 0.1\nbuild_up_s = 0\nrelease_s = 5",
            "4:14: locomotive_brake.build_up_s = 0: must lie between 0.1 and 600",
        ),
        (
            "[dynamic_brake.effort]\nspeed_kmh = [0, 8]\neffort_kn = [5, 325]",
            "4:14: dynamic_brake.effort.effort_kn[1] = 5: must be zero at standstill",
        ),
        (
            "multibody.coupler.height_m = 880",
            "2:30: multibody.coupler.height_m = 880: must lie between 0 and 3",
        ),
        (
            "multibody.contact.gauge_mm = 1.435",
            "2:30: multibody.contact.gauge_mm = 1.435: must lie between 300 and 2500",
        ),
        (
            "multibody.contact.gauge_depth_mm = 0.014",
            "2:36: multibody.contact.gauge_depth_mm = 0.014: must lie between 5 and 30",
        ),
        (
            "multibody.contact.running_circle_mm = 7",
            "2:39: multibody.contact.running_circle_mm = 7: must lie between 50 and 100",
        ),
        (
            "multibody.contact.creep.friction = 36",
            "2:36: multibody.contact.creep.friction = 36: must lie between 0.01 and 1",
        ),
    ] {
        assert_eq!(said(text), format!("changed.toml:{expected}"));
    }
}

#[test]
fn golden_what_a_vehicle_lacks_or_has_too_much() {
    for (text, expected) in [
        (
            "[resistance]\ncurve_formula = 'table'",
            "2:1: resistance.curve_table is missing: the curve formula \"table\" needs it",
        ),
        (
            "without = ['traction']\n[traction]\nramp_s = 1",
            "3:1: traction.effort is missing: traction needs it, or [traction.by_notch]",
        ),
        (
            "without = ['traction']\n[traction]\nramp_s = 1\nnotch_power = [0, 1]",
            "3:1: traction.power_kw is missing: notch_power needs it",
        ),
        ("mass = 3", "2:8: there is no key `mass`; did you mean `mass_kg`?"),
        ("[brake]\nlag = 1", "3:7: there is no key `lag` in brake; did you mean `lag_s`?"),
        ("name = 7", "2:8: name = 7: must be a text in quotes"),
        ("axles = 4.5", "2:9: axles = 4.5: must be a whole number"),
        ("mass_kg = '134 t'", "2:11: mass_kg = \"134 t\": must be a number"),
        ("mass_kg = 134 t", "2:11: a number stands alone; its unit is at the end of the key"),
        ("extends = 'again'", "2:1: `extends` stands twice; leave one of them out"),
    ] {
        let message = said(text);
        assert!(message.starts_with(&format!("changed.toml:{expected}")), "{message}");
    }
}

#[test]
fn a_vehicle_that_is_extended_and_not_there_is_answered_with_the_one_that_is_meant() {
    let scratch = Scratch::with("changed", "extends = 'wagon-ore-40'\n");
    let message = first_line(&scratch.vehicle("changed").unwrap_err());
    let expected = "changed.toml:1:11: extends = 'wagon-ore-40': there is no vehicle of this name in the \
                    library; did you mean `wagon-ore-40t`?";
    assert_eq!(message, expected);
}

/// A wrong value that comes from the vehicle that is extended is looked for in its file.
#[test]
fn a_mistake_of_an_extended_vehicle_names_its_own_file() {
    let scratch = Scratch::with("base", "extends = 'locomotive-coco-134t'\naxles = 99\n");
    std::fs::write(scratch.file("own"), "extends = 'base'\nlength_m = 19.0\n").unwrap();
    let message = first_line(&scratch.vehicle("own").unwrap_err());
    assert_eq!(message, "base.toml:2:9: axles = 99: must lie between 2 and 64");
}

/// The elements of the multibody section, each with one value that cannot be.
#[test]
fn golden_force_elements() {
    let element = |kind: &str, keys: &str| {
        let ends = "name = 'e'\nbetween = ['car body', 'front bogie']";
        said(&format!("[[multibody.{kind}]]\n{ends}\n{keys}"))
    };
    let at = "points_m = [[6.6, 0.0, 1.0]]";
    for (kind, keys, expected) in [
        (
            "damper",
            format!("{at}\ndirection = 'lateral'\ndamping_n_s_m = -5"),
            "7:17: multibody.damper[1].damping_n_s_m = -5: must be greater than zero",
        ),
        (
            "damper",
            format!("{at}\ndirection = 'sideways'\ndamping_n_s_m = 5"),
            "6:13: multibody.damper[1].direction = \"sideways\": must be",
        ),
        (
            "stop",
            format!("{at}\ndirection = 'lateral'\nfree_play_mm = -1\nstiffness_n_m = 1e6"),
            "7:16: multibody.stop[1].free_play_mm = -1: must lie between 0 and 1000",
        ),
        (
            "tabulated_spring",
            format!("{at}\ndirection = 'vertical'\ndisplacement_mm = [0, 5, 5]\nforce_n = [0, 1, 2]"),
            "7:26: multibody.tabulated_spring[1].displacement_mm[3] = 5: must be greater than the value",
        ),
        (
            "tabulated_spring",
            format!("{at}\ndirection = 'vertical'\ndisplacement_mm = [0, 5]\nforce_n = [3, 4]"),
            "8:12: multibody.tabulated_spring[1].force_n[1] = 3: a table that begins at displacement zero",
        ),
        (
            "rod",
            "ends_m = [[1.0, 0.0, 0.5], [1.0, 0.0, 0.52]]\nstiffness_n_m = 1e7".to_owned(),
            "5:10: multibody.rod[1].ends_m",
        ),
        (
            "friction",
            format!("{at}\ndirection = 'lateral'\nforce_n = 0\nstick_stiffness_n_m = 1e6"),
            "7:11: multibody.friction[1].force_n = 0: must be greater than zero",
        ),
        (
            "wedge",
            format!(
                "{at}\nangle_deg = 10\nfriction = 0.3\nspring_force_n = 1\nspring_stiffness_n_m = 1\n\
                 stick_stiffness_n_m = 1"
            ),
            "6:13: multibody.wedge[1].angle_deg = 10: must lie between 20 and 70",
        ),
        (
            "centre_plate",
            "point_m = [6.6, 0, 1]\nradius_m = 0.2\nstiffness_n_m = [1e6, 1e6, 1e6]\nfriction = 3\n\
             stick_stiffness_n_m_rad = 1e6"
                .to_owned(),
            "8:12: multibody.centre_plate[1].friction = 3: must lie between 0 and 1",
        ),
        (
            "rotational_spring",
            "stiffness_n_m_rad = [1e6, -1, 0]".to_owned(),
            "5:21: multibody.rotational_spring[1].stiffness_n_m_rad = -1: must lie between 0 and",
        ),
        (
            "side_bearer",
            format!(
                "{at}\npreload_n = 2e4\nstiffness_n_m = 1e6\nsolid_gap_mm = 5\nsolid_stiffness_n_m = 1e8\n\
                 friction = 0.3\nstick_stiffness_n_m = 0"
            ),
            "11:23: multibody.side_bearer[1].stick_stiffness_n_m = 0: must be greater than zero",
        ),
    ] {
        let message = element(kind, &keys);
        assert!(message.starts_with(&format!("changed.toml:{expected}")), "{message}");
    }
}

const LOADING: &str = "[loading]\ndeflection_mm = [0, 10, 30]\nforce_kn = [0, 100, 200]\n";

#[test]
fn golden_draft_gears() {
    let head = "name = 'gear'\nsource = 'test'\n";
    for (keys, sections, expected) in [
        ("", "", "3:2: "),
        (
            "structure_stiffness_mn_m = 0.5\n",
            LOADING,
            "structure_stiffness_mn_m = 0.5: must lie between 1",
        ),
        (
            "structure_stiffness_mn_m = 50\ndamping_kn_s_m = -1\n",
            LOADING,
            "damping_kn_s_m = -1: must lie between 0 and 10000",
        ),
        (
            "structure_stiffness_mn_m = 50\nloss_percent = 120\nlocked_stiffness_mn_m = 100\n",
            LOADING,
            "loss_percent = 120: must lie between 0 and 99",
        ),
        (
            "structure_stiffness_mn_m = 50\n",
            "[loading]\ndeflection_mm = [0, 10, 5]\nforce_kn = [0, 1, 2]\n",
            "loading.deflection_mm[3] = 5: must be greater than the value before it, 10",
        ),
        (
            "structure_stiffness_mn_m = 50\n",
            "[loading]\ndeflection_mm = [0, 10]\nforce_kn = [5, 5]\n",
            "loading.force_kn[2] = 5: must rise from the value before it, 5",
        ),
        (
            "drawbar.stiffness_mn_m = 100\n",
            LOADING,
            "drawbar: leave either [loading] or [drawbar] out",
        ),
        (
            "structure_stiffness_mn_m = 50\nloss = 3\n",
            LOADING,
            "there is no key `loss`; did you mean `loss_percent`?",
        ),
    ] {
        let message = said_of_gear(&format!("{head}{keys}{sections}"));
        assert!(message.starts_with("gear.toml:"), "{message}");
        match expected {
            "3:2: " => {
                assert!(message.contains("loading is missing: a gear needs [loading]"), "{message}")
            }
            expected => assert!(message.contains(expected), "{message}"),
        }
    }
}

#[test]
fn golden_consists() {
    for (text, expected) in [
        ("vehicle = []", "c.toml:1:11: vehicle: there must be at least one vehicle"),
        ("", "c.toml: vehicle is missing"),
        (
            "[vehicle]\ntype = 'a'",
            "c.toml:1:1: vehicle: write [[vehicle]] in double brackets, once for each",
        ),
        (
            "[[vehicle]]\ntype = 'a'\ncount = 1001",
            "c.toml:3:9: vehicle[1].count = 1001: must be at least 1, and 1000 in all at most",
        ),
        (
            "[[vehicle]]\ntype = 'a'\nhand_brake = 2",
            "c.toml:3:14: vehicle[1].hand_brake = 2: must lie between 0 and 1",
        ),
        (
            "[[vehicle]]\ntype = 'a'\ngroup = 16",
            "c.toml:3:9: vehicle[1].group = 16: must be less than 16",
        ),
        ("[[vehicle]]\ncount = 2", "c.toml:1:1: vehicle[1].type is missing"),
        (
            "[[vehicle]]\ntype = 'a'\ncount = '2'",
            "c.toml:3:9: vehicle[1].count = '2': must be a whole number, without quotes",
        ),
    ] {
        let message = first_line(&Consist::from_toml(text, "c.toml").unwrap_err());
        assert_eq!(message, expected);
    }
}

#[test]
fn a_folder_that_is_no_library_is_answered() {
    let message = Library::open("/nowhere").unwrap_err().to_string();
    assert_eq!(message, "/nowhere: is no rolling-stock library: it has no folder `vehicles`");
    let library = Library::open(ROOT).unwrap();
    let message = library.draft_gear("friction-gear-m901").unwrap_err().to_string();
    assert!(message.ends_with("did you mean `friction-gear-m901e.toml`?"), "{message}");
}

/// A file that people write may begin with anything; it is never more than a mistake.
#[test]
fn property_no_text_makes_the_reader_panic() {
    for text in ["\u{feff}", "[", "=", "a = \"", "[[a]]\n[a]", "é = 1", "vehicle = [{", "\t\r\n"] {
        let _ = Consist::from_toml(text, "c.toml").map_err(|mistake| mistake.to_string());
        let document = Document::new("c.toml", text);
        let _ = document.check().error("vehicle[1].é", 1, "").to_string();
    }
}
