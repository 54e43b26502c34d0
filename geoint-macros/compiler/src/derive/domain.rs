//! Domain of the energy: tests at a point, at the ends of a step, and between them.

use super::checks::{Check, Sign, checks_of, checks_where, edges_of, square_of};
use super::poles::{Angles, Jumps, Poles, schedule_over_any_scalar};
use crate::analyze::{self, Damping};
use crate::ir::{Function, Graph, Id, Node, UndefinedAt};
use crate::parse::Form;
use crate::schedule::{Output, Routine, Scheduler};
use std::collections::{BTreeSet, HashSet};

/// Tests of the domain.
#[derive(Debug)]
pub(crate) struct Domain {
    /// Conditions at a point. A state for which one of them holds is outside the domain.
    pub(crate) checks: Vec<Check>,
    /// The outputs `arguments` of all checks, `enough` of the checks that have [`Check::enough`], and the matrix `damping` or `friction` if it is not
    /// proven to be positive semidefinite.
    pub(crate) arguments: Routine,
    /// Points at which the energy has a value, but no second derivative. The runtime names them if it refuses a step there.
    pub(crate) edges: Edges,
    /// Zeros at which a power or root has finitely many derivatives. A Taylor series ends there.
    pub(crate) powers: Edges,
    /// True if the end of a step may lie outside the domain while later steps stay finite. The runtime then tests every end.
    pub(crate) examined: bool,
    pub(crate) poles: Option<Poles>,
    pub(crate) jumps: Option<Jumps>,
    /// Terms that jump where an angle `atan2(y, x)` passes from π to −π.
    pub(crate) turning: Vec<Id>,
    pub(crate) angles: Option<Angles>,
}

/// Boundary points that belong to the domain. The energy has a value there, but no derivative, as √u at u = 0.
#[derive(Debug)]
pub(crate) struct Edges {
    pub(crate) checks: Vec<Check>,
    /// The argument of each check.
    pub(crate) arguments: Routine,
}

/// The formulas of a system, for the tests of its domain.
#[derive(Clone, Copy)]
pub(super) struct Formulas<'a> {
    /// All formulas that a step evaluates.
    pub(super) all: &'a [Id],
    /// Formulas with discrete gradients. Steps look for their poles, and for jumps where a condition in them changes.
    pub(super) divided: &'a [Id],
    /// Expressions of the user that are not defined everywhere.
    pub(super) partial: &'a [UndefinedAt],
    pub(super) damping: Option<&'a Damping>,
    /// Further states at which a step does not exist although the energy has a value.
    pub(super) edges: &'a [Check],
    /// Rates, which may contain friction that is not linear in the velocities.
    pub(super) rates: &'a [Id],
}

impl<'a> Formulas<'a> {
    /// Formulas with discrete gradients, and without friction.
    pub(super) fn new(formulas: &'a [Id], partial: &'a [UndefinedAt]) -> Formulas<'a> {
        Formulas { all: formulas, divided: formulas, partial, damping: None, edges: &[], rates: &[] }
    }
}

impl Domain {
    /// Derives the tests of the domain from the formulas of a system.
    pub(super) fn of(graph: &mut Graph, form: Form, formulas: Formulas<'_>) -> Domain {
        let Formulas { all, divided, partial, damping, edges, rates } = formulas;
        let mut checks: Vec<Check> = partial.iter().flat_map(|partial| checks_where(graph, partial)).collect();
        // A contact flow may start where a function of time alone is singular. Its pieces check the time themselves.
        if form.has_action() {
            checks.retain(|check| graph.reads(check.argument).state());
        }
        let powers: BTreeSet<Id> =
            graph.reachable(rates).into_iter().filter_map(|id| dissipated_power(graph, id)).collect();
        let feeding = |power| Check::new(power, Sign::Negative, "friction that would feed energy", power);
        checks.extend(powers.into_iter().map(feeding));
        let mut matrix = vec![];
        if let Some(damping) = damping {
            let message = format!("{} that is negative", damping.name);
            let negative = |entry| Check::new(entry, Sign::Negative, message.clone(), entry);
            checks.extend(damping.open_diagonal(graph).into_iter().map(negative));
            matrix = damping.open_matrix();
        }
        for check in checks.iter_mut().filter(|check| check.forbidden != Sign::Negative) {
            check.enough = square_of(graph, check.argument);
        }
        let arguments = checks.iter().map(|check| check.argument).collect();
        let enough = checks.iter().filter_map(|check| check.enough).collect();
        let size = matrix.len().isqrt();
        let arguments = vec![
            Output::row("arguments", arguments),
            Output::row("enough", enough),
            Output::array(damping.map_or("damping", |damping| damping.name), &[size, size], matrix),
        ];
        Domain {
            arguments: Routine::new("outside_domain", arguments),
            checks,
            edges: Edges::of(graph, all, edges),
            powers: Edges::powers(graph, all),
            examined: is_examined(graph, all, partial),
            poles: Poles::of(graph, divided, partial),
            jumps: Jumps::of(graph, divided),
            turning: divided.iter().flat_map(|formula| analyze::turning_terms(graph, *formula)).collect(),
            angles: Angles::of(graph, divided),
        }
    }

    /// Computes the statements of all routines.
    pub(super) fn schedule(&mut self, scheduler: &mut Scheduler<'_>) {
        self.arguments.schedule(scheduler);
        self.edges.arguments.schedule(scheduler);
        self.powers.arguments.schedule(scheduler);
        if let Some(poles) = &mut self.poles {
            poles.schedule(scheduler);
        }
        if let Some(Jumps { sides, heights, .. }) = &mut self.jumps {
            sides.schedule(scheduler);
            schedule_over_any_scalar(heights, scheduler);
        }
        if let Some(angles) = &mut self.angles {
            angles.sides.schedule(scheduler);
        }
    }
}

impl Edges {
    /// Edges of the nodes that are computed at every point, after the given ones. Nodes below a condition are left out, because the condition may avoid their
    /// edges.
    fn of(graph: &mut Graph, roots: &[Id], given: &[Check]) -> Edges {
        let (mut open, mut seen, mut checks) = (roots.to_vec(), HashSet::new(), given.to_vec());
        while let Some(id) = open.pop() {
            if seen.insert(id) && !matches!(graph.node(id), Node::Select(..)) {
                graph.node(id).for_each_child(|id| open.push(id));
                checks.extend(edges_of(graph, id));
            }
        }
        Edges::new(graph, checks)
    }

    /// Zeros of the bases of fractional powers and roots.
    fn powers(graph: &mut Graph, roots: &[Id]) -> Edges {
        let power = |id: Id| {
            let base = match graph.node(id) {
                Node::Power(base, exponent) if !exponent.is_integer() && exponent.numerator > 0 => *base,
                Node::Call(Function::Powf | Function::Cbrt, args) => args[0],
                Node::Call(Function::Hypot, _) => id,
                _ => return None,
            };
            Some(Check::new(base, Sign::Zero, "a power has no Taylor series where it vanishes", id))
        };
        let checks = graph.reachable(roots).into_iter().filter_map(power).collect();
        Edges::new(graph, checks)
    }

    /// Keeps the checks that depend on the state. Velocities are no part of a state, so a check of a Lagrangian that is solved for them has no name for its edge.
    fn new(graph: &mut Graph, mut checks: Vec<Check>) -> Edges {
        checks.retain(|check: &Check| graph.reads(check.argument).state() && !graph.reads(check.argument).v);
        let arguments = checks.iter().map(|check| check.argument).collect();
        Edges { checks, arguments: Routine::row("arguments", arguments) }
    }
}

/// Returns whether a step may cross the boundary of the domain while all values stay finite. This is possible in two cases: an expression that is not
/// defined everywhere was simplified away, or its value is finite on the boundary and flows of consecutive steps are merged.
fn is_examined(graph: &mut Graph, roots: &[Id], partial: &[UndefinedAt]) -> bool {
    let computed: HashSet<Id> = graph.reachable(roots).into_iter().collect();
    partial.iter().any(|UndefinedAt { node, condition }| {
        graph.reads(*node).state()
            && !checks_of(graph, *node).is_empty()
            && (!computed.contains(node) || condition.is_some() || analyze::has_edge(graph, *node))
    })
}

/// Returns whether the values are not finite wherever one of the expressions is undefined. Proof: sums and products alone lead from a division by the
/// base of the expression to a value.
pub(super) fn shows(graph: &mut Graph, values: &[Id], partial: &[UndefinedAt]) -> bool {
    // Divisors, and whether their exponent is an integer.
    let mut divided: HashSet<(Id, bool)> = HashSet::new();
    let mut open = values.to_vec();
    let mut seen: HashSet<Id> = HashSet::new();
    while let Some(id) = open.pop() {
        match graph.node(id) {
            Node::Power(base, exponent) if exponent.numerator < 0 => {
                divided.extend([(*base, true), (*base, exponent.is_integer())]);
            }
            Node::Linear(..) | Node::Product(_) if seen.insert(id) => graph.node(id).for_each_child(|id| open.push(id)),
            _ => {}
        }
    }
    partial.iter().all(|UndefinedAt { node, condition }| {
        if !graph.reads(*node).state() || checks_of(graph, *node).is_empty() {
            return true;
        }
        // 1/√x² is a power of a power.
        let (mut base, mut whole) = (*node, true);
        while let Node::Power(inner, exponent) = graph.node(base) {
            whole &= exponent.is_integer() || !analyze::has_edge(graph, base);
            base = *inner;
        }
        condition.is_none() && divided.contains(&(base, whole))
    })
}

/// Returns the power that friction dissipates, if the node is a friction force.
fn dissipated_power(graph: &Graph, friction: Id) -> Option<Id> {
    match graph.node(friction) {
        Node::Call(Function::Provided, args) => Some(args[1]),
        _ => None,
    }
}
