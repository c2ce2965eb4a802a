//! The modelled length of rail: how it is cut along the track, and what is found along it.

use serde::{Deserialize, Serialize};

/// How the rail is cut along the track.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// Chainage at which the first element begins, m.
    pub begin: f64,
    /// Length of an element, m.
    pub element_length: f64,
    /// Number of elements.
    pub elements: usize,
}

impl Line {
    /// Chainage at which the last element ends, m.
    pub fn end(&self) -> f64 {
        self.begin + self.elements as f64 * self.element_length
    }

    /// Chainage of the middle of an element, m.
    pub fn chainage(&self, element: usize) -> f64 {
        self.begin + (element as f64 + 0.5) * self.element_length
    }

    /// The element at a chainage, if it is modelled.
    pub fn element(&self, chainage: f64) -> Option<usize> {
        let place = (chainage - self.begin) / self.element_length;
        (place >= 0.0 && place < self.elements as f64).then_some(place as usize)
    }

    /// The element at a chainage, or the one that is nearest to it.
    pub fn nearest(&self, chainage: f64) -> usize {
        let place = (chainage - self.begin) / self.element_length;
        (place.max(0.0) as usize).min(self.elements - 1)
    }

    /// The elements that a way covers, with the share of it in each. A point is a way too.
    pub fn shares(&self, from: f64, to: f64) -> impl Iterator<Item = (usize, f64)> {
        let Self { begin, element_length, elements } = *self;
        let (low, high) = if from <= to { (from, to) } else { (to, from) };
        let place = |chainage: f64| (chainage - begin) / element_length;
        let (low, high) = (place(low), place(high));
        let way = high - low;
        let first = low.max(0.0) as usize;
        let last = (high.max(-1.0) + 1.0).min(elements as f64) as usize;
        (first..last).filter_map(move |element| {
            let (start, end) = (element as f64, element as f64 + 1.0);
            if way > 0.0 {
                let part = high.min(end) - low.max(start);
                return (part > 0.0).then_some((element, part / way));
            }
            (low >= start && low < end).then_some((element, 1.0))
        })
    }
}

/// The highest rise at a depth, and where.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Highest {
    /// Rise, K.
    pub rise: f64,
    /// Chainage, m.
    pub chainage: f64,
}

/// A wheel that stands outside the modelled track.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stray {
    /// Place of the wheel in the order given.
    pub wheel: usize,
    /// Its chainage, m.
    pub position: f64,
}
