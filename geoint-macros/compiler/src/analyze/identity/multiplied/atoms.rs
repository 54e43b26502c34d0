//! What is an unknown of its own while a node is multiplied out.

use super::normal::{Atom, Normal};
use crate::ir::{Function, Graph, Id, Number, Ratio};

/// An unknown.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// A symbol.
    Symbol(Id),
    /// The magnitude of a number that is not exact, as bits; or a number of which a root is taken.
    Float(u64),
    Ratio(Ratio),
    /// A sum, to a negative or broken power.
    Sum(Normal),
    /// A high power of a sum, which would be too long.
    Power(Normal, i64),
    /// The cube root of a sum, of either sign.
    Cbrt(Normal),
    /// `exp` or `exp2` of a monomial with coefficient one: its powers are those of a positive number.
    Exponential(Function, Normal),
    /// Any other function.
    Call(Function, Vec<Normal>),
}

/// All unknowns, each once.
#[derive(Clone, Debug, Default)]
pub(super) struct Atoms(Vec<Kind>);

impl Atoms {
    pub(super) fn of(&mut self, kind: Kind) -> Atom {
        let known = self.0.iter().position(|other| *other == kind);
        known.unwrap_or_else(|| {
            self.0.push(kind);
            self.0.len() - 1
        })
    }

    pub(super) fn kind(&self, atom: Atom) -> &Kind {
        &self.0[atom]
    }

    /// Whether an atom is positive wherever it is defined.
    pub(super) fn is_positive(&self, atom: Atom) -> bool {
        matches!(self.kind(atom), Kind::Exponential(..) | Kind::Float(_) | Kind::Ratio(_))
    }

    /// From which power on there is another way to write an atom, without roots and with fewer cosines.
    pub(super) fn reducible_from(&self, atom: Atom) -> Option<i128> {
        match self.kind(atom) {
            Kind::Sum(_) | Kind::Ratio(_) => Some(1),
            Kind::Call(Function::Cos, _) => Some(2),
            Kind::Cbrt(_) => Some(3),
            _ => None,
        }
    }
}

/// A normal form with the atoms that it is made of, to be written as a node.
pub(super) struct Formula {
    pub(super) atoms: Atoms,
    pub(super) normal: Normal,
}

impl Formula {
    /// The sum as a node.
    pub(super) fn build(&self, graph: &mut Graph) -> Id {
        self.node(graph, &self.normal)
    }

    fn node(&self, graph: &mut Graph, normal: &Normal) -> Id {
        let mut sum = graph.zero();
        for (powers, coefficient) in normal.terms() {
            let mut product = graph.integer(1);
            for (atom, exponent) in powers {
                let base = self.atom(graph, *atom);
                let power = if exponent.denominator <= 2 {
                    graph.pow(base, *exponent)
                } else {
                    let exponent = graph.number(Number::Exact(*exponent));
                    graph.call(Function::Powf, &[base, exponent])
                };
                product = graph.mul(product, power);
            }
            let term = graph.scale(Number::Exact(coefficient), product);
            sum = graph.add(sum, term);
        }
        sum
    }

    fn atom(&self, graph: &mut Graph, atom: Atom) -> Id {
        match self.atoms.kind(atom) {
            Kind::Symbol(id) => *id,
            Kind::Float(bits) => graph.number(Number::Float(*bits)),
            Kind::Ratio(ratio) => graph.number(Number::Exact(*ratio)),
            Kind::Sum(base) => self.node(graph, base),
            Kind::Power(base, exponent) => {
                let base = self.node(graph, base);
                graph.pow(base, Ratio::integer((*exponent).into()))
            }
            Kind::Cbrt(base) => self.call(graph, Function::Cbrt, std::slice::from_ref(base)),
            Kind::Exponential(function, exponent) => self.call(graph, *function, std::slice::from_ref(exponent)),
            Kind::Call(function, args) => self.call(graph, *function, args),
        }
    }

    fn call(&self, graph: &mut Graph, function: Function, args: &[Normal]) -> Id {
        let args: Vec<Id> = args.iter().map(|arg| self.node(graph, arg)).collect();
        graph.call(function, &args)
    }
}
