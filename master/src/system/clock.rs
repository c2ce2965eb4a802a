//! Communication points, from integers so that rounding does not add up.

/// Communication points t_k = start + k·length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Clock {
    /// Time of point 0, s.
    pub start: f64,
    /// Time between two points, s.
    pub length: f64,
}

impl Clock {
    /// Time of point `k`, s.
    pub fn at(&self, k: u64) -> f64 {
        self.start + k as f64 * self.length
    }
}

/// Margin of [`beyond`], in parts of the time: the roundings of ten million steps that an FMU adds up.
const MARGIN: f64 = 1e-9;

/// The stop time to announce for a run from `start` that ends at `stop`, s: a little later.
///
/// The last step t + h may end behind `stop` by rounding, and an FMU may refuse a step beyond the
/// announced time (FMI 2.0 §2.1.6).
pub fn beyond(start: f64, stop: f64) -> f64 {
    stop + MARGIN * (stop - start).max(stop.abs())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All whole durations up to five minutes: an FMU that takes the communication point and the step as
    /// they are, and one that adds the steps up itself, never come behind what was announced.
    #[test]
    fn property_no_step_ends_behind_the_announced_stop_time() {
        for length in [0.05, 0.005, 0.001] {
            for start in [0.0, -7.3, 1e5 + 0.1] {
                let clock = Clock { start, length };
                for duration in 1..=300 {
                    let steps = (f64::from(duration) / length).round() as u64;
                    let announced = beyond(start, clock.at(steps));
                    let last = clock.at(steps - 1) + length;
                    assert!(last <= announced, "{start} + {duration} s by {length} s: {last}");
                    assert!(announced < clock.at(steps) + 0.5 * length);
                }
                let steps = (300.0 / length).round() as u64;
                let mut own = start;
                for k in 0..steps {
                    own += length;
                    let announced = beyond(start, clock.at(k + 1));
                    assert!(own <= announced, "{start} by {length} s: {own} at step {k}");
                }
            }
        }
    }

    /// What happens without a margin: this is why there is one.
    #[test]
    fn the_last_step_may_end_behind_the_stop_time_by_rounding() {
        let clock = Clock { start: 0.0, length: 0.05 };
        let passes = |&duration: &u64| clock.at(duration * 20 - 1) + 0.05 > duration as f64;
        assert!((1..=300).filter(passes).count() > 100);
    }
}
