//! Upper bounds of the degrees of nodes, as quotients of polynomials in the unknowns of a point.
//!
//! The denominator of a sum is the product of all denominators, and no terms are assumed to cancel.

use super::super::is_exponential;
use super::choices::MOST;
use super::evaluate::Plan;
use crate::ir::{Function, Id, Node, Number, Ratio};

/// The degrees of a quotient of polynomials.
#[derive(Clone, Copy, Debug, Default)]
struct Degree {
    /// Degree of the numerator.
    above: f64,
    /// Degree of the denominator.
    below: f64,
}

impl Degree {
    fn times(self, other: Degree) -> Degree {
        Degree { above: self.above + other.above, below: self.below + other.below }
    }

    fn plus(self, other: Degree) -> Degree {
        let above = (self.above + other.below).max(other.above + self.below);
        Degree { above, below: self.below + other.below }
    }

    /// An upper bound for both of two quotients.
    fn either(self, other: Degree) -> Degree {
        Degree { above: self.above.max(other.above), below: self.below.max(other.below) }
    }

    fn power(self, exponent: f64) -> Degree {
        let size = exponent.abs();
        let (above, below) = if exponent < 0.0 { (self.below, self.above) } else { (self.above, self.below) };
        Degree { above: size * above, below: size * below }
    }

    fn total(self) -> f64 {
        self.above + self.below
    }
}

/// The degree of a power of an unknown.
fn unknown(power: f64) -> Degree {
    Degree { above: power, below: 0.0 }
}

impl Plan<'_> {
    /// Returns whether roots of expressions other than symbols are taken.
    pub(super) fn has_roots(&self) -> bool {
        let open = |base: Id, exponent| self.arguments.power_of_root(base, exponent).is_none();
        self.order.iter().any(|id| match self.graph.node(*id) {
            Node::Power(base, exponent) => open(*base, *exponent) && !exponent.is_integer(),
            Node::Call(Function::Root, args) => open(args[0], Ratio::HALF),
            Node::Call(Function::Powf, args) => match self.graph.as_number(args[1]) {
                Some(Number::Exact(exponent)) => exponent.denominator == 2 && open(args[0], exponent),
                _ => false,
            },
            Node::Call(function, _) => *function == Function::Hypot,
            _ => false,
        })
    }

    /// An upper bound of the degree of a polynomial that vanishes at every misleading point. At a misleading point a node that is not zero
    /// vanishes for some signs of square roots, or two different arguments of a function have equal values. The bound may be infinite.
    pub(super) fn degree(&self, nodes: &[Id]) -> f64 {
        let mut degrees = vec![Degree::default(); self.order.last().map_or(0, |last| last.index() + 1)];
        let (mut roots, mut functions, mut largest) = (0_i32, 0.0_f64, 0.0_f64);
        for id in &self.order {
            let of = |id: &Id| degrees[id.index()];
            let degree = match self.graph.node(*id) {
                Node::Symbol(_) => unknown(self.arguments.power_of_symbol(*id) as f64),
                Node::Number(Number::Float(_) | Number::Root(..)) => unknown(1.0),
                Node::Linear(_, terms) => {
                    terms.iter().fold(Degree::default(), |sum, (c, term)| {
                        // Rounded numbers are unknowns.
                        let c = unknown(if matches!(c, Number::Exact(_)) { 0.0 } else { 1.0 });
                        sum.plus(c.times(of(term)))
                    })
                }
                Node::Product(ids) => ids.iter().map(of).fold(Degree::default(), Degree::times),
                Node::Power(base, exponent) => self.power(*base, *exponent, of(base)),
                Node::Call(function, args) => {
                    let inside: Vec<Degree> = args.iter().map(of).collect();
                    functions += 1.0;
                    self.function(*function, args, &inside, &degrees)
                }
                Node::Select(_, first, second) => of(first).either(of(second)),
                // The degree of the difference, whose sign is asked for.
                Node::Compare(_, a, b) => of(a).plus(of(b)),
                _ => Degree::default(),
            };
            let is_root = match self.graph.node(*id) {
                Node::Power(_, exponent) => !exponent.is_integer(),
                Node::Call(function, _) => matches!(function, Function::Hypot | Function::Root | Function::Powf),
                _ => false,
            };
            if is_root {
                roots += 1;
                functions += 1.0;
            }
            largest = largest.max(degree.total());
            degrees[id.index()] = degree;
        }
        let own: f64 = nodes.iter().map(|id| degrees[id.index()].total()).sum();
        // The degrees of conjugates add up. The signs of further roots are not combined.
        2.0_f64.powi(roots.min(MOST as i32)) * (own + functions * functions * 4.0 * largest)
    }

    /// The degree of baseᵉ, where `inside` is the degree of the base.
    fn power(&self, base: Id, exponent: Ratio, inside: Degree) -> Degree {
        if let Some(k) = self.arguments.power_of_root(base, exponent) {
            return unknown(1.0).power(k as f64);
        }
        let root = match exponent.denominator {
            1 => inside,
            2 => Degree { above: (inside.total() / 2.0).ceil().max(1.0), below: inside.below },
            _ => unknown(1.0),
        };
        root.power(exponent.numerator as f64)
    }

    /// The degree of a function, where `inside` has the degrees of its arguments.
    fn function(&self, function: Function, args: &[Id], inside: &[Degree], degrees: &[Degree]) -> Degree {
        let exponent = |argument: Id| {
            let terms = self.arguments.terms(argument).iter().map(|term| {
                let size = term.coefficient.to_f64().abs();
                // e^(n ln x) is a power of x.
                let whole = term.factors.iter().map(|id| match self.graph.node(*id) {
                    Node::Call(Function::Ln, args) => degrees[args[0].index()].total(),
                    _ => 0.0,
                });
                size * (self.arguments.denominator as f64 + whole.sum::<f64>())
            });
            terms.sum::<f64>()
        };
        match function {
            function if is_exponential(function) => {
                let size = 2.0 * exponent(args[0]);
                Degree { above: size, below: size }
            }
            Function::Hypot => {
                let squares = inside.iter().fold(Degree::default(), |sum, x| sum.plus(x.power(2.0)));
                Degree { above: (squares.total() / 2.0).ceil(), below: squares.below }
            }
            Function::Root => self.power(args[0], Ratio::HALF, inside[0]),
            Function::RecipPositive => inside[0].power(-1.0),
            Function::Powf => match self.graph.as_number(args[1]) {
                Some(Number::Exact(exponent)) => self.power(args[0], exponent, inside[0]),
                _ => {
                    let size = exponent(args[1]) * (1.0 + inside[0].total());
                    Degree { above: size, below: size }
                }
            },
            // Logarithms of exponentials are their exponents.
            Function::Ln | Function::Ln1p | Function::Log2 | Function::Log10 => {
                let exponents = self.graph.factors(self.graph.coefficient(args[0]).1).into_iter();
                let inner = exponents.map(|(base, _)| match self.graph.node(base) {
                    Node::Call(Function::Exp, args) => degrees[args[0].index()],
                    _ => unknown(1.0),
                });
                inner.fold(unknown(2.0), Degree::plus).times(unknown(1.0))
            }
            Function::Cbrt => unknown(self.arguments.power_of_symbol(args[0]).max(1) as f64),
            _ => inside.iter().fold(unknown(1.0), |all, x| all.either(*x)),
        }
    }
}
