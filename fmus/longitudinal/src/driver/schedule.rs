//! A schedule of commands by time or chainage.
//!
//! ```toml
//! [[command]]
//! from_s = 0.0                 # holds from this time on
//! notch = 5.0                  # or throttle = 0.625
//! [[command]]
//! from_m = 4200.0              # holds once the leading vehicle's middle has come here
//! dynamic_brake = 0.5          # share of full effort
//! train_brake = 0.3            # 1 is full service, 1.2 emergency
//! locomotive_brake = 0.0       # 1 is full
//! ```
//!
//! The commands hold one after the other: each waits for its own time or chainage, and then
//! for nothing else. What a command does not name is zero.

use files::{Check, Mistake};
use schemars::JsonSchema;
use serde::Deserialize;

use crate::command::{Command, EMERGENCY, HIGHEST_NOTCH};

/// Commands in order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Schedule {
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

/// One `[[command]]` of a driver file.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct Entry {
    /// Time from which it holds, s; instead of `from_m`.
    from_s: Option<f64>,
    /// Chainage of the leading vehicle from which it holds, m; instead of `from_s`.
    from_m: Option<f64>,
    /// Notch, 0 to 8; instead of `throttle`.
    notch: Option<f64>,
    /// Share of the throttle, 0 to 1; instead of `notch`.
    throttle: Option<f64>,
    /// Share of the dynamic brake, 0 to 1.
    #[serde(default)]
    dynamic_brake: f64,
    /// Share of the train brake, 0 to 1.
    #[serde(default)]
    train_brake: f64,
    /// Share of the locomotive brake, 0 to 1.
    #[serde(default)]
    locomotive_brake: f64,
}

impl Schedule {
    /// One command for the whole run.
    pub fn constant(command: Command) -> Self {
        Self { entries: vec![(Begin::Time(f64::NEG_INFINITY), command)] }
    }

    pub(super) fn compile(entries: &[Entry], check: &Check) -> Result<Self, Mistake> {
        let mut compiled: Vec<(Begin, Command)> = Vec::with_capacity(entries.len());
        for (i, entry) in entries.iter().enumerate() {
            let check = check.section(&format!("command[{}]", i + 1));
            let (begin, command) = entry.compile(&check)?;
            let before = compiled.iter().rev().find_map(|(before, _)| before.later_than(&begin));
            if let Some((key, before, own)) = before {
                let wanted = format!("goes back: a command before it waits for {before}");
                return Err(check.error(key, own, wanted));
            }
            compiled.push((begin, command));
        }
        Ok(Self { entries: compiled })
    }

    /// Whether a command has a notch.
    pub(super) fn pulls(&self) -> bool {
        self.entries.iter().any(|(_, command)| command.notch > 0.0)
    }

    /// The command that holds; `reached` is the number of commands whose time or chainage has come.
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

impl Begin {
    /// Key, own value and that of `next` when both are of a kind and this one is later.
    fn later_than(&self, next: &Self) -> Option<(&'static str, f64, f64)> {
        match (self, next) {
            (Self::Time(own), Self::Time(next)) if own > next => Some(("from_s", *own, *next)),
            (Self::Chainage(own), Self::Chainage(next)) if own > next => {
                Some(("from_m", *own, *next))
            }
            _ => None,
        }
    }
}

impl Entry {
    fn compile(&self, check: &Check) -> Result<(Begin, Command), Mistake> {
        let begin = match (self.from_s, self.from_m) {
            (Some(time), None) if time.is_finite() => Begin::Time(time),
            (None, Some(chainage)) if chainage.is_finite() => Begin::Chainage(chainage),
            (None, None) => {
                let what_for = "a command needs either from_s, a time, or from_m, a chainage";
                return Err(check.missing("from_s", what_for));
            }
            (Some(_), Some(_)) => {
                return Err(check.refuse("from_s", "leave either from_s or from_m out"));
            }
            (Some(time), None) => {
                return Err(check.error("from_s", time, "must be a finite time"));
            }
            (None, Some(chainage)) => {
                return Err(check.error("from_m", chainage, "must be a finite chainage"));
            }
        };
        let notch = match (self.notch, self.throttle) {
            (notch, None) => notch.unwrap_or_default(),
            (None, Some(throttle)) => {
                check.share("throttle", throttle, 1.0)?;
                throttle * HIGHEST_NOTCH
            }
            (Some(notch), Some(_)) => {
                return Err(check.error("notch", notch, "leave either notch or throttle out"));
            }
        };
        check.between("notch", notch, 0.0, HIGHEST_NOTCH)?;
        check.share("dynamic_brake", self.dynamic_brake, 1.0)?;
        check.share("train_brake", self.train_brake, EMERGENCY)?;
        check.share("locomotive_brake", self.locomotive_brake, 1.0)?;
        if notch > 0.0 && self.dynamic_brake > 0.0 {
            let wanted = "must be zero in a command with a notch";
            return Err(check.error("dynamic_brake", self.dynamic_brake, wanted));
        }
        let command = Command {
            notch,
            dynamic_brake: self.dynamic_brake,
            train_brake: self.train_brake,
            locomotive_brake: self.locomotive_brake,
        };
        Ok((begin, command))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Deserialize)]
    struct File {
        command: Vec<Entry>,
    }

    fn schedule(text: &str) -> Result<Schedule, Mistake> {
        let document = files::Document::new("driver.toml", text);
        let file: File = document.parse()?;
        Schedule::compile(&file.command, &document.check())
    }

    #[test]
    fn a_schedule_that_goes_back_in_time_is_refused() {
        let text = "command = [{ from_s = 9 }, { from_m = 5 }, { from_s = 8, notch = 1 }]";
        let message = schedule(text).unwrap_err().to_string();
        assert!(message.contains("command[3].from_s = 8: goes back"), "{message}");
    }

    #[test]
    fn commands_hold_from_their_time_or_chainage() {
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
    fn analytic_throttle_is_a_share_of_the_highest_notch() {
        let schedule = schedule("command = [{ from_s = 0, throttle = 0.75 }]").unwrap();
        assert_eq!(schedule.command(&mut 0, 0.0, 0.0).notch, 6.0);
    }

    #[test]
    fn a_notch_that_does_not_exist_is_refused_with_key_and_remedy() {
        let message = schedule("command = [{ from_s = 0, notch = 9 }]").unwrap_err().to_string();
        assert!(
            message.contains("driver.toml:1:34: command[1].notch = 9: must lie between 0 and 8"),
            "{message}"
        );
    }

    #[test]
    fn a_command_without_beginning_is_refused() {
        let message = schedule("command = [{ notch = 1 }]").unwrap_err().to_string();
        assert!(message.contains("command[1].from_s is missing: a command needs either"));
    }
}
