//! Instructions of a vehicle's step, counted by valgrind: they do not depend on what else the machine
//! does.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;
use std::process::Command;

use anyhow::{Context, Result, bail};

use crate::shell::{cargo, output, run, target};

/// Steps whose cost is counted, after as many that are not.
const STEPS: u64 = 2000;

/// Parts of a step, and what the path of their source files, or of functions into which the standard
/// library is inlined, contains; the first that fits counts.
const PARTS: [(&str, &[&str]); 7] = [
    ("creep law", &["crates/contact/src/creep/"]),
    (
        "contact search and Hertz",
        &["crates/contact/", "vehicle/src/contact/wheel.rs", "geometry::table"],
    ),
    (
        "wheelsets: their six equations and outputs",
        &[
            "vehicle/src/contact/",
            "vehicle/src/dynamics/wheelset.rs",
            "vehicle/src/dynamics/drive.rs",
            "vehicle/src/track/rail.rs",
            "::wheel",
            "::six",
        ],
    ),
    ("suspension", &["vehicle/src/suspension/", "::suspension::"]),
    ("track", &["crates/track/", "track::"]),
    ("bodies", &["vehicle/src/dynamics/", "vehicle/src/body/", "::dynamics::"]),
    (
        "outputs and calls of the FMU",
        &["crates/fmu/", "vehicle/src/interface/", "fmu::", "interface::"],
    ),
];

/// The rest: mathematics of the C library, copies.
const REST: &str = "C library and others";

/// A table of the instructions of one step by parts, as Markdown.
pub fn table() -> Result<String> {
    let folder = target().join("instructions");
    run(cargo()
        .args(["build", "--release", "-p", "vehicle", "--example", "steps"])
        .env("CARGO_TARGET_DIR", &folder)
        .env("CARGO_PROFILE_RELEASE_DEBUG", "line-tables-only"))?;
    let program = folder.join("release/examples/steps");
    let [before, after] = [STEPS, 2 * STEPS].map(|steps| count(&program, &folder, steps));
    let (before, after) = (before?, after?);
    let per_step = |part: &str| {
        let of = |counts: &BTreeMap<&str, u64>| counts.get(part).copied().unwrap_or(0);
        (of(&after) - of(&before)) / STEPS
    };
    let parts = PARTS.iter().map(|(part, _)| *part).chain([REST]);
    let rows: Vec<_> = parts.map(|part| (part, per_step(part))).collect();
    let sum: u64 = rows.iter().map(|(_, count)| count).sum();
    let mut text = String::from("| part | instructions a step | share |\n|---|---|---|\n");
    for (part, count) in rows.iter().chain(&[("sum", sum)]) {
        writeln!(text, "| {part} | {count} | {} % |", (100 * count + sum / 2) / sum)?;
    }
    Ok(text)
}

/// Instructions by part of a run of so many steps.
fn count(program: &Path, folder: &Path, steps: u64) -> Result<BTreeMap<&'static str, u64>> {
    let profile = folder.join(format!("callgrind.{steps}"));
    run(Command::new("valgrind")
        .args(["--tool=callgrind", "--quiet", "--dump-line=yes"])
        .arg(format!("--callgrind-out-file={}", profile.display()))
        .arg(program)
        .arg(steps.to_string()))
    .context("counting instructions needs valgrind (Debian: apt-get install valgrind)")?;
    let text = output(
        Command::new("callgrind_annotate")
            .args(["--threshold=100", "--auto=no", "--show-percs=no"])
            .arg(profile),
    )?;
    let mut counts = BTreeMap::new();
    for (count, source) in text.lines().filter_map(line) {
        *counts.entry(part(source)).or_default() += count;
    }
    if counts.is_empty() {
        bail!("callgrind_annotate printed no counts");
    }
    Ok(counts)
}

/// Count and source of a line like `1,234  file:function [object]`.
fn line(line: &str) -> Option<(u64, &str)> {
    let (count, source) = line.trim_start().split_once(' ')?;
    let count = count.replace(',', "").parse().ok()?;
    let source = source.trim_start();
    source.contains(':').then_some((count, source))
}

/// The part to which a source belongs: by its file, or else by its function.
fn part(source: &str) -> &'static str {
    let (file, function) = source.split_once(':').unwrap_or((source, ""));
    let found = |text: &str| PARTS.iter().find(|(_, marks)| marks.iter().any(|m| text.contains(m)));
    found(file).or_else(|| found(function)).map_or(REST, |(part, _)| part)
}
