//! The library: a folder of rolling-stock files, and vehicles that extend one another.
//!
//! A vehicle file may begin with `extends = "<other vehicle>"`: it then has all of the other's
//! values except those it gives itself, section by section. `without = ["traction"]` leaves
//! sections of the other out.

use std::path::{Path, PathBuf};

use files::{Document, Mistake, did_you_mean};
use toml::{Table, Value};

use crate::draft_gear::{DraftGear, GearFile};
use crate::vehicle::Vehicle;

/// Most files in a chain of vehicles that extend one another.
const LONGEST_CHAIN: usize = 8;

/// A folder with the subfolders `vehicles/` and `draft_gears/`.
#[derive(Clone, Debug)]
pub struct Library {
    root: PathBuf,
}

impl Library {
    /// The JSON schema of draft-gear files.
    pub fn draft_gear_schema() -> schemars::Schema {
        schemars::schema_for!(GearFile)
    }

    /// The library in the folder `root`.
    ///
    /// # Errors
    /// When `root` has no subfolder `vehicles`.
    pub fn open(root: impl Into<PathBuf>) -> Result<Self, Mistake> {
        let root = root.into();
        match root.join("vehicles").is_dir() {
            true => Ok(Self { root }),
            false => Err(Mistake::in_file(
                root.display(),
                "is no rolling-stock library: it has no folder `vehicles`",
            )),
        }
    }

    /// The library that a vehicle file belongs to.
    ///
    /// It is the folder that holds the file's folder `vehicles`, otherwise `stock/` beside the file, as
    /// in the resources of an FMU.
    ///
    /// # Errors
    /// When there is none.
    pub fn of(file: &Path) -> Result<Self, Mistake> {
        let folder = file.parent().unwrap_or(Path::new(""));
        match folder.file_name() {
            Some(name) if name == "vehicles" => Self::open(folder.join("..")),
            _ => Self::open(folder.join("stock")),
        }
    }

    /// The vehicle type `name`. Names of profiles that are files become paths from the library's
    /// folder.
    ///
    /// # Errors
    /// When its file, or one that it extends, cannot be read or has a value that is not possible.
    pub fn vehicle(&self, name: &str) -> Result<Vehicle, Mistake> {
        self.vehicle_from_file(&self.vehicle_path(name))
    }

    /// The vehicle type in `file`, which need not lie in the library; what it extends does.
    ///
    /// # Errors
    /// When the file, or one that it extends, cannot be read or has a value that is not possible.
    pub fn vehicle_from_file(&self, file: &Path) -> Result<Vehicle, Mistake> {
        let document = Document::read(file)?;
        let table: Table = document.parse()?;
        let base = table.get("extends").and_then(Value::as_str).map(str::to_owned);
        let mut vehicle: Vehicle = match table.contains_key("extends") {
            false => document.parse()?,
            true => document.parse_table(&self.extended(table, &document, LONGEST_CHAIN)?)?,
        };
        let check = document.check();
        let checked = vehicle.check(&check);
        if let Err(error) = checked.and_then(|()| vehicle.find_profiles(&check, &self.root)) {
            // A wrong value is looked for in the file that has it.
            let base_error = base.and_then(|base| self.vehicle(&base).err());
            return Err(base_error.unwrap_or(error));
        }
        Ok(vehicle)
    }

    /// The draft gear `name`.
    ///
    /// # Errors
    /// When its file cannot be read or has a value that is not possible.
    pub fn draft_gear(&self, name: &str) -> Result<DraftGear, Mistake> {
        let file = self.draft_gear_path(name);
        let document = Document::read(&file)?;
        document.parse::<GearFile>()?.compile(&document.check())
    }

    /// The draft gears at the front and the rear of the vehicle in `file`.
    ///
    /// # Errors
    /// When there is no such draft gear, or its file has a value that is not possible.
    pub fn draft_gears_of(
        &self,
        file: &Path,
        vehicle: &Vehicle,
    ) -> Result<[DraftGear; 2], Mistake> {
        let gear = |key: &str, gear: &str| {
            let folder = self.root.join("draft_gears");
            if folder.join(format!("{gear}.toml")).is_file() {
                return self.draft_gear(gear);
            }
            let known = names(&folder);
            let meant = did_you_mean(gear, known.iter().map(String::as_str));
            let wanted =
                format!("there is no draft gear of this name in {}{meant}", folder.display());
            let document = Document::read(file)?;
            Err(document.check().error(key, format!("\"{gear}\""), wanted))
        };
        let coupler = &vehicle.coupler;
        let rear = match coupler.rear {
            Some(_) => "coupler.rear.draft_gear",
            None => "coupler.draft_gear",
        };
        Ok([
            gear("coupler.draft_gear", &coupler.draft_gear)?,
            gear(rear, coupler.rear_draft_gear())?,
        ])
    }

    /// The names of all vehicle types in order.
    pub fn vehicle_names(&self) -> Vec<String> {
        names(&self.root.join("vehicles"))
    }

    /// The names of all draft gears in order.
    pub fn draft_gear_names(&self) -> Vec<String> {
        names(&self.root.join("draft_gears"))
    }

    /// The file of the draft gear `name`.
    pub fn draft_gear_path(&self, name: &str) -> PathBuf {
        self.root.join("draft_gears").join(format!("{name}.toml"))
    }

    /// The file of the vehicle type `name`.
    pub fn vehicle_path(&self, name: &str) -> PathBuf {
        self.root.join("vehicles").join(format!("{name}.toml"))
    }

    /// The table with the values of the vehicle that it extends; `chain` more may follow.
    fn extended(
        &self,
        mut own: Table,
        document: &Document,
        chain: usize,
    ) -> Result<Table, Mistake> {
        let check = document.check();
        let Some(extends) = own.remove("extends") else {
            return Ok(own);
        };
        let Value::String(base_name) = &extends else {
            return Err(check.error(
                "extends",
                extends,
                "must be the name of a vehicle, in quotes",
            ));
        };
        if chain == 0 {
            let wanted = format!(
                "more than {LONGEST_CHAIN} files extend one another; a vehicle must not extend itself"
            );
            return Err(check.error("extends", extends, wanted));
        }
        let without = own.remove("without").unwrap_or(Value::Array(vec![]));
        let base_file = self.vehicle_path(base_name);
        if !base_file.is_file() {
            let meant = did_you_mean(base_name, self.vehicle_names().iter().map(String::as_str));
            let wanted = format!("there is no vehicle of this name in the library{meant}");
            return Err(check.error("extends", extends, wanted));
        }
        let base = Document::read(&base_file)?;
        let mut base = self.extended(base.parse()?, &base, chain - 1)?;
        let Value::Array(without) = without else {
            return Err(check.error("without", without, "must be a list of names in brackets"));
        };
        for section in without {
            if section.as_str().and_then(|name| base.remove(name)).is_none() {
                let keys: Vec<&str> = base.keys().map(String::as_str).collect();
                let wanted = format!("{base_name} has only {}", keys.join(", "));
                return Err(check.error("without", section, wanted));
            }
        }
        merge(&mut base, own);
        Ok(base)
    }
}

/// The names of the TOML files in a folder, in order.
fn names(folder: &Path) -> Vec<String> {
    let files = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let stem = |file: std::fs::DirEntry| {
        Some(file.file_name().to_str()?.strip_suffix(".toml")?.to_owned())
    };
    let mut names: Vec<String> = files.filter_map(stem).collect();
    names.sort();
    names
}

/// Puts `own` over `base`, table by table.
fn merge(base: &mut Table, own: Table) {
    for (key, value) in own {
        match (base.get_mut(&key), value) {
            (Some(Value::Table(below)), Value::Table(above)) => merge(below, above),
            (_, value) => {
                base.insert(key, value);
            }
        }
    }
}
