//! Which file of a package uses which.

mod modules;
mod names;

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{TokenStream, TokenTree};
use syn::visit::{self, Visit};

use self::modules::{Module, is_for_tests};
use self::names::file_of;
use crate::workspace::Package;

/// What a file takes from another: the names, and the first line that names one of them.
#[derive(Default)]
pub struct Arrow {
    /// Names as they are written.
    pub names: BTreeSet<String>,
    /// First line, from 1.
    pub line: usize,
}

/// Arrows of a package from a file to the file whose items it names, both by index among its sources.
///
/// A `mod` line is no arrow, nor is a name that is only handed on (`pub use`); who uses the name has an
/// arrow to the file that defines it. Tests are left out.
pub fn arrows(package: &Package) -> BTreeMap<(usize, usize), Arrow> {
    let modules = modules::modules(package);
    let mut arrows = BTreeMap::<_, Arrow>::new();
    for (index, module) in modules.iter().enumerate() {
        for (path, line) in paths(module) {
            let Some(file) = file_of(&modules, index, &path) else { continue };
            if file != module.file {
                let arrow = arrows.entry((module.file, file)).or_default();
                arrow.names.insert(path.last().cloned().unwrap_or_default());
                arrow.line = if arrow.line == 0 { line } else { arrow.line.min(line) };
            }
        }
    }
    arrows
}

/// Paths that the code of a module names, with their lines; those of modules within it are theirs.
fn paths(module: &Module) -> Vec<(Vec<String>, usize)> {
    let used = module.imported.iter().filter(|import| !import.handed_on);
    let mut paths = Paths(used.map(|import| (import.path.clone(), import.line)).collect());
    for item in module.items {
        if !matches!(item, syn::Item::Use(_) | syn::Item::Mod(_)) {
            paths.visit_item(item);
        }
    }
    paths.0
}

struct Paths(Vec<(Vec<String>, usize)>);

impl<'a> Visit<'a> for Paths {
    fn visit_item(&mut self, item: &'a syn::Item) {
        let attributes = match item {
            syn::Item::Const(item) => &item.attrs,
            syn::Item::Fn(item) => &item.attrs,
            syn::Item::Impl(item) => &item.attrs,
            syn::Item::Struct(item) => &item.attrs,
            _ => &vec![],
        };
        if !is_for_tests(attributes) {
            visit::visit_item(self, item);
        }
    }

    fn visit_item_use(&mut self, item: &'a syn::ItemUse) {
        let mut add = |_, path, line| self.0.push((path, line));
        modules::flatten(&item.tree, &mut vec![], &mut add);
    }

    fn visit_path(&mut self, path: &'a syn::Path) {
        if path.leading_colon.is_none() {
            let segments = path.segments.iter().map(|segment| segment.ident.to_string());
            let line = path.segments.first().map_or(0, |first| first.ident.span().start().line);
            self.0.push((segments.collect(), line));
        }
        visit::visit_path(self, path);
    }

    fn visit_macro(&mut self, call: &'a syn::Macro) {
        self.visit_path(&call.path);
        self.scan(call.tokens.clone());
    }
}

impl Paths {
    /// Finds the paths in what is given to a macro: names with `::` between them.
    fn scan(&mut self, tokens: TokenStream) {
        let mut path: Vec<String> = vec![];
        let mut line = 0;
        let mut colons = 0;
        for token in tokens {
            match token {
                TokenTree::Punct(punct) if punct.as_char() == ':' => {
                    colons += 1;
                    continue;
                }
                TokenTree::Ident(ident) => {
                    if colons != 2 {
                        self.end(&mut path, line);
                        line = ident.span().start().line;
                    }
                    path.push(ident.to_string());
                }
                TokenTree::Group(group) => {
                    self.end(&mut path, line);
                    self.scan(group.stream());
                }
                _ => self.end(&mut path, line),
            }
            colons = 0;
        }
        self.end(&mut path, line);
    }

    fn end(&mut self, path: &mut Vec<String>, line: usize) {
        if !path.is_empty() {
            self.0.push((std::mem::take(path), line));
        }
    }
}
