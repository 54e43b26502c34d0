//! Where the energy is defined: what is tested at a point, and between the ends of a step.

use super::damping;
use super::kernel::Context;
use super::poles;
use crate::analyze::{self, Damping};
use crate::ir::op::Domain;
use crate::ir::{Function, Graph, Id, Node, Number, Partial, print::Printer};
use crate::parse::Form;
use proc_macro2::TokenStream;
use quote::quote;
use std::collections::HashSet;

/// What the trait `PhaseSpace` asks of a domain.
pub(crate) struct DomainTests(pub(super) TokenStream);

/// Derives and writes what is tested of the domain.
pub(crate) fn domain(context: &Context<'_>, graph: &mut Graph, energy: Id, damping: Option<&Damping>) -> DomainTests {
    let (array, action) = (context.array(), context.action());
    let outside = outside_domain(context, graph, damping);
    let poles = analyze::poles(graph, energy, context.partial);
    let poles = poles::poles(context, graph, &poles);
    let jumps = analyze::jumps(graph, energy);
    let jumps = poles::jumps(context, graph, &jumps);
    let examined = needs_examination(context, graph, energy).then(|| {
        quote!(
            const EXAMINED: bool = true;
        )
    });
    let space = quote! {
        fn outside_domain(
            &self, t: R, q: &#array, p: &#array, s: &#action,
        ) -> ::core::option::Option<&'static str> {
            #outside
        }
        #examined
        #poles
        #jumps
    };
    DomainTests(space)
}

/// Whether the end of a step may lie outside the domain without a trace in later steps: a function that is not defined everywhere was
/// simplified away, or its domain has an edge that a method with merged flows may step over and back.
fn needs_examination(context: &Context<'_>, graph: &mut Graph, energy: Id) -> bool {
    let computed: HashSet<Id> = graph.reachable(&[energy]).into_iter().collect();
    let lost = |partial: &&Partial| !computed.contains(&partial.node);
    let moves = |graph: &Graph, partial: &Partial| analyze::reads(graph, partial.node).state();
    context.partial.iter().any(|partial| {
        moves(graph, partial)
            && (lost(&partial) || partial.condition.is_some() || analyze::has_edge(graph, partial.node))
    })
}

/// A condition under which a node is undefined, as a method call on an argument.
struct Check {
    argument: Id,
    /// Tokens behind the argument.
    test: TokenStream,
    message: String,
}

/// The first condition that does not hold. A contact flow may begin where a function of time alone is singular: flows look after
/// that themselves.
fn outside_domain(context: &Context<'_>, graph: &mut Graph, damping: Option<&Damping>) -> TokenStream {
    let mut checks = checks(context, graph);
    if context.energy.form == Form::Contact {
        checks.retain(|check| analyze::reads(graph, check.argument).state());
    }
    let mut matrix = vec![];
    if let Some(damping) = damping {
        let coefficients = damping::coefficients(context, graph, damping).into_iter();
        let negative = quote!(.any_below(0.0));
        checks.extend(coefficients.map(|(argument, message)| Check { argument, test: negative.clone(), message }));
        matrix = damping::open_matrix(damping);
    }
    let roots: Vec<Id> = checks.iter().map(|check| check.argument).chain(matrix).collect();
    context.routine(graph, &roots, |mut values| {
        let matrix = damping::matrix_test(context, &values.split_off(checks.len()));
        let tests = checks.iter().zip(values).map(|(Check { test, message, .. }, value)| {
            quote!(if #value #test { return ::core::option::Option::Some(#message); })
        });
        quote!(#(#tests)* #matrix ::core::option::Option::None)
    })
}

/// What has to be tested for the energy, and its gradient, to be defined. Under a condition it is tested where that holds: that is
/// what an `if` around a root is for.
fn checks(context: &Context<'_>, graph: &mut Graph) -> Vec<Check> {
    let mut checks = vec![];
    for Partial { node, condition } in context.partial {
        let new = checks_of(context, graph, *node);
        checks.extend(
            new.into_iter().map(|check| Check { argument: guarded(graph, *condition, check.argument), ..check }),
        );
    }
    checks
}

/// A node where a condition holds, and elsewhere 1, at which every function of the language is defined.
fn guarded(graph: &mut Graph, condition: Option<Id>, node: Id) -> Id {
    let one = graph.integer(1);
    condition.map_or(node, |condition| graph.select(condition, node, one))
}

/// What has to be tested of one node.
fn checks_of(context: &Context<'_>, graph: &mut Graph, id: Id) -> Vec<Check> {
    let excerpt = |graph: &Graph, id| Printer::new(graph, |symbol| context.user_name(symbol)).excerpt(id);
    let not_positive = quote!(.any_not_positive());
    match graph.node(id).clone() {
        Node::Power(argument, exponent) => {
            let term = excerpt(graph, argument);
            let (test, message) = match (exponent.is_integer(), exponent.numerator < 0) {
                (true, false) => return vec![],
                (true, true) => (quote!(.abs().any_not_positive()), format!("division by zero: {term}")),
                (false, true) => {
                    (not_positive, format!("division by the root of a number that is not positive: {term}"))
                }
                (false, false) => (quote!(.any_below(0.0)), format!("`sqrt` of a negative number: {term}")),
            };
            vec![Check { argument, test, message }]
        }
        Node::Call(function, args) => {
            let Domain::Interval(low, high, what) = function.entry().domain else { return vec![] };
            let message = format!("`{}` of {what}: {}", function.entry().name, excerpt(graph, args[0]));
            // Distances from the ends of the interval.
            let mut distance = |end: f64, sign: Number| {
                let (end, x) = (graph.number(Number::float(end).mul(sign.neg())), graph.scale(sign, args[0]));
                graph.add(end, x)
            };
            let mut ends = vec![distance(low, Number::ONE)];
            if high.is_finite() {
                ends.push(distance(high, Number::MINUS_ONE));
            }
            let negative_power =
                args.get(1).and_then(|exponent| graph.as_number(*exponent)).is_some_and(Number::is_negative);
            let open =
                matches!(function, Function::Ln | Function::Log2 | Function::Log10 | Function::Ln1p | Function::Atanh);
            let test = if open || negative_power { not_positive } else { quote!(.any_below(0.0)) };
            ends.into_iter().map(|argument| Check { argument, test: test.clone(), message: message.clone() }).collect()
        }
        _ => vec![],
    }
}
