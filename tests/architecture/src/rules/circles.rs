//! No files of a package use each other in a loop, however long it is.

use std::collections::BTreeSet;

use crate::breach::Breach;
use crate::imports::arrows;
use crate::workspace::{Package, Workspace};

/// Every circle of files as one breach, whose message lists the arrows within it.
pub fn breaches(workspace: &Workspace) -> Vec<Breach> {
    workspace.packages.iter().flat_map(circles).collect()
}

fn circles(package: &Package) -> Vec<Breach> {
    let arrows = arrows(package);
    let count = package.sources.len();
    let reached: Vec<BTreeSet<usize>> = (0..count)
        .map(|from| reached_from(from, |a, b| arrows.contains_key(&(a, b)), count))
        .collect();
    let mut found = vec![];
    let mut seen = BTreeSet::<usize>::new();
    for file in 0..count {
        if !reached[file].contains(&file) || seen.contains(&file) {
            continue;
        }
        let circle: Vec<usize> =
            reached[file].iter().copied().filter(|&other| reached[other].contains(&file)).collect();
        seen.extend(&circle);
        let path = |file: usize| package.sources[file].path.display();
        let mut message = format!("{} files use each other:", circle.len());
        for ((from, to), arrow) in &arrows {
            if circle.contains(from) && circle.contains(to) {
                let names: Vec<_> = arrow.names.iter().map(String::as_str).collect();
                let names = names.join(", ");
                message +=
                    &format!("\n    {}:{} → {}: {names}", path(*from), arrow.line, path(*to));
            }
        }
        found.push(Breach::new(&package.sources[file].path, 0, message));
    }
    found
}

/// What can be reached from a file by at least one arrow.
fn reached_from(
    from: usize,
    arrow: impl Fn(usize, usize) -> bool,
    count: usize,
) -> BTreeSet<usize> {
    let mut reached = BTreeSet::new();
    let mut ends = vec![from];
    while let Some(end) = ends.pop() {
        for next in 0..count {
            if arrow(end, next) && reached.insert(next) {
                ends.push(next);
            }
        }
    }
    reached
}
