//! Each rule finds what breaks it in a small repository made for the purpose.

use std::path::Path;

use architecture::{RULES, Workspace};

/// A repository of one package `crates/example` with these files in it, read.
fn workspace(files: &[(&str, &str)]) -> (tempfile::TempDir, Workspace) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let manifest = ("crates/example/Cargo.toml", "[package]\nname = \"example\"\n");
    for (path, text) in files.iter().chain([&manifest]) {
        let path = folder.path().join(path);
        std::fs::create_dir_all(path.parent().expect("a file has a folder")).expect("is made");
        std::fs::write(path, text).expect("is written");
    }
    let workspace = Workspace::read_at(folder.path());
    (folder, workspace)
}

/// What a rule says of a repository, one string for each breach.
fn said(rule: &str, files: &[(&str, &str)]) -> Vec<String> {
    let (_folder, workspace) = workspace(files);
    let rule = RULES.iter().find(|candidate| candidate.name == rule).expect("a rule of that name");
    (rule.breaches)(&workspace).iter().map(ToString::to_string).collect()
}

const LIB: &str = "crates/example/src/lib.rs";
const A: &str = "crates/example/src/a.rs";
const B: &str = "crates/example/src/b.rs";
const C: &str = "crates/example/src/c.rs";

#[test]
fn a_circle_of_three_files_is_told_with_its_names() {
    let said = said(
        "circles",
        &[
            (LIB, "mod a; mod b; mod c;"),
            (A, "use crate::b::B;\npub struct A(B);"),
            (B, "pub struct B;\nfn f() { super::c::c(); }"),
            (C, "pub fn c() { assert!(crate::a::A::is_well()); }"),
        ],
    );
    assert_eq!(
        said,
        ["crates/example/src/a.rs: 3 files use each other:\
            \n    crates/example/src/a.rs:1 → crates/example/src/b.rs: B\
            \n    crates/example/src/b.rs:2 → crates/example/src/c.rs: c\
            \n    crates/example/src/c.rs:1 → crates/example/src/a.rs: is_well"]
    );
}

#[test]
fn a_name_is_followed_to_the_file_that_defines_it() {
    // `lib.rs` only hands names on; a uses b through it, and b uses nothing.
    let handed_on = [
        (LIB, "mod a; mod b; pub use a::A; pub use b::*;"),
        (A, "use crate::B;\npub struct A(B);"),
        (B, "pub struct B;"),
    ];
    assert_eq!(said("circles", &handed_on), [""; 0]);
    let back = [handed_on[0], handed_on[1], (B, "pub struct B(Box<super::A>);")];
    assert_eq!(said("circles", &back).len(), 1);
}

#[test]
fn what_a_root_defines_itself_can_close_a_circle() {
    let files = [
        ("crates/example/src/lib.rs", "mod room;"),
        ("crates/example/src/room/mod.rs", "mod door;\npub struct Key;\nfn f() { door::open(); }"),
        ("crates/example/src/room/door.rs", "use super::Key;\npub fn open() { let _ = Key; }"),
    ];
    assert_eq!(said("circles", &files).len(), 1);
}

#[test]
fn neither_tests_nor_other_crates_close_a_circle() {
    let tests = "pub struct B;\n#[cfg(test)]\nmod tests { use crate::a::A; fn f(_: A) {} }";
    let files = [
        (LIB, "mod a; mod b;"),
        (A, "use crate::b::B;\nuse std::fmt;\npub struct A(B);"),
        (B, tests),
    ];
    assert_eq!(said("circles", &files), [""; 0]);
}

#[test]
fn what_a_macro_makes_stands_in_the_file_that_calls_it() {
    let files = [
        (LIB, "mod a; mod b;"),
        (A, "use crate::b::Made;\npub struct A(Made);"),
        (B, "make! { pub struct Made; }\nuse crate::a::A;"),
    ];
    assert_eq!(said("circles", &files).len(), 1);
}

#[test]
fn a_long_file_is_told_with_its_lines() {
    let text = "// a line\n".repeat(351);
    let said = said("length", &[(LIB, &text), (A, &text[10..])]);
    assert_eq!(said, ["crates/example/src/lib.rs: 351 lines"]);
}

#[test]
fn too_many_entries_at_a_root_are_told() {
    let names: Vec<String> = (0..13).map(|n| format!("crates/example/src/f{n}.rs")).collect();
    let mut files: Vec<(&str, &str)> = names.iter().map(|name| (name.as_str(), "")).collect();
    assert_eq!(said("entries", &files), ["crates/example/src: 13 entries"]);
    files.pop();
    assert_eq!(said("entries", &files), [""; 0]);
}

#[test]
fn tests_are_counted_in_their_files_and_at_the_end_of_others() {
    let code = "// code\n".repeat(70);
    let inline = format!("{code}#[cfg(test)]\nmod tests {{\n{}}}\n", "// test\n".repeat(17));
    let file = "// test\n".repeat(10);
    let enough = [(LIB, inline.as_str()), ("crates/example/tests/all.rs", &file)];
    assert_eq!(said("tests", &enough), [""; 0]);
    let said = said("tests", &enough[..1]);
    assert_eq!(said.len(), 1);
    assert!(said[0].contains("20 of 90 lines are tests, 22.2 %"), "{}", said[0]);
}

#[test]
fn a_test_that_is_never_run_is_told() {
    let manifest = "[package]\nname = \"example\"\n[lib]\ntest = false\ndoctest = false\n";
    let files = [
        ("other/Cargo.toml", manifest),
        ("other/src/lib.rs", "/// An example.\n/// ```\n/// ```\n#[test]\nfn f() {}"),
    ];
    let expected = [
        "other/src/lib.rs:4: this test is never run",
        "other/src/lib.rs:2: this example is never run",
    ];
    assert_eq!(said("untested", &files), expected);
}

#[test]
fn an_identifier_in_the_old_words_is_told() {
    let said = said("vocabulary", &[(LIB, "fn f() {}\nfn wheel_place() {}")]);
    assert_eq!(said.len(), 1);
    assert!(said[0].starts_with("crates/example/src/lib.rs:2: `wheel_place` says 'place'"));
}

#[test]
fn a_long_first_line_of_a_public_item_is_told() {
    let long = "word ".repeat(21);
    let text = format!("/// {long}\nfn own() {{}}\n/// {long}\npub fn of_all() {{}}\n");
    let expected = ["crates/example/src/lib.rs:3: 104 characters in the first line"];
    assert_eq!(said("first-lines", &[(LIB, &text)]), expected);
}

#[test]
fn a_forbidden_dependency_is_told_with_its_reason() {
    let manifest = "[package]\nname = \"hotfoot\"\n[dependencies]\nvehicle = {}\nserde = {}\n";
    let said = said("dependencies", &[("master/Cargo.toml", manifest)]);
    let expected = "master/Cargo.toml: depends on vehicle, but the master knows FMUs only by their \
                    interface";
    assert_eq!(said, [expected]);
}

#[test]
fn unsafe_code_is_allowed_at_the_boundary_only() {
    let allows = ["#![allow(unsafe", "_code)]"].concat();
    let fmi = [("master/Cargo.toml", "[package]\nname = \"hotfoot\"\n")];
    let files = [fmi[0], ("master/src/fmi/mod.rs", &allows), (LIB, &allows)];
    assert_eq!(said("unsafe", &files), ["crates/example/src/lib.rs:1: allows unsafe code"]);
}

#[test]
fn a_constant_of_nature_is_told_where_it_is_written_again() {
    let said = said("constants", &[(LIB, "fn weight(mass: f64) -> f64 {\n    9.81 * mass\n}")]);
    let expected = "crates/example/src/lib.rs:2: 9.81 is the acceleration of gravity: use \
                    `numerics::constants::STANDARD_GRAVITY`";
    assert_eq!(said, [expected]);
}

#[test]
fn an_elementary_function_of_the_system_is_told_in_the_models() {
    let text = "fn f(x: f64) -> f64 {\n    let exp = x;\n    libm::exp(exp)\n        + x.sin()\n}\n\
                const F: fn(f64) -> f64 = f64::ln;\n";
    let files = [
        ("fmus/longitudinal/Cargo.toml", "[package]\nname = \"longitudinal\"\n"),
        ("fmus/longitudinal/src/lib.rs", text),
        // No model.
        (LIB, text),
    ];
    let expected = [
        "fmus/longitudinal/src/lib.rs:4: `sin` hangs on the processor: use `libm::sin`",
        "fmus/longitudinal/src/lib.rs:6: `ln` hangs on the processor: use `libm::log`",
    ];
    assert_eq!(said("elementary", &files), expected);
}

#[test]
fn an_equation_is_complete_with_anchor_citation_and_validation() {
    let page = "docs/theory/longitudinal.md";
    let theory = "<a id=\"eq-1\"></a>\n```text\n(1)  a = b\n(12)  c = d\n```\n";
    let row = "| case | [1](../theory/longitudinal.md#eq-1) |\n";
    let files = [
        (page, theory),
        ("docs/validation/longitudinal.md", row),
        ("fmus/longitudinal/Cargo.toml", "[package]\nname = \"longitudinal\"\n"),
        ("fmus/longitudinal/src/lib.rs", "//! Motion (theory, eq. 1).\n"),
        ("fmus/longitudinal/src/line.rs", "//! `docs/theory/longitudinal.md#eq-7`\n"),
        // What another package cites is not meant.
        (LIB, "//! Motion (theory, eq. 12).\n"),
    ];
    let expected = [
        "fmus/longitudinal/src/line.rs:1: docs/theory/longitudinal.md has no anchor eq-7",
        "docs/theory/longitudinal.md:4: equation (12) is without an anchor, a citation in code, \
         validation",
    ];
    assert_eq!(said("equations", &files), expected);
}

#[test]
fn the_map_is_told_what_it_leaves_out_and_what_does_not_exist() {
    let map = "The package\n`crates/other/src/lib.rs`.\n";
    let expected = [
        "docs/architecture.md: does not name `crates/example`",
        "docs/architecture.md:2: `crates/other/src/lib.rs` does not exist",
    ];
    assert_eq!(said("map", &[("docs/architecture.md", map)]), expected);
}

#[test]
fn every_rule_has_a_name_of_its_own() {
    let mut names: Vec<_> = RULES.iter().map(|rule| rule.name).collect();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), RULES.len());
    assert!(Path::new(env!("CARGO_MANIFEST_DIR")).ends_with("tests/architecture"));
}
