//! The heated rails in a run and after it: both of them, further trains, cooling, and what a
//! disk that refuses the field does to the run.

use hotfoot::recording::{KeyValue, SeriesReader};
use hotfoot_tests::SmallScenario;

/// Simulated time of the run, s: the whole train passes the probe in it.
const RUN: f64 = 8.0;

/// Two vehicles that pass a probe 30 m ahead on a rail of 60 m, in the energy model.
fn scenario(keys: &str, parameters: &str) -> SmallScenario {
    let keys = format!("field_interval_s = 2.0\nprobe = [{{ chainage_m = 30.0 }}]\n{keys}");
    SmallScenario::heating_a_short_rail(RUN, &keys, parameters)
}

/// The rows of one rail.
struct Rail {
    table: SeriesReader,
    side: &'static str,
}

impl Rail {
    fn of(scenario: &SmallScenario, side: &'static str) -> Self {
        Self {
            table: SeriesReader::open(&scenario.results().join("series"), "rail").unwrap(),
            side,
        }
    }

    fn column(&self, name: &str) -> Vec<f64> {
        self.table.read(name, &[("rail", KeyValue::Text(self.side))]).unwrap()
    }

    fn last(&self, name: &str) -> f64 {
        *self.column(name).last().unwrap()
    }
}

/// The heat of friction of both rails is what the wheels' friction power says: half of its work on
/// the modelled rail, to the 20 ms over which the power is averaged where a wheel enters or leaves.
#[test]
fn analytic_each_rail_gets_the_friction_of_its_own_wheels() {
    let scenario = scenario("rail = \"both\"", "");
    scenario.run_well(&[]);
    let [left, right] = ["left", "right"].map(|side| Rail::of(&scenario, side));
    for rail in [&left, &right] {
        let (friction, error) = (rail.last("energy.friction"), rail.last("energy.error"));
        let moved = friction.abs() + rail.last("energy.chill").abs();
        assert!(friction > 0.0 && error.abs() < 1e-9 * moved, "{friction} J, error {error} J");
        let wheels = SeriesReader::open(&scenario.results().join("series"), "wheels").unwrap();
        let keys = [("side", KeyValue::Text(rail.side))];
        let power = wheels.read("friction_power", &keys).unwrap();
        let place = wheels.read("position", &keys).unwrap();
        let on_rail = power.iter().zip(&place).filter(|(_, x)| (0.0..60.0).contains(*x));
        let work = 0.5 * 0.1 * on_rail.map(|(power, _)| power).sum::<f64>();
        assert!((friction / work - 1.0).abs() < 0.05, "{} {friction} J, {work} J", rail.side);
    }
    assert!(scenario.results().join("rail-left.zarr").is_dir());
    assert!(scenario.results().join("rail-right.zarr").is_dir());
    assert_ne!(left.last("energy.friction"), right.last("energy.friction"), "it is a curve");
}

/// One rail of two is the same as that rail alone: nothing is shared between them.
#[test]
fn property_a_rail_does_not_know_the_other() {
    let (both, right) = (scenario("rail = \"both\"", ""), scenario("rail = \"right\"", ""));
    both.run_well(&[]);
    right.run_well(&[]);
    let of = |run: &SmallScenario| Rail::of(run, "right").column("energy.stored");
    assert_eq!(of(&both), of(&right));
}

/// Three trains leave three times the friction heat of one, at the probe and in all, to rounding;
/// the rail's time goes on after the last of them, in which no friction is added, heat comes to the
/// foot, and the audit closes. Without sun, whose light the trains would keep off.
#[test]
fn analytic_three_trains_leave_three_times_the_heat_and_the_foot_warms_after_them() {
    let overcast = "\"solar.irradiance\" = 0.0";
    let one = scenario("", overcast);
    one.run_well(&[]);
    let three = scenario(
        "trains = { count = 3, headway_minutes = 2.0 }\ncool_down_minutes = 10.0\ncool_down_step_s = 30.0",
        overcast,
    );
    three.run_well(&[]);
    let (one, three) = (Rail::of(&one, "left"), Rail::of(&three, "left"));
    for heat in ["energy.friction", "probe[1].heat.friction"] {
        let ratio = three.last(heat) / one.last(heat);
        assert!((ratio - 3.0).abs() < 1e-9, "{heat}: {ratio}");
    }
    let time = three.column("time");
    assert!(time.is_sorted_by(|before, after| before < after), "{time:?}");
    assert_eq!(time.last(), Some(&(240.0 + RUN + 600.0)));
    let friction = three.column("energy.friction");
    let end_of_trains = time.iter().position(|t| (t - 240.0 - RUN).abs() < 1e-9).unwrap();
    assert_eq!(friction[end_of_trains], *friction.last().unwrap());
    let foot = three.column("foot.present.rise");
    assert!(foot.last().unwrap() > &(2.0 * foot[end_of_trains]), "heat comes to the foot later");
    let moved = friction.last().unwrap() + three.last("energy.chill").abs();
    assert!(three.last("energy.error").abs() < 1e-9 * moved);
}

/// What stands in the manifest is what the report and the series say.
#[test]
fn property_the_figures_of_the_manifest_are_those_of_the_series() {
    let scenario = scenario("rail = \"both\"\ncool_down_minutes = 5.0", "");
    scenario.run_well(&[]);
    let text = std::fs::read_to_string(scenario.results().join("manifest.toml")).unwrap();
    let manifest: toml::Table = toml::from_str(&text).unwrap();
    let figures = manifest["figure"].as_array().unwrap();
    let value = |key: &str| {
        let found = figures.iter().find(|figure| figure["key"].as_str() == Some(key));
        found.unwrap_or_else(|| panic!("{key} is missing"))["value"].as_float().unwrap()
    };
    for side in ["left", "right"] {
        let rail = Rail::of(&scenario, side);
        let figure = |key: &str| value(&format!("{side}.{key}"));
        assert_eq!(figure("foot.highest"), rail.last("foot.highest.rise"));
        assert_eq!(figure("camera.train"), rail.last("camera.train.highest.rise"));
        assert_eq!(figure("heat.friction.chainage_30_m"), rail.last("probe[1].heat.friction"));
        let mean = rail.last("energy.friction") / 60.0;
        assert_eq!(figure("heat.friction.mean_of_the_modelled_rail"), mean);
    }
    let report = std::fs::read_to_string(scenario.results().join("report.html")).unwrap();
    for part in
        ["Heat per metre by source", "Rise of the foot", "Foot: first reaches 15 mK", "never"]
    {
        assert!(report.contains(part), "{part}");
    }
}

/// A parameter of each type that the FMU has: String, Boolean, Real by a whole number, and a file,
/// which is packed into the FMU and read from there.
#[test]
fn parameters_of_every_type_come_to_the_rail() {
    let parameters = "\"section.model\" = \"column\"\n\"train.shade\" = false\n\
                      \"wheel.initial_rise\" = 50\nweather_file = \"night.csv\"\n";
    let scenario = scenario("cool_down_minutes = 1.0", parameters);
    let weather = "time_s,air_degC,wind_m_s,direct_W_m2,diffuse_W_m2,sun_elevation_deg,sun_azimuth_deg\n\
                   0,10,1,0,0,-30,0\n3600,10,1,0,0,-30,0\n";
    std::fs::write(scenario.folder.path().join("night.csv"), weather).unwrap();
    scenario.run_well(&[]);
    let rail = Rail::of(&scenario, "left");
    let hottest = rail.column("highest.wheel.temperature")[1];
    assert!((hottest - (283.15 + 50.0)).abs() < 0.5, "air of 10 °C and 50 K: {hottest} K");
    assert!(rail.last("energy.chill") > 0.0, "warm wheels heat the rail");
    let fmu = scenario.results().join("fmus/rail.fmu");
    let files = zip_names(&fmu);
    assert!(files.contains("resources/parameters/weather_file/night.csv"), "{files}");
}

/// The names of the files in an archive, as its central directory has them.
fn zip_names(file: &std::path::Path) -> String {
    String::from_utf8_lossy(&std::fs::read(file).unwrap()).into_owned()
}

/// A file where the field's folder should be: as on a disk that refuses it.
#[test]
fn a_field_that_cannot_be_written_stops_the_run_or_is_told() {
    let blocked = |keys: &str| {
        let scenario = scenario(keys, "");
        std::fs::create_dir_all(scenario.results()).unwrap();
        std::fs::write(scenario.results().join("rail.zarr"), "in the way").unwrap();
        scenario
    };
    let stops = blocked("field_failure = \"stop\"").run(&[]);
    let message = String::from_utf8_lossy(&stops.stderr).into_owned();
    assert!(!stops.status.success() && message.contains("rail.zarr"), "{message}");

    let scenario = blocked("field_failure = \"go-on\"");
    let output = scenario.run(&[]);
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(said.contains("warning: rail:") && said.contains("rail.zarr"), "{said}");
    assert!(Rail::of(&scenario, "left").last("energy.friction") > 0.0, "nothing else is lost");
    assert!(scenario.results().join("report.html").exists());
}

/// The rail is modelled behind and ahead of where the wheels stand: that is told before the run.
#[test]
fn wheels_outside_the_modelled_rail_are_told_of_before_the_run() {
    let output = scenario("", "").run(&["--duration", "0.1"]);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(said.contains("note: at the start wheels stand from chainage -28."), "{said}");
    assert!(said.contains("from 0 m to 60 m only"), "{said}");
    let mut short = scenario("", "");
    short.text = short.text.replace("begin_m = 0.0", "begin_m = -50.0");
    short.text = short.text.replace("probe = [{ chainage_m = 30.0 }]", "");
    let output = short.run(&[]);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(
        said.contains("the first wheel comes to chainage") && said.contains("to 10 m only"),
        "{said}"
    );
    let report = std::fs::read_to_string(short.results().join("report.html")).unwrap();
    assert!(report.contains("Note: at the speed of the start"));
}
