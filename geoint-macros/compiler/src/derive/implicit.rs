//! The equations of implicit methods.

use super::system::{Collocation, FieldKernels, StageKernel, StepKernel};
use crate::analyze::{self, Structure};
use crate::diff::contact::{self, Equation};
use crate::diff::field::{self, Field, SecondOrder};
use crate::diff::{self, Gradient};
use crate::ir::substitute::Substitution;
use crate::ir::{AffineForms, Graph, Id, Node, Number, Ratio, Symbol};
use crate::schedule::{Argument, Kernel, Levels, Output, Routine, Space, phase};

/// With more unknowns than this the runtime prefers the fixed point to Newton's iteration: an elimination costs more than the
/// evaluations that it saves. For six bodies (18 unknowns) a step with the fixed point takes a third to a tenth of the time.
///
/// The runtime reads this number, which has to be one: with a smaller one here, Newton's iteration would do without its own
/// kernel; with a larger one, that kernel would be compiled for nothing.
pub(crate) const MOST_UNKNOWNS: usize = 12;

/// The field, with derivatives and with divided differences, and what T adds to it.
pub(super) fn field(graph: &mut Graph, gradient: &Gradient, structure: &Structure, degrees: u32) -> Fields {
    let field = field::field(graph, gradient, structure, degrees);
    let discrete = field::discrete(graph, structure, degrees);
    let second_order = field::second_order(graph, gradient, structure, degrees);
    Fields { field, discrete, second_order }
}

/// The field of implicit methods.
pub(super) struct Fields {
    pub(super) field: Field,
    discrete: Field,
    second_order: Option<SecondOrder>,
}

impl Fields {
    /// The kernels of collocation and of discrete gradients.
    pub(super) fn kernels(self, graph: &mut Graph, structure: &Structure, positions: &[usize]) -> FieldKernels {
        let Fields { field, discrete, second_order } = self;
        let [coordinates, increments] =
            [&field, &discrete].map(|field| Space::of_unknowns(field.unknowns.clone(), positions));
        let degrees = positions.iter().product::<usize>() as u32;
        let mut stages = vec![field_routine("field", &field, &coordinates).reading("y", &coordinates)];
        let mut steps = vec![field_routine("slope", &discrete, &increments).reading("d", &increments)];
        if let Some(found) = &second_order {
            if field.unknowns.len() <= MOST_UNKNOWNS {
                steps.push(equation(graph, &discrete, found, &increments).reading("d", &increments));
            }
            let momenta = Space { symbols: (0..degrees).map(Symbol::Momentum).collect(), extents: positions.to_vec() };
            let sums =
                Space { symbols: (0..degrees).map(Symbol::MomentumIncrement).collect(), extents: positions.to_vec() };
            let vector = |name, nodes| Routine::new(name, vec![Output::array(name, positions, nodes)]);
            stages.push(vector("velocity", found.velocity.clone()).reading("p", &momenta));
            stages.push(vector("acceleration", found.acceleration.clone()).reading("f", &momenta));
            steps.push(vector("drift", drift(graph, &found.velocity)).reading("sum", &sums));
        }
        FieldKernels {
            linear: structure.linear(),
            mean_value: structure.mean_value,
            collocation: Collocation {
                second_order: second_order.is_some(),
                kernel: Kernel::new(Levels::Prepared, stages),
            },
            discrete: Some(iterated(steps, &coordinates)),
            nothing_kept: None,
            canonical: None,
            fourth: None,
            momenta: momenta(graph, structure, positions),
            coordinates,
            increments,
        }
    }
}

/// Gradients of the momenta that are kept beside H. Single coordinates are kept without them.
fn momenta(graph: &mut Graph, structure: &Structure, positions: &[usize]) -> Routine {
    let degrees = positions.iter().product::<usize>() as u32;
    let kept = if structure.conservative() { &structure.momenta[..] } else { &[] };
    let mut slopes = vec![];
    for momentum in kept {
        let gradient = diff::gradient(graph, momentum.value, degrees);
        slopes.extend([gradient.q, gradient.p].concat());
    }
    let extents = [&[kept.len()], &phase(positions)[..]].concat();
    Routine::new("momenta", vec![Output::array("slopes", &extents, slopes)])
}

/// The routine of f and its derivative.
pub(super) fn field_routine(name: &'static str, field: &Field, space: &Space) -> Routine {
    let f = Output::array("f", &space.extents, field.f.clone());
    Routine::new(name, vec![f, Output::square("jacobian", &space.extents, &field.jacobian)])
}

/// A kernel whose steps start at `y`.
pub(super) fn iterated(routines: Vec<Routine>, start: &Space) -> Kernel {
    let start = Some(Argument { name: "y", space: start.clone() });
    Kernel { start, ..Kernel::new(Levels::Iterated, routines) }
}

/// What Newton's iteration needs where T is quadratic: h·f̄, and 1 − h·(∂f̄/∂d)·(∂d/∂impulse) with d = h·M⁻¹(p + impulse/2).
/// What is known before the step is one factor.
///
/// Other systems are left to the runtime: the compiler would take a quarter longer.
fn equation(graph: &mut Graph, field: &Field, second_order: &SecondOrder, space: &Space) -> Routine {
    let (h, n) = (graph.symbol(Symbol::StepLength), field.unknowns.len());
    let image = field.f.iter().map(|f| graph.mul(h, *f)).collect();
    let mut matrix = vec![];
    let square = graph.pow(h, Ratio::integer(2));
    let half = graph.scale(Number::HALF, square);
    let mut affine_forms = AffineForms::new(|symbol| field.unknowns.contains(&symbol));
    for (i, row) in field.jacobian.iter().enumerate() {
        let mut entries = vec![];
        for j in 0..n {
            let mut terms = vec![graph.integer((i == j).into())];
            for (slope, inverse_mass) in row.iter().zip(&second_order.inverse_mass) {
                let weight = graph.mul(half, inverse_mass[j]);
                subtract(graph, weight, *slope, &mut terms);
            }
            let entry = graph.sum(&terms);
            entries.push(affine_forms.shortened(graph, entry));
        }
        matrix.push(entries);
    }
    equation_routine("equation", image, &matrix, space)
}

/// The routine of an equation d = image(d): the image, and 1 − ∂image/∂d.
pub(super) fn equation_routine(name: &'static str, image: Vec<Id>, matrix: &[Vec<Id>], space: &Space) -> Routine {
    let image = Output::array("image", &space.extents, image);
    Routine::new(name, vec![image, Output::square("matrix", &space.extents, matrix)])
}

/// −weight·x, a sum term by term: the chain of dependent operations is shorter. So is that of a multiple of a sum of products, each of which takes
/// the factor in.
fn subtract(graph: &mut Graph, weight: Id, x: Id, terms: &mut Vec<Id>) {
    let (weight, x) = match multiple_of_products(graph, x) {
        Some((factors, sum)) => (graph.product(&[&[weight], &factors[..]].concat()), sum),
        None => (weight, x),
    };
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

/// What parameters alone decide, and the sum of products that it multiplies.
fn multiple_of_products(graph: &Graph, x: Id) -> Option<(Vec<Id>, Id)> {
    let Node::Product(factors) = graph.node(x) else { return None };
    let is_known = |id: &Id| !graph.reads(*id).moves();
    let (known, others): (Vec<Id>, Vec<Id>) = factors.iter().copied().partition(is_known);
    let [sum] = others[..] else { return None };
    let Node::Linear(_, summands) = graph.node(sum) else { return None };
    let is_product = |(_, id): &(Number, Id)| matches!(graph.node(*id), Node::Product(_));
    summands.iter().all(is_product).then_some((known, sum))
}

/// h ∂T/∂p at the mean of two momenta, as a function of what stands for their sum: the half of it is a part of what is known before.
fn drift(graph: &mut Graph, velocity: &[Id]) -> Vec<Id> {
    let h = graph.symbol(Symbol::StepLength);
    let mut mean = Substitution::new(|graph: &mut Graph, symbol| match symbol {
        Symbol::Momentum(i) => {
            let sum = graph.symbol(Symbol::MomentumIncrement(i));
            Some(graph.scale(Number::HALF, sum))
        }
        _ => None,
    });
    let mut scaled = |velocity: &Id| {
        let velocity = mean.apply(graph, *velocity);
        graph.mul(h, velocity)
    };
    velocity.iter().map(&mut scaled).collect()
}

type Derive = fn(&mut Graph, Id, u32) -> Equation;

/// The methods of contact systems whose steps are solved.
const METHODS: [(&str, Derive); 2] =
    [("ContactMidpoint", contact::midpoint), ("ContactDiscreteGradient", contact::discrete)];

/// The equation of each method for contact systems.
pub(super) fn steps(graph: &mut Graph, energy: Id, positions: &[usize]) -> Vec<(&'static str, StepKernel)> {
    let degrees = positions.iter().product::<usize>() as u32;
    let step = |(method, derive): (_, Derive)| {
        let equation = derive(graph, energy, degrees);
        (method, step(graph, equation, positions))
    };
    METHODS.into_iter().map(step).collect()
}

/// The field at a stage of collocation: without s where ∂H/∂s reads time alone, and positions and momenta do not read s.
pub(super) fn stages(graph: &mut Graph, energy: Id, gradient: &Gradient, positions: &[usize]) -> StageKernel {
    let degrees = gradient.q.len() as u32;
    let mut moved: Vec<Symbol> = (0..degrees).map(Symbol::Position).chain((0..degrees).map(Symbol::Momentum)).collect();
    let mut rates = gradient.p.clone();
    rates.extend(gradient.q.iter().map(|slope| graph.neg(*slope)));
    let mut terms = vec![graph.neg(energy)];
    for (i, velocity) in (0..degrees).zip(&gradient.p) {
        let p = graph.symbol(Symbol::Momentum(i));
        terms.push(graph.mul(p, *velocity));
    }
    let action = graph.sum(&terms);
    if analyze::acts_back(graph, gradient.s, rates.iter().copied()) {
        moved.push(Symbol::Action);
        rates.push(action);
    }
    let moved = Space::of_unknowns(moved, positions);
    let mut by_moved = diff::jacobian(graph, &[&rates[..], &[gradient.s]].concat(), &moved.symbols);
    let decay_by = by_moved.pop().unwrap_or_default();
    let stage = Routine::new(
        "stage",
        vec![
            Output::array("f", &moved.extents, rates),
            Output::number("decay", gradient.s),
            Output::square("f_by", &moved.extents, &by_moved),
            Output::array("decay_by", &moved.extents, decay_by),
        ],
    );
    let decay = Routine::number("decay", gradient.s).reading("x", &moved);
    let routines = vec![stage.reading("x", &moved), decay, Routine::number("action", action)];
    StageKernel { moved, kernel: Kernel::new(Levels::Prepared, routines) }
}

/// Φ and 1 − ∂Φ/∂d, and the increments of a solution.
fn step(graph: &mut Graph, Equation { field, end }: Equation, positions: &[usize]) -> StepKernel {
    let one = graph.integer(1);
    let degrees = positions.iter().product::<usize>() as u32;
    let indices = 0..degrees;
    let start: Vec<Symbol> = indices.clone().map(Symbol::Position).chain(indices.map(Symbol::Momentum)).collect();
    let start = Space::of_unknowns([start, vec![Symbol::Action]].concat(), positions);
    let unknowns = Space::of_unknowns(field.unknowns.clone(), positions);
    let Scaled { image, matrix } = scaled(graph, &field, one);
    let image = Output::array("f", &unknowns.extents, image);
    let image = Routine::new("image", vec![image, Output::square("matrix", &unknowns.extents, &matrix)]);
    let routines = vec![image.reading("d", &unknowns), Routine::row("end", end).reading("d", &unknowns)];
    let start = Some(Argument { name: "x", space: start });
    StepKernel { unknowns, kernel: Kernel { start, ..Kernel::new(Levels::Iterated, routines) } }
}

/// The equation d = Φ(d) of a step.
pub(super) struct Scaled {
    /// Φ.
    pub(super) image: Vec<Id>,
    /// 1 − ∂Φ/∂d.
    pub(super) matrix: Vec<Vec<Id>>,
}

/// Φ = scale·f and 1 − ∂Φ/∂d.
pub(super) fn scaled(graph: &mut Graph, field: &Field, scale: Id) -> Scaled {
    let (zero, one) = (graph.zero(), graph.integer(1));
    let image: Vec<Id> = field.f.iter().map(|f| graph.mul(scale, *f)).collect();
    let mut matrix = vec![];
    for (i, row) in field.jacobian.iter().enumerate() {
        let mut entries = vec![];
        for (j, entry) in row.iter().enumerate() {
            let entry = graph.mul(scale, *entry);
            entries.push(graph.sub(if i == j { one } else { zero }, entry));
        }
        matrix.push(entries);
    }
    Scaled { image, matrix }
}
