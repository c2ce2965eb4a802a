//! What the tests of the whole system share: where things are, small scenarios, and the program.

pub mod fmu_copy;
pub mod hostile;
pub mod killed;
pub mod package;
pub mod probe;

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use validation::Page;

/// The page that has the table of comparisons of the whole system.
pub const PAGE: Page = Page {
    path: "docs/validation/README.md",
    text: include_str!("../../docs/validation/README.md"),
};

/// Root of the repository.
pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("tests lie in the repository")
}

/// The release folder of cargo's target folder, in which this test runs too.
fn release() -> PathBuf {
    let test = std::env::current_exe().expect("a test has a path");
    test.ancestors().nth(3).expect("target/release/deps/test").join("release")
}

/// The packed FMU of a model.
///
/// # Panics
/// When it has not been packed.
pub fn fmu(model: &str) -> PathBuf {
    let path = release().with_file_name("fmus").join(format!("{model}.fmu"));
    assert!(path.exists(), "{} is missing: run `cargo xtask fmus` first", path.display());
    path
}

/// The shared library of an example.
///
/// # Panics
/// When it has not been built.
pub fn library(package: &str) -> PathBuf {
    let file = format!("{}{package}{}", std::env::consts::DLL_PREFIX, std::env::consts::DLL_SUFFIX);
    let path = release().join(file);
    assert!(
        path.exists(),
        "{} is missing: run `cargo build --release --workspace`",
        path.display()
    );
    path
}

/// Runs the program `hotfoot` with these arguments in `folder`.
///
/// # Panics
/// When the program has not been built.
pub fn hotfoot(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = command(folder, arguments);
    let output = command.output();
    output.unwrap_or_else(|e| {
        panic!("{:?}: {e}: run `cargo xtask fmus` first", command.get_program())
    })
}

/// The program `hotfoot`: that of the release, or the one that `HOTFOOT_PROGRAM` names in the environment.
pub fn program() -> PathBuf {
    let stated = std::env::var_os("HOTFOOT_PROGRAM");
    stated.map_or_else(|| release().join("hotfoot"), PathBuf::from)
}

/// The program `hotfoot` with these arguments in `folder`.
pub fn command(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(program());
    command.args(arguments).current_dir(folder);
    command
}

/// A scenario of a short train in a folder of its own; its text may be changed before it is run.
pub struct SmallScenario {
    /// The folder, which goes when this goes.
    pub folder: tempfile::TempDir,
    /// Text of `scenario.toml`.
    pub text: String,
    /// Text of `track.toml`.
    pub track: String,
    /// Text of `driver.toml`.
    pub driver: String,
}

impl SmallScenario {
    /// The train of `tests/five-vehicles` for `duration` seconds: one locomotive and four wagons
    /// at 16.67 m/s in notch 7 on the track of the paper's curve, which begins 20 m ahead of the
    /// leading vehicle.
    ///
    /// # Panics
    /// When the files cannot be read or the temporary folder cannot be made.
    pub fn new(duration: f64) -> Self {
        let file = |name: &str| {
            let path = root().join("tests/five-vehicles").join(name);
            std::fs::read_to_string(path).expect("the scenario of five vehicles is there")
        };
        let stock = root().join("stock").display().to_string();
        let text = file("scenario.toml")
            .replace("duration_s = 2.0", &format!("duration_s = {duration:?}"))
            .replace("../../stock", &stock);
        Self {
            folder: tempfile::tempdir().expect("a temporary folder"),
            text,
            track: file("track.toml"),
            driver: file("driver.toml"),
        }
    }

    /// Its locomotive and one wagon on a rail of 60 m that conserves heat, with further `keys` of the
    /// section `[heat]` and `parameters` of the rail, for `duration` seconds.
    ///
    /// # Panics
    /// As [`Self::new`].
    pub fn heating_a_short_rail(duration: f64, keys: &str, parameters: &str) -> Self {
        let mut scenario = Self::new(duration);
        scenario.text = scenario.text.replace("count = 4", "count = 1");
        scenario.leave_out_heat();
        scenario.text += &format!(
            "[heat]\nmodel = \"energy\"\nstep_s = 0.02\nbegin_m = 0.0\nlength_m = 60.0\n{keys}\n\
             [heat.parameters]\n\"section.cell_size\" = 0.012\n{parameters}\n"
        );
        scenario
    }

    /// Cuts the text off where its last sections, those of the rail's heat, begin.
    ///
    /// # Panics
    /// When the scenario heats no rail.
    pub fn leave_out_heat(&mut self) {
        let heat = self.text.find("[heat]").expect("the scenario heats a rail");
        self.text.truncate(heat);
    }

    /// The arguments of a run.
    const RUN: [&'static str; 6] =
        ["run", "scenario.toml", "--quiet", "--results", "results", "--overwrite"];

    /// Writes the files and gives the program that runs the scenario with further arguments.
    ///
    /// # Panics
    /// When the files cannot be written.
    pub fn command(&self, arguments: &[&str]) -> Command {
        self.write();
        command(self.folder.path(), &[&Self::RUN, arguments].concat())
    }

    /// Writes the files and runs the scenario with further arguments; the results are in
    /// [`Self::results`].
    ///
    /// # Panics
    /// When the files cannot be written.
    pub fn run(&self, arguments: &[&str]) -> Output {
        let mut all = Self::RUN.to_vec();
        all.extend(arguments);
        self.hotfoot(&all)
    }

    /// Writes the files and runs the program in their folder.
    ///
    /// # Panics
    /// When the files cannot be written.
    pub fn hotfoot(&self, arguments: &[&str]) -> Output {
        self.write();
        hotfoot(self.folder.path(), arguments)
    }

    /// Runs the scenario, which must succeed.
    ///
    /// # Panics
    /// When it does not, with what the program said.
    pub fn run_well(&self, arguments: &[&str]) {
        let output = self.run(arguments);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    }

    /// Folder of the results.
    pub fn results(&self) -> PathBuf {
        self.folder.path().join("results")
    }

    /// Writes the files.
    ///
    /// # Panics
    /// When they cannot be written.
    pub fn write(&self) {
        let files = [
            ("scenario.toml", &self.text),
            ("track.toml", &self.track),
            ("driver.toml", &self.driver),
        ];
        for (name, text) in files {
            std::fs::write(self.folder.path().join(name), text).expect("the folder is writable");
        }
    }
}

/// The default resources of a model with the stock library, as `cargo xtask fmus` packs them.
///
/// # Panics
/// When they cannot be copied.
pub fn resources(model: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    copy_folder(&root().join("fmus").join(model).join("resources"), folder.path());
    copy_folder(&root().join("stock"), &folder.path().join("stock"));
    folder
}

/// Copies a folder with all that is in it.
///
/// # Panics
/// When it cannot be copied.
pub fn copy_folder(from: &Path, to: &Path) {
    std::fs::create_dir_all(to).expect("the target is writable");
    for entry in std::fs::read_dir(from).expect("the source is readable") {
        let path = entry.expect("the source is readable").path();
        let target = to.join(path.file_name().expect("an entry has a name"));
        if path.is_dir() {
            copy_folder(&path, &target);
        } else {
            std::fs::copy(&path, &target).expect("the target is writable");
        }
    }
}
