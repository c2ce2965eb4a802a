//! The step of an instance, and what is checked before and after it (§4.2.2).

use crate::calls::{Call, Phase};
use crate::error::Error;
use crate::instance::state::TIME_TOLERANCE;
use crate::instance::{Built, Instance};
use crate::model::{Interval, Model};
use crate::variables::Kind;

impl<M: Model> Instance<M> {
    /// Takes the model from `start` over `length`, s, with the inputs constant.
    ///
    /// # Errors
    /// When the interval does not follow on the last, or the model fails.
    pub fn do_step(&mut self, start: f64, length: f64) -> Result<(), Error> {
        let interval = Interval { start, length };
        self.call(Call::DoStep, |instance| instance.step(interval))
    }

    fn step(&mut self, interval: Interval) -> Result<(), Error> {
        self.check_interval(interval)?;
        let Interval { start, length } = interval;
        let (call, phase) = (Call::DoStep, self.phase);
        let built = self.built.as_mut();
        let Built { model, .. } = built.ok_or(Error::Forbidden { call, phase })?;

        let signals = &self.interface.signals;
        let result = model.step(signals, &mut self.values, interval, &mut self.log);
        self.logger.drain(&mut self.log);
        if let Err(source) = result {
            // An error that ends the simulation is told apart from a discarded step in `call`.
            self.phase = Phase::StepFailed;
            return Err(Error::Step { start, length, source });
        }
        self.check_finite(start + length)?;
        self.time = start + length;
        Ok(())
    }

    /// A step must have a length, follow on the last one, and end before the stop time.
    fn check_interval(&self, Interval { start, length }: Interval) -> Result<(), Error> {
        if !(length > 0.0 && length.is_finite()) {
            return Err(Error::StepSize(length));
        }
        let tolerance = TIME_TOLERANCE * self.time.abs().max(length);
        let gap = (start - self.time).abs();
        if gap.is_nan() || gap > tolerance {
            return Err(Error::CommunicationPoint { given: start, own: self.time });
        }
        let end = start + length;
        match self.experiment.and_then(|experiment| experiment.stop) {
            Some(stop) if end > stop + tolerance => Err(Error::BeyondStopTime { end, stop }),
            _ => Ok(()),
        }
    }

    /// No NaN leaves the instance. Inputs and parameters were checked when they were set.
    pub(crate) fn check_finite(&self, time: f64) -> Result<(), Error> {
        let reals = &self.values.reals;
        if all_finite(reals) {
            return Ok(());
        }
        let variables = self.declaration().variables().iter();
        let reals = variables.filter(|variable| matches!(variable.kind, Kind::Real { .. }));
        let mut pairs = reals.zip(&self.values.reals);
        match pairs.find(|(_, value)| !value.is_finite()) {
            Some((variable, &value)) => {
                Err(Error::NotFinite { variable: variable.name.clone(), value, time })
            }
            None => Ok(()),
        }
    }
}

/// Whether all values are finite: zero times any other number is not a number.
///
/// Four sums side by side and no early end make the loop one of vector instructions.
fn all_finite(values: &[f64]) -> bool {
    let (fours, rest) = values.as_chunks::<4>();
    let mut sums = [0.0; 4];
    for four in fours {
        for (sum, value) in sums.iter_mut().zip(four) {
            *sum += 0.0 * value;
        }
    }
    sums.iter().chain(rest).all(|value| value.is_finite())
}
