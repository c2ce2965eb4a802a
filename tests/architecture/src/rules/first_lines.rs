//! Doc comments begin with a short line.

use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{Attribute, Visibility};

use crate::breach::Breach;
use crate::workspace::Workspace;

/// Characters that the first line of a doc comment has at most.
const CHARACTERS: usize = 100;

/// Doc comments of public items whose first line is too long.
pub fn breaches(workspace: &Workspace) -> Vec<Breach> {
    let mut found = vec![];
    for package in &workspace.packages {
        for source in package.sources.iter().filter(|source| package.is_product(source)) {
            let mut long = FirstLines(vec![]);
            long.check(&source.tree.attrs);
            long.visit_file(&source.tree);
            let breaches = long.0.into_iter().map(|(line, length)| {
                Breach::new(&source.path, line, format!("{length} characters in the first line"))
            });
            found.extend(breaches);
        }
    }
    found
}

/// Lines that are too long, with their lengths.
struct FirstLines(Vec<(usize, usize)>);

impl FirstLines {
    fn check(&mut self, attributes: &[Attribute]) {
        let first = attributes.iter().find_map(|attribute| {
            let named = attribute.meta.require_name_value().ok()?;
            let syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(text), .. }) = &named.value else {
                return None;
            };
            let is_comment = named.path.is_ident("doc");
            is_comment.then(|| (attribute.span().start().line, text.value()))
        });
        if let Some((line, text)) = first {
            let length = text.trim().lines().next().unwrap_or_default().chars().count();
            if length > CHARACTERS {
                self.0.push((line, length));
            }
        }
    }

    fn check_public(&mut self, visibility: &Visibility, attributes: &[Attribute]) {
        if !matches!(visibility, Visibility::Inherited) {
            self.check(attributes);
        }
    }
}

/// Calls the check for items of each kind that has a visibility.
macro_rules! public {
    ($($visit:ident: $item:ident),* $(,)?) => {
        $(fn $visit(&mut self, item: &'a syn::$item) {
            self.check_public(&item.vis, &item.attrs);
            visit::$visit(self, item);
        })*
    };
}

impl<'a> Visit<'a> for FirstLines {
    public! {
        visit_field: Field,
        visit_impl_item_const: ImplItemConst,
        visit_impl_item_fn: ImplItemFn,
        visit_item_const: ItemConst,
        visit_item_enum: ItemEnum,
        visit_item_fn: ItemFn,
        visit_item_mod: ItemMod,
        visit_item_static: ItemStatic,
        visit_item_struct: ItemStruct,
        visit_item_trait: ItemTrait,
        visit_item_type: ItemType,
    }

    fn visit_variant(&mut self, variant: &'a syn::Variant) {
        self.check(&variant.attrs);
        visit::visit_variant(self, variant);
    }

    fn visit_trait_item_fn(&mut self, item: &'a syn::TraitItemFn) {
        self.check(&item.attrs);
        visit::visit_trait_item_fn(self, item);
    }
}
