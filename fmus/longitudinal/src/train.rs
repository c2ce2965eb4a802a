//! The train: vehicles, the connections between them, and the track they run on.

use std::collections::BTreeMap;

use numerics::TableError;
use serde::{Deserialize, Serialize};
use stock::{Consist, Library, StockError};
use track::Track;

use crate::connection::{Connection, ConnectionState};
use crate::draft_gear::DraftGear;
use crate::energy::{Energy, Work};
use crate::history::History;
use crate::pipe;
use crate::vehicle::{Vehicle, VehicleState};
use crate::wind::Wind;

/// Why a train cannot be built.
#[derive(Debug, thiserror::Error)]
pub enum BuildError {
    /// A rolling-stock file cannot be used.
    #[error(transparent)]
    Stock(#[from] StockError),
    /// A table of a vehicle type cannot be used.
    #[error("vehicle {vehicle}: {source}")]
    Table {
        /// The type's name.
        vehicle: String,
        /// Reason.
        source: TableError,
    },
    /// Two neighbours have couplers of different kinds.
    #[error(
        "vehicles {number} and {next} of the consist do not fit: the rear coupler of {front} is \
         {front_kind:?}, the front coupler of {rear} is {rear_kind:?} (coupler.kind)"
    )]
    DoNotFit {
        /// Number of the vehicle in front, from 1.
        number: usize,
        /// Number of the vehicle behind it.
        next: usize,
        /// Type of the vehicle in front.
        front: String,
        /// Kind of its rear coupler.
        front_kind: String,
        /// Type of the vehicle behind it.
        rear: String,
        /// Kind of its front coupler.
        rear_kind: String,
    },
    /// A hand brake is applied that a vehicle does not have.
    #[error(
        "vehicle {number} of the consist: hand_brake = {share}: its type {vehicle} has no section \
         [hand_brake]"
    )]
    NoHandBrake {
        /// Number of the vehicle in the train, from 1.
        number: usize,
        /// Share that is applied.
        share: f64,
        /// The type's name.
        vehicle: String,
    },
    /// The step of the model is too long for the train.
    #[error(
        "the step of {step} s is longer than the longest stable one, {longest:.2e} s, which vehicles \
         {number} and {next} set: give their draft gears a greater transition_speed_mm_s or none, \
         less damping, or less stiffness"
    )]
    Unstable {
        /// Step, s.
        step: f64,
        /// Longest stable step, s.
        longest: f64,
        /// Vehicle in front of the connection, from 1.
        number: usize,
        /// Vehicle behind it.
        next: usize,
    },
}

/// What does not change in a train (but for the places of the last lookups, which speed up the
/// next ones and have no influence on results).
#[derive(Clone, Debug)]
pub struct TrainDynamics {
    pub(crate) vehicles: Vec<Vehicle>,
    /// Connection `k` joins the vehicles `k` and `k + 1`.
    pub(crate) connections: Vec<Connection>,
    pub(crate) track: Track,
    /// Wind over the line.
    pub wind: Wind,
}

/// What changes in a train.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct TrainState {
    /// The vehicles from the head of the train.
    pub vehicles: Vec<VehicleState>,
    /// The connections from the head of the train.
    pub connections: Vec<ConnectionState>,
    /// Work since the start.
    pub work: Work,
    /// Power at present.
    pub power: Work,
    /// Work on the draft gears since the start, J.
    pub gear_work: f64,
    /// Energy at the start.
    pub initial_energy: Energy,
    /// Time since the start, s.
    pub time: f64,
    /// What each group of locomotives has told the brake pipe; empty when nobody listens.
    pub pipe: Vec<History<f64>>,
}

impl TrainDynamics {
    /// The train of a consist file, with vehicles and draft gears from `library`.
    ///
    /// # Errors
    /// When a file of the library is missing or has a value that is not possible.
    pub fn from_consist(
        consist: &Consist,
        library: &Library,
        track: Track,
    ) -> Result<Self, BuildError> {
        let mut types: BTreeMap<&str, (stock::Vehicle, [stock::DraftGear; 2])> = BTreeMap::new();
        for name in &consist.types {
            if !types.contains_key(name.as_str()) {
                let vehicle = library.vehicle(name)?;
                let front = library.draft_gear(&vehicle.coupler.draft_gear)?;
                let rear = library.draft_gear(vehicle.coupler.rear_draft_gear())?;
                types.insert(name, (vehicle, [front, rear]));
            }
        }
        let members = consist.types.iter().map(|name| &types[name.as_str()]);
        let mut train =
            Self::with_gears(members.map(|(v, [front, rear])| (v, front, rear)), track)?;
        for (i, member) in consist.members.iter().enumerate() {
            let vehicle = &mut train.vehicles[i];
            vehicle.group = member.group;
            if !vehicle.brake.apply_hand_brake(member.hand_brake) {
                return Err(BuildError::NoHandBrake {
                    number: i + 1,
                    share: member.hand_brake,
                    vehicle: consist.types[i].clone(),
                });
            }
        }
        train.find_sources();
        Ok(train)
    }

    /// The train of vehicles, each with one draft gear at both ends, from the head.
    ///
    /// # Errors
    /// When a table of a vehicle or gear cannot be used.
    pub fn new<'a>(
        members: impl IntoIterator<Item = (&'a stock::Vehicle, &'a stock::DraftGear)>,
        track: Track,
    ) -> Result<Self, BuildError> {
        Self::with_gears(members.into_iter().map(|(vehicle, gear)| (vehicle, gear, gear)), track)
    }

    /// The train of vehicles, each with the draft gears of its front and rear end, from the head.
    ///
    /// # Errors
    /// When a table of a vehicle or gear cannot be used.
    pub fn with_gears<'a>(
        members: impl IntoIterator<
            Item = (&'a stock::Vehicle, &'a stock::DraftGear, &'a stock::DraftGear),
        >,
        track: Track,
    ) -> Result<Self, BuildError> {
        let members: Vec<_> = members.into_iter().collect();
        let of = |vehicle: &stock::Vehicle| {
            let vehicle = vehicle.name.clone();
            move |source| BuildError::Table { vehicle, source }
        };
        let vehicles =
            members.iter().map(|(vehicle, ..)| Vehicle::new(vehicle).map_err(of(vehicle)));
        let connections = members.windows(2).enumerate().map(|(k, pair)| {
            let ((front, _, front_gear), (rear, rear_gear, _)) = (pair[0], pair[1]);
            if front.coupler.rear_kind() != rear.coupler.kind {
                return Err(BuildError::DoNotFit {
                    number: k + 1,
                    next: k + 2,
                    front: front.name.clone(),
                    front_kind: front.coupler.rear_kind().to_owned(),
                    rear: rear.name.clone(),
                    rear_kind: rear.coupler.kind.clone(),
                });
            }
            Ok(Connection::new(
                &DraftGear::new(front_gear).map_err(of(front))?,
                &DraftGear::new(rear_gear).map_err(of(rear))?,
                (front.coupler.rear_slack_mm() + rear.coupler.slack_mm) * 1e-3,
                (front.length_m + rear.length_m) / 2.0,
            ))
        });
        let mut train = Self {
            vehicles: vehicles.collect::<Result<_, BuildError>>()?,
            connections: connections.collect::<Result<_, BuildError>>()?,
            track,
            wind: Wind::default(),
        };
        train.find_sources();
        Ok(train)
    }

    /// Finds what each vehicle's air brake listens to.
    fn find_sources(&mut self) {
        let sources = pipe::sources(&self.vehicles);
        for (vehicle, source) in self.vehicles.iter_mut().zip(sources) {
            vehicle.source = source;
        }
    }

    /// Number of the groups of locomotives.
    pub fn groups(&self) -> usize {
        self.vehicles.iter().map(|vehicle| vehicle.group).max().map_or(1, |last| last + 1)
    }

    /// Force that the line takes from the train when all of it is `ahead`, m, further on, at a
    /// speed, m/s, in N.
    pub fn demand(&self, state: &TrainState, ahead: f64, speed: f64) -> f64 {
        let pairs = self.vehicles.iter().zip(&state.vehicles);
        pairs.map(|(v, own)| v.demand(own.position + ahead, speed, &self.track)).sum()
    }

    /// Mass of the train with that of the rotating parts' inertia, kg.
    pub fn inertia(&self) -> f64 {
        self.vehicles.iter().map(|vehicle| vehicle.inertia).sum()
    }

    /// The vehicles from the head of the train.
    pub fn vehicles(&self) -> &[Vehicle] {
        &self.vehicles
    }

    /// The connections from the head of the train.
    pub fn connections(&self) -> &[Connection] {
        &self.connections
    }

    /// Mass of the train, kg.
    pub fn mass(&self) -> f64 {
        self.vehicles.iter().map(|vehicle| vehicle.mass).sum()
    }

    /// Length of the train over its outer couplers in the middle of all slack, m.
    pub fn length(&self) -> f64 {
        self.vehicles.iter().map(|vehicle| vehicle.length).sum()
    }
}
