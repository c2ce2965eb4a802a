//! What comes after the run: further trains at their headway, and the times in which the rails
//! are alone.
//!
//! A further train does to the rails what the train of the run did, step by step from a tape
//! (`tape.rs`): it is the same train, driven in the same way, on rails that are warm already. While
//! the rails are alone all inputs of wheels are zero; a wheel that neither runs nor carries is
//! none. Then steps are long.

use crate::scenario::Heat;

/// What is planned after the run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Traffic {
    /// Trains, that of the run included.
    trains: u32,
    /// Time between two trains, s.
    headway: f64,
    /// Time alone after the last train, s.
    cool_down: f64,
    /// Longest step alone, s.
    longest_step: f64,
}

/// A part of the time after the run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Stage {
    /// The rails are alone: so many steps of that length from a time, s.
    Alone {
        /// Time at the beginning, s.
        from: f64,
        /// Length of a step, s.
        length: f64,
        /// Number of steps.
        steps: u64,
    },
    /// A further train passes, whose run begins at a time, s.
    Train {
        /// Time at the beginning, s.
        from: f64,
    },
}

impl Default for Traffic {
    /// Nothing after the run.
    fn default() -> Self {
        Self { trains: 1, headway: 0.0, cool_down: 0.0, longest_step: 1.0 }
    }
}

impl Traffic {
    /// What a scenario plans.
    pub fn of(heat: &Heat) -> Self {
        Self {
            trains: heat.trains.count,
            headway: 60.0 * heat.trains.headway_minutes,
            cool_down: 60.0 * heat.cool_down_minutes,
            longest_step: heat.cool_down_step_s,
        }
    }

    /// When the rails' time ends if the run takes `run`, s.
    pub fn end(&self, run: f64) -> f64 {
        f64::from(self.trains - 1) * self.headway + run + self.cool_down
    }

    /// When the run of the last train ends if each takes `run`, s.
    pub fn last_train_end(&self, run: f64) -> f64 {
        self.end(run) - self.cool_down
    }

    /// The parts of the time after a run that took `run`, s.
    pub fn stages(&self, run: f64) -> Vec<Stage> {
        let mut stages = vec![];
        for train in 1..self.trains {
            let from = f64::from(train) * self.headway;
            stages.extend(self.alone(from - self.headway + run, from));
            stages.push(Stage::Train { from });
        }
        stages.extend(self.alone(self.last_train_end(run), self.end(run)));
        stages
    }

    /// Equal steps from one time to another, none longer than allowed.
    fn alone(&self, from: f64, until: f64) -> Option<Stage> {
        let steps = ((until - from) / self.longest_step - 1e-9).ceil();
        let length = (until - from) / steps;
        (steps >= 1.0).then_some(Stage::Alone { from, length, steps: steps as u64 })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Three trains of 90 s every 5 min, then 1 min alone in steps of at most 7 s.
    #[test]
    fn analytic_stages_follow_each_other() {
        let traffic = Traffic { trains: 3, headway: 300.0, cool_down: 60.0, longest_step: 7.0 };
        assert_eq!(traffic.end(90.0), 750.0);
        let alone = |from, steps, length| Stage::Alone { from, length, steps };
        let between = 210.0 / 30.0;
        assert_eq!(
            traffic.stages(90.0),
            [
                alone(90.0, 30, between),
                Stage::Train { from: 300.0 },
                alone(390.0, 30, between),
                Stage::Train { from: 600.0 },
                alone(690.0, 9, 60.0 / 9.0),
            ]
        );
    }

    #[test]
    fn a_run_alone_has_no_stages() {
        let traffic = Traffic::default();
        assert_eq!(traffic.stages(200.0), []);
        assert_eq!(traffic.end(200.0), 200.0);
    }
}
