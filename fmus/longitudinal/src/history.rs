//! Changes of a command in the order of time, kept until they have arrived everywhere.

use serde::{Deserialize, Serialize};

/// Shortest time between two changes that are kept, s; a command that changes faster is sampled.
pub const SAMPLING: f64 = 0.1;

/// The last changes of a value, in memory that is taken at the start.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct History<T> {
    /// Times, s, and values; the change number `k` has the index `k` modulo their number.
    changes: Vec<(f64, T)>,
    /// Number of changes so far.
    count: u64,
}

impl<T: Copy + PartialEq> History<T> {
    /// A history that reaches `span`, s, back, of a value that has been `value` for ever.
    pub fn new(span: f64, value: T) -> Self {
        let length = (span / SAMPLING).ceil() as usize + 2;
        Self { changes: vec![(f64::NEG_INFINITY, value); length], count: 1 }
    }

    /// Number of changes so far.
    pub fn count(&self) -> u64 {
        self.count
    }

    /// Time and value of the change number `k`, which must not be too long ago.
    pub fn change(&self, k: u64) -> (f64, T) {
        self.changes[(k % self.changes.len() as u64) as usize]
    }

    /// Notes the value at a time, s; `at_once` even if the last change has just been.
    pub fn note(&mut self, time: f64, value: T, at_once: bool) {
        let (before, last) = self.change(self.count - 1);
        if value != last && (at_once || time >= before + SAMPLING) {
            let index = (self.count % self.changes.len() as u64) as usize;
            self.changes[index] = (time, value);
            self.count += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::History;

    #[test]
    fn a_history_keeps_its_span_of_sampled_changes() {
        let mut history = History::new(1.0, 0.0);
        for k in 0..1000 {
            let time = f64::from(k) * 0.01;
            history.note(time, time, false);
        }
        let last = history.count() - 1;
        assert!(history.change(last).0 >= 9.85);
        // The oldest change that a delay of 1 s can ask for.
        let oldest = (0..10).map(|k| history.change(last - k).0).fold(f64::INFINITY, f64::min);
        assert!(oldest <= history.change(last).0 - 0.9 + 1e-9);
    }
}
