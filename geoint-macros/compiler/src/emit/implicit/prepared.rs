//! Numbers that the code of a step prepares: for a system or a step length, and for the point where a step starts.

use crate::emit::context::Context;
use crate::schedule::Kernel;
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

/// Types and functions of the prepared numbers, as items of an implementation.
pub(super) struct Prepared {
    pub(super) types: TokenStream,
    pub(super) functions: TokenStream,
    /// The type of the numbers for a system or a step length.
    pub(super) prepared: TokenStream,
    /// The type of the numbers for the start of a step. Empty for stages.
    pub(super) started: TokenStream,
}

/// The name of an associated type, and the name of the function that computes its value.
type Names<'a> = [&'a str; 2];

impl Prepared {
    /// Returns the items for stages, with numbers of the system alone.
    pub(super) fn for_stages(context: &Context<'_>, kernel: &Kernel, names: Names<'_>) -> Self {
        let (prepared, started) = (numbers(kernel, 0), quote!());
        let (types, functions) = constants(context, kernel, names, &quote!(&self));
        Prepared { types, functions, prepared, started }
    }

    /// Returns the items for whole steps, with numbers for a step length h and for a point. The second function takes the point in `arguments`, and starts
    /// with the statements `parts`.
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

/// Returns the associated type and the function of level 0.
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

/// Returns the type of the numbers of a level.
pub(super) fn numbers(kernel: &Kernel, level: usize) -> TokenStream {
    let count = Literal::usize_unsuffixed(kernel.slots[level]);
    quote!([R; #count])
}
