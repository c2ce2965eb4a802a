//! A rail head made of circular arcs or of points, upright or inclined.

use super::point::ProfilePoint;
use super::points::PointProfile;

/// One arc of a symmetric head, given from the middle outwards.
#[derive(Clone, Copy, Debug)]
pub(crate) struct HalfArc {
    /// Radius in m.
    radius: f64,
    /// Distance from the middle at which the arc ends, in m.
    half_width: f64,
    /// Sine of the arc's inclination at its beginning; tangent to the arc before if not given.
    begin_sine: Option<f64>,
}

impl HalfArc {
    /// An arc that goes on along the tangent of the one before.
    pub(super) const fn tangent(radius: f64, half_width: f64) -> Self {
        Self { radius, half_width, begin_sine: None }
    }

    /// An arc that begins at another inclination than the one before has ended with.
    pub(super) const fn cornered(radius: f64, half_width: f64, begin_sine: f64) -> Self {
        Self { radius, half_width, begin_sine: Some(begin_sine) }
    }
}

/// An arc of the head's outline, convex upwards.
#[derive(Clone, Copy, Debug)]
struct Arc {
    /// Lateral coordinate and height of the centre in m.
    centre: (f64, f64),
    radius: f64,
    /// Lateral coordinate and height at which the arc begins (towards the gauge side) and ends.
    begin: (f64, f64),
    end: (f64, f64),
}

/// The outline of a rail head; its highest point is the origin.
///
/// The gauge side is negative, the field side positive.
#[derive(Clone, Debug)]
pub(crate) enum RailHead {
    /// Circular arcs.
    Arcs(Arcs),
    /// Points.
    Points(PointProfile),
}

/// The outline as arcs.
#[derive(Clone, Debug)]
pub(crate) struct Arcs {
    arcs: Vec<Arc>,
}

impl RailHead {
    /// An upright head of arcs, symmetric about its middle.
    pub(super) fn symmetric(half_arcs: &[HalfArc]) -> Self {
        Self::Arcs(Arcs::symmetric(half_arcs))
    }

    /// An upright head of points.
    pub(super) fn of_points(points: &PointProfile) -> Self {
        Self::Points(points.inclined(0.0))
    }

    /// The head leaning towards the track's middle by `inclination` (such as 1/40), moved so that
    /// its highest point is the origin again.
    pub(crate) fn inclined(&self, inclination: f64) -> Self {
        match self {
            Self::Arcs(arcs) => Self::Arcs(arcs.inclined(inclination)),
            Self::Points(points) => Self::Points(points.inclined(inclination)),
        }
    }

    /// The outline at `lateral` metres from the highest point; outside the head its end.
    pub(crate) fn at(&self, lateral: f64) -> ProfilePoint {
        match self {
            Self::Arcs(arcs) => arcs.at(lateral),
            Self::Points(points) => points.at(lateral),
        }
    }

    /// Lateral coordinates of the gauge side's and the field side's end, in m.
    pub(crate) fn range(&self) -> (f64, f64) {
        match self {
            Self::Arcs(arcs) => arcs.range(),
            Self::Points(points) => points.range(),
        }
    }

    /// Lateral coordinate of the gauge face `depth` metres below the top.
    pub(crate) fn gauge_face(&self, depth: f64) -> f64 {
        match self {
            Self::Arcs(arcs) => arcs.gauge_face(depth),
            Self::Points(points) => points.gauge_face(depth),
        }
    }
}

impl Arcs {
    /// An upright head, symmetric about its middle.
    fn symmetric(half_arcs: &[HalfArc]) -> Self {
        let mut field = Vec::with_capacity(half_arcs.len());
        let mut begin = (0.0, 0.0);
        let mut sine = 0.0_f64;
        for half in half_arcs {
            sine = half.begin_sine.unwrap_or(sine);
            let cosine = (1.0 - sine * sine).sqrt();
            let centre = (begin.0 - half.radius * sine, begin.1 + half.radius * cosine);
            sine = (half.half_width - centre.0) / half.radius;
            let rise = half.radius * (1.0 - sine * sine).sqrt();
            let end = (half.half_width, centre.1 - rise);
            field.push(Arc { centre, radius: half.radius, begin, end });
            begin = end;
        }
        let gauge = field.iter().rev().map(|arc| Arc {
            centre: mirrored(arc.centre),
            radius: arc.radius,
            begin: mirrored(arc.end),
            end: mirrored(arc.begin),
        });
        Self { arcs: gauge.chain(field.iter().copied()).collect() }
    }

    /// The head leaning towards the track's middle by `inclination` (such as 1/40), moved so that
    /// its highest point is the origin again.
    fn inclined(&self, inclination: f64) -> Self {
        let angle = libm::atan(inclination);
        let turn = |(y, z): (f64, f64)| {
            let (sine, cosine) = libm::sincos(angle);
            (y * cosine + z * sine, z * cosine - y * sine)
        };
        let turned: Vec<Arc> = self
            .arcs
            .iter()
            .map(|arc| Arc {
                centre: turn(arc.centre),
                radius: arc.radius,
                begin: turn(arc.begin),
                end: turn(arc.end),
            })
            .collect();
        let top = turned
            .iter()
            .find(|arc| arc.begin.0 <= arc.centre.0 && arc.centre.0 <= arc.end.0)
            .map_or((0.0, 0.0), |arc| (arc.centre.0, arc.centre.1 - arc.radius));
        let moved = |(y, z): (f64, f64)| (y - top.0, z - top.1);
        let arcs = turned.iter().map(|arc| Arc {
            centre: moved(arc.centre),
            radius: arc.radius,
            begin: moved(arc.begin),
            end: moved(arc.end),
        });
        Self { arcs: arcs.collect() }
    }

    /// The outline at `lateral` metres from the highest point; outside the head its end.
    fn at(&self, lateral: f64) -> ProfilePoint {
        let (first, last) = self.range();
        let y = lateral.clamp(first, last);
        let arc = self.arcs.iter().find(|arc| y <= arc.end.0);
        let arc = arc.unwrap_or(&self.arcs[self.arcs.len() - 1]);
        let x = y - arc.centre.0;
        let root = (arc.radius * arc.radius - x * x).max(0.0).sqrt();
        ProfilePoint { height: arc.centre.1 - root, slope: x / root }
    }

    /// Lateral coordinates of the gauge side's and the field side's end, in m.
    fn range(&self) -> (f64, f64) {
        (self.arcs[0].begin.0, self.arcs[self.arcs.len() - 1].end.0)
    }

    /// Lateral coordinate of the gauge face `depth` metres below the top. Below the last arc the face
    /// goes on along its tangent.
    fn gauge_face(&self, depth: f64) -> f64 {
        let first = &self.arcs[0];
        if depth > first.begin.1 {
            let steepness =
                (first.centre.0 - first.begin.0) / (first.begin.1 - first.centre.1).abs();
            return first.begin.0 - (depth - first.begin.1) / steepness;
        }
        let arc = self.arcs.iter().find(|arc| depth >= arc.end.1).unwrap_or(first);
        let height = arc.centre.1 - depth;
        arc.centre.0 - (arc.radius * arc.radius - height * height).max(0.0).sqrt()
    }
}

/// The same point on the other side of the middle.
fn mirrored((y, z): (f64, f64)) -> (f64, f64) {
    (-y, z)
}
