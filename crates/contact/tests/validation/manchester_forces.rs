//! Manchester contact benchmark A-2.2 (Shackleton and Iwnicki 2006): creep forces and friction power of
//! CONTACT (2025-07-23) for lateral, longitudinal and spin creep together. S1002 on UIC60 at 1:40, 2 m/s,
//! friction 0.3, yaw 2.4 mrad for each mm of displacement. All in its case A-2.2 (docs/reference/contact.md).
//!
//! The contact ellipses are those of `wheelset_geometry`; normal forces and creepages are CONTACT's, so
//! that the creep law alone is compared. CONTACT's creepages are rail minus wheel and its forces act on
//! the rail: both change sign here.

use crate::{near, pair};
use contact::kalker::CreepCoefficients;
use contact::{
    ContactPatch, CreepForces, CreepLaw, ExactRolling, FallingFriction, ModifiedFastsim, Polach,
    Reduction, STEEL, SlipVelocity, WheelContact, wheelset_geometry,
};

const MM: f64 = 1e-3;
const SPEED: f64 = 2.0;
const FRICTION: f64 = 0.3;

/// What CONTACT prints for a wheel: displacement in mm; xi, eta, and phi in 1/m; normal, longitudinal and
/// lateral force in N; friction power in W.
type Row = [f64; 8];

const LEFT: [Row; 11] = [
    [0.0, -5.665e-5, 0.0, -0.06302, 9997.0, 0.2783, 253.6, 0.4677],
    [1.0, -6.297e-4, 0.0024, -0.03848, 10050.0, 829.2, -2893.0, 14.45],
    [2.0, -8.651e-4, 0.004798, -0.02947, 10040.0, 546.3, -2961.0, 28.86],
    [3.0, -0.001103, 0.007197, -0.02432, 10030.0, 460.5, -2974.0, 43.31],
    [4.0, -0.001399, 0.009594, -0.02138, 10030.0, 436.6, -2977.0, 57.81],
    [5.0, -0.003462, 0.01198, -0.0199, 10030.0, 837.8, -2889.0, 74.4],
    [6.0, -0.004901, 0.01437, -0.01957, 10020.0, 973.1, -2845.0, 90.59],
    [7.0, -0.02035, 0.01663, -0.02761, 10010.0, 2327.0, -1900.0, 155.8],
    [8.0, -0.02281, 0.01899, -0.03511, 10020.0, 2310.0, -1921.0, 175.9],
    [9.0, -0.02425, 0.02135, -0.0421, 10020.0, 2257.0, -1985.0, 191.4],
    [10.0, -0.02532, 0.02371, -0.04883, 10020.0, 2196.0, -2054.0, 205.6],
];

const RIGHT: [Row; 11] = [
    [0.0, -5.665e-5, 0.0, 0.06302, 9997.0, 0.2783, -253.6, 0.4677],
    [1.0, 6.943e-4, 0.002407, 0.151, 9827.0, -814.3, -2832.0, 14.41],
    [2.0, 8.752e-4, 0.004818, 0.1746, 9799.0, -517.3, -2893.0, 28.39],
    [3.0, 0.001052, 0.007235, 0.1998, 9774.0, -417.5, -2902.0, 42.48],
    [4.0, 0.001276, 0.009662, 0.233, 9745.0, -379.6, -2898.0, 56.61],
    [5.0, 0.004174, 0.01255, 0.6188, 9619.0, -763.3, -2738.0, 75.99],
    [6.0, 0.005077, 0.0158, 0.8744, 9709.0, -880.0, -2775.0, 96.52],
    [7.0, 0.01949, 0.03457, 1.838, 14030.0, -2079.0, -3644.0, 338.8],
    [8.0, 0.02127, 0.033, 1.701, 12720.0, -2070.0, -3195.0, 304.0],
    [9.0, 0.02266, 0.03341, 1.588, 11970.0, -2014.0, -2963.0, 293.9],
    [10.0, 0.02378, 0.03445, 1.486, 11440.0, -1947.0, -2820.0, 291.3],
];

/// A wheel of the benchmark.
struct Case {
    name: String,
    /// Displacement of the wheelset, mm.
    displacement: f64,
    right: bool,
    patch: ContactPatch,
    slip: SlipVelocity,
    /// Longitudinal and lateral force on the wheel, N.
    force: [f64; 2],
    /// Friction power, W.
    power: f64,
}

/// All wheels but those without displacement, where CONTACT finds a patch of two lobes.
fn cases() -> Vec<Case> {
    let pair = pair("S1002", "UIC60-manchester");
    let mut cases = Vec::new();
    for (left, right) in LEFT.iter().zip(&RIGHT).skip(1) {
        let displacement = left[0];
        let geometry = wheelset_geometry(&pair, displacement * MM, 2.4 * displacement * MM);
        let geometry = geometry.unwrap();
        cases.push(Case::new(left, &geometry.left[0], false));
        cases.push(Case::new(right, &geometry.right[0], true));
    }
    cases
}

impl Case {
    fn new(row: &Row, contact: &WheelContact, right: bool) -> Self {
        let [displacement, xi, eta, phi, load, fx, fy, power] = *row;
        // CONTACT's creepages are rail less wheel, of which the longitudinal one is positive in traction.
        let (longitudinal, lateral, spin) = (SPEED * xi, -SPEED * eta, -SPEED * phi);
        let side = if right { "right" } else { "left" };
        Self {
            name: format!("{side} wheel at {displacement} mm"),
            displacement,
            right,
            patch: patch(contact, load),
            slip: SlipVelocity { longitudinal, lateral, spin },
            force: [-fx, -fy],
            power,
        }
    }

    /// Compares a law's answer: forces within a share of mu N, power within a share of itself.
    fn check(&self, law: &str, found: &CreepForces, forces: [f64; 2], power: f64) {
        self.check_force(law, found, forces);
        let case = format!("power in W {law}, {}", self.name);
        near(&case, found.friction_power, self.power, power * self.power);
    }

    fn check_force(&self, law: &str, found: &CreepForces, [fx, fy]: [f64; 2]) {
        let case = |what: &str| format!("{what} {law}, {}", self.name);
        let limit = FRICTION * self.patch.normal_force;
        near(&case("Fx in N"), found.force.longitudinal, self.force[0], fx * limit);
        near(&case("Fy in N"), found.force.lateral, self.force[1], fy * limit);
    }

    /// Force times slip of what CONTACT prints, with a law's moment, W.
    fn power_by_force(&self, found: &CreepForces) -> f64 {
        self.force[0] * self.slip.longitudinal
            - self.force[1] * self.slip.lateral
            - found.spin_moment * self.slip.spin
    }
}

/// The ellipse of a contact under `load` (N).
fn patch(contact: &WheelContact, load: f64) -> ContactPatch {
    let a = contact.hertz.semi_axis_rolling * load.cbrt();
    let b = contact.hertz.semi_axis_lateral * load.cbrt();
    let kalker = CreepCoefficients::new(a / b, STEEL.poisson_ratio);
    ContactPatch { normal_force: load, a, b, kalker }
}

/// Exact rolling by table, and FASTSIM, on treads and flanges, up to a spin of 1.8/m and full sliding.
///
/// Tolerance 1 % of mu N in each force and 2 % in power, which simplified theory and the ellipse in
/// place of CONTACT's true patch need about alike. Wider: 2 % and 3 % at 1 mm, where creepages are
/// small and the force still rises with them; 5 % in the longitudinal force of the right wheel at 5 mm,
/// where CONTACT has two patches and the rows only their sum.
///
/// The exact law's power is compared with CONTACT's force times slip: its printed power lacks half a watt in
/// every row, which its grid loses (3.3 % at 1 mm).
#[test]
fn benchmark_manchester_forces() {
    let friction = FallingFriction::constant(FRICTION);
    let laws = [
        ("exactly", CreepLaw::ExactRolling(ExactRolling::new(Reduction::NONE, friction))),
        (
            "by FASTSIM",
            CreepLaw::Fastsim(ModifiedFastsim::on_line(Reduction::NONE, friction, 20, 100)),
        ),
    ];
    for case in cases() {
        let (forces, power) = match (case.displacement, case.right) {
            (1.0, _) => ([0.02, 0.02], 0.03),
            (5.0, true) => ([0.05, 0.01], 0.02),
            _ => ([0.01, 0.01], 0.02),
        };
        for (name, law) in &laws {
            let found = law.force(&case.patch, &case.slip, SPEED);
            if let CreepLaw::ExactRolling(_) = law {
                case.check_force(name, &found, forces);
                let expected = case.power_by_force(&found);
                let name = format!("power in W {name}, {}", case.name);
                near(&name, found.friction_power, expected, power * expected);
            } else {
                case.check(name, &found, forces, power);
            }
        }
    }
}

/// Polach on treads up to 4 mm, but for the right wheel at 1 mm (spin 0.15 per m at small creep). There
/// and on the flange his law takes off 18 to 25 % of the power.
///
/// Tolerance: 8 % of mu N in each force and 12 % in power. Polach is within 6 % of CONTACT for pure
/// longitudinal creep (`polach.rs`); his treatment of spin adds as much: found -1 to +1 % in power on the
/// left wheels and -7 to -11 % on the right ones, whose spin is five times larger.
#[test]
fn benchmark_manchester_forces_by_polach() {
    let friction = FallingFriction::constant(FRICTION);
    let law = Polach { adhesion_factor: 1.0, slip_factor: 1.0, friction: friction.into() };
    let treads = cases().into_iter().filter(|case| match case.right {
        true => (2.0..=4.0).contains(&case.displacement),
        false => case.displacement <= 4.0,
    });
    for case in treads {
        case.check("by Polach", &law.force(&case.patch, &case.slip, SPEED), [0.08, 0.08], 0.12);
    }
}
