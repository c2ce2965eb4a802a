//! The library: a folder of rolling-stock files, and vehicles that extend one another.
//!
//! A vehicle file may begin with `extends = "<other vehicle>"`: it then has all of the other's
//! values except those it gives itself, section by section. `without = ["traction"]` leaves
//! sections of the other out.

use std::path::{Path, PathBuf};

use serde::de::DeserializeOwned;
use toml::{Table, Value};

use crate::check::{Check, StockError};
use crate::draft_gear::DraftGear;
use crate::gear_file::GearFile;
use crate::vehicle::Vehicle;

/// Most files in a chain of vehicles that extend one another.
const LONGEST_CHAIN: usize = 8;

/// A folder with the subfolders `vehicles/` and `draft_gears/`.
#[derive(Clone, Debug)]
pub struct Library {
    root: PathBuf,
}

impl Library {
    /// The library in the folder `root`.
    ///
    /// # Errors
    /// When `root` has no subfolder `vehicles`.
    pub fn open(root: impl Into<PathBuf>) -> Result<Self, StockError> {
        let root = root.into();
        match std::fs::metadata(root.join("vehicles")) {
            Ok(_) => Ok(Self { root }),
            Err(source) => {
                Err(StockError::Read { file: root.join("vehicles").display().to_string(), source })
            }
        }
    }

    /// The library a vehicle file belongs to: the folder that holds the file's folder `vehicles`,
    /// otherwise `stock/` beside the file, as in the resources of an FMU.
    ///
    /// # Errors
    /// When there is none.
    pub fn of(file: &Path) -> Result<Self, StockError> {
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
    pub fn vehicle(&self, name: &str) -> Result<Vehicle, StockError> {
        self.vehicle_from_file(&self.vehicle_path(name))
    }

    /// The vehicle type in `file`, which need not lie in the library; what it extends does.
    ///
    /// # Errors
    /// When the file, or one that it extends, cannot be read or has a value that is not possible.
    pub fn vehicle_from_file(&self, file: &Path) -> Result<Vehicle, StockError> {
        let name = file.display().to_string();
        let text = read(file)?;
        let table: Table = parse(&text, &name)?;
        let base = table.get("extends").and_then(Value::as_str).map(str::to_owned);
        let mut vehicle: Vehicle = match table.contains_key("extends") {
            // Reading the text itself gives errors with line and caret.
            false => parse(&text, &name)?,
            true => self
                .extended(table, &name, LONGEST_CHAIN)?
                .try_into()
                .map_err(|source| syntax(&name, source))?,
        };
        let checked = vehicle.check(&name);
        if let Err(error) = checked.and_then(|()| vehicle.find_profiles(&name, &self.root)) {
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
    pub fn draft_gear(&self, name: &str) -> Result<DraftGear, StockError> {
        let file = self.root.join("draft_gears").join(format!("{name}.toml"));
        let name = file.display().to_string();
        parse::<GearFile>(&read(&file)?, &name)?.compile(&name)
    }

    fn vehicle_path(&self, name: &str) -> PathBuf {
        self.root.join("vehicles").join(format!("{name}.toml"))
    }

    /// The table with the values of the vehicle that it extends; `chain` more may follow.
    fn extended(&self, mut own: Table, file: &str, chain: usize) -> Result<Table, StockError> {
        let check = Check::new(file);
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
        let base_file_name = base_file.display().to_string();
        let base = parse(&read(&base_file)?, &base_file_name)?;
        let mut base = self.extended(base, &base_file_name, chain - 1)?;
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

/// Reads a TOML file into the structure that describes it.
///
/// # Errors
/// When the file cannot be read, or does not have this structure.
pub fn read_toml<T: DeserializeOwned>(file: &Path) -> Result<T, StockError> {
    parse(&read(file)?, &file.display().to_string())
}

/// The text of a file.
pub(crate) fn read(file: &Path) -> Result<String, StockError> {
    std::fs::read_to_string(file)
        .map_err(|source| StockError::Read { file: file.display().to_string(), source })
}

/// The content of a file's text; `name` stands in the error message.
pub(crate) fn parse<T: DeserializeOwned>(text: &str, name: &str) -> Result<T, StockError> {
    toml::from_str(text).map_err(|source| syntax(name, source))
}

fn syntax(file: &str, source: toml::de::Error) -> StockError {
    StockError::Syntax { file: file.to_owned(), source: Box::new(source) }
}
