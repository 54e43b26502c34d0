//! Imports between the files of a crate, and circles among them.

mod syntax;

use crate::project::Project;
use std::collections::{BTreeMap, BTreeSet};
use syn::visit::Visit;
use syn::{Item, ItemMod, Visibility};
use syntax::{Names, attributes, flatten, is_for_tests, name};

/// A path of modules from the root of the crate.
type Path = Vec<String>;

/// A module, in a file of its own or within one.
#[derive(Debug, Default)]
struct Module {
    file: String,
    /// Names that `use` declares, with their paths.
    declared: BTreeMap<String, Path>,
    /// Modules whose names are all declared by a glob.
    globs: Vec<Path>,
    /// Names of the module's own items.
    items: BTreeSet<String>,
}

/// A path in the source of a module.
#[derive(Debug)]
struct Written {
    module: Path,
    path: Path,
    /// The name of a re-export, which is an import only if the file uses it.
    re_exported: Option<String>,
}

/// All modules of a crate, without its tests.
#[derive(Debug, Default)]
struct Crate {
    modules: BTreeMap<Path, Module>,
    written: Vec<Written>,
    /// For each file, the names outside of `use`.
    used: BTreeMap<String, BTreeSet<String>>,
}

/// For each file, the files that it imports.
type Edges = BTreeMap<String, BTreeSet<String>>;

/// Returns all circles of files of the crate with this root: files that import each other, directly or through other files.
///
/// A file may use the modules below it, which may use it. An import leads to the file of the item, not to a file that re-exports the item. A
/// name that a file re-exports and does not use is no import. Tests do not count.
///
/// # Panics
/// If a file is missing, or is no Rust.
pub fn circles(project: &Project, root: &str) -> Vec<Vec<String>> {
    let mut all = Crate::default();
    all.load(project, root, vec![]);
    let mut edges = all.edges();
    for (file, targets) in &mut edges {
        let below = format!("{}/", folder(file));
        targets.retain(|target| !target.starts_with(&below));
    }
    let reached: BTreeMap<&String, BTreeSet<&String>> = edges.keys().map(|file| (file, reach(&edges, file))).collect();
    let mut found: Vec<Vec<String>> = vec![];
    for (file, others) in &reached {
        if others.contains(file) && !found.iter().any(|circle| circle.contains(file)) {
            let leads_back = |other: &&&String| reached.get(**other).is_some_and(|others| others.contains(file));
            found.push(others.iter().filter(leads_back).map(|file| (*file).clone()).collect());
        }
    }
    found
}

/// Returns the files that imports reach from a file.
fn reach<'a>(edges: &'a Edges, from: &str) -> BTreeSet<&'a String> {
    let mut found = BTreeSet::new();
    let mut open: Vec<&String> = edges.get(from).into_iter().flatten().collect();
    while let Some(file) = open.pop() {
        if found.insert(file) {
            open.extend(edges.get(file).into_iter().flatten());
        }
    }
    found
}

/// Returns the folder of the modules that a file declares.
fn folder(file: &str) -> &str {
    let own = file.strip_suffix("/mod.rs").or(file.strip_suffix("/lib.rs"));
    own.unwrap_or(file.trim_end_matches(".rs"))
}

impl Crate {
    /// Loads the module in `file`, and its children.
    fn load(&mut self, project: &Project, file: &str, path: Path) {
        let text = project.read(file).unwrap_or_else(|| panic!("{file} is missing"));
        let syntax = syn::parse_file(text).unwrap_or_else(|error| panic!("{file}: {error}"));
        self.used.entry(file.to_owned()).or_default();
        self.items(project, &syntax.items, file, &path);
    }

    fn items(&mut self, project: &Project, items: &[Item], file: &str, path: &Path) {
        let module = self.modules.entry(path.clone()).or_default();
        file.clone_into(&mut module.file);
        for item in items.iter().filter(|item| !is_for_tests(attributes(item))) {
            match item {
                Item::Mod(ItemMod { ident, content, .. }) => {
                    let child = [&path[..], &[ident.to_string()]].concat();
                    match content {
                        Some((_, items)) => self.items(project, items, file, &child),
                        None => {
                            let folder = folder(file);
                            let [flat, nested] = [format!("{folder}/{ident}.rs"), format!("{folder}/{ident}/mod.rs")];
                            let file = if project.read(&flat).is_some() { flat } else { nested };
                            self.load(project, &file, child);
                        }
                    }
                }
                Item::Use(item) => {
                    let mut found = vec![];
                    flatten(&item.tree, &mut vec![], &mut found);
                    let private = matches!(item.vis, Visibility::Inherited);
                    for (name, target) in found {
                        let Some(target) = absolute(path, &target, self) else { continue };
                        let module = self.modules.get_mut(path).expect("it is being loaded");
                        match &name {
                            Some(name) => drop(module.declared.insert(name.clone(), target.clone())),
                            None => module.globs.push(target.clone()),
                        }
                        let re_exported = if private { None } else { Some(name.unwrap_or_default()) };
                        self.written.push(Written { module: path.clone(), path: target, re_exported });
                    }
                }
                item => {
                    let mut names = Names { paths: vec![], words: BTreeSet::new() };
                    names.visit_item(item);
                    self.used.entry(file.to_owned()).or_default().append(&mut names.words);
                    for written in names.paths {
                        self.written.push(Written { module: path.clone(), path: written, re_exported: None });
                    }
                    if let Some(name) = name(item) {
                        self.modules.get_mut(path).expect("it is being loaded").items.insert(name);
                    }
                }
            }
        }
    }

    /// Returns, for each file, the files that it imports.
    fn edges(&self) -> Edges {
        let mut edges = Edges::new();
        for written in &self.written {
            let file = &self.modules[&written.module].file;
            if written.re_exported.as_ref().is_some_and(|name| !self.used[file].contains(name)) {
                continue;
            }
            let Some(target) = self.target(&written.module, &written.path) else { continue };
            if target != *file {
                edges.entry(file.clone()).or_default().insert(target);
            }
        }
        edges
    }

    /// Returns the file of the item at the end of a path in a module. Modules and items of other crates have none.
    fn target(&self, module: &Path, path: &Path) -> Option<String> {
        let path = match path.first()?.as_str() {
            "crate" => path[1..].to_vec(),
            _ => absolute(module, path, self)?[1..].to_vec(),
        };
        self.item(&path, 0)
    }

    fn item(&self, path: &[String], depth: usize) -> Option<String> {
        let mut at: Path = vec![];
        for (i, name) in path.iter().enumerate() {
            let child = [&at[..], std::slice::from_ref(name)].concat();
            if self.modules.contains_key(&child) {
                at = child;
                continue;
            }
            let module = &self.modules[&at];
            if module.items.contains(name) || depth > 16 {
                return Some(module.file.clone());
            }
            if let Some(target) = module.declared.get(name) {
                let path = [&target[1..], &path[i + 1..]].concat();
                return self.item(&path, depth + 1).or(Some(module.file.clone()));
            }
            for glob in &module.globs {
                let within = self.modules.get(&glob[1..]);
                if within.is_some_and(|module| module.items.contains(name) || module.declared.contains_key(name)) {
                    return self.item(&[&glob[1..], &path[i..]].concat(), depth + 1);
                }
            }
            return Some(module.file.clone());
        }
        None
    }
}

/// Returns a path from the root, if it leads into this crate.
fn absolute(module: &Path, path: &[String], all: &Crate) -> Option<Path> {
    let mut at = module.clone();
    let mut rest = path;
    match rest.first()?.as_str() {
        "crate" => return Some(path.to_vec()),
        "self" => rest = &rest[1..],
        "super" => {
            while rest.first().is_some_and(|name| name == "super") {
                at.pop();
                rest = &rest[1..];
            }
        }
        first => {
            let child = [&at[..], &[first.to_owned()]].concat();
            let declared = all.modules.get(module).and_then(|module| module.declared.get(first));
            if let Some(target) = declared {
                return Some([&target[..], &rest[1..]].concat());
            }
            if !all.modules.contains_key(&child) {
                return None;
            }
        }
    }
    Some([&["crate".to_owned()][..], &at, rest].concat())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(files: &[(&str, &str)]) -> Vec<Vec<String>> {
        circles(&Project::of(files), "a/lib.rs")
    }

    #[test]
    fn files_that_import_each_other_are_a_circle() {
        let lib = ("a/lib.rs", "mod one; mod two;");
        let one = ("a/one.rs", "use super::two::Two; pub struct One(Two);");
        assert_eq!(
            found(&[lib, one, ("a/two.rs", "use crate::one::One; pub struct Two(One);")]),
            [["a/one.rs", "a/two.rs"]]
        );
        // A path in the code or in a macro is an import, too.
        assert_eq!(found(&[lib, one, ("a/two.rs", "pub struct Two; fn f() -> crate::one::One { todo!() }")]).len(), 1);
        assert_eq!(found(&[lib, one, ("a/two.rs", "pub struct Two; m! { crate::one::One }")]).len(), 1);
        assert!(found(&[lib, one, ("a/two.rs", "pub struct Two; // crate::one::One")]).is_empty());
        assert!(
            found(&[lib, one, ("a/two.rs", "pub struct Two; #[cfg(test)] mod tests { use crate::one::One; }")])
                .is_empty()
        );
    }

    #[test]
    fn longer_circles_are_found_behind_re_exports() {
        let lib = ("a/lib.rs", "mod one; mod two; mod three; pub use one::One; pub use three::Three;");
        let files = [
            lib,
            ("a/one.rs", "use super::two::Two; pub struct One(Two);"),
            ("a/two.rs", "use crate::Three; pub struct Two(Three);"),
        ];
        let three = |text| found(&[files[0], files[1], files[2], ("a/three.rs", text)]);
        assert_eq!(three("use crate::One; pub struct Three(One);"), [["a/one.rs", "a/three.rs", "a/two.rs"]]);
        assert!(three("pub struct Three;").is_empty());
    }

    #[test]
    fn a_parent_and_its_modules_are_no_circle() {
        let files =
            [("a/lib.rs", "mod one; fn f() -> one::One { one::One }"), ("a/one.rs", "use super::f; pub struct One;")];
        assert!(found(&files).is_empty());
    }

    #[test]
    fn the_crates_have_no_circles() {
        let project = Project::here();
        for root in ["geoint-macros/compiler/src/lib.rs", "geoint-runtime/src/lib.rs"] {
            assert_eq!(circles(&project, root), Vec::<Vec<String>>::new());
        }
    }
}
