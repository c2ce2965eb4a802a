//! Connections as they run: what a part takes from another, as pairs of indices.

use std::mem;

use super::part::Part;
use super::structure::Sampling;
use crate::interface::VariableType;
use crate::interface::si::Linear;

/// A pair of an output of the giver and an input of the receiver, by their indices.
type Pair = (u32, u32);

/// All that one part takes from another.
#[derive(Debug, Default)]
pub struct Gather {
    /// Number of the part that gives.
    pub giver: usize,
    /// Number of the part that takes.
    pub receiver: usize,
    /// Reals that are taken as they are.
    copied: Vec<Pair>,
    /// Reals that are converted: of units, and by a transformation.
    converted: Vec<(Pair, Linear)>,
    /// Reals that are summed up until the receiver steps.
    summed: Vec<(Pair, Linear)>,
    integers: Vec<Pair>,
    booleans: Vec<Pair>,
}

impl Gather {
    /// Nothing yet from one part to another.
    pub fn new(giver: usize, receiver: usize) -> Self {
        Self { giver, receiver, ..Self::default() }
    }

    /// Adds a link from an output to an input of the same type.
    pub fn add(
        &mut self,
        kind: VariableType,
        (output, input): (usize, usize),
        conversion: Linear,
        sampling: Sampling,
    ) {
        let pair = (index(output), index(input));
        match kind {
            VariableType::Real if sampling != Sampling::Last => {
                self.summed.push((pair, conversion));
            }
            VariableType::Real if conversion.is_identity() => self.copied.push(pair),
            VariableType::Real => self.converted.push((pair, conversion)),
            VariableType::Integer => self.integers.push(pair),
            VariableType::Boolean => self.booleans.push(pair),
            VariableType::Text => {}
        }
    }

    /// Takes over what the giver has, for the receiver's next step.
    pub fn pull(&self, parts: &mut [Part]) {
        self.with(parts, |gather, outputs, receiver| {
            for &((output, input), conversion) in &gather.summed {
                let value = conversion.apply(outputs.reals.values[output as usize]);
                receiver.sums[input as usize] += value;
            }
        });
    }

    /// Takes over what the giver has at one instant, with nothing summed up.
    pub fn pull_at_start(&self, parts: &mut [Part]) {
        self.with(parts, |gather, outputs, receiver| {
            for &((output, input), conversion) in &gather.summed {
                let value = conversion.apply(outputs.reals.values[output as usize]);
                receiver.inputs.reals.values[input as usize] = value;
            }
        });
    }

    /// Takes over the last values, and what is summed up as `sum` says.
    fn with(&self, parts: &mut [Part], sum: impl Fn(&Self, &super::signals::Signals, &mut Part)) {
        // A part may take from itself.
        let outputs = mem::take(&mut parts[self.giver].outputs);
        let receiver = &mut parts[self.receiver];
        let inputs = &mut receiver.inputs;
        for &(output, input) in &self.copied {
            inputs.reals.values[input as usize] = outputs.reals.values[output as usize];
        }
        for &((output, input), conversion) in &self.converted {
            let value = conversion.apply(outputs.reals.values[output as usize]);
            inputs.reals.values[input as usize] = value;
        }
        for &(output, input) in &self.integers {
            inputs.integers.values[input as usize] = outputs.integers.values[output as usize];
        }
        for &(output, input) in &self.booleans {
            inputs.booleans.values[input as usize] = outputs.booleans.values[output as usize];
        }
        sum(self, &outputs, receiver);
        parts[self.giver].outputs = outputs;
    }
}

/// An index of 32 bits: half the memory of the links, which every step reads.
fn index(index: usize) -> u32 {
    u32::try_from(index).expect("fewer than 2^32 variables")
}
