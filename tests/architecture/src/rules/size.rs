//! Short files, few entries at the root of a source folder, enough tests.

use std::path::Path;

use crate::breach::Breach;
use crate::workspace::{Package, Source, Workspace};

/// Lines that a file has at most, with its tests.
const LINES: usize = 350;

/// Entries that the root of a source folder has at most.
const ENTRIES: usize = 12;

/// Share of all lines that tests are at least.
const SHARE_OF_TESTS: f64 = 0.30;

/// Files with too many lines.
pub fn long_files(workspace: &Workspace) -> Vec<Breach> {
    let files = workspace.sources().map(|source| (source, source.text.lines().count()));
    files
        .filter(|(_, lines)| *lines > LINES)
        .map(|(source, lines)| Breach::new(&source.path, 0, format!("{lines} lines")))
        .collect()
}

/// Source folders with too many entries at their root.
pub fn crowded_roots(workspace: &Workspace) -> Vec<Breach> {
    let folders = workspace.packages.iter().map(|package| package.folder.join("src"));
    folders
        .filter_map(|folder| {
            let entries = std::fs::read_dir(workspace.root.join(&folder)).ok()?.count();
            (entries > ENTRIES).then(|| Breach::new(&folder, 0, format!("{entries} entries")))
        })
        .collect()
}

/// One breach when there are too few lines of tests, which lists the share of each package.
pub fn few_tests(workspace: &Workspace) -> Vec<Breach> {
    let share = |sources: &mut dyn Iterator<Item = &Source>| {
        let (mut tests, mut lines) = (0, 0);
        for source in sources {
            tests += source.lines_of_tests();
            lines += source.text.lines().count();
        }
        (tests, lines, tests as f64 / lines.max(1) as f64)
    };
    let (tests, lines, all) = share(&mut workspace.sources());
    if all >= SHARE_OF_TESTS {
        return vec![];
    }
    let mut message = format!("{tests} of {lines} lines are tests, {:.1} %:", 100.0 * all);
    for package in &workspace.packages {
        let (tests, lines, share) = share(&mut package.sources.iter());
        let folder = package.folder.display();
        message += &format!("\n    {folder}: {tests} of {lines}, {:.0} %", 100.0 * share);
    }
    vec![Breach::new(Path::new("."), 0, message)]
}

/// Tests and examples in targets for which Cargo is told to run none, which saves time where there are none.
pub fn tests_not_run(workspace: &Workspace) -> Vec<Breach> {
    workspace.packages.iter().flat_map(switched_off).collect()
}

fn switched_off(package: &Package) -> Vec<Breach> {
    let off = |target: &toml::Value, what| target.get(what) == Some(&toml::Value::Boolean(false));
    let path = |target: &toml::Value, usual: &str| {
        let path = target.get("path").and_then(|path| path.as_str());
        package.folder.join(path.unwrap_or(usual))
    };
    let mut found = vec![];
    let programs = package.manifest.get("bin").and_then(|programs| programs.as_array());
    for program in programs.into_iter().flatten().filter(|program| off(program, "test")) {
        let path = path(program, "src/main.rs");
        let source = package.sources.iter().find(|source| source.path == path);
        found.extend(source.and_then(|source| breach_at(source, first_test(source)?, "test")));
    }
    if let Some(library) = package.manifest.get("lib") {
        let path = path(library, "src/lib.rs");
        let folder = path.parent().expect("a file has a folder");
        for source in package.sources.iter().filter(|source| source.path.starts_with(folder)) {
            if off(library, "test") {
                found.extend(first_test(source).and_then(|line| breach_at(source, line, "test")));
            }
            if off(library, "doctest") {
                let line = first_example(source);
                found.extend(line.and_then(|line| breach_at(source, line, "example")));
            }
        }
    }
    found
}

fn breach_at(source: &Source, line: usize, what: &str) -> Option<Breach> {
    Some(Breach::new(&source.path, line, format!("this {what} is never run")))
}

fn first_test(source: &Source) -> Option<usize> {
    source.text.lines().position(|line| line.trim() == "#[test]").map(|line| line + 1)
}

/// Line of the first code block without a language in a doc comment, which is Rust.
fn first_example(source: &Source) -> Option<usize> {
    let comments = source.text.lines().enumerate().filter_map(|(index, line)| {
        let line = line.trim();
        let comment = line.strip_prefix("//!").or(line.strip_prefix("///"))?.trim();
        comment.starts_with("```").then_some((index + 1, comment))
    });
    // Every other fence closes a block.
    comments.step_by(2).find(|(_, fence)| *fence == "```").map(|(line, _)| line)
}
