//! The rail heat as an FMU.
//!
//! | file | what |
//! |---|---|
//! | `main.rs` | the names of its variables, and a run of the paper's model |
//! | `energy.rs` | the energy model, site, time and weather |
//! | `field.rs` | the store of the field, saved states |
//! | `bad_input.rs` | what is wrong is named |
//! | `bench.rs` | an FMU for the tests |

mod bad_input;
mod bench;
mod energy;
mod field;

use fmu::Kind;

use crate::bench::Bench;

/// Other programs connect to these names.
#[test]
fn property_the_signals_have_their_names() {
    let bench = Bench::new();
    for signal in [
        "position",
        "speed",
        "creepage.longitudinal",
        "force.normal",
        "friction_power",
        "contact.a",
        "contact.b",
        "contact.flash_factor",
        "contact.lateral_position",
        "brake_power",
    ] {
        bench.reference(&format!("vehicle[2].wheelset[1].{signal}"));
    }
    for name in [
        "ambient.temperature",
        "wind.speed",
        "solar.irradiance",
        "solar.elevation",
        "solar.azimuth",
        "field_file",
        "field_interval",
        "model",
        "highest.surface.rise",
        "highest.foot.chainage",
        "highest.depth[2].rise",
        "probe[1].surface.rise",
        "probe[1].depth[1].rise",
        "probe[1].foot.rise",
        "probe[1].heat",
        "energy.stored",
    ] {
        bench.reference(name);
    }
    let variables = bench.instance.declaration().variables();
    let positions = variables.iter().filter(|variable| variable.name.ends_with("].position"));
    assert_eq!(positions.count(), 3, "two wheelsets and one");
    let model = variables.iter().find(|variable| variable.name == "model").unwrap();
    assert!(matches!(&model.kind, Kind::Text { start, .. } if start == "energy"), "{model:?}");
}

#[test]
fn property_a_passing_wheel_warms_the_probe() {
    let mut bench = Bench::of_paper();
    bench.start().unwrap();
    assert_eq!(bench.get("probe[1].surface.rise"), 0.0);
    bench.steps(0, 50);
    let (surface, deep) = (bench.get("probe[1].surface.rise"), bench.get("probe[1].depth[2].rise"));
    assert!(surface > 1.0 && (0.0..1e-3).contains(&deep));
    assert!(bench.get("probe[1].heat") > 0.0);
    assert!(bench.get("highest.surface.rise") >= surface);
    let chainage = bench.get("highest.surface.chainage");
    assert!((28.0..=36.4).contains(&chainage), "{chainage}");
    let (stored, imposed) = (bench.get("energy.stored"), bench.get("energy.imposed"));
    let error = stored - imposed - bench.get("energy.weather");
    assert!(error.abs() < 1e-10 * imposed);
}
