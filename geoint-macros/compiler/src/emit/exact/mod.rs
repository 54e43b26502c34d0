//! Emits exact flows of parts of an energy: of V (kick) and T (drift), of both parts of A + B (perturbed systems), of the pieces of a sum, and of rigid
//! bodies. The file `stepped_as` names the steps of splittings of contact systems.
//!
//! A flow computes some numbers once, before the first step, from the parameters and its length. These are the prepared numbers, level 0 of its kernel.
//!
//! Each flow moves a point in place. A run with compensated sums needs the increment of every coordinate instead, because it carries
//! the rounding error of each sum.

mod bodies;
mod kick_drift;
mod kind;
mod perturbed;
mod pieces;
mod stepped_as;

use super::context::Context;
use crate::derive::FlowKernel;
pub(super) use bodies::{attitudes, bodies};
pub(super) use kick_drift::splitting;
pub(super) use perturbed::perturbed;
pub(super) use pieces::pieces;
use proc_macro2::{Literal, TokenStream};
use quote::quote;
pub(super) use stepped_as::stepped_as;

/// Returns the number of prepared numbers of a flow.
fn slots(flow: &FlowKernel) -> Literal {
    Literal::usize_unsuffixed(flow.kernel.slots[0])
}

/// The emitted code of one flow.
struct FlowTokens {
    /// The type of the prepared numbers.
    prepared: TokenStream,
    /// Body of the function that computes the prepared numbers.
    prepare: TokenStream,
    /// Body of the function that moves a point.
    flow: TokenStream,
    /// Body of the function that returns the increments of a point, for compensated sums. Absent if the flow only adds to positions, or only to momenta: the
    /// default of the runtime's trait applies such a flow to zeros.
    increments: Option<TokenStream>,
}

/// Returns the tokens of a flow.
fn flow(context: &Context<'_>, flow: &FlowKernel) -> FlowTokens {
    let slots = slots(flow);
    FlowTokens {
        prepared: quote!([R; #slots]),
        prepare: context.stored(&flow.kernel, 0),
        flow: assign(context, flow),
        increments: flow.kernel.find("increments").map(|_| increments(context, flow)),
    }
}

/// Returns the body of a function with the increments of a flow from `x`: `d.z[0][i] = …; d.z[1][i] = …; d.s = …;`. A system x' = f(x) has one array
/// of coordinates, `d.z[i]`.
fn increments(context: &Context<'_>, flow: &FlowKernel) -> TokenStream {
    let (parts, writes) =
        (context.per_coordinate_type(), context.coordinates_written(flow.kernel.routine("increments")));
    let point = if context.form.is_flow() { quote!(q) } else { quote!([q, p]) };
    quote! {
        let PerCoordinate { z: #point, s } = x;
        let mut d: #parts = PerCoordinate::nothing();
        #writes
        d
    }
}

/// Returns the statements that assign the new values of the coordinates that a flow changes: `q[i] = …; p[i] = …; *s = …;`.
fn assign(context: &Context<'_>, flow: &FlowKernel) -> TokenStream {
    context.coordinates_written(flow.kernel.routine("end"))
}
