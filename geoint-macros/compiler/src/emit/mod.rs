//! Emission of tokens: the struct with its docs, and the implementations of the runtime's traits.
//!
//! Tokens are built directly, never parsed from text. They name items of `::core`, of the runtime, and those that the user's function and attribute name.
//!
//! - The user's items: `structure` (the struct), `attributes` (of the function and the struct), `outside` (checks of the constants and aliases in the attribute), `report`.
//! - Implementations: `system`, `flow`, `lagrangian`, `poles`, `domain`, `exact` (splittings), `implicit` (implicit steps), `jet` (Taylor coefficients). The
//!   signatures of traits that some systems lack are data in `signature`. `implementation` builds present and absent ones, `missing` the message of absent ones.
//! - Printing of routines: `context`, `writer`, `statements`, `loops`, `calls`, `tokens`.

mod attributes;
mod domain;
mod exact;
mod flow;
mod implementation;
mod implicit;
mod jet;
mod tokens;
mod context;
mod lagrangian;
mod loops;
mod statements;
mod missing;
mod outside;
mod poles;
mod report;
mod signature;
mod calls;
mod structure;
mod system;
mod writer;

use crate::compilation::Compilation;
use crate::derive::Derived;
use crate::lower::VELOCITY;
use crate::parse::{self, Energy, Form, Role};
use context::Context;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// Returns the user's function. More than seven arguments would be a warning of clippy.
pub(crate) fn function(energy: &Energy, item: TokenStream) -> TokenStream {
    let function = checked(energy).unwrap_or(item);
    if energy.item.sig.inputs.len() > 7 { quote!(#[allow(clippy::too_many_arguments)] #function) } else { function }
}

/// Returns the function with the expressions of its attribute in its body, if there are some. There rustc checks the expressions, and sees that they use
/// their arguments. They stand in closures that are never called.
fn checked(energy: &Energy) -> Option<TokenStream> {
    let mut item = energy.item.clone();
    let used = energy.expressions().map(|expr| match expr {
        // The entries of a structure matrix, by their indices.
        syn::Expr::Closure(_) => {
            let float = &energy.float;
            quote! {
                fn entries(_: impl ::core::ops::Fn(usize, usize) -> #float) {}
                entries(#expr);
            }
        }
        _ => quote!(let _ = #expr;),
    });
    let used = used.chain(energy.expressions_of_velocities().map(|expr| with_velocity(energy, expr)));
    let statements: Vec<syn::Stmt> = used.map(|used| syn::parse_quote!(let _ = || { #used };)).collect();
    let some = !statements.is_empty();
    item.block.stmts.splice(0..0, statements);
    some.then(|| quote!(#item))
}

/// Returns the statement that reads an expression, with a variable for the velocity in scope. The statement never runs, so the momenta, which have the same type, stand
/// for the velocity.
fn with_velocity(energy: &Energy, expr: &syn::Expr) -> TokenStream {
    let momenta = energy.argument(Role::Momentum).map(|momenta| &momenta.name);
    let velocity = momenta.map(|momenta| {
        let velocity = format_ident!("{VELOCITY}", span = proc_macro2::Span::call_site());
        quote!(#[allow(unused_variables, reason = "generated code")] let #velocity = #momenta;)
    });
    quote!(#velocity let _ = #expr;)
}

/// Returns the items that are emitted beside the user's function.
pub(crate) fn items(compilation: &Compilation<'_>, derived: &Derived) -> TokenStream {
    let (context, system) = (&Context::new(compilation), &derived.system);
    let report = report::report(compilation, derived);
    let flow = context.form.is_flow().then(|| flow::inherent(context, system));
    let inherent = structure::inherent(context, system, flow, &report);
    let space = system::phase_space(context, system);
    let pieces = system.pieces.iter().map(|found| exact::pieces(context, found));
    let flows = system.splitting.as_ref().map(|found| exact::splitting(context, found));
    let parted = system.perturbed.as_ref().map(|found| exact::perturbed(context, found));
    let integrals = system.integrals.as_ref().map(|integrals| flow::integrals(context, integrals));
    let lagrangian = system.lagrangian.as_ref().map(|found| match context.form {
        Form::FirstOrder => lagrangian::first_order(context, found),
        _ => lagrangian::lagrangian(context, found),
    });
    let of_energy = (context.form == Form::Hamiltonian).then(|| lagrangian::of_energy(context, system));
    let modified = system.modified.as_ref().map(|modified| system::modified_energy(context, modified));
    let implicit = implicit::implicit(context, system);
    let jets = system.jet.as_ref().map(|found| jet::jets(context, found));
    let implementations =
        quote!(#inherent #space #lagrangian #of_energy #integrals #(#pieces)* #flows #parted #modified #implicit #jets);
    around(context, &report, &implementations)
}

/// Returns the struct with its docs, and the implementations in a scope of their own.
fn around(context: &Context<'_>, report: &str, implementations: &TokenStream) -> TokenStream {
    let docs = format!("\n# What was derived\n\n```text\n{report}```");
    let Energy { runtime, .. } = context.energy;
    let structure = structure::structure(context, &docs);
    let (assertions, existence) = (context.energy.options.outside.assertions(), outside::existence(context));
    // This use prevents a warning about an unused function, because the user need not call the function.
    let used = (!attributes::expected_dead(context.energy)).then(|| {
        let function = &context.energy.item.sig.ident;
        quote! {
            const _: fn() = || {
                let _ = #function;
            };
        }
    });
    // Few lints of rustc are allowed, and `deprecated` only if it occurs, because a crate that forbids a lint rejects code that allows it.
    let old = attributes::is_deprecated(context.energy).then(|| quote!(deprecated,));
    let imported = parse::imported().map(|name| format_ident!("{name}"));
    quote! {
        #structure
        #assertions
        #existence

        #[allow(
            clippy::all, clippy::pedantic, clippy::nursery, clippy::restriction, #old private_bounds, unused_imports,
            unused_mut, unused_variables, reason = "generated code"
        )]
        const _: () = {
            use #runtime::private::{#(#imported),*};

            #used

            #implementations
        };
    }
}
