//! Reading and writing the values of a table.

use fmu::{Declaration, ResourceFile, Variables, unit};

use crate::kettle::{Flow, Heating, Kettle, Side, Spot, running};

#[test]
fn what_is_written_is_read_back() {
    let mut declaration = Declaration::default();
    let handles = Kettle::declare(&mut declaration, "");
    let mut values = declaration.start_values().clone();
    let kettle = Kettle {
        volume: 1.0,
        filling: 0.25,
        height: 7.0,
        cups: 3,
        lid: false,
        label: "red".to_owned(),
        heating: Heating::Gas,
        recipe: ResourceFile { named: "/soup.toml".to_owned(), default: "recipe.toml" },
    };
    kettle.write(&handles, &mut values);
    assert_eq!(Kettle::read(&handles, &values), kettle);
    assert_eq!(values[handles.heating], "gas");
    assert_eq!(values[handles.recipe.parameter], "/soup.toml");
}

#[test]
fn a_table_of_reals_alone_is_written_to_its_handles_and_nowhere_else() {
    let mut declaration = Declaration::default();
    let before = declaration.real("before", unit::ONE, "Before").output();
    let handles = Flow::declare(&mut declaration, "flow");
    let after = declaration.real("after", unit::ONE, "After").output();
    let mut values = declaration.start_values().clone();
    let flow = Flow { mass: 1.0, speed: 2.0, power: 3.0 };
    flow.write(&handles, &mut values);
    let written = [before, handles.mass, handles.speed, handles.power, after];
    assert_eq!(written.map(|handle| values[handle]), [0.0, 1.0, 2.0, 3.0, 0.0]);
    values[handles.speed] = -7.0;
    assert_eq!(Flow::read(&handles, &values), Flow { speed: -7.0, ..flow });
}

#[test]
fn groups_are_written_where_they_stand() {
    let mut kettle = running();
    let air = kettle.signals().air.temperature.reference();
    kettle.set_real(&[air], [400.0]).unwrap();
    kettle.do_step(1.0, 1.0).unwrap();
    let side = Side::read(&kettle.signals().sides[1], kettle.values());
    let spot = Spot { temperature: 400.0, bubbles: 1, boils: true };
    assert_eq!(side, Side { spots: [spot; 2], mean: spot, area: 0.25 });
}
