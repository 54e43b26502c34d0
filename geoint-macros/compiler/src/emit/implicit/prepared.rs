//! What the code of a step has ready: numbers for a system, or for a step length, and numbers for the point where a step starts.

use crate::emit::kernel::Context;
use crate::ir::Symbol;
use crate::schedule::Plan;
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

/// Types and functions for what is ready, in the implementation of a trait.
pub(super) struct Prepared {
    pub(super) types: TokenStream,
    pub(super) functions: TokenStream,
    /// The type of numbers for a system or a step length, and of those for a point.
    pub(super) prepared: TokenStream,
    pub(super) started: TokenStream,
}

/// Names of a type and of the function that gives it.
type Names<'a> = [&'a str; 2];

impl Prepared {
    /// For stages: numbers of the system alone.
    pub(super) fn for_stages(context: &Context<'_>, plan: &Plan, names: Names<'_>) -> Self {
        let (prepared, started) = (numbers(plan, 0), quote!());
        let (types, functions) = constants(context, plan, names, &quote!(&self));
        Prepared { types, functions, prepared, started }
    }

    /// For whole steps: numbers for a length h, and those for a point, which is among the `arguments`; `given` in places of the array that they
    /// name, or, after `parts`, one by one.
    pub(super) fn for_steps(
        context: &Context<'_>,
        plan: &Plan,
        [length, start]: [Names<'_>; 2],
        (given, parts, arguments): ((&[Symbol], &str), &TokenStream, &TokenStream),
    ) -> Self {
        let [prepared, started] = [0, 1].map(|level| numbers(plan, level));
        let (types, functions) = constants(context, plan, length, &quote!(&self, h: R));
        let [ty, function] = start.map(|name| format_ident!("{name}"));
        let begin = context.planned(&plan.stores[1], given, |values| quote!([#(#values),*]));
        let types = quote!(#types type #ty = #started;);
        let functions = quote! {
            #functions
            #[inline(always)]
            fn #function(&self, prepared: &#prepared, #arguments) -> #started {
                #parts
                #begin
            }
        };
        Prepared { types, functions, prepared, started }
    }
}

fn constants(
    context: &Context<'_>,
    plan: &Plan,
    names: Names<'_>,
    arguments: &TokenStream,
) -> (TokenStream, TokenStream) {
    let [ty, function] = names.map(|name| format_ident!("{name}"));
    let (numbers, constants) = (numbers(plan, 0), context.stored(plan, 0));
    let function = quote! {
        #[inline]
        fn #function(#arguments) -> #numbers {
            #constants
        }
    };
    (quote!(type #ty = #numbers;), function)
}

/// The type of the numbers of a level.
fn numbers(plan: &Plan, level: usize) -> TokenStream {
    let count = Literal::usize_unsuffixed(plan.slots[level]);
    quote!([R; #count])
}
