//! From the elements of a vehicle file to flat arrays, one entry for each point.

use nalgebra::Vector3;
use stock::{Direction, Multibody};

use crate::body::RigidBody;
use crate::suspension::Suspension;
use crate::suspension::centre_plate::CentrePlate;
use crate::suspension::damper::Damper;
use crate::suspension::friction::Friction;
use crate::suspension::grip::Grip;
use crate::suspension::pair::{Pair, Point};
use crate::suspension::rod::Rod;
use crate::suspension::rotational::RotationalSpring;
use crate::suspension::side_bearer::SideBearer;
use crate::suspension::spring::Spring;
use crate::suspension::stop::Stop;
use crate::suspension::tabulated::TabulatedSpring;
use crate::suspension::wedge::Wedge;

impl Suspension {
    /// The elements between these bodies, whose names the stock library has checked. Static loads
    /// are not known yet.
    pub(crate) fn new(multibody: &Multibody, bodies: &[RigidBody]) -> Self {
        let mut all = Self::default();
        for spring in &multibody.spring {
            let points = all.points(bodies, &spring.between, &spring.points_m);
            all.springs.extend(points.into_iter().map(|at| Spring {
                at,
                stiffness: spring.stiffness_n_m.into(),
                damping: spring.damping_n_s_m.into(),
                preload: Vector3::zeros(),
            }));
        }
        for damper in &multibody.damper {
            let points = all.points(bodies, &damper.between, &damper.points_m);
            all.dampers.extend(points.into_iter().map(|at| Damper {
                at,
                axis: axis(damper.direction),
                damping: damper.damping_n_s_m,
                series_stiffness: damper.series_stiffness_n_m.unwrap_or(f64::INFINITY),
                blow_off: damper.blow_off_n.unwrap_or(f64::INFINITY),
            }));
        }
        for stop in &multibody.stop {
            let points = all.points(bodies, &stop.between, &stop.points_m);
            all.stops.extend(points.into_iter().map(|at| Stop {
                at,
                axis: axis(stop.direction),
                free_play: stop.free_play_mm * 1e-3,
                stiffness: stop.stiffness_n_m,
            }));
        }
        for spring in &multibody.tabulated_spring {
            let table = spring.displacement_mm.iter().zip(&spring.force_n);
            let table: Vec<[f64; 2]> = table.map(|(mm, force)| [mm * 1e-3, *force]).collect();
            let axis = axis(spring.direction);
            let points = all.points(bodies, &spring.between, &spring.points_m);
            let spring = |at| TabulatedSpring::new(at, axis, table.clone(), spring.damping_n_s_m);
            all.tabulated_springs.extend(points.into_iter().map(spring));
        }
        for spring in &multibody.rotational_spring {
            let pair = all.pair(bodies, &spring.between);
            all.rotational_springs.push(RotationalSpring {
                pair,
                stiffness: spring.stiffness_n_m_rad.into(),
                damping: spring.damping_n_m_s_rad.into(),
                preload: Vector3::zeros(),
            });
        }
        for rod in &multibody.rod {
            let [a, b] = rod.ends_m;
            let line = Vector3::new(b[0] - a[0], b[1] - a[1], a[2] - b[2]);
            let points = all.points(bodies, &rod.between, &[a]);
            all.rods.extend(points.into_iter().map(|at| Rod {
                at,
                line,
                stiffness: rod.stiffness_n_m,
                damping: rod.damping_n_s_m,
                preload: 0.0,
            }));
        }
        all.add_friction(multibody, bodies);
        all
    }

    fn add_friction(&mut self, multibody: &Multibody, bodies: &[RigidBody]) {
        for friction in &multibody.friction {
            let grip = Grip { stiffness: friction.stick_stiffness_n_m };
            let points = self.points(bodies, &friction.between, &friction.points_m);
            self.frictions.extend(points.into_iter().map(|at| Friction {
                at,
                axis: axis(friction.direction),
                limit: friction.force_n,
                grip,
            }));
        }
        for wedge in &multibody.wedge {
            let points = self.points(bodies, &wedge.between, &wedge.points_m);
            self.wedges.extend(points.into_iter().map(|at| Wedge {
                at,
                slope: libm::tan(wedge.angle_deg.to_radians()),
                friction: wedge.friction,
                spring_force: wedge.spring_force_n,
                spring_stiffness: wedge.spring_stiffness_n_m,
                grip: Grip { stiffness: wedge.stick_stiffness_n_m },
            }));
        }
        for plate in &multibody.centre_plate {
            let points = self.points(bodies, &plate.between, &[plate.point_m]);
            self.centre_plates.extend(points.into_iter().map(|at| CentrePlate {
                at,
                radius: plate.radius_m,
                stiffness: plate.stiffness_n_m.into(),
                damping: plate.damping_n_s_m.into(),
                friction: plate.friction,
                grip: Grip { stiffness: plate.stick_stiffness_n_m_rad },
                preload: [0.0; 2],
                rim_preload: [0.0; 4],
            }));
        }
        for bearer in &multibody.side_bearer {
            let points = self.points(bodies, &bearer.between, &bearer.points_m);
            self.side_bearers.extend(points.into_iter().map(|at| SideBearer {
                at,
                preload: bearer.preload_n,
                stiffness: bearer.stiffness_n_m,
                solid_gap: bearer.solid_gap_mm * 1e-3,
                solid_stiffness: bearer.solid_stiffness_n_m,
                friction: bearer.friction,
                grip: Grip { stiffness: bearer.stick_stiffness_n_m },
            }));
        }
    }

    /// Points between two bodies, from coordinates x, y, height in the vehicle file.
    fn points(
        &mut self,
        bodies: &[RigidBody],
        between: &[String; 2],
        coordinates: &[[f64; 3]],
    ) -> Vec<Point> {
        let pair = self.pair(bodies, between);
        let first = &bodies[index(bodies, &between[0])];
        coordinates.iter().map(|at| Point { pair, arm: arm(first, at) }).collect()
    }

    /// Index of the pair of these two bodies.
    fn pair(&mut self, bodies: &[RigidBody], between: &[String; 2]) -> usize {
        let indices = between.each_ref().map(|name| index(bodies, name));
        let known = self.pairs.iter().position(|pair| pair.bodies == indices);
        known.unwrap_or_else(|| {
            let [first, second] = indices.map(|i| arm(&bodies[i], &[0.0; 3]));
            self.pairs.push(Pair { bodies: indices, offset: second - first });
            self.pairs.len() - 1
        })
    }
}

/// Arm from a body's centre of mass to a point x, y, height.
fn arm(body: &RigidBody, &[x, y, height]: &[f64; 3]) -> Vector3<f64> {
    Vector3::new(x - body.along, y - body.across, body.height - height)
}

/// Index of the body with this name; the stock library has checked that there is one.
pub(crate) fn index(bodies: &[RigidBody], name: &str) -> usize {
    let found = bodies.iter().position(|body| body.name == name);
    found.expect("the stock library checks the names of bodies")
}

fn axis(direction: Direction) -> usize {
    match direction {
        Direction::Longitudinal => 0,
        Direction::Lateral => 1,
        Direction::Vertical => 2,
    }
}
