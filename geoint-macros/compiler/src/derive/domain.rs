//! Where the energy is defined: what is tested at a point, at the ends of a step, and between them.

use super::poles::{Jumps, Poles, schedule_over_any_scalar};
use crate::analyze::{self, Damping};
use crate::ir::op::Domain as Defined;
use crate::ir::{Function, Graph, Id, Node, Number, Ratio, UndefinedAt};
use crate::parse::Form;
use crate::schedule::{Output, Routine, Scheduler};
use std::collections::{BTreeSet, HashSet};

/// What is tested of the domain.
#[derive(Debug)]
pub(crate) struct Domain {
    /// What is tested at a point.
    pub(crate) checks: Vec<Check>,
    /// The outputs `arguments` of all checks, `enough` of the checks that have [`Check::enough`], and the matrix `damping` if it is not proven to be
    /// positive semidefinite.
    pub(crate) arguments: Routine,
    /// Where the energy is defined but not smooth: what explains a step that is refused there.
    pub(crate) edges: Edges,
    /// Powers that have so many derivatives alone where what they are powers of vanishes: no series goes on from there.
    pub(crate) powers: Edges,
    /// Whether the end of a step may lie outside the domain without a trace in later steps.
    pub(crate) examined: bool,
    pub(crate) poles: Option<Poles>,
    pub(crate) jumps: Option<Jumps>,
    /// Terms that jump where an angle by `atan2` comes round.
    pub(crate) turning: Vec<Id>,
    pub(crate) angles: Option<Angles>,
}

/// The angles `atan2(y, x)` of the state in functions of which divided differences are taken.
#[derive(Debug)]
pub(crate) struct Angles {
    pub(crate) all: Vec<Id>,
    /// y and x of each angle.
    pub(crate) sides: Routine,
}

/// Edges of the domain that belong to it: there a value is a number, and a derivative is not, as of √u at u = 0.
#[derive(Debug)]
pub(crate) struct Edges {
    pub(crate) checks: Vec<Check>,
    /// The argument of each check.
    pub(crate) arguments: Routine,
}

/// What a system is computed from.
#[derive(Clone, Copy)]
pub(crate) struct Roots<'a> {
    pub(super) all: &'a [Id],
    /// Those of which discrete gradients are taken: what jumps where a condition changes, and notices poles.
    pub(super) divided: &'a [Id],
}

impl<'a> Roots<'a> {
    /// Of an energy alone.
    pub(super) fn of_energy(energy: &'a Id) -> Roots<'a> {
        let energy = std::slice::from_ref(energy);
        Roots { all: energy, divided: energy }
    }
}

/// Friction, whose signs are tested.
#[derive(Clone, Copy)]
pub(super) struct Friction<'a> {
    pub(super) damping: Option<&'a Damping>,
    /// Rates, which may contain friction that is not linear.
    pub(super) rates: &'a [Id],
}

impl Friction<'_> {
    pub(super) const NONE: Friction<'static> = Friction { damping: None, rates: &[] };
}

/// A condition under which the energy is undefined.
#[derive(Clone, Debug)]
pub(crate) struct Check {
    pub(super) argument: Id,
    pub(crate) if_it_is: Sign,
    /// What that is, and of what.
    pub(crate) what: String,
    pub(crate) term: Id,
    /// The argument is a sum of squares, of which this one is enough if it is positive: two bodies whose x are apart are in two places.
    pub(crate) enough: Option<Id>,
}

/// A number that must not be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sign {
    Negative,
    NotPositive,
    Zero,
}

impl Domain {
    /// Derives what is tested of nodes some of which are not defined everywhere; `rates` may have friction in them that no matrix gives.
    pub(super) fn of(
        graph: &mut Graph,
        roots: Roots<'_>,
        form: Form,
        partial: &[UndefinedAt],
        Friction { damping, rates }: Friction<'_>,
    ) -> Domain {
        let mut checks = vec![];
        for UndefinedAt { node, condition } in partial {
            for check in checks_of(graph, *node) {
                checks.push(Check { argument: guarded(graph, *condition, check.argument), ..check });
            }
        }
        // A contact flow may begin where a function of time alone is singular: flows look after that themselves.
        if form == Form::Contact {
            checks.retain(|check| graph.reads(check.argument).state());
        }
        let taken: BTreeSet<Id> = graph.reachable(rates).into_iter().filter_map(|id| taken(graph, id)).collect();
        let feeding = |taken| Check::new(taken, Sign::Negative, "friction that would feed energy".into(), taken);
        checks.extend(taken.into_iter().map(feeding));
        let mut matrix = vec![];
        if let Some(damping) = damping {
            let negative = |entry| Check::new(entry, Sign::Negative, "damping that is negative".into(), entry);
            checks.extend(damping.open_diagonal(graph).into_iter().map(negative));
            matrix = damping.open_matrix();
        }
        for check in checks.iter_mut().filter(|check| check.if_it_is != Sign::Negative) {
            check.enough = square_of(graph, check.argument);
        }
        let arguments = checks.iter().map(|check| check.argument).collect();
        let enough = checks.iter().filter_map(|check| check.enough).collect();
        let size = matrix.len().isqrt();
        let arguments = vec![
            Output::row("arguments", arguments),
            Output::row("enough", enough),
            Output::array("damping", &[size, size], matrix),
        ];
        let examined = is_examined(graph, roots.all, partial);
        Domain {
            arguments: Routine::new("outside_domain", arguments),
            checks,
            edges: Edges::of(graph, roots.all),
            powers: Edges::powers(graph, roots.all),
            examined,
            poles: Poles::of(graph, roots.divided, partial),
            jumps: Jumps::of(graph, roots.divided),
            turning: roots.divided.iter().flat_map(|root| analyze::turning_terms(graph, *root)).collect(),
            angles: Angles::of(graph, roots.divided),
        }
    }
}

impl Angles {
    /// Returns the angles that read coordinates and no velocities: the runtime evaluates them at points of phase space.
    fn of(graph: &mut Graph, roots: &[Id]) -> Option<Angles> {
        let mut all = graph.reachable(roots);
        all.retain(|id| {
            let is_angle = matches!(graph.node(*id), Node::Call(Function::Atan2, _));
            is_angle && graph.reads(*id).state() && !graph.reads(*id).v
        });
        let sides: Vec<Id> = all.iter().flat_map(|id| graph.node(*id).children()).collect();
        let sides = Output::array("sides", &[all.len(), 2], sides);
        (!all.is_empty()).then(|| Angles { all, sides: Routine::new("angles", vec![sides]) })
    }
}

impl Domain {
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
    /// Those of all nodes that are computed at every point: a condition is what keeps away from an edge.
    fn of(graph: &mut Graph, roots: &[Id]) -> Edges {
        let (mut open, mut seen, mut checks) = (roots.to_vec(), HashSet::new(), vec![]);
        while let Some(id) = open.pop() {
            if seen.insert(id) && !matches!(graph.node(id), Node::Select(..)) {
                graph.node(id).for_each_child(|id| open.push(id));
                checks.extend(edges_of(graph, id));
            }
        }
        Edges::new(graph, checks)
    }

    /// Powers that are no whole numbers, and vanish with what they are powers of; roots too.
    fn powers(graph: &mut Graph, roots: &[Id]) -> Edges {
        let power = |id: Id| {
            let base = match graph.node(id) {
                Node::Power(base, exponent) if !exponent.is_integer() && exponent.numerator > 0 => *base,
                Node::Call(Function::Powf | Function::Cbrt, args) => args[0],
                Node::Call(Function::Hypot, _) => id,
                _ => return None,
            };
            Some(Check::new(base, Sign::Zero, "a power has no Taylor series where it vanishes".into(), id))
        };
        let checks = graph.reachable(roots).into_iter().filter_map(power).collect();
        Edges::new(graph, checks)
    }

    /// Those that depend on where a system is.
    fn new(graph: &mut Graph, mut checks: Vec<Check>) -> Edges {
        checks.retain(|check: &Check| graph.reads(check.argument).state());
        let arguments = checks.iter().map(|check| check.argument).collect();
        Edges { checks, arguments: Routine::row("arguments", arguments) }
    }
}

impl Check {
    fn new(argument: Id, if_it_is: Sign, what: String, term: Id) -> Check {
        Check { argument, if_it_is, what, term, enough: None }
    }
}

/// Whether steps may lead over an edge of the domain and back unseen: a function that is not defined everywhere was simplified away, or a
/// method with merged flows may pass.
fn is_examined(graph: &mut Graph, roots: &[Id], partial: &[UndefinedAt]) -> bool {
    let computed: HashSet<Id> = graph.reachable(roots).into_iter().collect();
    partial.iter().any(|UndefinedAt { node, condition }| {
        graph.reads(*node).state()
            && !checks_of(graph, *node).is_empty()
            && (!computed.contains(node) || condition.is_some() || analyze::has_edge(graph, *node))
    })
}

/// Whether values are not finite where one of the nodes is not defined: each of them has a base that is divided by on the way to a value,
/// through nothing but sums and products.
pub(super) fn shows(graph: &mut Graph, values: &[Id], partial: &[UndefinedAt]) -> bool {
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

/// The energy that friction takes.
fn taken(graph: &Graph, friction: Id) -> Option<Id> {
    match graph.node(friction) {
        Node::Call(Function::Provided, args) => Some(args[1]),
        _ => None,
    }
}

/// A node where a condition holds, and elsewhere 1, at which every function of the language is defined.
fn guarded(graph: &mut Graph, condition: Option<Id>, node: Id) -> Id {
    let one = graph.integer(1);
    condition.map_or(node, |condition| graph.select(condition, node, one))
}

/// The first term of a sum of squares: rounded as it is, the sum is not below it.
fn square_of(graph: &Graph, sum: Id) -> Option<Id> {
    let Node::Linear(constant, terms) = graph.node(sum) else { return None };
    let is_square = |(c, term): &(Number, Id)| {
        let is_even = |exponent: &Ratio| exponent.is_integer() && exponent.numerator % 2 == 0;
        *c == Number::ONE && matches!(graph.node(*term), Node::Power(_, exponent) if is_even(exponent))
    };
    (!constant.is_negative() && terms.iter().all(is_square)).then(|| terms[0].1)
}

/// What has to be tested of one node for the energy, and its gradient, to be defined. Under a condition it is tested where that holds:
/// that is what an `if` around a root is for.
pub(super) fn checks_of(graph: &mut Graph, id: Id) -> Vec<Check> {
    match graph.node(id).clone() {
        Node::Power(base, exponent) => {
            let (sign, what) = match (exponent.is_integer(), exponent.numerator < 0) {
                (true, false) => return vec![],
                (true, true) => (Sign::Zero, "division by zero"),
                (false, true) => (Sign::NotPositive, "division by the root of a number that is not positive"),
                (false, false) if !analyze::has_edge(graph, id) => return vec![],
                (false, false) => (Sign::Negative, "`sqrt` of a negative number"),
            };
            vec![Check::new(base, sign, what.into(), base)]
        }
        Node::Call(function, args) => {
            let Defined::Interval(low, high, of) = function.entry().domain else { return vec![] };
            let what = format!("`{}` of {of}", function.entry().name);
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
            let sign = if open || negative_power { Sign::NotPositive } else { Sign::Negative };
            ends.into_iter().map(|argument| Check::new(argument, sign, what.clone(), args[0])).collect()
        }
        _ => vec![],
    }
}

/// Where a node has a value, and no second derivative.
fn edges_of(graph: &mut Graph, id: Id) -> Vec<Check> {
    let rough = |check: Check| Check {
        if_it_is: Sign::NotPositive,
        what: "a derivative that is not a number".into(),
        term: id,
        ..check
    };
    match graph.node(id) {
        Node::Power(base, exponent)
            if !exponent.is_integer() && exponent.numerator > 0 && exponent.numerator < 2 * exponent.denominator =>
        {
            vec![rough(Check::new(*base, Sign::NotPositive, String::new(), id))]
        }
        Node::Call(..) => {
            checks_of(graph, id).into_iter().filter(|check| check.if_it_is == Sign::Negative).map(rough).collect()
        }
        _ => vec![],
    }
}
