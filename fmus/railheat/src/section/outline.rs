//! The outline of a rail's section as a closed polygon.

use std::f64::consts::PI;

/// Number of chords that stand for the arc of a fillet.
const CHORDS: usize = 8;

/// A point of the section.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Point {
    /// Lateral position, to the right of the rail's middle, m.
    pub y: f64,
    /// Depth below the crown, m.
    pub z: f64,
}

/// A corner of the right half of an outline, and the radius by which it is rounded, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner {
    /// Where the straight sides meet.
    pub point: Point,
    /// Radius of the fillet; zero for a sharp corner.
    pub radius: f64,
}

/// What an outline amounts to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Properties {
    /// Area, m².
    pub area: f64,
    /// Depth of the centroid below the crown, m.
    pub centroid: f64,
    /// Second moment of area about the horizontal axis through the centroid, m⁴.
    pub second_moment: f64,
    /// Length of the outline, m.
    pub perimeter: f64,
}

/// A closed polygon, clockwise when seen with y to the right and z downwards.
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    points: Vec<Point>,
}

impl Outline {
    /// The outline whose right half has these corners, from the crown to the middle of the foot.
    ///
    /// The left half mirrors it. The error is the index of the first corner whose radius does not
    /// fit between its neighbours.
    pub(crate) fn from_right_half(corners: &[Corner]) -> Result<Self, usize> {
        let mut points = vec![];
        for (index, corner) in corners.iter().enumerate() {
            let inner = index > 0 && index + 1 < corners.len();
            if inner && corner.radius > 0.0 {
                let (before, after) = (corners[index - 1].point, corners[index + 1].point);
                let arc = fillet(before, *corner, after).ok_or(index)?;
                points.extend(arc);
            } else {
                points.push(corner.point);
            }
        }
        let mirrored: Vec<Point> = points.iter().rev().map(|p| Point { y: -p.y, z: p.z }).collect();
        points.extend(mirrored);
        points.dedup();
        if points.first() == points.last() {
            points.pop();
        }
        Ok(Self { points })
    }

    /// The corners of the polygon.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// The sides of the polygon, from corner to corner.
    pub fn sides(&self) -> impl Iterator<Item = (Point, Point)> + '_ {
        sides(&self.points)
    }

    /// Depth of the lowest point, m: the height of the rail.
    pub fn height(&self) -> f64 {
        self.points.iter().map(|point| point.z).fold(0.0, f64::max)
    }

    /// Largest distance from the middle, m: half the width of the foot.
    pub fn half_width(&self) -> f64 {
        self.points.iter().map(|point| point.y).fold(0.0, f64::max)
    }

    /// Area, centroid, second moment, perimeter (Green's theorem, side by side).
    pub fn properties(&self) -> Properties {
        let (mut area, mut first, mut second, mut perimeter) = (0.0, 0.0, 0.0, 0.0);
        for (from, to) in self.sides() {
            let cross = from.y * to.z - to.y * from.z;
            area += cross / 2.0;
            first += cross * (from.z + to.z) / 6.0;
            second += cross * (from.z * from.z + from.z * to.z + to.z * to.z) / 12.0;
            perimeter += libm::hypot(to.y - from.y, to.z - from.z);
        }
        let centroid = first / area;
        let second_moment = second - area * centroid * centroid;
        Properties { area, centroid, second_moment, perimeter }
    }
}

/// The sides of a closed polygon.
pub(crate) fn sides(points: &[Point]) -> impl Iterator<Item = (Point, Point)> + '_ {
    points.iter().zip(points.iter().cycle().skip(1)).map(|(from, to)| (*from, *to))
}

/// Points on the arc that rounds a corner; none when it is longer than a side.
fn fillet(before: Point, corner: Corner, after: Point) -> Option<Vec<Point>> {
    let Corner { point, radius } = corner;
    let unit = |to: Point| {
        let length = libm::hypot(to.y - point.y, to.z - point.z);
        ((to.y - point.y) / length, (to.z - point.z) / length, length)
    };
    let (uy, uz, to_before) = unit(before);
    let (vy, vz, to_after) = unit(after);
    let half_angle = 0.5 * libm::acos((uy * vy + uz * vz).clamp(-1.0, 1.0));
    let tangent = radius / libm::tan(half_angle);
    if tangent > to_before.min(to_after) {
        return None;
    }
    let bisector = libm::hypot(uy + vy, uz + vz);
    let distance = radius / libm::sin(half_angle);
    let centre = Point {
        y: point.y + (uy + vy) / bisector * distance,
        z: point.z + (uz + vz) / bisector * distance,
    };
    let angle = |y: f64, z: f64| libm::atan2(z - centre.z, y - centre.y);
    let begin = angle(point.y + uy * tangent, point.z + uz * tangent);
    let end = angle(point.y + vy * tangent, point.z + vz * tangent);
    let turn = (end - begin + PI).rem_euclid(2.0 * PI) - PI;
    let on_arc = |chord: usize| {
        let at = begin + turn * chord as f64 / CHORDS as f64;
        Point { y: centre.y + radius * libm::cos(at), z: centre.z + radius * libm::sin(at) }
    };
    Some((0..=CHORDS).map(on_arc).collect())
}
