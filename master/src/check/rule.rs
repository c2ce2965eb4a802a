//! What a rule is, and what it finds.

use std::fmt;

use super::description::{Description, Element};

/// How much a breach matters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Severity {
    /// The standard is broken: some tool refuses the FMU or misreads it.
    Error,
    /// Legal, but some tool complains or works less well.
    Advice,
}

/// A rule that a model description can break.
pub struct Rule {
    /// Lasting name.
    pub name: &'static str,
    /// How much a breach matters.
    pub severity: Severity,
    /// What the rule wants, in a sentence.
    pub wants: &'static str,
    /// Finds the breaches.
    pub(super) check: fn(&Description<'_>, &mut Breaches),
}

/// What a rule has found: the line, and a sentence that says what stands there and what would be
/// right.
#[derive(Default)]
pub(crate) struct Breaches(pub(super) Vec<(u32, String)>);

impl Breaches {
    /// A breach at an element.
    pub fn at(&mut self, element: Element<'_>, sentence: String) {
        let line = element.document().text_pos_at(element.range().start).row;
        self.0.push((line, sentence));
    }
}

/// A breach of a rule.
#[derive(Debug, Clone, PartialEq)]
pub struct Finding {
    /// Name of the rule.
    pub rule: &'static str,
    /// How much it matters.
    pub severity: Severity,
    /// File inside of the FMU, with the line where there is one.
    pub location: String,
    /// What is wrong, and what would be right.
    pub sentence: String,
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { rule, severity, location, sentence } = self;
        let severity = match severity {
            Severity::Error => "error",
            Severity::Advice => "advice",
        };
        write!(f, "{location}: {severity}: {sentence} [{rule}]")
    }
}
