//! Where the energy is defined: what is tested at a point, and between the ends of a step.

use super::damping;
use super::kernel::Context;
use crate::analyze::{self, Damping, Pole, poles};
use crate::ir::op::Domain;
use crate::ir::{Function, Graph, Id, Node, print::Printer};
use crate::parse::Form;
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};
use std::collections::HashSet;

/// What the trait `PhaseSpace` asks of a domain, and `Hamiltonian`: of poles those that divided differences do not notice either.
pub(crate) struct DomainTests {
    pub(super) space: TokenStream,
    pub(super) hidden: Option<TokenStream>,
}

/// Derives and writes what is tested of the domain.
pub(crate) fn domain(context: &Context<'_>, graph: &mut Graph, energy: Id, damping: Option<&Damping>) -> DomainTests {
    let (array, action) = (context.array(), context.action());
    let outside = outside_domain(context, graph, energy, damping);
    let nodes = unconditional(graph, energy, context.partial);
    let poles = poles(graph, &nodes);
    let between = sides(context, graph, &poles, End::Open).map(|body| pole_between(context, "pole_between", &body));
    let (singular, hidden) = match context.energy.form {
        Form::Contact => (singular_time(context, graph, &poles), None),
        Form::Hamiltonian => (None, hidden(context, graph, &poles)),
    };
    let space = quote! {
        fn outside_domain(
            &self, t: R, q: &#array, p: &#array, s: &#action,
        ) -> ::core::option::Option<&'static str> {
            #outside
        }
        #between
        #singular
    };
    DomainTests { space, hidden }
}

/// Poles in time alone, which no flow at frozen time notices.
fn singular_time(context: &Context<'_>, graph: &mut Graph, poles: &[Pole]) -> Option<TokenStream> {
    let timed =
        poles.iter().filter(|pole| !analyze::reads(graph, pole.vanishes).state()).copied().collect::<Vec<Pole>>();
    sides(context, graph, &timed, End::Closed).map(|body| pole_between(context, "singular_time_between", &body))
}

fn hidden(context: &Context<'_>, graph: &mut Graph, poles: &[Pole]) -> Option<TokenStream> {
    let hidden: Vec<Pole> = poles.iter().filter(|pole| pole.hidden).copied().collect();
    sides(context, graph, &hidden, End::Open).map(|body| pole_between(context, "hidden_pole_between", &body))
}

fn pole_between(context: &Context<'_>, name: &str, body: &TokenStream) -> TokenStream {
    let (array, action, name) = (context.array(), context.action(), format_ident!("{name}"));
    quote! {
        #[inline]
        fn #name(
            &self, t: [R; 2], q: [&#array; 2], p: [&#array; 2], s: [&#action; 2],
        ) -> ::core::option::Option<&'static str> {
            #body
            ::core::option::Option::None
        }
    }
}

/// Whether a step may end at a pole.
#[derive(Clone, Copy, PartialEq, Eq)]
enum End {
    Open,
    Closed,
}

/// Tests that nothing changes its sign which vanishes at a pole.
fn sides(context: &Context<'_>, graph: &mut Graph, poles: &[Pole], end: End) -> Option<TokenStream> {
    if poles.is_empty() {
        return None;
    }
    let printer = Printer::new(graph, |symbol| context.user_name(symbol));
    let messages: Vec<String> = poles
        .iter()
        .map(|pole| format!("a pole between the ends of the step: {}", printer.excerpt(pole.term)))
        .collect();
    let roots: Vec<Id> = poles.iter().map(|pole| pole.vanishes).collect();
    let (array, action, count) = (context.array(), context.action(), Literal::usize_unsuffixed(poles.len()));
    let values = context.routine(graph, &roots, |values| quote!([#(#values),*]));
    let tests = (0..poles.len()).map(Literal::usize_unsuffixed).map(|i| {
        let reached = (end == End::Closed).then(|| quote!(|| end[#i].abs().any_not_positive()));
        quote!((start[#i] * end[#i]).any_below(0.0) #reached)
    });
    Some(quote! {
        let side = |t: R, q: &#array, p: &#array, s: &#action| -> [R; #count] { #values };
        let (start, end) = (side(t[0], q[0], p[0], s[0]), side(t[1], q[1], p[1], s[1]));
        #(if #tests { return ::core::option::Option::Some(#messages); })*
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
fn outside_domain(context: &Context<'_>, graph: &mut Graph, energy: Id, damping: Option<&Damping>) -> TokenStream {
    let mut checks = checks(context, graph, energy);
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

/// What has to be tested for the energy, and its gradient, to be defined. Branches test for themselves: that is what an
/// `if` around a root is for.
fn checks(context: &Context<'_>, graph: &Graph, energy: Id) -> Vec<Check> {
    let printer = Printer::new(graph, |symbol| context.user_name(symbol));
    // The smallest positive number: below it is zero or negative.
    let not_positive = quote!(.any_not_positive());
    let zero = quote!(.abs().any_not_positive());
    let mut checks = vec![];
    for id in unconditional(graph, energy, context.partial) {
        match graph.node(id) {
            Node::Power(base, exponent) => {
                let term = printer.excerpt(*base);
                let (test, message) = match (exponent.is_integer(), exponent.numerator < 0) {
                    (true, false) => continue,
                    (true, true) => (zero.clone(), format!("division by zero: {term}")),
                    (false, true) => {
                        (not_positive.clone(), format!("division by the root of a number that is not positive: {term}"))
                    }
                    (false, false) => (quote!(.any_below(0.0)), format!("`sqrt` of a negative number: {term}")),
                };
                checks.push(Check { argument: *base, test, message });
            }
            Node::Call(function, args) => {
                let Domain::Interval(low, high, what) = function.entry().domain else { continue };
                let message = format!("`{}` of {what}: {}", function.entry().name, printer.excerpt(args[0]));
                let open = matches!(function, Function::Ln | Function::Log2 | Function::Log10);
                let low = Literal::f64_unsuffixed(low.abs());
                let below = match (open, function.entry().domain) {
                    (true, _) => not_positive.clone(),
                    (_, Domain::Interval(bound, ..)) if bound < 0.0 => quote!(.any_below(-#low)),
                    _ => quote!(.any_below(#low)),
                };
                checks.push(Check { argument: args[0], test: below, message: message.clone() });
                if high.is_finite() {
                    let high = Literal::f64_unsuffixed(high);
                    checks.push(Check { argument: args[0], test: quote!(.any_above(#high)), message });
                }
            }
            _ => {}
        }
    }
    checks
}

/// The root, and more nodes, with all that is computed for them whatever the conditions are.
fn unconditional(graph: &Graph, root: Id, more: &[Id]) -> Vec<Id> {
    let (mut seen, mut open) = (HashSet::new(), [&[root], more].concat());
    while let Some(id) = open.pop() {
        if seen.insert(id) {
            match graph.node(id) {
                Node::Select(condition, _, _) => open.push(*condition),
                node => open.extend(node.children()),
            }
        }
    }
    let mut all: Vec<Id> = seen.into_iter().collect();
    all.sort();
    all
}
