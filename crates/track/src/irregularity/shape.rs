//! Single defects of one rail or both.

use std::f64::consts::{PI, TAU};

use serde::Deserialize;

use super::RailOffset;

/// Form of a defect.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub(super) enum Form {
    /// Rises linearly to the amplitude and stays.
    Ramp,
    /// As many full sine waves as `waves` says, and zero outside.
    Sine,
    /// Waves of (1 - cos)/2, which all go to one side, and zero outside.
    Dip,
}

/// Rail or rails that a defect has.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub(super) enum Rails {
    /// The left one.
    Left,
    /// The right one.
    Right,
    /// Both alike.
    Both,
    /// The left one, and the right one to the opposite side.
    Opposite,
}

/// Direction of a defect.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub(super) enum Direction {
    /// Across, amplitude positive to the right.
    Lateral,
    /// Down.
    Vertical,
}

/// A defect.
#[derive(Clone, Debug)]
pub(super) struct Shape {
    pub form: Form,
    pub rails: Rails,
    pub direction: Direction,
    /// Chainage at which it begins, m.
    pub begin: f64,
    pub length: f64,
    /// m.
    pub amplitude: f64,
    /// Number of waves in the length.
    pub waves: f64,
}

impl Shape {
    /// Adds the defect at a chainage.
    #[inline]
    pub fn add_to(&self, rails: &mut [RailOffset; 2], chainage: f64) {
        let share = (chainage - self.begin) / self.length;
        if share <= 0.0 {
            return;
        }
        let (value, slope) = self.unit(share);
        let factors = match self.rails {
            Rails::Left => [1.0, 0.0],
            Rails::Right => [0.0, 1.0],
            Rails::Both => [1.0, 1.0],
            Rails::Opposite => [1.0, -1.0],
        };
        for (rail, factor) in rails.iter_mut().zip(factors) {
            let (value, slope) =
                (factor * self.amplitude * value, factor * self.amplitude * slope / self.length);
            match self.direction {
                Direction::Lateral => {
                    rail.lateral += value;
                    rail.lateral_slope += slope;
                }
                Direction::Vertical => {
                    rail.vertical += value;
                    rail.vertical_slope += slope;
                }
            }
        }
    }

    /// Value and slope of a defect of length and amplitude one.
    fn unit(&self, share: f64) -> (f64, f64) {
        let phase = TAU * self.waves * share;
        match self.form {
            Form::Ramp if share < 1.0 => (share, 1.0),
            Form::Ramp => (1.0, 0.0),
            Form::Sine if share < 1.0 => (phase.sin(), TAU * self.waves * phase.cos()),
            Form::Dip if share < 1.0 => (0.5 * (1.0 - phase.cos()), PI * self.waves * phase.sin()),
            Form::Sine | Form::Dip => (0.0, 0.0),
        }
    }
}
