//! A vehicle of another maker: a point mass on a straight track, with the variables that the role
//! of a vehicle needs and no more.
//!
//! ```text
//! m dv/dt = F_front − F_rear + F_resistance + F_traction + F_sync        dx/dt = v
//! ```

use std::borrow::Cow;
use std::path::Path;

use fmu::{Declaration, Handles, Identity, Interval, Log, Model, ModelError, Values, Variables};

fmu::variables! {
    /// What the vehicle is, and where it begins.
    #[derive(Copy)]
    pub struct Parameters: parameter {
        /// Mass
        mass: "mass", KILOGRAM = 134e3, above(0.0);
        /// Chainage of the vehicle's middle at the start
        position: "initial.position", METRE = 0.0;
        /// Velocity at the start
        velocity: "initial.velocity", METRE_PER_SECOND = 0.0;
    }

    /// The forces on the vehicle along the track.
    #[derive(Copy)]
    pub struct Forces: input {
        /// Force of the front coupler, tension positive
        front: "coupler.front.force", NEWTON = 0.0;
        /// Force of the rear coupler, tension positive
        rear: "coupler.rear.force", NEWTON = 0.0;
        /// Propulsion resistance, negative when running forward
        resistance: "resistance.force", NEWTON = 0.0;
        /// Traction, negative for the dynamic brake
        traction: "traction.force", NEWTON = 0.0;
        /// Force that keeps the vehicle in step with the train
        synchronisation: "sync.force", NEWTON = 0.0;
    }

    /// How the vehicle moves.
    #[derive(Copy)]
    pub struct Motion: output {
        /// Chainage of the vehicle's middle
        position: "position", METRE;
        /// Velocity along the track
        velocity: "velocity", METRE_PER_SECOND;
    }

    /// All variables of the FMU.
    pub struct Signals {
        /// What the vehicle is, and where it begins.
        parameters: "", group(Parameters);
        /// What acts on it.
        forces: "", group(Forces);
        /// How it moves.
        motion: "", group(Motion);
    }
}

impl Forces {
    /// Their sum forward, N.
    fn sum(&self) -> f64 {
        self.front - self.rear + self.resistance + self.traction + self.synchronisation
    }
}

/// The model.
#[derive(Debug)]
pub struct PointMass {
    mass: f64,
    motion: Motion,
}

impl Model for PointMass {
    const IDENTITY: Identity = Identity {
        name: "Point mass",
        identifier: "swap_a_vehicle",
        description: "A vehicle without wheels: one mass on a straight track",
        default_step: 1e-3,
    };

    type Signals = Handles<Signals>;
    type State = (f64, f64);

    fn declare(
        _resources: &Path,
        declaration: &mut Declaration,
    ) -> Result<Handles<Signals>, ModelError> {
        Ok(Signals::declare(declaration, ""))
    }

    fn initialize(
        signals: &Handles<Signals>,
        values: &mut Values,
        _resources: &Path,
        _start_time: f64,
        _log: &mut Log,
    ) -> Result<Self, ModelError> {
        let Parameters { mass, position, velocity } = Parameters::read(&signals.parameters, values);
        let motion = Motion { position, velocity };
        motion.write(&signals.motion, values);
        Ok(Self { mass, motion })
    }

    /// With forces that are constant over the step the motion is exact.
    fn step(
        &mut self,
        signals: &Handles<Signals>,
        values: &mut Values,
        interval: Interval,
        _log: &mut Log,
    ) -> Result<(), ModelError> {
        let before = self.motion.velocity;
        let force = Forces::read(&signals.forces, values).sum();
        self.motion.velocity += force / self.mass * interval.length;
        self.motion.position += 0.5 * (before + self.motion.velocity) * interval.length;
        self.motion.write(&signals.motion, values);
        Ok(())
    }

    fn state(&self) -> Cow<'_, (f64, f64)> {
        Cow::Owned((self.motion.position, self.motion.velocity))
    }

    fn restore(&mut self, (position, velocity): (f64, f64)) {
        self.motion = Motion { position, velocity };
    }
}

fmu::export!(PointMass);
