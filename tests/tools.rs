//! The engineering commands.

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

/// Coulomb's law: a wheel that slides has the force mu N, forward in traction, and turns mu N w v into
/// heat. The creep table is exact to 0.4 % there (`property_table_follows_the_march`).
#[test]
fn analytic_a_sliding_wheel_has_the_friction_force() {
    let contact = ["--load", "100000", "--semi-axes-mm", "6", "6", "--friction", "0.3"];
    let table =
        rows(&[&["creep", "--speed", "10", "--longitudinal", "0.5"], &contact[..]].concat());
    let force = column(&table, "force_longitudinal_n")[0];
    let power = column(&table, "friction_power_w")[0];
    assert!((force / 30e3 - 1.0).abs() < 4e-3, "{force}");
    assert!((power / 150e3 - 1.0).abs() < 4e-3, "{power}");
}

/// A cone of 1:20 has the conicity 1/20 at the contact (Klingel 1883).
#[test]
fn analytic_a_cone_has_its_conicity() {
    let table = rows(&["contact", "--wheel", "cone-1-20", "--from-mm", "2", "--to-mm", "2"]);
    for conicity in column(&table, "conicity") {
        assert_eq!(conicity, 0.05);
    }
}

/// The cone of the same wavelength is the cone itself, at every amplitude (EN 15302).
#[test]
fn analytic_a_cone_has_its_equivalent_conicity() {
    let table = rows(&["contact", "--wheel", "cone-1-20", "--from-mm", "1", "--to-mm", "3"]);
    for conicity in column(&table, "equivalent_conicity") {
        assert_eq!(conicity, 0.05);
    }
}

/// What is understood of a worn wheel, drawn and written; the clean file is taken as it is.
#[test]
fn a_profile_is_understood_drawn_and_written() {
    let folder = tempfile::tempdir().unwrap();
    let (plot, clean) = (folder.path().join("worn.svg"), folder.path().join("worn.txt"));
    let [plot, clean] = [&plot, &clean].map(|path| path.to_str().unwrap());
    let output =
        hotfoot(root(), &["profile", "tests/profiles/worn.prw", "--plot", plot, "--write", clean]);
    let text = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(text.contains("SIMPACK") && text.contains(plot) && text.contains(clean), "{text}");
    let again = hotfoot(root(), &["profile", clean]);
    let text = String::from_utf8_lossy(&again.stdout);
    assert!(text.contains("smoothed           no") && text.contains("0.00 µm rms"), "{text}");
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

/// The SVG that a command draws.
fn plot(arguments: &[&str]) -> String {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("plot.svg");
    let output = hotfoot(root(), &[arguments, &["--plot", file.to_str().unwrap()]].concat());
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let told = String::from_utf8_lossy(&output.stdout);
    assert_eq!(told.trim(), file.display().to_string(), "the file instead of the rows");
    std::fs::read_to_string(&file).unwrap()
}

/// Every panel is there with its name and unit, and a dot for each contact that bears a load.
#[test]
fn a_contact_plot_shows_every_contact_in_every_panel() {
    let displacements = ["--from-mm", "1", "--to-mm", "3", "--step-mm", "1"];
    let arguments = [&["contact"], &displacements[..]].concat();
    let svg = plot(&arguments);
    for name in [
        "S1002 on 60E1 1:40, 100 kN a wheel",
        "rolling radii, right less left, in mm",
        "equivalent conicity",
        "contact angle in mrad",
        "normal force in N",
        "contact on the rail in mm",
        "contact on the wheel in mm",
        "semi-axis a along in mm",
        "semi-axis b across in mm",
    ] {
        assert!(svg.contains(name), "{name} is missing");
    }
    let loads = column(&rows(&arguments), "normal_force_n");
    let loaded = loads.iter().filter(|load| **load > 0.0).count();
    let (panels, legend) = (6, 4);
    assert_eq!(svg.matches("<circle").count(), panels * loaded + legend);
}

#[test]
fn a_creep_plot_has_the_creepage_that_changes_as_its_axis() {
    let contact = ["--load", "1e5", "--semi-axes-mm", "6", "6"];
    let lateral = ["creep", "--longitudinal", "0.001", "--lateral", "0,0.001,0.002"];
    let svg = plot(&[&lateral[..], &contact].concat());
    assert!(svg.contains("lateral creepage") && !svg.contains("longitudinal creepage"));
    assert!(svg.contains("friction power in W") && svg.contains("flash temperature, rise in K"));
}

#[test]
fn a_plot_that_cannot_be_is_refused_with_the_remedy() {
    let contact = ["creep", "--load", "1e5", "--semi-axes-mm", "6", "6"];
    for (arguments, remedy) in [
        (&["--plot", "creep.svg"][..], "a list of creepages that differ"),
        (&["--longitudinal", "0,0.01", "--plot", "creep.png"], "must end in .svg"),
    ] {
        let output = hotfoot(root(), &[&contact[..], arguments].concat());
        assert!(!output.status.success());
        let text = String::from_utf8_lossy(&output.stderr);
        assert!(text.contains(remedy), "{text}");
    }
}
