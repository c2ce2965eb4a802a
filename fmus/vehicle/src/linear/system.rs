//! The linear system M d²q/dt² + C dq/dt + K q + Σ b f = 0.
//!
//! A damper c with the stiffness k in series has the force f with df/dt = k (bᵀ dq/dt - f/c).

use nalgebra::{DMatrix, DVector, Matrix3x6, Vector3};

use crate::body::RigidBody;
use crate::structure::Structure;
use crate::suspension::Suspension;
use crate::suspension::pair::Point;

/// Coordinates of a body: x, y, z, roll, pitch, yaw.
pub(super) const COORDINATES: usize = 6;

/// What dry friction does in small motions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Surfaces {
    /// They slide as if there were no friction.
    Slide,
    /// They stick and are elastic.
    Stick,
}

/// A vehicle linearised at rest.
#[derive(Clone, Debug)]
pub struct System {
    /// Masses and moments of inertia on the diagonal of the mass matrix.
    pub inertia: DVector<f64>,
    /// Stiffness matrix, N/m, N, N m.
    pub stiffness: DMatrix<f64>,
    /// Damping matrix, N s/m, N s, N m s.
    pub damping: DMatrix<f64>,
    /// Dampers with stiffness in series.
    pub(super) series: Vec<Series>,
}

/// A damper c with the stiffness k in series.
#[derive(Clone, Debug)]
pub(super) struct Series {
    /// Derivative of its length by the coordinates.
    pub row: DVector<f64>,
    pub damping: f64,
    pub stiffness: f64,
}

/// The two bodies that an element joins, and the arms from their centres of mass to its ends.
struct Ends {
    bodies: [usize; 2],
    arms: [Vector3<f64>; 2],
}

impl Ends {
    /// Both ends at one point.
    fn new(suspension: &Suspension, at: &Point) -> Self {
        let pair = &suspension.pairs[at.pair];
        Self { bodies: pair.bodies, arms: [at.arm, at.arm + pair.offset] }
    }

    /// The second end by `line` from the first one.
    fn with_line(mut self, line: &Vector3<f64>) -> Self {
        self.arms[1] += line;
        self
    }
}

/// Derivative of a point's displacement by its body's displacement and rotation.
fn jacobian(arm: &Vector3<f64>) -> Matrix3x6<f64> {
    let mut jacobian = Matrix3x6::identity();
    let turn = -arm.cross_matrix();
    jacobian.fixed_view_mut::<3, 3>(0, 3).copy_from(&turn);
    jacobian
}

impl System {
    /// All bodies on the suspension, wheelsets included; nothing holds these.
    pub fn new(structure: &Structure, surfaces: Surfaces) -> Self {
        let mut system = Self::of_load_bearing_elements(structure);
        system.add_dampers(structure);
        system.add_preloaded_elements(structure);
        if surfaces == Surfaces::Stick {
            system.add_grips(structure);
        }
        system
    }

    /// The elements that share the weight as their stiffness says.
    pub(crate) fn of_load_bearing_elements(structure: &Structure) -> Self {
        let size = COORDINATES * structure.bodies.len();
        let of = |body: &RigidBody| {
            let m = body.mass;
            [m, m, m, body.inertia.x, body.inertia.y, body.inertia.z]
        };
        let inertia: Vec<f64> = structure.bodies.iter().flat_map(of).collect();
        let mut system = Self {
            inertia: DVector::from_vec(inertia),
            stiffness: DMatrix::zeros(size, size),
            damping: DMatrix::zeros(size, size),
            series: vec![],
        };
        system.add_springs(structure);
        system
    }

    /// The system with the wheelsets held: their coordinates, the last ones, are left out.
    #[must_use]
    pub fn with_wheelsets_held(mut self, structure: &Structure) -> Self {
        let free = structure.bodies.iter().filter(|body| !body.turns).count();
        let size = COORDINATES * free;
        self.inertia = self.inertia.rows(0, size).into_owned();
        self.stiffness = self.stiffness.view((0, 0), (size, size)).into_owned();
        self.damping = self.damping.view((0, 0), (size, size)).into_owned();
        for series in &mut self.series {
            series.row = series.row.rows(0, size).into_owned();
        }
        self
    }

    /// The system without dampers and damping.
    #[must_use]
    pub fn without_damping(mut self) -> Self {
        self.damping.fill(0.0);
        self.series.clear();
        self
    }

    fn add_springs(&mut self, structure: &Structure) {
        let suspension = &structure.suspension;
        for spring in &suspension.springs {
            self.add(suspension, &spring.at, &spring.stiffness, &spring.damping);
        }
        for spring in &suspension.rotational_springs {
            self.add_rotation(
                &suspension.pairs[spring.pair].bodies,
                &spring.stiffness,
                &spring.damping,
            );
        }
        for rod in &suspension.rods {
            let ends = Ends::new(suspension, &rod.at).with_line(&rod.line);
            let row = self.row(&ends, &rod.line.normalize());
            self.stiffness += rod.stiffness * &row * row.transpose();
            self.damping += rod.damping * &row * row.transpose();
        }
        for plate in &suspension.centre_plates {
            self.add(suspension, &plate.at, &plate.stiffness, &plate.damping);
            // Four springs on the rim: a quarter of the stiffness each, two at R from either axis.
            let square = 0.5 * plate.radius * plate.radius;
            let tilting = |constant: f64| Vector3::new(square * constant, square * constant, 0.0);
            let (stiffness, damping) = (tilting(plate.stiffness.z), tilting(plate.damping.z));
            self.add_rotation(&suspension.pairs[plate.at.pair].bodies, &stiffness, &damping);
        }
    }

    fn add_dampers(&mut self, structure: &Structure) {
        let suspension = &structure.suspension;
        for damper in &suspension.dampers {
            let axis = Vector3::ith(damper.axis, 1.0);
            match damper.series_stiffness.is_finite() {
                true => self.series.push(Series {
                    row: self.row(&Ends::new(suspension, &damper.at), &axis),
                    damping: damper.damping,
                    stiffness: damper.series_stiffness,
                }),
                false => {
                    self.add(suspension, &damper.at, &Vector3::zeros(), &(damper.damping * axis))
                }
            }
        }
    }

    /// Elements whose force at rest is given.
    fn add_preloaded_elements(&mut self, structure: &Structure) {
        let (suspension, zero) = (&structure.suspension, Vector3::zeros());
        for spring in &suspension.tabulated_springs {
            let axis = Vector3::ith(spring.axis, 1.0);
            let stiffness = spring.static_stiffness() * axis;
            self.add(suspension, &spring.at, &stiffness, &(spring.damping * axis));
        }
        for wedge in &suspension.wedges {
            self.add(suspension, &wedge.at, &Vector3::new(0.0, 0.0, wedge.spring_stiffness), &zero);
        }
        for bearer in &suspension.side_bearers {
            self.add(suspension, &bearer.at, &Vector3::new(0.0, 0.0, bearer.stiffness), &zero);
        }
    }

    /// Dry friction that does not slide.
    fn add_grips(&mut self, structure: &Structure) {
        let (suspension, zero) = (&structure.suspension, Vector3::zeros());
        for friction in &suspension.frictions {
            let stiffness = friction.grip.stiffness * Vector3::ith(friction.axis, 1.0);
            self.add(suspension, &friction.at, &stiffness, &zero);
        }
        for wedge in &suspension.wedges {
            let k = wedge.grip.stiffness;
            self.add(suspension, &wedge.at, &Vector3::new(0.0, k, k), &zero);
        }
        for plate in &suspension.centre_plates {
            let stiffness = Vector3::new(0.0, 0.0, plate.grip.stiffness);
            self.add_rotation(&suspension.pairs[plate.at.pair].bodies, &stiffness, &zero);
        }
        for bearer in &suspension.side_bearers {
            let k = bearer.grip.stiffness;
            self.add(suspension, &bearer.at, &Vector3::new(k, k, 0.0), &zero);
        }
    }

    /// An element whose force in its three directions is the constants times its stretch and rate.
    fn add(
        &mut self,
        suspension: &Suspension,
        at: &Point,
        stiffness: &Vector3<f64>,
        damping: &Vector3<f64>,
    ) {
        let ends = Ends::new(suspension, at);
        let jacobians = ends.arms.each_ref().map(jacobian);
        self.add_between(&ends.bodies, &jacobians, stiffness, damping);
    }

    /// The same for the rotations of two bodies.
    fn add_rotation(
        &mut self,
        bodies: &[usize; 2],
        stiffness: &Vector3<f64>,
        damping: &Vector3<f64>,
    ) {
        let mut rotation = Matrix3x6::zeros();
        rotation.fixed_view_mut::<3, 3>(0, 3).fill_with_identity();
        self.add_between(bodies, &[rotation; 2], stiffness, damping);
    }

    fn add_between(
        &mut self,
        bodies: &[usize; 2],
        jacobians: &[Matrix3x6<f64>; 2],
        stiffness: &Vector3<f64>,
        damping: &Vector3<f64>,
    ) {
        let pairs = [(&mut self.stiffness, stiffness), (&mut self.damping, damping)];
        for (matrix, constants) in pairs {
            let diagonal = nalgebra::Matrix3::from_diagonal(constants);
            for (i, side) in [-1.0, 1.0].into_iter().enumerate() {
                for (j, other) in [-1.0, 1.0].into_iter().enumerate() {
                    let block = side * other * jacobians[i].transpose() * diagonal * jacobians[j];
                    let corner = (COORDINATES * bodies[i], COORDINATES * bodies[j]);
                    let mut view = matrix.view_mut(corner, (COORDINATES, COORDINATES));
                    view += block;
                }
            }
        }
    }

    /// Derivative of an element's length along `axis` by all coordinates.
    fn row(&self, ends: &Ends, axis: &Vector3<f64>) -> DVector<f64> {
        let mut row = DVector::zeros(self.inertia.len());
        for (end, side) in [-1.0, 1.0].into_iter().enumerate() {
            let mut view = row.rows_mut(COORDINATES * ends.bodies[end], COORDINATES);
            view += side * jacobian(&ends.arms[end]).transpose() * axis;
        }
        row
    }

    /// A matrix in coordinates of unit inertia, M^-1/2 A M^-1/2.
    pub(super) fn scaled(&self, matrix: &DMatrix<f64>) -> DMatrix<f64> {
        let inertia = &self.inertia;
        DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, j| {
            matrix[(i, j)] / (inertia[i] * inertia[j]).sqrt()
        })
    }
}
