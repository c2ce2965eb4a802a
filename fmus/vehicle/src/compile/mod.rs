//! From a vehicle file to the flat arrays of a structure.
//!
//! | file | part |
//! |---|---|
//! | `suspension.rs` | force elements, one entry for each point |
//! | `creep_law.rs` | the creep law that the file chooses |
//! | `statics.rs` | static load of the springs |

mod creep_law;
mod statics;
mod suspension;

use std::sync::{Arc, Mutex, PoisonError, Weak};

use contact::{ContactError, GeometryTable, ProfilePair, RailProfile, Reading, WheelProfile};
use nalgebra::Vector3;
use stock::{Multibody, WheelRailContact};

use self::statics::Loose;
use self::suspension::index;
use crate::body::RigidBody;
use crate::contact::WheelData;
use crate::contact::slip_mobility::SlipMobility;
use crate::linear;
use crate::structure::{Structure, WheelsetData};
use crate::suspension::Suspension;

const MM: f64 = 1e-3;

/// Why a vehicle file gives no vehicle.
#[derive(Debug, thiserror::Error)]
pub enum StructureError {
    /// It has only longitudinal data.
    #[error("vehicle \"{vehicle}\" has no section [multibody], which the 3D vehicle model needs")]
    NoMultibody {
        /// Name of the vehicle.
        vehicle: String,
    },
    /// Wheel and rail do not go together.
    #[error("vehicle \"{vehicle}\", {key}: {source}")]
    Contact {
        /// Name of the vehicle.
        vehicle: String,
        /// What is wrong in its file.
        key: &'static str,
        /// Reason.
        source: ContactError,
    },
    /// A body can move without any spring holding it.
    #[error(
        "vehicle \"{vehicle}\", section [multibody]: no spring holds body \"{body}\" in \
         {coordinate}; every body must be held against the wheelsets in all directions"
    )]
    Loose {
        /// Name of the vehicle.
        vehicle: String,
        /// Name of the body.
        body: String,
        /// Coordinate in which it can move.
        coordinate: &'static str,
    },
}

/// Structures of vehicles that are in use: a train of 250 vehicles has few types.
static STRUCTURES: Mutex<Vec<(stock::Vehicle, Weak<Structure>)>> = Mutex::new(Vec::new());

impl Structure {
    /// Compiles a vehicle of the stock library.
    ///
    /// # Errors
    /// When the vehicle has no multibody section or its parts do not fit each other.
    pub fn new(vehicle: &stock::Vehicle) -> Result<Self, StructureError> {
        let name = || vehicle.name.clone();
        let multibody = multibody(vehicle)?;
        let bodies = bodies(multibody);
        let wheelsets = wheelsets(multibody, &bodies)
            .map_err(|(key, source)| StructureError::Contact { vehicle: name(), key, source })?;
        let car = &bodies[0];
        let coupler = |end: f64| {
            let height = multibody.coupler.height_m;
            Vector3::new(end - car.along, -car.across, car.height - height)
        };
        let half = 0.5 * vehicle.length_m;
        let mut structure = Self {
            highest_frequency: 0.0,
            couplers: [coupler(half), coupler(-half)],
            suspension: Suspension::new(multibody, &bodies),
            creep: creep_law::compiled(&multibody.contact.creep),
            bodies,
            wheelsets,
        };
        statics::preload(&mut structure).map_err(|Loose { body, coordinate }| {
            StructureError::Loose { vehicle: name(), body, coordinate }
        })?;
        structure.highest_frequency = linear::highest_frequency(&structure);
        Ok(structure)
    }

    /// The same, compiled once for all instances of this vehicle in the process.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn shared(vehicle: &stock::Vehicle) -> Result<Arc<Self>, StructureError> {
        let mut structures = STRUCTURES.lock().unwrap_or_else(PoisonError::into_inner);
        structures.retain(|(_, structure)| structure.strong_count() > 0);
        let known = structures.iter().find(|(known, _)| known == vehicle);
        if let Some(structure) = known.and_then(|(_, structure)| structure.upgrade()) {
            return Ok(structure);
        }
        let structure = Arc::new(Self::new(vehicle)?);
        structures.push((vehicle.clone(), Arc::downgrade(&structure)));
        Ok(structure)
    }
}

/// The section of a vehicle file that this model needs.
///
/// # Errors
/// When the vehicle has none.
pub fn multibody(vehicle: &stock::Vehicle) -> Result<&Multibody, StructureError> {
    let section = vehicle.multibody.as_ref();
    section.ok_or_else(|| StructureError::NoMultibody { vehicle: vehicle.name.clone() })
}

fn bodies(multibody: &Multibody) -> Vec<RigidBody> {
    let bodies = multibody.body.iter().map(|body| RigidBody {
        name: body.name.clone(),
        mass: body.mass_kg,
        inertia: body.inertia_kg_m2.into(),
        along: body.x_m,
        across: body.y_m,
        height: body.height_m,
        turns: false,
    });
    let wheelsets = multibody.wheelset.iter().map(|wheelset| RigidBody {
        name: wheelset.name.clone(),
        mass: wheelset.mass_kg,
        inertia: wheelset.inertia_kg_m2.into(),
        along: wheelset.x_m,
        across: 0.0,
        height: wheelset.wheel_radius_m,
        turns: true,
    });
    bodies.chain(wheelsets).collect()
}

/// Profiles of wheel and rail on the left and on the right, or the key of the one that is wrong.
fn profiles(
    contact: &WheelRailContact,
) -> Result<[(WheelProfile, RailProfile); 2], (&'static str, ContactError)> {
    let reading = Reading {
        running_circle: contact.running_circle_mm * MM,
        wavelength: contact.profile_smoothing_mm * MM,
        ..Reading::default()
    };
    let wheel = |key, name: &str| WheelProfile::read(name, &reading).map_err(|error| (key, error));
    let rail = |key, name: &str| RailProfile::read(name, &reading).map_err(|error| (key, error));
    let right = (
        wheel("multibody.contact.wheel", &contact.wheel)?,
        rail("multibody.contact.rail", &contact.rail)?,
    );
    let mut left = right.clone();
    if let Some(name) = &contact.left_wheel {
        left.0 = wheel("multibody.contact.left_wheel", name)?;
    }
    if let Some(name) = &contact.left_rail {
        left.1 = rail("multibody.contact.left_rail", name)?;
    }
    Ok([left, right])
}

fn wheelsets(
    multibody: &Multibody,
    bodies: &[RigidBody],
) -> Result<Vec<WheelsetData>, (&'static str, ContactError)> {
    let contact = &multibody.contact;
    let profiles = profiles(contact)?;
    let powered = multibody.wheelset.iter().filter(|w| w.powered).count();
    let count = multibody.wheelset.len();
    let mut wheelsets = Vec::with_capacity(count);
    for wheelset in &multibody.wheelset {
        let pair = |(wheel, rail): &(WheelProfile, RailProfile)| ProfilePair {
            wheel: wheel.clone(),
            rail: rail.clone(),
            rail_inclination: contact.rail_inclination,
            gauge: contact.gauge_mm * MM,
            gauge_depth: contact.gauge_depth_mm * MM,
            flange_back_distance: contact.flange_back_distance_mm * MM,
            running_circle_from_flange_back: contact.running_circle_mm * MM,
            nominal_radius: wheelset.wheel_radius_m,
        };
        let pairs = profiles.each_ref().map(pair);
        let table = |pair: &ProfilePair| {
            GeometryTable::shared(pair).map_err(|error| ("multibody.contact", error))
        };
        let body = index(bodies, &wheelset.name);
        let (radius, half_distance) = (wheelset.wheel_radius_m, pairs[0].running_circle());
        wheelsets.push(WheelsetData {
            body,
            frame: index(bodies, &wheelset.frame),
            wheel: WheelData { radius, half_distance, damping: contact.damping_s_m },
            slip_mobility: SlipMobility::new(&bodies[body], radius),
            tables: [table(&pairs[0])?, table(&pairs[1])?],
            static_wheel_load: 0.0,
            traction_share: if wheelset.powered { 1.0 / powered as f64 } else { 0.0 },
            brake_share: 1.0 / count as f64,
        });
    }
    Ok(wheelsets)
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    fn vehicle(name: &str) -> stock::Vehicle {
        let stock = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../stock");
        stock::Library::open(stock).unwrap().vehicle(name).unwrap()
    }

    /// Bodies have the mass of the vehicle, wheels carry it, and drive and brake are shared out whole.
    #[test]
    fn property_masses_loads_and_shares_add_up() {
        for name in
            ["locomotive-coco-134t", "manchester-vehicle-1", "wagon-ore-40t", "wagon-ore-40t-empty"]
        {
            let vehicle = vehicle(name);
            let structure = Structure::new(&vehicle).unwrap();
            let near = |found: f64, expected: f64| {
                assert!((found / expected - 1.0).abs() < 1e-6, "{name}: {found}, {expected}");
            };
            near(structure.mass(), vehicle.mass_kg);
            let loads = structure.wheelsets.iter().map(|data| 2.0 * data.static_wheel_load);
            near(loads.sum(), vehicle.mass_kg * numerics::constants::STANDARD_GRAVITY);
            near(structure.wheelsets.iter().map(|data| data.brake_share).sum(), 1.0);
            let traction: f64 = structure.wheelsets.iter().map(|data| data.traction_share).sum();
            assert!(traction == 0.0 || (traction - 1.0).abs() < 1e-12, "{name}: {traction}");
        }
    }

    #[test]
    fn equal_vehicles_share_one_structure() {
        let first = Structure::shared(&vehicle("wagon-ore-40t")).unwrap();
        let second = Structure::shared(&vehicle("wagon-ore-40t")).unwrap();
        assert!(Arc::ptr_eq(&first, &second));
    }

    #[test]
    fn a_vehicle_without_bodies_is_refused_by_name() {
        let mut vehicle = vehicle("wagon-ore-40t");
        vehicle.multibody = None;
        let message = Structure::new(&vehicle).unwrap_err().to_string();
        assert!(message.contains(&vehicle.name) && message.contains("[multibody]"), "{message}");
    }
}
