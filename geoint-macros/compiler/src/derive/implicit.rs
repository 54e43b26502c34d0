//! The equations of implicit methods.

use super::system::{FieldKernels, StageKernel, StepKernel};
use crate::analyze::{self, Structure};
use crate::diff::contact::{self, Equation};
use crate::diff::field::{self, Field, SecondOrder};
use crate::diff::{self, Gradient};
use crate::ir::substitute::Substitution;
use crate::ir::{AffineForms, Graph, Id, Node, Number, Ratio, Symbol};
use crate::schedule::{Kernel, Levels};

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
    pub(super) fn kernels(self, graph: &mut Graph, structure: &Structure, degrees: u32) -> FieldKernels<Kernel> {
        let Fields { field, discrete, second_order } = self;
        let folded = second_order.as_ref().filter(|_| field.unknowns.len() <= MOST_UNKNOWNS);
        let equation = folded.map_or_else(Vec::new, |second_order| equation(graph, &discrete, second_order));
        let velocity = second_order.as_ref().map_or(&[][..], |second_order| &second_order.velocity);
        let acceleration = second_order.as_ref().map_or(&[][..], |second_order| &second_order.acceleration);
        let drift = drift(graph, velocity);
        FieldKernels {
            second_order: second_order.is_some(),
            folded: folded.is_some(),
            linear: structure.linear(),
            mean_value: structure.mean_value,
            collocation: Kernel {
                levels: Levels::Prepared,
                routines: vec![roots(&field), velocity.to_vec(), acceleration.to_vec()],
            },
            discrete: Some(Kernel { levels: Levels::Iterated, routines: vec![roots(&discrete), equation, drift] }),
            nothing_kept: None,
            canonical: None,
            fourth: None,
            momenta: momenta(graph, structure, degrees),
            coordinates: field.unknowns,
            increments: discrete.unknowns,
        }
    }
}

/// The gradients of what is kept beside H, but for single coordinates, which are kept anyway.
fn momenta(graph: &mut Graph, structure: &Structure, degrees: u32) -> Kernel {
    let mut slopes = vec![];
    for momentum in structure.momenta.iter().filter(|_| structure.conservative()) {
        let gradient = diff::gradient(graph, momentum.value, degrees);
        slopes.extend([gradient.q, gradient.p].concat());
    }
    Kernel::new(Levels::One, slopes)
}

pub(super) fn roots(field: &Field) -> Vec<Id> {
    field.f.iter().chain(field.jacobian.iter().flatten()).copied().collect()
}

/// What Newton's iteration needs where T is quadratic: h·f̄, and 1 − h·(∂f̄/∂d)·(∂d/∂impulse) with d = h·M⁻¹(p + impulse/2).
/// What is known before the step is one factor.
///
/// Other systems are left to the runtime: the compiler would take a quarter longer.
fn equation(graph: &mut Graph, field: &Field, second_order: &SecondOrder) -> Vec<Id> {
    let (h, n) = (graph.symbol(Symbol::StepLength), field.unknowns.len());
    let mut roots = field.f.iter().map(|f| graph.mul(h, *f)).collect::<Vec<_>>();
    let square = graph.pow(h, Ratio::integer(2));
    let half = graph.scale(Number::HALF, square);
    let mut affine_forms = AffineForms::new(|symbol| field.unknowns.contains(&symbol));
    for (i, row) in field.jacobian.iter().enumerate() {
        for j in 0..n {
            let mut terms = vec![graph.integer((i == j).into())];
            for (slope, inverse_mass) in row.iter().zip(&second_order.inverse_mass) {
                let weight = graph.mul(half, inverse_mass[j]);
                subtract(graph, weight, *slope, &mut terms);
            }
            let entry = graph.sum(&terms);
            roots.push(affine_forms.shortened(graph, entry));
        }
    }
    roots
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
pub(super) fn steps(graph: &mut Graph, energy: Id, degrees: u32) -> Vec<(&'static str, StepKernel<Kernel>)> {
    let step = |(method, derive): (_, Derive)| {
        let equation = derive(graph, energy, degrees);
        (method, step(graph, equation))
    };
    METHODS.into_iter().map(step).collect()
}

/// The field at a stage of collocation: without s where ∂H/∂s reads time alone, and positions and momenta do not read s.
pub(super) fn stages(graph: &mut Graph, energy: Id, gradient: &Gradient) -> StageKernel<Kernel> {
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
    let varying = analyze::acts_back(graph, gradient.s, rates.iter().copied());
    if varying {
        moved.push(Symbol::Action);
        rates.push(action);
    }
    rates.push(gradient.s);
    let derivatives = diff::jacobian(graph, &rates, &moved).concat();
    let kernel = Kernel {
        levels: Levels::Prepared,
        routines: vec![[rates, derivatives].concat(), vec![gradient.s], vec![action]],
    };
    StageKernel { moved, kernel }
}

/// Φ and 1 − ∂Φ/∂d, and what a solution adds.
fn step(graph: &mut Graph, Equation { field, end }: Equation) -> StepKernel<Kernel> {
    let one = graph.integer(1);
    let image = image(graph, &field, one);
    let kernel = Kernel { levels: Levels::Iterated, routines: vec![image, end] };
    StepKernel { unknowns: field.unknowns, kernel }
}

/// Φ = scale·f and 1 − ∂Φ/∂d.
pub(super) fn image(graph: &mut Graph, field: &Field, scale: Id) -> Vec<Id> {
    let (zero, one) = (graph.zero(), graph.integer(1));
    let mut image: Vec<Id> = field.f.iter().map(|f| graph.mul(scale, *f)).collect();
    for (i, row) in field.jacobian.iter().enumerate() {
        for (j, entry) in row.iter().enumerate() {
            let entry = graph.mul(scale, *entry);
            image.push(graph.sub(if i == j { one } else { zero }, entry));
        }
    }
    image
}
