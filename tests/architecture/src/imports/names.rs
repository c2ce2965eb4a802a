//! From a path as code writes it to the file that defines what it names.

use super::modules::{Import, Module};

/// Finds where a path of `module` leads: the index of the file that defines the item, none for what the
/// package does not define, and for a module as such.
pub fn file_of(modules: &[Module], module: usize, path: &[String]) -> Option<usize> {
    match resolve(modules, module, path, 0)? {
        Target::Item(file) => Some(file),
        Target::Module(_) => None,
    }
}

enum Target {
    /// An item in the file of this index.
    Item(usize),
    /// The module of this index.
    Module(usize),
}

/// Re-exports that are followed at most, so that two that lead to each other end.
const DEPTH: usize = 16;

fn resolve(modules: &[Module], from: usize, path: &[String], depth: usize) -> Option<Target> {
    if depth > DEPTH {
        return None;
    }
    let (first, rest) = path.split_first()?;
    let mut target = match first.as_str() {
        "crate" => Target::Module(root(modules, from)),
        "self" => Target::Module(from),
        "super" => Target::Module(modules[from].parent?),
        name => look_up(modules, from, name, depth)?,
    };
    for name in rest {
        let Target::Module(module) = target else { break };
        target = if name == "super" {
            Target::Module(modules[module].parent?)
        } else {
            match look_up(modules, module, name, depth) {
                Some(target) => target,
                None if is_from_outside(&modules[module], name) => return None,
                // An item that a macro makes there.
                None => Target::Item(modules[module].file),
            }
        };
    }
    Some(target)
}

fn look_up(modules: &[Module], module: usize, name: &str, depth: usize) -> Option<Target> {
    let here = &modules[module];
    if here.defined.iter().any(|defined| defined == name) {
        return Some(Target::Item(here.file));
    }
    if let Some(&child) = here.children.get(name) {
        return Some(Target::Module(child));
    }
    let leads_back = |import: &Import| import.path.first().is_some_and(|first| first == name);
    let named = here.imported.iter().filter(|import| import.name == name && !leads_back(import));
    let globs = here.imported.iter().filter(|import| import.name == "*");
    let named = named.map(|import| import.path.clone());
    let globs = globs.map(|import| {
        let name = std::iter::once(name.to_owned());
        import.path.iter().cloned().chain(name).collect::<Vec<_>>()
    });
    // What a glob brings is looked up there; it is never an item that a macro makes.
    named
        .chain(globs.filter(|path| exists(modules, module, path, depth + 1)))
        .find_map(|path| resolve(modules, module, &path, depth + 1))
}

/// Whether the last name of a path is known in the module that the path's beginning names.
fn exists(modules: &[Module], from: usize, path: &[String], depth: usize) -> bool {
    let Some((name, path)) = path.split_last() else { return false };
    match resolve(modules, from, path, depth) {
        Some(Target::Module(module)) => look_up(modules, module, name, depth).is_some(),
        _ => false,
    }
}

/// Whether a name comes from another crate.
fn is_from_outside(module: &Module, name: &str) -> bool {
    module.imported.iter().any(|import| import.name == name)
}

fn root(modules: &[Module], mut module: usize) -> usize {
    while let Some(parent) = modules[module].parent {
        module = parent;
    }
    module
}
