//! The arguments of the attribute.

use super::outside::Outside;
use super::{Form, Role};
use proc_macro2::{Ident, Span, TokenStream, TokenTree};
use syn::Token;
use syn::ext::IdentExt;
use syn::parse::{Parse, ParseStream};
use syn::punctuated::Punctuated;
use syn::spanned::Spanned;

/// What the arguments say.
#[derive(Default)]
pub(super) struct Options {
    pub(super) name: Option<Ident>,
    pub(super) runtime: Option<syn::Path>,
    pub(super) roles: Vec<(Role, Ident)>,
    pub(super) requirements: Vec<(Requirement, Span)>,
    pub(super) damping: Option<syn::Expr>,
    pub(super) split: Option<Vec<syn::Expr>>,
    pub(super) lift: Option<Span>,
    pub(super) outside: Outside,
    pub(super) with: Vec<syn::Path>,
}

const HAMILTONIAN: &str = "the arguments of this attribute are `name = Type`, `q = argument`, `p = argument`, `t = argument`, \
                           `attitude = argument`, `m = argument`, `damping = coefficients`, `const N = 3`, `type P = [f64; 3]`, `with(function)`, `crate = path` and \
                           `require(separable, quadratic_kinetic)`";

const CONTACT: &str = "the arguments of this attribute are `name = Type`, `q = argument`, `p = argument`, `s = argument`, \
                       `t = argument`, `split = \"terms | terms\"`, `lift`, `const N = 3`, `type P = [f64; 3]`, `with(function)` and `crate = path`";

const FUNCTION: &str =
    "the arguments of this attribute are `const N = 3`, `type P = [f64; 3]`, `with(function)` and `crate = path`";

/// What may be given several times.
const REPEATABLE: [&str; 3] = ["require", "const", "type"];

impl Options {
    /// Those of the attribute of a form, or of `#[energy_function]`.
    pub(super) fn parse(form: Option<Form>, input: ParseStream<'_>) -> syn::Result<Self> {
        let mut options = Options::default();
        let mut given: Vec<Ident> = vec![];
        while !input.is_empty() {
            let key = input.call(Ident::parse_any)?;
            if !REPEATABLE.iter().any(|name| key == name) && given.contains(&key) {
                return Err(syn::Error::new_spanned(&key, format!("`{key}` is given twice")));
            }
            given.push(key.clone());
            let (energy, contact) = (form.is_some(), form == Some(Form::Contact));
            match key.to_string().as_str() {
                "with" => options.with = super::function::with(input)?,
                "require" if energy && !contact => {
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
                "const" => options.outside.parse_constant(input)?,
                "type" => options.outside.parse_alias(input)?,
                "crate" => {
                    input.parse::<Token![=]>()?;
                    options.runtime = Some(input.parse()?);
                }
                "damping" if contact => {
                    let message = "a contact system is damped by the terms in `s` of its energy, such as `+ gamma * s`";
                    return Err(syn::Error::new_spanned(key, message));
                }
                "split" if contact => {
                    input.parse::<Token![=]>()?;
                    if !input.peek(syn::LitStr) {
                        return Err(input.error("the pieces are given as a string: `split = \"terms | terms\"`"));
                    }
                    options.split = Some(groups(&input.parse()?)?);
                }
                "lift" if contact => options.lift = Some(key.span()),
                "damping" if energy => {
                    input.parse::<Token![=]>()?;
                    options.damping = Some(input.parse()?);
                }
                name @ ("name" | "q" | "p" | "s" | "t" | "attitude" | "m") if energy && takes(contact, name) => {
                    input.parse::<Token![=]>()?;
                    let value: Ident = input.parse()?;
                    match name {
                        "name" => options.name = Some(value),
                        "q" => options.roles.push((Role::Position, value)),
                        "p" => options.roles.push((Role::Momentum, value)),
                        "s" => options.roles.push((Role::Action, value)),
                        "attitude" => options.roles.push((Role::Attitude, value)),
                        "m" => options.roles.push((Role::AngularMomentum, value)),
                        _ => options.roles.push((Role::Time, value)),
                    }
                }
                _ => {
                    let message = match form {
                        Some(Form::Hamiltonian | Form::Bodies) => HAMILTONIAN,
                        Some(Form::Contact) => CONTACT,
                        None => FUNCTION,
                    };
                    return Err(syn::Error::new_spanned(key, message));
                }
            }
            if !input.is_empty() {
                input.parse::<Token![,]>()?;
            }
        }
        options.consistent()
    }

    /// Rigid bodies have an attitude and angular momenta, in place of positions and momenta, and are not damped.
    fn consistent(self) -> syn::Result<Self> {
        let role = |role: Role| self.roles.iter().find(|(other, _)| *other == role).map(|(_, name)| name);
        let wrong = match (role(Role::Attitude), role(Role::AngularMomentum)) {
            (None, Some(m)) => Some((m.span(), WITHOUT_ATTITUDE)),
            (None, None) => None,
            (Some(_), _) if self.damping.is_some() => self.damping.as_ref().map(|expr| (expr.span(), DAMPED_BODY)),
            (Some(_), _) if !self.requirements.is_empty() => Some((self.requirements[0].1, ALWAYS_SEPARABLE)),
            (Some(_), _) => role(Role::Position).or(role(Role::Momentum)).map(|name| (name.span(), NO_CENTRES)),
        };
        wrong.map_or(Ok(()), |(span, message)| Err(syn::Error::new(span, message)))?;
        Ok(self)
    }
}

/// Whether an attribute has a name for the struct or for an argument.
fn takes(contact: bool, name: &str) -> bool {
    match name {
        "s" => contact,
        "attitude" | "m" => !contact,
        _ => true,
    }
}

const WITHOUT_ATTITUDE: &str =
    "`m = …` names the angular momentum of a rigid body: say which argument is its attitude, `attitude = …`";

const DAMPED_BODY: &str = "rigid bodies are not damped: `damping` is for energies of `q` and `p`";

const ALWAYS_SEPARABLE: &str =
    "with `attitude` the energy has to be T(m) + V(r) with a quadratic T: leave `require` out";

const NO_CENTRES: &str = "with `attitude` the state is the attitude and the angular momentum alone";

/// `"terms | terms"` as expressions.
fn groups(text: &syn::LitStr) -> syn::Result<Vec<syn::Expr>> {
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

/// A property that the user asks the macro to prove.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Requirement {
    Separable,
    QuadraticKinetic,
}
