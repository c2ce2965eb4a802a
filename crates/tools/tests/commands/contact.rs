//! `hotfoot contact`.

use tools::contact::{ContactArguments, contact};

use crate::table::{Table, assert_near, refusal};

fn table(words: &[&str]) -> Table {
    Table::of::<ContactArguments>(contact, words)
}

fn refused(words: &[&str]) -> String {
    refusal::<ContactArguments>(contact, words)
}

/// One displacement, with further words.
fn at(lateral_mm: &str, words: &[&str]) -> Table {
    table(&[&["--from-mm", lateral_mm, "--to-mm", lateral_mm], words].concat())
}

#[test]
fn golden_columns() {
    let names = "lateral_mm,roll_mrad,radius_difference_mm,conicity,equivalent_conicity,side,contact,\
                 gap_mm,rail_mm,wheel_mm,radius_change_mm,angle_mrad,normal_force_n,a_mm,b_mm,approach_mm";
    assert_eq!(at("1", &[]).names(), names);
}

#[test]
fn a_row_stands_for_each_contact_of_each_displacement() {
    let table = table(&["--from-mm", "-1", "--to-mm", "1", "--step-mm", "1"]);
    let mut displacements = table.column("lateral_mm");
    displacements.dedup();
    assert_eq!(displacements, [-1.0, 0.0, 1.0]);
    let (sides, numbers) = (table.texts("side"), table.column("contact"));
    // The contacts of a wheel are numbered from one.
    for (i, number) in numbers.iter().enumerate() {
        let begins = i == 0 || sides[i] != sides[i - 1];
        assert_eq!(*number, if begins { 1.0 } else { numbers[i - 1] + 1.0 });
    }
    // A wheelset in the middle has no conicity.
    let centred = table.column("lateral_mm").iter().position(|lateral| *lateral == 0.0).unwrap();
    assert_eq!(table.texts("conicity")[centred], "");
}

/// A cone of 1:20 has the conicity 1/20, as EN 15302 counts the displacement: at the contact, without roll.
/// The radii of the wheelset that rolls have more of it, by a factor 1/(1 − r γ/e) of some 1.03 and more.
#[test]
fn analytic_a_cone_has_its_conicity_at_every_displacement() {
    let cone = ["--wheel", "cone-1-20", "--from-mm", "1", "--to-mm", "3"];
    let table = table(&cone);
    for conicity in table.column("conicity").into_iter().chain(table.column("equivalent_conicity"))
    {
        assert_eq!(conicity, 0.05);
    }
    let difference = |roll: &str| {
        let one = [&cone[..2], &["--from-mm", "2", "--to-mm", "2", "--roll", roll]].concat();
        Table::of::<ContactArguments>(contact, &one).column("radius_difference_mm")[0]
    };
    assert!((difference("off") - 0.2).abs() < 2e-5);
    assert!((0.205..0.22).contains(&difference("free")), "{}", difference("free"));
}

/// A wheelset that is held keeps the roll that is said, and the free one that with which both wheels touch.
#[test]
fn the_roll_is_free_off_or_said() {
    let roll = |words: &[&str]| at("2", words).column("roll_mrad")[0];
    assert_eq!(roll(&["--roll", "off"]), 0.0);
    assert_eq!(roll(&["--roll", "-1.5"]), -1.5);
    assert_eq!(roll(&[]), roll(&["--roll", "free"]));
    assert!(roll(&[]).abs() > 0.01);
    assert!(refused(&["--roll", "loose"]).contains("or free, or off"));
}

/// The left wheel smaller by 0.1 mm: the radii differ by it in the middle, and cones of 1:20 swing about
/// 1 mm to the left, where they are equal.
#[test]
fn analytic_a_left_wheel_that_differs() {
    let cones = ["--wheel", "cone-1-20", "--roll", "off", "--left-radius", "0.4599"];
    let table = at("0", &cones);
    assert!((table.column("radius_difference_mm")[0] - 0.1).abs() < 2e-5);
    let table = at("-1", &cones);
    assert!(table.column("radius_difference_mm")[0].abs() < 2e-5);
    assert_eq!(table.column("equivalent_conicity")[0], 0.05);
    let other = at("2", &["--left-wheel", "cone-1-40", "--wheel", "cone-1-20", "--roll", "off"]);
    let both = at("2", &["--wheel", "cone-1-20", "--roll", "off"]);
    let changes = [&other, &both].map(|table| table.column("radius_change_mm"));
    assert_eq!(changes[0][1], changes[1][1], "the right wheel is the same");
    assert_ne!(changes[0][0], changes[1][0], "the left one is another");
}

/// On a cone both wheels roll on the cone's angle: tan γ = 1/20, one wheel more and one less by the roll.
#[test]
fn analytic_the_contact_angles_of_a_cone_add_up_to_twice_its_own() {
    let table = at("2", &["--wheel", "cone-1-20"]);
    let sum: f64 = table.column("angle_mrad").iter().map(|angle| angle.abs()).sum();
    // The roll cancels; a tenth of a mrad is what the digits leave.
    assert!((sum - 2.0 * 1e3 * (0.05_f64).atan()).abs() < 0.1, "{sum}");
}

/// Hertz 1882: semi-axes go with the cube root of the load, the approach with its square.
#[test]
fn analytic_patches_grow_as_hertz_has_it() {
    let cone = ["--wheel", "cone-1-20"];
    let light = at("0", &[&cone[..], &["--load", "50000"]].concat());
    let heavy = at("0", &[&cone[..], &["--load", "400000"]].concat());
    for (quantity, ratio) in [("a_mm", 2.0), ("b_mm", 2.0), ("approach_mm", 4.0)] {
        let ratio_found = heavy.column(quantity)[0] / light.column(quantity)[0];
        // Five decimals are printed, of an approach of some hundredths of a millimetre.
        assert_near(ratio_found, ratio, 5e-4);
    }
}

/// However many contacts a wheel has, together they hold its load: Σ N cos γ = Q.
#[test]
fn property_contacts_share_the_whole_load() {
    let table = table(&["--from-mm", "-5", "--to-mm", "5", "--load", "120000"]);
    let (sides, laterals) = (table.texts("side"), table.column("lateral_mm"));
    let vertical = table.column("normal_force_n").into_iter().zip(table.column("angle_mrad"));
    let vertical: Vec<f64> = vertical.map(|(force, angle)| force * (angle * 1e-3).cos()).collect();
    let mut begin = 0;
    for end in 1..=vertical.len() {
        let same = |i: usize| sides[i] == sides[begin] && laterals[i] == laterals[begin];
        if end == vertical.len() || !same(end) {
            assert_near(vertical[begin..end].iter().sum(), 120e3, 1e-6);
            begin = end;
        }
    }
}

/// What the left wheel does at one displacement the right one does at the opposite one.
#[test]
fn property_left_and_right_are_mirror_images() {
    let (left, right) = (at("-3", &[]), at("3", &[]));
    let of = |table: &Table, side: &str, quantity: &str| {
        let values = table.column(quantity);
        let sides = table.texts("side");
        let own = sides.iter().zip(values).filter(|(own, _)| **own == side);
        own.map(|(_, value)| value).collect::<Vec<f64>>()
    };
    for quantity in ["gap_mm", "normal_force_n", "a_mm", "b_mm", "radius_change_mm"] {
        for (own, other) in [("left", "right"), ("right", "left")] {
            let pairs = of(&left, own, quantity).into_iter().zip(of(&right, other, quantity));
            // The last of five decimals may be rounded otherwise.
            let alike = pairs.clone().all(|(left, right)| (left - right).abs() < 2e-5);
            assert!(alike && pairs.len() > 0, "{quantity}: {:?}", pairs.collect::<Vec<_>>());
        }
    }
    let opposite = -right.column("radius_difference_mm")[0];
    assert!((left.column("radius_difference_mm")[0] - opposite).abs() < 2e-5);
}

#[test]
fn wrong_options_are_answered_with_what_is_right() {
    for (words, wanted) in [
        (&["--load", "0"][..], "must be greater than zero"),
        (&["--step-mm", "0"], "must be greater than zero"),
        (&["--gauge-mm", "1435mm"], "must be a number, without a unit"),
        (&["--inclination", "0,05"], "must be a number, with a decimal point"),
        (&["--from-mm", "3", "--to-mm", "2"], "--to-mm must not be below --from-mm"),
        (&["--step-mm", "1e-9"], "--step-mm makes more than 10000 rows"),
        (&["--wheel", "S9999"], "there is no wheel profile \"S9999\"; known are S1002"),
        (&["--rail", "none"], "there is no rail profile \"none\"; known are 60E1"),
        (&["--plot", "curve.png"], "--plot curve.png: the name must end in .svg"),
    ] {
        let message = refused(words);
        assert!(message.contains(wanted), "{words:?}: {message}");
    }
}

#[test]
fn a_plot_that_cannot_be_written_is_named() {
    let file = "/nowhere/at/all/plot.svg";
    let message = refused(&["--from-mm", "0", "--to-mm", "1", "--plot", file]);
    assert!(message.starts_with(&format!("{file} cannot be written: ")), "{message}");
}
