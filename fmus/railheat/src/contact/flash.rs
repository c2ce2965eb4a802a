//! Temperature rise of the rail's surface under a passing wheel.
//!
//! The rail is a half-space that a band of heat crosses fast; [`contact::flash`] has the equation
//! (`docs/theory/railheat/paper.md#eq-4`). The paper takes its surface temperature from Spiryagin et
//! al. (2016), whose equations it does not print; any version of them has to reduce to this one.
//! Validated by `analytic_flash_temperature_…`.

use super::creep_force::{Contact, creep_force};
use super::material::Material;

pub use contact::flash::HERTZ_PEAK;

/// Mean over the contact ellipse of the rise by a semi-ellipsoid of flux, over its highest.
pub const MEAN_OVER_PEAK: f64 = 0.676_506_3 / HERTZ_PEAK;

/// Highest temperature rise of the rail's surface under a wheel, K.
///
/// The friction power is `force · creepage · speed`, of which the share `partition` flows into the
/// rail.
pub fn flash_rise(
    contact: &Contact,
    force: f64,
    creepage: f64,
    speed: f64,
    partition: f64,
    material: &Material,
) -> f64 {
    let energy_per_metre = partition * force * creepage.abs();
    contact::flash::flash_rise(
        energy_per_metre,
        contact.a,
        contact.b,
        speed,
        material.penetration(),
    )
}

/// How a wheel heats the rail, as far as the paper's model sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Friction {
    /// Friction coefficient μ of wheel on rail.
    pub coefficient: f64,
    /// Share ε of the friction heat that flows into the rail; one half for equal steels.
    pub partition: f64,
}

impl Friction {
    /// Table 4 of the paper, and equal steels.
    pub const PAPER: Self = Self { coefficient: 0.47, partition: 0.5 };

    /// Temperature rise of the surface by a wheel's longitudinal creepage, K.
    ///
    /// Lateral creepage and spin add nothing, as in the paper; nor does a wheel without normal force.
    pub fn rise(&self, contact: &Contact, creepage: f64, speed: f64, material: &Material) -> f64 {
        if contact.normal_force <= 0.0 {
            return 0.0;
        }
        let force = creep_force(contact, creepage, self.coefficient);
        flash_rise(contact, force, creepage, speed, self.partition, material)
    }
}
