//! `hotfoot critical-speed`.

use tools::critical_speed::{CriticalSpeedArguments, critical_speed};

use crate::table::{STOCK, Table, arguments, refusal};

const LOCOMOTIVE: &str = "locomotive-coco-134t";

fn table(words: &[&str]) -> Table {
    let words = [&[LOCOMOTIVE, "--stock", STOCK, "--csv"], words].concat();
    Table::of::<CriticalSpeedArguments>(critical_speed, &words)
}

/// The more conical the wheels, the earlier a vehicle runs unsteadily, and never faster than its free
/// wheelsets swing: Klingel's frequency V √(λ/(r e))/2π (1883) is the highest there is.
#[test]
fn property_conicity_brings_instability_forward() {
    let table = table(&["--conicity", "0.1,0.2,0.3"]);
    let (conicities, speeds) = (table.column("conicity"), table.column("critical_speed_m_s"));
    assert_eq!(conicities, [0.1, 0.2, 0.3]);
    assert!(speeds.windows(2).all(|pair| pair[1] < pair[0]), "{speeds:?}");
    let (radius, half_distance) = (0.5, 0.75);
    for ((frequency, speed), conicity) in
        table.column("frequency_hz").into_iter().zip(&speeds).zip(&conicities)
    {
        let klingel: f64 = conicity / (radius * half_distance);
        let klingel = speed * klingel.sqrt() / std::f64::consts::TAU;
        assert!(frequency > 0.0 && frequency < 1.1 * klingel, "{frequency} Hz, {klingel} Hz");
    }
}

#[test]
fn a_vehicle_that_stays_stable_has_no_critical_speed() {
    let slow = table(&["--conicity", "0.1", "--greatest", "5"]);
    assert_eq!(slow.texts("critical_speed_m_s"), [""]);
    assert_eq!(slow.names(), "conicity,critical_speed_m_s,frequency_hz");
    let words = [LOCOMOTIVE, "--stock", STOCK, "--conicity", "0.1", "--greatest", "5"];
    let arguments: CriticalSpeedArguments = arguments(&words).unwrap();
    let text = critical_speed(&arguments).unwrap();
    assert!(text.contains("0.100  stable up to 5 m/s"), "{text}");
}

/// For people the speed stands in km/h, too.
#[test]
fn a_table_for_people_has_both_units_of_speed() {
    let words = [LOCOMOTIVE, "--stock", STOCK, "--conicity", "0.3"];
    let arguments: CriticalSpeedArguments = arguments(&words).unwrap();
    let text = critical_speed(&arguments).unwrap();
    let speed = table(&["--conicity", "0.3"]).column("critical_speed_m_s")[0];
    assert!(text.contains(&format!("{speed:.1} m/s")), "{text}");
    assert!(text.contains(&format!("{:.0} km/h)", 3.6 * speed)), "{text}");
}

#[test]
fn wrong_options_are_answered_with_what_is_right() {
    for (words, wanted) in [
        (&["--conicity", "0.1,0"][..], "must be greater than zero"),
        (&["--half-distance", "0"], "must be greater than zero"),
        (&["--rail-radius", "0.3m"], "must be a number, without a unit"),
        (&["--greatest", "0"], "must be greater than zero"),
    ] {
        let words = [&[LOCOMOTIVE, "--stock", STOCK], words].concat();
        let message = refusal::<CriticalSpeedArguments>(critical_speed, &words);
        assert!(message.contains(wanted), "{words:?}: {message}");
    }
}
