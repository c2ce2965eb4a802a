//! A vehicle whose FMU has failed and which follows the motion of the train from there.
//!
//! Its wheelsets keep their distances from its middle; its forces, friction power and all else that it would
//! give are zero.

use std::collections::{BTreeMap, HashMap};

use numerics::seconds;
use serde::{Deserialize, Serialize};

use super::layout::VehicleHolder;
use super::roles::tables::{VEHICLE_OUTPUT, WHEELSET};
use super::roles::variable::{RoleVariable, find, named};
use crate::interface::range::Range;
use crate::interface::si::Linear;
use crate::interface::{Interface, Variable, VariableType};
use crate::system::unit::{Unit, UnitError};

/// What such a vehicle is told of its motion in the train, in m and m/s: the train's names and its own.
pub const MOTION: [(&str, &str); 2] =
    [("position", "follow.position"), ("velocity", "follow.velocity")];

/// A vehicle that follows the train if its FMU fails.
pub struct Following {
    unit: Box<dyn Unit>,
    /// That of the unit, and what it is told of the train.
    interface: Interface,
    /// Value references of what it is told, and the values: position, m, and velocity, m/s.
    references: [u32; 2],
    motion: [f64; 2],
    /// Its own outputs that follow.
    followed: HashMap<u32, Followed>,
    /// Value reference of the position of its middle.
    middle: Option<u32>,
    /// Whether its first step has begun. A failure before that always ends the run.
    steps: bool,
    /// Whether it has failed and follows.
    follows: bool,
    /// Time that it has reached, s.
    time: f64,
    warnings: Vec<String>,
}

/// A vehicle in a checkpoint; what it is told of the train comes with its inputs.
#[derive(Serialize, Deserialize)]
struct Saved {
    /// Its FMU, unless that has failed.
    unit: Option<Vec<u8>>,
    time: f64,
    offsets: BTreeMap<u32, f64>,
    warnings: Vec<String>,
}

/// An output that follows the train.
struct Followed {
    /// Position or velocity.
    which: usize,
    /// From SI units to its own.
    conversion: Linear,
    /// What it is more than the train's, in SI units.
    offset: f64,
}

impl Following {
    /// The vehicle that a unit computes as long as it does not fail.
    pub fn new(unit: Box<dyn Unit>, holder: &VehicleHolder) -> Self {
        let mut followed = HashMap::new();
        let mut add = |prefix: String, variable: &RoleVariable, which| {
            let found = find(unit.interface(), &prefix, variable, "output", &holder.names);
            let Some((name, to_si)) = found.ok().flatten() else { return };
            let Some(variable) = unit.interface().variable(&name) else { return };
            let conversion = to_si.inverse();
            followed.insert(variable.reference, Followed { which, conversion, offset: 0.0 });
        };
        add(String::new(), named(VEHICLE_OUTPUT, "position"), 0);
        add(String::new(), named(VEHICLE_OUTPUT, "velocity"), 1);
        let middle = middle_of(unit.interface(), holder);
        for wheelset in 1..=holder.wheelsets {
            add(format!("wheelset[{wheelset}]."), named(WHEELSET, "position"), 0);
        }
        let (interface, references) = with_motion(unit.interface());
        Self {
            middle,
            steps: false,
            interface,
            references,
            motion: [0.0; 2],
            followed,
            follows: false,
            time: 0.0,
            warnings: vec![],
            unit,
        }
    }

    /// What a call has come to: a failure in a step lets the vehicle follow, unless it wants the run to end.
    fn outcome(&mut self, called: Result<(), UnitError>) -> Result<(), UnitError> {
        let Err(error) = called else { return Ok(()) };
        if !self.steps || self.unit.wish_to_end().is_some() {
            return Err(error);
        }
        let UnitError { source_file, action, status, last_message, .. } = &error;
        let status = status.map(|status| format!(" with {status}")).unwrap_or_default();
        let message = last_message.as_deref().unwrap_or("it failed");
        self.warnings.push(format!(
            "{message} at {} s in {action}{status} ({source_file}); from there on it follows the motion of \
             the train, and its forces and friction power are zero",
            seconds(self.time)
        ));
        self.follows = true;
        Ok(())
    }

    /// The value of an output while it follows.
    fn value(&self, reference: u32) -> f64 {
        self.followed.get(&reference).map_or(0.0, |Followed { which, conversion, offset }| {
            conversion.apply(self.motion[*which] + offset)
        })
    }

    /// Notes how far the wheelsets are from the middle of the vehicle.
    fn note_offsets(&mut self) -> Result<(), UnitError> {
        let positions = self.followed.iter().filter(|(_, followed)| followed.which == 0);
        let references: Vec<u32> = positions.map(|(reference, _)| *reference).collect();
        let mut values = vec![0.0; references.len()];
        self.unit.get_reals(&references, &mut values)?;
        let mut middle = 0.0;
        for (reference, value) in references.iter().zip(values) {
            if let Some(followed) = self.followed.get_mut(reference) {
                followed.offset = followed.conversion.inverse().apply(value);
                if Some(*reference) == self.middle {
                    middle = followed.offset;
                }
            }
        }
        let positions = self.followed.values_mut().filter(|followed| followed.which == 0);
        positions.for_each(|followed| followed.offset -= middle);
        Ok(())
    }
}

/// The value reference of the position of a vehicle's middle.
fn middle_of(interface: &Interface, holder: &VehicleHolder) -> Option<u32> {
    let variable = named(VEHICLE_OUTPUT, "position");
    let (name, _) = find(interface, "", variable, "output", &holder.names).ok().flatten()?;
    interface.variable(&name).map(|variable| variable.reference)
}

/// The interface with what the vehicle is told of its motion, and the value references of that.
fn with_motion(interface: &Interface) -> (Interface, [u32; 2]) {
    let known = interface.variables();
    let is_free = |reference: &u32| {
        !known.iter().any(|own| own.kind == VariableType::Real && own.reference == *reference)
    };
    let mut free = (0..).filter(is_free);
    let references = [(); 2].map(|()| free.next().unwrap_or_default());
    let input = |(reference, (_, name)): (u32, (&str, &str))| Variable {
        name: name.to_owned(),
        reference,
        kind: VariableType::Real,
        causality: "input".to_owned(),
        discrete: false,
        unit: None,
        si: None,
        range: Range::FINITE,
        start: None,
        description: String::new(),
    };
    (interface.clone().with(references.into_iter().zip(MOTION).map(input)), references)
}

/// Calls that a vehicle which follows does not need.
macro_rules! unless_it_follows {
    ($($name:ident($($argument:ident: $type:ty),*);)*) => {$(
        fn $name(&mut self, $($argument: $type),*) -> Result<(), UnitError> {
            match self.follows {
                true => Ok(()),
                false => self.unit.$name($($argument),*),
            }
        }
    )*};
}

impl Unit for Following {
    fn name(&self) -> &str {
        self.unit.name()
    }

    fn source_file(&self) -> &str {
        self.unit.source_file()
    }

    fn interface(&self) -> &Interface {
        &self.interface
    }

    fn is_separate(&self) -> bool {
        !self.follows
    }

    unless_it_follows! {
        set_text(reference: u32, value: &str);
        set_integers(references: &[u32], values: &[i32]);
        set_booleans(references: &[u32], values: &[i32]);
        enter_initialization(start: f64, stop: f64);
    }

    fn get_text(&mut self, reference: u32) -> Result<String, UnitError> {
        if self.follows { Ok(String::new()) } else { self.unit.get_text(reference) }
    }

    fn set_reals(&mut self, references: &[u32], values: &[f64]) -> Result<(), UnitError> {
        let (mut own, mut own_values) = (vec![], vec![]);
        for (&reference, &value) in references.iter().zip(values) {
            match self.references.iter().position(|own| *own == reference) {
                Some(which) => self.motion[which] = value,
                None => {
                    own.push(reference);
                    own_values.push(value);
                }
            }
        }
        match self.follows || own.is_empty() {
            true => Ok(()),
            false => self.unit.set_reals(&own, &own_values),
        }
    }

    fn get_reals(&mut self, references: &[u32], values: &mut [f64]) -> Result<(), UnitError> {
        if !self.follows {
            let got = self.unit.get_reals(references, values);
            self.outcome(got)?;
        }
        if self.follows {
            let given = references.iter().map(|reference| self.value(*reference));
            values.iter_mut().zip(given).for_each(|(value, given)| *value = given);
        }
        Ok(())
    }

    fn get_integers(&mut self, references: &[u32], values: &mut [i32]) -> Result<(), UnitError> {
        values.fill(0);
        let got = if self.follows { Ok(()) } else { self.unit.get_integers(references, values) };
        self.outcome(got)
    }

    fn get_booleans(&mut self, references: &[u32], values: &mut [i32]) -> Result<(), UnitError> {
        values.fill(0);
        let got = if self.follows { Ok(()) } else { self.unit.get_booleans(references, values) };
        self.outcome(got)
    }

    fn exit_initialization(&mut self) -> Result<(), UnitError> {
        self.unit.exit_initialization()?;
        self.note_offsets()
    }

    fn begin_step(&mut self, time: f64, length: f64) -> Result<(), UnitError> {
        (self.steps, self.time) = (true, time);
        let begun = self.unit.begin_step(time, length);
        self.outcome(begun)
    }

    fn step(&mut self, time: f64, length: f64) -> Result<(), UnitError> {
        (self.steps, self.time) = (true, time);
        if self.follows {
            return Ok(());
        }
        let stepped = self.unit.step(time, length);
        self.outcome(stepped)
    }

    fn keeps_states(&self) -> bool {
        self.unit.keeps_states()
    }

    fn save(&mut self) -> Result<Vec<u8>, UnitError> {
        let mut unit = None;
        if !self.follows {
            match self.unit.save() {
                Ok(bytes) => unit = Some(bytes),
                Err(error) => self.outcome(Err(error))?,
            }
        }
        let offset = |(reference, own): (&u32, &Followed)| (*reference, own.offset);
        let saved = Saved {
            unit,
            time: self.time,
            offsets: self.followed.iter().map(offset).collect(),
            warnings: self.warnings.clone(),
        };
        Ok(postcard::to_allocvec(&saved).expect("plain data can always be serialized"))
    }

    fn restore(&mut self, bytes: &[u8]) -> Result<(), UnitError> {
        let saved = postcard::from_bytes(bytes);
        let saved: Saved = saved.map_err(|error| self.differs(&error.to_string()))?;
        for (reference, offset) in saved.offsets {
            if let Some(own) = self.followed.get_mut(&reference) {
                own.offset = offset;
            }
        }
        (self.steps, self.time, self.warnings) = (true, saved.time, saved.warnings);
        self.follows = saved.unit.is_none();
        saved.unit.map_or(Ok(()), |unit| self.unit.restore(&unit))
    }

    /// What fails when all is computed is no reason to call the run a failure.
    fn terminate(&mut self) -> Result<(), UnitError> {
        if self.follows {
            return Ok(());
        }
        if let Err(UnitError { source_file, action, last_message, .. }) = self.unit.terminate() {
            let message = last_message.as_deref().unwrap_or("it failed");
            self.warnings.push(format!("{message} at the end, in {action} ({source_file})"));
        }
        Ok(())
    }

    fn wish_to_end(&self) -> Option<f64> {
        self.unit.wish_to_end()
    }

    fn take_warnings(&mut self) -> Vec<String> {
        let mut warnings = self.unit.take_warnings();
        warnings.append(&mut self.warnings);
        warnings
    }
}
