//! Refuses code that rustc accepts and the evaluation would misinterpret. The check precedes the evaluation.

use crate::diagnostics::Diagnostics;
use crate::parse::{Energy, Function};
use proc_macro2::Ident;
use quote::ToTokens;
use syn::visit::{self, Visit};
use syn::{Attribute, Generics, Lit};

/// Reports attributes, generics and numbers of another type in the body and in the expressions of the attribute.
pub(super) fn report(energy: &Energy, errors: &mut Diagnostics) {
    let mut unseen = Unseen { float: &energy.float, errors };
    unseen.visit_block(&energy.item.block);
    energy.expressions().chain(energy.expressions_of_velocities()).for_each(|expr| unseen.visit_expr(expr));
    unseen.visit_functions(&energy.functions);
}

struct Unseen<'a> {
    /// Type of all numbers.
    float: &'a Ident,
    errors: &'a mut Diagnostics,
}

/// Attributes that do not change the code.
const HARMLESS: &str = "allow expect warn deny forbid doc inline cold must_use rustfmt clippy deprecated";

impl Visit<'_> for Unseen<'_> {
    fn visit_attribute(&mut self, attribute: &Attribute) {
        let first = attribute.path().segments.first().map(|segment| segment.ident.to_string());
        let is_harmless = first.is_some_and(|name| HARMLESS.split(' ').any(|harmless| name == harmless));
        if !is_harmless {
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

    fn visit_type_path(&mut self, path: &syn::TypePath) {
        if path.path.is_ident("f32") {
            self.narrow_number(path);
        }
        visit::visit_type_path(self, path);
    }

    fn visit_lit(&mut self, lit: &Lit) {
        if lit.suffix() == "f32" {
            self.narrow_number(lit);
        }
    }
}

impl Unseen<'_> {
    /// Refuses `f32` in an energy of `f64`, because it rounds differently. In an energy of `f32`, `f64` matters only with a cast, and lowering refuses it.
    fn narrow_number(&mut self, syntax: &impl ToTokens) {
        if self.float == "f64" {
            self.errors.at(syntax, format!("all numbers of an energy have one type, here `{}`", self.float));
        }
    }

    fn visit_functions(&mut self, functions: &[Function]) {
        for function in functions {
            self.visit_item_fn(&function.item);
            self.visit_functions(&function.used);
        }
    }
}
