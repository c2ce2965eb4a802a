//! How fast a variable changes from one step to the next.

use std::fmt;

use super::signals::Signals;

/// A Real output that cannot change faster than so much a second.
pub struct Motion {
    /// Value reference.
    pub reference: u32,
    most_per_second: f64,
    /// Its index among the outputs, once it is known.
    index: Option<usize>,
    /// Time, s, and value at the last step.
    pub(super) last: Option<(f64, f64)>,
}

/// A change that was too fast.
pub struct Jump {
    /// The value behind it.
    pub value: f64,
    before: f64,
    duration: f64,
}

impl Motion {
    /// A Real that changes by so much a second at most.
    pub fn new(reference: u32, most_per_second: f64) -> Self {
        Self { reference, most_per_second, index: None, last: None }
    }

    /// Takes in the value at `time`, s; gives the change since the last one if that was too fast.
    pub fn jump(&mut self, outputs: &Signals, time: f64) -> Option<Jump> {
        if self.index.is_none() {
            self.index = outputs.reals.known(self.reference);
        }
        let value = outputs.reals.values[self.index?];
        let (last, before) = self.last.replace((time, value))?;
        let duration = time - last;
        let most = self.most_per_second * duration;
        // Values that are not finite are told by another check, and a step back in time by none.
        let too_fast = duration > 0.0 && (value - before).abs() > most;
        (too_fast && value.is_finite()).then_some(Jump { value, before, duration })
    }
}

impl fmt::Display for Jump {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { before, duration, .. } = self;
        write!(f, "was {before:?} only {duration:.6} s before, which is faster than it can change")
    }
}
