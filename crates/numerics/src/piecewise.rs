//! Functions by points with straight lines or cubic splines between them, and steps.

use crate::table::{TableError, interval};

/// How a function goes from point to point.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Interpolation {
    /// Straight lines.
    #[default]
    Linear,
    /// A cubic spline with continuous curvature. At its ends it has the slope of the outermost
    /// chord, so that a spline through two points is a straight line.
    Cubic,
}

/// A function by points, constant outside them.
///
/// An abscissa may stand twice: there the function steps from the first value to the second (or,
/// with equal values, has a corner), and a new spline begins.
#[derive(Clone, Debug, PartialEq)]
pub struct Piecewise {
    x: Vec<f64>,
    /// Coefficients of the powers of the distance from the beginning of each interval.
    pieces: Vec<[f64; 4]>,
}

impl Piecewise {
    /// The function through the points `(x[i], y[i])`.
    ///
    /// # Errors
    /// When the columns differ in length, are empty, not finite, or `x` falls or stands more than
    /// twice.
    pub fn new(x: Vec<f64>, y: &[f64], interpolation: Interpolation) -> Result<Self, TableError> {
        if x.len() != y.len() || x.is_empty() {
            return Err(TableError::Shape { x: x.len(), y: y.len() });
        }
        if let Some(row) = (0..x.len()).find(|&i| !(x[i].is_finite() && y[i].is_finite())) {
            return Err(TableError::NotFinite { row: row + 1 });
        }
        let falls = |&i: &usize| x[i] < x[i - 1] || (i > 1 && x[i] == x[i - 2]);
        if let Some(i) = (1..x.len()).find(falls) {
            return Err(TableError::NotRising { row: i + 1, before: x[i - 1], value: x[i] });
        }
        let mut pieces = Vec::with_capacity(x.len());
        let mut begin = 0;
        for end in 1..=x.len() {
            if end == x.len() || x[end] == x[end - 1] {
                let slopes = match interpolation {
                    Interpolation::Linear => None,
                    Interpolation::Cubic => Some(spline_slopes(&x[begin..end], &y[begin..end])),
                };
                for i in begin..end - 1 {
                    let ends = slopes.as_ref().map(|s| (s[i - begin], s[i + 1 - begin]));
                    pieces.push(piece(x[i + 1] - x[i], y[i], y[i + 1], ends));
                }
                // The interval without length at a step, and what holds beyond the last point.
                pieces.push([y[end - 1], 0.0, 0.0, 0.0]);
                begin = end;
            }
        }
        Ok(Self { x, pieces })
    }

    /// The value at `x`; `index` is any number at first and that of the last lookup later.
    pub fn value(&self, x: f64, index: &mut usize) -> f64 {
        self.expansion(x, index)[0]
    }

    /// Coefficients of the powers of the distance from `x`, valid up to the next point.
    pub fn expansion(&self, x: f64, index: &mut usize) -> [f64; 4] {
        let last = self.x.len() - 1;
        if x < self.x[0] {
            return [self.pieces[0][0], 0.0, 0.0, 0.0];
        }
        *index = match x >= self.x[last] {
            true => last,
            false => interval(&self.x, x, *index),
        };
        let s = x - self.x[*index];
        let [a, b, c, d] = self.pieces[*index];
        [a + s * (b + s * (c + s * d)), b + s * (2.0 * c + s * 3.0 * d), c + s * 3.0 * d, d]
    }

    /// The abscissae.
    pub fn x(&self) -> &[f64] {
        &self.x
    }
}

/// Coefficients of the piece of a length, from one value to the next.
///
/// A cubic one has the slopes at its ends.
fn piece(length: f64, from: f64, to: f64, slopes: Option<(f64, f64)>) -> [f64; 4] {
    let chord = (to - from) / length;
    match slopes {
        None => [from, chord, 0.0, 0.0],
        Some((begin, end)) => {
            let quadratic = (3.0 * chord - 2.0 * begin - end) / length;
            let cubic = (begin + end - 2.0 * chord) / (length * length);
            [from, begin, quadratic, cubic]
        }
    }
}

/// Slopes of the spline at its points: continuous curvature inside, those of the chords at the
/// ends (a tridiagonal system, solved from both ends of its diagonal).
fn spline_slopes(x: &[f64], y: &[f64]) -> Vec<f64> {
    let last = x.len() - 1;
    if last == 0 {
        return vec![0.0];
    }
    let length = |i: usize| x[i + 1] - x[i];
    let chord = |i: usize| (y[i + 1] - y[i]) / length(i);
    let mut slopes = vec![chord(0); x.len()];
    slopes[last] = chord(last - 1);
    // After the elimination slope[i] = slopes[i] - share[i] slope[i + 1].
    let mut share = vec![0.0; x.len()];
    for i in 1..last {
        let (before, after) = (1.0 / length(i - 1), 1.0 / length(i));
        let pivot = 2.0 * (before + after) - before * share[i - 1];
        let right = 3.0 * (before * chord(i - 1) + after * chord(i));
        slopes[i] = (right - before * slopes[i - 1]) / pivot;
        share[i] = after / pivot;
    }
    for i in (1..last).rev() {
        slopes[i] -= share[i] * slopes[i + 1];
    }
    slopes
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(function: &Piecewise, x: f64) -> f64 {
        function.value(x, &mut 0)
    }

    /// The conditions that define the spline.
    #[test]
    fn analytic_spline_meets_its_points_and_has_continuous_curvature() {
        let (x, y) = (vec![0.0, 1.0, 3.0, 4.0], [0.0, 2.0, 1.0, 5.0]);
        let spline = Piecewise::new(x.clone(), &y, Interpolation::Cubic).unwrap();
        for (x, y) in x.iter().zip(y) {
            assert!((at(&spline, *x) - y).abs() < 1e-14);
        }
        for x in [1.0, 3.0] {
            let [_, before, bend_before, _] = spline.expansion(x - 1e-9, &mut 0);
            let [_, after, bend_after, _] = spline.expansion(x, &mut 0);
            assert!((before - after).abs() < 1e-7 && (bend_before - bend_after).abs() < 1e-7);
        }
        assert!((spline.expansion(0.0, &mut 0)[1] - 2.0).abs() < 1e-14);
        assert!((spline.expansion(4.0 - 1e-12, &mut 0)[1] - 4.0).abs() < 1e-9);
    }

    #[test]
    fn analytic_spline_through_two_points_is_a_straight_line() {
        let line = Piecewise::new(vec![1.0, 3.0], &[4.0, 8.0], Interpolation::Cubic).unwrap();
        for (x, y) in [(0.0, 4.0), (1.5, 5.0), (3.0, 8.0), (9.0, 8.0)] {
            assert!((at(&line, x) - y).abs() < 1e-14);
        }
    }

    #[test]
    fn an_abscissa_that_stands_twice_is_a_step() {
        let x = vec![0.0, 1.0, 1.0, 2.0];
        for interpolation in [Interpolation::Linear, Interpolation::Cubic] {
            let step = Piecewise::new(x.clone(), &[0.0, 1.0, 5.0, 7.0], interpolation).unwrap();
            assert!((at(&step, 0.5) - 0.5).abs() < 1e-14);
            assert_eq!(at(&step, 1.0), 5.0);
            assert!((at(&step, 1.5) - 6.0).abs() < 1e-14);
        }
    }

    #[test]
    fn an_abscissa_that_stands_three_times_is_refused_by_row() {
        let error = Piecewise::new(vec![1.0; 3], &[0.0; 3], Interpolation::Linear).unwrap_err();
        assert_eq!(error, TableError::NotRising { row: 3, before: 1.0, value: 1.0 });
    }
}
