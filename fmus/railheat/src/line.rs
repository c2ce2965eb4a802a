//! The modelled length of rail: how it is cut along the track, and what is found along it.

use std::ops::RangeInclusive;

use serde::{Deserialize, Serialize};

use crate::contact::Wheel;

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

    /// A chainage counted in elements from the beginning of the line.
    fn in_elements(&self, chainage: f64) -> f64 {
        (chainage - self.begin) / self.element_length
    }

    /// The element at a chainage, if it is modelled.
    pub fn element(&self, chainage: f64) -> Option<usize> {
        let index = self.in_elements(chainage);
        (index >= 0.0 && index < self.elements as f64).then_some(index as usize)
    }

    /// The element at a chainage, or the one that is nearest to it.
    pub fn nearest(&self, chainage: f64) -> usize {
        (self.in_elements(chainage).max(0.0) as usize).min(self.elements - 1)
    }

    /// The elements that a wheel touches between two chainages, in whichever order it goes.
    ///
    /// They reach from the one on which it stands at first to the one on which it stands at last,
    /// so that none is missed, however fast the wheel and however long the step. `None` when all of
    /// it lies outside.
    pub fn passed(&self, from: f64, to: f64) -> Option<RangeInclusive<usize>> {
        let (low, high) = if from <= to { (from, to) } else { (to, from) };
        if high < self.begin || low >= self.end() {
            return None;
        }
        Some(self.nearest(low)..=self.nearest(high))
    }

    /// The elements between two chainages, with the share of the distance that lies in each.
    ///
    /// Two equal chainages lie in one element.
    pub fn shares(&self, from: f64, to: f64) -> impl Iterator<Item = (usize, f64)> {
        let (low, high) = if from <= to { (from, to) } else { (to, from) };
        let (low, high) = (self.in_elements(low), self.in_elements(high));
        let distance = high - low;
        let first = low.max(0.0) as usize;
        let last = (high.max(-1.0) + 1.0).min(self.elements as f64) as usize;
        (first..last).filter_map(move |element| {
            let (start, end) = (element as f64, element as f64 + 1.0);
            if distance > 0.0 {
                let part = high.min(end) - low.max(start);
                return (part > 0.0).then_some((element, part / distance));
            }
            (low >= start && low < end).then_some((element, 1.0))
        })
    }

    /// The first loaded wheel that stands outside the line, if none was `found` before.
    pub fn first_stray(&self, wheels: &[Wheel], found: &mut bool) -> Option<Stray> {
        if *found {
            return None;
        }
        let is_stray = |wheel: &Wheel| {
            wheel.contact.normal_force > 0.0 && self.element(wheel.position).is_none()
        };
        let wheel = wheels.iter().position(is_stray)?;
        *found = true;
        Some(Stray { wheel, position: wheels[wheel].position })
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
    /// Index of the wheel in the order given.
    pub wheel: usize,
    /// Its chainage, m.
    pub position: f64,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::Contact;

    /// 100 m from chainage 50 m on.
    const LINE: Line = Line { begin: 50.0, element_length: 0.1, elements: 1000 };

    #[test]
    fn analytic_elements_are_found_by_their_chainage() {
        assert_eq!(LINE.end(), 150.0);
        assert_eq!(LINE.chainage(0), 50.05);
        assert_eq!(
            (LINE.element(50.25), LINE.element(49.9), LINE.element(150.0)),
            (Some(2), None, None)
        );
        assert_eq!((LINE.nearest(-5.0), LINE.nearest(50.25), LINE.nearest(200.0)), (0, 2, 999));
    }

    #[test]
    fn analytic_the_elements_passed_reach_from_the_first_to_the_last() {
        assert_eq!(LINE.passed(50.25, 50.449), Some(2..=4));
        assert_eq!(LINE.passed(50.449, 50.25), Some(2..=4), "backwards");
        assert_eq!(LINE.passed(45.0, 50.05), Some(0..=0));
        assert_eq!(LINE.passed(149.95, 250.0), Some(999..=999));
        assert_eq!(LINE.passed(45.0, 49.0), None);
        assert_eq!(LINE.passed(150.0, 151.0), None);
    }

    #[test]
    fn analytic_shares_are_those_of_the_distance_in_each_element() {
        let line = Line { begin: 0.0, element_length: 2.0, elements: 3 };
        let shares = |from, to| line.shares(from, to).collect::<Vec<_>>();
        assert_eq!(shares(1.0, 5.0), [(0, 0.25), (1, 0.5), (2, 0.25)]);
        assert_eq!(shares(5.0, 1.0), shares(1.0, 5.0), "backwards");
        assert_eq!(shares(3.0, 3.0), [(1, 1.0)], "a point");
        assert_eq!(shares(5.0, 9.0), [(2, 0.25)], "the rest lies beyond the end");
        assert_eq!(shares(-4.0, -1.0), []);
    }

    #[test]
    fn the_first_loaded_wheel_outside_is_a_stray() {
        let at = |position, normal_force| Wheel {
            position,
            contact: Contact { normal_force, a: 0.006, b: 0.006 },
            ..Wheel::default()
        };
        let wheels = [at(100.0, 1e5), at(200.0, 0.0), at(40.0, 1e5)];
        let mut found = false;
        assert_eq!(LINE.first_stray(&wheels[..2], &mut found), None);
        let stray = Stray { wheel: 2, position: 40.0 };
        assert_eq!(LINE.first_stray(&wheels, &mut found), Some(stray));
        assert_eq!(LINE.first_stray(&wheels, &mut found), None, "once");
    }
}
