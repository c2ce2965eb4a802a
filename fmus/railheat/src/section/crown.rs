//! Where on the head a contact's heat goes.
//!
//! The heat of a contact of half width b at the lateral position y spreads over the running surface
//! as full slip in a Hertz contact does. Summed along the rail, the semi-ellipsoid of the flux is a
//! parabola, 1-(s/b)², whose share left of s is (`docs/theory/railheat/energy.md#eq-17`)
//!
//! ```text
//! F(s) = 1/2 + 3/4 (s/b) - 1/4 (s/b)³
//! ```
//!
//! A band that would reach beyond the running surface is moved inwards, so that no heat is lost.

use super::cells::Cells;
use super::modes::Modes;
use super::running_surface::running_surface;

/// The running surface: strips from left to right, a cell behind each.
#[derive(Clone, Debug, PartialEq)]
pub struct Crown {
    /// Ends of the strips, m; one more than strips.
    ends: Vec<f64>,
    /// Strip after strip the modes of its cell.
    shapes: Vec<f64>,
    width: usize,
}

impl Crown {
    /// The running surface of a section.
    pub fn new(cells: &Cells, modes: &Modes) -> Self {
        let mut facets = running_surface(&cells.facets);
        facets.sort_by(|a, b| a.middle().y.total_cmp(&b.middle().y));
        let mut crown = Self { ends: vec![], shapes: vec![], width: modes.width() };
        let mut last = usize::MAX;
        for facet in facets {
            let [a, b] = facet.ends.map(|end| end.y);
            if facet.cell == last {
                crown.ends.pop();
            } else {
                if crown.ends.is_empty() {
                    crown.ends.push(a.min(b));
                }
                crown.shapes.extend_from_slice(modes.at(facet.cell));
                last = facet.cell;
            }
            crown.ends.push(a.max(b));
        }
        crown
    }

    /// Number of strips.
    pub fn strips(&self) -> usize {
        self.ends.len() - 1
    }

    /// The modes of a strip's cell.
    pub fn shape(&self, strip: usize) -> &[f64] {
        &self.shapes[strip * self.width..][..self.width]
    }

    /// The strips that a band covers, with their share of its heat; lateral position and half width in m.
    pub fn shares(&self, lateral: f64, half_width: f64) -> impl Iterator<Item = (usize, f64)> + '_ {
        let (left, right) = (self.ends[0], self.ends[self.ends.len() - 1]);
        let half_width = half_width.min(0.5 * (right - left));
        let middle = lateral.clamp(left + half_width, right - half_width);
        let part = move |end: f64| {
            let s = ((end - middle) / half_width).clamp(-1.0, 1.0);
            0.75 * s - 0.25 * s * s * s
        };
        let last = self.strips() - 1;
        (0..=last).filter_map(move |strip| {
            // The outermost strips reach as far as the band does.
            let from = if strip == 0 { -0.5 } else { part(self.ends[strip]) };
            let to = if strip == last { 0.5 } else { part(self.ends[strip + 1]) };
            (to > from).then_some((strip, to - from))
        })
    }
}
