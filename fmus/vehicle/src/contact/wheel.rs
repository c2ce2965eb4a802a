//! One wheel on its rail: the contacts in which it touches.

use arrayvec::ArrayVec;
use contact::{CreepLaw, GeometryTable};

use super::patch::Patch;
use super::wheel_motion::WheelMotion;

/// Most contacts of a wheel at the same time.
pub const PATCHES: usize = GeometryTable::MOST_PATCHES;

/// How a wheel stands on its rail.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Standing {
    /// It touches the rail within its profile.
    #[default]
    OnRail,
    /// It does not touch the rail.
    Lifted,
    /// It has left the profiles: climbed over the rail or fallen off it.
    Derailed,
}

/// A wheel at one place.
#[derive(Clone, Debug, Default)]
pub struct Wheel {
    patches: ArrayVec<Patch, PATCHES>,
    beyond: bool,
    /// Place on the rail head of the contact that is nearest, where none presses, m.
    nearest: f64,
}

impl Wheel {
    /// Finds the contacts of the wheel that moves like this on its rail, and their forces. (Into an
    /// empty wheel, as copying one took a good part of a step.)
    #[inline]
    pub fn touch(&mut self, table: &GeometryTable, motion: &WheelMotion, creep: &CreepLaw) {
        let place = motion.place();
        let row = table.row(place.shift);
        self.beyond = row.beyond();
        let mut highest = f64::NEG_INFINITY;
        for number in 0..table.patches() {
            let Some(mut contact) = table.patch(number, row, &place) else {
                continue;
            };
            let sunk = contact.sunk(&place);
            if sunk > 0.0 {
                let pressed = contact.pressed(&place);
                self.patches.push(Patch::new(number, &pressed, motion, creep));
            } else if sunk > highest {
                highest = sunk;
                self.nearest = contact.rail_lateral();
            }
        }
    }

    /// The contacts that press.
    #[inline]
    pub fn patches(&self) -> &[Patch] {
        &self.patches
    }

    /// The same, to be changed.
    #[inline]
    pub fn patches_mut(&mut self) -> &mut [Patch] {
        &mut self.patches
    }

    /// Place on the rail head of the nearest contact of a lifted wheel, m.
    pub fn nearest(&self) -> f64 {
        self.nearest
    }

    /// How the wheel stands.
    pub fn standing(&self) -> Standing {
        match (self.beyond, self.patches.is_empty()) {
            (true, _) => Standing::Derailed,
            (false, true) => Standing::Lifted,
            (false, false) => Standing::OnRail,
        }
    }
}
