//! Exact flows of parts of an energy, and what they are written with.

mod bodies;
mod kick_drift;
mod perturbed;
mod pieces;

use super::kernel::Context;
use crate::derive::FlowKernel;
pub(super) use bodies::{attitudes, bodies};
pub(super) use kick_drift::splitting;
pub(super) use perturbed::perturbed;
pub(super) use pieces::pieces;
use proc_macro2::{Literal, TokenStream};
use quote::quote;

fn slots(flow: &FlowKernel) -> Literal {
    Literal::usize_unsuffixed(flow.kernel.slots[0])
}

/// The parts of a flow in an implementation.
struct FlowTokens {
    /// The type of the prepared numbers.
    prepared: TokenStream,
    /// Bodies of the functions that prepare them, that move a point, and that return the increments of a flow that does more than add.
    prepare: TokenStream,
    flow: TokenStream,
    increments: Option<TokenStream>,
}

fn flow(context: &Context<'_>, flow: &FlowKernel) -> FlowTokens {
    let slots = slots(flow);
    FlowTokens {
        prepared: quote!([R; #slots]),
        prepare: context.stored(&flow.kernel, 0),
        flow: assign(context, flow),
        increments: flow.kernel.find("increments").map(|_| increments(context, flow)),
    }
}

/// `d.q[i] = …; d.p[i] = …; d.s = …;`: the increments of a flow from `x`.
fn increments(context: &Context<'_>, flow: &FlowKernel) -> TokenStream {
    let (parts, writes) = (context.per_coordinate(), context.moved(flow.kernel.routine("increments")));
    let point = if context.form.is_flow() { quote!(q) } else { quote!([q, p]) };
    quote! {
        let PerCoordinate { z: #point, s } = x;
        let mut d: #parts = PerCoordinate::nothing();
        #writes
        d
    }
}

/// `q[i] = …; p[i] = …; *s = …;`
fn assign(context: &Context<'_>, flow: &FlowKernel) -> TokenStream {
    context.moved(flow.kernel.routine("end"))
}
