//! Names of tests, examples and refused programs in pages, and their existence.

use crate::programs::{Tests, parsed};
use crate::project::Project;
use std::collections::BTreeMap;
use syn::Item;

/// Crates whose unit tests are named by the folder of their module.
const CRATES: [&str; 2] = ["geoint-macros/compiler/src", "geoint-runtime/src"];

/// Folders of programs that must not compile.
const MISTAKES: [&str; 2] = ["tests/messages/src/ui", "tests/essentials/mistakes"];

/// Looks names up in a project. Each program is read once.
#[derive(Debug)]
pub struct Names<'a> {
    project: &'a Project,
    programs: BTreeMap<String, Tests>,
}

impl<'a> Names<'a> {
    /// Returns the names of a project.
    pub fn of(project: &'a Project) -> Self {
        Names { project, programs: BTreeMap::new() }
    }

    /// Returns whether `folder::test` names a test in a file below the folder. The file must belong to a program that `cargo test` runs.
    pub fn is_test(&mut self, name: &str) -> bool {
        let Some((folder, test)) = name.rsplit_once("::") else { return false };
        self.tests(folder).is_some_and(|tests| tests.has(folder, test))
    }

    /// Returns the faults of a page: references in backticks that lead nowhere, and names without the place of a test.
    ///
    /// A reference begins with `tests/`, `geoint-macros/` or `geoint-runtime/` and names a test or a file with tests, or it begins with `example::` or
    /// `refused::`. Other words in backticks are code. A word of small letters, digits and underscores is no code, so that a name without
    /// a place is a fault.
    pub fn faults(&mut self, page: &str) -> Vec<String> {
        let words = page.split('`').skip(1).step_by(2);
        words.filter_map(|word| Some(format!("`{word}` {}", self.fault(word)?))).collect()
    }

    fn fault(&mut self, word: &str) -> Option<&'static str> {
        let fault = |is: bool, message: &'static str| if is { None } else { Some(message) };
        if let Some(name) = word.strip_prefix("example::") {
            return fault(self.is_example(name), "is no example");
        }
        if let Some(name) = word.strip_prefix("refused::") {
            return fault(self.is_refused(name), "is no program that is refused");
        }
        let prefixes = ["tests/", "geoint-macros/", "geoint-runtime/"];
        if prefixes.iter().any(|prefix| word.starts_with(prefix)) {
            return match word.contains("::") {
                true => fault(self.is_test(word), "is no test"),
                false => fault(self.is_file_of_tests(word), "is no file with tests"),
            };
        }
        let small = |letter: char| letter.is_ascii_lowercase() || letter.is_ascii_digit() || letter == '_';
        let like_a_name = word.chars().all(small) || word.contains('/');
        fault(!like_a_name, "has no place")
    }

    fn is_example(&self, name: &str) -> bool {
        self.project.read(&format!("examples/src/bin/{name}.rs")).is_some()
    }

    fn is_refused(&self, name: &str) -> bool {
        let is_module = |item: &Item| matches!(item, Item::Mod(module) if module.ident == name);
        let mut files = MISTAKES.iter().flat_map(|folder| self.project.below(folder));
        files.any(|(path, text)| parsed(path, text).iter().any(is_module))
    }

    fn is_file_of_tests(&mut self, path: &str) -> bool {
        let Some((folder, _)) = path.rsplit_once('/') else { return false };
        self.tests(folder).is_some_and(|tests| tests.has_file(path))
    }

    /// Returns the tests of the program to which a folder belongs.
    fn tests(&mut self, folder: &str) -> Option<&Tests> {
        let root = self.root(folder)?;
        let project = self.project;
        Some(self.programs.entry(root).or_insert_with_key(|root| Tests::of(project, root)))
    }

    /// Returns the root file of this program. A folder of tests has a `main.rs` that the manifest names.
    fn root(&self, folder: &str) -> Option<String> {
        if let Some(of) = CRATES.iter().find(|of| folder == **of || folder.starts_with(&format!("{of}/"))) {
            return Some(format!("{of}/lib.rs"));
        }
        let program = folder.strip_prefix("tests/")?.split('/').next()?;
        let manifest = self.project.read("tests/Cargo.toml")?;
        manifest.contains(&format!("path = \"{program}/main.rs\"")).then(|| format!("tests/{program}/main.rs"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FILES: [(&str, &str); 7] = [
        ("tests/Cargo.toml", "[[test]]\npath = \"laws/main.rs\""),
        (
            "tests/laws/main.rs",
            "mod energies;\nmacro_rules! each { ($($of:ident $test:ident),*) => { $( #[test] fn $test() {} )* }; }",
        ),
        (
            "tests/laws/energies.rs",
            "//! not_a_comment\n#[test] fn energy_stays() {}\nfn no_test() { \"fn not_a_string()\"; }\n#[test] #[ignore] fn asleep() {}\n\
             each! { Top top_turns, Ball ball_falls }\n#[cfg(test)] mod within { #[test] fn inner() {} }\n#[test] fn last() {}",
        ),
        ("tests/laws/orphan.rs", "#[test] fn belongs_to_no_program() {}"),
        (
            "geoint-macros/compiler/src/lib.rs",
            "#[cfg(test)] mod tests { proptest! { #[test] fn drawn(x in 0..3) {} } }",
        ),
        ("examples/src/bin/pendulum.rs", "fn main() {}"),
        ("tests/messages/src/ui/fields.rs", "mod field_swells { fn inside() {} }\n// mod in_a_comment {}"),
    ];

    fn faults(word: &str) -> usize {
        let project = Project::of(&FILES);
        Names::of(&project).faults(&format!("A row with `{word}` in it.")).len()
    }

    #[test]
    fn tests_are_found() {
        for test in ["energy_stays", "top_turns", "ball_falls", "inner", "last"] {
            assert_eq!(faults(&format!("tests/laws::{test}")), 0, "{test}");
        }
        assert_eq!(faults("geoint-macros/compiler/src::drawn"), 0);
        assert_eq!(faults("tests/laws/energies.rs"), 0);
    }

    #[test]
    fn names_that_are_no_tests_are_faults() {
        let names = [
            "not_a_comment",
            "not_a_string",
            "no_test",
            "asleep",
            "Top",
            "Ball",
            "belongs_to_no_program",
            "each",
            "gone",
        ];
        for name in names {
            assert_eq!(faults(&format!("tests/laws::{name}")), 1, "{name}");
        }
        // Another folder, and files that are missing or have no test.
        for name in ["tests/rules::energy_stays", "tests/laws/gone.rs", "tests/laws/main.rs", "tests/laws/orphan.rs"] {
            assert_eq!(faults(name), 1, "{name}");
        }
    }

    #[test]
    fn examples_and_refused_programs_exist() {
        assert_eq!([faults("example::pendulum"), faults("example::top")], [0, 1]);
        assert_eq!(
            [faults("refused::field_swells"), faults("refused::in_a_comment"), faults("refused::inside")],
            [0, 1, 1]
        );
    }

    #[test]
    fn names_without_a_place_are_faults() {
        for name in ["energy_stays", "pendulum", "benches/README.md"] {
            assert_eq!(faults(name), 1, "{name}");
        }
        for code in
            ["keeps(…)", "structure = …", "Projection(method, Integrals)", "#[vector_field]", "ContactGauss::<2>"]
        {
            assert_eq!(faults(code), 0, "{code}");
        }
    }
}
