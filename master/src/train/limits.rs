//! The physical bounds of the roles, told to the parts that fill them.

use super::layout::Layout;
use super::roles::{self, Group, Names, RoleVariable, find};
use crate::interface::range::Range;
use crate::system::step::System;

/// Lets the outputs of a train's parts be no more than their roles can be.
pub fn limit(layout: &Layout, system: &mut System) {
    limit_part(system, &layout.train, "", &roles::longitudinal(layout.count), &Names::new());
    for holder in &layout.vehicles {
        let groups = roles::vehicle(holder.wheelsets);
        limit_part(system, &holder.component, &holder.prefix, &groups, &holder.names);
    }
}

fn limit_part(system: &mut System, component: &str, prefix: &str, groups: &[Group], names: &Names) {
    let Some(number) = system.number(component) else { return };
    let part = &mut system.parts[number];
    for (inner, variables, causality) in groups.iter().filter(|group| group.2 == "output") {
        for variable in *variables {
            let RoleVariable { range, most_per_second, .. } = variable;
            let found = find(
                part.unit.interface(),
                &format!("{prefix}{inner}"),
                variable,
                causality,
                names,
            );
            let Ok(Some((name, conversion))) = found else { continue };
            let Some(own) = part.unit.interface().variable(&name) else { continue };
            let (reference, back) = (own.reference, conversion.inverse());
            let (a, b) = (back.apply(range.min), back.apply(range.max));
            let range = Range::stated(Some(a.min(b)), Some(a.max(b)));
            let most_per_second = most_per_second.map(|most| most * back.factor.abs());
            part.watch.limit(reference, range, most_per_second);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interface::VariableType;
    use crate::system::clock::Clock;
    use crate::system::mock::Mock;
    use crate::system::part::Part;
    use crate::train::layout::VehicleHolder;

    /// A vehicle whose wheel wins energy from friction, and whose speed turns round.
    #[test]
    fn a_vehicle_is_held_to_the_bounds_of_its_role() {
        let names = ["position", "v", "wheelset[1].position", "wheelset[1].left.friction_power"];
        let outputs = names.map(|name| (name.to_owned(), "output"));
        let step = |own: &mut [f64], _: f64, _: f64| own.copy_from_slice(&[0.0, -16.0, 0.0, -1e6]);
        let mock = Mock::new("vehicle[1]", &outputs, &Default::default(), step);
        let mut part = Part::new(Box::new(mock), 0, 1);
        for reference in 0..4 {
            part.outputs.index(VariableType::Real, reference);
        }
        let mut system = System::new(Clock { start: 0.0, length: 1e-3 }, vec![part]);
        let holder = VehicleHolder {
            component: "vehicle[1]".to_owned(),
            wheelsets: 1,
            names: Names::from([("velocity".to_owned(), "v".to_owned())]),
            ..VehicleHolder::default()
        };
        limit(&Layout { vehicles: vec![holder], ..Layout::default() }, &mut system);
        let part = &mut system.parts[0];
        part.take_outputs(0.0).unwrap();
        part.advance(0.0, 1e-3).unwrap();
        let warnings = part.take_warnings().join("\n");
        assert!(
            warnings.contains("friction_power = -1000000.0 at 0.001 s is less than"),
            "{warnings}"
        );
        assert!(warnings.contains("v = -16.0 at 0.001 s was 0.0 only"), "{warnings}");
    }
}
