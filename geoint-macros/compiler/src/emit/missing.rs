//! Traits that no scalar implements. The error message of such a trait states why a system lacks a property.

use super::context::Context;
use crate::derive::{Missing, Pair};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

/// Returns the name of the trait without implementations that states why a system lacks a property.
pub(super) fn marker(context: &Context<'_>, missing: Missing) -> Ident {
    format_ident!("{}{}", missing.marker, context.energy.name)
}

/// Returns the name and the definition of a trait without implementations. Its message states why the system lacks a property.
pub(super) fn unsatisfied(context: &Context<'_>, missing: Missing) -> (Ident, TokenStream) {
    let Missing { term, why, pair, .. } = missing;
    let (name, marker) = (&context.energy.name, marker(context, missing));
    let printer = context.printer();
    let message = format!("`{name}`: {why}");
    let pair = pair.map_or_else(String::new, |Pair { coordinates: [a, b], verb }| {
        format!("; {} and {} {verb}", printer.named(a), printer.named(b))
    });
    let label = format!("the term is: {}{pair}", printer.excerpt(term));
    // rustc reads braces in a message as parameters.
    let (message, label) = (message.replace(['{', '}'], "|"), label.replace(['{', '}'], "|"));
    let tokens = quote! {
        #[diagnostic::on_unimplemented(message = #message, label = #label)]
        pub trait #marker {
            type Proof;
        }
    };
    (marker, tokens)
}
