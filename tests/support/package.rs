//! An SSP package of FMUs that misbehave, run by the program: starts in an instant.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use hotfoot::recording::SeriesReader;

use crate::hostile::{Claims, archive, hostile_vehicle};

/// A package of two hostile FMUs in a folder of its own, with a temporary folder beside it.
pub struct HostilePackage {
    /// The folder.
    pub folder: tempfile::TempDir,
}

impl HostilePackage {
    /// A package whose FMUs, the components `a` and `b`, behave as the word of `hostile.c` says.
    ///
    /// # Panics
    /// When it cannot be built.
    pub fn new(behaviour: &str) -> Self {
        let folder = tempfile::tempdir().expect("a temporary folder");
        std::fs::create_dir(folder.path().join("temporary")).expect("the folder is writable");
        let fmu = hostile_vehicle(folder.path(), behaviour, &Claims::default());
        let fmu = std::fs::read(fmu).expect("it was just built");
        let component = |name: &str| {
            format!(
                "<ssd:Component name=\"{name}\" type=\"application/x-fmu-sharedlibrary\" \
                 source=\"resources/hostile.fmu\"><ssd:Connectors><ssd:Connector name=\"position\" \
                 kind=\"output\"><ssc:Real unit=\"m\"/></ssd:Connector></ssd:Connectors>\
                 </ssd:Component>"
            )
        };
        let structure = format!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<ssd:SystemStructureDescription \
             xmlns:ssd=\"http://ssp-standard.org/SSP1/SystemStructureDescription\" \
             xmlns:ssc=\"http://ssp-standard.org/SSP1/SystemStructureCommon\" version=\"1.0\" \
             name=\"hostile\"><ssd:System name=\"hostile\"><ssd:Elements>{}{}</ssd:Elements>\
             </ssd:System></ssd:SystemStructureDescription>\n",
            component("a"),
            component("b")
        );
        let entries: [(&str, &[u8]); 2] =
            [("SystemStructure.ssd", structure.as_bytes()), ("resources/hostile.fmu", &fmu)];
        archive(&folder.path().join("hostile.ssp"), &entries);
        Self { folder }
    }

    /// The program that runs the package for 0.1 s with a record every 0.01 s, with further arguments.
    pub fn command(&self, further: &[&str]) -> Command {
        let run = ["run", "hostile.ssp", "--quiet", "--results", "results", "--interval", "0.01"];
        let duration: &[&str] =
            if further.contains(&"--duration") { &[] } else { &["--duration", "0.1"] };
        self.program(&[&run, duration, further].concat())
    }

    /// The program with these arguments, in the folder and with its temporary folder.
    pub fn program(&self, arguments: &[&str]) -> Command {
        let mut command = crate::command(self.folder.path(), arguments);
        command.env("TMPDIR", self.temporary());
        command
    }

    /// Runs the package.
    ///
    /// # Panics
    /// When the program cannot be started.
    pub fn run(&self, further: &[&str]) -> Output {
        self.command(further).output().expect("the program starts")
    }

    /// Folder of the results.
    pub fn results(&self) -> PathBuf {
        self.folder.path().join("results")
    }

    /// The temporary folder of the runs.
    pub fn temporary(&self) -> PathBuf {
        self.folder.path().join("temporary")
    }

    /// What has been left in the temporary folder.
    ///
    /// # Panics
    /// When it cannot be read.
    pub fn left(&self) -> Vec<PathBuf> {
        let entries = std::fs::read_dir(self.temporary()).expect("it is there");
        entries.map(|entry| entry.expect("readable").path()).collect()
    }
}

/// The times of the records of both components, which must be the same.
///
/// # Panics
/// When they are not, or the results cannot be read.
pub fn times(results: &Path) -> Vec<f64> {
    let times = |table: &str| {
        let table = SeriesReader::open(&results.join("series"), table).expect("it was recorded");
        table.read("time", &[]).expect("readable")
    };
    let (a, b) = (times("a"), times("b"));
    assert_eq!(a, b, "all tables end at the same record");
    a
}
