//! Atoms: the subexpressions that count as independent unknowns in a normal form.

use super::normal::{Atom, Normal};
use crate::ir::{Function, Graph, Id, Number, Ratio};

/// The subexpression of an atom.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Symbol(Id),
    /// The bits of the magnitude of a number that is not exact.
    Float(u64),
    /// A positive number under a root.
    Ratio(Ratio),
    /// The base of a negative power or a root.
    Sum(Normal),
    /// A power of a sum with too many terms to be multiplied out.
    Power(Normal, i64),
    /// The cube root of a sum of either sign.
    Cbrt(Normal),
    /// `exp` or `exp2` of a monomial with coefficient 1. An exponential with another coefficient is a power of this atom.
    Exponential(Function, Normal),
    Call(Function, Vec<Normal>),
}

/// Table of the atoms of normal forms, without repetition.
#[derive(Clone, Debug, Default)]
pub(super) struct Atoms(Vec<Kind>);

impl Atoms {
    /// Returns the atom of a subexpression. Adds it to the table if necessary.
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

    /// Returns whether an atom is positive wherever it is defined.
    pub(super) fn is_positive(&self, atom: Atom) -> bool {
        matches!(self.kind(atom), Kind::Exponential(..) | Kind::Float(_) | Kind::Ratio(_))
    }

    /// The lowest exponent from which on a power of the atom is rewritten: (√u)² = u, cos² = 1 − sin², (∛u)³ = u.
    pub(super) fn reducible_from(&self, atom: Atom) -> Option<i128> {
        match self.kind(atom) {
            Kind::Sum(_) | Kind::Ratio(_) => Some(1),
            Kind::Call(Function::Cos, _) => Some(2),
            Kind::Cbrt(_) => Some(3),
            _ => None,
        }
    }

    /// Returns whether a sum with at least one term is certainly not zero everywhere: it is one term, or reads symbols and numbers only.
    pub(super) fn is_certain(&self, normal: &Normal) -> bool {
        let mut factors = normal.monomials().flatten();
        normal.len() == 1 || factors.all(|(atom, _)| matches!(self.kind(*atom), Kind::Symbol(_)))
    }

    /// Writes a normal form as a node.
    pub(super) fn build(&self, graph: &mut Graph, normal: &Normal) -> Id {
        let mut sum = graph.zero();
        for (monomial, coefficient) in normal.terms() {
            let mut product = graph.integer(1);
            for (atom, exponent) in monomial {
                let base = self.build_atom(graph, *atom);
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

    fn build_atom(&self, graph: &mut Graph, atom: Atom) -> Id {
        let (function, args) = match self.kind(atom) {
            Kind::Symbol(id) => return *id,
            Kind::Float(bits) => return graph.number(Number::Float(*bits)),
            Kind::Ratio(ratio) => return graph.number(Number::Exact(*ratio)),
            Kind::Sum(base) => return self.build(graph, base),
            Kind::Power(base, exponent) => {
                let base = self.build(graph, base);
                return graph.pow(base, Ratio::integer((*exponent).into()));
            }
            Kind::Cbrt(base) => (Function::Cbrt, std::slice::from_ref(base)),
            Kind::Exponential(function, exponent) => (*function, std::slice::from_ref(exponent)),
            Kind::Call(function, args) => (*function, &args[..]),
        };
        let args: Vec<Id> = args.iter().map(|arg| self.build(graph, arg)).collect();
        graph.call(function, &args)
    }
}
