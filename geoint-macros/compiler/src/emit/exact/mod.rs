//! Exact flows of parts of an energy, and what they are written with.

mod bodies;
mod kick_drift;
mod perturbed;
mod pieces;

use super::given::{Given, array};
use super::kernel::Context;
use crate::derive::FlowKernel;
use crate::ir::Symbol;
pub(super) use bodies::{attitudes, bodies};
pub(super) use kick_drift::splitting;
pub(super) use perturbed::perturbed;
pub(super) use pieces::pieces;
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

fn slots(flow: &FlowKernel) -> Literal {
    Literal::usize_unsuffixed(flow.kernel.slots[0])
}

/// The type of what is prepared for a flow, the function that prepares it, and the flow.
fn flow(context: &Context<'_>, name: &str, flow_kernel: &FlowKernel) -> (TokenStream, TokenStream, TokenStream) {
    let (array, prepare_name, name) = (context.array(), format_ident!("prepare_{name}"), format_ident!("{name}"));
    let (slots, prepare, body) =
        (slots(flow_kernel), context.stored(&flow_kernel.kernel, 0), assign(context, flow_kernel));
    let action = match context.form {
        form if form.has_action() => quote!(s: &mut R),
        _ => quote!(_: &mut ()),
    };
    let prepare = quote! {
        #[inline]
        fn #prepare_name(&self, h: R) -> [R; #slots] {
            #prepare
        }
    };
    let flow = quote! {
        #[inline(always)]
        fn #name(&self, prepared: &[R; #slots], t: R, q: &mut #array, p: &mut #array, #action) {
            #body
        }
    };
    // What only adds needs no second routine.
    let increments = flow_kernel.kernel.find("increments").map(|_| {
        let (name, body) = (format_ident!("{name}_increments"), increments(context, flow_kernel));
        let parts = context.per_coordinate();
        quote! {
            #[inline(always)]
            fn #name(&self, prepared: &[R; #slots], t: R, x: &#parts) -> #parts {
                #body
            }
        }
    });
    (quote!([R; #slots]), prepare, quote!(#flow #increments))
}

/// `d.q[i] = …; d.p[i] = …; d.s = …;`: what a flow from `x` adds.
fn increments(context: &Context<'_>, flow: &FlowKernel) -> TokenStream {
    let entry = |half: &[usize], i: u32| {
        let indices = [half, &context.coordinate(i)[..]].concat();
        Given::entry(array::INCREMENTS, quote!(d.z), indices)
    };
    let target = |symbol| match symbol {
        Symbol::Position(i) if context.form.is_flow() => entry(&[], i),
        Symbol::Position(i) => entry(&[0], i),
        Symbol::Momentum(i) => entry(&[1], i),
        _ => Given::alone(quote!(d.s)),
    };
    let parts = context.per_coordinate();
    let writes = context.moved(flow.kernel.routine("increments"), target);
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
    context.moved(flow.kernel.routine("end"), |symbol| context.input(symbol))
}
