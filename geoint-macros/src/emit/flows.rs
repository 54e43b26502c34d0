//! Kick and drift, if H = T(p) + V(q) and nothing is damped; otherwise an implementation that no scalar satisfies, whose
//! message names the term that couples, or damps.

use super::kernel::{Context, write};
use super::system::{modified_energy, self_type};
use crate::analyze::{Parts, Split, Structure};
use crate::check::{COUPLED, DAMPED, NOT_QUADRATIC};
use crate::diff::{self, Derivatives, modified};
use crate::ir::{Graph, Id, Number, Symbol, print::Printer};
use crate::schedule::{self, Operations};
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

/// The tokens, and what a kick and a drift cost.
pub(super) fn flows(
    context: &Context<'_>,
    graph: &mut Graph,
    structure: &Structure,
    derivatives: &Derivatives,
    bounds: &TokenStream,
) -> (TokenStream, Option<[Operations; 2]>) {
    let drag = structure
        .damping
        .as_ref()
        .and_then(|damping| damping.matrix.iter().flatten().copied().find(|entry| !graph.is_zero(*entry)));
    match (drag, &structure.split) {
        (None, Split::Separable(parts)) => {
            let (tokens, operations) = separable(context, graph, (parts, derivatives), bounds);
            let modified = modified(context, graph, structure, (parts, derivatives));
            let modified = modified_energy(context, &modified, bounds);
            (quote!(#tokens #modified), Some(operations))
        }
        (Some(term), _) => (none(context, graph, ("Undamped", term, DAMPED), bounds), None),
        (None, Split::Coupled(term)) => (none(context, graph, ("Uncoupled", *term, COUPLED), bounds), None),
    }
}

fn separable(
    context: &Context<'_>,
    graph: &mut Graph,
    (parts, derivatives): (&Parts, &Derivatives),
    bounds: &TokenStream,
) -> (TokenStream, [Operations; 2]) {
    let (name, array) = (self_type(context), context.array());
    // Derivatives of −hV and hT, not −h and h times those of V and T: then h meets the constants of every term and is
    // prepared with them, instead of being multiplied to the sum.
    let h = graph.symbol(Symbol::H);
    let [impulse, shift] = [(parts.potential, Number::MINUS_ONE), (parts.kinetic, Number::ONE)].map(|(part, sign)| {
        let generator = graph.mul(h, part);
        let generator = graph.scale(sign, generator);
        diff::gradient(graph, generator, context.energy.degrees())
    });
    let kick = flow(context, graph, "p", Symbol::P, &impulse.q);
    let drift = flow(context, graph, "q", Symbol::Q, &shift.p);
    let quadratic = match parts.not_quadratic {
        None if context.energy.degrees() <= FEW => {
            let kick = quote!(gradient_kick(self, prepared, t, q, p););
            quadratic(
                context,
                (&quote!((<Self as Collocation<R>>::Constants, [R; 2])), &quote!((self.constants(), [h, g])), &kick),
                bounds,
            )
        }
        None => {
            let (force, velocity) = (&derivatives.field.f, &derivatives.gradient.p);
            let kick = diff::gradient_kick(graph, parts.potential, force, velocity);
            let kick = flow(context, graph, "p", Symbol::P, &kick.impulse);
            let slots = &kick.slots;
            quadratic(context, (&quote!([R; #slots]), &kick.prepare, &kick.body), bounds)
        }
        Some(term) => {
            let (marker, tokens) = unsatisfied(context, graph, "QuadraticIn", term, NOT_QUADRATIC);
            let never = not_quadratic(context, &quote!(#bounds + #marker));
            quote!(#tokens #never)
        }
    };
    let (kick_slots, drift_slots) = (&kick.slots, &drift.slots);
    let (prepare_kick, prepare_drift) = (&kick.prepare, &drift.prepare);
    let (kick_body, drift_body) = (&kick.body, &drift.body);
    let tokens = quote! {
        impl<R: #bounds> Separable<R> for #name {
            type Kick = [R; #kick_slots];
            type Drift = [R; #drift_slots];

            #[inline]
            fn prepare_kick(&self, h: R) -> [R; #kick_slots] {
                #prepare_kick
            }
            #[inline]
            fn prepare_drift(&self, h: R) -> [R; #drift_slots] {
                #prepare_drift
            }
            #[inline(always)]
            fn kick(&self, prepared: &[R; #kick_slots], t: R, q: &mut #array, p: &mut #array, _: &mut ()) {
                #kick_body
            }
            #[inline(always)]
            fn drift(&self, prepared: &[R; #drift_slots], t: R, q: &mut #array, p: &mut #array, _: &mut ()) {
                #drift_body
            }
        }
        #quadratic
    };
    (tokens, [kick.operations, drift.operations])
}

/// The energy that steps of Störmer and Verlet keep up to h⁴: in closed form, or where nothing reads time by the kernels of implicit
/// methods, which costs users no time to compile.
fn modified(
    context: &Context<'_>,
    graph: &mut Graph,
    structure: &Structure,
    (parts, derivatives): (&Parts, &Derivatives),
) -> TokenStream {
    if structure.autonomous && parts.not_quadratic.is_none() {
        return quote!(modified_verlet(self, h, t, q, p));
    }
    let modified = modified::verlet(graph, parts, &derivatives.gradient);
    context.routine(graph, &[modified], |mut values| values.remove(0))
}

struct Flow {
    slots: Literal,
    prepare: TokenStream,
    body: TokenStream,
    operations: Operations,
}

/// x ← x + increment, where what depends on h and parameters only is prepared.
///
/// An increment is summed before it is added: x is rounded once.
fn flow(context: &Context<'_>, graph: &mut Graph, array: &str, symbol: fn(u32) -> Symbol, increments: &[Id]) -> Flow {
    let mut changed = vec![];
    let mut roots = vec![];
    for (i, increment) in increments.iter().enumerate() {
        if graph.is_zero(*increment) {
            continue;
        }
        let start = graph.symbol(symbol(i as u32));
        roots.push(graph.add(start, *increment));
        changed.push(context.coordinate(i as u32));
    }
    let level = |symbol| usize::from(!matches!(symbol, Symbol::Parameter(_) | Symbol::H | Symbol::G));
    let plan = schedule::plan(graph, level, &[&[]], &[&roots]);
    let prepare = context.planned(&plan.stores[0], (&[], ""), |values| quote!([#(#values),*]));
    let body = context.planned(&plan.last[0], (&[], ""), |values| write(array, &changed, &values));
    Flow { slots: Literal::usize_unsuffixed(plan.slots[0]), prepare, body, operations: plan.last[0].operations() }
}

/// In so few degrees of freedom a kick with a force gradient is made of the kernel of implicit methods, whose derivative is hardly
/// more than the one direction that is needed of it: users do not pay for compiling another one.
const FEW: u32 = 3;

/// `impl QuadraticKinetic` and `impl ForceGradient`, by what is prepared for a kick, how, and its body.
pub(super) fn quadratic(
    context: &Context<'_>,
    (prepared, prepare, body): (&TokenStream, &TokenStream, &TokenStream),
    bounds: &TokenStream,
) -> TokenStream {
    let (name, array, action) = (self_type(context), context.array(), context.action());
    quote! {
        impl<R: #bounds> QuadraticKinetic<R> for #name {}
        impl<R: #bounds> ForceGradient<R> for #name {
            type GradientKick = #prepared;
            #[inline]
            fn prepare_gradient_kick(&self, h: R, g: R) -> #prepared {
                #prepare
            }
            #[inline(always)]
            fn gradient_kick(&self, prepared: &#prepared, t: R, q: &mut #array, p: &mut #array, s: &mut #action) {
                #body
            }
        }
    }
}

/// The same for no scalar.
pub(super) fn not_quadratic(context: &Context<'_>, bounds: &TokenStream) -> TokenStream {
    let (name, array, action) = (self_type(context), context.array(), context.action());
    let never = quote!(::core::convert::Infallible);
    quote! {
        impl<R: #bounds> QuadraticKinetic<R> for #name {}
        impl<R: #bounds> ForceGradient<R> for #name {
            type GradientKick = #never;
            fn prepare_gradient_kick(&self, _: R, _: R) -> #never {
                ::core::unreachable!()
            }
            fn gradient_kick(&self, never: &#never, _: R, _: &mut #array, _: &mut #array, _: &mut #action) {
                match *never {}
            }
        }
    }
}

/// Neither kick nor drift, for want of what a term breaks.
fn none(
    context: &Context<'_>,
    graph: &Graph,
    (what, term, why): (&str, Id, &str),
    bounds: &TokenStream,
) -> TokenStream {
    let (name, array) = (self_type(context), context.array());
    let (marker, tokens) = unsatisfied(context, graph, what, term, why);
    let never = quote!(::core::convert::Infallible);
    let not_quadratic = not_quadratic(context, &quote!(#bounds + #marker));
    quote! {
        #tokens
        impl<R: #bounds + #marker> Separable<R> for #name {
            type Kick = #never;
            type Drift = #never;
            fn prepare_kick(&self, _: R) -> #never {
                ::core::unreachable!()
            }
            fn prepare_drift(&self, _: R) -> #never {
                ::core::unreachable!()
            }
            fn kick(&self, never: &#never, _: R, _: &mut #array, _: &mut #array, _: &mut ()) {
                match *never {}
            }
            fn drift(&self, never: &#never, _: R, _: &mut #array, _: &mut #array, _: &mut ()) {
                match *never {}
            }
        }
        #not_quadratic
    }
}

/// A trait that nothing implements, whose message says why a system lacks a property.
pub(super) fn unsatisfied(
    context: &Context<'_>,
    graph: &Graph,
    what: &str,
    term: Id,
    why: &str,
) -> (proc_macro2::Ident, TokenStream) {
    let name = &context.energy.name;
    let marker = format_ident!("{what}{name}");
    let printer = Printer::new(graph, |symbol| context.user_name(symbol));
    let message = format!("`{name}`: {why}");
    let label = format!("the term is: {}", printer.excerpt(term));
    // Braces in a message are read as parameters.
    let (message, label) = (message.replace(['{', '}'], "|"), label.replace(['{', '}'], "|"));
    let tokens = quote! {
        #[diagnostic::on_unimplemented(message = #message, label = #label)]
        pub trait #marker {}
    };
    (marker, tokens)
}
