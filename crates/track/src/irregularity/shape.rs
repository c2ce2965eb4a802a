//! Single defects of one rail or both.

use std::f64::consts::{PI, TAU};

use schemars::JsonSchema;
use serde::Deserialize;

use super::rail_offset::RailOffset;

/// Form of a defect.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
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
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
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
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
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
            Form::Sine if share < 1.0 => (libm::sin(phase), TAU * self.waves * libm::cos(phase)),
            Form::Dip if share < 1.0 => {
                (0.5 * (1.0 - libm::cos(phase)), PI * self.waves * libm::sin(phase))
            }
            Form::Sine | Form::Dip => (0.0, 0.0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shape(form: Form, rails: Rails, direction: Direction) -> Shape {
        Shape { form, rails, direction, begin: 100.0, length: 20.0, amplitude: 4e-3, waves: 2.0 }
    }

    fn at(shape: &Shape, chainage: f64) -> [RailOffset; 2] {
        let mut rails = [RailOffset::default(); 2];
        shape.add_to(&mut rails, chainage);
        rails
    }

    /// Two sine waves in 20 m: crests at 102.5 and 112.5 m, zeros at 105 and 110 m; the steepest
    /// slope is 2π a n/l. Two dips: 4 mm at 105 and 115 m.
    #[test]
    fn analytic_crests_and_zeros_of_waves() {
        let sine = shape(Form::Sine, Rails::Left, Direction::Lateral);
        for (chainage, value) in [(102.5, 4e-3), (105.0, 0.0), (107.5, -4e-3), (112.5, 4e-3)] {
            assert!((at(&sine, chainage)[0].lateral - value).abs() < 1e-17);
        }
        let steepest = TAU * 4e-3 * 2.0 / 20.0;
        assert!((at(&sine, 110.0)[0].lateral_slope - steepest).abs() < 1e-17);
        let dip = shape(Form::Dip, Rails::Right, Direction::Vertical);
        for (chainage, value) in [(102.5, 2e-3), (105.0, 4e-3), (110.0, 0.0), (115.0, 4e-3)] {
            assert!((at(&dip, chainage)[1].vertical - value).abs() < 1e-17);
        }
    }

    /// Slopes against differences over 2 mm, whose own error is below 1e-9.
    #[test]
    fn analytic_slopes_are_derivatives() {
        for form in [Form::Ramp, Form::Sine, Form::Dip] {
            let shape = shape(form, Rails::Both, Direction::Vertical);
            for chainage in [101.0, 104.3, 116.9, 130.0] {
                let difference = at(&shape, chainage + 1e-3)[0].vertical
                    - at(&shape, chainage - 1e-3)[0].vertical;
                let slope = at(&shape, chainage)[0].vertical_slope;
                assert!((slope - difference / 2e-3).abs() < 1e-9, "{form:?} at {chainage} m");
            }
        }
    }

    #[test]
    fn a_ramp_stays_and_waves_end() {
        let behind = |form| at(&shape(form, Rails::Left, Direction::Lateral), 125.0)[0].lateral;
        assert_eq!([Form::Ramp, Form::Sine, Form::Dip].map(behind), [4e-3, 0.0, 0.0]);
        let before = shape(Form::Ramp, Rails::Left, Direction::Lateral);
        assert_eq!(at(&before, 99.9), [RailOffset::default(); 2]);
    }

    #[test]
    fn each_rail_has_its_sign() {
        let laterals = |rails| {
            at(&shape(Form::Ramp, rails, Direction::Lateral), 110.0).map(|rail| rail.lateral)
        };
        assert_eq!(laterals(Rails::Left), [2e-3, 0.0]);
        assert_eq!(laterals(Rails::Right), [0.0, 2e-3]);
        assert_eq!(laterals(Rails::Both), [2e-3, 2e-3]);
        assert_eq!(laterals(Rails::Opposite), [2e-3, -2e-3]);
    }
}
