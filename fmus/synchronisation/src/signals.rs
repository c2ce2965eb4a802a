//! The FMU's variables, and their conversion to those of the controller.

fmu::variables! {
    /// All variables.
    #[derive(Copy)]
    pub struct Signals {
        /// Motion of the vehicle model.
        vehicle: "vehicle", group(Motion) = "the vehicle model";
        /// Motion that the train model has where the vehicle is.
        train: "train", group(Motion) = "the vehicle in the train model";
        /// Gains and limit of the controller.
        gains: "", group(Gains);
        /// Force on the vehicle.
        force: "", group(Force);
    }

    /// Position and velocity at one instant.
    #[derive(Copy)]
    pub struct Motion: input {
        /// Chainage of {}
        position: "position", METRE = 0.0;
        /// Velocity of {}
        velocity: "velocity", METRE_PER_SECOND = 0.0;
    }

    /// Gains of Bosomworth et al. 2018, section 2.2.3; the limit as in Hotfoot's scenarios.
    #[derive(Copy)]
    pub struct Gains: parameter {
        /// Kp
        proportional: "gain.proportional", NEWTON_PER_METRE = 2e3, 0.0..;
        /// Ki
        integral: "gain.integral", NEWTON_PER_METRE_SECOND = 0.0, 0.0..;
        /// Kd
        derivative: "gain.derivative", NEWTON_SECOND_PER_METRE = 10e3, 0.0..;
        /// Largest magnitude of the force
        limit: "force.limit", NEWTON = 500e3, 0.0..;
    }

    /// What the controller gives.
    #[derive(Copy)]
    pub struct Force: output {
        /// Force on the vehicle
        force: "sync.force", NEWTON;
    }
}

impl From<Motion> for controller::Motion {
    fn from(Motion { position, velocity }: Motion) -> Self {
        Self { position, velocity }
    }
}

impl From<Gains> for controller::Gains {
    fn from(Gains { proportional, integral, derivative, limit }: Gains) -> Self {
        Self { proportional, integral, derivative, limit }
    }
}
