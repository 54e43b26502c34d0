//! Mean velocities of steps from x to x + d that keep functions of x: of order 2 and of order 4, for every field.
//!
//! A step x + h·v keeps I if ḡ·v = 0 for its discrete gradient ḡ between both ends. The mean velocity is
//! v = F − G(GᵀG)⁻¹GᵀF with the ḡ of all integrals in the columns of G. The exact mean velocity is orthogonal to all ḡ as well: the
//! projection leaves it alone, so that v is as accurate as F is,
//!
//! order 2: F = f(m) in the middle m,
//! order 4: F = (f(x₀) + 4 f(c) + f(x₁))/6 with c = m + h/8 (f(x₀) − f(x₁)).
//!
//! In general Gᵀv = ρ: an integral that reads time has −ρ for its divided difference in time, and one that changes by b·∇I has the
//! mean of that for ρ.

use super::field::{Field, middle};
use super::forward::jacobian;
use super::gradient::{discrete_gradient, discrete_gradient_and_rate, gradient};
use super::slope::coordinate_increment;
use crate::ir::substitute::Substitution;
use crate::ir::{Function, Graph, Id, Node, Number, Ratio, Symbol};

/// A function I(x, t) with dI/dt = b·∇I along a field, or 0.
#[derive(Clone, Debug)]
pub(crate) struct Conserved {
    pub(crate) value: Id,
    pub(crate) but: Option<Vec<Id>>,
}

/// How accurate a mean velocity is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Order {
    Two,
    Four,
}

/// The mean velocity, with its derivative by the increment.
pub(crate) fn mean_velocity(graph: &mut Graph, f: &[Id], kept: &[Conserved], order: Order) -> Field {
    let mut points = Points::new(graph, f, order);
    let unknowns: Vec<Symbol> = (0..f.len() as u32).map(Symbol::PositionIncrement).collect();
    let velocity = points.mean(graph, f);
    let slopes: Vec<Vec<Id>> = jacobian(graph, &velocity, &unknowns);
    let columns: Vec<Column> =
        kept.iter().map(|conserved| Column::new(graph, conserved, &mut points, &unknowns)).collect();
    let projector = Projector::new(graph, columns);
    let rates: Vec<Id> = projector.columns.iter().map(|column| column.rate).collect();
    let (f, weights) = projector.apply(graph, &velocity, &rates);
    let jacobian = projector.derivative(graph, &slopes, &f, &weights);
    Field { unknowns, f, jacobian }
}

/// The points of a step at which f is evaluated, each with its weight.
struct Points(Vec<(Number, Substitution<Replace>)>);

type Replace = Box<dyn Fn(&mut Graph, Symbol) -> Option<Id>>;

impl Points {
    fn new(graph: &mut Graph, f: &[Id], order: Order) -> Points {
        if order == Order::Two {
            return Points(vec![(Number::ONE, Substitution::new(Box::new(middle)))]);
        }
        let h = graph.symbol(Symbol::StepLength);
        let [before, after] = [Symbol::StepStart, Symbol::StepEnd].map(|symbol| graph.symbol(symbol));
        let at_start: Replace = Box::new(move |_, symbol| (symbol == Symbol::Time).then_some(before));
        let at_end: Replace = Box::new(move |graph, symbol| match symbol {
            Symbol::Time => Some(after),
            _ => {
                let increment = coordinate_increment(graph, symbol)?;
                let start = graph.symbol(symbol);
                Some(graph.add(start, increment))
            }
        });
        let (mut start, mut end) = (Substitution::new(at_start), Substitution::new(at_end));
        let eighth = graph.scale(Number::Exact(Ratio { numerator: 1, denominator: 8 }), h);
        let mut third = vec![];
        for (i, f) in (0..).zip(f) {
            let (before, after) = (start.apply(graph, *f), end.apply(graph, *f));
            let change = graph.sub(before, after);
            let shift = graph.mul(eighth, change);
            third.extend(middle(graph, Symbol::Position(i)).map(|middle| graph.add(middle, shift)));
        }
        let at_third: Replace = Box::new(move |_, symbol| match symbol {
            Symbol::Position(i) => third.get(i as usize).copied(),
            _ => None,
        });
        let [sixth, most] =
            [1, 4].map(|numerator| Number::Exact(Ratio::integer(numerator).mul(SIXTH).unwrap_or(SIXTH)));
        Points(vec![(sixth, start), (most, Substitution::new(at_third)), (sixth, end)])
    }

    /// The means of some nodes.
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

const SIXTH: Ratio = Ratio { numerator: 1, denominator: 6 };

/// A column of G, with what its product with the velocity is to be, and the derivatives of both.
struct Column {
    /// Of the entries of the slope. It is scaled with the rate, so that no square overflows or vanishes; the derivatives are not.
    size: Id,
    slope: Vec<Id>,
    rate: Id,
    jacobian: Vec<Vec<Id>>,
    rate_jacobian: Vec<Id>,
}

impl Column {
    fn new(graph: &mut Graph, kept: &Conserved, points: &mut Points, unknowns: &[Symbol]) -> Column {
        let n = unknowns.len() as u32;
        let (slope, in_time) = discrete_gradient_and_rate(graph, kept.value, n);
        let mut rate = graph.neg(in_time);
        if let Some(b) = &kept.but {
            // In the middle with the discrete gradient, so that the balance is that of dissipative systems; else the mean of what changes I.
            let power = if points.0.len() == 1 {
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
        let rates = jacobian(graph, &[rate], unknowns).remove(0);
        let sizes: Vec<Id> = slope.iter().map(|entry| graph.call(Function::Abs, &[*entry])).collect();
        let size = graph.sum(&sizes);
        let slope = slope.into_iter().map(|entry| scaled(graph, entry, size)).collect();
        Column { size, slope, rate: scaled(graph, rate, size), jacobian: slopes, rate_jacobian: rates }
    }
}

/// Orthogonal columns that span what all columns span: by Gram and Schmidt, each column twice. One of which less than 10⁻¹⁴ is left
/// depends on those before it, and takes no part.
struct Projector {
    columns: Vec<Column>,
    orthogonal: Vec<Vec<Id>>,
    /// 1/|w|² of each; zero if it takes no part.
    reciprocal: Vec<Id>,
    /// column = orthogonal + Σ coefficient·(orthogonal before it).
    coefficients: Vec<Vec<Id>>,
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

    /// What is next to a vector and has given products with the columns; and the weights of orthogonal columns that were taken off.
    fn apply(&self, graph: &mut Graph, vector: &[Id], products: &[Id]) -> (Vec<Id>, Vec<Id>) {
        let mut of_orthogonal: Vec<Id> = vec![];
        for (product, own) in products.iter().zip(&self.coefficients) {
            let taken = graph.dot(own, &of_orthogonal);
            of_orthogonal.push(graph.sub(*product, taken));
        }
        let (mut rest, mut weights) = (vector.to_vec(), vec![]);
        for (a, w) in self.orthogonal.iter().enumerate() {
            let product = graph.dot(vector, w);
            let excess = graph.sub(product, of_orthogonal[a]);
            let weight = graph.mul(excess, self.reciprocal[a]);
            rest = minus(graph, &rest, weight, w);
            weights.push(weight);
        }
        (rest, weights)
    }

    /// The derivative of v = F − Gλ with Gᵀv = ρ, from that of F: of Gᵀdv = dρ − dGᵀv, and dv + G dλ = dF − dG λ.
    fn derivative(&self, graph: &mut Graph, slopes: &[Vec<Id>], v: &[Id], weights: &[Id]) -> Vec<Vec<Id>> {
        // λ from the weights of orthogonal columns.
        let mut lambda = weights.to_vec();
        for a in (0..lambda.len()).rev() {
            for later in a + 1..lambda.len() {
                let product = graph.mul(self.coefficients[later][a], lambda[later]);
                lambda[a] = graph.sub(lambda[a], product);
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
            let (column, _) = self.apply(graph, &change, &products);
            for (i, entry) in column.into_iter().enumerate() {
                derivative[i][j] = entry;
            }
        }
        derivative
    }
}

/// A number in the units of a column of this size. No product: that would be taken apart where it is squared.
fn scaled(graph: &mut Graph, number: Id, size: Id) -> Id {
    if graph.is_zero(number) { number } else { graph.call(Function::Scaled, &[number, size]) }
}

/// a − c·b.
fn minus(graph: &mut Graph, a: &[Id], c: Id, b: &[Id]) -> Vec<Id> {
    let mut difference = |(a, b): (&Id, &Id)| {
        let product = graph.mul(c, *b);
        graph.sub(*a, product)
    };
    a.iter().zip(b).map(&mut difference).collect()
}

/// S(m)·ḡ with the discrete gradient ḡ of H: keeps H for skew S.
pub(crate) fn structured(graph: &mut Graph, energy: Id, matrix: &[Vec<Id>]) -> Field {
    let n = matrix.len() as u32;
    let mut mean = Substitution::new(middle);
    let matrix: Vec<Vec<Id>> =
        matrix.iter().map(|row| row.iter().map(|entry| mean.apply(graph, *entry)).collect()).collect();
    let gradient = discrete_gradient(graph, energy, n).q;
    let gradient = in_means(graph, &gradient);
    let f: Vec<Id> = times(graph, &matrix, &gradient).into_iter().map(|f| factored(graph, f)).collect();
    let unknowns: Vec<Symbol> = (0..n).map(Symbol::PositionIncrement).collect();
    let jacobian = jacobian(graph, &f, &unknowns);
    Field { unknowns, f, jacobian }
}

/// Slopes of squares, 2x + d, as multiples of the mean x + d/2, at which S is taken as well.
fn in_means(graph: &mut Graph, slopes: &[Id]) -> Vec<Id> {
    let mut means = Substitution::new(|_: &mut Graph, _| None);
    for i in 0..slopes.len() as u32 {
        let [x, d] = [Symbol::Position(i), Symbol::PositionIncrement(i)].map(|symbol| graph.symbol(symbol));
        let slope = graph.sum(&[x, x, d]);
        if let Some(middle) = middle(graph, Symbol::Position(i)) {
            let twice = graph.scale(Number::Exact(Ratio::integer(2)), middle);
            means.insert(slope, twice);
        }
    }
    slopes.iter().map(|slope| means.apply(graph, *slope)).collect()
}

/// A sum with the factors that all its terms have taken out: the rest of them often depends on parameters only.
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

fn powers(graph: &mut Graph, factors: &[&(Id, Ratio)]) -> Id {
    let powers: Vec<Id> = factors.iter().map(|(base, exponent)| graph.pow(*base, *exponent)).collect();
    graph.product(&powers)
}

/// A matrix times a vector.
pub(crate) fn times(graph: &mut Graph, matrix: &[Vec<Id>], vector: &[Id]) -> Vec<Id> {
    matrix.iter().map(|row| graph.dot(row, vector)).collect()
}
