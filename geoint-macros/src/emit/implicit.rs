//! The field of implicit methods: with derivatives for collocation, with divided differences for discrete gradients.

use super::kernel::{Context, place, write};
use super::system::self_type;
use crate::analyze::{MeanValue, Structure};
use crate::diff::{Field, SecondOrder};
use crate::ir::substitute::Substitution;
use crate::ir::{Graph, Id, Node, Number, Ratio, Symbol};
use crate::schedule::{self, Operations};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// The places of a square matrix, row by row.
fn square(places: &[Vec<usize>]) -> Vec<Vec<usize>> {
    places.iter().flat_map(|row| places.iter().map(move |column| [&row[..], &column[..]].concat())).collect()
}

/// The levels of a kernel that is evaluated again and again: parameters and h, the start of a step, iterates.
pub(super) fn level(symbol: Symbol) -> usize {
    match symbol {
        Symbol::Parameter(_) | Symbol::H | Symbol::G => 0,
        Symbol::Q(_) | Symbol::P(_) | Symbol::S | Symbol::T => 1,
        Symbol::Dq(_) | Symbol::Dp(_) | Symbol::Ds => 2,
    }
}

/// The statements that write f and its derivative.
pub(super) fn write_field(names: [&str; 2], places: &[Vec<usize>], values: &[TokenStream]) -> TokenStream {
    let (f, jacobian) = values.split_at(places.len());
    let f = write(names[0], places, f);
    let jacobian = write(names[1], &square(places), jacobian);
    quote!(#f #jacobian)
}

fn roots(field: &Field) -> Vec<Id> {
    field.f.iter().chain(field.jacobian.iter().flatten()).copied().collect()
}

/// With more unknowns than this the runtime prefers the fixed point to Newton's iteration: an elimination costs more than the
/// evaluations that it saves. For six bodies (18 unknowns) a step with the fixed point takes a third to a tenth of the time.
///
/// The runtime reads this number, which has to be one: with a smaller one here, Newton's iteration would do without its own
/// kernel; with a larger one, that kernel would be compiled for nothing.
pub(crate) const MOST_UNKNOWNS: usize = 12;

/// What Newton's iteration needs where T is quadratic: h·f̄, and 1 − h·(∂f̄/∂d)·(∂d/∂impulse) with d = h·M⁻¹(p + impulse/2).
/// What is known before the step is one factor.
///
/// Other systems are left to the runtime: the compiler would take a quarter longer.
fn equation(graph: &mut Graph, field: &Field, second_order: &SecondOrder) -> Vec<Id> {
    let (h, n) = (graph.symbol(Symbol::H), field.unknowns.len());
    let mut roots = field.f.iter().map(|f| graph.mul(h, *f)).collect::<Vec<_>>();
    let square = graph.pow(h, Ratio::integer(2));
    let half = graph.scale(Number::HALF, square);
    for (i, row) in field.jacobian.iter().enumerate() {
        for j in 0..n {
            let mut terms = vec![graph.integer((i == j).into())];
            for (slope, inverse_mass) in row.iter().zip(&second_order.inverse_mass) {
                let weight = graph.mul(half, inverse_mass[j]);
                subtract(graph, weight, *slope, &mut terms);
            }
            roots.push(graph.sum(&terms));
        }
    }
    roots
}

/// −weight·x, a sum term by term: the chain of dependent operations is shorter.
fn subtract(graph: &mut Graph, weight: Id, x: Id, terms: &mut Vec<Id>) {
    let Node::Linear(constant, summands) = graph.node(x).clone() else {
        let product = graph.mul(weight, x);
        return terms.push(graph.neg(product));
    };
    terms.push(graph.scale(constant.neg(), weight));
    for (c, x) in summands {
        let weight = graph.scale(c, weight);
        subtract(graph, weight, x, terms);
    }
}

/// h ∂T/∂p as a function of what stands for the momenta.
fn drift(graph: &mut Graph, velocity: &[Id]) -> Vec<Id> {
    let h = graph.symbol(Symbol::H);
    let mut mean = Substitution::new(|graph: &mut Graph, symbol| match symbol {
        Symbol::P(i) => Some(graph.symbol(Symbol::Dp(i))),
        _ => None,
    });
    let mut scaled = |velocity: &Id| {
        let velocity = mean.apply(graph, *velocity);
        graph.mul(h, velocity)
    };
    velocity.iter().map(&mut scaled).collect()
}

fn momenta(degrees: u32) -> Vec<Symbol> {
    (0..degrees).map(Symbol::P).collect()
}

/// `impl DiscreteField`, and what an evaluation costs.
pub(super) fn discrete_field(
    context: &Context<'_>,
    graph: &mut Graph,
    (field, start, second_order): (&Field, &[Symbol], Option<&SecondOrder>),
    structure: &Structure,
    bounds: &TokenStream,
) -> (TokenStream, Operations) {
    let name = self_type(context);
    let unknown = context.unknown_type(field.unknowns.len());
    let places = context.unknown_places(field.unknowns.len());
    let folded = second_order.filter(|_| field.unknowns.len() <= MOST_UNKNOWNS);
    let equation = folded.map_or_else(Vec::new, |second_order| equation(graph, field, second_order));
    let drift = second_order.map_or_else(Vec::new, |second_order| drift(graph, &second_order.velocity));
    let plan = schedule::plan(graph, level, &[&[], &[]], &[&roots(field), &equation, &drift]);
    let parameters = context.planned(&plan.stores[0], (&[], ""), |values| quote!([#(#values),*]));
    let begin = context.planned(&plan.stores[1], (start, "y"), |values| quote!([#(#values),*]));
    let [prepared, started] = [plan.slots[0], plan.slots[1]].map(Literal::usize_unsuffixed);
    let (given, names) = ((&field.unknowns[..], "d"), [["f", "jacobian"], ["image", "matrix"]]);
    let slope = context.planned(&plan.last[0], given, |values| write_field(names[0], &places, &values));
    let equation = folded.map(|_| {
        let equation = context.planned(&plan.last[1], given, |values| write_field(names[1], &places, &values));
        quote! {
            #[inline(always)]
            fn equation(
                &self,
                _: (&Self::Constants, R),
                prepared: &[R; #prepared],
                start: &[R; #started],
                d: &#unknown,
                image: &mut #unknown,
                matrix: &mut Square<#unknown>,
            ) {
                #equation
            }
        }
    });
    let mean: Vec<Symbol> = (0..drift.len() as u32).map(Symbol::Dp).collect();
    let drift = context.planned(&plan.last[2], (&mean, "p"), |values| write("drift", &places, &values));
    let inverse = if structure.linear() { quote!(Inverted<#unknown>) } else { quote!(()) };
    let mean = match structure.mean_value {
        MeanValue::Gauss(points) => {
            let points = Literal::u32_unsuffixed(points);
            quote!(Gauss(#points))
        }
        MeanValue::Parts(parts) => {
            let parts = Literal::u32_unsuffixed(parts);
            quote!(Parts(#parts))
        }
        MeanValue::NotClosed(_) => quote!(NotClosed),
    };
    let tokens = quote! {
        impl<R: #bounds> DiscreteField<R> for #name {
            type Parameters = [R; #prepared];
            type Start = [R; #started];
            type Inverse = #inverse;
            const MEAN: Mean = Mean::#mean;

            #[inline]
            fn parameters(&self, h: R) -> [R; #prepared] {
                #parameters
            }
            #[inline(always)]
            fn begin(&self, prepared: &[R; #prepared], t: R, y: &#unknown) -> [R; #started] {
                #begin
            }
            #[inline(always)]
            fn slope(
                &self,
                prepared: &[R; #prepared],
                start: &[R; #started],
                d: &#unknown,
                f: &mut #unknown,
                jacobian: &mut Square<#unknown>,
            ) {
                #slope
            }
            #equation
            #[inline(always)]
            fn drift(&self, prepared: &[R; #prepared], p: &#unknown) -> #unknown {
                let mut drift = <#unknown as Array>::zero();
                #drift
                drift
            }
        }
    };
    (tokens, plan.last[0].operations())
}

/// `impl Collocation`, and what one evaluation of the field with its derivative costs.
pub(super) fn collocation(
    context: &Context<'_>,
    graph: &mut Graph,
    field: &Field,
    second_order: Option<&SecondOrder>,
    bounds: &TokenStream,
) -> (TokenStream, Operations) {
    let (name, array) = (self_type(context), context.array());
    let unknown = context.unknown_type(field.unknowns.len());
    let places = context.unknown_places(field.unknowns.len());
    let (velocity, acceleration): (&[Id], &[Id]) =
        second_order.map_or((&[], &[]), |second_order| (&second_order.velocity, &second_order.acceleration));
    // Iterates are the only thing that is not prepared.
    let level = |symbol| level(symbol).min(1);
    let plan = schedule::plan(graph, level, &[&[]], &[&roots(field), velocity, acceleration]);

    let constants = context.planned(&plan.stores[0], (&[], ""), |values| quote!([#(#values),*]));
    let evaluate = context
        .planned(&plan.last[0], (&field.unknowns, "y"), |values| write_field(["f", "jacobian"], &places, &values));
    let momenta = momenta(context.energy.degrees());
    let velocity = context.planned(&plan.last[1], (&momenta, "p"), |values| write("velocity", &places, &values));
    let y: Vec<_> = places.iter().map(|indices| place(quote!(y), indices)).collect();
    let [derivative, start, add, increments] = if second_order.is_some() {
        let add =
            context.planned(&plan.last[2], (&momenta, "f"), |values| quote!(#(#y = w.multiply_add(#values, #y);)*));
        [quote!(2), quote!((*q, *p)), add, quote!([*change, *impulse])]
    } else {
        let f = places.iter().map(|indices| place(quote!(f), indices));
        let add = quote!(#(#y = w.multiply_add(#f, #y);)*);
        [quote!(1), quote!(([*q, *p], [*q, *p])), add, quote!(*change)]
    };
    let prepared = Literal::usize_unsuffixed(plan.slots[0]);
    let tokens = quote! {
        impl<R: #bounds> Collocation<R> for #name {
            type Unknown = #unknown;
            type Constants = [R; #prepared];
            const DERIVATIVE: usize = #derivative;

            #[inline]
            fn constants(&self) -> [R; #prepared] {
                #constants
            }
            #[inline(always)]
            fn start(q: &#array, p: &#array) -> (#unknown, #unknown) {
                #start
            }
            #[inline(always)]
            fn velocity(&self, prepared: &[R; #prepared], p: &#unknown) -> #unknown {
                let mut velocity = <#unknown as Array>::zero();
                #velocity
                velocity
            }
            #[inline(always)]
            fn field(
                &self,
                prepared: &[R; #prepared],
                t: R,
                y: &#unknown,
                f: &mut #unknown,
                jacobian: &mut Square<#unknown>,
            ) {
                #evaluate
            }
            #[inline(always)]
            fn add(&self, prepared: &[R; #prepared], w: R, f: &#unknown, y: &mut #unknown) {
                #add
            }
            #[inline(always)]
            fn increments(change: &#unknown, impulse: &#unknown) -> [#array; 2] {
                #increments
            }
        }
    };
    (tokens, plan.last[0].operations())
}
