//! The tutorials of the book: each command is run, and prints what the page shows.
//!
//! In a page `...` stands for lines and `[..]` for words that differ from run to run.

use std::path::PathBuf;
use std::process::Command;

use hotfoot_tests::{program, root};

#[test]
fn commands_of_the_tutorials_print_what_their_pages_show() {
    // The commands write into the folders that they begin in.
    let copy = tempfile::tempdir().unwrap();
    let copied = Command::new("cp")
        .args(["-r".into(), root().join("docs/tutorials"), copy.path().to_owned()])
        .status();
    assert!(copied.unwrap().success());
    let folder = copy.path().join("tutorials");
    // A tutorial that begins with no files works in a folder of its own, too.
    for page in std::fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path()) {
        if page.extension().is_some_and(|extension| extension == "md") {
            std::fs::create_dir_all(page.with_extension("in")).unwrap();
        }
    }
    let cases = trycmd::TestCases::new();
    cases.register_bin("hotfoot", program());
    for tool in ["cc", "mkdir", "mv", "python3"] {
        cases.register_bin(tool, on_the_path(tool));
    }
    cases.case(folder.join("*.md"));
    cases.run();
}

/// The path of a program that every machine with a compiler has.
fn on_the_path(program: &str) -> PathBuf {
    let folders = std::env::var_os("PATH").expect("there is a PATH");
    let mut files = std::env::split_paths(&folders).map(|folder| folder.join(program));
    files.find(|file| file.is_file()).unwrap_or_else(|| panic!("{program} is not on the PATH"))
}
