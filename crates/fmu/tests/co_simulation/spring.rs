//! A mass on a spring, driven by a force, that can fail on request.

use std::borrow::Cow;
use std::path::Path;

use fmu::{
    Declaration, Handles, Identity, Interval, Log, Model, ModelError, Real, Values, Variables, unit,
};
use serde::{Deserialize, Serialize};

/// Longest step that the spring does in one go, s.
pub const LONGEST_STEP: f64 = 1.0;

/// The model: what is computed once from the parameters, and the state.
pub struct Spring {
    load: Load,
    parameters: Parameters,
    /// Force when the simulation began, N: balances the spring's weight for good. It is computed
    /// once and is therefore not in the state.
    preload: f64,
    state: State,
}

fmu::variables! {
    /// What drives the spring.
    #[derive(Copy)]
    pub struct Drive: input {
        /// Force on the mass
        force: "force", NEWTON = 0.0, ..=1e6;
    }

    /// What hangs on the spring.
    #[derive(Copy)]
    pub struct Load: parameter {
        /// Mass
        mass: "mass", KILOGRAM = 1.0, 0.1..;
    }

    /// What may change between steps.
    #[derive(Copy)]
    pub struct Tuning: tunable {
        /// Stiffness times one metre
        stiffness: "stiffness", NEWTON = 100.0, 0.0..=1e9;
    }

    /// What else is fixed when the simulation begins.
    pub struct Parameters: parameter {
        /// First elongation
        initial_position: "initial.position", METRE = 0.1;
        /// Substeps in a step
        substeps: "substeps", i32 = 4, 1..=100;
        /// Whether there is friction
        damped: "damped", bool = true;
        /// How to fail.
        ///
        /// `panic`, `error`, `nan`, `warning`, or with `start` before it already in the
        /// initialization.
        trouble: "trouble", String = "";
        /// When to fail
        trouble_time: "trouble.time", SECOND = 0.0;
    }

    /// What changes in a step.
    #[derive(Copy, Serialize, Deserialize)]
    pub struct State: output {
        /// Elongation
        position: "position", METRE;
        /// Its rate
        velocity: "velocity", METRE_PER_SECOND;
    }
}

/// Handles of the variables.
pub struct Signals {
    pub drive: Handles<Drive>,
    pub load: Handles<Load>,
    pub tuning: Handles<Tuning>,
    pub parameters: Handles<Parameters>,
    pub state: Handles<State>,
    /// Elongation at points along the spring; as many as the file `points.txt` says.
    pub points: Vec<Real>,
}

impl Model for Spring {
    const IDENTITY: Identity = Identity {
        name: "Spring",
        identifier: "spring",
        description: "A mass on a spring",
        default_step: 0.01,
    };

    type Signals = Signals;
    type State = State;

    fn declare(resources: &Path, d: &mut Declaration) -> Result<Signals, ModelError> {
        let points = number_of_points(&resources.join("points.txt"))?;
        Ok(Signals {
            drive: Drive::declare(d, ""),
            load: Load::declare(d, ""),
            tuning: Tuning::declare(d, ""),
            parameters: Parameters::declare(d, ""),
            state: State::declare(d, ""),
            points: (1..=points)
                .map(|point| {
                    d.terminal(format!("point[{point}]"), "point", "A point of the spring");
                    let name = format!("point[{point}].position");
                    d.real(name, unit::METRE, "Elongation at a point").output()
                })
                .collect(),
        })
    }

    fn initialize(
        signals: &Signals,
        values: &mut Values,
        _resources: &Path,
        _start_time: f64,
        log: &mut Log,
    ) -> Result<Self, ModelError> {
        let parameters = Parameters::read(&signals.parameters, values);
        let spring = Self {
            load: Load::read(&signals.load, values),
            preload: Drive::read(&signals.drive, values).force,
            state: State { position: parameters.initial_position, velocity: 0.0 },
            parameters,
        };
        log.event(format!("100 % ready with {} kg", spring.load.mass));
        spring.show(signals, values);
        if let Some(trouble) = spring.parameters.trouble.strip_prefix("start ") {
            make_trouble(trouble, signals, values, log)?;
        }
        Ok(spring)
    }

    fn step(
        &mut self,
        signals: &Signals,
        values: &mut Values,
        interval: Interval,
        log: &mut Log,
    ) -> Result<(), ModelError> {
        if interval.length > LONGEST_STEP {
            let sentence = format!("at most {LONGEST_STEP} s can be done in one step");
            return Err(ModelError::step_too_long(sentence));
        }
        let Drive { force } = Drive::read(&signals.drive, values);
        let Tuning { stiffness } = Tuning::read(&signals.tuning, values);
        let Parameters { substeps, damped, .. } = self.parameters;
        let length = interval.length / f64::from(substeps);
        let damping = if damped { 2.0 } else { 0.0 };
        for _ in 0..substeps {
            let State { position, velocity } = &mut self.state;
            let force = force - self.preload - stiffness * *position - damping * *velocity;
            *velocity += force / self.load.mass * length;
            *position += *velocity * length;
        }
        self.show(signals, values);
        if interval.start >= self.parameters.trouble_time {
            if self.parameters.trouble == "panic" {
                // What is not in the state breaks, so that restoring the state is not enough.
                self.preload = f64::NAN;
            }
            make_trouble(&self.parameters.trouble, signals, values, log)?;
        }
        Ok(())
    }

    fn state(&self) -> Cow<'_, State> {
        Cow::Borrowed(&self.state)
    }

    fn restore(&mut self, state: State) {
        self.state = state;
    }

    fn terminate(&mut self, log: &mut Log) -> Result<(), ModelError> {
        log.event("the spring rests");
        Ok(())
    }
}

impl Spring {
    fn show(&self, signals: &Signals, values: &mut Values) {
        self.state.write(&signals.state, values);
        let count = signals.points.len() as f64;
        for (index, &point) in signals.points.iter().enumerate() {
            values[point] = self.state.position * ((index + 1) as f64 / count);
        }
    }
}

fn make_trouble(
    trouble: &str,
    signals: &Signals,
    values: &mut Values,
    log: &mut Log,
) -> Result<(), ModelError> {
    match trouble {
        "panic" => panic!("the spring snapped"),
        "error" => return Err(ModelError::new("the spring is too hot")),
        "nan" => values[signals.state.velocity] = f64::NAN,
        "warning" => log.warning("the spring creaks"),
        _ => {}
    }
    Ok(())
}

fn number_of_points(file: &Path) -> Result<usize, ModelError> {
    let Ok(text) = std::fs::read_to_string(file) else {
        return Ok(1);
    };
    let number = text.trim().parse();
    number.map_err(|_| ModelError::new(format!("{}: `{text}` is no number", file.display())))
}
