//! The arguments of the attribute.

use super::Role;
use proc_macro2::{Ident, Span};
use syn::Token;
use syn::ext::IdentExt;
use syn::parse::{Parse, ParseStream};
use syn::punctuated::Punctuated;

/// What the arguments say.
#[derive(Default)]
pub(super) struct Options {
    pub(super) name: Option<Ident>,
    pub(super) runtime: Option<syn::Path>,
    pub(super) roles: Vec<(Role, Ident)>,
    pub(super) requirements: Vec<(Requirement, Span)>,
    pub(super) damping: Option<syn::Expr>,
}

const OPTIONS: &str = "the arguments of this attribute are `name = Type`, `q = argument`, `p = argument`, `t = argument`, \
                       `damping = coefficients`, `crate = path` and `require(separable, quadratic_kinetic)`";

impl Parse for Options {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let mut options = Options::default();
        let mut given: Vec<Ident> = vec![];
        while !input.is_empty() {
            let key = input.call(Ident::parse_any)?;
            if key != "require" && given.contains(&key) {
                return Err(syn::Error::new_spanned(&key, format!("`{key}` is given twice")));
            }
            given.push(key.clone());
            match key.to_string().as_str() {
                "require" => {
                    let inner;
                    syn::parenthesized!(inner in input);
                    for name in Punctuated::<Ident, Token![,]>::parse_terminated(&inner)? {
                        let requirement = match name.to_string().as_str() {
                            "separable" => Requirement::Separable,
                            "quadratic_kinetic" => Requirement::QuadraticKinetic,
                            _ => {
                                let message = "what can be required is `separable` and `quadratic_kinetic`";
                                return Err(syn::Error::new_spanned(name, message));
                            }
                        };
                        options.requirements.push((requirement, name.span()));
                    }
                }
                "crate" => {
                    input.parse::<Token![=]>()?;
                    options.runtime = Some(input.parse()?);
                }
                "damping" => {
                    input.parse::<Token![=]>()?;
                    options.damping = Some(input.parse()?);
                }
                name @ ("name" | "q" | "p" | "t") => {
                    input.parse::<Token![=]>()?;
                    let value: Ident = input.parse()?;
                    match name {
                        "name" => options.name = Some(value),
                        "q" => options.roles.push((Role::Position, value)),
                        "p" => options.roles.push((Role::Momentum, value)),
                        _ => options.roles.push((Role::Time, value)),
                    }
                }
                _ => return Err(syn::Error::new_spanned(key, OPTIONS)),
            }
            if !input.is_empty() {
                input.parse::<Token![,]>()?;
            }
        }
        Ok(options)
    }
}

/// A property that the user asks the macro to prove.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Requirement {
    Separable,
    QuadraticKinetic,
}
