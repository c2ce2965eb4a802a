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

/// A wheel in one position over its rail.
#[derive(Clone, Debug, Default)]
pub struct Wheel {
    patches: ArrayVec<Patch, PATCHES>,
    beyond: bool,
    /// Lateral coordinate on the rail head of the nearest contact, where none presses, m.
    nearest: f64,
}

impl Wheel {
    /// Finds the contacts of the wheel in this motion, and their forces.
    ///
    /// The wheel must be empty: it is filled, as copying one took a good part of a step.
    #[inline]
    pub fn touch(&mut self, table: &GeometryTable, motion: &WheelMotion, creep: &CreepLaw) {
        let position = motion.position();
        let row = table.row(position.shift);
        self.beyond = row.beyond();
        let mut highest = f64::NEG_INFINITY;
        for number in 0..table.patches() {
            let Some(mut contact) = table.patch(number, row, &position) else {
                continue;
            };
            let sunk = contact.sunk(&position);
            if sunk > 0.0 {
                let pressed = contact.pressed(&position);
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

    /// Lateral coordinate on the rail head of the nearest contact of a lifted wheel, m.
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
