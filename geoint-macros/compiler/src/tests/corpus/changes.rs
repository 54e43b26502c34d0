//! Tests of the comparison with the list `expansions.txt` of hashes.
//!
//! The comparison reports a changed token for every form of system, a changed outcome, and new and missing functions. The hash reads every
//! token, and ignores positions in the source. The outcome of an expansion is a system of some form, an energy function, a question,
//! or a refusal. An annotated energy function defines a macro, which attributes call to read the function. If the function is in another
//! file, this call remains, and the outcome is a question.

use super::comparison::{Differences, Entry, hash};
use super::{FORMS, Outcome, expansions};
use proc_macro2::{Group, Ident, Span, TokenStream, TokenTree};
use std::path::Path;
use std::str::FromStr;

/// Returns the text of the list for some entries.
fn list(entries: &[Entry]) -> String {
    entries.iter().map(ToString::to_string).collect()
}

/// Applies a change deep inside the code. Descends into the middle one of the groups until the tokens contain no group, and changes these
/// tokens. Groups without tokens do not count. A hash that reads the outer tokens only would miss the change.
fn in_the_middle(tokens: TokenStream, change: fn(&mut Vec<TokenTree>)) -> TokenStream {
    let mut trees: Vec<TokenTree> = tokens.into_iter().collect();
    let groups: Vec<usize> = (0..trees.len())
        .filter(|&at| matches!(&trees[at], TokenTree::Group(group) if !group.stream().is_empty()))
        .collect();
    match groups.get(groups.len() / 2) {
        Some(&at) => {
            let TokenTree::Group(group) = &trees[at] else { unreachable!("all indices are those of groups") };
            trees[at] = Group::new(group.delimiter(), in_the_middle(group.stream(), change)).into();
        }
        None => change(&mut trees),
    }
    trees.into_iter().collect()
}

/// The changes remove, add and replace a token. `scenes.rs` has one function of every form. The test reads this file as text.
#[test]
fn a_changed_token_is_reported_in_every_form() {
    let scenes = expansions(Path::new("geoint-macros/compiler/src/tests/corpus/scenes.rs"));
    let entries: Vec<Entry> = scenes.iter().map(|(entry, _)| entry.clone()).collect();
    let list = list(&entries);
    assert_eq!(Differences::between(&list, &entries), Differences::default());
    let changes: [fn(&mut Vec<TokenTree>); 3] = [
        |trees| drop(trees.pop()),
        |trees| trees.push(Ident::new("more", Span::call_site()).into()),
        |trees| trees[0] = Ident::new("other", Span::call_site()).into(),
    ];
    for form in FORMS {
        let at = entries.iter().position(|entry| entry.outcome == Outcome::System(form));
        let at = at.unwrap_or_else(|| panic!("no scene is {form:?}"));
        for change in changes {
            let mut changed = entries.clone();
            changed[at].hash = hash(&in_the_middle(scenes[at].1.clone(), change));
            let function = format!("{} {}", entries[at].path, entries[at].name);
            let differences = Differences { changed: vec![function], ..Differences::default() };
            assert_eq!(Differences::between(&list, &changed), differences, "{form:?}");
        }
    }
}

/// `stays#2` is the second function `stays` of the file, and an entry of its own. The list itself tests the numbering.
#[test]
fn new_and_missing_functions_are_reported() {
    let entry = |name: &str| Entry {
        path: "tests/some.rs".to_owned(),
        name: name.to_owned(),
        outcome: Outcome::Refused,
        hash: 1,
    };
    let committed = "# A comment.\n".to_owned() + &list(&[entry("stays"), entry("goes")]);
    let differences = Differences::between(&committed, &[entry("stays"), entry("stays#2")]);
    let expected = Differences {
        new: vec!["tests/some.rs stays#2".to_owned()],
        gone: vec!["tests/some.rs goes".to_owned()],
        ..Differences::default()
    };
    assert_eq!(differences, expected);
    assert_eq!(differences.to_string(), "new (1):\n    tests/some.rs stays#2\ngone (1):\n    tests/some.rs goes\n");
}

/// A changed outcome is reported even if the hash is equal.
#[test]
fn the_outcome_of_an_expansion_is_compared() {
    let [before, after] = [Outcome::Refused, Outcome::Question].map(|outcome| Entry {
        path: "tests/some.rs".to_owned(),
        name: "some".to_owned(),
        outcome,
        hash: 1,
    });
    assert_eq!(Differences::between(&list(&[before]), &[after]).changed, ["tests/some.rs some"]);
}

/// Whitespace and line breaks that separate no tokens change positions only. The hash reads whether two punctuation marks are adjacent.
#[test]
fn hashes_read_every_token_and_no_position() {
    let of = |text: &str| hash(&TokenStream::from_str(text).expect("tokens"));
    for (one, other) in [
        ("a == b", "a = = b"),
        ("1.0", "1.0_f64"),
        ("1.0", "1.00"),
        ("x", "r#x"),
        ("\"x\"", "'x'"),
        ("f(a, b)", "f(a), b"),
        ("(a)", "[a]"),
        ("a b", "ab"),
        ("a + b", "b + a"),
        ("a", ""),
    ] {
        assert_ne!(of(one), of(other), "{one} and {other}");
    }
    assert_eq!(of("fn f() { 1.0 + x }"), of("\n\n fn f ( )\n{1.0+x}"));
    // A group without delimiters has no text, but it changes the order of operations. The hash must include it.
    let inner = TokenStream::from_str("a + b").expect("tokens");
    let group = TokenTree::from(Group::new(proc_macro2::Delimiter::None, inner));
    assert_ne!(hash(&group.into()), of("a + b"));
}
