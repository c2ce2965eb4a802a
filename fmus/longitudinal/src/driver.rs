//! What the driver does, and the file that says it.
//!
//! ```toml
//! initially_applied = true     # the first command has held for long before the run
//! [[command]]
//! from_s = 0.0                 # holds from this time on
//! notch = 5.0
//! [[command]]
//! from_m = 4200.0              # holds once the leading vehicle's middle has come here
//! dynamic_brake = 0.5          # share of full effort
//! train_brake = 0.3            # 1 is full service, 1.2 emergency
//! ```
//!
//! The commands hold one after the other: each waits for its own time or place, and then for
//! nothing else. What a command does not name is zero.

use std::path::Path;

use serde::{Deserialize, Serialize};
use stock::{Check, StockError};

use crate::brake::EMERGENCY;
use crate::traction::HIGHEST_NOTCH;

/// What the driver asks for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Command {
    /// Notch, 0 (idle) to 8; between two notches the drive is between them.
    pub notch: f64,
    /// Dynamic brake as a share of full effort; takes traction away.
    pub dynamic_brake: f64,
    /// Train brake: 1 is full service, 1.2 emergency.
    pub train_brake: f64,
}

impl Command {
    /// The place that the levers of the locomotives go to (see [`crate::lever`]).
    pub fn lever(&self) -> f64 {
        match self.dynamic_brake > 0.0 {
            true => -self.dynamic_brake,
            false => self.notch / HIGHEST_NOTCH,
        }
    }
}

/// Commands in order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Schedule {
    /// Whether the drives and brakes have come to the first command before the run begins.
    pub initially_applied: bool,
    entries: Vec<(Begin, Command)>,
}

/// When a command begins to hold.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Begin {
    /// At a time, s.
    Time(f64),
    /// When the leading vehicle's middle has come to a chainage, m.
    Chainage(f64),
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct DriverFile {
    #[serde(default = "yes")]
    initially_applied: bool,
    #[serde(default)]
    command: Vec<Entry>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Entry {
    from_s: Option<f64>,
    from_m: Option<f64>,
    #[serde(default)]
    notch: f64,
    #[serde(default)]
    dynamic_brake: f64,
    #[serde(default)]
    train_brake: f64,
}

fn yes() -> bool {
    true
}

impl Schedule {
    /// One command for the whole run, applied from the beginning.
    pub fn constant(command: Command) -> Self {
        Self { initially_applied: true, entries: vec![(Begin::Time(f64::NEG_INFINITY), command)] }
    }

    /// Reads a driver file.
    ///
    /// # Errors
    /// When the file cannot be read or a value in it is not possible.
    pub fn from_file(file: &Path) -> Result<Self, StockError> {
        let content: DriverFile = stock::read_toml(file)?;
        let name = file.display().to_string();
        let check = Check::new(&name);
        let entries = content.command.iter().enumerate();
        let entries =
            entries.map(|(i, e)| e.compile(&check.section(&format!("command[{}]", i + 1))));
        Ok(Self {
            initially_applied: content.initially_applied,
            entries: entries.collect::<Result<_, _>>()?,
        })
    }

    /// The command that holds; `reached` is the number of commands whose time or place has come.
    pub fn command(&self, reached: &mut usize, time: f64, chainage: f64) -> Command {
        while let Some((begin, _)) = self.entries.get(*reached) {
            let holds = match begin {
                Begin::Time(begin) => time >= *begin,
                Begin::Chainage(begin) => chainage >= *begin,
            };
            if !holds {
                break;
            }
            *reached += 1;
        }
        match reached.checked_sub(1) {
            None => Command::default(),
            Some(last) => self.entries[last].1,
        }
    }
}

impl Entry {
    fn compile(&self, check: &Check) -> Result<(Begin, Command), StockError> {
        let begin = match (self.from_s, self.from_m) {
            (Some(time), None) if time.is_finite() => Begin::Time(time),
            (None, Some(chainage)) if chainage.is_finite() => Begin::Chainage(chainage),
            (time, _) => {
                let value = time.map_or("none".to_owned(), |time| time.to_string());
                let wanted = "a command needs either from_s, a time, or from_m, a chainage";
                return Err(check.error("from_s", value, wanted));
            }
        };
        check.between("notch", self.notch, 0.0, HIGHEST_NOTCH)?;
        check.between("dynamic_brake", self.dynamic_brake, 0.0, 1.0)?;
        check.between("train_brake", self.train_brake, 0.0, EMERGENCY)?;
        if self.notch > 0.0 && self.dynamic_brake > 0.0 {
            let wanted = "must be zero in a command with a notch";
            return Err(check.error("dynamic_brake", self.dynamic_brake, wanted));
        }
        let command = Command {
            notch: self.notch,
            dynamic_brake: self.dynamic_brake,
            train_brake: self.train_brake,
        };
        Ok((begin, command))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn schedule(text: &str) -> Result<Schedule, StockError> {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("driver.toml");
        std::fs::write(&file, text).unwrap();
        Schedule::from_file(&file)
    }

    #[test]
    fn commands_hold_from_their_time_or_place() {
        let schedule = schedule(
            "command = [{ from_s = 0, notch = 8 }, { from_m = 500, train_brake = 1 },
                        { from_s = 10, dynamic_brake = 0.5 }]",
        )
        .unwrap();
        let mut reached = 0;
        let mut at = |time, chainage| schedule.command(&mut reached, time, chainage);
        assert_eq!(at(-1.0, 0.0), Command::default());
        assert_eq!(at(0.0, 0.0).notch, 8.0);
        assert_eq!(at(20.0, 499.0).notch, 8.0);
        assert_eq!(at(20.0, 500.0).dynamic_brake, 0.5);
        assert_eq!(at(21.0, 0.0).lever(), -0.5);
    }

    #[test]
    fn a_notch_that_does_not_exist_is_refused_with_key_and_remedy() {
        let message = schedule("command = [{ from_s = 0, notch = 9 }]").unwrap_err().to_string();
        assert!(message.contains("driver.toml: command[1].notch = 9: must lie between 0 and 8"));
    }

    #[test]
    fn a_command_without_beginning_is_refused() {
        let message = schedule("command = [{ notch = 1 }]").unwrap_err().to_string();
        assert!(message.contains("command[1].from_s = none: a command needs either"));
    }
}
