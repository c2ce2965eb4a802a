//! The modules of a package: which file holds which, and what names it knows.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use syn::{Item, UseTree, Visibility};

use crate::workspace::{Package, Source};

/// A module in a file: the file as a whole, or one written out within it.
pub struct Module<'a> {
    /// Index of its file among the sources of the package.
    pub file: usize,
    /// Index of the module around it; none for the root of a crate.
    pub parent: Option<usize>,
    /// Its items.
    pub items: &'a [Item],
    /// Modules in it by name.
    pub children: BTreeMap<String, usize>,
    /// Names of the other items that it defines.
    pub defined: Vec<String>,
    /// Names that it imports with their paths.
    pub imported: Vec<Import>,
}

/// A name that a module knows by `use`.
pub struct Import {
    /// The name; `*` for all names of the module at the path.
    pub name: String,
    /// Segments of the path.
    pub path: Vec<String>,
    /// Line of the `use`, from 1.
    pub line: usize,
    /// Whether it only hands the name on to others, as `pub use` does.
    pub handed_on: bool,
}

/// The modules of all crates of a package; those for tests are left out.
pub fn modules(package: &Package) -> Vec<Module<'_>> {
    let mut reader = Reader { package, modules: vec![] };
    let declared: Vec<usize> =
        package.sources.iter().flat_map(|source| reader.declared_by(source)).collect();
    for (file, source) in package.sources.iter().enumerate() {
        if !declared.contains(&file) {
            reader.read(file, None, &source.tree.items, &[]);
        }
    }
    reader.modules
}

struct Reader<'a> {
    package: &'a Package,
    modules: Vec<Module<'a>>,
}

impl<'a> Reader<'a> {
    /// Adds a module and those in it; `within` are the names of modules written out around it in its file.
    fn read(
        &mut self,
        file: usize,
        parent: Option<usize>,
        items: &'a [Item],
        within: &[String],
    ) -> usize {
        let index = self.modules.len();
        self.modules.push(Module {
            file,
            parent,
            items,
            children: BTreeMap::new(),
            defined: items.iter().filter_map(defined_name).collect(),
            imported: items.iter().flat_map(imports).collect(),
        });
        for item in items {
            let Item::Mod(module) = item else { continue };
            if is_for_tests(&module.attrs) {
                continue;
            }
            let name = module.ident.to_string();
            let child = match &module.content {
                Some((_, items)) => {
                    let within = [within, std::slice::from_ref(&name)].concat();
                    self.read(file, Some(index), items, &within)
                }
                None => {
                    let path = &self.package.sources[file].path;
                    let Some(file) = self.file_of(path, module, within) else { continue };
                    self.read(file, Some(index), &self.package.sources[file].tree.items, &[])
                }
            };
            self.modules[index].children.insert(name, child);
        }
        index
    }

    /// Files that the `mod` lines of a source declare.
    fn declared_by(&self, source: &Source) -> Vec<usize> {
        let declarations = source.tree.items.iter().filter_map(|item| match item {
            Item::Mod(module) if module.content.is_none() => Some(module),
            _ => None,
        });
        declarations.filter_map(|module| self.file_of(&source.path, module, &[])).collect()
    }

    /// Index of the file of `mod name;` in the file `path`.
    fn file_of(&self, path: &Path, module: &syn::ItemMod, within: &[String]) -> Option<usize> {
        let folder = path.parent()?;
        let file = |path: PathBuf| {
            self.package.sources.iter().position(|source| source.path == normal(&path))
        };
        if let Some(given) = path_attribute(&module.attrs) {
            return file(folder.join(given));
        }
        let name = module.ident.to_string();
        let below = |folder: &Path| {
            let folder = within.iter().fold(folder.to_owned(), |folder, name| folder.join(name));
            file(folder.join(format!("{name}.rs")))
                .or_else(|| file(folder.join(&name).join("mod.rs")))
        };
        below(&folder.join(path.file_stem()?)).or_else(|| below(folder))
    }
}

/// Whether an item exists in tests only.
pub fn is_for_tests(attributes: &[syn::Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        attribute.path().is_ident("test")
            || attribute.path().is_ident("cfg")
                && attribute.parse_args::<syn::Path>().is_ok_and(|path| path.is_ident("test"))
    })
}

/// The path with its `..` taken back.
fn normal(path: &Path) -> PathBuf {
    let mut normal = PathBuf::new();
    for part in path {
        if part == ".." {
            normal.pop();
        } else {
            normal.push(part);
        }
    }
    normal
}

fn path_attribute(attributes: &[syn::Attribute]) -> Option<String> {
    attributes.iter().find_map(|attribute| {
        let named = attribute.meta.require_name_value().ok()?;
        if !named.path.is_ident("path") {
            return None;
        }
        match &named.value {
            syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(text), .. }) => Some(text.value()),
            _ => None,
        }
    })
}

/// Name that an item gives to its module.
fn defined_name(item: &Item) -> Option<String> {
    let name = match item {
        Item::Const(item) => &item.ident,
        Item::Enum(item) => &item.ident,
        Item::Fn(item) => &item.sig.ident,
        Item::Macro(item) => item.ident.as_ref()?,
        Item::Static(item) => &item.ident,
        Item::Struct(item) => &item.ident,
        Item::Trait(item) => &item.ident,
        Item::Type(item) => &item.ident,
        Item::Union(item) => &item.ident,
        _ => return None,
    };
    Some(name.to_string())
}

/// Names that an item imports.
pub fn imports(item: &Item) -> Vec<Import> {
    let mut found = vec![];
    if let Item::Use(import) = item
        && !is_for_tests(&import.attrs)
    {
        let handed_on = !matches!(import.vis, Visibility::Inherited);
        let mut add = |name: String, path: Vec<String>, line| {
            found.push(Import { name, path, line, handed_on });
        };
        flatten(&import.tree, &mut vec![], &mut add);
    }
    found
}

/// Calls `add` with the name, the path and the line of everything that a `use` brings.
pub fn flatten(
    tree: &UseTree,
    prefix: &mut Vec<String>,
    add: &mut impl FnMut(String, Vec<String>, usize),
) {
    let line = |ident: &syn::Ident| ident.span().start().line;
    let path = |prefix: &[String], last: String| {
        let last = (last != "self").then_some(last);
        prefix.iter().cloned().chain(last).collect::<Vec<_>>()
    };
    match tree {
        UseTree::Path(part) => {
            prefix.push(part.ident.to_string());
            flatten(&part.tree, prefix, add);
            prefix.pop();
        }
        UseTree::Name(name) => {
            let path = path(prefix, name.ident.to_string());
            let last = path.last().cloned().unwrap_or_default();
            add(last, path, line(&name.ident));
        }
        UseTree::Rename(name) => {
            let path = path(prefix, name.ident.to_string());
            add(name.rename.to_string(), path, line(&name.rename));
        }
        UseTree::Glob(star) => {
            use syn::spanned::Spanned;
            add("*".to_owned(), prefix.clone(), star.span().start().line);
        }
        UseTree::Group(group) => {
            for tree in &group.items {
                flatten(tree, prefix, add);
            }
        }
    }
}
