//! Rules of `macro_rules!`, and how they match: the part of the language that macros with annotated functions use.

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use std::collections::BTreeMap;
use syn::parse::{Parse, ParseStream, Parser};
use syn::{Block, Expr, Pat, Path, Type};

/// A rule, `(pattern) => { body }`.
pub(super) struct Rule {
    pattern: Vec<Pattern>,
    pub(super) body: TokenStream,
}

/// A part of a pattern.
enum Pattern {
    Token(TokenTree),
    Group(Delimiter, Vec<Pattern>),
    /// `$name:kind`
    Fragment {
        name: String,
        kind: String,
    },
    /// `$( … )` with an operator
    Repetition {
        pattern: Vec<Pattern>,
        separator: Option<TokenTree>,
        is_optional: bool,
    },
}

/// The value of a fragment: tokens, or a value for each iteration of a repetition.
#[derive(Clone)]
pub(super) enum Binding {
    Tokens(TokenStream),
    Repeated(Vec<Binding>),
}

/// The values of fragments by name.
pub(super) type Bindings = BTreeMap<String, Binding>;

/// Returns the rules of a macro.
pub(super) fn rules(definition: TokenStream) -> Vec<Rule> {
    let groups = definition.into_iter().filter_map(|tree| match tree {
        TokenTree::Group(group) => Some(group.stream()),
        _ => None,
    });
    let groups: Vec<TokenStream> = groups.collect();
    let (rules, _) = groups.as_chunks();
    rules.iter().map(|[pattern, body]| Rule { pattern: patterns(pattern.clone()), body: body.clone() }).collect()
}

/// The tokens behind `$(…)`.
pub(super) struct Repeat {
    pub(super) separator: Option<TokenTree>,
    /// `*`, `+` or `?`.
    operator: char,
    /// The number of these tokens.
    pub(super) length: usize,
}

/// Returns the separator and the operator behind `$(…)`.
pub(super) fn repetition(behind: &[TokenTree]) -> Repeat {
    let operator = |tree: &TokenTree| match tree {
        TokenTree::Punct(punct) if matches!(punct.as_char(), '*' | '+' | '?') => Some(punct.as_char()),
        _ => None,
    };
    match behind {
        [first, ..] if operator(first).is_some() => {
            Repeat { separator: None, operator: operator(first).unwrap_or('*'), length: 1 }
        }
        [separator, second, ..] => {
            Repeat { separator: Some(separator.clone()), operator: operator(second).unwrap_or('*'), length: 2 }
        }
        _ => Repeat { separator: None, operator: '*', length: behind.len() },
    }
}

fn patterns(tokens: TokenStream) -> Vec<Pattern> {
    let trees: Vec<TokenTree> = tokens.into_iter().collect();
    let mut found = vec![];
    let mut rest = &trees[..];
    while let Some((first, behind)) = rest.split_first() {
        rest = behind;
        found.push(match (first, behind) {
            (TokenTree::Punct(dollar), [TokenTree::Ident(name), TokenTree::Punct(_), TokenTree::Ident(kind), ..])
                if dollar.as_char() == '$' =>
            {
                rest = &behind[3..];
                Pattern::Fragment { name: name.to_string(), kind: kind.to_string() }
            }
            (TokenTree::Punct(dollar), [TokenTree::Group(group), behind @ ..]) if dollar.as_char() == '$' => {
                let Repeat { separator, operator, length } = repetition(behind);
                rest = &behind[length..];
                Pattern::Repetition { pattern: patterns(group.stream()), separator, is_optional: operator == '?' }
            }
            (TokenTree::Group(group), _) => Pattern::Group(group.delimiter(), patterns(group.stream())),
            (token, _) => Pattern::Token(token.clone()),
        });
    }
    found
}

impl Rule {
    /// Returns the values of the fragments if the rule matches the arguments of a macro.
    pub(super) fn matches(&self, arguments: TokenStream) -> Option<Bindings> {
        let trees: Vec<TokenTree> = arguments.into_iter().collect();
        let mut bindings = Bindings::new();
        let rest = all(&self.pattern, &trees, &mut bindings)?;
        rest.is_empty().then_some(bindings)
    }
}

/// Matches patterns with the first tokens. Returns the tokens behind.
fn all<'a>(pattern: &[Pattern], mut trees: &'a [TokenTree], bindings: &mut Bindings) -> Option<&'a [TokenTree]> {
    for part in pattern {
        trees = match part {
            Pattern::Token(token) => {
                let (first, behind) = trees.split_first()?;
                (first.to_string() == token.to_string()).then_some(behind)?
            }
            Pattern::Group(delimiter, pattern) => {
                let (TokenTree::Group(group), behind) = trees.split_first()? else { return None };
                let inside: Vec<TokenTree> = group.stream().into_iter().collect();
                let is_whole = group.delimiter() == *delimiter && all(pattern, &inside, bindings)?.is_empty();
                is_whole.then_some(behind)?
            }
            Pattern::Fragment { name, kind } => {
                let (tokens, behind) = fragment(kind, trees)?;
                bindings.insert(name.clone(), Binding::Tokens(tokens));
                behind
            }
            Pattern::Repetition { pattern, separator, is_optional } => {
                repeated(pattern, separator.as_ref(), *is_optional, trees, bindings)
            }
        };
    }
    Some(trees)
}

/// Matches a repetition as often as possible. Returns the tokens behind.
fn repeated<'a>(
    pattern: &[Pattern],
    separator: Option<&TokenTree>,
    is_optional: bool,
    mut trees: &'a [TokenTree],
    bindings: &mut Bindings,
) -> &'a [TokenTree] {
    let mut iterations: Vec<Bindings> = vec![];
    while !(trees.is_empty() || is_optional && iterations.len() == 1) {
        let next = match (separator, trees) {
            (Some(separator), [first, behind @ ..]) if !iterations.is_empty() => {
                if first.to_string() != separator.to_string() {
                    break;
                }
                behind
            }
            _ => trees,
        };
        let mut iteration = Bindings::new();
        let Some(behind) = all(pattern, next, &mut iteration) else { break };
        iterations.push(iteration);
        trees = behind;
    }
    for name in names(pattern) {
        let values = iterations.iter().map(|iteration| iteration[name].clone()).collect();
        bindings.insert(name.to_owned(), Binding::Repeated(values));
    }
    trees
}

/// Returns the names of all fragments of a pattern.
fn names(pattern: &[Pattern]) -> Vec<&str> {
    let of_part = |part| match part {
        &Pattern::Token(_) => vec![],
        Pattern::Fragment { name, .. } => vec![name.as_str()],
        Pattern::Group(_, pattern) | Pattern::Repetition { pattern, .. } => names(pattern),
    };
    pattern.iter().flat_map(of_part).collect()
}

/// Matches a fragment. Returns its tokens, in a group as rustc has them, and the tokens behind.
fn fragment<'a>(kind: &str, trees: &'a [TokenTree]) -> Option<(TokenStream, &'a [TokenTree])> {
    let length = match (kind, trees) {
        ("ident", [TokenTree::Ident(_), ..]) | ("literal", [TokenTree::Literal(_), ..]) | ("tt", [_, ..]) => 1,
        ("literal", [TokenTree::Punct(minus), TokenTree::Literal(_), ..]) if minus.as_char() == '-' => 2,
        ("expr", _) => parsed::<Expr>(Expr::parse, trees)?,
        ("ty", _) => parsed::<Type>(Type::parse, trees)?,
        ("path", _) => parsed::<Path>(Path::parse, trees)?,
        ("block", _) => parsed::<Block>(Block::parse, trees)?,
        ("pat", _) => parsed::<Pat>(Pat::parse_multi, trees)?,
        _ => return None,
    };
    let (tokens, behind) = trees.split_at(length);
    let tokens = tokens.iter().cloned().collect();
    match kind {
        "ident" | "literal" | "tt" => Some((tokens, behind)),
        _ => Some((TokenTree::from(Group::new(Delimiter::None, tokens)).into(), behind)),
    }
}

/// Returns the number of tokens of some syntax at the start.
fn parsed<T>(parser: fn(ParseStream<'_>) -> syn::Result<T>, trees: &[TokenTree]) -> Option<usize> {
    // No fragment goes beyond a semicolon. A short stream is fast.
    let end = trees.iter().position(|tree| matches!(tree, TokenTree::Punct(punct) if punct.as_char() == ';'));
    let stream: TokenStream = trees[..end.unwrap_or(trees.len())].iter().cloned().collect();
    let length = stream.clone().into_iter().count();
    let rest = |input: ParseStream<'_>| {
        parser(input)?;
        input.parse::<TokenStream>()
    };
    Some(length - rest.parse2(stream).ok()?.into_iter().count())
}
