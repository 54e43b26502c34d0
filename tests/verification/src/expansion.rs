//! Expansion of `macro_rules!`, because macros write some tests of the project.

use proc_macro2::{Delimiter, Group, Ident, Punct, Spacing, Span, TokenStream, TokenTree};
use quote::ToTokens;
use std::collections::BTreeMap;
use syn::ext::IdentExt;
use syn::parse::discouraged::Speculative;
use syn::parse::{ParseStream, Parser};

/// A macro by its rules: a pattern and the tokens in its place.
#[derive(Clone, Debug)]
pub(crate) struct Macro(Vec<(Vec<Pattern>, TokenStream)>);

#[derive(Clone, Debug)]
enum Pattern {
    Token(TokenTree),
    Group(Delimiter, Vec<Pattern>),
    /// `$name:kind`.
    Fragment(String, String),
    /// `$(…) separator operator`.
    Repetition(Vec<Pattern>, Vec<TokenTree>, char),
}

/// The tokens of a fragment, or its bindings in each repetition.
#[derive(Clone, Debug)]
enum Binding {
    One(TokenStream),
    Many(Vec<Binding>),
}

type Bindings = BTreeMap<String, Binding>;

impl Macro {
    /// Reads the rules of `macro_rules!`.
    pub(crate) fn new(rules: TokenStream) -> Self {
        let groups = rules.into_iter().filter_map(|token| match token {
            TokenTree::Group(group) => Some(group.stream()),
            _ => None,
        });
        let groups: Vec<TokenStream> = groups.collect();
        Macro(groups.chunks_exact(2).map(|rule| (patterns(rule[0].clone()), rule[1].clone())).collect())
    }

    /// Returns the tokens in place of an invocation with these arguments, if a rule matches them.
    pub(crate) fn expand(&self, arguments: &TokenStream) -> Option<TokenStream> {
        self.0.iter().find_map(|(patterns, body)| {
            let parser = |input: ParseStream<'_>| {
                let mut found = Bindings::new();
                matched(patterns, input, &mut found).map(|()| found)
            };
            Some(transcribed(body, &parser.parse2(arguments.clone()).ok()?))
        })
    }
}

fn is_punct(token: Option<&TokenTree>, accepted: &[char]) -> bool {
    matches!(token, Some(TokenTree::Punct(punct)) if accepted.contains(&punct.as_char()))
}

/// Splits `separator operator` off the tokens behind a repetition. Returns the number of tokens, too.
fn repeated(tokens: &[TokenTree]) -> (Vec<TokenTree>, char, usize) {
    let operators = ['*', '+', '?'];
    let length = tokens.iter().position(|token| is_punct(Some(token), &operators)).expect("an operator");
    let TokenTree::Punct(operator) = &tokens[length] else { unreachable!("just found") };
    (tokens[..length].to_vec(), operator.as_char(), length + 1)
}

fn patterns(tokens: TokenStream) -> Vec<Pattern> {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let mut found = vec![];
    let mut i = 0;
    while i < tokens.len() {
        let dollar = is_punct(tokens.get(i), &['$']);
        match (&tokens[i], tokens.get(i + 1)) {
            (_, Some(TokenTree::Ident(name))) if dollar => {
                let kind = tokens.get(i + 3).map(ToString::to_string).unwrap_or_default();
                found.push(Pattern::Fragment(name.to_string(), kind));
                i += 4;
            }
            (_, Some(TokenTree::Group(group))) if dollar => {
                let (separator, operator, length) = repeated(&tokens[i + 2..]);
                found.push(Pattern::Repetition(patterns(group.stream()), separator, operator));
                i += 2 + length;
            }
            (TokenTree::Group(group), _) => {
                found.push(Pattern::Group(group.delimiter(), patterns(group.stream())));
                i += 1;
            }
            (token, _) => {
                found.push(Pattern::Token(token.clone()));
                i += 1;
            }
        }
    }
    found
}

fn matched(patterns: &[Pattern], input: ParseStream<'_>, found: &mut Bindings) -> syn::Result<()> {
    for pattern in patterns {
        match pattern {
            Pattern::Token(expected) => same(expected, input)?,
            Pattern::Group(delimiter, inner) => {
                let group: Group = input.parse()?;
                if group.delimiter() != *delimiter {
                    return Err(input.error("another delimiter"));
                }
                (|input: ParseStream<'_>| matched(inner, input, found)).parse2(group.stream())?;
            }
            Pattern::Fragment(name, kind) => {
                found.insert(name.clone(), Binding::One(fragment(kind, input)?));
            }
            Pattern::Repetition(inner, separator, operator) => {
                let all = repetitions(inner, separator, *operator, input)?;
                for name in names(inner) {
                    let each = all.iter().map(|one| one[&name].clone()).collect();
                    found.insert(name, Binding::Many(each));
                }
            }
        }
    }
    Ok(())
}

fn same(expected: &TokenTree, input: ParseStream<'_>) -> syn::Result<()> {
    let token: TokenTree = input.parse()?;
    if token.to_string() == expected.to_string() { Ok(()) } else { Err(input.error("another token")) }
}

fn repetitions(
    inner: &[Pattern],
    separator: &[TokenTree],
    operator: char,
    input: ParseStream<'_>,
) -> syn::Result<Vec<Bindings>> {
    let mut all = vec![];
    while !input.is_empty() && (operator != '?' || all.is_empty()) {
        let fork = input.fork();
        let mut one = Bindings::new();
        let separated = all.is_empty() || separator.iter().all(|token| same(token, &fork).is_ok());
        if !separated || matched(inner, &fork, &mut one).is_err() {
            break;
        }
        input.advance_to(&fork);
        all.push(one);
    }
    if operator == '+' && all.is_empty() { Err(input.error("nothing repeats")) } else { Ok(all) }
}

fn fragment(kind: &str, input: ParseStream<'_>) -> syn::Result<TokenStream> {
    Ok(match kind {
        "ident" => input.call(Ident::parse_any)?.into_token_stream(),
        "ty" => grouped(input.parse::<syn::Type>()?),
        "expr" => grouped(input.parse::<syn::Expr>()?),
        "literal" => {
            let sign: Option<syn::Token![-]> = input.parse()?;
            let literal: syn::Lit = input.parse()?;
            [sign.into_token_stream(), literal.into_token_stream()].into_iter().collect()
        }
        "path" => input.parse::<syn::Path>()?.into_token_stream(),
        "meta" => input.parse::<syn::Meta>()?.into_token_stream(),
        "block" => input.parse::<syn::Block>()?.into_token_stream(),
        "pat" => syn::Pat::parse_multi(input)?.into_token_stream(),
        "tt" => input.parse::<TokenTree>()?.into_token_stream(),
        _ => return Err(input.error("a fragment of another kind")),
    })
}

/// Returns tokens that stay together next to any operators.
fn grouped(tokens: impl ToTokens) -> TokenStream {
    TokenTree::Group(Group::new(Delimiter::None, tokens.into_token_stream())).into()
}

fn names(patterns: &[Pattern]) -> Vec<String> {
    let mut found = vec![];
    for pattern in patterns {
        match pattern {
            Pattern::Token(_) => {}
            Pattern::Fragment(name, _) => found.push(name.clone()),
            Pattern::Group(_, inner) | Pattern::Repetition(inner, ..) => found.extend(names(inner)),
        }
    }
    found
}

fn transcribed(body: &TokenStream, bindings: &Bindings) -> TokenStream {
    let tokens: Vec<TokenTree> = body.clone().into_iter().collect();
    let mut written = TokenStream::new();
    let mut i = 0;
    while i < tokens.len() {
        let dollar = is_punct(tokens.get(i), &['$']);
        match (&tokens[i], tokens.get(i + 1)) {
            (_, Some(TokenTree::Ident(name))) if dollar => {
                match bindings.get(&name.to_string()) {
                    Some(Binding::One(tokens)) => written.extend(tokens.clone()),
                    _ if name == "crate" => written.extend([TokenTree::Ident(Ident::new("crate", Span::call_site()))]),
                    _ => written.extend([TokenTree::Punct(Punct::new('$', Spacing::Alone)), name.clone().into()]),
                }
                i += 2;
            }
            (_, Some(TokenTree::Group(group))) if dollar => {
                let (separator, _, length) = repeated(&tokens[i + 2..]);
                for (k, one) in each(&group.stream(), bindings).iter().enumerate() {
                    if k > 0 {
                        written.extend(separator.clone());
                    }
                    written.extend(transcribed(&group.stream(), one));
                }
                i += 2 + length;
            }
            (TokenTree::Group(group), _) => {
                let inner = transcribed(&group.stream(), bindings);
                written.extend([TokenTree::Group(Group::new(group.delimiter(), inner))]);
                i += 1;
            }
            (token, _) => {
                written.extend([token.clone()]);
                i += 1;
            }
        }
    }
    written
}

/// Returns the bindings in each repetition of tokens.
fn each(tokens: &TokenStream, bindings: &Bindings) -> Vec<Bindings> {
    let mut words = vec![];
    words_of(tokens, &mut words);
    let repeated = bindings.iter().filter_map(|(name, binding)| match binding {
        Binding::Many(all) if words.contains(name) => Some((name, all)),
        _ => None,
    });
    let repeated: Vec<(&String, &Vec<Binding>)> = repeated.collect();
    let count = repeated.iter().map(|(_, all)| all.len()).min().unwrap_or_default();
    let one = |k: usize| {
        let mut one = bindings.clone();
        one.extend(repeated.iter().map(|(name, all)| ((*name).clone(), all[k].clone())));
        one
    };
    (0..count).map(one).collect()
}

fn words_of(tokens: &TokenStream, words: &mut Vec<String>) {
    for token in tokens.clone() {
        match token {
            TokenTree::Group(group) => words_of(&group.stream(), words),
            TokenTree::Ident(ident) => words.push(ident.to_string()),
            _ => {}
        }
    }
}
