//! A mass on a spring, driven by a force, that can fail on request.

use std::borrow::Cow;
use std::path::Path;

use fmu::{
    Boolean, Declaration, Identity, Integer, Interval, Log, Model, ModelError, Real, Text, Values,
    unit,
};
use serde::{Deserialize, Serialize};

/// Longest step that the spring does in one go, s.
pub const LONGEST_STEP: f64 = 1.0;

/// The model: what is computed once from the parameters, and the state.
pub struct Spring {
    /// Mass, kg.
    mass: f64,
    /// Force when the simulation began, N: balances the spring's weight for good. It is computed
    /// once and is therefore not in the state.
    preload: f64,
    state: State,
}

/// What changes in a step.
#[derive(Clone, Serialize, Deserialize)]
pub struct State {
    /// Elongation, m.
    position: f64,
    /// Its rate, m/s.
    velocity: f64,
}

/// Handles of the variables.
pub struct Signals {
    pub force: Real,
    pub mass: Real,
    pub stiffness: Real,
    pub initial_position: Real,
    pub substeps: Integer,
    pub damped: Boolean,
    /// How to fail: `panic`, `error`, `nan`, `warning`, or with `start` before it already in the
    /// initialization.
    pub trouble: Text,
    /// When to fail, s.
    pub trouble_time: Real,
    pub position: Real,
    pub velocity: Real,
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
            force: d.real("force", unit::NEWTON, "Force on the mass").max(1e6).input(0.0),
            mass: d.real("mass", unit::KILOGRAM, "Mass").min(0.1).parameter(1.0),
            stiffness: d
                .real("stiffness", unit::NEWTON, "Stiffness times one metre")
                .min(0.0)
                .max(1e9)
                .tunable(100.0),
            initial_position: d
                .real("initial.position", unit::METRE, "First elongation")
                .parameter(0.1),
            substeps: d.integer_parameter("substeps", "Substeps in a step", 4, (1, 100)),
            damped: d.boolean_parameter("damped", "Whether there is friction", true),
            trouble: d.text_parameter("trouble", "How to fail", ""),
            trouble_time: d.real("trouble.time", unit::SECOND, "When to fail").parameter(0.0),
            position: d.real("position", unit::METRE, "Elongation").output(),
            velocity: d.real("velocity", unit::METRE_PER_SECOND, "Its rate").output(),
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
        let spring = Self {
            mass: values[signals.mass],
            preload: values[signals.force],
            state: State { position: values[signals.initial_position], velocity: 0.0 },
        };
        log.event(format!("100 % ready with {} kg", spring.mass));
        spring.show(signals, values);
        let trouble = values[signals.trouble].clone();
        if let Some(trouble) = trouble.strip_prefix("start ") {
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
        let substeps = values[signals.substeps];
        let length = interval.length / f64::from(substeps);
        let damping = if values[signals.damped] { 2.0 } else { 0.0 };
        for _ in 0..substeps {
            let State { position, velocity } = &mut self.state;
            let force = values[signals.force]
                - self.preload
                - values[signals.stiffness] * *position
                - damping * *velocity;
            *velocity += force / self.mass * length;
            *position += *velocity * length;
        }
        self.show(signals, values);
        if interval.start >= values[signals.trouble_time] {
            let trouble = values[signals.trouble].clone();
            if trouble == "panic" {
                // What is not in the state breaks, so that restoring the state is not enough.
                self.preload = f64::NAN;
            }
            make_trouble(&trouble, signals, values, log)?;
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
        values[signals.position] = self.state.position;
        values[signals.velocity] = self.state.velocity;
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
        "nan" => values[signals.velocity] = f64::NAN,
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
