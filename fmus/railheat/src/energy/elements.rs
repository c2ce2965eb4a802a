//! What each element of the rail has more than untouched rail.
//!
//! Elements that no wheel has touched have nothing more and cost nothing. The others have the
//! amplitudes of the section's even modes: what is read of them, on the middle line and in sums, has nothing of
//! the odd ones (`section/modes.rs`). Of these again only the slower ones are computed, those that have not
//! decayed since heat last came in: a minute after the last wheel some thirty. Arrays over all modes are read as far
//! as these go. Heat that comes in between two steps is gathered and spread
//! evenly over the step (second order in its length, and exact in its sum).

use serde::{Deserialize, Serialize};

use super::followers::Followers;
use super::ledger::Sources;
use crate::contact::Wheel;
use crate::section::{Crown, LANES, Modes, Propagator, Readings, add, dot};

/// What an element gets between two steps.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Deposit {
    /// Heat through contacts, J/m.
    pub contact: f64,
    /// The same weighted by its size: the weight of its position.
    pub weight: f64,
    /// Weight times lateral position, J.
    pub lateral: f64,
    /// Weight times half width, J.
    pub half_width: f64,
    /// Heat of bending, J/m.
    pub bending: f64,
    /// Time under a vehicle, s.
    pub covered: f64,
    /// Time in the shadow of a vehicle, s.
    pub shaded: f64,
}

/// The band of the head that a contact covers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Band {
    /// From the rail's middle to the field side, m.
    pub lateral: f64,
    /// Half its width, m.
    pub half_width: f64,
}

impl From<&Wheel> for Band {
    fn from(wheel: &Wheel) -> Self {
        Self { lateral: wheel.lateral_position, half_width: wheel.contact.b }
    }
}

/// Weather that touched elements feel more than untouched rail.
#[derive(Clone, Debug, PartialEq)]
pub struct Extra {
    /// Heat that the shade of a vehicle takes in the modes, J/m per second.
    pub shade: Vec<f64>,
    /// What the modes that follow make of it in the readings, K per second.
    pub shade_followed: Vec<f64>,
    /// Sum of it over the section, W/m.
    pub shade_heat: f64,
    /// Share of each mode in the mean rise of the exposed surface.
    pub mean: Vec<f64>,
    /// Conductance in all of the exposed surface that the modes do not have, W/(m·K).
    pub conductance: f64,
    /// The same by the wind of a train, for elements under it.
    pub train_wind: f64,
    /// Mean excess of untouched surface over the air, K.
    pub over_air: f64,
}

impl Extra {
    /// Nothing more than untouched rail feels, as in the weather of the start.
    ///
    /// `mean` is the share of each mode in the mean rise of the surface.
    pub fn none(mean: Vec<f64>, readings: usize) -> Self {
        Self {
            shade: vec![0.0; mean.len()],
            shade_followed: vec![0.0; readings],
            shade_heat: 0.0,
            conductance: 0.0,
            train_wind: 0.0,
            over_air: 0.0,
            mean,
        }
    }
}

/// The part of the constants that a step of the elements needs.
pub(crate) struct Section<'m> {
    pub modes: &'m Modes,
    pub followers: &'m Followers,
    pub crown: &'m Crown,
    pub bending: &'m [f64],
    pub propagator: &'m Propagator,
    pub extra: &'m Extra,
}

/// All elements.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Elements {
    width: usize,
    /// Element after element.
    amplitudes: Vec<f64>,
    /// Groups of [`LANES`] amplitudes of each element that have not decayed; the others are zero.
    alive: Vec<u16>,
    /// What the modes that follow add to each reading, K, element after element.
    followed: Vec<f64>,
    readings: usize,
    touched: Vec<bool>,
    deposits: Vec<Deposit>,
    /// Heat by source, J/m, beyond what untouched rail got.
    sources: Vec<Sources>,
}

impl Elements {
    /// So many elements with so many amplitudes and readings each.
    pub fn new(elements: usize, width: usize, readings: usize) -> Self {
        Self {
            width,
            followed: vec![0.0; elements * readings],
            readings,
            amplitudes: vec![0.0; elements * width],
            alive: vec![0; elements],
            touched: vec![false; elements],
            deposits: vec![Deposit::default(); elements],
            sources: vec![Sources::default(); elements],
        }
    }

    /// Number of elements.
    pub fn count(&self) -> usize {
        self.touched.len()
    }

    /// Whether something has touched an element.
    pub fn is_touched(&self, element: usize) -> bool {
        self.touched[element]
    }

    /// A contact leaves heat in an element of a length in m; `left` is in J.
    pub fn deposit(&mut self, element: usize, band: &Band, left: Sources, length: f64) {
        self.touched[element] = true;
        let deposit = &mut self.deposits[element];
        let contact = (left.friction + left.chill) / length;
        let weight = (left.friction.abs() + left.chill.abs()) / length;
        deposit.contact += contact;
        deposit.weight += weight;
        deposit.lateral += weight * band.lateral;
        deposit.half_width += weight * band.half_width;
        deposit.bending += left.bending / length;
        let sources = &mut self.sources[element];
        sources.friction += left.friction / length;
        sources.chill += left.chill / length;
        sources.bending += left.bending / length;
    }

    /// Takes what elements of the rail, from `first` on, are about to get; `is_right` says whether
    /// their contacts lie to the right where they say to the field side.
    pub(super) fn take_deposits(&mut self, rail: &Self, first: usize, is_right: bool) {
        let side = if is_right { 1.0 } else { -1.0 };
        for (element, (own, touched)) in self.deposits.iter_mut().zip(&mut self.touched).enumerate()
        {
            let deposit = rail.deposits[first + element];
            *own = Deposit { lateral: side * deposit.lateral, ..deposit };
            *touched |= rail.touched[first + element];
        }
    }

    /// An element lies under a vehicle, or several, for all of a time in s.
    pub fn cover(&mut self, element: usize, time: f64) {
        self.touched[element] = true;
        self.deposits[element].covered = time;
    }

    /// An element lies in the shadow of a vehicle, or several, for all of a time in s.
    pub fn shade(&mut self, element: usize, time: f64) {
        self.touched[element] = true;
        self.deposits[element].shaded = time;
    }

    /// Number of amplitudes of an element.
    pub(super) fn width(&self) -> usize {
        self.width
    }

    /// Heat comes to an element along the track.
    pub(super) fn touch(&mut self, element: usize) {
        self.touched[element] = true;
    }

    /// A group of an element's amplitudes.
    pub(super) fn row(&self, element: usize, group: usize) -> [f64; LANES] {
        let amplitudes = &self.amplitudes[element * self.width + group * LANES..][..LANES];
        std::array::from_fn(|lane| amplitudes[lane])
    }

    /// Changes a group of an element's amplitudes.
    pub(super) fn change_row(&mut self, element: usize, group: usize, by: &[f64; LANES]) {
        add(&mut self.amplitudes[element * self.width + group * LANES..][..LANES], 1.0, by);
        self.alive[element] = self.alive[element].max(group as u16 + 1);
    }

    /// The amplitudes of an element that have not decayed.
    pub fn amplitudes(&self, element: usize) -> &[f64] {
        &self.amplitudes[element * self.width..][..usize::from(self.alive[element]) * LANES]
    }

    /// What the modes that follow add to the readings of an element, K.
    pub fn followed(&self, element: usize) -> &[f64] {
        &self.followed[element * self.readings..][..self.readings]
    }

    /// What an element has more than untouched rail at a reading, counted through levels and rows, K.
    pub fn read(&self, element: usize, readings: &Readings, reading: usize) -> f64 {
        let shape = match reading.checked_sub(readings.levels.len()) {
            None => &readings.levels[reading],
            Some(row) => &readings.rows[row],
        };
        dot(shape, self.amplitudes(element)) + self.followed(element)[reading]
    }

    /// Heat by source of an element beyond untouched rail, J/m.
    pub fn sources(&self, element: usize) -> Sources {
        self.sources[element]
    }

    /// Heat in an element beyond untouched rail, J/m.
    pub fn heat(&self, element: usize, modes: &Modes) -> f64 {
        let deposit = &self.deposits[element];
        dot(&modes.content, self.amplitudes(element)) + deposit.contact + deposit.bending
    }

    /// One step of an element; `source` is scratch.
    pub(crate) fn step(&mut self, element: usize, section: &Section<'_>, source: &mut [f64]) {
        let Section { modes, propagator, .. } = section;
        let all = &mut self.amplitudes[element * self.width..][..self.width];
        let alive = &mut self.alive[element];
        let amplitudes = &mut all[..usize::from(*alive) * LANES];
        let deposit = std::mem::take(&mut self.deposits[element]);
        let mut lost = dot(&propagator.lost, amplitudes);
        let followed = &mut self.followed[element * self.readings..][..self.readings];
        let (heat, weather) = fill([source, followed], &deposit, section, amplitudes);
        propagator.decay(amplitudes);
        if heat.is_some() {
            lost += dot(&propagator.lost_at_once, source);
            propagator.add(all, source);
            *alive = (self.width / LANES) as u16;
        } else {
            let (groups, _) = amplitudes.as_chunks::<LANES>();
            let decayed = groups.iter().rev().take_while(|group| **group == [0.0; LANES]);
            *alive -= decayed.count() as u16;
        }
        // What the modes that follow hold is next to nothing, and the surroundings have it at once.
        let dropped = heat.map_or(0.0, |heat| heat - dot(&modes.content, source));
        self.sources[element].weather += weather - lost - dropped;
    }
}

/// Fills the sources of the modes over a step, and what the modes that follow add to the readings.
///
/// Gives the heat of all sources in J/m, if there is any, and that of the weather among it.
fn fill(
    [source, followed]: [&mut [f64]; 2],
    deposit: &Deposit,
    section: &Section<'_>,
    amplitudes: &[f64],
) -> (Option<f64>, f64) {
    let Section { extra, propagator, followers, .. } = section;
    followed.fill(0.0);
    if *deposit == Deposit::default() && extra.conductance == 0.0 {
        return (None, 0.0);
    }
    source.fill(0.0);
    let mut weather = 0.0;
    if deposit.weight > 0.0 {
        let lateral = deposit.lateral / deposit.weight;
        let half_width = deposit.half_width / deposit.weight;
        for (strip, share) in section.crown.shares(lateral, half_width) {
            add(source, share * deposit.contact, section.crown.shape(strip));
            followers.add_strip(followed, strip, share * deposit.contact);
        }
    }
    if deposit.bending != 0.0 {
        add(source, deposit.bending, section.bending);
        followers.add_bending(followed, deposit.bending);
    }
    if deposit.shaded > 0.0 && extra.shade_heat != 0.0 {
        add(source, -deposit.shaded, &extra.shade);
        add(followed, -deposit.shaded, &extra.shade_followed);
        weather -= deposit.shaded * extra.shade_heat;
    }
    let in_wind = deposit.covered * extra.train_wind;
    if extra.conductance != 0.0 || in_wind != 0.0 {
        let rise = dot(&extra.mean, amplitudes);
        let heat =
            -propagator.time() * extra.conductance * rise - in_wind * (rise + extra.over_air);
        add(source, heat, &extra.mean);
        followers.add_exposed(followed, heat);
        weather += heat;
    }
    (Some(deposit.contact + deposit.bending + weather), weather)
}
