//! Parsers for values of the attribute's arguments, except names and plain expressions.

use super::Form;
use crate::messages::NO_CONSTRAINT;
use proc_macro2::{Ident, Span, TokenStream, TokenTree};
use syn::parse::{Parse, ParseStream};
use syn::punctuated::Punctuated;
use syn::{Path, Token};

/// A property that the user asks the macro to prove.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Requirement {
    Separable,
    QuadraticKinetic,
    Conservative,
    /// L is quadratic in the velocities.
    Quadratic,
    /// ∂²L/∂v² is constant.
    ConstantMass,
    /// Velocities follow from momenta.
    Regular,
}

impl Requirement {
    const NAMES: [(&str, Requirement); 6] = [
        ("separable", Requirement::Separable),
        ("quadratic_kinetic", Requirement::QuadraticKinetic),
        ("conservative", Requirement::Conservative),
        ("quadratic", Requirement::Quadratic),
        ("constant_mass", Requirement::ConstantMass),
        ("regular", Requirement::Regular),
    ];

    /// Parses a list in parentheses. The form decides the allowed names.
    pub(super) fn list(form: Form, to: &mut Vec<(Requirement, Span)>, input: ParseStream<'_>) -> syn::Result<()> {
        let allowed = || {
            let of_form = |requirement: &Requirement| form == Form::Lagrangian || !requirement.is_of_lagrangian();
            Self::NAMES.iter().filter(move |(_, requirement)| of_form(requirement))
        };
        let inner;
        syn::parenthesized!(inner in input);
        for name in Punctuated::<Ident, Token![,]>::parse_terminated(&inner)? {
            let Some((_, requirement)) = allowed().find(|(known, _)| name == known) else {
                let known: Vec<String> = allowed().map(|(known, _)| format!("`{known}`")).collect();
                return Err(syn::Error::new_spanned(name, format!("what can be required is {}", listed(&known))));
            };
            to.push((*requirement, name.span()));
        }
        Ok(())
    }

    /// Returns whether the property is one of the Lagrangian and not of its energy.
    pub(crate) fn is_of_lagrangian(self) -> bool {
        matches!(self, Requirement::Quadratic | Requirement::ConstantMass | Requirement::Regular)
    }
}

/// Joins words to a list: `a, b and c`.
pub(super) fn listed(words: &[String]) -> String {
    match words {
        [others @ .., last] if !others.is_empty() => format!("{} and {last}", others.join(", ")),
        words => words.concat(),
    }
}

/// Coordinates in which methods move the bodies of an energy.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Coordinates {
    /// Position of each body relative to the centre of mass of the previous bodies.
    Jacobi,
    /// Position of each body relative to body 0.
    Heliocentric,
}

impl Coordinates {
    /// Returns the coordinates of a name, with its place.
    pub(super) fn named(name: Ident) -> syn::Result<(Coordinates, Span)> {
        match name.to_string().as_str() {
            "jacobi" => Ok((Coordinates::Jacobi, name.span())),
            "heliocentric" => Ok((Coordinates::Heliocentric, name.span())),
            _ => Err(syn::Error::new_spanned(name, UNKNOWN_COORDINATES)),
        }
    }
}

const UNKNOWN_COORDINATES: &str =
    "the coordinates of bodies that there are: `coordinates = jacobi`, `coordinates = heliocentric`";

/// Refuses an empty array of constraints of positions or of velocities.
pub(super) fn constraint(functions: syn::Expr) -> syn::Result<syn::Expr> {
    match &functions {
        syn::Expr::Array(array) if array.elems.is_empty() => Err(syn::Error::new_spanned(functions, NO_CONSTRAINT)),
        _ => Ok(functions),
    }
}

/// Parses `= "terms | terms"`. Each piece is an expression.
pub(super) fn pieces(input: ParseStream<'_>) -> syn::Result<Vec<syn::Expr>> {
    input.parse::<Token![=]>()?;
    if !input.peek(syn::LitStr) {
        return Err(input.error("the pieces are given as a string: `split = \"terms | terms\"`"));
    }
    let text: syn::LitStr = input.parse()?;
    let parser = Punctuated::<Piece, Token![|]>::parse_separated_nonempty;
    // Errors at the end of the text have no place inside the text. So all errors point at the whole text.
    let pieces = text.parse_with(parser).map_err(|error| syn::Error::new(text.span(), error))?;
    Ok(pieces.into_iter().map(|Piece(expr)| expr).collect())
}

/// An expression that ends before a `|`.
struct Piece(syn::Expr);

impl Parse for Piece {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let mut tokens = TokenStream::new();
        while !input.is_empty() && !input.peek(Token![|]) {
            tokens.extend([input.parse::<TokenTree>()?]);
        }
        if tokens.is_empty() {
            return Err(input.error("a piece without terms: write `split = \"terms | terms\"`"));
        }
        syn::parse2(tokens).map(Piece)
    }
}

/// Parses `(f, module::g)` after `with`.
pub(super) fn functions(input: ParseStream<'_>) -> syn::Result<Vec<Path>> {
    let inner;
    syn::parenthesized!(inner in input);
    let paths = inner.parse_terminated(Path::parse_mod_style, Token![,])?;
    Ok(paths.into_iter().collect())
}
