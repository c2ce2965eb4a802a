//! What an unpacked FMU has to be run with: binaries for platforms, or sources (FMI 2.0 §2.3).

use std::path::Path;

/// What an FMU has to be run with, without the binary for this platform.
#[derive(Debug)]
pub struct Binaries {
    /// The files in the folder of this platform.
    here: Vec<String>,
    /// The other platforms for which it has binaries.
    elsewhere: Vec<String>,
    /// Whether it has sources.
    sources: bool,
}

impl Binaries {
    /// Those of the FMU that is unpacked in a folder.
    pub fn of(folder: &Path) -> Self {
        let binaries = folder.join("binaries");
        let mut elsewhere = entries(&binaries);
        elsewhere.retain(|platform| {
            platform != PLATFORM && !entries(&binaries.join(platform)).is_empty()
        });
        let here = entries(&binaries.join(PLATFORM));
        Self { here, elsewhere, sources: !entries(&folder.join("sources")).is_empty() }
    }

    /// Whether the FMU is whole, though not for this platform.
    pub fn are_elsewhere(&self) -> bool {
        self.here.is_empty() && (self.sources || !self.elsewhere.is_empty())
    }

    /// What there is, and what can be done.
    pub fn sentence(&self) -> String {
        let Self { here, elsewhere, sources } = self;
        match (here.as_slice(), elsewhere.as_slice(), sources) {
            ([_, ..], ..) => format!(
                "there is {}, but the binary must be named by `modelIdentifier`",
                here.join(", ")
            ),
            ([], [_, ..], _) => format!("it has binaries for {} only", elsewhere.join(", ")),
            ([], [], true) => "it has sources only: compile them to that binary, as the tool that \
                              wrote it or `fmpy compile` does"
                .to_owned(),
            ([], [], false) => "it has neither binaries nor sources".to_owned(),
        }
    }
}

/// Where the binary lies in an FMU on this platform.
pub const PLATFORM: &str = match (cfg!(target_os = "windows"), cfg!(target_os = "macos")) {
    (true, _) => "win64",
    (_, true) => "darwin64",
    _ => "linux64",
};

/// The names in a folder, sorted; none where there is no folder.
fn entries(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let mut names: Vec<_> =
        entries.map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with(files: &[&str]) -> (bool, String) {
        let folder = tempfile::tempdir().unwrap();
        for file in files {
            let file = folder.path().join(file);
            std::fs::create_dir_all(file.parent().unwrap()).unwrap();
            std::fs::write(file, "").unwrap();
        }
        let binaries = Binaries::of(folder.path());
        (binaries.are_elsewhere(), binaries.sentence())
    }

    #[test]
    fn what_an_fmu_has_instead_of_the_binary_is_told() {
        let here = format!("binaries/{PLATFORM}/other.so");
        for (files, elsewhere, wanted) in [
            (
                vec!["binaries/win64/a.dll", "binaries/win32/a.dll", "sources/a.c"],
                true,
                "for win32, win64 only",
            ),
            (vec!["sources/a.c"], true, "has sources only"),
            (vec![here.as_str(), "binaries/win64/a.dll"], false, "there is other.so, but"),
            (vec!["documentation/index.html"], false, "neither binaries nor sources"),
        ] {
            let (found, sentence) = with(&files);
            assert!(found == elsewhere && sentence.contains(wanted), "{files:?}: {sentence}");
        }
    }
}
