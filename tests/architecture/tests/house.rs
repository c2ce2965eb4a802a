//! The rules, held against this repository.

use std::fmt::Write;

use architecture::{RULES, Workspace};

/// The sources are read once; every breach of every rule is printed.
#[test]
fn the_house_keeps_its_rules() {
    let workspace = Workspace::read();
    let mut broken = String::new();
    for rule in RULES {
        for breach in (rule.breaches)(&workspace) {
            let _ = write!(broken, "\n{} {breach}", rule.sentence);
        }
    }
    assert!(broken.is_empty(), "{broken}");
}
