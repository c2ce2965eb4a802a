//! FMUs that misbehave at the seam to the master: values that cannot be, settings of the processor, memory
//! that is not theirs, threads, and messages.

use std::process::Output;

use hotfoot::recording::{KeyValue, SeriesReader};
use hotfoot_tests::SmallScenario;
use hotfoot_tests::hostile::Claims;

use crate::hostile::{assert_says, recorded, refusal, run, scenario, text, until_trouble};

/// Number of records of a run that comes to its end.
const ALL: usize = 11;

/// The end of a run that succeeds.
fn success(output: &Output) -> String {
    assert!(output.status.success(), "{}", text(&output.stderr));
    text(&output.stdout)
}

/// A run that ends at 0.05 s with exit code 1, its records until then, and a message with these parts.
fn ends_at_trouble(behaviour: &str, parts: &[&str]) {
    let (scenario, output) = run(behaviour);
    let message = refusal(&output);
    assert_eq!(output.status.code(), Some(1), "{behaviour}");
    assert_says(&message, &["at 0.05 s", "vehicle[2]", "hostile.fmu", "the results until then"]);
    assert_says(&message, parts);
    assert_eq!(recorded(&scenario), until_trouble(), "{behaviour}");
}

/// A run that comes to its end with a warning of these parts.
fn warns(behaviour: &str, parts: &[&str]) {
    let (scenario, output) = run(behaviour);
    let told = success(&output);
    assert_says(&told, parts);
    assert_eq!(told.matches(parts[0]).count(), 1, "{behaviour} is told once: {told}");
    assert_eq!(recorded(&scenario).len(), ALL, "{behaviour}");
}

#[test]
fn a_value_that_is_not_finite_ends_the_run() {
    for (behaviour, value) in [("NAN_SPEED", "NaN"), ("INFINITE_SPEED", "inf")] {
        let check = format!("the check of velocity = {value} at 0.051 s failed");
        ends_at_trouble(behaviour, &[&check, "is not a finite number"]);
    }
}

#[test]
fn a_value_out_of_its_range_is_a_warning_once() {
    warns("HUGE_SPEED", &["velocity = 1000000000.0 at 0.051 s is more than 200.0"]);
    warns("REVERSING", &["velocity = -16.67 at 0.051 s was 16.67 only 0.001000 s before"]);
}

#[test]
fn a_scenario_and_an_option_say_what_becomes_of_such_values() {
    let with = |behaviour, key: &str, options: &[&str]| {
        let mut scenario = scenario(behaviour, &Claims::default());
        scenario.text = format!("{key}{}", scenario.text);
        scenario.run(options)
    };
    let message = refusal(&with("HUGE_SPEED", "checks = \"error\"\n", &[]));
    assert_says(&message, &["velocity = 1000000000.0 at 0.051 s", "more than 200.0"]);
    assert!(!success(&with("HUGE_SPEED", "checks = \"off\"\n", &[])).contains("velocity"));
    // The option goes before the key.
    let output = with("HUGE_SPEED", "checks = \"error\"\n", &["--checks", "warn"]);
    assert_says(&success(&output), &["warning: vehicle[2]: velocity = 1000000000.0"]);
    // What is let through reaches others: the controller says that it cannot go on.
    let message = refusal(&with("NAN_SPEED", "", &["--checks", "warn"]));
    assert_says(&message, &["controller[2]", "sync.force"]);
    let message = refusal(&with("WELL", "checks = \"no\"\n", &[]));
    assert_says(&message, &["checks", "error", "warn", "off"]);
}

/// The values of a column at all records and all vehicles but the hostile one, to the bit.
fn others(scenario: &SmallScenario) -> Vec<u64> {
    let reader = SeriesReader::open(&scenario.results().join("series"), "vehicles").unwrap();
    let mut bits = vec![];
    for vehicle in [1, 3, 4, 5] {
        for column in ["position", "velocity", "friction_power", "creep_force"] {
            let values = reader.read(column, &[("vehicle", KeyValue::Integer(vehicle))]).unwrap();
            bits.extend(values.into_iter().map(f64::to_bits));
        }
    }
    bits
}

#[test]
fn what_an_fmu_changes_of_the_processor_is_put_back_and_told_once() {
    let well = |options: &[&str]| {
        let scenario = scenario("WELL", &Claims::default());
        scenario.run_well(options);
        others(&scenario)
    };
    let expected = well(&[]);
    for (behaviour, change) in [
        ("ROUNDING", "another rounding than to nearest"),
        ("FLUSHING", "denormal numbers taken for zero"),
        ("TRAPPING", "floating-point exceptions trapped"),
    ] {
        let told = format!("vehicle[2]: fmi2DoStep left the processor with {change} at 0.05 s");
        warns(behaviour, &[&told]);
        // One thread calls all: what is left behind would reach all others.
        let scenario = scenario(behaviour, &Claims::default());
        scenario.run_well(&["--threads", "1"]);
        assert_eq!(others(&scenario), expected, "{behaviour}");
    }
    warns("ROUNDING_AT_LOAD", &["vehicle[2]: loading its binary left the processor with another"]);
}

#[test]
fn what_an_fmu_writes_outside_of_its_arrays_is_named() {
    for behaviour in ["WRITES_BEYOND", "WRITES_BEFORE"] {
        let parts = ["fmi2GetReal of", "it has written outside of the array of 2 values"];
        ends_at_trouble(behaviour, &parts);
    }
    let parts = ["fmi2GetReal of", "it has changed the value references"];
    ends_at_trouble("CHANGES_REFERENCES", &parts);
    ends_at_trouble("CHANGES_INPUTS", &["fmi2SetReal of", "it has changed the values that"]);
}

#[test]
fn a_double_free_in_a_step_is_named_and_all_that_was_recorded_is_there() {
    let (scenario, output) = run("DOUBLE_FREE");
    let parts = ["vehicle[2]", "hostile.fmu", "fmi2DoStep crashed", "SIGABRT", "the results until"];
    assert_says(&refusal(&output), &parts);
    assert_eq!(recorded(&scenario), until_trouble());
}

/// With one thread it is always the same; with more the scenario, or an option, asks for it.
#[test]
fn an_fmu_for_one_thread_is_called_by_the_thread_that_has_made_it() {
    let mut scenario = scenario("ONE_THREAD", &Claims::default());
    let complete = |scenario: &SmallScenario, options: &[&str]| {
        scenario.run_well(options);
        assert_eq!(recorded(scenario).len(), ALL, "{options:?}");
    };
    complete(&scenario, &["--threads", "1"]);
    complete(&scenario, &["--threads", "4", "--same-thread"]);
    let own = "file = \"hostile.fmu\", same_thread = true }";
    scenario.text = scenario.text.replace("file = \"hostile.fmu\" }", own);
    complete(&scenario, &["--threads", "4"]);
    let exported = scenario.hotfoot(&["export-ssp", "scenario.toml", "-o", "train.ssp"]);
    assert!(exported.status.success(), "{}", text(&exported.stderr));
    let run = ["run", "train.ssp", "--quiet", "--threads", "4", "--results", "of-package"];
    success(&scenario.hotfoot(&run));
}

#[test]
fn a_message_finds_its_instance_whatever_the_environment_is() {
    for behaviour in ["NULL_ENVIRONMENT", "OWN_ENVIRONMENT", "FOREIGN_THREAD"] {
        let (scenario, output) = run(behaviour);
        assert_says(&success(&output), &["warning: vehicle[2]: the bearing is warm"]);
        assert_eq!(recorded(&scenario).len(), ALL, "{behaviour}");
    }
}

#[test]
fn a_message_after_the_end_of_its_instance_is_told_at_once() {
    let (scenario, output) = run("MESSAGE_AFTER_FREE");
    success(&output);
    let told = "warning: vehicle[2] (hostile.fmu): the bearing is warm (after fmi2FreeInstance)";
    let stderr = text(&output.stderr).replace(&scenario.folder.path().display().to_string(), "");
    assert_says(&stderr.replace("(/", "("), &[told]);
    assert_eq!(recorded(&scenario).len(), ALL);
}

#[test]
fn a_thread_that_outlives_its_instance_does_no_harm() {
    let (scenario, output) = run("THREAD_OUTLIVES");
    assert_says(&success(&output), &["warning: vehicle[2]: still here"]);
    assert_eq!(recorded(&scenario).len(), ALL);
}

#[test]
fn control_characters_in_a_message_are_shown_and_not_sent_to_the_terminal() {
    let (_, output) = run("CONTROL_CHARACTERS");
    assert!(!output.stdout.contains(&0x1b), "the escape character is passed on");
    assert_says(&success(&output), &["\\u{1b}[2J\\u{1b}]0;all is well\\u{7} at 0.05 s"]);
}

#[test]
fn of_many_messages_the_first_are_told_and_how_many_more() {
    let (_, output) = run("MANY_MESSAGES");
    let told = success(&output);
    assert_eq!(told.matches("warning: vehicle[2]: low oil at").count(), 20, "{told}");
    assert_says(&told, &["vehicle[2]: and 30 more messages"]);
}
