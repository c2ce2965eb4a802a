//! `hotfoot profile`.

use tools::profile::{ProfileArguments, profile};

use crate::table::{arguments, refusal};

const PROFILES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/profiles");

/// What is understood of a file.
fn understood(file: &str, words: &[&str]) -> String {
    let words = [&[file], words].concat();
    let arguments = arguments::<ProfileArguments>(&words).expect("arguments that can be typed");
    profile(&arguments).expect("a profile")
}

fn shipped(file: &str) -> String {
    format!("{PROFILES}/{file}")
}

/// The value in a line.
fn value(text: &str, name: &str) -> String {
    let line = text.lines().find(|line| line.starts_with(name));
    line.unwrap_or_else(|| panic!("{name} is missing in {text}"))[name.len()..].trim().to_owned()
}

/// The number at the beginning of a value.
fn number(text: &str, name: &str) -> f64 {
    value(text, name).split(' ').next().unwrap().parse().unwrap()
}

/// S1002 has Sd 32.5, Sh 28 and qR 10.8 mm (EN 13715, EN 15313), here from its points. Tolerance: what
/// smoothing moves of the flange's tip, of 12 mm radius.
#[test]
fn benchmark_the_flange_of_s1002() {
    let text = understood(&shipped("wheel-clean.txt"), &[]);
    assert_eq!(value(&text, "profile"), "wheel");
    assert_eq!(value(&text, "format"), "columns");
    assert_eq!(value(&text, "unit"), "mm");
    for (name, expected) in
        [("flange height", 28.0), ("flange thickness", 32.5), ("flange gradient", 10.8)]
    {
        assert!((number(&text, name) - expected).abs() < 0.05, "{name}: {text}");
    }
    assert!(value(&text, "running circle").contains("slope is -0.0336"), "{text}");
}

/// What rounding to 0.01 mm has is taken away: 0.01 mm/sqrt(12) = 2.9 µm rms.
#[test]
fn analytic_the_roughness_of_rounded_points() {
    let text = understood(&shipped("rail-rounded.txt"), &[]);
    let rms = number(&text, "removed");
    assert!((2.3..3.3).contains(&rms), "{text}");
    assert!(value(&text, "smoothed").contains("4 mm"));
    let as_it_is = understood(&shipped("rail-rounded.txt"), &["--smoothing-mm", "0"]);
    assert_eq!(number(&as_it_is, "removed"), 0.0);
}

/// 60E1 is 72 mm wide at 14 mm depth, leaning by 1:40 here; deeper the face is no nearer by much.
#[test]
fn the_gauge_point_is_that_of_the_depth() {
    let at = |words: &[&str]| {
        let text = value(&understood(&shipped("rail-clean.txt"), words), "gauge point");
        text.trim_start_matches("at ").split(' ').next().unwrap().parse::<f64>().unwrap()
    };
    let (shallow, deep) = (at(&[]), at(&["--gauge-depth-mm", "15.875"]));
    assert!(
        (-35.6..-35.4).contains(&shallow) && (-35.8..shallow).contains(&deep),
        "{shallow} {deep}"
    );
    let missing = understood(&shipped("rail-two-points.txt"), &[]);
    assert!(value(&missing, "gauge point").contains("they end 11.8"), "{missing}");
}

/// Metres are refused with the unit, and written in mm with it; the new file is the same wheel.
#[test]
fn lengths_in_another_unit_are_written_in_mm() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).display().to_string();
    let clean = std::fs::read_to_string(shipped("wheel-clean.txt")).unwrap();
    let metres: String = clean
        .lines()
        .map(|line| {
            let numbers = line
                .split_whitespace()
                .map(|number| format!("{:.7} ", 1e-3 * number.parse::<f64>().unwrap()));
            numbers.collect::<String>() + "\n"
        })
        .collect();
    std::fs::write(path("metres.txt"), metres).unwrap();
    let message = refusal::<ProfileArguments>(profile, &[&path("metres.txt"), "--kind", "wheel"]);
    assert!(message.contains("are the lengths metres? Then"), "{message}");
    let (new, plot) = (path("new.txt"), path("new.svg"));
    let words = ["--kind", "wheel", "--unit", "m", "--write", &new, "--plot", &plot];
    let text = understood(&path("metres.txt"), &words);
    assert_eq!((value(&text, "unit"), value(&text, "written to")), ("m".into(), new.clone()));
    let again = understood(&new, &[]);
    assert_eq!(value(&again, "smoothed"), "no");
    assert_eq!(number(&again, "flange height"), number(&text, "flange height"));
    let svg = std::fs::read_to_string(&plot).unwrap();
    for name in ["height in mm", "angle in degrees", "removed by smoothing in µm", "running circle"]
    {
        assert!(svg.contains(name), "{name} is missing");
    }
}

#[test]
fn what_cannot_be_is_answered_with_what_is_right() {
    let missing = refusal::<ProfileArguments>(profile, &["/nowhere/w.whl"]);
    assert!(missing.contains("/nowhere/w.whl: No such file"), "{missing}");
    let unit = refusal::<ProfileArguments>(profile, &["w.whl", "--unit", "furlong"]);
    assert!(unit.contains("[possible values: mm, cm, m, in, um]"), "{unit}");
}
