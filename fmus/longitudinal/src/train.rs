//! The train: vehicles, the connections between them, and the track they run on.

use std::collections::BTreeMap;

use numerics::TableError;
use serde::{Deserialize, Serialize};
use stock::{Consist, Library, StockError};
use track::Track;

use crate::connection::{Connection, ConnectionState};
use crate::draft_gear::DraftGear;
use crate::energy::{Energy, Work};
use crate::vehicle::{Vehicle, VehicleState};

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
}

/// What does not change in a train (but for the places of the last lookups, which speed up the
/// next ones and have no influence on results).
#[derive(Clone, Debug)]
pub struct TrainDynamics {
    pub(crate) vehicles: Vec<Vehicle>,
    /// Connection `k` joins the vehicles `k` and `k + 1`.
    pub(crate) connections: Vec<Connection>,
    pub(crate) track: Track,
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
        let mut types: BTreeMap<&str, (stock::Vehicle, stock::DraftGear)> = BTreeMap::new();
        for name in &consist.types {
            if !types.contains_key(name.as_str()) {
                let vehicle = library.vehicle(name)?;
                let gear = library.draft_gear(&vehicle.coupler.draft_gear)?;
                types.insert(name, (vehicle, gear));
            }
        }
        let members = consist.types.iter().map(|name| &types[name.as_str()]);
        Self::new(members.map(|(vehicle, gear)| (vehicle, gear)), track)
    }

    /// The train of vehicles, each with its draft gear, from the head.
    ///
    /// # Errors
    /// When a table of a vehicle cannot be used.
    pub fn new<'a>(
        members: impl IntoIterator<Item = (&'a stock::Vehicle, &'a stock::DraftGear)>,
        track: Track,
    ) -> Result<Self, BuildError> {
        let members: Vec<_> = members.into_iter().collect();
        let vehicles = members.iter().map(|(vehicle, _)| {
            Vehicle::new(vehicle)
                .map_err(|source| BuildError::Table { vehicle: vehicle.name.clone(), source })
        });
        let connections = members.windows(2).map(|pair| {
            let ((front, front_gear), (rear, rear_gear)) = (pair[0], pair[1]);
            Connection::new(
                &DraftGear::new(front_gear),
                &DraftGear::new(rear_gear),
                (front.coupler.slack_mm + rear.coupler.slack_mm) * 1e-3,
                (front.length_m + rear.length_m) / 2.0,
            )
        });
        Ok(Self {
            vehicles: vehicles.collect::<Result<_, _>>()?,
            connections: connections.collect(),
            track,
        })
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
