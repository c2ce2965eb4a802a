//! One wheel on its rail: the contacts in which it touches.

use contact::{GeometryTable, Polach};

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
#[derive(Clone, Copy, Debug)]
pub struct Wheel {
    patches: [Patch; PATCHES],
    count: usize,
    beyond: bool,
}

impl Wheel {
    /// The wheel on `side` of a wheelset at `state`, without its forces.
    #[inline]
    pub fn new(side: Side, data: &WheelData, table: &GeometryTable, state: &BodyState) -> Self {
        // Eq. 16: shift towards the flange.
        let shift = side.sign() * (state.position.y - data.radius * state.rotation.x);
        let yaw_squared = state.rotation.z * state.rotation.z;
        let mut wheel = Self { patches: Default::default(), count: 0, beyond: false };
        let mut nearest: Option<Patch> = None;
        for number in 0..table.patches() {
            let Some(point) = table.patch(number, shift, yaw_squared) else {
                continue;
            };
            let patch = Patch::new(number, point, side, data, state);
            wheel.beyond |= point.beyond;
            if patch.elastic_force > 0.0 {
                wheel.patches[wheel.count] = patch;
                wheel.count += 1;
            } else if nearest.is_none_or(|nearest| patch.approach > nearest.approach) {
                nearest = Some(patch);
            }
        }
        if let (0, Some(nearest)) = (wheel.count, nearest) {
            wheel.patches[0] = nearest;
        }
        wheel
    }

    /// Finds the forces of all contacts with the wheelset's velocities against the track's frame;
    /// `speed` is that of travel.
    #[inline]
    pub fn load(&mut self, data: &WheelData, creep: &Polach, velocities: &Six, speed: f64) {
        for patch in &mut self.patches[..self.count] {
            patch.load(data.damping, creep, velocities, speed);
        }
    }

    /// The contacts that press.
    #[inline]
    pub fn patches(&self) -> &[Patch] {
        &self.patches[..self.count]
    }

    /// A contact that presses, or the nearest one of a lifted wheel.
    pub fn nearest(&self) -> &Patch {
        &self.patches[0]
    }

    /// How the wheel stands.
    pub fn standing(&self) -> Standing {
        match (self.beyond, self.count) {
            (true, _) => Standing::Derailed,
            (false, 0) => Standing::Lifted,
            (false, _) => Standing::OnRail,
        }
    }
}
