//! The curve through the points of an outline.
//!
//! Lateral coordinate y and height z are piecewise cubics of the length s along the polyline of the
//! points. So a face is no steeper for the curve than a tread is, and two points 3 µm beside each
//! other on a gauge face are 0.5 mm apart. The derivatives at the points are those of the parabola
//! through three of them, limited:
//!
//! - y'(s) to 0 .. 3 of the smaller chord beside it, so that y rises everywhere (Fritsch and Carlson,
//!   SIAM J. Numer. Anal. 17 (1980) 238);
//! - z'(s) to what keeps z monotone where the points are, and the parabola at a smooth crown (the
//!   constraint M3-A of Huynh, SIAM J. Numer. Anal. 30 (1993) 57).
//!
//! The slope dz/dy = z'/y' is continuous. The curve meets a parabola and an arc with an error of third
//! order in the distance of the points, and does not overshoot where they have a corner.

use super::point::ProfilePoint;

/// Least dy/ds for a slope: what is steeper has the slope 1e4.
const LEAST_RISE: f64 = 1e-4;

/// Halvings or steps of Newton's method that find a lateral coordinate.
const MOST_STEPS: usize = 60;

/// A point of the curve with the derivatives by its length.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Knot {
    /// Length from the beginning, m.
    length: f64,
    /// Lateral coordinate and height, m.
    at: [f64; 2],
    /// Their derivatives by the length.
    direction: [f64; 2],
}

/// A curve through points whose lateral coordinates rise.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Spline {
    knots: Vec<Knot>,
}

impl Spline {
    /// The curve through these points, in m; at least two, with rising lateral coordinates.
    pub fn new(points: &[[f64; 2]]) -> Self {
        let lengths = lengths(points);
        let of = |i: usize| points.iter().map(|point| point[i]).collect::<Vec<f64>>();
        let along = derivatives(&lengths, &of(0), rising);
        let down = derivatives(&lengths, &of(1), monotone);
        let knot =
            |i: usize| Knot { length: lengths[i], at: points[i], direction: [along[i], down[i]] };
        Self { knots: (0..points.len()).map(knot).collect() }
    }

    /// First and last lateral coordinate, m.
    pub fn range(&self) -> (f64, f64) {
        (self.knots[0].at[0], self.knots[self.knots.len() - 1].at[0])
    }

    /// Height and slope at `lateral` metres, outside the points those at the end.
    pub fn at(&self, lateral: f64) -> ProfilePoint {
        let (begin, end) = self.range();
        let y = lateral.clamp(begin, end);
        let after = self.knots.partition_point(|knot| knot.at[0] <= y);
        let after = after.clamp(1, self.knots.len() - 1);
        let piece = Piece::new(&self.knots[after - 1], &self.knots[after]);
        let share = piece.share(y);
        let [along, down] = piece.direction(share);
        ProfilePoint { height: piece.value(1, share), slope: down / along.max(LEAST_RISE) }
    }

    /// Lateral coordinate and height of the highest point, m.
    pub fn top(&self) -> [f64; 2] {
        let highest = self.knots.iter().enumerate().min_by(|a, b| a.1.at[1].total_cmp(&b.1.at[1]));
        let (i, knot) = highest.map_or((0, self.knots[0]), |(i, knot)| (i, *knot));
        // Between the neighbours of the highest knot the slope goes through zero once.
        let mut low = self.knots[i.saturating_sub(1)].at[0];
        let mut high = self.knots[(i + 1).min(self.knots.len() - 1)].at[0];
        for _ in 0..MOST_STEPS {
            let middle = 0.5 * (low + high);
            if self.at(middle).slope < 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
        let found = self.at(high);
        if found.height < knot.at[1] { [high, found.height] } else { knot.at }
    }
}

/// The cubics between two knots, in powers of the share of the length.
struct Piece {
    length: f64,
    coordinates: [[f64; 4]; 2],
}

impl Piece {
    fn new(begin: &Knot, end: &Knot) -> Self {
        let length = end.length - begin.length;
        let cubic = |i: usize| {
            let rise = end.at[i] - begin.at[i];
            let (p, q) = (length * begin.direction[i], length * end.direction[i]);
            [begin.at[i], p, 3.0 * rise - 2.0 * p - q, p + q - 2.0 * rise]
        };
        Self { length, coordinates: [cubic(0), cubic(1)] }
    }

    fn value(&self, i: usize, t: f64) -> f64 {
        let [c0, c1, c2, c3] = self.coordinates[i];
        c0 + t * (c1 + t * (c2 + t * c3))
    }

    /// dy/ds and dz/ds.
    fn direction(&self, t: f64) -> [f64; 2] {
        self.coordinates.map(|[_, c1, c2, c3]| (c1 + t * (2.0 * c2 + t * 3.0 * c3)) / self.length)
    }

    /// Where the lateral coordinate is `y`: Newton's method, halved where it leaves the bracket.
    fn share(&self, y: f64) -> f64 {
        let [c0, c1, c2, c3] = self.coordinates[0];
        let width = c1 + c2 + c3;
        let (mut low, mut high) = (0.0, 1.0);
        let mut t = ((y - c0) / width).clamp(0.0, 1.0);
        for _ in 0..MOST_STEPS {
            let wrong = self.value(0, t) - y;
            if wrong > 0.0 {
                high = t;
            } else {
                low = t;
            }
            let next = t - wrong / (c1 + t * (2.0 * c2 + t * 3.0 * c3));
            let next = if next > low && next < high { next } else { 0.5 * (low + high) };
            if wrong.abs() <= 1e-15 * width.abs().max(y.abs()) || next == t {
                break;
            }
            t = next;
        }
        t
    }
}

/// Length of the polyline up to each point, m.
pub(super) fn lengths(points: &[[f64; 2]]) -> Vec<f64> {
    let mut length = 0.0;
    let mut before = points.first().copied().unwrap_or_default();
    let grown = |point: &[f64; 2]| {
        length += libm::hypot(point[0] - before[0], point[1] - before[1]);
        before = *point;
        length
    };
    points.iter().map(grown).collect()
}

/// The chords and curvatures around a point.
struct Around {
    /// Derivative of the parabola through the point and its neighbours.
    parabola: f64,
    /// Slope of the chord before and after it.
    chords: [f64; 2],
    /// The same slopes, carried to the point by the curvature that both ends of the chord agree on.
    carried: [f64; 2],
}

/// Derivative at each point by a `limit` of that of the parabola.
fn derivatives(lengths: &[f64], values: &[f64], limit: fn(&Around) -> f64) -> Vec<f64> {
    let count = values.len();
    let step = |i: usize| lengths[i + 1] - lengths[i];
    let chord = |i: usize| (values[i + 1] - values[i]) / step(i);
    // Half of the second derivative at a point that has both neighbours, else that of the next.
    let bend = |i: usize| match count {
        0..3 => 0.0,
        _ => {
            let i = i.clamp(1, count - 2);
            (chord(i) - chord(i - 1)) / (lengths[i + 1] - lengths[i - 1])
        }
    };
    let at_end = |chord: f64, parabola: f64| {
        limit(&Around { parabola, chords: [chord; 2], carried: [parabola; 2] })
    };
    let derivative = |i: usize| match i {
        0 => at_end(chord(0), chord(0) - step(0) * bend(0)),
        _ if i == count - 1 => at_end(chord(i - 1), chord(i - 1) + step(i - 1) * bend(i)),
        _ => {
            let (before, after) = (step(i - 1), step(i));
            let chords = [chord(i - 1), chord(i)];
            limit(&Around {
                parabola: (after * chords[0] + before * chords[1]) / (before + after),
                chords,
                carried: [
                    chords[0] + before * smaller(bend(i - 1), bend(i)),
                    chords[1] - after * smaller(bend(i), bend(i + 1)),
                ],
            })
        }
    };
    (0..count).map(derivative).collect()
}

/// The derivative of a value that must rise.
fn rising(around: &Around) -> f64 {
    let [before, after] = around.chords;
    around.parabola.clamp(0.0, 3.0 * before.min(after).max(0.0))
}

/// The derivative of a value that is monotone where its points are.
fn monotone(around: &Around) -> f64 {
    let [before, after] = around.chords;
    let carried = smaller(around.carried[0], around.carried[1]);
    let most = (3.0 * smaller(before, after).abs()).max(1.5 * carried.abs());
    smaller(around.parabola, most.copysign(carried))
}

/// The one nearer to zero of two numbers of the same sign, else zero.
fn smaller(a: f64, b: f64) -> f64 {
    match a * b > 0.0 {
        true if a.abs() < b.abs() => a,
        true => b,
        false => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An arc of 13 mm through points 0.25 mm apart: third order leaves h³/R² of some 0.1 µm in height
    /// and 1e-4 in slope, also where it is steep.
    #[test]
    fn analytic_an_arc_is_met() {
        let radius: f64 = 0.013;
        let point = |angle: f64| [radius * angle.sin(), radius * (1.0 - angle.cos())];
        let count = 72;
        let angles = (0..=count).map(|i| -1.4 + 2.8 * f64::from(i) / f64::from(count));
        let spline = Spline::new(&angles.map(point).collect::<Vec<_>>());
        for i in 1..400 {
            let angle = -1.39 + 2.78 * f64::from(i) / 400.0;
            let [y, z] = point(angle);
            let found = spline.at(y);
            let steepness = 1.0 / angle.cos();
            assert!((found.height - z).abs() < 1e-7 * steepness, "{found:?} at {angle}");
            let turned = found.slope.atan() - angle;
            assert!(turned.abs() < 2e-4, "{turned} at {angle}");
        }
        let [y, z] = spline.top();
        assert!(y.abs() < 1e-6 && z.abs() < 1e-9, "{y} {z}");
    }

    /// Two points of a gauge face 3 µm beside each other: a cubic over the lateral coordinate overshot
    /// by millimetres there. The curve stays between the heights of its points where they are monotone.
    #[test]
    fn property_no_overshoot_on_a_steep_face() {
        let points = [
            [-35.3298e-3, 11.9341e-3],
            [-35.3268e-3, 11.4341e-3],
            [-34.9268e-3, 11.3841e-3],
            [-34.8432e-3, 11.1485e-3],
            [-34.7550e-3, 10.9145e-3],
            [-34.0e-3, 9.3e-3],
            [-30.0e-3, 5.3e-3],
        ];
        let spline = Spline::new(&points);
        for pair in points.windows(2) {
            for i in 0..=50 {
                let y = pair[0][0] + (pair[1][0] - pair[0][0]) * f64::from(i) / 50.0;
                let height = spline.at(y).height;
                assert!(
                    (pair[1][1] - 1e-12..=pair[0][1] + 1e-12).contains(&height),
                    "{height} between {pair:?}"
                );
            }
        }
    }

    /// The lateral coordinate of each point gives its height back, however near the points are.
    #[test]
    fn property_the_curve_goes_through_its_points() {
        let points: Vec<[f64; 2]> = (0..40)
            .map(|i| {
                let x = f64::from(i);
                [1e-3 * x + 0.9e-3 * (x * 1.7).sin() * 0.5, 1e-3 * (x * 0.9).cos()]
            })
            .collect();
        let spline = Spline::new(&points);
        for [y, z] in points {
            assert!((spline.at(y).height - z).abs() < 1e-12);
        }
    }
}
