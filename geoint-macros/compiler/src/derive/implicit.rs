//! The equations of implicit methods.

use super::system::{Collocation, FieldKernels, StageKernel, StepKernel};
use crate::analyze::{self, Structure};
use crate::diff::contact::{self, Equation};
use crate::diff::equations;
use crate::diff::field::{self, Field, SecondOrder};
use crate::diff::{self, Gradient};
use crate::ir::substitute::Substitution;
use crate::ir::{AffineForms, Graph, Id, Node, Number, Ratio, Symbol};
use crate::schedule::{Argument, Kernel, Levels, Output, Routine, Space, phase};

/// The largest number of unknowns with a kernel of Newton's iteration. With more unknowns the runtime prefers the fixed point, because an elimination
/// costs more than the evaluations that it saves. For six bodies (18 unknowns) a step with the fixed point takes a third to a tenth of the time.
///
/// The runtime reads this number, so that it uses the kernel exactly if it was emitted.
pub(crate) const MOST_UNKNOWNS: usize = 12;

/// Derives the right-hand sides of collocation and of discrete gradients.
pub(super) fn fields(graph: &mut Graph, gradient: &Gradient, structure: &Structure, degrees: u32) -> Fields {
    let field = field::field(graph, gradient, structure, degrees);
    let discrete = field::discrete(graph, structure, degrees);
    let second_order = field::second_order(graph, gradient, structure, degrees);
    Fields { field, discrete, second_order }
}

/// The right-hand sides of implicit methods of a canonical system.
pub(super) struct Fields {
    /// With derivatives at a point.
    pub(super) field: Field,
    /// With divided differences between two points.
    discrete: Field,
    /// The part of T, if the equation is of second order.
    second_order: Option<SecondOrder>,
}

impl Fields {
    /// Creates the kernels of collocation and of discrete gradients.
    pub(super) fn kernels(self, graph: &mut Graph, structure: &Structure, positions: &[usize]) -> FieldKernels {
        let Fields { field, discrete, second_order } = self;
        let [coordinates, increments] =
            [&field, &discrete].map(|field| Space::of_unknowns(field.unknowns.clone(), positions));
        let mut stages = vec![field_routine("field", &field, &coordinates).reading("y", &coordinates)];
        let mut steps = vec![field_routine("slope", &discrete, &increments).reading("d", &increments)];
        if let Some(found) = &second_order {
            if field.unknowns.len() <= MOST_UNKNOWNS {
                steps.push(equation(graph, &discrete, found, &increments).reading("d", &increments));
            }
            let degrees = found.velocity.len() as u32;
            let [momenta, sums] = [Symbol::Momentum, Symbol::MomentumIncrement].map(|symbol: fn(u32) -> Symbol| {
                Space { symbols: (0..degrees).map(symbol).collect(), extents: positions.to_vec() }
            });
            let vector = |name, nodes| Routine::array(name, name, positions, nodes);
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
            forward: None,
            canonical: None,
            fourth: None,
            momenta: momenta(graph, structure, positions),
            coordinates,
            increments,
        }
    }
}

/// Creates the routine of the gradients of the momenta that steps keep in addition to H. Methods keep momenta that are single coordinates anyway.
fn momenta(graph: &mut Graph, structure: &Structure, positions: &[usize]) -> Routine {
    let degrees = positions.iter().product::<usize>() as u32;
    let kept = if structure.conservative() { &structure.momenta[..] } else { &[] };
    let mut slopes = vec![];
    for momentum in kept {
        let gradient = diff::gradient(graph, momentum.value, degrees);
        slopes.extend([gradient.q, gradient.p].concat());
    }
    let extents = [&[kept.len()], &phase(positions)[..]].concat();
    Routine::array("momenta", "slopes", &extents, slopes)
}

/// Creates the routine of f and its derivative.
pub(super) fn field_routine(name: &'static str, field: &Field, space: &Space) -> Routine {
    let f = Output::array("f", &space.extents, field.f.clone());
    Routine::new(name, vec![f, Output::square("jacobian", &space.extents, &field.jacobian)])
}

/// Creates the kernel of a step that starts at `y`.
pub(super) fn iterated(routines: Vec<Routine>, start: &Space) -> Kernel {
    let start = Some(Argument { name: "y", space: start.clone() });
    Kernel { start, ..Kernel::new(Levels::Iterated, routines) }
}

/// Derives the equation of Newton's iteration for a quadratic T: h·f̄, and 1 − h·(∂f̄/∂d)·(∂d/∂impulse) with d = h·M⁻¹(p + impulse/2). Factors that
/// are known before the step are multiplied first.
///
/// For other systems the runtime composes this matrix, because a kernel would make compilation a quarter longer.
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

/// Creates the routine of an equation d = image(d): the image, and 1 − ∂image/∂d.
pub(super) fn equation_routine(name: &'static str, image: Vec<Id>, matrix: &[Vec<Id>], space: &Space) -> Routine {
    let image = Output::array("image", &space.extents, image);
    Routine::new(name, vec![image, Output::square("matrix", &space.extents, matrix)])
}

/// Adds −weight·x to the terms. A sum is multiplied term by term, which makes the chain of dependent operations shorter. A known factor of a sum of
/// products is moved into the products for the same reason.
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

/// Splits a product into factors that read parameters only, and one sum of products. Returns `None` if it has another form.
fn multiple_of_products(graph: &Graph, x: Id) -> Option<(Vec<Id>, Id)> {
    let Node::Product(factors) = graph.node(x) else { return None };
    let is_known = |id: &Id| !graph.reads(*id).moves();
    let (known, others): (Vec<Id>, Vec<Id>) = factors.iter().copied().partition(is_known);
    let [sum] = others[..] else { return None };
    let Node::Linear(_, summands) = graph.node(sum) else { return None };
    let is_product = |(_, id): &(Number, Id)| matches!(graph.node(*id), Node::Product(_));
    summands.iter().all(is_product).then_some((known, sum))
}

/// Returns h ∂T/∂p at the mean of two momenta, as a function of their sum. The factor ½ is then prepared with h.
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

/// Derives the equation of each implicit method for contact systems.
pub(super) fn steps(
    graph: &mut Graph,
    energy: Id,
    degrees: u32,
    positions: &[usize],
) -> Vec<(&'static str, StepKernel)> {
    let midpoint = contact::midpoint(graph, energy, degrees);
    let midpoint = step(graph, midpoint, degrees, positions);
    let discrete = contact::discrete(graph, energy, degrees);
    let discrete = step(graph, discrete, degrees, positions);
    vec![("ContactMidpoint", midpoint), ("ContactDiscreteGradient", discrete)]
}

/// Derives the field at a stage of collocation of a contact system, without the friction −p ∂H/∂s, which the runtime adds. The action is no unknown if
/// ∂H/∂s reads time alone, and the rates of positions and momenta do not read s.
pub(super) fn stages(graph: &mut Graph, energy: Id, gradient: &Gradient, positions: &[usize]) -> StageKernel {
    let degrees = gradient.q.len() as u32;
    let mut moved: Vec<Symbol> = (0..degrees).map(Symbol::Position).chain((0..degrees).map(Symbol::Momentum)).collect();
    let mut rates = gradient.p.clone();
    rates.extend(gradient.q.iter().map(|slope| graph.neg(*slope)));
    let mut terms = vec![graph.neg(energy)];
    for (p, velocity) in equations::momenta(graph, gradient).into_iter().zip(&gradient.p) {
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

/// Creates the kernel of a step: Φ with 1 − ∂Φ/∂d, and the increments of a solution.
fn step(graph: &mut Graph, Equation { field, end }: Equation, degrees: u32, positions: &[usize]) -> StepKernel {
    let one = graph.integer(1);
    let start = (0..degrees).map(Symbol::Position).chain((0..degrees).map(Symbol::Momentum)).chain([Symbol::Action]);
    let start = Space::of_unknowns(start.collect(), positions);
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

/// Returns Φ = scale·f and 1 − ∂Φ/∂d.
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
