//! A file that a String parameter names, with a default in the FMU's resources.

use std::path::{Path, PathBuf};

use super::table::Variables;
use super::values::{Text, Values};

/// The file that a parameter names; an empty name means a file in the FMU's resources.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ResourceFile {
    /// The value of the parameter.
    pub named: String,
    /// Name of the file in the resources.
    pub default: &'static str,
}

impl ResourceFile {
    /// The file to be read; `resources` is the FMU's folder of that name.
    pub fn path(&self, resources: &Path) -> PathBuf {
        match self.named.as_str() {
            "" => resources.join(self.default),
            named => PathBuf::from(named),
        }
    }
}

/// Handle of a String parameter that names a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FileHandle {
    /// The parameter.
    pub parameter: Text,
    /// Name of the file in the resources that an empty name means.
    pub default: &'static str,
}

impl Variables for ResourceFile {
    type Handles = FileHandle;

    fn read(handle: &FileHandle, values: &Values) -> Self {
        Self { named: values[handle.parameter].clone(), default: handle.default }
    }

    fn write(&self, handle: &FileHandle, values: &mut Values) {
        values[handle.parameter].clone_from(&self.named);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_empty_name_means_the_file_in_the_resources() {
        let mut file = ResourceFile { named: String::new(), default: "track.toml" };
        let resources = Path::new("/fmu/resources");
        assert_eq!(file.path(resources), Path::new("/fmu/resources/track.toml"));
        file.named = "/data/other.toml".to_owned();
        assert_eq!(file.path(resources), Path::new("/data/other.toml"));
    }
}
