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
fn a_target_without_test_runs_has_no_tests() {
    holds("untested");
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
fn each_equation_has_anchor_citation_and_validation() {
    holds("equations");
}
