//! What rustc accepts, and what would mean something else here: refused before anything is evaluated.

use crate::diagnostics::Diagnostics;
use crate::parse::{Energy, Function};
use proc_macro2::Ident;
use quote::ToTokens;
use syn::visit::{self, Visit};
use syn::{Attribute, Generics, Lit};

/// Reports everything that is written which the evaluation could not follow and would not notice.
pub(super) fn report(energy: &Energy, errors: &mut Diagnostics) {
    let float = &energy.float;
    let mut unseen = Unseen { other: if float == "f64" { "f32" } else { "f64" }, float, errors };
    unseen.visit_block(&energy.item.block);
    energy.expressions().chain(&energy.options.force).for_each(|expr| unseen.visit_expr(expr));
    functions(&mut unseen, &energy.functions);
}

fn functions(unseen: &mut Unseen<'_>, all: &[Function]) {
    for function in all {
        unseen.visit_item_fn(&function.item);
        functions(unseen, &function.used);
    }
}

struct Unseen<'a> {
    float: &'a Ident,
    /// The float type that is not the one of the energy.
    other: &'static str,
    errors: &'a mut Diagnostics,
}

/// Attributes that leave the code as it is.
const HARMLESS: [&str; 12] = [
    "allow",
    "expect",
    "warn",
    "deny",
    "forbid",
    "doc",
    "inline",
    "cold",
    "must_use",
    "rustfmt",
    "clippy",
    "deprecated",
];

impl Visit<'_> for Unseen<'_> {
    fn visit_attribute(&mut self, attribute: &Attribute) {
        let harmless = |segment: &syn::PathSegment| HARMLESS.iter().any(|name| segment.ident == name);
        if !attribute.path().segments.first().is_some_and(harmless) {
            let name = attribute.path().to_token_stream();
            let message = format!("`{name}` may change or remove this after it was differentiated: leave it out");
            self.errors.at(attribute, message);
        }
    }

    fn visit_generics(&mut self, generics: &Generics) {
        for parameter in &generics.params {
            if !matches!(parameter, syn::GenericParam::Lifetime(_)) {
                self.errors
                    .at(parameter, "nested functions are inlined and cannot be generic: write types and lengths");
            }
        }
    }

    // Numbers of another type round differently. (In an energy in `f32`, constants in `f64` are harmless, and whatever
    // else is in `f64` needs a cast, which is refused.)
    fn visit_type_path(&mut self, path: &syn::TypePath) {
        if self.other == "f32" && path.path.is_ident(self.other) {
            self.mixed(path);
        }
        visit::visit_type_path(self, path);
    }

    fn visit_lit(&mut self, lit: &Lit) {
        let suffix = lit.suffix();
        if self.other == "f32" && suffix == self.other {
            self.mixed(lit);
        }
    }
}

impl Unseen<'_> {
    fn mixed(&mut self, syntax: &impl ToTokens) {
        self.errors.at(syntax, format!("all numbers of an energy have one type, here `{}`", self.float));
    }
}
