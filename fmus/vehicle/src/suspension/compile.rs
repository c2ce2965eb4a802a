//! From the elements of a vehicle file to flat arrays, one entry for each point.

use nalgebra::Vector3;
use stock::{Direction, Multibody};

use super::Suspension;
use super::centre_plate::CentrePlate;
use super::damper::Damper;
use super::ends::Ends;
use super::friction::Friction;
use super::grip::Grip;
use super::rod::Rod;
use super::rotational::RotationalSpring;
use super::side_bearer::SideBearer;
use super::spring::Spring;
use super::stop::Stop;
use super::tabulated::TabulatedSpring;
use super::wedge::Wedge;
use crate::body::RigidBody;

impl Suspension {
    /// The elements between these bodies, whose names the stock library has checked. Static loads
    /// are not known yet.
    pub(crate) fn new(multibody: &Multibody, bodies: &[RigidBody]) -> Self {
        let ends = |between: &[String; 2], points| all_ends(bodies, between, points);
        let mut all = Self::default();
        for spring in &multibody.spring {
            all.springs.extend(ends(&spring.between, &spring.points_m).map(|ends| Spring {
                ends,
                stiffness: spring.stiffness_n_m.into(),
                damping: spring.damping_n_s_m.into(),
                preload: Vector3::zeros(),
            }));
        }
        for damper in &multibody.damper {
            all.dampers.extend(ends(&damper.between, &damper.points_m).map(|ends| Damper {
                ends,
                axis: axis(damper.direction),
                damping: damper.damping_n_s_m,
                series_stiffness: damper.series_stiffness_n_m.unwrap_or(f64::INFINITY),
                blow_off: damper.blow_off_n.unwrap_or(f64::INFINITY),
            }));
        }
        for stop in &multibody.stop {
            all.stops.extend(ends(&stop.between, &stop.points_m).map(|ends| Stop {
                ends,
                axis: axis(stop.direction),
                free_play: stop.free_play_mm * 1e-3,
                stiffness: stop.stiffness_n_m,
            }));
        }
        for spring in &multibody.tabulated_spring {
            let table = spring.displacement_mm.iter().zip(&spring.force_n);
            let points: Vec<[f64; 2]> = table.map(|(mm, force)| [mm * 1e-3, *force]).collect();
            let axis = axis(spring.direction);
            let springs = ends(&spring.between, &spring.points_m)
                .map(|ends| TabulatedSpring::new(ends, axis, points.clone(), spring.damping_n_s_m));
            all.tabulated_springs.extend(springs);
        }
        for spring in &multibody.rotational_spring {
            all.rotational_springs.push(RotationalSpring {
                bodies: spring.between.each_ref().map(|name| index(bodies, name)),
                stiffness: spring.stiffness_n_m_rad.into(),
                damping: spring.damping_n_m_s_rad.into(),
                preload: Vector3::zeros(),
            });
        }
        for rod in &multibody.rod {
            all.rods.push(self::rod(rod, bodies));
        }
        all.add_friction(multibody, bodies);
        all
    }

    fn add_friction(&mut self, multibody: &Multibody, bodies: &[RigidBody]) {
        let ends = |between: &[String; 2], points| all_ends(bodies, between, points);
        for friction in &multibody.friction {
            let grip = Grip { stiffness: friction.stick_stiffness_n_m };
            self.frictions.extend(ends(&friction.between, &friction.points_m).map(|ends| {
                Friction { ends, axis: axis(friction.direction), limit: friction.force_n, grip }
            }));
        }
        for wedge in &multibody.wedge {
            self.wedges.extend(ends(&wedge.between, &wedge.points_m).map(|ends| Wedge {
                ends,
                slope: wedge.angle_deg.to_radians().tan(),
                friction: wedge.friction,
                spring_force: wedge.spring_force_n,
                spring_stiffness: wedge.spring_stiffness_n_m,
                grip: Grip { stiffness: wedge.stick_stiffness_n_m },
            }));
        }
        for plate in &multibody.centre_plate {
            self.centre_plates.extend(
                ends(&plate.between, std::slice::from_ref(&plate.point_m)).map(|ends| {
                    CentrePlate {
                        ends,
                        radius: plate.radius_m,
                        stiffness: plate.stiffness_n_m.into(),
                        damping: plate.damping_n_s_m.into(),
                        friction: plate.friction,
                        grip: Grip { stiffness: plate.stick_stiffness_n_m_rad },
                        preload: [0.0; 2],
                        rim_preload: [0.0; 4],
                    }
                }),
            );
        }
        for bearer in &multibody.side_bearer {
            self.side_bearers.extend(ends(&bearer.between, &bearer.points_m).map(|ends| {
                SideBearer {
                    ends,
                    preload: bearer.preload_n,
                    stiffness: bearer.stiffness_n_m,
                    solid_gap: bearer.solid_gap_mm * 1e-3,
                    solid_stiffness: bearer.solid_stiffness_n_m,
                    friction: bearer.friction,
                    grip: Grip { stiffness: bearer.stick_stiffness_n_m },
                }
            }));
        }
    }
}

fn rod(rod: &stock::Rod, bodies: &[RigidBody]) -> Rod {
    let indices = rod.between.each_ref().map(|name| index(bodies, name));
    let arm = |end: usize| arm(&bodies[indices[end]], &rod.ends_m[end]);
    let [a, b] = rod.ends_m;
    Rod {
        ends: Ends { bodies: indices, arms: [arm(0), arm(1)] },
        line: Vector3::new(b[0] - a[0], b[1] - a[1], a[2] - b[2]),
        stiffness: rod.stiffness_n_m,
        damping: rod.damping_n_s_m,
        preload: 0.0,
    }
}

/// The ends of elements between two bodies, one for each point.
fn all_ends<'a>(
    bodies: &'a [RigidBody],
    between: &[String; 2],
    points: &'a [[f64; 3]],
) -> impl Iterator<Item = Ends> + use<'a> {
    let indices = between.each_ref().map(|name| index(bodies, name));
    points
        .iter()
        .map(move |point| Ends { bodies: indices, arms: indices.map(|i| arm(&bodies[i], point)) })
}

/// Arm from a body's centre of mass to a point x, y, height.
fn arm(body: &RigidBody, &[x, y, height]: &[f64; 3]) -> Vector3<f64> {
    Vector3::new(x - body.along, y - body.across, body.height - height)
}

/// Place of the body with this name; the stock library has checked that there is one.
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
