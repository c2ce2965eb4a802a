//! The rules, held against this repository. A test prints every breach of its rule at once.

use architecture::{RULES, Workspace};

/// # Panics
/// When the rule is broken, with every breach.
#[track_caller]
fn holds(name: &str) {
    let rule = RULES.iter().find(|rule| rule.name == name).expect("a rule of that name");
    let breaches = (rule.breaches)(&Workspace::read());
    let lines: String = breaches.iter().map(|breach| format!("\n{breach}")).collect();
    assert!(breaches.is_empty(), "{} It is broken {} times:{lines}", rule.sentence, breaches.len());
}

#[test]
fn no_files_use_each_other_in_a_loop() {
    holds("circles");
}

#[test]
fn a_file_has_at_most_350_lines() {
    holds("length");
}

#[test]
fn the_root_of_a_source_folder_has_at_most_12_entries() {
    holds("entries");
}

#[test]
fn at_least_30_percent_of_the_lines_are_tests() {
    holds("tests");
}

#[test]
fn a_target_without_test_runs_has_no_tests() {
    holds("untested");
}

#[test]
fn identifiers_are_in_the_words_of_the_field() {
    holds("vocabulary");
}

#[test]
fn doc_comments_begin_with_a_short_line() {
    holds("first-lines");
}

#[test]
fn packages_depend_only_on_what_their_part_allows() {
    holds("dependencies");
}

#[test]
fn only_the_fmi_boundary_allows_unsafe_code() {
    holds("unsafe");
}

#[test]
fn equations_have_anchors_citations_and_validation() {
    holds("equations");
}
