//! What the code of a step has ready: numbers for a system, or for a step length, and numbers for the point where a step starts.

use crate::emit::kernel::Context;
use crate::schedule::Kernel;
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
    pub(super) fn for_stages(context: &Context<'_>, kernel: &Kernel, names: Names<'_>) -> Self {
        let (prepared, started) = (numbers(kernel, 0), quote!());
        let (types, functions) = constants(context, kernel, names, &quote!(&self));
        Prepared { types, functions, prepared, started }
    }

    /// For whole steps: numbers for a length h, and numbers for a point. The `arguments` of the second function give the point, whose `parts` get
    /// names first.
    pub(super) fn for_steps(
        context: &Context<'_>,
        kernel: &Kernel,
        [length, start]: [Names<'_>; 2],
        parts: &TokenStream,
        arguments: &TokenStream,
    ) -> Self {
        let [prepared, started] = [0, 1].map(|level| numbers(kernel, level));
        let (types, functions) = constants(context, kernel, length, &quote!(&self, h: R));
        let [ty, function] = start.map(|name| format_ident!("{name}"));
        let begin = context.stored(kernel, 1);
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
    kernel: &Kernel,
    names: Names<'_>,
    arguments: &TokenStream,
) -> (TokenStream, TokenStream) {
    let [ty, function] = names.map(|name| format_ident!("{name}"));
    let (numbers, constants) = (numbers(kernel, 0), context.stored(kernel, 0));
    let function = quote! {
        #[inline]
        fn #function(#arguments) -> #numbers {
            #constants
        }
    };
    (quote!(type #ty = #numbers;), function)
}

/// The type of the numbers of a level.
pub(super) fn numbers(kernel: &Kernel, level: usize) -> TokenStream {
    let count = Literal::usize_unsuffixed(kernel.slots[level]);
    quote!([R; #count])
}
