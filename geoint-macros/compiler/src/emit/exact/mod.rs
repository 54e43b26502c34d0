//! Exact flows of parts of an energy, and what they are written with.

mod bodies;
mod kick_drift;
mod perturbed;
mod pieces;

use super::kernel::Context;
use crate::derive::FlowKernel;
use crate::ir::Symbol;
use crate::schedule::{Array, Place, Plan};
pub(super) use bodies::bodies;
pub(super) use kick_drift::splitting;
pub(super) use perturbed::perturbed;
pub(super) use pieces::pieces;
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

fn slots(flow: &FlowKernel<Plan>) -> Literal {
    Literal::usize_unsuffixed(flow.kernel.slots[0])
}

/// The type of what is prepared for a flow, the function that prepares it, and the flow.
fn flow(context: &Context<'_>, name: &str, flow_kernel: &FlowKernel<Plan>) -> (TokenStream, TokenStream, TokenStream) {
    let (array, prepare_name, name) = (context.array(), format_ident!("prepare_{name}"), format_ident!("{name}"));
    let (slots, prepare, body) =
        (slots(flow_kernel), context.stored(&flow_kernel.kernel, 0), assign(context, flow_kernel));
    let action = match context.energy.form {
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
    let increments = flow_kernel.kernel.last.get(1).map(|_| {
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
fn increments(context: &Context<'_>, flow: &FlowKernel<Plan>) -> TokenStream {
    let entry = |half: &[usize], i: u32| Place {
        array: Array::Increment,
        indices: [half, &context.coordinate(i)[..]].concat(),
    };
    let targets = flow.changes.iter().map(|symbol| match symbol {
        Symbol::Position(i) if context.energy.form.is_flow() => entry(&[], *i),
        Symbol::Position(i) => entry(&[0], *i),
        Symbol::Momentum(i) => entry(&[1], *i),
        _ => Place::number(Symbol::ActionIncrement),
    });
    let parts = context.per_coordinate();
    let writes = context.written(&flow.kernel.last[1], &targets.collect::<Vec<_>>());
    let point = if context.energy.form.is_flow() { quote!(q) } else { quote!([q, p]) };
    quote! {
        let PerCoordinate { z: #point, s } = x;
        let mut d: #parts = PerCoordinate::nothing();
        #writes
        d
    }
}

/// `q[i] = …; p[i] = …; *s = …;`
fn assign(context: &Context<'_>, flow: &FlowKernel<Plan>) -> TokenStream {
    let layout = context.layout(vec![]);
    let targets: Vec<Place> = flow.changes.iter().map(|symbol| layout.place(*symbol)).collect();
    context.written(&flow.kernel.last[0], &targets)
}
