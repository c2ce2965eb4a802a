//! The options of `hotfoot profile`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use contact::{ProfileKind, Reading};

use crate::contact::outline::OutlineOptions;

/// Arguments of `hotfoot profile`.
#[derive(Args)]
pub struct ProfileArguments {
    /// File of points: MiniProf, SIMPACK, GENSYS, or columns
    pub(super) file: PathBuf,
    /// Whose profile it is; left out, the file or its width tells it
    #[arg(long)]
    pub(super) kind: Option<Kind>,
    /// Unit of the lengths, if it is another than the file says
    #[arg(long)]
    pub(super) unit: Option<Unit>,
    #[command(flatten)]
    pub(super) outline: OutlineOptions,
    /// Turn a rail round, so that its other side is that of the gauge
    #[arg(long)]
    pub(super) mirror: bool,
    /// Draw the profile and what smoothing took away into this SVG file
    #[arg(long, value_name = "FILE.svg")]
    pub(super) plot: Option<PathBuf>,
    /// Write the clean profile into this file: two columns in mm, not to be made smooth again
    #[arg(long, value_name = "FILE")]
    pub(super) write: Option<PathBuf>,
}

impl ProfileArguments {
    /// How the file is to be read.
    pub(super) fn reading(&self) -> Reading {
        Reading {
            per_metre: self.unit.map(Unit::per_metre),
            mirrored: self.mirror,
            ..self.outline.reading()
        }
    }
}

/// What a profile belongs to, as an option has it.
#[derive(Clone, Copy, ValueEnum)]
pub(super) enum Kind {
    Wheel,
    Rail,
}

impl From<Kind> for ProfileKind {
    fn from(kind: Kind) -> Self {
        match kind {
            Kind::Wheel => Self::Wheel,
            Kind::Rail => Self::Rail,
        }
    }
}

/// Units of length, as an option has them.
#[derive(Clone, Copy, ValueEnum)]
pub(super) enum Unit {
    Mm,
    Cm,
    M,
    In,
    Um,
}

impl Unit {
    pub(super) const ALL: [Self; 5] = [Self::Mm, Self::Cm, Self::M, Self::In, Self::Um];

    /// How many of them a metre has.
    pub(super) fn per_metre(self) -> f64 {
        match self {
            Self::Mm => 1e3,
            Self::Cm => 100.0,
            Self::M => 1.0,
            Self::In => 1e3 / 25.4,
            Self::Um => 1e6,
        }
    }

    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Mm => "mm",
            Self::Cm => "cm",
            Self::M => "m",
            Self::In => "in",
            Self::Um => "µm",
        }
    }
}
