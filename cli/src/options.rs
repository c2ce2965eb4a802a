//! Options that several commands have.

use std::path::PathBuf;

use clap::Args;
use files::Setting;
use hotfoot::shipped;

/// Keys of the scenario that the command line sets.
#[derive(Args)]
pub struct Settings {
    /// Value of a key of the scenario in place of the file's, such as train.speed_m_per_s=20;
    /// can be given more than once
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub settings: Vec<Setting>,
}

/// Where Hotfoot's own FMUs are.
#[derive(Args)]
pub struct Fmus {
    /// Folder of Hotfoot's own FMUs; left out: `fmus` beside the folder of the program
    #[arg(long)]
    fmus: Option<PathBuf>,
}

impl Fmus {
    /// The folder: `target/fmus` for `target/release/hotfoot` where none is named.
    pub fn folder(&self) -> PathBuf {
        self.fmus.clone().unwrap_or_else(|| shipped::folder("fmus"))
    }
}

/// Whether what is right is told.
#[derive(Args)]
pub struct Quiet {
    /// Print nothing where all is right
    #[arg(long)]
    pub quiet: bool,
}
