//! Names that emitted code declares must not clash with types of the user.

use super::{expansions, sources};
use crate::parse::DECLARED;
use crate::tests::hidden_statements;
use std::path::Path;
use syn::visit::{Visit, visit_const_param, visit_item_struct, visit_item_trait, visit_type_path};

/// Declarations of an expansion, and type paths of one segment.
#[derive(Default)]
struct Names {
    constants: Vec<String>,
    types: Vec<String>,
    paths: Vec<String>,
    depth: usize,
}

impl<'a> Visit<'a> for Names {
    fn visit_const_param(&mut self, parameter: &'a syn::ConstParam) {
        self.constants.push(parameter.ident.to_string());
        visit_const_param(self, parameter);
    }

    fn visit_type_path(&mut self, path: &'a syn::TypePath) {
        self.paths.extend(path.path.get_ident().map(ToString::to_string));
        visit_type_path(self, path);
    }

    fn visit_item_struct(&mut self, item: &'a syn::ItemStruct) {
        self.types.extend((self.depth == 0).then(|| item.ident.to_string()));
        visit_item_struct(self, item);
    }

    fn visit_item_trait(&mut self, item: &'a syn::ItemTrait) {
        self.types.extend((self.depth == 0).then(|| item.ident.to_string()));
        visit_item_trait(self, item);
    }

    /// Items of a function are invisible outside of it.
    fn visit_impl_item_fn(&mut self, function: &'a syn::ImplItemFn) {
        self.depth += 1;
        syn::visit::visit_impl_item_fn(self, function);
        self.depth -= 1;
    }
}

/// Emitted code must write a constant parameter `P` as `{ P }` in generic arguments: rustc takes `P` for a type of the user otherwise. Types and
/// traits beside the implementations must be on the list of names that no struct can have.
#[test]
fn names_of_emitted_code_do_not_clash_with_types_of_the_user() {
    let files = sources::files();
    let chosen = files.iter().filter(|file| file.starts_with("tests/src") || file.starts_with("tests/language"));
    let (mut constants, mut count) = (0, 0);
    for (entry, tokens) in chosen.flat_map(|file: &std::path::PathBuf| expansions(Path::new(file))) {
        let Ok(file) = syn::parse2::<syn::File>(tokens) else { continue };
        count += 1;
        let system = file.items.iter().find_map(|item| match item {
            syn::Item::Struct(system) => Some(system.ident.to_string()),
            _ => None,
        });
        // Every implementation is a scope of its own.
        for item in file.items.iter().filter_map(hidden_statements).flatten() {
            let mut names = Names::default();
            names.visit_stmt(item);
            for constant in &names.constants {
                assert!(!names.paths.contains(constant), "{entry}: `{constant}` stands for a type without braces");
            }
            // Longer names follow from the name of the struct.
            for name in names.types.iter().filter(|name| !system.as_ref().is_some_and(|system| name.ends_with(system)))
            {
                assert!(DECLARED.contains(&&**name), "{entry}: `{name}` is not on the list of declared names");
            }
            constants += names.constants.len();
        }
    }
    assert!(count > 100 && constants > 100, "{count} expansions with {constants} constant parameters");
}
