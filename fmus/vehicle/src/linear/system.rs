//! The linear system M d²q/dt² + C dq/dt + K q + Σ b f = 0, where f of a damper with the stiffness
//! k in series follows df/dt = k (bᵀ dq/dt - f/c).

use nalgebra::{DMatrix, DVector, Matrix3x6, Vector3};

use crate::body::RigidBody;
use crate::structure::Structure;
use crate::suspension::ends::Ends;

/// Coordinates of a body: x, y, z, roll, pitch, yaw.
pub(super) const COORDINATES: usize = 6;

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

/// Derivative of a point's displacement by its body's displacement and rotation.
fn jacobian(arm: &Vector3<f64>) -> Matrix3x6<f64> {
    let mut jacobian = Matrix3x6::identity();
    let turn = -arm.cross_matrix();
    jacobian.fixed_view_mut::<3, 3>(0, 3).copy_from(&turn);
    jacobian
}

impl System {
    /// All bodies on the suspension, wheelsets included; nothing holds these.
    pub fn new(structure: &Structure) -> Self {
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
        for spring in &structure.suspension.springs {
            add(&mut system.stiffness, &spring.ends, &spring.stiffness);
            add(&mut system.damping, &spring.ends, &spring.damping);
        }
        for damper in &structure.suspension.dampers {
            let axis = Vector3::ith(damper.axis, 1.0);
            match damper.series_stiffness.is_finite() {
                true => system.series.push(Series {
                    row: row(size, &damper.ends, &axis),
                    damping: damper.damping,
                    stiffness: damper.series_stiffness,
                }),
                false => add(&mut system.damping, &damper.ends, &(damper.damping * axis)),
            }
        }
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

    /// A matrix in coordinates of unit inertia, M^-1/2 A M^-1/2.
    pub(super) fn scaled(&self, matrix: &DMatrix<f64>) -> DMatrix<f64> {
        let inertia = &self.inertia;
        DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, j| {
            matrix[(i, j)] / (inertia[i] * inertia[j]).sqrt()
        })
    }
}

/// Adds a matrix of an element whose force in its three directions is the `constants` times its
/// stretch or rate.
fn add(matrix: &mut DMatrix<f64>, ends: &Ends, constants: &Vector3<f64>) {
    let diagonal = nalgebra::Matrix3::from_diagonal(constants);
    for (i, side) in [-1.0, 1.0].into_iter().enumerate() {
        for (j, other) in [-1.0, 1.0].into_iter().enumerate() {
            let rows = jacobian(&ends.arms[i]).transpose();
            let block = side * other * rows * diagonal * jacobian(&ends.arms[j]);
            let place = (COORDINATES * ends.bodies[i], COORDINATES * ends.bodies[j]);
            let mut view = matrix.view_mut(place, (COORDINATES, COORDINATES));
            view += block;
        }
    }
}

/// Derivative of an element's length along `axis` by all coordinates.
fn row(size: usize, ends: &Ends, axis: &Vector3<f64>) -> DVector<f64> {
    let mut row = DVector::zeros(size);
    for (end, side) in [-1.0, 1.0].into_iter().enumerate() {
        let mut view = row.rows_mut(COORDINATES * ends.bodies[end], COORDINATES);
        view += side * jacobian(&ends.arms[end]).transpose() * axis;
    }
    row
}
