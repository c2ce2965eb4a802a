//! The report of an invented system.

use std::path::Path;

use super::provenance::{PartTime, Provenance, UnitFacts};
use super::system::{ComponentFacts, SystemFacts};
use super::write;
use crate::recording::{Column, SeriesWriter};

/// Number of records, 0.1 s apart.
const RECORDS: u32 = 20;

fn component(name: &str, wall_time_s: f64) -> ComponentFacts {
    ComponentFacts {
        name: name.to_owned(),
        fmu: format!("{name}.fmu"),
        series: Some(name.to_owned()),
        wall_time_s,
    }
}

fn facts() -> SystemFacts {
    let silent = ComponentFacts { series: None, ..component("silent", 0.0) };
    SystemFacts {
        name: "a <tank> and a pump".to_owned(),
        package: "tank.ssp".to_owned(),
        simulated_s: 2.0,
        step_s: 1e-3,
        threads: 2,
        wall_time_s: Some(0.5),
        recording_s: 0.05,
        component: vec![component("tank", 0.4), component("pump", 0.002), silent],
    }
}

/// What was run, with the time of the tank and what the pump warned of.
fn provenance() -> Provenance {
    let unit = |name: &str, wall_time_s: f64, message: Option<&str>| UnitFacts {
        name: name.to_owned(),
        fmu: format!("{name}.fmu"),
        wall_time_s,
        slowest_step_s: 1e-3,
        slowest_at_s: 1.5,
        last_message: message.map(str::to_owned),
    };
    Provenance {
        command: "hotfoot run tank.ssp".to_owned(),
        begun: "2026-11-30 12:00:00 UTC".to_owned(),
        end: "complete".to_owned(),
        wall_time_of: vec![PartTime { part: "stage 1".to_owned(), seconds: 0.4 }],
        unit: vec![unit("tank", 0.4, None), unit("pump", 0.1, Some("the <pump> runs dry"))],
        ..Provenance::default()
    }
}

/// A table whose columns are, in turn, a force, ten speeds in km/h, and a number that never changes.
fn write_table(folder: &Path, name: &str) {
    let speeds = (1..=10).map(|i| Column::new(&format!("speed[{i}]"), "km/h", "Speed").double());
    let mut columns = vec![Column::new("force", "N", "Force").double()];
    columns.extend(speeds);
    columns.push(Column::new("gears", "1", "Number of gears").double());
    let count = columns.len();
    let series = folder.join("series");
    let mut writer = SeriesWriter::create(&series, name, vec![], columns, 100).unwrap();
    for record in 0..RECORDS {
        let time = f64::from(record) / 10.0;
        let mut values = vec![1e3 * time; count];
        values[count - 1] = 5.0;
        writer.observe(0, &values);
        writer.record(time).unwrap();
    }
    writer.finish().unwrap();
}

fn report(facts: SystemFacts) -> String {
    #[derive(serde::Serialize)]
    struct Manifest {
        system: SystemFacts,
        #[serde(flatten)]
        provenance: Provenance,
    }
    let folder = tempfile::tempdir().unwrap();
    let provenance = provenance();
    let text = toml::to_string(&Manifest { system: facts, provenance }).unwrap();
    std::fs::write(folder.path().join("manifest.toml"), text).unwrap();
    write_table(folder.path(), "tank");
    write_table(folder.path(), "pump");
    let (file, figures) = write(folder.path()).unwrap();
    assert!(figures.is_empty(), "a system has no main figures");
    std::fs::read_to_string(file).unwrap()
}

#[test]
fn the_page_of_a_system_has_facts_times_and_what_changed() {
    let page = report(facts());
    for wanted in [
        "a &lt;tank&gt; and a pump",
        "3 components from tank.ssp",
        "2 s simulated in steps of",
        "500 ms in all with 2 threads, of which recording took 50.0 ms",
        "<td>tank <span class=\"location\">tank.fmu</span></td><td class=\"value\">400 ms</td><td class=\"value\">80.0 %</td>",
        "the &lt;pump&gt; runs dry",
        "What was run",
        "hotfoot run tank.ssp",
        "Value in kN",
        "Value in km/h",
        // Of 24 quantities, each table shows its force and as many speeds as there are colours.
        "8 further quantities",
        "hotfoot report",
    ] {
        assert!(page.contains(wanted), "'{wanted}' is missing");
    }
    assert_eq!(page.matches("<svg").count(), 4);
    assert!(!page.contains("gears"), "what keeps its value has no curve");
    for outside in ["src=", "href=", "@import", "url(http", "<script", "<link"] {
        assert!(!page.contains(outside), "{outside}");
    }
}

#[test]
fn a_run_that_was_killed_says_so_and_tells_no_times() {
    let page = report(SystemFacts { simulated_s: 0.0, wall_time_s: None, ..facts() });
    assert!(page.contains("this run has not finished") && !page.contains("Wall time"));
    assert_eq!(page.matches("<svg").count(), 4, "what was recorded is shown");
}
