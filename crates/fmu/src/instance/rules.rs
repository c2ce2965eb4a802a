//! What the functions that set values admit: when, and which values.

use crate::calls::{Phases, settable};
use crate::variables::{Kind, Values, Variable};

/// When variables may be set and to what, by type and value reference.
#[derive(Default)]
pub(crate) struct Rules {
    pub(crate) reals: Vec<Rule<f64>>,
    pub(crate) integers: Vec<Rule<i32>>,
    pub(crate) booleans: Vec<Rule<bool>>,
    pub(crate) texts: Vec<TextRule>,
}

/// When a variable may be set, and the smallest and largest value.
#[derive(Clone, Copy)]
pub(crate) struct Rule<T> {
    pub(crate) settable: Phases,
    min: T,
    max: T,
}

impl<T: PartialOrd> Rule<T> {
    fn new(settable: Phases, (min, max): (T, T)) -> Self {
        Self { settable, min, max }
    }

    /// Whether the value is within the bounds.
    ///
    /// NaN never is, nor is an infinite number, as the bounds are finite.
    pub(crate) fn admits(&self, value: &T) -> bool {
        *value >= self.min && *value <= self.max
    }
}

/// When a text may be set, and to which texts.
#[derive(Clone, Copy)]
pub(crate) struct TextRule {
    pub(crate) settable: Phases,
    choices: &'static [&'static str],
}

impl TextRule {
    /// Whether the text is one of the choices, if there are any.
    pub(crate) fn admits(&self, text: &str) -> bool {
        self.choices.is_empty() || self.choices.contains(&text)
    }
}

impl Rules {
    pub(crate) fn of(variables: &[Variable]) -> Self {
        let mut rules = Self::default();
        for variable in variables {
            let settable = settable(variable);
            match variable.kind {
                Kind::Real { bounds, .. } => {
                    rules.reals.push(Rule::new(settable, bounds.limits()));
                }
                Kind::Integer { bounds, .. } => {
                    rules.integers.push(Rule::new(settable, bounds.limits()));
                }
                Kind::Boolean { .. } => rules.booleans.push(Rule::new(settable, (false, true))),
                Kind::Text { choices, .. } => rules.texts.push(TextRule { settable, choices }),
            }
        }
        rules
    }
}

impl Rules {
    /// Whether every value that can be set is one that a setter admits.
    pub(crate) fn admit(&self, values: &Values) -> bool {
        fn all<T: PartialOrd>(rules: &[Rule<T>], values: &[T]) -> bool {
            let mut pairs = rules.iter().zip(values);
            pairs.all(|(rule, value)| rule.settable == Phases::NONE || rule.admits(value))
        }
        let mut texts = self.texts.iter().zip(&values.texts);
        all(&self.reals, &values.reals)
            && all(&self.integers, &values.integers)
            && texts.all(|(rule, text)| rule.settable == Phases::NONE || rule.admits(text))
    }
}

impl Kind {
    /// Whether the start value is one that may be set, as it must be (§2.2.7).
    pub(crate) fn admits_start(&self) -> bool {
        match self {
            Self::Real { start, bounds, .. } => {
                Rule::new(Phases::NONE, bounds.limits()).admits(start)
            }
            Self::Integer { start, bounds } => {
                Rule::new(Phases::NONE, bounds.limits()).admits(start)
            }
            Self::Boolean { .. } => true,
            Self::Text { start, choices } => {
                TextRule { settable: Phases::NONE, choices }.admits(start)
            }
        }
    }
}
