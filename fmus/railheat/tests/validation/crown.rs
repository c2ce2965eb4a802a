//! The running surface of a crown that is drawn as one straight piece on each side.

use railheat::HeatModel;
use railheat::contact::Wheel;
use railheat::energy::{EnergyModel, Parameters, Resolution};
use railheat::section::{Outline, RailFile};
use railheat::weather::Exchange;

use validation::Row;

use crate::PAGE;
use crate::energy_common::{NIGHT, energy, parameters, slab_of, wheel};

/// Heat of 1 kJ/m by friction in 20 ms, and the time after it.
fn after_an_impulse(
    outline: Outline,
    resolution: Resolution,
    cell_size: f64,
    time: f64,
) -> EnergyModel {
    let base = parameters(outline, resolution, cell_size);
    let mut model = energy(Parameters { interval: 0.02, ..base }, &[1], &NIGHT);
    let standing = Wheel { speed: 0.0, friction_power: 1e4, ..wheel(8.05) };
    model.step(&[standing], &NIGHT, 0.0, 0.02);
    model.step(&[Wheel::default()], &NIGHT, 0.02, time - 0.01);
    model
}

/// V8: the surface of a slab after an impulse, however far the piece's middle lies from that of the crown. Cells of 1 mm
/// are read half a cell deep, where the rise falls by less than 1e-3 of itself.
#[test]
fn analytic_the_surface_of_a_wide_slab() {
    for half_width in [20.0, 40.0] {
        for (time, top) in [(156.0, 2.3088852), (600.0, 1.2075623)] {
            let model = after_an_impulse(slab_of(half_width), Resolution::Column, 0.001, time);
            let mixture = 1e3 / (7850.0 * 450.0 * 0.172 * 2e-3 * half_width);
            let found = model.excess(80, 0) / mixture;
            Row {
                case: &format!(
                    "impulse on a slab of {half_width} mm half width: top after {time} s"
                ),
                value: found,
                expected: top,
                unit: "of the mixture",
                source: "V8, docs/reference/conduction.md",
                tolerance: (1e-3 * top, "read half a cell of 1 mm deep"),
            }
            .holds(&PAGE);
        }
    }
}

/// AS60's height and foot under a head whose right half is one side from the crown to 36 mm.
fn straight_crown() -> Outline {
    let text = "name = \"drawn\"\nsource = \"test\"\nheight_mm = 172\narea_mm2 = 7964\n\
                centroid_above_foot_mm = 80\nsecond_moment_mm4 = 3e7\ncorners_mm = [[0, 172, 0], \
                [36, 170, 0], [36, 130, 0], [8, 121, 0], [8, 29, 0], [75, 11, 0], [75, 0, 0], [0, 0, 0]]";
    RailFile::from_toml(text, "drawn").unwrap().outline()
}

/// Both section models see the same heat in the head: one cell a row has the mean over the row, which the cells
/// over the width have too once the heat has spread over the head.
#[test]
fn property_a_straight_crown_warms_in_both_section_models() {
    let surface = |resolution| {
        let model = after_an_impulse(straight_crown(), resolution, 0.0025, 200.0);
        model.excess(80, 0)
    };
    let (column, plane) = (surface(Resolution::Column), surface(Resolution::Plane));
    println!("column {column:.5} K, 2d {plane:.5} K");
    assert!(plane > 0.01 && (column / plane - 1.0).abs() < 0.1, "{column} against {plane}");
}

/// A foot whose underside rises to both sides lies on no pad, so that a conductance to it has no meaning.
#[test]
fn a_pad_without_an_underside_is_refused() {
    let text = "name = \"keel\"\nsource = \"test\"\nheight_mm = 172\narea_mm2 = 7120\n\
                centroid_above_foot_mm = 86\nsecond_moment_mm4 = 1\n\
                corners_mm = [[0, 172, 0], [25, 172, 0], [25, 59.2, 0], [0, 0, 0]]";
    let outline = RailFile::from_toml(text, "keel").unwrap().outline();
    let base = parameters(outline, Resolution::Column, 0.01);
    let new = |pad: f64| {
        let exchange = Exchange { pad, ..base.exchange };
        EnergyModel::new(Parameters { exchange, ..base.clone() }, &[1], &NIGHT, 0.0)
    };
    assert!(new(0.0).is_ok());
    let sentence = new(20.0).err().unwrap().to_string();
    assert!(sentence.contains("foot.conductance = 20 W/(m2.K)"), "{sentence}");
}
