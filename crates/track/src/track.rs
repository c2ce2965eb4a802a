//! The compiled track.

use numerics::interval;

/// Track properties at one chainage.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TrackPoint {
    /// Curvature 1/R, positive for a right-hand curve, 1/m.
    pub curvature: f64,
    /// Change of the curvature along the track, 1/m².
    pub curvature_slope: f64,
    /// Heading ∫ curvature ds from the start of the track, rad.
    pub heading: f64,
    /// ∫ heading ds: lateral offset to the right in the small-angle plane, m.
    pub heading_integral: f64,
    /// Cant angle, positive when the right rail is the lower, rad.
    pub cant_angle: f64,
    /// Change of the cant angle along the track (twist), rad/m.
    pub cant_angle_slope: f64,
    /// Gradient dz/ds, positive uphill, m/m.
    pub gradient: f64,
    /// Change of the gradient along the track (vertical curvature), 1/m.
    pub gradient_slope: f64,
    /// Height above the start of the track, m.
    pub elevation: f64,
    /// ∫ elevation ds from the start of the track, m².
    pub elevation_integral: f64,
}

/// A piece of track in which curvature, cant and gradient are cubic in the chainage.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Piece {
    /// Integrals at the beginning of the piece, as in [`TrackPoint`].
    pub heading: f64,
    pub heading_integral: f64,
    pub elevation: f64,
    pub elevation_integral: f64,
    /// Coefficients of the powers of the distance from the beginning of the piece.
    pub curvature: [f64; 4],
    pub cant_angle: [f64; 4],
    pub gradient: [f64; 4],
    /// All three are constant, as on most of a track, which then costs no polynomial.
    pub uniform: bool,
}

/// A location on the track, for those who need little of what holds there.
#[derive(Clone, Copy, Debug)]
pub struct Location<'a> {
    piece: &'a Piece,
    /// Distance from the beginning of the piece, m.
    distance: f64,
}

impl Location<'_> {
    /// As [`TrackPoint::curvature`].
    #[inline]
    pub fn curvature(&self) -> f64 {
        value(&self.piece.curvature, self.distance)
    }

    /// As [`TrackPoint::heading`].
    #[inline]
    pub fn heading(&self) -> f64 {
        self.piece.heading + integral(&self.piece.curvature, self.distance)
    }

    /// As [`TrackPoint::gradient`].
    #[inline]
    pub fn gradient(&self) -> f64 {
        value(&self.piece.gradient, self.distance)
    }

    /// As [`TrackPoint::elevation`].
    #[inline]
    pub fn elevation(&self) -> f64 {
        self.piece.elevation + integral(&self.piece.gradient, self.distance)
    }
}

/// Curvature, cant and gradient as functions of the chainage, in closed form piece by piece.
///
/// Before the first piece and after the last one the outermost values hold.
#[derive(Clone, Debug)]
pub struct Track {
    /// Chainage at which each piece begins, m, rising.
    pub(crate) begins: Vec<f64>,
    pub(crate) pieces: Vec<Piece>,
    /// What holds before the first piece, over the distance from its beginning.
    pub(crate) before: Piece,
}

impl Track {
    /// Straight and level without end.
    pub fn straight() -> Self {
        Self { begins: vec![0.0], pieces: vec![Piece::default()], before: Piece::default() }
    }

    /// All that holds at `chainage`; `index` as for [`Self::locate`].
    #[inline]
    pub fn at(&self, chainage: f64, index: &mut usize) -> TrackPoint {
        let Location { piece, distance } = self.locate(chainage, index);
        piece.at(distance)
    }

    /// The location at `chainage`, m.
    ///
    /// `index` is any number at first and that of the last lookup later, so that a lookup near the
    /// last one costs little.
    #[inline]
    pub fn locate(&self, chainage: f64, index: &mut usize) -> Location<'_> {
        if chainage < self.begins[0] {
            return Location { piece: &self.before, distance: chainage - self.begins[0] };
        }
        *index = match self.begins.last() {
            Some(&last) if chainage >= last => self.begins.len() - 1,
            _ => interval(&self.begins, chainage, *index),
        };
        Location { piece: &self.pieces[*index], distance: chainage - self.begins[*index] }
    }

    /// The track by at most some `most` points, between which it is nearly linear: the ends of its pieces,
    /// with the values on both sides of a step.
    pub fn profile(&self, most: usize) -> Vec<(f64, TrackPoint)> {
        let every = (2 * self.pieces.len()).div_ceil(most.max(2)).max(1);
        let mut points = vec![(self.begins[0], self.before.at(0.0))];
        for (begins, piece) in self.begins.windows(2).zip(&self.pieces).step_by(every) {
            points.push((begins[0], piece.at(0.0)));
            points.push((begins[1], piece.at(begins[1] - begins[0])));
        }
        if let (Some(&begin), Some(piece)) = (self.begins.last(), self.pieces.last()) {
            points.push((begin, piece.at(0.0)));
        }
        points
    }
}

impl Piece {
    /// The piece with the values that it has at its beginning, as they hold backwards from there.
    pub(crate) fn as_at_its_beginning(&self) -> Self {
        let constant = |coefficients: [f64; 4]| [coefficients[0], 0.0, 0.0, 0.0];
        Self {
            curvature: constant(self.curvature),
            cant_angle: constant(self.cant_angle),
            gradient: constant(self.gradient),
            uniform: true,
            ..*self
        }
    }

    /// What holds `s` after the beginning of the piece: the integrals of cubic functions.
    #[inline]
    pub(crate) fn at(&self, s: f64) -> TrackPoint {
        let cubics = [&self.curvature, &self.cant_angle, &self.gradient];
        let [curvature, cant_angle, gradient] = match self.uniform {
            true => cubics.map(|cubic| Cubic::constant(cubic, s)),
            false => cubics.map(|cubic| Cubic::at(cubic, s)),
        };
        TrackPoint {
            curvature: curvature.value,
            curvature_slope: curvature.slope,
            heading: self.heading + curvature.integral,
            heading_integral: self.heading_integral + s * self.heading + curvature.double_integral,
            cant_angle: cant_angle.value,
            cant_angle_slope: cant_angle.slope,
            gradient: gradient.value,
            gradient_slope: gradient.slope,
            elevation: self.elevation + gradient.integral,
            elevation_integral: self.elevation_integral
                + s * self.elevation
                + gradient.double_integral,
        }
    }
}

/// A cubic at one argument, and its integrals from 0 to there.
struct Cubic {
    value: f64,
    slope: f64,
    integral: f64,
    double_integral: f64,
}

impl Cubic {
    /// The cubic with the coefficients `c` at `s`, of which only the first is not zero.
    #[inline]
    fn constant(c: &[f64; 4], s: f64) -> Self {
        let integral = s * c[0];
        Self { value: c[0], slope: 0.0, integral, double_integral: 0.5 * s * integral }
    }

    /// The cubic with the coefficients `c` at `s`.
    #[inline]
    fn at(c: &[f64; 4], s: f64) -> Self {
        let (half, sixth, twelfth, twentieth) = (0.5, 1.0 / 6.0, 1.0 / 12.0, 1.0 / 20.0);
        let twice =
            half * c[0] + s * (sixth * c[1] + s * (twelfth * c[2] + s * (twentieth * c[3])));
        Self {
            value: value(c, s),
            slope: c[1] + s * (2.0 * c[2] + s * 3.0 * c[3]),
            integral: integral(c, s),
            double_integral: s * s * twice,
        }
    }
}

/// Value of a cubic with the coefficients `c`.
#[inline]
fn value(c: &[f64; 4], s: f64) -> f64 {
    c[0] + s * (c[1] + s * (c[2] + s * c[3]))
}

/// Its integral from 0 to `s`.
#[inline]
fn integral(c: &[f64; 4], s: f64) -> f64 {
    s * (c[0] + s * (c[1] / 2.0 + s * (c[2] * (1.0 / 3.0) + s * c[3] / 4.0)))
}

#[cfg(test)]
mod tests {
    use super::*;

    const CUBIC: [f64; 4] = [2e-3, -3e-5, 4e-7, -5e-9];

    fn piece() -> Piece {
        Piece {
            heading: 0.3,
            heading_integral: 7.0,
            elevation: 5.0,
            elevation_integral: 11.0,
            curvature: CUBIC,
            cant_angle: [0.04, 1e-4, 0.0, 0.0],
            gradient: [-0.01, 2e-5, -3e-7, 4e-9],
            uniform: false,
        }
    }

    /// A track of one piece that begins at 100 m.
    fn track() -> Track {
        let before = piece().as_at_its_beginning();
        Track { begins: vec![100.0], pieces: vec![piece()], before }
    }

    /// ∫ f from 0 to s by three points of Gauss and Legendre, exact up to the fifth power.
    fn integral_by_gauss(f: impl Fn(f64) -> f64, s: f64) -> f64 {
        let outer = 0.6_f64.sqrt();
        let nodes = [(-outer, 5.0 / 18.0), (0.0, 8.0 / 18.0), (outer, 5.0 / 18.0)];
        nodes.iter().map(|(x, weight)| weight * s * f(s * (1.0 + x) / 2.0)).sum()
    }

    /// Heading and offset are ∫ κ dt and, by Cauchy's repeated integration, ∫ (s − t) κ dt.
    /// Elevation likewise of the gradient. Rounding.
    #[test]
    fn analytic_integrals_of_cubics() {
        for s in [1.0, 40.0, 90.0] {
            let point = piece().at(s);
            let curvature = |t: f64| value(&CUBIC, t);
            let gradient = |t: f64| value(&piece().gradient, t);
            let pairs = [
                (point.heading, 0.3 + integral_by_gauss(curvature, s)),
                (
                    point.heading_integral,
                    7.0 + 0.3 * s + integral_by_gauss(|t| (s - t) * curvature(t), s),
                ),
                (point.elevation, 5.0 + integral_by_gauss(gradient, s)),
                (
                    point.elevation_integral,
                    11.0 + 5.0 * s + integral_by_gauss(|t| (s - t) * gradient(t), s),
                ),
            ];
            for (found, expected) in pairs {
                assert!((found - expected).abs() < 1e-12 * expected.abs(), "{found}, {expected}");
            }
        }
    }

    /// Slopes against differences of the values over 2 mm, whose own error is below 1e-10.
    #[test]
    fn analytic_slopes_are_derivatives() {
        let (before, point, after) = (piece().at(49.999), piece().at(50.0), piece().at(50.001));
        let pairs = [
            (point.curvature_slope, after.curvature - before.curvature),
            (point.cant_angle_slope, after.cant_angle - before.cant_angle),
            (point.gradient_slope, after.gradient - before.gradient),
            (point.heading, after.heading_integral - before.heading_integral),
        ];
        for (slope, difference) in pairs {
            assert!((slope - difference / 2e-3).abs() < 1e-9, "{slope}");
        }
    }

    #[test]
    fn property_a_location_agrees_with_the_whole_point() {
        let track = track();
        for chainage in [-50.0, 100.0, 150.0, 199.0] {
            let point = track.at(chainage, &mut 0);
            let location = track.locate(chainage, &mut 0);
            let pairs = [
                (location.curvature(), point.curvature),
                (location.heading(), point.heading),
                (location.gradient(), point.gradient),
                (location.elevation(), point.elevation),
            ];
            for (found, expected) in pairs {
                assert!((found - expected).abs() < 1e-15, "{found}, {expected} at {chainage} m");
            }
        }
    }

    /// Before the first point the track is a circle on a straight slope with the values of there.
    #[test]
    fn analytic_before_its_beginning_a_track_keeps_its_first_values() {
        let point = track().at(60.0, &mut 0);
        assert_eq!((point.curvature, point.gradient, point.cant_angle), (2e-3, -0.01, 0.04));
        assert_eq!((point.curvature_slope, point.gradient_slope), (0.0, 0.0));
        assert!((point.heading - (0.3 - 40.0 * 2e-3)).abs() < 1e-15);
        assert!((point.elevation - (5.0 + 40.0 * 0.01)).abs() < 1e-15);
        let offset = 7.0 - 40.0 * 0.3 + 0.5 * 2e-3 * 40.0 * 40.0;
        assert!((point.heading_integral - offset).abs() < 1e-13);
    }

    /// A constant piece takes the short formulas, with the same values.
    #[test]
    fn analytic_a_constant_piece_is_a_cubic_without_slope() {
        let constant = piece().as_at_its_beginning();
        let general = Piece { uniform: false, ..constant };
        let (short, long) = (constant.at(37.0), general.at(37.0));
        assert_eq!((short.heading, short.elevation), (long.heading, long.elevation));
        assert!((short.heading_integral - long.heading_integral).abs() < 1e-14);
        assert!((short.elevation_integral - long.elevation_integral).abs() < 1e-13);
    }

    #[test]
    fn analytic_straight_track_is_zero_everywhere() {
        for chainage in [-1e6, 0.0, 1e6] {
            assert_eq!(Track::straight().at(chainage, &mut 7), TrackPoint::default());
        }
    }
}
