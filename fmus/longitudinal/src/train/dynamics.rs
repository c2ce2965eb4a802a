//! The train: vehicles, the connections between them, and the track they run on.

use std::collections::BTreeMap;
use std::sync::Arc;

use serde::{Deserialize, Serialize};
use stock::{Consist, Library};
use track::Track;

use crate::coupling::connection::{Connection, ConnectionState};
use crate::history::History;
use crate::line::wind::Wind;
use crate::train::build::{BuildError, Shared};
use crate::train::energy::{Energy, Work};
use crate::train::member::Member;
use crate::train::vehicle::Vehicle;
use crate::train::vehicle_state::VehicleState;

/// What does not change in a train.
///
/// Only indices of the last lookups change; they speed up the next ones and do not affect results.
#[derive(Clone, Debug)]
pub struct TrainDynamics {
    pub(crate) vehicles: Vec<Arc<Vehicle>>,
    /// What distinguishes each vehicle from others of its type.
    pub(crate) members: Vec<Member>,
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
    /// What each group of locomotives has commanded by the brake pipe; empty without air brakes.
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
            let hand_force = train.vehicles[i].brake.hand_force(member.hand_brake);
            let hand_force = hand_force.ok_or_else(|| BuildError::NoHandBrake {
                number: i + 1,
                share: member.hand_brake,
                vehicle: consist.types[i].clone(),
            })?;
            train.members[i] = Member { group: member.group, hand_force, ..Member::default() };
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
        let mut shared = Shared::default();
        let mut connections = Vec::with_capacity(members.len());
        for (k, pair) in members.windows(2).enumerate() {
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
            connections.push(Connection::new(
                shared.gears([(front, front_gear), (rear, rear_gear)])?,
                (front.coupler.rear_slack_mm() + rear.coupler.slack_mm) * 1e-3,
                (front.length_m + rear.length_m) / 2.0,
            ));
        }
        let vehicles = members.iter().map(|(vehicle, ..)| shared.vehicle(vehicle));
        let vehicles: Vec<_> = vehicles.collect::<Result<_, _>>()?;
        let members = vec![Member::default(); vehicles.len()];
        let mut train = Self { vehicles, members, connections, track, wind: Wind::default() };
        train.find_sources();
        Ok(train)
    }

    /// Number of the groups of locomotives.
    pub fn groups(&self) -> usize {
        self.members.iter().map(|member| member.group).max().map_or(1, |last| last + 1)
    }

    /// Force that the train needs to keep a speed, m/s, where it will be `ahead`, m, in N.
    pub fn demand(&self, state: &TrainState, ahead: f64, speed: f64) -> f64 {
        let vehicles = self.vehicles.iter().zip(&self.members).zip(&state.vehicles);
        let demand = |((vehicle, member), own): ((&Arc<Vehicle>, &Member), &VehicleState)| {
            vehicle.demand(own.position + ahead, speed, &self.track, member.track_index)
        };
        vehicles.map(demand).sum()
    }

    /// Mass of the train with that of the rotating parts' inertia, kg.
    pub fn inertia(&self) -> f64 {
        self.vehicles.iter().map(|vehicle| vehicle.inertia).sum()
    }

    /// The vehicles from the head of the train.
    pub fn vehicles(&self) -> &[Arc<Vehicle>] {
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
