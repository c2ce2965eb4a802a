//! An unpacked FMU of ours, of which a test changes a file.

use std::path::Path;

use crate::hostile::archive;

/// An unpacked FMU.
pub struct FmuCopy(tempfile::TempDir);

impl FmuCopy {
    /// Unpacks the FMU of a model.
    ///
    /// # Panics
    /// When it has not been packed.
    pub fn of(model: &str) -> Self {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let file = std::fs::File::open(crate::fmu(model)).expect("it is there");
        let mut zip = zip::ZipArchive::new(file).expect("an archive");
        zip.extract(folder.path()).expect("the folder is writable");
        Self(folder)
    }

    /// Text of a file in it.
    ///
    /// # Panics
    /// When there is no such file.
    pub fn text(&self, name: &str) -> String {
        std::fs::read_to_string(self.0.path().join(name)).expect("it is there")
    }

    /// Shows an FMU, in which one of the files is `text`, to `look`.
    ///
    /// # Panics
    /// When it cannot be packed.
    pub fn with<T>(&self, name: &str, text: &str, look: impl FnOnce(&Path) -> T) -> T {
        let mut files = vec![];
        collect(self.0.path(), self.0.path(), &mut files);
        let entries: Vec<(&str, &[u8])> = files
            .iter()
            .map(|(own, bytes)| (own.as_str(), if own == name { text.as_bytes() } else { bytes }))
            .collect();
        let folder = tempfile::tempdir().expect("a temporary folder");
        let fmu = folder.path().join("mutant.fmu");
        archive(&fmu, &entries);
        look(&fmu)
    }
}

/// All files below a folder, with their names in the archive.
fn collect(root: &Path, folder: &Path, files: &mut Vec<(String, Vec<u8>)>) {
    for entry in std::fs::read_dir(folder).expect("it is readable") {
        let path = entry.expect("it is readable").path();
        if path.is_dir() {
            collect(root, &path, files);
        } else {
            let name = path.strip_prefix(root).expect("it lies below").to_string_lossy();
            files.push((name.into_owned(), std::fs::read(&path).expect("it is readable")));
        }
    }
}
