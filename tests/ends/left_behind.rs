//! What stays behind of a run whose FMU misbehaves, in any way that `hostile.c` knows: nothing.

use std::fs;
use std::path::{Path, PathBuf};

use hotfoot_tests::package::HostilePackage;

use super::is_running;

/// Whatever an FMU does, no process and no temporary file is left when the program has ended.
#[test]
fn no_misbehaviour_leaves_anything_behind() {
    let in_seam = [
        "NAN_SPEED",
        "INFINITE_SPEED",
        "HUGE_SPEED",
        "REVERSING",
        "ROUNDING",
        "FLUSHING",
        "TRAPPING",
        "ROUNDING_AT_LOAD",
        "ONE_THREAD",
        "MESSAGE_AFTER_FREE",
        "THREAD_OUTLIVES",
        "DOUBLE_FREE",
        "WRITES_BEYOND",
        "WRITES_BEFORE",
        "CHANGES_REFERENCES",
        "CHANGES_INPUTS",
        "NULL_ENVIRONMENT",
        "OWN_ENVIRONMENT",
        "FOREIGN_THREAD",
        "CONTROL_CHARACTERS",
        "MANY_MESSAGES",
    ];
    let of_standard =
        ["WELL", "STEP_ERROR", "DISCARD", "ABORT", "SEGFAULT", "FATAL", "PENDING", "OTHER_VERSION"];
    let hows =
        ["BY_EXIT", "BY_EXIT_AT_ONCE", "BY_CRASH", "BY_LOOP", "BY_BUSY_LOOP", "BY_DOUBLE_FREE"];
    let at =
        ["AT_LOAD", "AT_INSTANTIATE", "AT_INIT", "AT_STEP", "AT_TERMINATE", "AT_FREE", "AT_UNLOAD"];
    let ends = hows.iter().flat_map(|how| at.map(|place| format!("ENDS({how},{place})")));
    let words = in_seam.into_iter().chain(of_standard).map(str::to_owned).chain(ends);
    let limits = ["--start-limit", "0.2", "--step-limit", "0.2", "--end-limit", "0.2"];
    for word in words {
        let package = HostilePackage::new(&word);
        for further in [&[][..], &["--isolate", "all"]] {
            package.run(&[&limits[..], &["--overwrite"], further].concat());
            assert_eq!(package.left(), Vec::<PathBuf>::new(), "{word} {further:?}");
            let running = running_in(package.folder.path());
            assert_eq!(running, Vec::<u32>::new(), "{word} {further:?}");
        }
    }
}

/// The processes that work in a folder.
fn running_in(folder: &Path) -> Vec<u32> {
    let processes = fs::read_dir("/proc").unwrap().flatten();
    let numbers = processes.filter_map(|entry| entry.file_name().to_str()?.parse::<u32>().ok());
    let works_there = |number: &u32| {
        fs::read_link(format!("/proc/{number}/cwd")).is_ok_and(|works_in| works_in == folder)
    };
    numbers.filter(|number| works_there(number) && is_running(*number)).collect()
}
