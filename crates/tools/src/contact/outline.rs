//! The options of how outlines are read from files of points, and where gauge and running circle are.

use clap::Args;
use contact::{ProfilePair, Reading};

use crate::number::{not_negative, positive};

/// A millimetre, in m.
pub(super) const MM: f64 = 1e-3;

/// Options of the commands that read outlines.
#[derive(Args)]
pub(super) struct OutlineOptions {
    /// Depth below the top of the rail to which the gauge is measured, mm; 15.875 in North America
    #[arg(long, default_value_t = ProfilePair::GAUGE_DEPTH / MM, value_parser = positive)]
    pub gauge_depth_mm: f64,
    /// Distance of the running circle from the flange back, mm
    #[arg(long, default_value_t = Reading::RUNNING_CIRCLE / MM, value_parser = positive)]
    pub running_circle_mm: f64,
    /// Wavelength to which outlines from files of points are made smooth, mm; 0 leaves them as they are
    #[arg(long, default_value_t = Reading::WAVELENGTH / MM, value_parser = not_negative)]
    smoothing_mm: f64,
}

impl OutlineOptions {
    /// How a file is to be read, in its own unit.
    pub fn reading(&self) -> Reading {
        Reading {
            running_circle: self.running_circle_mm * MM,
            wavelength: self.smoothing_mm * MM,
            ..Reading::default()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;
    use stock::Library;

    /// A vehicle file that says nothing of them has the values that the commands have.
    #[test]
    fn vehicle_files_have_the_same_defaults() {
        let folder = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../stock"));
        let vehicle = Library::open(folder).unwrap().vehicle("wagon-ore-40t").unwrap();
        let contact = vehicle.multibody.unwrap().contact;
        let found =
            [contact.gauge_depth_mm, contact.running_circle_mm, contact.profile_smoothing_mm];
        let wanted = [ProfilePair::GAUGE_DEPTH, Reading::RUNNING_CIRCLE, Reading::WAVELENGTH];
        assert_eq!(found, wanted.map(|length| length / MM));
    }
}
