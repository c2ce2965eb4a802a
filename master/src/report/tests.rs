//! The report of an invented run.

use super::collect::ReportData;
use super::collect::collect;
use super::invented::{facts, write_run};
use super::page::render;
use super::*;

fn report(facts: &RunFacts) -> (ReportData, String) {
    let folder = tempfile::tempdir().unwrap();
    write_run(folder.path(), facts);
    let data = collect(folder.path()).unwrap();
    let page = render(&data).unwrap();
    (data, page)
}

/// What stands in the page before its numbers and scripts.
fn shown(page: &str) -> &str {
    page.split_once("<script type=\"application/json\"").expect("the page has its numbers").0
}

#[test]
fn the_page_has_every_section_and_stands_alone() {
    let (_, page) = report(&facts());
    for section in [
        "Rise of the foot: highest along the track",
        "Rise of the foot: under the last wheel",
        "Heat per metre by source, left rail",
        "Speed of the leading vehicle",
        "Coupler forces of the whole train",
        "The run in one view",
        "Main figures",
        "Temperature of the rail",
        "Energy audit of the rail",
        "Energy audit",
        "What was run",
    ] {
        assert!(shown(&page).contains(&format!(">{section}<")), "{section} is missing");
    }
    assert!(page.contains("Curve &lt;test&gt; &amp; more"), "the title is escaped");
    assert!(page.contains("wheels &lt;outside&gt; heat nothing"), "the note is shown");
    for outside in ["src=", "href=", "@import", "url(", "<link", "<iframe"] {
        assert!(!shown(&page).contains(outside), "{outside}");
    }
    assert_eq!(page.matches("<script").count(), 3, "numbers, library and linked view");
    assert!(!page.contains("<script src") && !page.contains("fetch(") && !page.contains("import("));
    assert!(page.len() < 2_000_000, "{} bytes", page.len());
}

/// Screen readers say what a drawing shows.
#[test]
fn every_drawing_has_a_title() {
    let (_, page) = report(&facts());
    let drawings: Vec<&str> = shown(&page).split("<svg ").skip(1).collect();
    assert_eq!(drawings.len(), 6);
    for drawing in drawings {
        assert!(drawing.starts_with("role=\"img\""), "{}", &drawing[..60]);
        assert!(drawing.split_once('>').unwrap().1.starts_with("<title>"), "{}", &drawing[..200]);
    }
}

/// The left foot reaches 15 mK, the right one does not; friction brings most heat.
#[test]
fn the_first_screen_answers() {
    let (_, page) = report(&facts());
    // The template escapes more than it must.
    let page = page.replace("&#x2f;", "/");
    for sentence in [
        "Yes: the foot of the left rail warms by 15 mK.",
        "The foot of the left rail first reaches 15 mK at chainage 88.0 m, 14.7 min after the end of",
        "A camera on the train does not see it: 100 µK under the last wheel.",
        "A camera at the track side sees it after the train: 24.7 mK.",
        "Most heat of the left rail comes by friction: 20.0 J/m in the mean along it.",
    ] {
        assert!(page.contains(sentence), "{sentence}");
    }
    let (_, page) = report(&RunFacts { rails: None, ..facts() });
    assert!(page.contains("No rail was heated in this run."));
    assert!(page.contains("Largest coupler tension: 90.0 kN, rear coupler of vehicle 1 at 0 s."));
}

/// The left foot is warmest at 99 m, and the probes are elsewhere; the right rail has no field. Without the
/// section where the foot is warmest, as in older results, the page says how one comes to it.
#[test]
fn a_section_that_was_not_kept_is_told_with_its_key() {
    let folder = tempfile::tempdir().unwrap();
    write_run(folder.path(), &facts());
    let page = || render(&collect(folder.path()).unwrap()).unwrap();
    let begin = "The foot of the left rail is warmest at chainage 99.0 m, but";
    assert!(!page().contains(begin), "the section is there");
    std::fs::remove_dir_all(folder.path().join("rail-left.zarr/warmest_section_rise")).unwrap();
    let page = page();
    let sentence = "The foot of the left rail is warmest at chainage 99.0 m, but sections were kept at 100.5 m, 120.5 m \
                    only: { chainage_m = 99.0 } among the probes of the scenario (heat.probe) keeps the one there";
    assert!(page.contains(sentence), "{}", shown(&page));
    assert!(!page.contains("The foot of the right rail is warmest at chainage"));
}

/// A tension of 90 kN is above 80 kN, and no run gives what it does not record.
#[test]
fn limits_are_judged() {
    let limit = |key: &str, at_most| Limit {
        key: key.to_owned(),
        at_most: Some(at_most),
        source: "test".to_owned(),
        ..Limit::default()
    };
    let figures = vec![
        limit("coupler.tension", 80e3),
        limit("coupler.compression", 80e3),
        limit("outputs.x.highest", 0.8),
    ];
    let limits = LimitFacts { simulated_s: 0.0, figures };
    let (_, page) = report(&RunFacts { limits: limits.clone(), ..facts() });
    assert!(page.contains("1 of 3 limits are exceeded."));
    for words in [">exceeded<", ">kept<", "at most 80.0 kN", "not recorded"] {
        assert!(page.contains(words), "{words}");
    }
    // The invented manifest says that the run came to 0 s.
    let (_, page) =
        report(&RunFacts { limits: LimitFacts { simulated_s: 12.0, ..limits }, ..facts() });
    assert!(page.contains("3 of 3 limits are not judged.") && !page.contains(">kept<"));
}

/// 20 s at 15 m/s are 300 m; 20 s in 4 s of wall time are 5 times real time; the rise is highest
/// where the train has just come to chainage 50 m: at the first record after 50/15 s.
#[test]
fn analytic_main_figures_of_an_invented_run() {
    let (data, _) = report(&facts());
    let figure = |name: &str| {
        let found = data.main_figures.iter().find(|figure| figure.name == name);
        let found = found.unwrap_or_else(|| panic!("{name} is missing"));
        (found.text.as_str(), found.location.as_str())
    };
    assert_eq!(figure("Distance run"), ("300.0 m", "in 20 s"));
    assert_eq!(figure("Speed at the end"), ("15.00 m/s (54.0 km/h)", "change +0.00 m/s"));
    let tension = figure("Largest coupler tension");
    assert_eq!(tension, ("90.0 kN", "rear coupler of vehicle 1 at 0 s"));
    assert_eq!(figure("Largest coupler compression").0, "0 N");
    let creep = figure("Largest longitudinal creep force of a vehicle");
    assert_eq!(creep, ("50.0 kN", "vehicle 1 at 0 s"));
    assert!(figure("Wall time").1.starts_with("5.00 times real time"));
}

/// The rows are those of [`rail_row`]: the left foot reaches 15 mK after 15 min, and 25 mK after
/// 25 min; the record nearest to that is that of 25 min and 20 s.
#[test]
fn analytic_the_answer_on_the_foot_of_each_rail() {
    let (data, page) = report(&facts());
    let figure = |rail: usize, key: &str| {
        let found = data.rails[rail].figures.iter().find(|figure| figure.key == key);
        found.unwrap_or_else(|| panic!("{key} is missing")).clone()
    };
    let surface = figure(0, "left.highest.surface");
    assert_eq!(
        (surface.text.as_str(), surface.location.as_str()),
        ("1.66 K", "chainage 51.0 m at 3.4 s")
    );
    let highest = figure(0, "left.foot.highest");
    assert_eq!((highest.text.as_str(), highest.time_s), ("25.0 mK", Some(1500.0)));
    let detection = figure(0, "left.foot.detection");
    assert_eq!((detection.value, detection.chainage_m), (Some(900.0), Some(88.0)));
    let never = figure(1, "right.foot.detection");
    assert_eq!((never.value, never.text.as_str()), (None, "never"));
    assert_eq!(figure(1, "right.camera.train").text, "50.0 µK");
    let side = figure(0, "left.camera.track_side");
    assert_eq!((side.text.as_str(), side.time_s), ("24.7 mK", Some(1520.0)));
    assert!(
        side.location.ends_with("25.0 min after the run of the last train"),
        "{}",
        side.location
    );
    assert_eq!(data.rails[1].heat[0].location, "chainage 100 m");
    assert_eq!(data.rails[1].heat[1].sources, [10.0, -5.0, 0.5, 0.0], "the mean over 300 m");
    assert_eq!(data.rails[0].energy[1].joules, -3e3);
    assert!(page.contains("chainage 88.0 m at 900 s") && page.contains("never"));
}

/// The paper's model has no answer on the foot, and a run without time after the train says that a
/// camera at the track side was not simulated.
#[test]
fn what_a_run_does_not_tell_is_not_made_up() {
    let of_rails = facts().rails.unwrap();
    let paper = RailFacts { model: "paper".to_owned(), ..of_rails.clone() };
    let (data, page) = report(&RunFacts { rails: Some(paper), ..facts() });
    assert!(data.rails.iter().all(|rail| rail.foot.is_none() && rail.heat.is_empty()));
    assert!(!shown(&page).contains("Rise of the foot") && page.contains("Temperature of the rail"));
    assert!(page.contains("This run does not say whether the rail foot warms by 15 mK"));
    assert!(page.contains(">Rise of the surface: highest along the track<"));
    assert!(page.contains("Do not read from them whether, when or where the foot warms"));
    assert!(!report(&facts()).1.contains("paper&#x27;s model"), "only where it was the model");
    let no_cooling = RailFacts { last_train_end_s: 1e9, ..of_rails };
    let (_, page) = report(&RunFacts { rails: Some(no_cooling), ..facts() });
    assert!(page.contains("not simulated") && page.contains("heat.cool_down_minutes"));
}

#[test]
fn a_run_without_rail_heat_or_locomotives_has_a_report() {
    let facts = RunFacts { locomotives: vec![], wall_time_s: None, energy: vec![], ..facts() };
    let facts = RunFacts { rails: None, ..facts };
    let folder = tempfile::tempdir().unwrap();
    write_run(folder.path(), &facts);
    let page = render(&collect(folder.path()).unwrap()).unwrap();
    assert!(page.contains("this run has not finished"));
    assert!(!shown(&page).contains("Rise of the"));
    assert!(page.contains("0 of them locomotives"));
}

#[test]
fn property_a_report_is_the_same_each_time_it_is_made() {
    assert!(report(&facts()).1 == report(&facts()).1);
}

#[test]
fn a_folder_without_manifest_is_refused_by_name() {
    let folder = tempfile::tempdir().unwrap();
    let error = collect(folder.path()).err().unwrap().to_string();
    assert!(error.contains("manifest.toml: No such file"), "{error}");
    std::fs::write(folder.path().join("manifest.toml"), "[run]\ntitle = 3\n").unwrap();
    let error = collect(folder.path()).err().unwrap().to_string();
    assert!(error.contains("line 2") && error.contains("manifest.toml"), "{error}");
}

#[test]
fn what_is_written_is_what_is_rendered() {
    let folder = tempfile::tempdir().unwrap();
    write_run(folder.path(), &facts());
    let (file, figures) = write(folder.path()).unwrap();
    let page = render(&collect(folder.path()).unwrap()).unwrap();
    assert!(std::fs::read_to_string(file).unwrap() == page);
    assert_eq!(figures[0].name, "Distance run");
}
