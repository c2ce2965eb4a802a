//! The driver file.

use std::path::{Path, PathBuf};

use files::{Check, Document, Mistake};
use schemars::JsonSchema;
use serde::Deserialize;

use super::cruise::{Cruise, Gains, SpeedFile};
use super::fuzzy::{Fuzzy, FuzzyFile};
use super::levers::Levers;
use super::profile::ProfileFile;
use super::remote::RemoteFile;
use super::replay::ReplayFile;
use super::schedule::{Entry, Schedule};
use super::{Driver, Kind};

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct DriverFile {
    /// Whether what is commanded first is in force at the start.
    #[serde(default = "yes")]
    initially_applied: bool,
    /// Commands by time or by chainage.
    #[serde(default)]
    command: Vec<Entry>,
    /// Single levers over time or chainage, before all else.
    #[serde(default)]
    profile: Vec<ProfileFile>,
    /// Commands of remote locomotives.
    #[serde(default)]
    remote: Vec<RemoteFile>,
    /// The speed to keep to.
    speed: Option<SpeedFile>,
    /// A controller that keeps the speed.
    cruise: Option<Gains>,
    /// A driver by fuzzy rules who keeps the speed.
    fuzzy: Option<FuzzyFile>,
    /// How fast the levers are moved.
    #[serde(default)]
    levers: Levers,
    /// What a logger has recorded.
    replay: Option<ReplayFile>,
}

fn yes() -> bool {
    true
}

impl Driver {
    /// The JSON schema of driver files.
    pub fn schema() -> schemars::Schema {
        schemars::schema_for!(DriverFile)
    }

    /// Reads a driver file; the file of a logger lies beside it.
    ///
    /// # Errors
    /// When the file cannot be read or a value in it is not possible.
    pub fn from_file(file: &Path) -> Result<Self, Mistake> {
        Self::from_files(file, &[])
    }

    /// Reads a driver file and the files that it names, which are among `others` or lie beside it.
    ///
    /// # Errors
    /// When a file cannot be read or a value in it is not possible.
    pub fn from_files(file: &Path, others: &[PathBuf]) -> Result<Self, Mistake> {
        let document = Document::read(file)?;
        let content: DriverFile = document.parse()?;
        let check = document.check();
        let folder = file.parent().unwrap_or(Path::new(""));
        let find = |name: &str| {
            let named = others.iter().find(|other| other.file_name() == Some(name.as_ref()));
            named.cloned().unwrap_or_else(|| folder.join(name))
        };
        let numbered = |section: &str, i: usize| check.section(&format!("{section}[{}]", i + 1));
        let profiles = content.profile.iter().enumerate();
        let remotes = content.remote.iter().enumerate();
        Ok(Self {
            initially_applied: content.initially_applied,
            kind: content.kind(&check, &find)?,
            profiles: profiles
                .map(|(i, profile)| profile.compile(&numbered("profile", i)))
                .collect::<Result<_, _>>()?,
            remotes: remotes
                .map(|(i, remote)| remote.compile(&numbered("remote", i)))
                .collect::<Result<_, _>>()?,
        })
    }
}

/// A mistake in a remote group of a driver file, if the groups of the train, from 0, lack it.
///
/// # Errors
/// When the file cannot be read, or names such a group.
pub fn check_groups(file: &Path, groups: &[usize]) -> Result<(), Mistake> {
    let document = Document::read(file)?;
    let content: DriverFile = document.parse()?;
    for (i, remote) in content.remote.iter().enumerate() {
        let listed = groups.iter().map(usize::to_string).collect::<Vec<_>>().join(", ");
        let wanted = format!(
            "no vehicle of the train has this group, but only {listed}; give it to the remote locomotives by \
             train.vehicles[..].group"
        );
        let known = groups.contains(&remote.group);
        document.check().element("remote", i).ensure(known, "group", remote.group, &wanted)?;
    }
    Ok(())
}

impl DriverFile {
    fn kind(&self, check: &Check, find: &dyn Fn(&str) -> PathBuf) -> Result<Kind, Mistake> {
        let sections = [
            ("command", !self.command.is_empty()),
            ("cruise", self.cruise.is_some()),
            ("fuzzy", self.fuzzy.is_some()),
            ("replay", self.replay.is_some()),
        ];
        let given: Vec<&str> = sections.iter().filter(|s| s.1).map(|s| s.0).collect();
        if let [first, second, ..] = given[..] {
            let wanted = format!("a driver is of one kind; leave it or {first} out");
            return Err(check.refuse(second, wanted));
        }
        let levers = &check.section("levers");
        self.levers.check(levers)?;
        let speed = || match &self.speed {
            Some(speed) => speed.compile(&check.section("speed")),
            None => {
                Err(check.missing("speed", "this driver needs [speed] with the speed to keep to"))
            }
        };
        let levers = self.levers.clone();
        if let Some(gains) = &self.cruise {
            gains.check(&check.section("cruise"))?;
            return Ok(Kind::Cruise(Cruise { gains: gains.clone(), speed: speed()?, levers }));
        }
        if let Some(rules) = &self.fuzzy {
            rules.check(&check.section("fuzzy"))?;
            return Ok(Kind::Fuzzy(Fuzzy { rules: rules.clone(), speed: speed()?, levers }));
        }
        if let Some(replay) = &self.replay {
            return Ok(Kind::Replay(
                replay.compile(&check.section("replay"), &find(&replay.file))?,
            ));
        }
        Ok(Kind::Schedule(Schedule::compile(&self.command, check)?))
    }
}
