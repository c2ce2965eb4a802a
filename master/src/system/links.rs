//! Connections as they run: what the parts of a stage take from others, as indices.

use super::part::Part;
use super::structure::Sampling;
use crate::interface::VariableType;
use crate::interface::si::Linear;

/// An output of a part that becomes an input of another, or of the same. Numbers of 32 bits halve the
/// memory of the links, which every step reads.
#[derive(Debug, Clone, Copy)]
pub struct Link {
    /// Number of the part that gives.
    pub giver: u32,
    /// Index of the output in the bank of its type.
    pub output: u32,
    /// Number of the part that takes.
    pub receiver: u32,
    /// Index of the input in the bank of its type.
    pub input: u32,
}

/// All that the parts of a stage take.
#[derive(Debug, Default)]
pub struct Links {
    /// Reals that are taken as they are.
    copied: Vec<Link>,
    /// Reals that are converted: of units, and by a transformation.
    converted: Vec<(Link, Linear)>,
    /// Reals that are summed up until the receiver steps.
    summed: Vec<(Link, Linear)>,
    integers: Vec<Link>,
    booleans: Vec<Link>,
}

impl Link {
    /// From an output of the giver to an input of the receiver, each given by number of its part and
    /// index.
    ///
    /// # Panics
    /// When there are 2³² parts or variables.
    pub fn new((giver, output): (usize, usize), (receiver, input): (usize, usize)) -> Self {
        let [giver, output, receiver, input] = [giver, output, receiver, input]
            .map(|number| u32::try_from(number).expect("fewer than 2^32 parts and variables"));
        Self { giver, output, receiver, input }
    }

    /// The output's part.
    fn from<'p>(&self, parts: &'p [Part]) -> &'p Part {
        &parts[self.giver as usize]
    }

    /// The input's part.
    fn to<'p>(&self, parts: &'p mut [Part]) -> &'p mut Part {
        &mut parts[self.receiver as usize]
    }

    /// The value of a Real output.
    fn real(&self, parts: &[Part]) -> f64 {
        self.from(parts).outputs.reals.values[self.output as usize]
    }

    /// Where a Real input stands.
    fn real_input<'p>(&self, parts: &'p mut [Part]) -> &'p mut f64 {
        &mut self.to(parts).inputs.reals.values[self.input as usize]
    }
}

impl Links {
    /// Adds a link of variables of the same type.
    pub fn add(&mut self, kind: VariableType, link: Link, conversion: Linear, sampling: Sampling) {
        match kind {
            VariableType::Real if sampling != Sampling::Last => {
                self.summed.push((link, conversion));
            }
            VariableType::Real if conversion.is_identity() => self.copied.push(link),
            VariableType::Real => self.converted.push((link, conversion)),
            VariableType::Integer => self.integers.push(link),
            VariableType::Boolean => self.booleans.push(link),
            VariableType::Text => {}
        }
    }

    /// Takes over what the givers have, for the receivers' next step.
    pub fn pull(&self, parts: &mut [Part]) {
        self.copy(parts, |_| true);
        for (link, conversion) in &self.summed {
            let value = conversion.apply(link.real(parts));
            link.to(parts).sums[link.input as usize] += value;
        }
    }

    /// Takes over what the givers have at one instant, with nothing summed up, for the receivers that
    /// are `ready`, by their numbers.
    pub fn pull_at_start(&self, parts: &mut [Part], ready: impl Fn(usize) -> bool) {
        let is_ready = |link: &Link| ready(link.receiver as usize);
        self.copy(parts, is_ready);
        for (link, conversion) in self.summed.iter().filter(|(link, _)| is_ready(link)) {
            *link.real_input(parts) = conversion.apply(link.real(parts));
        }
    }

    /// Takes over the last values of what is not summed up, by the links that are wanted.
    fn copy(&self, parts: &mut [Part], wanted: impl Fn(&Link) -> bool) {
        for link in self.copied.iter().filter(|link| wanted(link)) {
            *link.real_input(parts) = link.real(parts);
        }
        for (link, conversion) in self.converted.iter().filter(|(link, _)| wanted(link)) {
            *link.real_input(parts) = conversion.apply(link.real(parts));
        }
        for link in self.integers.iter().filter(|link| wanted(link)) {
            let value = link.from(parts).outputs.integers.values[link.output as usize];
            link.to(parts).inputs.integers.values[link.input as usize] = value;
        }
        for link in self.booleans.iter().filter(|link| wanted(link)) {
            let value = link.from(parts).outputs.booleans.values[link.output as usize];
            link.to(parts).inputs.booleans.values[link.input as usize] = value;
        }
    }

    /// All links.
    pub fn iter(&self) -> impl Iterator<Item = &Link> {
        let converted = self.converted.iter().chain(&self.summed).map(|(link, _)| link);
        self.copied.iter().chain(converted).chain(&self.integers).chain(&self.booleans)
    }
}
