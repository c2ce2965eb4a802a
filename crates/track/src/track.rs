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
}

/// A piece of track in which curvature, cant and gradient are linear in the chainage;
/// all values hold at its beginning.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Piece {
    pub at: TrackPoint,
}

/// Curvature, cant and gradient as functions of the chainage, in closed form piece by piece.
///
/// Before the first piece and after the last one the track goes on with the outermost values.
#[derive(Clone, Debug)]
pub struct Track {
    /// Chainage at which each piece begins, m, rising.
    pub(crate) begins: Vec<f64>,
    pub(crate) pieces: Vec<Piece>,
}

impl Track {
    /// Straight and level without end.
    pub fn straight() -> Self {
        let piece = Piece { at: TrackPoint::default() };
        Self { begins: vec![0.0], pieces: vec![piece] }
    }

    /// What holds at `chainage`; `index` is any number at first and the place of the last lookup
    /// later, so that a lookup near the last one costs little.
    pub fn at(&self, chainage: f64, index: &mut usize) -> TrackPoint {
        if chainage < self.begins[0] {
            return self.before_the_first(chainage);
        }
        *index = match self.begins.last() {
            Some(&last) if chainage >= last => self.begins.len() - 1,
            _ => interval(&self.begins, chainage, *index),
        };
        self.pieces[*index].at(chainage - self.begins[*index])
    }

    /// Extends the values at the beginning of the track backwards.
    fn before_the_first(&self, chainage: f64) -> TrackPoint {
        let at = TrackPoint {
            curvature_slope: 0.0,
            cant_angle_slope: 0.0,
            gradient_slope: 0.0,
            ..self.pieces[0].at
        };
        Piece { at }.at(chainage - self.begins[0])
    }

    /// Chainages at which curves begin and end, transitions included, m. A curve that goes on
    /// without end is left out.
    pub fn curves(&self) -> Vec<[f64; 2]> {
        let curved = |piece: &Piece| piece.at.curvature != 0.0 || piece.at.curvature_slope != 0.0;
        let mut curves: Vec<[f64; 2]> = vec![];
        for (ends, piece) in self.begins.windows(2).zip(&self.pieces) {
            match curves.last_mut() {
                _ if !curved(piece) => {}
                Some(curve) if curve[1] == ends[0] => curve[1] = ends[1],
                _ => curves.push([ends[0], ends[1]]),
            }
        }
        curves
    }
}

impl Piece {
    /// What holds `distance` after the beginning of the piece: the integrals of linear functions.
    pub(crate) fn at(&self, distance: f64) -> TrackPoint {
        let Piece { at } = *self;
        let s = distance;
        TrackPoint {
            curvature: at.curvature + at.curvature_slope * s,
            heading: at.heading + s * (at.curvature + at.curvature_slope * s / 2.0),
            heading_integral: at.heading_integral
                + s * (at.heading + s * (at.curvature / 2.0 + at.curvature_slope * s / 6.0)),
            cant_angle: at.cant_angle + at.cant_angle_slope * s,
            gradient: at.gradient + at.gradient_slope * s,
            elevation: at.elevation + s * (at.gradient + at.gradient_slope * s / 2.0),
            ..at
        }
    }
}
