//! The published interfaces (`modelDescription/`) as a master reads them.

use super::Interface;
use super::si::Dimension;

/// The published model descriptions.
const PUBLISHED: [(&str, &str); 4] = [
    ("longitudinal", include_str!("../../../modelDescription/longitudinal.xml")),
    ("vehicle", include_str!("../../../modelDescription/vehicle.xml")),
    ("railheat", include_str!("../../../modelDescription/railheat.xml")),
    ("synchronisation", include_str!("../../../modelDescription/synchronisation.xml")),
];

/// Exponents of kilogram, metre, second and kelvin of each unit: The International System of Units, 9th
/// edition (BIPM 2019), tables 4 to 6; the radian is one.
const SI: [(&str, [i32; 4]); 25] = [
    ("1", [0, 0, 0, 0]),
    ("1/K", [0, 0, 0, -1]),
    ("1/m", [0, -1, 0, 0]),
    ("J", [1, 2, -2, 0]),
    ("J/(kg.K)", [0, 2, -2, -1]),
    ("J/K", [1, 2, -2, -1]),
    ("J/m", [1, 1, -2, 0]),
    ("K", [0, 0, 0, 1]),
    ("N", [1, 1, -2, 0]),
    ("N.s/m", [1, 0, -1, 0]),
    ("N/(m.s)", [1, 0, -3, 0]),
    ("N/m", [1, 0, -2, 0]),
    ("Pa", [1, -1, -2, 0]),
    ("W", [1, 2, -3, 0]),
    ("W/(m.K)", [1, 1, -3, -1]),
    ("W/(m2.K)", [1, 0, -3, -1]),
    ("W/K", [1, 2, -3, -1]),
    ("W/m2", [1, 0, -3, 0]),
    ("kg", [1, 0, 0, 0]),
    ("kg/m3", [1, -3, 0, 0]),
    ("m", [0, 1, 0, 0]),
    ("m/s", [0, 1, -1, 0]),
    ("m/s2", [0, 1, -2, 0]),
    ("rad", [0, 0, 0, 0]),
    ("s", [0, 0, 1, 0]),
];

#[test]
fn benchmark_published_units_are_those_of_the_si() {
    for (model, xml) in PUBLISHED {
        let interface = Interface::from_xml(xml).unwrap();
        for variable in interface.variables() {
            let Some(unit) = &variable.unit else { continue };
            let name = format!("{model}: {} in {unit}", variable.name);
            let [kg, m, s, kelvin] = SI
                .iter()
                .find(|(symbol, _)| symbol == unit)
                .unwrap_or_else(|| panic!("{name}: no unit of the list"))
                .1;
            let si = variable.si.unwrap_or_else(|| panic!("{name} is not traced to SI units"));
            assert_eq!(si.dimension, Dimension([kg, m, s, 0, kelvin, 0, 0]), "{name}");
            assert!(si.to_base.is_identity(), "{name}: SI units need no factor");
        }
    }
}

/// FMI 2.0 §2.1.1: the GUID binds description and binary; §4.3.1: the identifier names the binary.
#[test]
fn published_interfaces_are_those_of_their_models() {
    let mut seen = vec![];
    for (model, xml) in PUBLISHED {
        let interface = Interface::from_xml(xml).unwrap();
        assert_eq!(interface.identifier, model);
        assert!(!seen.contains(&interface.guid), "{model} has the GUID of another");
        assert!(interface.can_get_and_set_state, "{model} can be set back");
        assert!(interface.can_serialize_state, "{model} can go on in another program");
        assert!(interface.variable_step, "{model} takes steps of any length");
        seen.push(interface.guid);
    }
}
