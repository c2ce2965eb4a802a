//! The engineering commands, which the program starts in `hotfoot-tools`.

use hotfoot_tests::{hotfoot, root};

/// The rows that a command prints, with its columns.
fn rows(arguments: &[&str]) -> (Vec<String>, Vec<Vec<String>>) {
    let output = hotfoot(root(), arguments);
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let mut lines = text.lines().map(|line| line.split(',').map(str::to_owned).collect());
    (lines.next().unwrap(), lines.collect())
}

/// The numbers in a column.
fn column(table: &(Vec<String>, Vec<Vec<String>>), name: &str) -> Vec<f64> {
    let place = table.0.iter().position(|column| column == name).unwrap();
    table.1.iter().map(|row| row[place].parse().unwrap()).collect()
}

/// Coulomb's law: a wheel that slides has the force mu N against the slip, and turns mu N w v into
/// heat. The creep table is exact to 0.4 % there (`property_table_follows_the_march`).
#[test]
fn analytic_a_sliding_wheel_has_the_friction_force() {
    let contact = ["--load", "100000", "--semi-axes-mm", "6", "6", "--friction", "0.3"];
    let table =
        rows(&[&["creep", "--speed", "10", "--longitudinal", "0.5"], &contact[..]].concat());
    let force = column(&table, "force_longitudinal_n")[0];
    let power = column(&table, "friction_power_w")[0];
    assert!((force / -30e3 - 1.0).abs() < 4e-3, "{force}");
    assert!((power / 150e3 - 1.0).abs() < 4e-3, "{power}");
}

/// A cone of 1:20 has the conicity 1/20, raised by the roll of the wheelset and the round rail head
/// by a factor 1/(1 - r gamma/e) of some 1.03 and more (Klingel 1883 gives 1/20 for a knife edge).
#[test]
fn analytic_a_cone_has_its_conicity() {
    let table = rows(&["contact", "--wheel", "cone-1-20", "--from-mm", "2", "--to-mm", "2"]);
    for conicity in column(&table, "conicity") {
        assert!((0.05..0.055).contains(&conicity), "{conicity}");
    }
}

/// Two profiles that meet in the middle do so alike on both sides.
#[test]
fn property_a_centred_wheelset_stands_alike_on_both_rails() {
    let table = rows(&["contact", "--from-mm", "0", "--to-mm", "0"]);
    let places = column(&table, "rail_mm");
    assert_eq!(places.len() % 2, 0, "as many contacts on the left as on the right");
    let (left, right) = places.split_at(places.len() / 2);
    assert_eq!(left, right);
}

#[test]
fn an_unknown_profile_is_named() {
    let output = hotfoot(root(), &["contact", "--wheel", "S9999"]);
    assert!(!output.status.success());
    let text = String::from_utf8_lossy(&output.stderr);
    assert!(text.contains("S9999") && !text.contains("panicked"), "{text}");
}
