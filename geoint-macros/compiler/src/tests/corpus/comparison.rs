//! Compares expansions with the committed list, which has a line for each function: path, name, kind of expansion, and hash.

use super::expansion::Outcome;
use fnv::FnvHasher;
use proc_macro2::{Delimiter, Spacing, TokenStream, TokenTree};
use std::collections::BTreeMap;
use std::fmt;
use std::hash::Hasher;

/// An expansion in the list.
#[derive(Clone)]
pub(super) struct Entry {
    /// The file below the root of the workspace.
    pub(super) path: String,
    /// The name of the function. The second function of a name in the file is `name#2`.
    pub(super) name: String,
    pub(super) outcome: Outcome,
    pub(super) hash: u64,
}

impl fmt::Display for Entry {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Entry { path, name, outcome, hash } = self;
        writeln!(f, "{path} {name} {outcome} {hash:016x}")
    }
}

/// Returns the 64-bit FNV-1a hash of tokens. It reads their kinds, text, delimiters and spacing, but no spans.
///
/// `to_string` hides groups without delimiters, although these groups change the order of operations.
pub(super) fn hash(tokens: &TokenStream) -> u64 {
    let mut hasher = FnvHasher::default();
    write(tokens, &mut hasher);
    hasher.finish()
}

fn write(tokens: &TokenStream, hasher: &mut FnvHasher) {
    for tree in tokens.clone() {
        match tree {
            TokenTree::Group(group) => {
                let (open, close) = match group.delimiter() {
                    Delimiter::Parenthesis => ("(", ")"),
                    Delimiter::Bracket => ("[", "]"),
                    Delimiter::Brace => ("{", "}"),
                    Delimiter::None => ("open", "close"),
                };
                hasher.write(open.as_bytes());
                write(&group.stream(), hasher);
                hasher.write(close.as_bytes());
            }
            TokenTree::Ident(ident) => hasher.write(ident.to_string().as_bytes()),
            TokenTree::Literal(literal) => hasher.write(literal.to_string().as_bytes()),
            TokenTree::Punct(punct) => {
                hasher.write(punct.as_char().to_string().as_bytes());
                hasher.write_u8((punct.spacing() == Spacing::Joint).into());
            }
        }
        hasher.write_u8(0); // the end of a token
    }
}

/// The functions whose expansion differs from the list, by path and name.
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct Differences {
    pub(super) changed: Vec<String>,
    pub(super) new: Vec<String>,
    pub(super) gone: Vec<String>,
}

impl Differences {
    /// Compares the text of the list with expansions.
    pub(super) fn between(committed: &str, found: &[Entry]) -> Differences {
        let found: String = found.iter().map(ToString::to_string).collect();
        let (committed, found) = (by_function(committed), by_function(&found));
        let mut differences = Differences::default();
        for (&function, kind_and_hash) in &found {
            match committed.get(function) {
                None => differences.new.push(function.to_owned()),
                Some(before) if before != kind_and_hash => differences.changed.push(function.to_owned()),
                Some(_) => {}
            }
        }
        let gone = committed.keys().filter(|function| !found.contains_key(*function));
        differences.gone.extend(gone.map(ToString::to_string));
        differences
    }

    pub(super) fn is_empty(&self) -> bool {
        *self == Differences::default()
    }
}

/// Returns kind and hash of each function of the list. Lines that begin with `#` are comments.
fn by_function(list: &str) -> BTreeMap<&str, &str> {
    let lines = list.lines().filter(|line| !line.starts_with('#'));
    // Path and name have no spaces.
    let split = lines.filter_map(|line| line.match_indices(' ').nth(1).map(|(end, _)| line.split_at(end)));
    split.collect()
}

impl fmt::Display for Differences {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (title, functions) in [("changed", &self.changed), ("new", &self.new), ("gone", &self.gone)] {
            if !functions.is_empty() {
                writeln!(f, "{title} ({}):", functions.len())?;
            }
            for function in functions {
                writeln!(f, "    {function}")?;
            }
        }
        Ok(())
    }
}
