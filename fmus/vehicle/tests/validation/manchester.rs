//! Manchester contact benchmark A-2.2 (Shackleton and Iwnicki 2006) with the wheels of the vehicle:
//! creepages of CONTACT (2025-07-23), from reference 2.3.
//!
//! A wheelset of S1002 on UIC60 at 1:40 is held at a displacement and a yaw of 2.4 mrad for each mm and
//! pulled along at 2 m/s. Its height and roll are those at which each wheel has 10 kN vertically, its
//! rotation is the one at which the creep forces have no moment about the axle. CONTACT's creepages are
//! rail minus wheel: the sign changes here.

use contact::{
    CreepLaw, FallingFriction, GeometryTable, ModifiedFastsim, ProfilePair, RailProfile, Reduction,
    WheelProfile,
};
use std::sync::Arc;
use vehicle::body::BodyState;
use vehicle::patch::{Patch, WheelMotion};
use vehicle::six::Six;
use vehicle::wheel::{Side, Wheel, WheelData};

const SPEED: f64 = 2.0;
const WHEEL_LOAD: f64 = 10e3;

/// Halvings in each of the three nested searches.
const HALVINGS: usize = 44;

/// Displacement in mm, roll in mrad, rotation in rad/s; xi, eta, and phi in 1/m, of both wheels.
type Row = (f64, f64, f64, [f64; 3], [f64; 3]);

const CONTACT: [Row; 6] = [
    (1.0, -0.05049, 4.3465752, [-6.297e-4, 0.0024, -0.03848], [6.943e-4, 0.002407, 0.151]),
    (2.0, -0.1128, 4.3459197, [-8.651e-4, 0.004798, -0.02947], [8.752e-4, 0.004818, 0.1746]),
    (3.0, -0.1803, 4.3451503, [-0.001103, 0.007197, -0.02432], [0.001052, 0.007235, 0.1998]),
    (4.0, -0.2557, 4.344093, [-0.001399, 0.009594, -0.02138], [0.001276, 0.009662, 0.233]),
    (5.0, -0.3554, 4.3353637, [-0.003462, 0.01198, -0.0199], [0.004174, 0.01255, 0.6188]),
    (6.0, -0.6272, 4.3293718, [-0.004901, 0.01437, -0.01957], [0.005077, 0.0158, 0.8744]),
];

/// The wheelset of the benchmark.
struct Wheelset {
    data: WheelData,
    table: Arc<GeometryTable>,
    creep: CreepLaw,
}

/// Where it stands and how fast it turns.
#[derive(Clone, Copy)]
struct Placement {
    state: BodyState,
    rotation: f64,
}

impl Wheelset {
    fn new() -> Self {
        let wheel = WheelProfile::named("S1002").unwrap();
        let rail = RailProfile::named("UIC60-manchester").unwrap();
        let pair = ProfilePair::standard_gauge(wheel, rail, 1.0 / 40.0, 0.460);
        let friction = FallingFriction::constant(0.3);
        Self {
            data: WheelData { radius: 0.460, half_distance: pair.running_circle(), damping: 0.0 },
            table: GeometryTable::shared(&pair).unwrap(),
            creep: CreepLaw::Fastsim(ModifiedFastsim::by_table(Reduction::NONE, friction)),
        }
    }

    /// Left and right wheel with their forces.
    fn wheels(&self, placement: &Placement) -> [Wheel; 2] {
        [Side::Left, Side::Right].map(|side| {
            let motion = WheelMotion {
                side,
                data: &self.data,
                state: &placement.state,
                velocities: &velocities(placement),
                speed: SPEED,
                turning: 0.0,
            };
            let mut wheel = Wheel::default();
            wheel.touch(&self.table, &motion, &self.creep);
            wheel
        })
    }

    /// Vertical force of both rails, N.
    fn vertical(&self, placement: &Placement) -> [f64; 2] {
        self.wheels(placement).map(|wheel| {
            let upwards =
                |patch: &Patch| patch.rows.upwards(patch.forces.creep.lateral, patch.forces.normal);
            wheel.patches().iter().map(upwards).sum()
        })
    }

    /// Moment of the contact forces about the axle, N m.
    fn axle_moment(&self, placement: &Placement) -> f64 {
        let mut forces = Six::default();
        for patch in self.wheels(placement).iter().flat_map(Wheel::patches) {
            patch.rows.add(&patch.forces, 0.0, &mut Default::default(), &mut forces);
        }
        forces[4]
    }

    /// In balance at a displacement `y` and `yaw`.
    fn balanced(&self, y: f64, yaw: f64) -> Placement {
        let mut placement = Placement { state: BodyState::default(), rotation: 0.0 };
        placement.state.position.y = y;
        placement.state.rotation.z = yaw;
        placement.rotation = root(0.95 * SPEED / 0.46, 1.02 * SPEED / 0.46, |rotation| {
            let turning = Placement { rotation, ..placement };
            self.axle_moment(&self.standing(turning))
        });
        self.standing(placement)
    }

    /// With the height and roll at which each wheel has its load.
    fn standing(&self, placement: Placement) -> Placement {
        let at_height = |mut placement: Placement, roll: f64| {
            placement.state.rotation.x = roll;
            placement.state.position.z = root(-0.02, 0.02, |z| {
                placement.state.position.z = z;
                let [left, right] = self.vertical(&placement);
                left + right - 2.0 * WHEEL_LOAD
            });
            placement
        };
        let roll = root(-0.02, 0.02, |roll| {
            let [left, right] = self.vertical(&at_height(placement, roll));
            right - left
        });
        at_height(placement, roll)
    }
}

/// Velocities of a wheelset that is held askew.
fn velocities(placement: &Placement) -> Six {
    [SPEED, 0.0, 0.0, 0.0, -placement.rotation, 0.0]
}

/// Where a rising function is zero.
fn root(mut low: f64, mut high: f64, mut rising: impl FnMut(f64) -> f64) -> f64 {
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if rising(middle) < 0.0 { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// Creepages of the patch that bears most, as CONTACT has them: rail minus wheel, along the track and
/// across it. Those of the wheel are along the yawed wheel; in the plane of a contact with the angle
/// delta the directions differ by the yaw times cos delta.
fn creepages(wheel: &Wheel, placement: &Placement) -> [f64; 3] {
    let heavier = |a: &&Patch, b: &&Patch| a.forces.normal.total_cmp(&b.forces.normal);
    let patch = wheel.patches().iter().max_by(heavier).unwrap();
    let velocities = velocities(placement);
    let slip = patch.rows.motion(&velocities).slip;
    let [xi, eta, phi] = [slip.longitudinal, slip.lateral, slip.spin].map(|slip| -slip / SPEED);
    let (sine, cosine) = (placement.state.rotation.z * patch.angle().cos()).sin_cos();
    [xi * cosine - eta * sine, xi * sine + eta * cosine, phi]
}

/// Tolerances. Roll 0.003 mrad. Rotation 5e-5 of itself to 4 mm, 2e-4 beyond. Longitudinal creepage 2e-5
/// to 4 mm, 1.5e-4 beyond: 0.01 mm of rolling radius, which 0.1 mm of contact position makes on the tread
/// and 0.03 mm in the flange root. Lateral creepage 0.5 %. Spin 0.0015/m and 1 %: 0.7 mrad of contact
/// angle. Left out are the case without displacement, where CONTACT has a patch of two lobes, and the
/// right wheel at 5 mm, where it has two patches and prints means.
#[test]
fn benchmark_manchester_creepages() {
    let wheelset = Wheelset::new();
    for (y, roll, rotation, left, right) in &CONTACT {
        let placement = wheelset.balanced(1e-3 * y, 2.4e-3 * y);
        let small = *y <= 4.0;
        let case = |what: &str| format!("{what} at {y} mm");
        near(&case("roll in mrad"), 1e3 * placement.state.rotation.x, *roll, 0.003);
        let share = if small { 5e-5 } else { 2e-4 };
        near(&case("rotation in rad/s"), placement.rotation, *rotation, share * rotation);
        let wheels = wheelset.wheels(&placement);
        for ((side, expected), wheel) in [("left", left), ("right", right)].iter().zip(&wheels) {
            if (*side, *y) == ("right", 5.0) {
                continue;
            }
            let [xi, eta, phi] = creepages(wheel, &placement);
            let case = |what: &str| format!("{what} of the {side} wheel at {y} mm");
            near(&case("xi"), xi, expected[0], if small { 2e-5 } else { 1.5e-4 });
            near(&case("eta"), eta, expected[1], 5e-3 * expected[1]);
            near(&case("phi in 1/m"), phi, expected[2], 0.0015 + 0.01 * expected[2].abs());
        }
    }
}

/// Fails with the case's name unless `value` is `expected` within `tolerance`.
fn near(case: &str, value: f64, expected: f64, tolerance: f64) {
    let error = (value - expected).abs();
    assert!(error <= tolerance, "{case}: {value} instead of {expected}, more than {tolerance} off");
}
