//! Friction between a rolling wheel and the rail.
//!
//! Axes: x along the track, y to the right, z down. Creepage is (wheel - rail)/speed. Along the track
//! the wheel counts by the speed of its rim, so that positive creepage is **traction** and the force on
//! the wheel is positive with it. Across and about the normal the wheel counts by its motion, so that
//! force and moment on it are opposed to creepage and spin. Forces on the rail are the opposite.
//!
//! | file | part |
//! |---|---|
//! | `law.rs` | the laws to choose from |
//! | `exact_rolling.rs`, `rolling_table.rs` | Kalker's exact theory by a table |
//! | `modified_fastsim.rs` | modified FASTSIM |
//! | `fastsim.rs` | simplified theory, dimensionless |
//! | `flexibility.rs` | reduction of the stiffness, and FASTSIM's flexibilities |
//! | `polach.rs` | Polach's closed formula |
//! | `linear.rs` | Kalker's linear theory, with Shen, Hedrick and Elkins' limit |
//! | `friction.rs`, `friction_by_temperature.rs` | friction that falls with slip or temperature |

pub(crate) mod exact_rolling;
mod fastsim;
pub(crate) mod flexibility;
pub(crate) mod friction;
pub(crate) mod friction_by_temperature;
pub(crate) mod law;
mod linear;
pub(crate) mod modified_fastsim;
pub(crate) mod polach;
pub(crate) mod rolling_table;
mod sliding;

/// Least reference speed in m/s that slip velocities are divided by.
///
/// Creepage loses its meaning at standstill. Below this speed the wheel creeps as if it rolled at it:
/// a stiff viscous force, still bounded by friction, that holds a standing wheel to about
/// 0.1 m/s times the creepage it needs.
pub const REFERENCE_SPEED_MIN: f64 = 0.1;

/// Slip of the wheel against the rail at the contact, in the contact's plane.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SlipVelocity {
    /// Speed of the wheel's rim less that of its axle, in m/s, positive where it drives along x.
    pub longitudinal: f64,
    /// Velocity of the wheel across, in m/s, positive to the right (along the contact plane).
    pub lateral: f64,
    /// Relative rotation about the contact normal in rad/s, positive about z down.
    pub spin: f64,
}

impl SlipVelocity {
    /// Creepages at a rolling `speed` in m/s, whose magnitude counts as [`REFERENCE_SPEED_MIN`] at
    /// least.
    pub fn creepages(&self, speed: f64) -> Creepages {
        let per_speed = 1.0 / reference_speed(speed);
        Creepages {
            longitudinal: self.longitudinal * per_speed,
            lateral: self.lateral * per_speed,
            spin: self.spin * per_speed,
        }
    }
}

/// Slip velocities divided by the speed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Creepages {
    /// Longitudinal, positive in traction.
    pub longitudinal: f64,
    /// Lateral, positive to the right.
    pub lateral: f64,
    /// Spin in 1/m, positive about z down.
    pub spin: f64,
}

/// A force in the contact plane, in N.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TangentialForce {
    /// Along the track, positive where it drives along x.
    pub longitudinal: f64,
    /// Across, positive to the right.
    pub lateral: f64,
}

/// Force over slip velocity, in N s/m, never negative: secants of the creep curve.
///
/// The curve is concave, so the secant is at least the tangent. An integrator that takes the secant
/// from the beginning of its step times the slip at the end is stable at any speed, also where
/// friction falls with slip.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CreepDamping {
    /// Of longitudinal slip.
    pub longitudinal: f64,
    /// Of lateral slip, without spin.
    pub lateral: f64,
}

/// What creep does to the wheel.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CreepForces {
    /// Force on the wheel: longitudinal `damping.longitudinal * slip.longitudinal`, lateral
    /// `spin_force - damping.lateral * slip.lateral`.
    pub force: TangentialForce,
    /// Moment on the wheel about the contact normal, in N m, positive about z down.
    pub spin_moment: f64,
    /// Power turned into heat, in W, never negative.
    pub friction_power: f64,
    /// How the force changes with the slip.
    pub damping: CreepDamping,
    /// The part of the lateral force that spin causes, in N; it needs no implicit treatment.
    pub spin_force: f64,
    /// Highest flash temperature by that of the same power spread over the contact as the pressure.
    pub flash_factor: f64,
}

impl CreepForces {
    /// Cut to the `limit` (N) of friction, which discretisation or interpolation may exceed by a trifle;
    /// `along` is the longitudinal slip, m/s.
    #[inline]
    pub(crate) fn within(self, limit: f64, along: f64) -> Self {
        let CreepDamping { longitudinal: damping, lateral: lateral_damping } = self.damping;
        let force = self.force.lateral;
        let square = damping * along * damping * along + force * force;
        let cut = if square > limit * limit { limit / square.sqrt() } else { 1.0 };
        Self {
            force: TangentialForce { longitudinal: cut * damping * along, lateral: cut * force },
            spin_moment: cut * self.spin_moment,
            friction_power: cut * self.friction_power,
            damping: CreepDamping { longitudinal: cut * damping, lateral: cut * lateral_damping },
            spin_force: cut * self.spin_force,
            flash_factor: self.flash_factor,
        }
    }
}

/// The magnitude of `speed`, at least [`REFERENCE_SPEED_MIN`].
pub(crate) fn reference_speed(speed: f64) -> f64 {
    speed.abs().max(REFERENCE_SPEED_MIN)
}
