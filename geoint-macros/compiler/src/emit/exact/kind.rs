//! The kinds of flows, as constants of implementations.

use crate::emit::context::Context;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// The kind of a flow; see `FlowKind` of the runtime.
pub(super) struct Kind {
    /// Whether the flow only adds an increment to positions or to momenta.
    pub(super) adds: bool,
    pub(super) time: Time,
    /// Whether the flow makes momenta non-finite where the energy is not defined.
    pub(super) shows_domain: bool,
    /// The list of parts that may cease to exist within a step.
    pub(super) parts: Option<TokenStream>,
}

/// How a flow depends on time.
pub(super) enum Time {
    Unread,
    Frozen,
    Exact,
}

impl Kind {
    /// Returns the constant `name`.
    pub(super) fn constant(self, context: &Context<'_>, name: &str) -> TokenStream {
        let name = format_ident!("{name}");
        // The path is full, because a struct of the user may have this name.
        let runtime = &context.energy.runtime;
        let kind = quote!(#runtime::private::FlowKind);
        let base = if self.adds { quote!(ADDS) } else { quote!(MOVES) };
        let time = match self.time {
            Time::Unread => Some(quote!(.without_time())),
            Time::Frozen => None,
            Time::Exact => Some(quote!(.exact_in_time())),
        };
        let shows = self.shows_domain.then(|| quote!(.showing_domain()));
        let parts = self.parts.map(|parts| quote!(.with_parts(#parts)));
        quote!(const #name: #kind = #kind::#base #time #shows #parts;)
    }
}
