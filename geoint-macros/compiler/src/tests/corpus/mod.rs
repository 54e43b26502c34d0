//! The corpus of emitted code: the test expands every annotated function of the repository, and compares a hash of each expansion with the
//! list `expansions.txt`.
//!
//! The list shows whether a change of the compiler changes emitted code, and for which functions. A refactoring of the
//! compiler must change no hash. A new or edited annotated function changes the list.
//!
//! The test reads Rust files and Markdown pages, and the code blocks of doc comments. It also expands each `macro_rules!` that a file both defines
//! and calls. A function that the scan misses fails the test. A refusal by the compiler is an outcome.
//!
//! `UPDATE_EXPECT=1` rewrites the list. `EXPANSIONS=NAME` writes all expansions as formatted code to the folder
//! `target/geoint/expansions/NAME`. To read a difference, write the folders `before` and `after`, and compare them by `diff -r`.

mod changes; // Tests of the comparison.
mod comparison; // Hashes, and the comparison with the list.
mod expansion; // Expansion of an annotated function to its final code.
mod export; // Formatted files of expansions.
mod names; // Names that emitted code declares.
mod rules; // Patterns of `macro_rules!`, and how they match.
mod scan; // Search for annotated functions in tokens.
mod sources; // Search for files and code blocks.
mod transcription; // Expansion of `macro_rules!`.
mod written; // Attributes and annotated functions as the source has them.

use crate::parse::Form;
use comparison::{Differences, Entry};
use expansion::Outcome;
use proc_macro2::TokenStream;
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::{env, fs, thread};

/// All forms of systems. The corpus must contain each of them. A new form must be added by hand.
const FORMS: [Form; 8] = [
    Form::Hamiltonian,
    Form::Contact,
    Form::Bodies,
    Form::Structured,
    Form::Field,
    Form::Lagrangian,
    Form::Herglotz,
    Form::FirstOrder,
];

/// The least number of annotated functions, deliberately below the number in the list. A scan that finds fewer is broken.
const AT_LEAST: usize = 1400;

/// The stack of a thread of rustc, in bytes. Expansions must succeed with this stack, because rustc runs the macros on it.
const STACK: usize = 8 << 20;

/// The comment at the top of the list.
const HEADER: &str = "\
# Hashes of the code that is emitted for the functions of this repository: path, name, outcome, FNV-1a of the tokens.
# Written by `UPDATE_EXPECT=1 cargo test -p geoint-compiler corpus`.
";

/// The advice that follows the differences.
const HELP: &str = "\
The code that is emitted for these functions is not the code of src/tests/corpus/expansions.txt.
If this is intended: `UPDATE_EXPECT=1 cargo test -p geoint-compiler corpus` rewrites the list.
To read the difference: run `EXPANSIONS=before cargo test -p geoint-compiler corpus` without the change, run it with
`EXPANSIONS=after` with the change, and compare the folders `target/geoint/expansions/{before,after}` by `diff -r`.
";

#[test]
fn expansions_equal_the_list() {
    let list = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/tests/corpus/expansions.txt");
    let found = expanded(&sources::files());
    assert!(found.len() >= AT_LEAST, "the scan finds {} functions, fewer than {AT_LEAST}", found.len());
    for form in FORMS {
        assert!(found.iter().any(|entry| entry.outcome == Outcome::System(form)), "no system is {form:?}");
    }
    if env::var_os("UPDATE_EXPECT").is_some() {
        let lines: String = found.iter().map(ToString::to_string).collect();
        fs::write(list, HEADER.to_owned() + &lines).expect("the list is written");
        return;
    }
    let differences = Differences::between(&fs::read_to_string(list).unwrap_or_default(), &found);
    assert!(differences.is_empty(), "\n{differences}\n{HELP}");
}

/// Expands all annotated functions of some files, on a thread for each processor. Writes the expansions if `EXPANSIONS` is set.
///
/// Returns the entries in the order of `files`, so that the list does not depend on the threads.
fn expanded(files: &[PathBuf]) -> Vec<Entry> {
    let folder = export::folder();
    let next = AtomicUsize::new(0);
    let work = || {
        let mut done = vec![];
        while let Some(file) = files.get(next.fetch_add(1, Ordering::Relaxed)) {
            for (entry, tokens) in expansions(file) {
                if let Some(folder) = &folder {
                    export::write(folder, &entry, &tokens);
                }
                done.push((file, entry));
            }
        }
        done
    };
    let mut found = thread::scope(|scope| {
        let threads = thread::available_parallelism().map_or(1, usize::from);
        let spawned: Vec<_> = (0..threads)
            .map(|_| thread::Builder::new().stack_size(STACK).spawn_scoped(scope, work).expect("a thread"))
            .collect();
        spawned.into_iter().flat_map(|thread| thread.join().expect("expansions without panics")).collect::<Vec<_>>()
    });
    found.sort_by_key(|(file, _)| *file); // a stable sort keeps the order within a file
    found.into_iter().map(|(_, entry)| entry).collect()
}

/// Expands all annotated functions of a file, in the order of the file.
///
/// A name may occur several times in a file. The second function of a name is `name#2`. Thus path and name identify an entry.
fn expansions(file: &Path) -> Vec<(Entry, TokenStream)> {
    let text = fs::read_to_string(sources::root().join(file)).expect("a text file");
    if !sources::mentions_attribute(&text) {
        return vec![];
    }
    let mut found = scan::Found::default();
    let is_markdown = file.extension().is_some_and(|extension| extension == "md");
    // A Markdown page is in no module, so its scope is empty.
    let scanned = if is_markdown { found.markdown(&text, &[]) } else { found.rust(&text) };
    scanned.unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    assert!(found.missed.is_empty(), "{}: the scan does not expand {:?}", file.display(), found.missed);
    let mut count_by_name: HashMap<String, usize> = HashMap::new();
    let mut expanded = vec![];
    for function in &found.functions {
        let name = function.path();
        let count = count_by_name.entry(name.clone()).or_default();
        *count += 1;
        let name = if *count == 1 { name } else { format!("{name}#{count}") };
        // An attribute may name an energy function of the same file.
        let (outcome, tokens) = expansion::expand(function, &found.functions);
        let entry = Entry { path: file.display().to_string(), name, outcome, hash: comparison::hash(&tokens) };
        expanded.push((entry, tokens));
    }
    expanded
}
