//! Which pieces of the outline are the running surface: they are found by position and never none.
//!
//! A piece counts by its middle. Where the outline is drawn so coarsely that no middle lies in the
//! region asked for, the pieces that reach nearest to the middle of the crown stand for it.

use super::cells::Facet;
use super::outline::Point;

/// Depth to which the head's surface counts as running surface, m: to the gauge point.
const RUNNING_DEPTH: f64 = 0.016;

/// Half width of the band on the crown over which the surface is read, m.
const BAND: f64 = 0.015;

/// Slack in comparing distances, m.
const SAME_DISTANCE: f64 = 1e-9;

/// The middle of the crown.
const CROWN: Point = Point { y: 0.0, z: 0.0 };

/// The pieces that wheels may run on, in the order of the outline.
pub fn running_surface(facets: &[Facet]) -> Vec<&Facet> {
    by_middle_or_nearest(facets, |middle| middle.z < RUNNING_DEPTH)
}

/// The pieces of the running surface over which its temperature is read.
pub fn crown_band(facets: &[Facet]) -> Vec<&Facet> {
    by_middle_or_nearest(facets, |middle| middle.z < RUNNING_DEPTH && middle.y.abs() < BAND)
}

/// The index of the piece at the middle of the crown.
pub fn crown_piece(facets: &[Facet]) -> usize {
    let distance = |index: &usize| facets[*index].distance(CROWN);
    let nearest = (0..facets.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)));
    nearest.expect("a section has a surface")
}

/// The upward pieces whose middle lies inside, or else those nearest to the middle of the crown.
fn by_middle_or_nearest(facets: &[Facet], inside: impl Fn(Point) -> bool) -> Vec<&Facet> {
    let upwards: Vec<&Facet> = facets.iter().filter(|facet| facet.normal.z < 0.0).collect();
    let inside: Vec<&Facet> =
        upwards.iter().copied().filter(|facet| inside(facet.middle())).collect();
    if !inside.is_empty() {
        return inside;
    }
    let distance = |facet: &&Facet| facet.distance(CROWN);
    let nearest = upwards.iter().map(distance).fold(f64::INFINITY, f64::min);
    upwards.into_iter().filter(|facet| distance(facet) <= nearest + SAME_DISTANCE).collect()
}

impl Facet {
    /// Distance of a point from the nearest point of the piece, m.
    fn distance(&self, point: Point) -> f64 {
        let [a, b] = self.ends;
        let (dy, dz) = (b.y - a.y, b.z - a.z);
        let along = ((point.y - a.y) * dy + (point.z - a.z) * dz) / (self.length * self.length);
        let along = along.clamp(0.0, 1.0);
        libm::hypot(a.y + along * dy - point.y, a.z + along * dz - point.z)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::section::{Cells, Outline, RailFile};

    /// A head whose right half is one straight side from the crown to a corner, mm, on a web and a foot.
    fn outline(corner: [f64; 2]) -> Outline {
        let [half_width, height] = corner;
        let text = format!(
            "name = \"drawn\"\nsource = \"test\"\nheight_mm = 172.0\narea_mm2 = {}\n\
             centroid_above_foot_mm = 80.0\nsecond_moment_mm4 = 3e7\ncorners_mm = [[0, 172, 0], \
             [{half_width}, {height}, 0], [{half_width}, 130, 0], [8, 130, 0], [8, 20, 0], \
             [75, 20, 0], [75, 0, 0], [0, 0, 0]]",
            half_width * (172.0 - height)
                + 2.0 * half_width * (height - 130.0)
                + 16.0 * 110.0
                + 3000.0
        );
        RailFile::from_toml(&text, "drawn").unwrap().outline()
    }

    /// A crown of one straight piece on each side is the running surface, wherever its middle lies.
    #[test]
    fn property_the_running_surface_is_never_empty() {
        for corner in [[36.0, 170.0], [60.0, 172.0], [36.0, 135.0]] {
            let outline = outline(corner);
            for cells in [
                Cells::column(&outline, 0.0025),
                Cells::grid(&outline, 0.0025),
                Cells::column(&outline, 0.08),
            ] {
                for pieces in [running_surface(&cells.facets), crown_band(&cells.facets)] {
                    let width: f64 =
                        pieces.iter().map(|piece| piece.length * -piece.normal.z).sum();
                    assert!(width > 0.0, "{corner:?}");
                    let left: f64 = pieces.iter().map(|piece| piece.middle().y).sum();
                    assert!(left.abs() < 1e-12, "{corner:?}: as much on the left as on the right");
                }
                let [a, b] = cells.facets[crown_piece(&cells.facets)].ends;
                assert!(a.y.abs().min(b.y.abs()) < 1e-12, "{corner:?}");
            }
        }
    }

    #[test]
    fn analytic_distance_of_a_point_from_a_piece() {
        let ends = [Point { y: 3.0, z: 4.0 }, Point { y: 6.0, z: 4.0 }];
        let piece = Facet { cell: 0, ends, length: 3.0, normal: Point { y: 0.0, z: -1.0 } };
        assert_eq!(piece.distance(CROWN), 5.0, "beyond the end");
        assert_eq!(piece.distance(Point { y: 5.0, z: 0.0 }), 4.0, "beside it");
    }
}
