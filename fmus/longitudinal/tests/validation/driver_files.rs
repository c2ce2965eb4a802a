//! What is refused of the files of drivers: loggers, profiles, drivers of two kinds.

use std::path::Path;

use longitudinal::driver::Driver;
use track::Track;

use crate::drivers::{REPLAY, SPEED, driver};

fn refused(text: &str, logger: &str) -> String {
    driver(text, &[("logger.csv", logger)]).unwrap_err().to_string()
}

#[test]
fn a_logger_with_a_gap_is_refused_by_line() {
    let message = refused(REPLAY, "Time (s),Notch,DB,Speed\n0,1,0,9\n1,1,0,9\n60,1,0,9\n");
    assert!(message.contains("logger.csv:4:1: Time (s) = 60: a gap of 59 s"), "{message}");
}

#[test]
fn a_logger_that_goes_back_in_time_is_refused_by_line() {
    let message = refused(REPLAY, "Time (s),Notch,DB,Speed\n5,1,0,9\n4,1,0,9\n");
    assert!(message.contains("logger.csv:3:1: Time (s) = 4: goes back"), "{message}");
}

#[test]
fn a_logger_without_a_number_is_refused_by_line() {
    let message = refused(REPLAY, "Time (s),Notch,DB,Speed\n0,1,0,9\n1,idle,0,9\n");
    assert!(message.contains("Notch = idle: must be a number"), "{message}");
}

#[test]
fn a_column_that_the_logger_does_not_have_is_refused_with_those_it_has() {
    let message = refused(REPLAY, "Time (s),Throttle,DB,Speed\n0,1,0,9\n");
    assert!(message.contains("replay.throttle = 'Notch'"), "{message}");
}

#[test]
fn a_notch_beyond_the_table_is_refused_by_line() {
    let message = refused(REPLAY, "Time (s),Notch,DB,Speed\n0,9,0,9\n");
    assert!(message.contains("Notch = 9: must lie between 0 and 8"), "{message}");
}

#[test]
fn a_driver_of_two_kinds_is_refused() {
    let text = format!("{SPEED}[cruise]\n[fuzzy]\n");
    let message = refused(&text, "");
    assert!(message.contains("fuzzy: a driver is of one kind"), "{message}");
}

#[test]
fn a_profile_that_goes_back_is_refused() {
    let text = "profile = [{ lever = 'throttle', chainage_m = [0, 5, 4], value = [0, 1, 0] }]";
    let message = refused(text, "");
    assert!(
        message
            .contains("profile[1].chainage_m[3] = 4: must be greater than the value before it, 5"),
        "{message}"
    );
}

/// The international benchmark is prepared but open: each of its files is refused by what is missing.
#[test]
fn the_open_benchmark_is_refused_until_it_is_filled_in() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenarios/benchmarks/ibltd");
    let stock = stock::Library::open(folder.join("stock")).unwrap();
    let messages = [
        stock::Consist::from_file(&folder.join("consist.toml")).unwrap_err().to_string(),
        Track::from_file(&folder.join("track.toml")).unwrap_err().to_string(),
        Driver::from_file(&folder.join("driver.toml")).unwrap_err().to_string(),
        stock.vehicle("ibltd-wagon").unwrap_err().to_string(),
        stock.vehicle("ibltd-locomotive").unwrap_err().to_string(),
        stock.draft_gear("ibltd-gear").unwrap_err().to_string(),
    ];
    for message in messages {
        assert!(message.contains("ibltd") && message.contains("FILL IN"), "{message}");
    }
}
