//! Distributed power: remote groups of locomotives with a delay or commands of their own.
//!
//! ```toml
//! [[remote]]
//! group = 1                    # of the consist file
//! delay_s = 1.5                # behind the leading group
//! [[remote.command]]           # left out: the group does what the leading one does
//! from_s = 0.0
//! notch = 4.0
//! ```

use files::{Check, Mistake};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::schedule::{Entry, Schedule};
use super::view::View;
use crate::command::Command;
use crate::history::History;

/// A remote group.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Remote {
    pub(super) group: usize,
    delay: f64,
    own: Option<Schedule>,
}

/// One `[[remote]]` of a driver file.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct RemoteFile {
    /// Number of the group of locomotives, as in the train.
    pub(super) group: usize,
    /// Delay of the radio, s.
    #[serde(default)]
    delay_s: f64,
    /// Commands of its own; left out: it follows the leading ones.
    #[serde(default)]
    command: Vec<Entry>,
}

/// What has gone over the radio.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct RadioState {
    /// Commands of the leading group.
    sent: History<Command>,
    /// For each remote group: changes received, and commands of its own that have come.
    received: Vec<(u64, usize)>,
}

impl RemoteFile {
    pub(super) fn compile(&self, check: &Check) -> Result<Remote, Mistake> {
        check.between("delay_s", self.delay_s, 0.0, 60.0)?;
        if self.group == 0 {
            let wanted = "group 0 is the leading one; remote groups count from 1";
            return Err(check.error("group", self.group, wanted));
        }
        let own = match self.command.is_empty() {
            true => None,
            false => Some(Schedule::compile(&self.command, check)?),
        };
        Ok(Remote { group: self.group, delay: self.delay_s, own })
    }
}

impl RadioState {
    pub(super) fn new(remotes: &[Remote]) -> Self {
        let longest = remotes.iter().map(|remote| remote.delay).fold(0.0, f64::max);
        Self {
            sent: History::new(longest, Command::default()),
            received: vec![(0, 0); remotes.len()],
        }
    }

    /// Sends the command of the leading group; the first one counts as sent long ago.
    pub(super) fn send(&mut self, time: f64, command: Command) {
        let first = self.sent.count() == 1;
        self.sent.note(if first { f64::NEG_INFINITY } else { time }, command, first);
    }
}

impl Remote {
    /// Whether it pulls at some time by commands of its own.
    pub(super) fn pulls(&self) -> bool {
        self.own.as_ref().is_some_and(Schedule::pulls)
    }

    /// The command of the remote group with the index `i`.
    pub(super) fn command(&self, radio: &mut RadioState, i: usize, view: &View) -> Command {
        let (received, reached) = &mut radio.received[i];
        let sending_time = view.time - self.delay;
        if let Some(own) = &self.own {
            return own.command(reached, sending_time, view.chainage);
        }
        while *received + 1 < radio.sent.count()
            && radio.sent.change(*received + 1).0 <= sending_time
        {
            *received += 1;
        }
        radio.sent.change(*received).1
    }
}
