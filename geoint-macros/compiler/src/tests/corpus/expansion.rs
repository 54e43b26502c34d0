//! Expands an annotated function to its final code. Questions for energy functions are answered from the same file.

use super::written::{Annotated, Attribute, Scope};
use crate::attribute;
use crate::parse::{self, Form, Source};
use proc_macro2::{TokenStream, TokenTree};
use quote::quote;
use std::fmt;
use syn::parse::{ParseStream, Parser};
use syn::{Path, braced};

/// The longest chain of energy functions that name each other.
const MAX_CHAIN: usize = 8;

/// The kind of an expansion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Outcome {
    System(Form),
    EnergyFunction,
    /// A question for an energy function that is not in the file.
    Question,
    /// Messages.
    Refused,
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Outcome::System(form) => write!(f, "{form:?}"),
            other => write!(f, "{other:?}"),
        }
    }
}

/// Expands a function. `file` holds the functions of the same file, among them the energy functions that it names.
pub(super) fn expand(function: &Annotated, file: &[Annotated]) -> (Outcome, TokenStream) {
    let Annotated { attribute, args, item, .. } = function;
    let expansion = match attribute {
        Attribute::System(form) => attribute::expand(*form, args.clone(), item.clone()),
        Attribute::EnergyFunction => attribute::energy_function(args.clone(), item.clone()),
    };
    let mut trees: Vec<TokenTree> = expansion.into_iter().collect();
    let mut is_question = false;
    while let Some(question) = Question::of(&trees) {
        let Some(source) = source(&question.path, &function.scope, file, MAX_CHAIN) else {
            is_question = true;
            break;
        };
        let state = question.state;
        trees.truncate(question.start);
        trees.extend(attribute::resume(quote!(#state { #source })));
    }
    let outcome = if is_question { Outcome::Question } else { outcome(function, &trees) };
    (outcome, trees.into_iter().collect())
}

/// The question of `link::ask` at the end of an expansion.
struct Question {
    /// The place of its first token.
    start: usize,
    path: Path,
    /// The arguments of `resume`, before the answer.
    state: TokenStream,
}

impl Question {
    fn of(trees: &[TokenTree]) -> Option<Question> {
        let [before @ .., TokenTree::Ident(name), TokenTree::Punct(_), TokenTree::Group(group)] = trees else {
            return None;
        };
        if name != "put_energy_function_above_it" {
            return None;
        }
        let parser = |input: ParseStream<'_>| {
            let path;
            braced!(path in input);
            let path = path.parse::<Path>()?;
            input.parse::<proc_macro2::Group>()?; // the path of `resume`
            Ok((path, input.parse::<TokenStream>()?))
        };
        let (path, state) = parser.parse2(group.stream()).expect("the tokens of `link::ask`");
        // The path of the macro follows the body of the function.
        let start = before.iter().rposition(|tree| matches!(tree, TokenTree::Group(_))).map_or(0, |body| body + 1);
        Some(Question { start, path, state })
    }
}

/// Returns the answer of the macro of an energy function. Missing if the file lacks this function or an energy function that it names.
fn source(path: &Path, scope: &[Scope], file: &[Annotated], max_chain: usize) -> Option<TokenStream> {
    if max_chain == 0 {
        return None;
    }
    let function = resolve(path, scope, file)?;
    let options = parse::function_options(function.args.clone()).ok()?;
    let used = options.with.iter().map(|path| source(path, &function.scope, file, max_chain - 1));
    let used = used.collect::<Option<Vec<_>>>()?;
    let source = Source { args: function.args.clone(), item: function.item.clone(), used };
    Some(quote!(#source))
}

/// Returns the energy function that a path names, seen from a scope.
///
/// The search goes from inner to outer scopes. In each scope it takes the function at the end of the path. Otherwise it takes the only
/// function of this name in the scopes inside, because a `use` may import it.
fn resolve<'a>(path: &Path, scope: &[Scope], file: &'a [Annotated]) -> Option<&'a Annotated> {
    let segments: Vec<String> = path.segments.iter().map(|segment| segment.ident.to_string()).collect();
    let segments = segments.iter().filter(|segment| !matches!(segment.as_str(), "crate" | "self" | "super"));
    let segments: Vec<String> = segments.cloned().collect();
    let (name, modules) = segments.split_last()?;
    let modules: Vec<Scope> = modules.iter().cloned().map(Scope::Module).collect();
    let of_name: Vec<&Annotated> = file
        .iter()
        .filter(|function| matches!(function.attribute, Attribute::EnergyFunction) && function.name == *name)
        .collect();
    for depth in (0..=scope.len()).rev() {
        let exact = [&scope[..depth], &modules].concat();
        if let Some(function) = of_name.iter().find(|function| function.scope == exact) {
            return Some(function);
        }
        let mut inside = of_name.iter().filter(|function| function.scope.starts_with(&scope[..depth]));
        match (inside.next(), inside.next()) {
            (None, _) => {}
            (Some(function), None) => return Some(function),
            (Some(_), Some(_)) => return None,
        }
    }
    None
}

/// Returns the kind of an expansion without questions.
fn outcome(function: &Annotated, trees: &[TokenTree]) -> Outcome {
    if trees.iter().any(|tree| matches!(tree, TokenTree::Ident(name) if name == "compile_error")) {
        return Outcome::Refused;
    }
    let Attribute::System(form) = function.attribute else { return Outcome::EnergyFunction };
    let energy = syn::parse2(function.item.clone()).map_err(Into::into);
    match energy.and_then(|item| parse::energy(form, function.args.clone(), item)).map(|energy| energy.form) {
        // The state of a Lagrangian that is linear in velocities has no momenta.
        Ok(Form::Lagrangian) if has_flow_state(trees) => Outcome::System(Form::FirstOrder),
        Ok(form) => Outcome::System(form),
        Err(_) => Outcome::Refused,
    }
}

/// Returns whether the tokens have the type `FlowState<…>`, which all systems import and flows use.
fn has_flow_state(trees: &[TokenTree]) -> bool {
    trees.iter().zip(&trees[1.min(trees.len())..]).any(|pair| match pair {
        (TokenTree::Ident(name), TokenTree::Punct(less)) => name == "FlowState" && less.as_char() == '<',
        _ => false,
    }) || trees.iter().any(|tree| match tree {
        TokenTree::Group(group) => has_flow_state(&group.stream().into_iter().collect::<Vec<_>>()),
        _ => false,
    })
}
