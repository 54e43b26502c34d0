//! Expands the `macro_rules!` of a file that have annotated functions.

use super::rules::{Binding, Bindings, Repeat, Rule, repetition, rules};
use super::sources::mentions_attribute;
use proc_macro2::{Group, Ident, Span, TokenStream, TokenTree};

/// The macros of a file that have annotated functions in their rules.
#[derive(Default)]
pub(super) struct Macros(Vec<Macro>);

struct Macro {
    name: String,
    rules: Vec<Rule>,
    is_used: bool,
}

impl Macros {
    /// Adds a macro if an attribute is named in its rules.
    pub(super) fn define(&mut self, name: String, definition: TokenStream) {
        if mentions_attribute(&definition.to_string()) {
            self.0.push(Macro { name, rules: rules(definition), is_used: false });
        }
    }

    /// Expands a call. Returns nothing if the file has no such macro. Errors: the name of a macro if no rule is found to match.
    pub(super) fn expand(&mut self, name: &str, arguments: &TokenStream) -> Result<Option<TokenStream>, String> {
        let Some(called) = self.0.iter_mut().rev().find(|called| called.name == name) else { return Ok(None) };
        called.is_used = true;
        for rule in &called.rules {
            if let Some(bindings) = rule.matches(arguments.clone()) {
                return Ok(Some(transcribed(rule.body.clone(), &bindings)));
            }
        }
        Err(called.name.clone())
    }

    /// Returns the names of macros that the file does not call.
    pub(super) fn unused(&self) -> impl Iterator<Item = &String> {
        self.0.iter().filter(|defined| !defined.is_used).map(|defined| &defined.name)
    }
}

/// Returns the body of a rule with the values of its fragments.
fn transcribed(body: TokenStream, bindings: &Bindings) -> TokenStream {
    let trees: Vec<TokenTree> = body.into_iter().collect();
    let mut written = TokenStream::new();
    let mut rest = &trees[..];
    while let Some((first, behind)) = rest.split_first() {
        rest = behind;
        match (first, behind) {
            (TokenTree::Punct(dollar), [TokenTree::Ident(name), ..]) if dollar.as_char() == '$' => {
                rest = &behind[1..];
                match bindings.get(&name.to_string()) {
                    Some(Binding::Tokens(tokens)) => written.extend(tokens.clone()),
                    Some(Binding::Repeated(_)) => {}
                    // `$crate`, or a fragment of a macro inside.
                    None if name == "crate" => {
                        written.extend([TokenTree::from(Ident::new("crate", Span::call_site()))])
                    }
                    None => written.extend([first.clone(), behind[0].clone()]),
                }
            }
            (TokenTree::Punct(dollar), [TokenTree::Group(group), behind @ ..]) if dollar.as_char() == '$' => {
                let Repeat { separator, length, .. } = repetition(behind);
                rest = &behind[length..];
                for (i, iteration) in iterations(&group.stream(), bindings).iter().enumerate() {
                    written.extend(separator.clone().filter(|_| i > 0));
                    written.extend(transcribed(group.stream(), iteration));
                }
            }
            (TokenTree::Group(group), _) => {
                let inside = transcribed(group.stream(), bindings);
                written.extend([TokenTree::from(Group::new(group.delimiter(), inside))]);
            }
            (token, _) => written.extend([token.clone()]),
        }
    }
    written
}

/// Returns the values of fragments in each iteration of a repetition.
fn iterations(body: &TokenStream, bindings: &Bindings) -> Vec<Bindings> {
    let repeated = bindings.iter().filter_map(|(name, binding)| match binding {
        Binding::Repeated(values) if names(body, name) => Some((name, values)),
        _ => None,
    });
    let repeated: Vec<_> = repeated.collect();
    let count = repeated.iter().map(|(_, values)| values.len()).max().unwrap_or(0);
    let iteration = |i: usize| {
        let values = repeated.iter().filter_map(|(name, values)| Some(((*name).clone(), values.get(i)?.clone())));
        bindings.clone().into_iter().chain(values).collect()
    };
    (0..count).map(iteration).collect()
}

/// Returns whether `$name` is among the tokens.
fn names(body: &TokenStream, name: &str) -> bool {
    let trees: Vec<TokenTree> = body.clone().into_iter().collect();
    let is_fragment = |pair: &[TokenTree]| match pair {
        [TokenTree::Punct(dollar), TokenTree::Ident(ident)] => dollar.as_char() == '$' && ident == name,
        _ => false,
    };
    trees.windows(2).any(is_fragment)
        || trees.iter().any(|tree| matches!(tree, TokenTree::Group(group) if names(&group.stream(), name)))
}
