//! One wheel on its rail: the contacts in which it touches.

use arrayvec::ArrayVec;
use contact::{CreepLaw, GeometryTable};

use crate::body::BodyState;
use crate::patch::Patch;
use crate::six::Six;

/// Most contacts of a wheel at the same time.
pub const PATCHES: usize = GeometryTable::MOST_PATCHES;

/// Rail on which a wheel runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Left rail.
    Left,
    /// Right rail.
    Right,
}

impl Side {
    /// -1 on the left, +1 on the right.
    pub fn sign(self) -> f64 {
        match self {
            Self::Left => -1.0,
            Self::Right => 1.0,
        }
    }
}

/// Dimensions of a wheel.
#[derive(Clone, Copy, Debug)]
pub struct WheelData {
    /// Radius of the running circle, m.
    pub radius: f64,
    /// Distance of the running circle from the track's middle, m.
    pub half_distance: f64,
    /// Damping force over normal force for a speed of approach, s/m.
    pub damping: f64,
}

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
    /// The wheel on `side` of a wheelset at `state`, without its forces.
    #[inline]
    pub fn new(side: Side, data: &WheelData, table: &GeometryTable, state: &BodyState) -> Self {
        // Eq. 16: shift towards the flange.
        let shift = side.sign() * (state.position.y - data.radius * state.rotation.x);
        let yaw_squared = state.rotation.z * state.rotation.z;
        let mut wheel = Self::default();
        let mut least_gap = f64::INFINITY;
        for number in 0..table.patches() {
            let Some(point) = table.patch(number, shift, yaw_squared) else {
                continue;
            };
            let patch = Patch::new(number, point, side, data, state);
            wheel.beyond |= point.beyond;
            if patch.elastic_force > 0.0 {
                wheel.patches.push(patch);
            } else if -patch.approach < least_gap {
                least_gap = -patch.approach;
                wheel.nearest = patch.rail_lateral();
            }
        }
        wheel
    }

    /// Finds the forces of all contacts with the wheelset's velocities against the track's frame;
    /// `speed` is that of travel.
    #[inline]
    pub fn load(&mut self, data: &WheelData, creep: &CreepLaw, velocities: &Six, speed: f64) {
        for patch in &mut self.patches {
            patch.load(data.damping, creep, velocities, speed);
        }
    }

    /// The contacts that press.
    #[inline]
    pub fn patches(&self) -> &[Patch] {
        &self.patches
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
