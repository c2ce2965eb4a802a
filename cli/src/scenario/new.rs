//! `hotfoot new`: the folder of a new scenario, from one that is shipped.

use std::fs;
use std::path::PathBuf;

use anyhow::{Context, Result, bail};
use clap::{Args, ValueEnum};
use files::{Document, Setting};
use hotfoot::shipped;

use crate::options::Quiet;
use crate::output;

/// Arguments of `hotfoot new`.
#[derive(Args)]
pub struct NewArguments {
    /// Folder that is made, with scenario.toml, track.toml and driver.toml
    #[arg(default_value = "first-look")]
    folder: PathBuf,
    /// Scenario that it begins as
    #[arg(long, value_enum, default_value_t = Template::FirstLook)]
    from: Template,
    /// Folder of the rolling-stock library; left out: `stock` beside the folder of the program
    #[arg(long)]
    stock: Option<PathBuf>,
    #[command(flatten)]
    quiet: Quiet,
}

/// A shipped scenario.
#[derive(Debug, Clone, Copy, ValueEnum)]
enum Template {
    /// Five vehicles in a sharp curve, and whether the foot of the rail warms: some seconds
    FirstLook,
    /// The paper's curve: 130 vehicles and the paper's model of the rail's heat: some minutes
    PaperCurve,
    /// Two locomotives and eight wagons where the rails become wet, one of them on sand
    WetRail,
}

/// The files of a scenario.
macro_rules! shipped {
    ($folder:literal) => {
        [
            (
                "scenario.toml",
                include_str!(concat!("../../../scenarios/", $folder, "/scenario.toml")),
            ),
            ("track.toml", include_str!(concat!("../../../scenarios/", $folder, "/track.toml"))),
            ("driver.toml", include_str!(concat!("../../../scenarios/", $folder, "/driver.toml"))),
        ]
    };
}

impl Template {
    /// Names and texts of its files.
    fn files(self) -> [(&'static str, &'static str); 3] {
        match self {
            Self::FirstLook => shipped!("first-look"),
            Self::PaperCurve => shipped!("curve-increasing-speed"),
            Self::WetRail => shipped!("wet-rail"),
        }
    }
}

/// Makes the folder, and tells what comes next.
///
/// # Errors
/// When it is there already, cannot be written, or there is no rolling stock.
pub fn new(arguments: &NewArguments) -> Result<()> {
    let NewArguments { folder, from, stock, quiet } = arguments;
    let shown = folder.display();
    if folder.exists() {
        bail!("{shown} is there already; name another folder");
    }
    let stock = stock.clone().unwrap_or_else(|| shipped::folder("stock"));
    let stock = fs::canonicalize(&stock).ok().filter(|stock| stock.join("vehicles").is_dir());
    let Some(stock) = stock else {
        bail!(
            "there is no library of rolling stock; name its folder, which holds `vehicles`, by --stock"
        );
    };
    let stock = format!("stock={:?}", stock.display().to_string());
    fs::create_dir_all(folder).with_context(|| format!("{shown} cannot be made"))?;
    for (name, text) in from.files() {
        let mut document = Document::new(name, text);
        if name == "scenario.toml" {
            document = document.with(&[stock.parse::<Setting>().map_err(anyhow::Error::msg)?])?;
        }
        let file = folder.join(name);
        fs::write(&file, document.text()).with_context(|| file.display().to_string())?;
    }
    if quiet.quiet {
        return Ok(());
    }
    output::print(format_args!(
        "{shown} is a scenario of its own now: change scenario.toml, track.toml and driver.toml, and run it by\n  \
         hotfoot run {shown}"
    ))
}
