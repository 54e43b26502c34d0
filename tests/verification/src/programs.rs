//! The tests of the project: functions that `cargo test` runs.

use crate::expansion::Macro;
use crate::project::Project;
use proc_macro2::TokenStream;
use std::collections::{BTreeMap, BTreeSet};
use syn::{Attribute, Expr, Item, ItemMod, Lit, Meta};

/// Macros by their names, where they are in scope.
type Macros = BTreeMap<String, Macro>;

/// All tests of a program or a crate.
#[derive(Debug, Default)]
pub(crate) struct Tests {
    /// The file of each test and its name.
    found: BTreeSet<(String, String)>,
    /// Files without tests belong to the program, too.
    files: BTreeSet<String>,
}

impl Tests {
    /// Loads the tests of the program with this root file, and of its modules.
    ///
    /// # Panics
    /// If a file is no Rust, or an invocation of a macro that writes tests has no expansion.
    pub(crate) fn of(project: &Project, root: &str) -> Self {
        let mut tests = Tests::default();
        let mut exported = Macros::new();
        for (path, text) in project.below("tests/src") {
            exported.extend(parsed(path, text).iter().filter_map(definition));
        }
        tests.load(project, root, &exported);
        tests
    }

    /// Returns whether a file below a folder has a test with this name.
    pub(crate) fn has(&self, folder: &str, name: &str) -> bool {
        let folder = format!("{folder}/");
        self.found.iter().any(|(file, test)| file.starts_with(&folder) && test == name)
    }

    /// Returns whether a file has a test.
    pub(crate) fn has_file(&self, path: &str) -> bool {
        self.found.iter().any(|(file, _)| file == path)
    }

    fn load(&mut self, project: &Project, file: &str, macros: &Macros) {
        let Some(text) = project.read(file) else { return };
        if self.files.insert(file.to_owned()) {
            self.walk(project, file, file, parsed(file, text), macros.clone());
        }
    }

    /// Walks over the items of a file. Modules without a body lie beside `place`.
    fn walk(&mut self, project: &Project, file: &str, place: &str, items: Vec<Item>, mut macros: Macros) {
        macros.extend(items.iter().filter_map(definition));
        for item in items {
            match item {
                Item::Fn(item) if is_test(&item.attrs) => {
                    self.found.insert((file.to_owned(), item.sig.ident.to_string()));
                }
                Item::Mod(item) => self.module(project, file, place, item, &macros),
                Item::Macro(item) if item.ident.is_none() => {
                    let name = item.mac.path.segments.last().map(|name| name.ident.to_string()).unwrap_or_default();
                    let items = match macros.get(&name) {
                        Some(rules) => expanded(rules, &item.mac.tokens, file),
                        // The items of `proptest!` are functions with the attributes of tests and with arguments of their own.
                        None if name == "proptest" => {
                            self.found.extend(drawn(item.mac.tokens).into_iter().map(|test| (file.to_owned(), test)));
                            continue;
                        }
                        None => continue,
                    };
                    self.walk(project, file, place, items, macros.clone());
                }
                _ => {}
            }
        }
    }

    fn module(&mut self, project: &Project, file: &str, place: &str, item: ItemMod, macros: &Macros) {
        let name = item.ident.to_string();
        let (parent, last) = place.rsplit_once('/').unwrap_or(("", place));
        let own = ["main.rs", "lib.rs", "mod.rs"].contains(&last);
        let folder = if own { parent.to_owned() } else { place.trim_end_matches(".rs").to_owned() };
        if let Some((_, items)) = item.content {
            return self.walk(project, file, &format!("{folder}/{name}/mod.rs"), items, macros.clone());
        }
        match given_path(&item.attrs) {
            Some(path) => self.load(project, &format!("{parent}/{path}"), macros),
            // Only one of the two exists.
            None => {
                self.load(project, &format!("{folder}/{name}.rs"), macros);
                self.load(project, &format!("{folder}/{name}/mod.rs"), macros);
            }
        }
    }
}

/// Returns the items of a file.
///
/// # Panics
/// If the file is no Rust.
pub(crate) fn parsed(file: &str, text: &str) -> Vec<Item> {
    syn::parse_file(text).unwrap_or_else(|error| panic!("{file}: {error}")).items
}

fn definition(item: &Item) -> Option<(String, Macro)> {
    match item {
        Item::Macro(item) => Some((item.ident.as_ref()?.to_string(), Macro::new(item.mac.tokens.clone()))),
        _ => None,
    }
}

fn expanded(rules: &Macro, arguments: &TokenStream, file: &str) -> Vec<Item> {
    let tokens = rules.expand(arguments).unwrap_or_else(|| panic!("{file}: no rule of a macro matches {arguments}"));
    syn::parse2::<syn::File>(tokens).unwrap_or_else(|error| panic!("{file}: {error} in an expansion")).items
}

/// Returns whether `cargo test` runs a function without a request.
fn is_test(attributes: &[Attribute]) -> bool {
    let has = |name: &str| attributes.iter().any(|attribute| attribute.path().is_ident(name));
    has("test") && !has("ignore")
}

/// Returns the file that `#[path = "…"]` names.
fn given_path(attributes: &[Attribute]) -> Option<String> {
    attributes.iter().find_map(|attribute| match &attribute.meta {
        Meta::NameValue(pair) if pair.path.is_ident("path") => match &pair.value {
            Expr::Lit(literal) => match &literal.lit {
                Lit::Str(path) => Some(path.value()),
                _ => None,
            },
            _ => None,
        },
        _ => None,
    })
}

/// Returns the functions of `proptest!` behind `#[test]`.
fn drawn(tokens: TokenStream) -> Vec<String> {
    let tokens: Vec<String> = tokens.into_iter().map(|token| token.to_string()).collect();
    let mut found = vec![];
    let mut test = false;
    for pair in tokens.windows(2) {
        test |= pair[0] == "#" && pair[1].replace(' ', "") == "[test]";
        if test && pair[0] == "fn" {
            found.push(pair[1].clone());
            test = false;
        }
    }
    found
}
