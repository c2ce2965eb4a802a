//! The rise of the whole section at some places.

use std::f64::consts::PI;

use railheat::HeatModel;
use railheat::contact::{Material, Wheel};
use railheat::energy::{EnergyModel, Parameters, Resolution};
use railheat::line::Line;
use railheat::section::Cell;
use railheat::weather::Weather;

use crate::common::SPEED;
use crate::energy_common::{
    DAY, NIGHT, all_effects, energy, outline, parameters, run, slab, wheel,
};

/// The element whose section is kept, in the middle of the rail.
const PLACE: usize = 100;

/// Two vehicles, the wheels of which touch the rail so far to the field side, in m.
fn train(lateral: f64) -> impl Fn(f64) -> Vec<Wheel> {
    move |time| {
        let at = |offset| Wheel { lateral_position: lateral, ..wheel(SPEED * time + 8.0 - offset) };
        [0.0, 1.8, 20.0, 21.8].map(at).to_vec()
    }
}

/// A model that keeps the section, after a train and `rest` s.
fn after_train(parameters: Parameters, lateral: f64, is_right: bool, rest: u32) -> EnergyModel {
    let mut model = energy(parameters, &[2, 2], &NIGHT);
    model.keep_sections(&[PLACE], is_right);
    run(&mut model, &DAY, train(lateral), 0.0, 300, 0.01);
    run(&mut model, &DAY, |_| vec![Wheel::default(); 4], 3.0, rest, 1.0);
    model
}

fn cells(model: &EnergyModel) -> Vec<Cell> {
    model.kept_sections().unwrap().cells.to_vec()
}

/// Heat above the initial state by the section, J/m.
fn heat(model: &EnergyModel) -> f64 {
    let capacity = Material::PAPER.heat_capacity();
    let of_cells = cells(model).into_iter().zip(model.section_rises());
    of_cells.map(|(cell, rise)| capacity * cell.area * rise).sum()
}

/// The rise on the middle line of a section in a row of its cells.
fn on_middle_line(cells: &[Cell], rises: &[f64], row: usize) -> f64 {
    let in_row = || cells.iter().zip(rises).filter(move |(cell, _)| cell.row == row);
    let nearest = in_row().map(|(cell, _)| cell.middle.y.abs()).fold(f64::INFINITY, f64::min);
    let middle: Vec<f64> = in_row()
        .filter(|(cell, _)| cell.middle.y.abs() < nearest + 1e-9)
        .map(|(_, rise)| *rise)
        .collect();
    middle.iter().sum::<f64>() / middle.len() as f64
}

/// The largest difference between the section's middle line and what is read of the element, over the
/// element's largest reading.
fn off_middle_line(model: &EnergyModel) -> f64 {
    let rows = model.depths().len();
    let mut read = vec![0.0_f32; rows * model.line().elements];
    model.snapshot(&mut read);
    let read = &read[PLACE * rows..][..rows];
    let (cells, rises) = (cells(model), model.section_rises());
    let of_row = |row: usize| on_middle_line(&cells, &rises, row);
    let off = read.iter().enumerate().map(|(row, rise)| (f64::from(*rise) - of_row(row)).abs());
    let largest = read.iter().fold(0.0_f32, |largest, rise| largest.max(rise.abs()));
    off.fold(0.0, f64::max) / f64::from(largest)
}

/// With all effects on and a contact aside, the section's middle line is what is read of its element, and
/// its heat is the element's. Readings are in single precision: 1e-7. Where fast modes follow in the
/// element, it differs by what that leaves out, 0.7 % of what such modes had: most while heat comes in,
/// less than 1e-4 of the crown's rise once a few seconds have passed.
#[test]
fn property_a_section_has_its_elements_middle_line_and_heat() {
    let base = || all_effects(outline("60E1"), Resolution::Plane);
    for (shortest, rest, allowed) in [(0.0, 0, 1e-6), (0.0, 60, 1e-6), (0.2, 5, 1e-4)] {
        let parameters = Parameters { shortest, ..base() };
        let model = after_train(parameters, 0.012, true, rest);
        let off = off_middle_line(&model);
        let (own, element) = (heat(&model), model.heat_per_metre(PLACE));
        println!(
            "shortest {shortest}, {rest} s: middle line {off:.1e}, heat {own} of {element} J/m"
        );
        assert!(off < allowed, "{off} with {shortest} s after {rest} s");
        let slack = if shortest > 0.0 { 1e-3 } else { 1e-9 };
        assert!((own / element - 1.0).abs() < slack, "{own} of {element} J/m");
    }
}

/// Sections of rails without sun whose contacts lie on opposite sides are each other's mirror image, and
/// the side of the contact is the warmer one: to the right by day on the right rail, for a contact on the
/// field side. To rounding: 1e-12 of the largest rise.
#[test]
fn property_a_mirrored_contact_gives_the_mirrored_section() {
    let base = || parameters(outline("AS60"), Resolution::Plane, 0.008);
    let rises = |lateral, is_right| {
        let model = after_train(base(), lateral, is_right, 3);
        (cells(&model), model.section_rises())
    };
    let (cells, field) = rises(0.015, true);
    for other in [rises(-0.015, true).1, rises(0.015, false).1] {
        let largest = field.iter().copied().fold(0.0, f64::max);
        for (cell, rise) in cells.iter().zip(&field) {
            let mirrored = cells.iter().position(|other| {
                (other.middle.y + cell.middle.y).abs() < 1e-9
                    && (other.middle.z - cell.middle.z).abs() < 1e-9
            });
            let opposite = other[mirrored.expect("the section is symmetric")];
            assert!((rise - opposite).abs() < 1e-12 * largest, "{rise} {opposite} at {cell:?}");
        }
    }
    let side = |sign: f64| -> f64 {
        let of_side = cells.iter().zip(&field).filter(|(cell, _)| sign * cell.middle.y > 1e-3);
        of_side.map(|(cell, rise)| cell.area * rise).sum()
    };
    assert!(side(1.0) > 1.5 * side(-1.0), "{} {}", side(1.0), side(-1.0));
}

/// An insulated slab of the width w = 40 mm, heated by 50 J/m at y = 8 mm over b = 6.3 mm: what lies
/// on one side more than on the other, in the shape sin(πy/w), is
///
/// ```text
/// E sin(πy/w) 3(sin κ - κ cos κ)/κ³ e^(-rt),   κ = πb/w,   r = α (4/h²) sin²(πh/2w)
/// ```
///
/// The shape is one of the grid's too, whose rate r is that of cells of h = 4 mm, 0.8 % less than α(π/w)²: it is met to
/// rounding. The band on such cells is 1 % off. No heat is lost meanwhile, and in four hours it is
/// mixed: E/(ρ c A) everywhere.
#[test]
fn analytic_a_section_evens_out_across_the_rail() {
    let mut model = energy(parameters(slab(), Resolution::Plane, 0.004), &[1], &NIGHT);
    model.keep_sections(&[PLACE], true);
    let at = |time: f64| vec![Wheel { lateral_position: 0.008, ..wheel(2.0 + SPEED * time) }];
    run(&mut model, &NIGHT, at, 0.0, 10, 0.1);
    let (width, band, cell) = (0.04, 0.0063, 0.004);
    let sine = (0.5 * PI * cell / width).sin();
    let rate = Material::PAPER.diffusivity() * (2.0 * sine / cell).powi(2);
    let kappa = PI * band / width;
    let shape = 3.0 * (kappa.sin() - kappa * kappa.cos()) / kappa.powi(3);
    // Heat came in evenly over the first second.
    let gain = -(-rate).exp_m1() / rate;
    let wanted = 50.0 * (PI * 0.008 / width).sin() * shape * gain;
    let odd = |model: &EnergyModel| -> f64 {
        let capacity = Material::PAPER.heat_capacity();
        let of_cells = cells(model).into_iter().zip(model.section_rises());
        let odd =
            of_cells.map(|(cell, rise)| cell.area * rise * (PI * cell.middle.y / width).sin());
        capacity * odd.sum::<f64>()
    };
    let first = odd(&model);
    println!("{first:.5} of {wanted:.5} J/m");
    assert!((first / wanted - 1.0).abs() < 0.015, "{first} of {wanted} J/m");
    let mut time = 1.0;
    for steps in [10, 20] {
        run(&mut model, &NIGHT, |_| vec![Wheel::default()], time, steps, 1.0);
        time += f64::from(steps);
        let (found, wanted) = (odd(&model), first * (-rate * (time - 1.0)).exp());
        println!("{time} s: {:.1e} off", found / wanted - 1.0);
        assert!((found / wanted - 1.0).abs() < 1e-9, "{time} s: {found} of {wanted} J/m");
        assert!((heat(&model) / 50.0 - 1.0).abs() < 1e-9, "{} J/m", heat(&model));
    }
    run(&mut model, &NIGHT, |_| vec![Wheel::default()], 31.0, 240, 60.0);
    let mixture = 50.0 / (Material::PAPER.heat_capacity() * 0.04 * 0.172);
    for rise in model.section_rises() {
        assert!((rise / mixture - 1.0).abs() < 1e-6, "{rise} of {mixture} K");
    }
}

/// A wheel burn with conduction along the track: the section there, aside as it was heated, still has the
/// middle line of its element, to single precision, and a part as large on one side as without a
/// neighbour would be too much: it has flowed away with the rest.
#[test]
fn property_heat_flows_along_the_track_in_all_modes() {
    let side = |conducts_along: bool| {
        let base = parameters(outline("60E1"), Resolution::Plane, 0.012);
        let line = Line { begin: 0.0, element_length: 0.02, elements: 200 };
        let mut model =
            energy(Parameters { line, conducts_along, shortest: 0.0, ..base }, &[1], &NIGHT);
        model.keep_sections(&[PLACE], true);
        let spinning = Wheel {
            speed: 0.0,
            friction_power: 10e3,
            lateral_position: 0.02,
            ..wheel(0.02 * PLACE as f64 + 0.01)
        };
        run(&mut model, &NIGHT, |_| vec![spinning], 0.0, 1, 1.0);
        run(&mut model, &NIGHT, |_| vec![Wheel::default()], 1.0, 60, 1.0);
        let off = off_middle_line(&model);
        assert!(off < 1e-6, "{off}");
        let (own, element) = (heat(&model), model.heat_per_metre(PLACE));
        assert!((own / element - 1.0).abs() < 1e-6, "{own} of {element} J/m");
        let of_cells = cells(&model).into_iter().zip(model.section_rises());
        let uneven: f64 = of_cells.map(|(cell, rise)| cell.area * rise * cell.middle.y).sum();
        uneven / element
    };
    let (alone, along) = (side(false), side(true));
    // What lies aside decays across the rail as fast as without neighbours.
    assert!(alone > 0.0 && (along / alone - 1.0).abs() < 1e-3, "{along} of {alone}");
}

/// The elements themselves do not know that a section is kept.
#[test]
fn property_a_section_that_is_kept_changes_no_element() {
    let base = || all_effects(outline("60E1"), Resolution::Plane);
    let kept = after_train(base(), 0.01, true, 5);
    let mut without = energy(base(), &[2, 2], &NIGHT);
    run(&mut without, &DAY, train(0.01), 0.0, 300, 0.01);
    run(&mut without, &DAY, |_| vec![Wheel::default(); 4], 3.0, 5, 1.0);
    assert!(without.kept_sections().is_none());
    for element in 0..200 {
        for level in 0..kept.levels() {
            assert_eq!(kept.rise(element, level), without.rise(element, level));
        }
    }
    assert_eq!(kept.ledger(), without.ledger());
}

/// What is read of the foot in the rises of a section: 9/8 of the lowest row's middle less 1/8 of the next one's.
fn foot_of(cells: &[Cell], rises: &[f64]) -> f64 {
    let last = cells.iter().map(|cell| cell.row).max().unwrap();
    let middle = |row: usize| on_middle_line(cells, rises, row);
    9.0 / 8.0 * middle(last) - middle(last - 1) / 8.0
}

/// The section where the foot is warmest has the foot's rise that is recorded, to rounding, and is the mean of
/// left and right of the section that is kept at the same element with all its modes: to rounding too, in the
/// sum of both sides. The train's wheels touch the rail aside and at night, so that all that differs between the sides
/// is theirs: half of the section's highest rise at once, 2e-7 of it after ten minutes.
#[test]
fn property_the_warmest_section_has_the_foots_rise_and_no_side() {
    let base = || Parameters { shortest: 0.0, ..all_effects(outline("60E1"), Resolution::Plane) };
    let dark = Weather { direct: 0.0, ..DAY };
    let after = |place: usize, rest: u32| {
        let mut model = energy(base(), &[2, 2], &dark);
        model.keep_sections(&[place], true);
        run(&mut model, &dark, train(0.012), 0.0, 300, 0.01);
        run(&mut model, &dark, |_| vec![Wheel::default(); 4], 3.0, rest, 1.0);
        model
    };
    for (rest, [least, most]) in [(0, [0.1, 1.0]), (600, [0.0, 1e-5])] {
        let present = after(PLACE, rest).answer().present;
        let model = after(base().line.element(present.chainage).unwrap(), rest);
        let (chainage, rises) = model.warmest_section();
        assert_eq!(chainage, present.chainage);
        let cells = cells(&model);
        let element = model.line().element(chainage).unwrap();
        let (foot, recorded) = (foot_of(&cells, &rises), model.rise(element, model.levels() - 1));
        assert!((foot / recorded - 1.0).abs() < 1e-9, "{foot} of {recorded} K");
        let kept = model.section_rises();
        let largest = kept.iter().copied().fold(0.0, f64::max);
        let mut uneven = 0.0_f64;
        for (cell, rise) in cells.iter().zip(&rises) {
            let mirrored = cells.iter().position(|other| {
                (other.middle.y + cell.middle.y).abs() < 1e-9
                    && (other.middle.z - cell.middle.z).abs() < 1e-9
            });
            let own = cells.iter().position(|other| other == cell).unwrap();
            let sides = [own, mirrored.expect("the section is symmetric")].map(|i| kept[i]);
            let mean = 0.5 * (sides[0] + sides[1]);
            assert!((rise - mean).abs() < 1e-9 * largest, "{rise} of {mean} K at {cell:?}");
            uneven = uneven.max((sides[0] - mean).abs() / largest);
        }
        println!("{rest} s: foot {recorded:.3e} K, sides differ from their mean by {uneven:.1e}");
        assert!((least..=most).contains(&uneven), "{uneven} after {rest} s");
    }
}
