//! What flows between the units of a train, as connections of a package.

use crate::system::port::Port;
use crate::system::structure::{Connection, Endpoint};
use crate::train::lockstep::Lockstep;
use crate::train::rail::Rail;
use crate::train::roles::{rail_input, train, vehicle_input, vehicle_output};

/// Name of the train's component.
pub(super) const TRAIN: &str = "train";

impl Lockstep {
    /// Every connection between the units and the controllers.
    pub(super) fn connections(&self) -> Vec<Connection> {
        let mut connections = vec![];
        for place in 1..=self.vehicles.len() {
            connections.extend(self.forces(place));
            connections.extend(self.controller(place));
        }
        for rail in &self.rails {
            connections.extend(self.wheels(rail));
        }
        connections
    }

    /// From the train to a vehicle.
    fn forces(&self, place: usize) -> Vec<Connection> {
        let outputs = &self.train.outputs;
        let inputs = &self.vehicles[place - 1].inputs;
        let block = (place - 1) * train::NAMES.len();
        let pairs = [
            (train::COUPLER_FRONT, vehicle_input::COUPLER_FRONT),
            (train::COUPLER_REAR, vehicle_input::COUPLER_REAR),
            (train::RESISTANCE, vehicle_input::RESISTANCE),
            (train::TRACTION, vehicle_input::TRACTION),
            (train::BRAKE, vehicle_input::BRAKE),
        ];
        let connect = |(output, input)| {
            connection((TRAIN, outputs, block + output), (&vehicle_name(place), inputs, input))
        };
        pairs.into_iter().filter_map(connect).collect()
    }

    /// From a vehicle and its place in the train to its controller, and back to the vehicle.
    fn controller(&self, place: usize) -> Vec<Connection> {
        let vehicle = &self.vehicles[place - 1];
        let block = (place - 1) * train::NAMES.len();
        let (name, controller) = (vehicle_name(place), controller_name(place));
        let into = |element: &str, port: &Port, at: usize, connector: &str| {
            let (variable, way) = port.variable(at)?;
            let to = endpoint(&controller, connector);
            Some(Connection::of(endpoint(element, variable), to, way))
        };
        let of_train = &self.train.outputs;
        let force = vehicle.inputs.variable(vehicle_input::SYNCHRONISATION).map(|(input, way)| {
            let from = endpoint(&controller, "sync.force");
            Connection::of(from, endpoint(&name, input), way.inverse())
        });
        [
            into(&name, &vehicle.outputs, vehicle_output::POSITION, "vehicle.position"),
            into(&name, &vehicle.outputs, vehicle_output::VELOCITY, "vehicle.velocity"),
            into(TRAIN, of_train, block + train::POSITION, "train.position"),
            into(TRAIN, of_train, block + train::VELOCITY, "train.velocity"),
            force,
        ]
        .into_iter()
        .flatten()
        .collect()
    }

    /// From the vehicles' wheelsets to the rail, and from the train the heat of their brakes.
    fn wheels(&self, rail: &Rail) -> Vec<Connection> {
        let name = component_name(rail.unit.name());
        let mut connections = vec![];
        let mut block = 0;
        for (i, vehicle) in self.vehicles.iter().enumerate() {
            for j in 0..vehicle.wheelsets() {
                let wheel = vehicle_output::wheel(j, rail.side);
                let of_wheel = rail_input::FROM_WHEEL.iter().map(|place| wheel + place);
                let outputs = [vehicle_output::wheelset(j), vehicle_output::VELOCITY];
                for (input, output) in outputs.into_iter().chain(of_wheel).enumerate() {
                    connections.extend(connection(
                        (&vehicle_name(i + 1), &vehicle.outputs, output),
                        (&name, &rail.inputs, block + input),
                    ));
                }
                let heat = i * train::NAMES.len() + train::WHEEL_BRAKE_POWER;
                connections.extend(connection(
                    (TRAIN, &self.train.outputs, heat),
                    (&name, &rail.inputs, block + rail_input::BRAKE_POWER),
                ));
                block += rail_input::NAMES.len();
            }
        }
        connections
    }
}

/// Name of a unit's component: `vehicle_17` for `vehicle[17]`, as brackets are no part of an SSP
/// name.
pub(super) fn component_name(unit: &str) -> String {
    unit.replace('[', "_").replace(']', "")
}

fn vehicle_name(place: usize) -> String {
    format!("vehicle_{place}")
}

/// Name of the component of a vehicle's controller.
pub(super) fn controller_name(place: usize) -> String {
    format!("controller_{place}")
}

fn endpoint(element: &str, connector: &str) -> Endpoint {
    Endpoint { element: element.to_owned(), connector: connector.to_owned() }
}

/// A place in a port of a component.
type PortPlace<'p> = (&'p str, &'p Port, usize);

/// The connection of two places; none where a unit lacks the variable.
fn connection(output: PortPlace<'_>, input: PortPlace<'_>) -> Option<Connection> {
    let (from, from_way) = output.1.variable(output.2)?;
    let (to, to_way) = input.1.variable(input.2)?;
    let way = from_way.then(to_way.inverse());
    Some(Connection::of(endpoint(output.0, from), endpoint(input.0, to), way))
}
