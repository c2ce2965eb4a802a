//! Whatever goes wrong, each sentence of the answer comes once.

use std::collections::BTreeSet;
use std::process::Output;

use hotfoot_tests::{SmallScenario, fmu, hotfoot};

/// Words from which on a part of an answer is a sentence; shorter ones are names and numbers.
const SENTENCE: usize = 4;

/// The sentences of an answer: what stands between colons, semicolons and line ends. Lines that show
/// a file are none.
fn sentences(answer: &str) -> Vec<String> {
    let gutter = |c: char| c == ' ' || c.is_ascii_digit();
    let shows_a_file = |line: &str| line.trim_start_matches(gutter).starts_with('|');
    let lines = answer.lines().filter(|line| !shows_a_file(line));
    let lines = lines.flat_map(|line| line.split([':', ';']));
    let words = lines.map(|part| part.split_whitespace().collect::<Vec<_>>());
    words.filter(|words| words.len() >= SENTENCE).map(|words| words.join(" ")).collect()
}

/// What makes a small scenario wrong.
type Change = fn(&mut SmallScenario);

/// Fails if the command succeeds, says a sentence twice, or speaks of the program's inside.
fn assert_each_once(what: &str, output: &Output) {
    let answer = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(!output.status.success(), "{what} succeeded");
    assert!(!answer.trim().is_empty(), "{what} says nothing");
    assert!(!answer.contains("panicked") && !answer.contains("RUST_BACKTRACE"), "{what}: {answer}");
    let mut said = BTreeSet::new();
    for sentence in sentences(&answer) {
        assert!(said.insert(sentence.clone()), "{what} says '{sentence}' twice: {answer}");
    }
}

#[test]
fn no_sentence_comes_twice_whatever_file_is_wrong() {
    let change: [(&str, Change); 15] = [
        ("an unknown key", |s| s.text = s.text.replace("duration_s", "durationn_s")),
        ("a step of zero", |s| s.text = s.text.replace("step_s = 0.001", "step_s = 0.0")),
        ("no TOML", |s| s.text = s.text.replace("step_s = 0.001", "step_s = 0,001")),
        ("no track file", |s| s.text = s.text.replace("\"track.toml\"", "\"trck.toml\"")),
        ("no vehicle", |s| s.text = s.text.replace("wagon-coco-134t-unpowered", "wagon-of-gold")),
        ("a radius of zero", |s| s.track = s.track.replace("radius_m = 800.0", "radius_m = 0.0")),
        ("an unknown key of the track", |s| s.track += "\nlenght = 1\n"),
        ("a track that is no TOML", |s| s.track = "start_m = ".to_owned()),
        ("a notch of 9", |s| s.driver = "command = [{ from_s = 0, notch = 9 }]".to_owned()),
        ("a command without beginning", |s| s.driver = "command = [{ notch = 1 }]".to_owned()),
        ("a driver of two kinds", |s| s.driver = "[cruise]\n[fuzzy]\n".to_owned()),
        ("an unknown parameter", |s| s.text += "\n[heat.parameters]\n\"cellsize\" = 0.005\n"),
        ("a parameter beyond its bounds", |s| {
            s.text += "\n[heat.parameters]\n\"cell.size\" = -1.0\n"
        }),
        ("a missing FMU", |s| s.text += "\n[fmus]\nvehicle = \"none.fmu\"\n"),
        ("outputs that match nothing", |s| s.text += "\n[record]\noutputs = [\"*.none\"]\n"),
    ];
    for (what, change) in change {
        let mut scenario = SmallScenario::new(0.01);
        change(&mut scenario);
        assert_each_once(what, &scenario.run(&[]));
    }
}

#[test]
fn no_sentence_comes_twice_whatever_command_is_wrong() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("bad.fmu"), "no archive").unwrap();
    std::fs::write(folder.path().join("bad.ssp"), "no archive").unwrap();
    let railheat = fmu("railheat").display().to_string();
    for words in [
        &["run", "nowhere"][..],
        &["run", "."],
        &["run", "nowhere", "--threads", "0"],
        &["run", "nowhere", "--duration", "10s"],
        &["run", "bad.ssp", "--results", "r"],
        &["run", ".", "--results", "bad.fmu"],
        &["report", "."],
        &["report", "nowhere"],
        &["expect", ".", "expected.toml"],
        &["check", "bad.fmu"],
        &["check", "none.fmu"],
        &["check", &railheat, "--as", "vehicle"],
        &["pack", "none.so", "--output", "out.fmu"],
        &["pack", "bad.fmu", "--output", "out.fmu"],
        &["interface", "bad.fmu"],
        &["interface", "none.fmu"],
        &["export-ssp", "nowhere"],
        &["modes", "none"],
        &["contact", "--wheel", "none"],
        &["creep", "--load", "1"],
        &["critical-speed", "none"],
    ] {
        assert_each_once(&words.join(" "), &hotfoot(folder.path(), words));
    }
}

/// The same names of options as others have are taken, and what is wrong is said with the remedy.
#[test]
fn wrong_options_are_answered_with_what_is_right() {
    let folder = tempfile::tempdir().unwrap();
    for (words, wanted) in [
        (&["run", "x", "--threads", "0"][..], "must be a whole number, at least 1"),
        (&["run", "x", "--threads", "all"], "must be a whole number, at least 1"),
        (&["run", "x", "--duration", "10s"], "must be a number, without a unit"),
        (&["run", "x", "--step", "0,001"], "must be a number, with a decimal point"),
        (&["report", "."], "it has no manifest.toml"),
        (&["check", "none.fmu"], "none.fmu: there is no such file"),
        (&["check", "x.fmu", "--as", "wagon"], "possible values: longitudinal, vehicle, railheat"),
    ] {
        let output = hotfoot(folder.path(), words);
        let answer = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(!output.status.success() && answer.contains(wanted), "{words:?}: {answer}");
    }
}

/// `hotfoot help COMMAND` shows what `hotfoot COMMAND --help` does, of every command.
#[test]
fn help_shows_the_options_of_every_command() {
    let folder = tempfile::tempdir().unwrap();
    let text = |words: &[&str]| {
        let output = hotfoot(folder.path(), words);
        assert!(output.status.success(), "{words:?}");
        String::from_utf8(output.stdout).unwrap()
    };
    let commands = text(&["--help"]);
    let list = commands.split("Commands:\n").nth(1).and_then(|text| text.split("\n\n").next());
    let names = list.unwrap().lines().filter_map(|line| line.strip_prefix("  "));
    let names = names.filter(|line| !line.starts_with(' '));
    let names: Vec<&str> = names.filter_map(|line| line.split_whitespace().next()).collect();
    assert!(names.contains(&"run") && names.contains(&"creep"), "{names:?}");
    for name in names.into_iter().filter(|name| *name != "help") {
        assert_eq!(text(&["help", name]), text(&[name, "--help"]), "{name}");
    }
    assert!(text(&["help", "creep"]).contains("--semi-axes-mm"));
}
