//! Attribute arguments of systems without momenta: the structure S of x' = S(x) ∇H, and the first integrals of a vector field.

use crate::diagnostics::Diagnostics;
use proc_macro2::Ident;
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Expr, Token, parenthesized};

/// S of x' = S(x) ∇H.
#[derive(Clone)]
pub(crate) struct StructureForm {
    pub(crate) kind: StructureKind,
    /// C of `nambu(C)`, otherwise the whole expression.
    pub(crate) expr: Expr,
}

/// The notation in which S is given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum StructureKind {
    /// x' = x × ∇H.
    So3,
    /// (m, γ)' = (m × ∂H/∂m + γ × ∂H/∂γ, γ × ∂H/∂m).
    Se3,
    /// (q, p)' = (∂H/∂p, −∂H/∂q) for the halves of x.
    Canonical,
    /// x' = ∇C × ∇H.
    Nambu,
    /// Entries of S: an array of arrays, or a function of i and j for i < j.
    Entries,
}

/// A first integral I(x) of a vector field.
#[derive(Clone)]
pub(crate) struct Kept {
    pub(crate) name: Ident,
    pub(crate) value: Expr,
    /// b of a function with the rate b·∇I, for example by friction.
    pub(crate) but: Option<Expr>,
    /// Whether the user asserts the conservation without a proof.
    pub(crate) assumed: bool,
}

impl StructureKind {
    pub(crate) const NAMES: [&str; 4] = ["so3", "se3", "canonical", "nambu"];
}

impl StructureForm {
    pub(super) fn new(expr: Expr) -> StructureForm {
        if let Expr::Call(call) = &expr
            && is_name(&call.func, "nambu")
            && call.args.len() == 1
        {
            return StructureForm { kind: StructureKind::Nambu, expr: call.args[0].clone() };
        }
        let kinds = [StructureKind::So3, StructureKind::Se3, StructureKind::Canonical];
        let kind = StructureKind::NAMES.into_iter().zip(kinds).find(|(name, _)| is_name(&expr, name));
        StructureForm { kind: kind.map_or(StructureKind::Entries, |(_, kind)| kind), expr }
    }

    /// Returns whether S contains an expression of the user, beyond a name.
    pub(super) fn is_expression(&self) -> bool {
        matches!(self.kind, StructureKind::Nambu | StructureKind::Entries)
    }
}

fn is_name(expr: &Expr, name: &str) -> bool {
    matches!(expr, Expr::Path(path) if path.path.is_ident(name))
}

/// Whether the macro has to prove an integral.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Proof {
    Required,
    Assumed,
}

/// Parses `(integral = expr, but = expr, …, assume(integral = expr, …))` after `keeps`.
pub(super) fn keeps(input: ParseStream<'_>) -> syn::Result<Vec<Kept>> {
    let inner;
    parenthesized!(inner in input);
    let mut kept = vec![];
    integrals(&inner, Proof::Required, &mut kept)?;
    Ok(kept)
}

fn integrals(input: ParseStream<'_>, proof: Proof, kept: &mut Vec<Kept>) -> syn::Result<()> {
    while !input.is_empty() {
        let name: Ident = input.parse()?;
        if name == "assume" && proof == Proof::Required && input.peek(syn::token::Paren) {
            let inner;
            parenthesized!(inner in input);
            integrals(&inner, Proof::Assumed, kept)?;
        } else {
            input.parse::<Token![=]>()?;
            let value: Expr = input.parse()?;
            match kept.last_mut() {
                Some(last) if name == "but" && last.but.is_none() => last.but = Some(value),
                _ if name == "but" => {
                    let message =
                        "`but` stands behind the integral that changes by it: `keeps(integral = …, but = […])`";
                    return Err(syn::Error::new_spanned(name, message));
                }
                _ => kept.push(Kept { name, value, but: None, assumed: proof == Proof::Assumed }),
            }
        }
        if !input.is_empty() {
            input.parse::<Token![,]>()?;
        }
    }
    Ok(())
}

/// Functions of the generated struct. An integral can not have their names.
const TAKEN: [&str; 4] = ["integrator", "adaptive", "taylor", "field"];

/// Refuses names of integrals that are taken or repeated.
pub(super) fn names(kept: &[Kept], errors: &mut Diagnostics) {
    for (i, Kept { name, .. }) in kept.iter().enumerate() {
        let plain = name.unraw();
        if kept[..i].iter().any(|other| other.name.unraw() == plain) {
            errors.at(name, format!("`{name}` is given twice"));
        }
        if TAKEN.iter().any(|taken| plain == taken) {
            errors.at(name, format!("`{name}` is a function of generated code; give the integral another name"));
        }
    }
}
