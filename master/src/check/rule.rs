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

/// What a rule has found: where in the text, and what stands there and what would be right.
#[derive(Default)]
pub(crate) struct Breaches(pub(super) Vec<(usize, String)>);

impl Breaches {
    /// A breach at an element.
    pub fn at(&mut self, element: Element<'_>, sentence: String) {
        self.0.push((element.range().start, sentence));
    }
}

/// Where the lines of a text begin. The parser would count them anew for each breach.
pub(crate) struct Lines(Vec<usize>);

impl Lines {
    /// The lines of a text.
    pub fn of(text: &str) -> Self {
        Self(text.match_indices('\n').map(|(at, _)| at).collect())
    }

    /// The number, from one, of the line in which a byte stands.
    pub fn number(&self, byte: usize) -> usize {
        1 + self.0.partition_point(|end| *end < byte)
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
