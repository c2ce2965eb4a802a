//! From the track file to the compiled track.

use files::{Check, Mistake};
use numerics::{Interpolation, Piecewise};

use crate::content::{Content, Element};
use crate::track::{Piece, Track, TrackPoint};

/// Distance between the middles of the two rail heads over which cant is measured, m.
const CANT_BASE: f64 = 1.5;

/// Points of a function of the chainage: chainages, m, and values.
type Points = (Vec<f64>, Vec<f64>);

impl Content {
    pub(crate) fn compile(&self, check: &Check) -> Result<Track, Mistake> {
        let function = |key: &'static str, (chainages, values): Points, between: Interpolation| {
            if let [first, second, ..] = chainages[..]
                && first == second
            {
                let wanted = "a step needs a point before it, from which its first value holds";
                return Err(check.error(&format!("{key}[2].chainage_m"), second, wanted));
            }
            Piecewise::new(chainages, &values, between)
                .map_err(|error| check.refuse(key, error.to_string()))
        };
        let (curvature, cant) = self.curvature_and_cant();
        let between = self.curvature_interpolation.into();
        let curvature = function("curvature", curvature, between)?;
        let cant = function("curvature", cant, between)?;
        let between = self.gradient_interpolation.into();
        let gradient = function("gradient", self.gradient(), between)?;

        let mut begins = [curvature.x(), cant.x(), gradient.x()].concat();
        begins.sort_by(f64::total_cmp);
        begins.dedup();
        let mut pieces: Vec<Piece> = Vec::with_capacity(begins.len());
        for (i, &begin) in begins.iter().enumerate() {
            let before = match i {
                0 => TrackPoint::default(),
                _ => pieces[i - 1].at(begin - begins[i - 1]),
            };
            let functions = [&curvature, &cant, &gradient];
            let [curvature, cant_angle, gradient] = functions.map(|f| f.expansion(begin, &mut 0));
            let uniform = [curvature, cant_angle, gradient].iter().all(|c| c[1..] == [0.0; 3]);
            pieces.push(Piece {
                heading: before.heading,
                heading_integral: before.heading_integral,
                elevation: before.elevation,
                elevation_integral: before.elevation_integral,
                curvature,
                cant_angle,
                gradient,
                uniform,
            });
        }
        let before = pieces[0].as_at_its_beginning();
        Ok(Track { begins, pieces, before })
    }

    fn gradient(&self) -> Points {
        match self.gradient.len() {
            0 => (vec![self.start_m], vec![0.0]),
            _ => self.gradient.iter().map(|p| (p.chainage_m, p.permille * 1e-3)).unzip(),
        }
    }

    fn curvature_and_cant(&self) -> (Points, Points) {
        let angle = |cant_mm: f64| (cant_mm * 1e-3 / CANT_BASE).asin();
        if self.curvature.is_empty() {
            let curvature = |element: &Element| element.radius_m.map_or(0.0, |radius| 1.0 / radius);
            return (self.elements(curvature), self.elements(|e| angle(e.cant_mm)));
        }
        let points = self.curvature.iter();
        (
            points.clone().map(|p| (p.chainage_m, p.per_km * 1e-3)).unzip(),
            points.map(|p| (p.chainage_m, angle(p.cant_mm))).unzip(),
        )
    }

    /// The ends of the elements with the value there: constant in an element, linear in a
    /// transition, a step where two constant elements of different value meet.
    fn elements(&self, value: impl Fn(&Element) -> f64) -> Points {
        let constant = |i: Option<usize>| {
            let element = i.and_then(|i| self.alignment.get(i)).filter(|e| !e.transition);
            element.map_or(0.0, &value)
        };
        let (mut chainages, mut values) = (vec![self.start_m], vec![0.0]);
        for (i, element) in self.alignment.iter().enumerate() {
            let (from, to) = match element.transition {
                true => (constant(i.checked_sub(1)), constant(Some(i + 1))),
                false => (constant(Some(i)), constant(Some(i))),
            };
            let begin = chainages[chainages.len() - 1];
            if i == 0 {
                values[0] = from;
            } else if values[values.len() - 1] != from {
                chainages.push(begin);
                values.push(from);
            }
            chainages.push(begin + element.length_m);
            values.push(to);
        }
        (chainages, values)
    }
}
