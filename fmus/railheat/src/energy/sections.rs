//! The rise of the whole section: at some places, and where the foot is warmest.
//!
//! An element has the modes that its middle line and its heat need: the even ones that do not follow.
//! At the places that are asked for all modes are kept, even and odd, fast and slow. They get what the
//! element gets, with the contact on its own side, and decay as exactly. Where heat flows along the
//! track, the elements within [`REACH`] are kept too, so that it flows in all modes. Nothing of this
//! changes what the elements do. Validated by `property_a_section_…` and `analytic_a_section_…`.
//!
//! Where the foot will be warmest nobody knows beforehand. There the section is that of the even modes that every
//! element has, so the mean of left and right; the weather's part, which untouched rail has too, is whole. What
//! is missing evens out across the rail: of a contact 12 mm aside it is half of the highest rise at once and
//! 2e-7 of it after ten minutes, before the foot is warmest. Validated by `property_the_warmest_section_…`.

use super::along::Along;
use super::elements::{Elements, Section};
use super::followers::Followers;
use super::kept_elements::{KeptElement, Sections};
use super::model::EnergyModel;
use super::parameters::Resolution;
use crate::heat_model::KeptSections;
use crate::section::{add, dot};

/// Length of track on either side of a place from which heat may flow to it, m: in an hour heat goes
/// 0.4 m (twice the root of diffusivity times time).
const REACH: f64 = 1.0;

impl EnergyModel {
    /// Keeps the rise of the whole section at some elements from now on, where the section is a plane.
    ///
    /// Without any element there is still the section where the foot is warmest.
    /// Wheels say how far to the field side they touch the rail; on the right rail that is to the right.
    pub fn keep_sections(&mut self, elements: &[usize], field_side_is_right: bool) {
        if self.parameters.resolution != Resolution::Plane {
            return;
        }
        let line = &self.parameters.line;
        let reach = match self.along {
            Some(_) => (REACH / line.element_length).ceil() as usize,
            None => 0,
        };
        let shapes = [&self.bending, &self.zones[0].extra.mean].map(Vec::as_slice);
        let none = self.modes.even_width();
        let followers = Followers::new(&self.modes, none, &self.readings, &self.crown, shapes);
        let width = self.modes.width();
        let kept = |&element: &usize| {
            let first = element.saturating_sub(reach);
            let count = (element + reach + 1).min(line.elements) - first;
            let elements = Elements::new(count, width, followers.count());
            KeptElement { first, middle: element - first, elements }
        };
        self.state.kept_elements = elements.iter().map(kept).collect();
        self.sections = Some(Sections {
            along: self.along.as_ref().map(|_| Along::new(2 * reach + 1)),
            source: vec![0.0; width],
            field_side_is_right,
            followers,
        });
    }

    /// One step of all places with what their elements are about to get.
    pub(super) fn step_sections(&mut self, time: f64) {
        let Some(sections) = &mut self.sections else { return };
        let line = &self.parameters.line;
        let number = self.parameters.material.diffusivity() * time
            / (line.element_length * line.element_length);
        for KeptElement { first, elements, .. } in &mut self.state.kept_elements {
            elements.take_deposits(&self.state.elements, *first, sections.field_side_is_right);
            let mut conduct = |elements: &mut Elements| {
                if let Some(along) = &mut sections.along {
                    along.conduct(elements, &self.modes, 0.5 * number);
                }
            };
            conduct(elements);
            for element in 0..elements.count() {
                if elements.is_touched(element) {
                    let section = Section {
                        modes: &self.modes,
                        followers: &sections.followers,
                        crown: &self.crown,
                        bending: &self.bending,
                        propagator: &self.propagator,
                        extra: &self.zones[usize::from(self.zone_of[*first + element])].extra,
                    };
                    elements.step(element, &section, &mut sections.source);
                }
            }
            conduct(elements);
        }
    }

    /// The section and where its rise is kept, if it is a plane and was asked for.
    pub(super) fn kept_sections(&self) -> Option<KeptSections<'_>> {
        let sections = self.sections.as_ref()?;
        let line = &self.parameters.line;
        let chainage = |kept: &KeptElement| line.chainage(kept.first + kept.middle);
        Some(KeptSections {
            chainages: self.state.kept_elements.iter().map(chainage).collect(),
            cells: &self.cells.cells,
            cell_width: self.parameters.cell_size,
            field_side_is_right: sections.field_side_is_right,
        })
    }

    /// The rise of each cell at each place over the initial state, K; the cells of the first place first.
    pub fn section_rises(&self) -> Vec<f64> {
        let of_element = |kept: &KeptElement| {
            let zone = usize::from(self.zone_of[kept.first + kept.middle]);
            let mut all = self.state.untouched[zone].amplitudes.clone();
            // The place has no more amplitudes than those that have not decayed.
            add(&mut all, 1.0, kept.elements.amplitudes(kept.middle));
            (0..self.modes.cells()).map(move |cell| dot(self.modes.at(cell), &all))
        };
        self.state.kept_elements.iter().flat_map(of_element).collect()
    }

    /// Chainage of the element whose foot is warmest over untouched rail, and the rise of each cell there.
    ///
    /// The rise is over the initial state, K, and the mean of left and right. Before any heat it is the first element.
    pub fn warmest_section(&self) -> (f64, Vec<f64>) {
        let line = &self.parameters.line;
        let element = line.nearest(self.state.answer.present.chainage);
        let zone = usize::from(self.zone_of[element]);
        let mut all = self.state.untouched[zone].amplitudes.clone();
        // Behind the even modes stand odd ones as padding, whose contact may lie on the other side.
        let own = self.state.elements.amplitudes(element).iter().take(self.modes.even);
        all.iter_mut().zip(own).for_each(|(all, own)| *all += own);
        let rise = |cell| dot(self.modes.at(cell), &all);
        (line.chainage(element), (0..self.modes.cells()).map(rise).collect())
    }
}
