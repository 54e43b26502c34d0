//! What arguments of attributes are set to, where it is neither a name nor an expression.

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

type Named = (&'static str, Requirement);

/// What can be required of an energy.
pub(super) const OF_ENERGIES: [Named; 3] = [
    ("separable", Requirement::Separable),
    ("quadratic_kinetic", Requirement::QuadraticKinetic),
    ("conservative", Requirement::Conservative),
];

/// What can be required of a Lagrangian.
pub(super) const OF_LAGRANGIANS: [Named; 6] = [
    OF_ENERGIES[0],
    OF_ENERGIES[1],
    OF_ENERGIES[2],
    ("quadratic", Requirement::Quadratic),
    ("constant_mass", Requirement::ConstantMass),
    ("regular", Requirement::Regular),
];

impl Requirement {
    /// Those of a list in parentheses, with their places.
    pub(super) fn list(known: &[Named], to: &mut Vec<(Requirement, Span)>, input: ParseStream<'_>) -> syn::Result<()> {
        let inner;
        syn::parenthesized!(inner in input);
        for name in Punctuated::<Ident, Token![,]>::parse_terminated(&inner)? {
            let Some((_, requirement)) = known.iter().find(|(known, _)| name == known) else {
                let known: Vec<String> = known.iter().map(|(known, _)| format!("`{known}`")).collect();
                let (last, others) = known.split_last().expect("something can be required");
                let message = format!("what can be required is {} and {last}", others.join(", "));
                return Err(syn::Error::new_spanned(name, message));
            };
            to.push((*requirement, name.span()));
        }
        Ok(())
    }

    /// Whether the Lagrangian decides it, and not its energy.
    pub(crate) fn is_of_lagrangian(self) -> bool {
        matches!(self, Requirement::Quadratic | Requirement::ConstantMass | Requirement::Regular)
    }
}

/// Coordinates in which methods move the bodies of an energy.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Coordinates {
    /// Each body as seen from the centre of mass of those before it.
    Jacobi,
    /// Each body as seen from body 0.
    Heliocentric,
}

impl Coordinates {
    pub(super) fn named(name: &Ident) -> syn::Result<Coordinates> {
        match name.to_string().as_str() {
            "jacobi" => Ok(Coordinates::Jacobi),
            "heliocentric" => Ok(Coordinates::Heliocentric),
            _ => {
                let message =
                    "the coordinates of bodies that there are: `coordinates = jacobi`, `coordinates = heliocentric`";
                Err(syn::Error::new_spanned(name, message))
            }
        }
    }
}

/// Functions that stay zero: one at least.
pub(super) fn constraint(functions: syn::Expr) -> syn::Result<syn::Expr> {
    match &functions {
        syn::Expr::Array(array) if array.elems.is_empty() => Err(syn::Error::new_spanned(functions, NO_CONSTRAINT)),
        _ => Ok(functions),
    }
}

/// `"terms | terms"` as expressions.
pub(super) fn pieces(input: ParseStream<'_>) -> syn::Result<Vec<syn::Expr>> {
    if !input.peek(syn::LitStr) {
        return Err(input.error("the pieces are given as a string: `split = \"terms | terms\"`"));
    }
    let text: syn::LitStr = input.parse()?;
    let parser = Punctuated::<Group, Token![|]>::parse_separated_nonempty;
    // What is missing has no place inside of the text.
    let groups = text.parse_with(parser).map_err(|error| syn::Error::new(text.span(), error))?;
    Ok(groups.into_iter().map(|Group(expr)| expr).collect())
}

/// An expression that ends before a `|`.
struct Group(syn::Expr);

impl Parse for Group {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let mut tokens = TokenStream::new();
        while !input.is_empty() && !input.peek(Token![|]) {
            tokens.extend([input.parse::<TokenTree>()?]);
        }
        if tokens.is_empty() {
            return Err(input.error("a piece without terms: write `split = \"terms | terms\"`"));
        }
        syn::parse2(tokens).map(Group)
    }
}

/// `with(f, module::g)`, behind the name.
pub(super) fn functions(input: ParseStream<'_>) -> syn::Result<Vec<Path>> {
    let inner;
    syn::parenthesized!(inner in input);
    let paths = inner.parse_terminated(Path::parse_mod_style, Token![,])?;
    Ok(paths.into_iter().collect())
}
