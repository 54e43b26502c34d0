//! Mean velocities of steps from x to x + d that keep functions of x, of order 2 and of order 4, for every field.
//!
//! A step x + h·v keeps I if ḡ·v = 0, where ḡ is the discrete gradient of I between both ends. With the ḡ of all integrals as columns of G, the
//! mean velocity is v = F − G(GᵀG)⁻¹GᵀF. The exact mean velocity is orthogonal to every ḡ, so the projection keeps the accuracy of F:
//!
//! order 2: F = f(m) at the middle m,
//! order 4: F = (f(x₀) + 4 f(c) + f(x₁))/6 with c = m + h/8 (f(x₀) − f(x₁)).
//!
//! In general Gᵀv = ρ. If I reads time, ρ is the negative divided difference of I in time. If I changes by b·∇I, ρ is the mean of b·∇I.

use super::equations;
use super::field::Field;
use super::forward::jacobian;
use super::gradient::{DiscreteGradient, discrete_gradient, discrete_gradient_with_time, gradient};
use super::slope::{coordinate_at_end, coordinate_in_middle};
use crate::ir::substitute::Substitution;
use crate::ir::{Function, Graph, Id, Node, Number, Ratio, Symbol};

/// A function I(x, t) with dI/dt = b·∇I along a field, or dI/dt = 0 if `but` is absent. Users state b by the option `but = b`.
#[derive(Clone, Debug)]
pub(crate) struct Conserved {
    pub(crate) value: Id,
    /// The vector b.
    pub(crate) but: Option<Vec<Id>>,
}

/// Order of accuracy of a mean velocity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Order {
    Two,
    Four,
}

/// Builds the mean velocity and its derivative by the increment.
pub(crate) fn mean_velocity(graph: &mut Graph, f: &[Id], kept: &[Conserved], order: Order) -> Field {
    let mut points = Points::new(graph, f, order);
    let unknowns = increments(f.len());
    let velocity = points.mean(graph, f);
    let slopes: Vec<Vec<Id>> = jacobian(graph, &velocity, &unknowns);
    let mut column = |conserved: &Conserved| Column::new(graph, conserved, order, &mut points, &unknowns);
    let columns: Vec<Column> = kept.iter().map(&mut column).collect();
    let projector = Projector::new(graph, columns);
    let rates: Vec<Id> = projector.columns.iter().map(|column| column.rate).collect();
    let Projection { vector: f, weights } = projector.apply(graph, &velocity, &rates);
    let jacobian = projector.derivative(graph, &slopes, &f, &weights);
    Field { unknowns, f, jacobian }
}

/// Returns the symbols of the increments of x.
pub(super) fn increments(n: usize) -> Vec<Symbol> {
    (0..n as u32).map(Symbol::PositionIncrement).collect()
}

/// The points of a step at which f is evaluated, each with its weight.
struct Points(Vec<(Number, Substitution<Replace>)>);

type Replace = Box<dyn Fn(&mut Graph, Symbol) -> Option<Id>>;

impl Points {
    fn new(graph: &mut Graph, f: &[Id], order: Order) -> Points {
        if order == Order::Two {
            return Points(vec![(Number::ONE, Substitution::new(Box::new(coordinate_in_middle)))]);
        }
        let h = graph.symbol(Symbol::StepLength);
        let [before, after] = [Symbol::StepStart, Symbol::StepEnd].map(|symbol| graph.symbol(symbol));
        let at_start: Replace = Box::new(move |_, symbol| (symbol == Symbol::Time).then_some(before));
        let at_end: Replace =
            Box::new(
                move |graph, symbol| {
                    if symbol == Symbol::Time { Some(after) } else { coordinate_at_end(graph, symbol) }
                },
            );
        let (mut start, mut end) = (Substitution::new(at_start), Substitution::new(at_end));
        let eighth = graph.scale(Number::Exact(Ratio { numerator: 1, denominator: 8 }), h);
        let mut inner = vec![];
        for (i, f) in (0..).zip(f) {
            let (before, after) = (start.apply(graph, *f), end.apply(graph, *f));
            let shift = graph.build(eighth * (before - after));
            inner.extend(coordinate_in_middle(graph, Symbol::Position(i)).map(|middle| graph.add(middle, shift)));
        }
        let at_inner: Replace = Box::new(move |_, symbol| match symbol {
            Symbol::Position(i) => inner.get(i as usize).copied(),
            _ => None,
        });
        let outer_weight = Number::Exact(Ratio { numerator: 1, denominator: 6 });
        let inner_weight = Number::Exact(Ratio { numerator: 2, denominator: 3 });
        Points(vec![(outer_weight, start), (inner_weight, Substitution::new(at_inner)), (outer_weight, end)])
    }

    /// The weighted mean of each node over all points.
    fn mean(&mut self, graph: &mut Graph, nodes: &[Id]) -> Vec<Id> {
        let mut means = vec![];
        for node in nodes {
            let mut terms = vec![];
            for (weight, at) in &mut self.0 {
                let value = at.apply(graph, *node);
                terms.push(graph.scale(*weight, value));
            }
            means.push(graph.sum(&terms));
        }
        means
    }
}

/// A column ḡ of G, its entry of ρ, and the derivatives of both by the unknowns.
struct Column {
    /// Σ |ḡᵢ|. The fields `slope` and `rate` are divided by it, so that no square overflows or vanishes. The derivatives are not.
    size: Id,
    slope: Vec<Id>,
    rate: Id,
    jacobian: Vec<Vec<Id>>,
    rate_jacobian: Vec<Id>,
}

impl Column {
    fn new(graph: &mut Graph, kept: &Conserved, order: Order, points: &mut Points, unknowns: &[Symbol]) -> Column {
        let n = unknowns.len() as u32;
        let DiscreteGradient { by_x: slope, by_t } = discrete_gradient_with_time(graph, kept.value, n);
        let mut rate = graph.neg(by_t);
        if let Some(b) = &kept.but {
            // Order 2 takes ḡ·b with b in the middle, as in the energy balance of dissipative systems. Order 4 takes the mean of b·∇I.
            let power = if order == Order::Two {
                let b = points.mean(graph, b);
                graph.dot(&slope, &b)
            } else {
                let gradient = gradient(graph, kept.value, n).q;
                let power = graph.dot(&gradient, b);
                points.mean(graph, &[power])[0]
            };
            rate = graph.add(rate, power);
        }
        let slopes = jacobian(graph, &slope, unknowns);
        let rates = jacobian(graph, &[rate], unknowns).concat();
        let sizes: Vec<Id> = slope.iter().map(|entry| graph.call(Function::Abs, &[*entry])).collect();
        let size = graph.sum(&sizes);
        let slope = slope.into_iter().map(|entry| scaled(graph, entry, size)).collect();
        Column { size, slope, rate: scaled(graph, rate, size), jacobian: slopes, rate_jacobian: rates }
    }
}

/// Orthogonal columns with the span of all columns, by Gram–Schmidt with two passes for each column. A column of which less than 10⁻¹⁴ is left
/// depends on earlier columns, and takes no part.
struct Projector {
    columns: Vec<Column>,
    orthogonal: Vec<Vec<Id>>,
    /// 1/|w|² of every orthogonal column w, or zero if the column takes no part.
    reciprocal: Vec<Id>,
    /// Column k equals orthogonal column k plus the sum of coefficient·(earlier orthogonal column).
    coefficients: Vec<Vec<Id>>,
}

/// A vector after projection, and the weights of the orthogonal columns that were subtracted.
struct Projection {
    vector: Vec<Id>,
    weights: Vec<Id>,
}

impl Projector {
    fn new(graph: &mut Graph, columns: Vec<Column>) -> Projector {
        let (mut orthogonal, mut reciprocal, mut coefficients) = (Vec::<Vec<Id>>::new(), Vec::<Id>::new(), vec![]);
        for column in &columns {
            let mut rest = column.slope.clone();
            let mut own = vec![graph.zero(); orthogonal.len()];
            for _ in 0..2 {
                for (b, w) in orthogonal.iter().enumerate() {
                    let product = graph.dot(&rest, w);
                    let coefficient = graph.mul(product, reciprocal[b]);
                    rest = minus(graph, &rest, coefficient, w);
                    own[b] = graph.add(own[b], coefficient);
                }
            }
            let [square, size] = [graph.dot(&rest, &rest), graph.dot(&column.slope, &column.slope)];
            reciprocal.push(graph.call(Function::RecipAbove, &[square, size]));
            orthogonal.push(rest);
            coefficients.push(own);
        }
        Projector { columns, orthogonal, reciprocal, coefficients }
    }

    /// Returns the closest vector whose products with the columns are `products`.
    fn apply(&self, graph: &mut Graph, vector: &[Id], products: &[Id]) -> Projection {
        let mut of_orthogonal: Vec<Id> = vec![];
        for (product, own) in products.iter().zip(&self.coefficients) {
            let taken = graph.dot(own, &of_orthogonal);
            of_orthogonal.push(graph.sub(*product, taken));
        }
        let (mut rest, mut weights) = (vector.to_vec(), vec![]);
        for (a, w) in self.orthogonal.iter().enumerate() {
            let product = graph.dot(vector, w);
            let weight = graph.build((product - of_orthogonal[a]) * self.reciprocal[a]);
            rest = minus(graph, &rest, weight, w);
            weights.push(weight);
        }
        Projection { vector: rest, weights }
    }

    /// The derivative of v = F − Gλ with Gᵀv = ρ, from the derivative of F. It solves dv + G dλ = dF − dG λ and Gᵀdv = dρ − dGᵀv.
    fn derivative(&self, graph: &mut Graph, slopes: &[Vec<Id>], v: &[Id], weights: &[Id]) -> Vec<Vec<Id>> {
        // Solve for λ from the weights of the orthogonal columns.
        let mut lambda = weights.to_vec();
        for a in (0..lambda.len()).rev() {
            for later in a + 1..lambda.len() {
                lambda[a] = graph.build(lambda[a] - self.coefficients[later][a] * lambda[later]);
            }
        }
        let n = v.len();
        let mut derivative = vec![vec![graph.zero(); n]; n];
        for j in 0..n {
            let of = |matrix: &[Vec<Id>]| matrix.iter().map(|row| row[j]).collect::<Vec<Id>>();
            let mut change = of(slopes);
            let mut products = vec![];
            for (column, lambda) in self.columns.iter().zip(&lambda) {
                let (moved, weight) = (of(&column.jacobian), scaled(graph, *lambda, column.size));
                change = minus(graph, &change, weight, &moved);
                let power = graph.dot(v, &moved);
                let excess = graph.sub(column.rate_jacobian[j], power);
                products.push(scaled(graph, excess, column.size));
            }
            for (row, entry) in derivative.iter_mut().zip(self.apply(graph, &change, &products).vector) {
                row[j] = entry;
            }
        }
        derivative
    }
}

/// number/size, as a call. A product would be taken apart when it is squared.
pub(super) fn scaled(graph: &mut Graph, number: Id, size: Id) -> Id {
    if graph.is_zero(number) { number } else { graph.call(Function::Scaled, &[number, size]) }
}

/// a − c·b.
fn minus(graph: &mut Graph, a: &[Id], c: Id, b: &[Id]) -> Vec<Id> {
    a.iter().zip(b).map(|(a, b)| graph.build(*a - c * *b)).collect()
}

/// The field S(m)·ḡ with the discrete gradient ḡ of H and the middle m of the step. It keeps H if S is skew-symmetric.
pub(crate) fn structured(graph: &mut Graph, energy: Id, matrix: &[Vec<Id>]) -> Field {
    let mut mean = Substitution::new(coordinate_in_middle);
    let matrix: Vec<Vec<Id>> =
        matrix.iter().map(|row| row.iter().map(|entry| mean.apply(graph, *entry)).collect()).collect();
    let gradient = discrete_gradient(graph, energy, matrix.len() as u32).q;
    let gradient = in_means(graph, &gradient);
    let rates = equations::structured(graph, &matrix, &gradient);
    let f: Vec<Id> = rates.into_iter().map(|rate| factored(graph, rate)).collect();
    Field::new(graph, increments(matrix.len()), f)
}

/// Rewrites slopes 2x + d of squares as 2(x + d/2). The entries of S read the mean x + d/2, too.
pub(super) fn in_means(graph: &mut Graph, slopes: &[Id]) -> Vec<Id> {
    let mut means = Substitution::new(|_: &mut Graph, _| None);
    for i in 0..slopes.len() as u32 {
        let [x, d] = [Symbol::Position(i), Symbol::PositionIncrement(i)].map(|symbol| graph.symbol(symbol));
        let slope = graph.sum(&[x, x, d]);
        if let Some(coordinate_in_middle) = coordinate_in_middle(graph, Symbol::Position(i)) {
            let twice = graph.scale(Number::Exact(Ratio::integer(2)), coordinate_in_middle);
            means.insert(slope, twice);
        }
    }
    slopes.iter().map(|slope| means.apply(graph, *slope)).collect()
}

/// Takes the common factors out of a sum. The remaining factors often depend on parameters only.
fn factored(graph: &mut Graph, sum: Id) -> Id {
    let Node::Linear(constant, terms) = graph.node(sum).clone() else { return sum };
    let all: Vec<Vec<(Id, Ratio)>> = terms.iter().map(|(_, term)| graph.factors(*term)).collect();
    let [first, others @ ..] = &all[..] else { return sum };
    let common: Vec<_> = first.iter().filter(|factor| others.iter().all(|other| other.contains(factor))).collect();
    if !constant.is_zero() || others.is_empty() || common.is_empty() {
        return sum;
    }
    let mut rests = vec![];
    for ((c, _), factors) in terms.iter().zip(&all) {
        let rest: Vec<_> = factors.iter().filter(|factor| !common.contains(factor)).collect();
        let rest = powers(graph, &rest);
        rests.push(graph.scale(*c, rest));
    }
    let (common, rest) = (powers(graph, &common), graph.sum(&rests));
    graph.mul(common, rest)
}

/// The product of powers.
fn powers(graph: &mut Graph, factors: &[&(Id, Ratio)]) -> Id {
    let powers: Vec<Id> = factors.iter().map(|(base, exponent)| graph.pow(*base, *exponent)).collect();
    graph.product(&powers)
}
