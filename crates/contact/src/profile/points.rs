//! A profile through points, on which a wheel runs.

use super::kind::ProfileKind;
use super::point::ProfilePoint;
use super::spline::Spline;

/// Least distance of two points across the track that counts as going on, in m.
const LEAST_STEP: f64 = 1e-6;

/// How far an outline may go back across the track before it ends there, in m: a measurement in two
/// parts overlaps by less, a side that is undercut by more.
const MOST_BACK: f64 = 1e-3;

/// Steepness with which a face at least goes on, so that it is somewhere.
const LEAST_STEEPNESS: f64 = 0.01;

/// An outline of points in m, and the curve through the part of it on which a wheel can run.
///
/// Points stand from the gauge side or flange to the field side.
#[derive(Clone, Debug, PartialEq)]
pub struct PointProfile {
    name: String,
    kind: ProfileKind,
    outline: Vec<[f64; 2]>,
    spline: Spline,
    /// Points of the curve.
    count: usize,
}

impl PointProfile {
    /// The profile of this outline.
    ///
    /// The curve reaches from the tip of the flange or the top of the rail both ways as far as the
    /// lateral coordinate goes on.
    pub(super) fn new(name: String, kind: ProfileKind, outline: Vec<[f64; 2]>) -> Self {
        let middle = match kind {
            ProfileKind::Wheel => {
                outline.iter().enumerate().max_by(|a, b| a.1[1].total_cmp(&b.1[1]))
            }
            ProfileKind::Rail => {
                outline.iter().enumerate().min_by(|a, b| a.1[1].total_cmp(&b.1[1]))
            }
        };
        let middle = middle.map_or(0, |(i, _)| i);
        let mut points = going_on(outline[..=middle].iter().rev().copied(), -1.0);
        points.reverse();
        points.extend(going_on(outline[middle..].iter().copied(), 1.0).into_iter().skip(1));
        let count = points.len();
        // A curve needs two points; a single one is refused later.
        if count < 2 {
            points.push([points[0][0] + LEAST_STEP, points[0][1]]);
        }
        Self { name, kind, outline, spline: Spline::new(&points), count }
    }

    /// Name of the file.
    pub(super) fn name(&self) -> &str {
        &self.name
    }

    /// Number of points on which a wheel can run.
    pub(super) fn count(&self) -> usize {
        self.count
    }

    /// All points, m: lateral coordinate and height, from the gauge side or flange to the field side.
    pub fn outline(&self) -> &[[f64; 2]] {
        &self.outline
    }

    /// First and last lateral coordinate on which a wheel can run, in m.
    pub fn range(&self) -> (f64, f64) {
        self.spline.range()
    }

    /// The profile at `lateral` metres, outside the points the value at the end.
    pub fn at(&self, lateral: f64) -> ProfilePoint {
        self.spline.at(lateral)
    }

    /// Lateral coordinate and height of the highest point, m.
    pub fn top(&self) -> [f64; 2] {
        self.spline.top()
    }

    /// The same profile, moved by these metres to the side and down.
    pub(super) fn moved(&self, by: [f64; 2]) -> Self {
        let moved = self.outline.iter().map(|[y, z]| [y + by[0], z + by[1]]);
        Self::new(self.name.clone(), self.kind, moved.collect())
    }

    /// The profile leaning by `inclination`, with its highest point as the origin.
    pub(super) fn inclined(&self, inclination: f64) -> Self {
        let (sine, cosine) = libm::sincos(libm::atan(inclination));
        let turn = |&[y, z]: &[f64; 2]| [y * cosine + z * sine, z * cosine - y * sine];
        let outline = self.outline.iter().map(turn).collect();
        let turned = Self::new(self.name.clone(), self.kind, outline);
        let [y, z] = turned.top();
        turned.moved([-y, -z])
    }

    /// Lateral coordinate nearest to the middle of the track between the top and `depth` metres below
    /// it, where the gauge is measured.
    ///
    /// Below the end of the points the face is taken as upright.
    pub(super) fn gauge_face(&self, depth: f64) -> f64 {
        let [top, height] = self.top();
        let deep = height + depth;
        let beside = self.outline.iter().rev().skip_while(|point| point[0] > top);
        let mut nearest = top;
        let mut before = [top, height];
        for point in beside {
            if point[1] > deep {
                let share = (deep - before[1]) / (point[1] - before[1]);
                return nearest.min(before[0] + share * (point[0] - before[0]));
            }
            nearest = nearest.min(point[0]);
            before = *point;
        }
        nearest
    }

    /// How uncertain the gauge is, in m, where points of it are missing.
    ///
    /// It is how far aside the gauge side's tangent at its end reaches the `depth` of the gauge.
    pub(crate) fn gauge_lacks(&self, depth: f64) -> f64 {
        let steepness = (-self.at(self.range().0).slope).max(LEAST_STEEPNESS);
        (depth - self.gauge_depth()).max(0.0) / steepness
    }

    /// How far the gauge side reaches below the top, m.
    pub fn gauge_depth(&self) -> f64 {
        let [top, height] = self.top();
        let gauge_side = self.outline.iter().filter(|point| point[0] < top);
        gauge_side.fold(0.0, |deepest: f64, point| deepest.max(point[1] - height))
    }
}

/// The points that go on in the direction of `sign`, until the outline goes back for good.
fn going_on(outline: impl Iterator<Item = [f64; 2]>, sign: f64) -> Vec<[f64; 2]> {
    let mut points: Vec<[f64; 2]> = vec![];
    for point in outline {
        let ahead = points.last().map_or(f64::INFINITY, |last| sign * (point[0] - last[0]));
        if ahead > LEAST_STEP {
            points.push(point);
        } else if ahead < -MOST_BACK {
            break;
        }
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A head with a flank that is undercut, its underside, and a crown of z = y²/100 mm.
    fn head() -> PointProfile {
        let mut outline = vec![[-20.0, 45.0], [-34.0, 38.0], [-35.0, 30.0], [-36.0, 14.0]];
        outline.extend((-35..=35).map(|i| [f64::from(i), f64::from(i * i) / 100.0]));
        outline.extend([[36.0, 14.0], [35.5, 30.0]]);
        let metres = outline.iter().map(|point| point.map(|value| 1e-3 * value)).collect();
        PointProfile::new("head".into(), ProfileKind::Rail, metres)
    }

    #[test]
    fn an_outline_is_followed_to_where_it_goes_back() {
        let (begin, end) = head().range();
        assert!((begin + 0.036).abs() < 1e-12 && (end - 0.036).abs() < 1e-12);
        assert!((head().at(-0.0205).height - 4.2025e-3).abs() < 1e-8);
    }

    /// At 14 mm the flank stands out farthest; what is below is nearer to the middle of the rail.
    #[test]
    fn analytic_the_gauge_is_measured_at_the_nearest_point() {
        assert!((head().gauge_face(0.014) + 0.036).abs() < 1e-9);
        assert!((head().gauge_face(0.020) + 0.036).abs() < 1e-9);
        assert!((head().gauge_face(0.009) + 0.030).abs() < 1e-9);
        assert!((head().gauge_depth() - 0.045).abs() < 1e-9);
    }

    /// The top of a leaning parabola lies where its slope is the inclination: y = 50 mm/40.
    #[test]
    fn analytic_a_leaning_head_has_its_top_where_its_slope_is() {
        let leaning = head().inclined(1.0 / 40.0);
        assert!(leaning.at(0.0).height.abs() < 1e-15);
        assert!(leaning.at(0.0).slope.abs() < 1e-6);
        // Turned by 1/40 the parabola of 1/50 mm is the same one about its new top, but for the turn of
        // its chords: 9 mm below lies y = 1.25 mm − sqrt(900 (1 + 1/40²)) mm.
        let (sine, cosine) = libm::sincos((1.0_f64 / 40.0).atan());
        let across = |y: f64| 1e-3 * (y * cosine + y * y / 100.0 * sine);
        let y = 1.25 - (900.0 * (1.0_f64 + 1.0 / 1600.0).sqrt()).sqrt();
        let beside = leaning.gauge_face(0.009) - (across(y) - across(1.25));
        // Between points 1 mm apart the face is their chord.
        assert!(beside.abs() < 5e-6, "{beside}");
    }
}
