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
