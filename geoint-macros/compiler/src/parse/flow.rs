//! What attributes of systems without momenta say: the structure S of x' = S(x) ∇H, and what a vector field keeps.

use crate::diagnostics::Diagnostics;
use proc_macro2::Ident;
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Expr, Token, parenthesized};

/// S of x' = S(x) ∇H.
#[derive(Clone)]
pub(crate) struct StructureForm {
    pub(crate) kind: StructureKind,
    /// C of `nambu(C)`; else all that is written.
    pub(crate) expr: Expr,
}

/// How S is given.
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
    /// By its entries: an array of arrays, or a function of i and j for i < j.
    Entries,
}

/// A function of x that a field keeps.
#[derive(Clone)]
pub(crate) struct Kept {
    pub(crate) name: Ident,
    pub(crate) value: Expr,
    /// b, if the function changes by b·∇I alone.
    pub(crate) but: Option<Expr>,
    /// Whether that is not to be proven.
    pub(crate) assumed: bool,
}

impl StructureKind {
    pub(crate) const NAMES: [&str; 4] = ["so3", "se3", "canonical", "nambu"];
}

impl StructureForm {
    pub(super) fn new(expr: Expr) -> StructureForm {
        let named = |expr: &Expr| match expr {
            Expr::Path(path) => path.path.get_ident().map(ToString::to_string),
            _ => None,
        };
        if let Expr::Call(call) = &expr
            && named(&call.func).as_deref() == Some("nambu")
            && call.args.len() == 1
        {
            return StructureForm { kind: StructureKind::Nambu, expr: call.args[0].clone() };
        }
        let kind = match named(&expr).as_deref() {
            Some("so3") => StructureKind::So3,
            Some("se3") => StructureKind::Se3,
            Some("canonical") => StructureKind::Canonical,
            _ => StructureKind::Entries,
        };
        StructureForm { kind, expr }
    }

    /// Whether it is more than a name.
    pub(super) fn is_expression(&self) -> bool {
        matches!(self.kind, StructureKind::Nambu | StructureKind::Entries)
    }
}

/// `(integral = expr, but = expr, …, assume(integral = expr, …))`, behind `keeps`.
pub(super) fn keeps(input: ParseStream<'_>) -> syn::Result<Vec<Kept>> {
    let inner;
    parenthesized!(inner in input);
    let mut kept = vec![];
    entries(&inner, false, &mut kept)?;
    Ok(kept)
}

fn entries(input: ParseStream<'_>, assumed: bool, kept: &mut Vec<Kept>) -> syn::Result<()> {
    while !input.is_empty() {
        let name: Ident = input.parse()?;
        if name == "assume" && !assumed && input.peek(syn::token::Paren) {
            let inner;
            parenthesized!(inner in input);
            entries(&inner, true, kept)?;
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
                _ => kept.push(Kept { name, value, but: None, assumed }),
            }
        }
        if !input.is_empty() {
            input.parse::<Token![,]>()?;
        }
    }
    Ok(())
}

/// Functions of the generated struct that an integral cannot be called by.
const TAKEN: [&str; 4] = ["integrator", "adaptive", "taylor", "field"];

/// Refuses names of integrals that are taken.
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
