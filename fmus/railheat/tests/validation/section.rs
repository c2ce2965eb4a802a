//! The cut section and its modes.

use railheat::contact::Material;
use railheat::section::{Cells, Modes, RailFile};

use validation::Row;

use crate::PAGE;
use crate::energy_common::outline;

/// Area, centroid and second moment of the three sections against the published ones in their
/// files: within the percentages that the files state.
#[test]
fn benchmark_section_properties() {
    for (name, area, centroid, moment) in [
        ("AS60", 0.005, 0.005, 0.005),
        ("60E1", 0.0102, 0.0065, 0.004),
        ("136RE", 0.005, 0.006, 0.0131),
    ] {
        let file = RailFile::open(name).unwrap();
        let found = file.outline().properties();
        let above_foot = file.outline().height() - found.centroid;
        for (what, value, expected, unit, share) in [
            ("area", found.area * 1e6, file.area_mm2, "mm²", area),
            (
                "centroid above the foot",
                above_foot * 1e3,
                file.centroid_above_foot_mm,
                "mm",
                centroid,
            ),
            (
                "second moment",
                found.second_moment * 1e8,
                file.second_moment_mm4 * 1e-4,
                "cm⁴",
                moment,
            ),
        ] {
            Row {
                case: &format!("{what} of {name}"),
                value,
                expected,
                unit,
                source: &format!("published, stock/rails/{name}.toml"),
                tolerance: (share * expected, "radii left open by the source"),
            }
            .holds(&PAGE);
        }
    }
}

/// Whatever the cells, none of the steel and none of the surface is lost.
#[test]
fn property_cut_cells_keep_area_and_surface() {
    for name in ["AS60", "60E1", "136RE"] {
        let outline = outline(name);
        let wanted = outline.properties();
        for cells in [
            Cells::grid(&outline, 0.003),
            Cells::grid(&outline, 0.008),
            Cells::column(&outline, 0.005),
        ] {
            let surface: f64 = cells.facets.iter().map(|facet| facet.length).sum();
            assert!((cells.area() / wanted.area - 1.0).abs() < 1e-9);
            assert!((surface / wanted.perimeter - 1.0).abs() < 1e-6, "{surface} {wanted:?}");
        }
    }
}

/// The even and the odd modes together are all modes of the section: they make up its conductances K + H again, to the
/// rounding of some hundred terms. Odd ones hold no heat and lose none. With a cell on the middle and with none.
#[test]
fn property_even_and_odd_modes_make_up_the_section() {
    for size in [0.009, 0.0075] {
        let cells = Cells::grid(&outline("AS60"), size);
        let surface = vec![15.0; cells.facets.len()];
        let modes = Modes::new(&cells, &Material::PAPER, &surface, size).unwrap();
        let count = cells.cells.len();
        assert_eq!(modes.count, count);
        let mut wanted = vec![vec![0.0; count]; count];
        for link in &cells.links {
            let conductance = Material::PAPER.conductivity * link.ratio;
            let [a, b] = link.cells;
            for (row, column) in [(a, b), (b, a)] {
                wanted[row][row] += conductance;
                wanted[row][column] -= conductance;
            }
        }
        for facet in &cells.facets {
            wanted[facet.cell][facet.cell] += 15.0 * facet.length;
        }
        let capacity = |cell: usize| Material::PAPER.heat_capacity() * cells.cells[cell].area;
        for (row, wanted) in wanted.iter().enumerate() {
            for (column, wanted) in wanted.iter().enumerate() {
                let of_modes = |k: usize| modes.rates[k] * modes.at(row)[k] * modes.at(column)[k];
                let sum = (0..count).map(of_modes).sum::<f64>() * capacity(row) * capacity(column);
                assert!((sum - wanted).abs() < 1e-10 * 40.0, "{row} {column}: {sum}, {wanted}");
            }
        }
        assert!(modes.even >= count / 2 && modes.even_width() < modes.width());
        for k in modes.even..count {
            assert!(modes.content[k].abs() < 1e-11 && modes.loss[k].abs() < 1e-13);
        }
    }
}

/// `docs/reference/section.md`: the slowest mode of an insulated 60E1 section takes 922 s, that of AS60 898 s
/// (approximate outline), with k = 40. The outlines differ from those of that page; 2 %.
/// The result settles as the cells get smaller.
#[test]
fn benchmark_slowest_mode() {
    for (name, wanted) in [("60E1", 922.0), ("AS60", 898.0)] {
        let slowest = [0.012, 0.006, 0.004].map(|size| {
            let cells = Cells::grid(&outline(name), size);
            let insulated = vec![0.0; cells.facets.len()];
            let modes = Modes::new(&cells, &Material::PAPER, &insulated, size).unwrap();
            assert!(modes.rates[0] < 1e-12, "the heat of an insulated section stays");
            1.0 / modes.rates[1]
        });
        println!("{name}: {slowest:.1?} s");
        Row {
            case: &format!("slowest mode of {name}, insulated, cells of 4 mm"),
            value: slowest[2],
            expected: wanted,
            unit: "s",
            source: "stairs of 2 mm, docs/reference/section.md",
            tolerance: (0.02 * wanted, "other outline, and stairs are of first order"),
        }
        .holds(&PAGE);
        assert!((slowest[1] / slowest[2] - 1.0).abs() < 0.005);
    }
}

#[test]
fn wrong_rail_files_are_named() {
    let file = |area: &str, corners: &str| {
        format!(
            "name = \"x\"\nsource = \"x\"\nheight_mm = 172\narea_mm2 = {area}\n\
             centroid_above_foot_mm = 86\nsecond_moment_mm4 = 1\ncorners_mm = [{corners}]"
        )
    };
    for (text, wanted) in [
        (file("6880", "[0, 172, 0], [20, 172, 0], [20, 0, 0]"), "the section is not closed"),
        (file("9000", "[0, 172, 0], [20, 172, 0], [20, 0, 0], [0, 0, 0]"), "enclose 6880 mm2"),
        (
            file("6880", "[0, 172, 0], [20, 172, 50], [20, 0, 0], [0, 0, 0]"),
            "x.toml:7:38: corners_mm[2][3] = 50: the radius in mm does not fit",
        ),
        (
            file("6880", "[0, 172, 0], [20, 180, 0], [20, 0, 0], [0, 0, 0]"),
            "corners_mm[2][2] = 180: is above the crown: must be at most height_mm = 172",
        ),
        (file("6880", ""), "corners_mm: must lead from the crown to the foot"),
    ] {
        let sentence = RailFile::from_toml(&text, "x.toml").unwrap_err().to_string();
        assert!(sentence.contains(wanted) && sentence.contains("x.toml"), "{sentence}");
    }
    let sentence = RailFile::open("/nowhere.toml").unwrap_err().to_string();
    assert!(sentence.contains("AS60, 60E1, 136RE"), "{sentence}");
}
