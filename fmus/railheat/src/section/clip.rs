//! What of a polygon lies in a rectangle (Sutherland and Hodgman, *Comm. ACM* 17 (1974) 32-42).

use super::outline::{Point, sides};

/// A rectangle of the grid, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Rectangle {
    /// Left and right end.
    pub y: [f64; 2],
    /// Upper and lower end.
    pub z: [f64; 2],
}

/// The part of a closed polygon inside the rectangle.
pub(crate) fn clip(polygon: &[Point], rectangle: &Rectangle) -> Vec<Point> {
    let Rectangle { y, z } = *rectangle;
    let right_of_left = cut(polygon, |p| p.y - y[0]);
    let between = cut(&right_of_left, |p| y[1] - p.y);
    let below_top = cut(&between, |p| p.z - z[0]);
    cut(&below_top, |p| z[1] - p.z)
}

/// Keeps the part where `inside` is not negative; it is linear in y and z.
fn cut(polygon: &[Point], inside: impl Fn(Point) -> f64) -> Vec<Point> {
    let mut kept = vec![];
    for (from, to) in sides(polygon) {
        let (a, b) = (inside(from), inside(to));
        if a >= 0.0 {
            kept.push(from);
        }
        if (a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0) {
            let share = a / (a - b);
            kept.push(Point {
                y: from.y + share * (to.y - from.y),
                z: from.z + share * (to.z - from.z),
            });
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_a_triangle_is_cut_by_a_square() {
        let triangle = [(0.0, 0.0), (2.0, 0.0), (0.0, 2.0)].map(|(y, z)| Point { y, z });
        let square = Rectangle { y: [0.0, 1.5], z: [0.0, 1.0] };
        let kept = clip(&triangle, &square);
        let area: f64 = sides(&kept).map(|(a, b)| (a.y * b.z - b.y * a.z) / 2.0).sum();
        // The square of 1.5 x 1 less the triangle of 0.5 x 0.5 beyond the slanted side.
        assert!((area - 1.375).abs() < 1e-15, "{area}");
    }
}
