//! Wrong input of the rail heat through the whole program: the run does not begin, and one sentence says which file,
//! key and value are wrong and what would be right.

use hotfoot_tests::SmallScenario;

const WEATHER: &str =
    "time_s,air_degC,wind_m_s,direct_W_m2,diffuse_W_m2,sun_elevation_deg,sun_azimuth_deg";

/// A rectangle of 172 x 40 mm as a rail file, with these corners.
fn rail_file(corners: &str) -> String {
    format!(
        "name = \"bar\"\nsource = \"test\"\nheight_mm = 172\narea_mm2 = 6880\n\
         centroid_above_foot_mm = 86\nsecond_moment_mm4 = 1\ncorners_mm = [{corners}]\n"
    )
}

/// What the program says to a scenario with these keys of `[heat]` and `[heat.parameters]` and this file.
fn refusal(keys: &str, parameters: &str, (name, content): (&str, &str)) -> String {
    let mut scenario = SmallScenario::new(2.0);
    scenario.leave_out_heat();
    scenario.text += &format!(
        "[heat]\nmodel = \"energy\"\nbegin_m = 0.0\nlength_m = 60.0\n{keys}\n[heat.parameters]\n{parameters}\n"
    );
    std::fs::write(scenario.folder.path().join(name), content).unwrap();
    let output = scenario.run(&[]);
    assert!(!output.status.success(), "{keys} {parameters}");
    assert!(!scenario.results().join("series").exists(), "nothing was begun");
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    // Long messages have several lines.
    said.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn wrong_weather_is_named_before_the_run() {
    let night = "weather_file = \"night.csv\"";
    for (keys, rows, wanted) in [
        (
            "",
            "0,10,1,0,0,-30,0\n20000,10,1,0,0,-30,0",
            "time_s = 20000: must rise from 0 before it",
        ),
        ("", "0,288,1,0,0,-30,0", "air_degC = 288: must lie between -90 and 65"),
        ("", "0,10,1,0,0", "this row has 5 values, but the rows above it have 7"),
        (
            "cool_down_minutes = 30.0",
            "0,10,1,0,0,-30,0\n600,10,1,0,0,-30,0",
            "has weather from 0 s to 600 s, but the run needs 1802 s",
        ),
    ] {
        let said = refusal(keys, night, ("night.csv", &format!("{WEATHER}\n{rows}\n")));
        assert!(said.contains("night.csv") && said.contains(wanted), "{wanted} in {said}");
    }
}

#[test]
fn a_section_that_is_not_closed_is_named() {
    let corners = "[0, 172, 0], [20, 172, 0], [20, 0, 0]";
    let said = refusal("", "\"section.rail\" = \"bar.toml\"", ("bar.toml", &rail_file(corners)));
    for part in [
        "bar.toml",
        "corners_mm: the section is not closed: must begin at [0, 172]",
        "ends at [20, 0]",
    ] {
        assert!(said.contains(part), "{part} in {said}");
    }
}

#[test]
fn impossible_values_are_named() {
    for (keys, parameters, wanted) in [
        (
            "",
            "\"material.specific_heat\" = 0",
            "`material.specific_heat` cannot be 0 J/(kg.K): it must be a finite number, greater than 0",
        ),
        (
            "",
            "\"material.density\" = 0",
            "`material.density` cannot be 0 kg/m3: it must be a finite number, greater than 0 kg/m3",
        ),
        (
            "",
            "\"wind.speed\" = 300",
            "heat.parameters.\"wind.speed\" = 300: must lie between 0 and 115 m/s",
        ),
        (
            "probe = [{ chainage_m = 30.0 }, { chainage_m = 100.0 }]",
            "",
            "heat.probe[2].chainage_m = 100.0: must lie on the modelled rail, from 0 m to 60 m",
        ),
    ] {
        let said = refusal(keys, parameters, ("unused", ""));
        assert!(said.contains(wanted), "{wanted} in {said}");
    }
}
