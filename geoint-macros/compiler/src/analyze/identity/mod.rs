//! Is a node zero, whatever the values of its symbols are?
//!
//! It is multiplied out; what is too long for that, or rests on relations between functions, is evaluated at points of a finite field.
//! "Zero" is proven by one of the two: it holds wherever the node is defined, and the answer says by which. What is not proven is
//! either wrong, with a state at which it is not zero, or open: floating point tells which, and proves nothing.
//!
//! `claims` asks this of fields, integrals and structure matrices; `search` and `liouville` find integrals and energies.
mod angles;
pub(crate) mod claims;
pub(crate) mod crossings;
pub(crate) mod liouville;
mod multiplied;
mod residues;
mod rounding;
pub(crate) mod search;
mod surface;
mod witness;

use crate::ir::{Function, Graph, Id, Node, Number, Symbol};
pub(crate) use angles::{angles, broken_at};
pub(crate) use residues::Bound;
pub(crate) use rounding::Direction;
use rounding::Shown;
use std::collections::{BTreeSet, HashSet};
pub(crate) use witness::{Value, Witness};

/// Comparisons and signs of which only the sides count, and no state at which both numbers are equal.
type OpenBoundaries = HashSet<Id>;

/// What is known of a node.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Identity {
    /// It is zero wherever it is defined.
    Zero(Proof),
    /// It is not zero.
    Wrong(Box<Wrong>),
    /// It was not proven, and no state was met at which it is certainly not zero.
    Open(Open),
}

/// How an identity was proven.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Proof {
    /// Multiplied out, exactly.
    Multiplied,
    /// Evaluated over a finite field: wrong with the probability that the bound gives, were points drawn at random.
    Points(Bound),
}

impl Proof {
    /// What two proofs are together.
    pub(crate) fn weaker(self, other: Proof) -> Proof {
        match (self, other) {
            (Proof::Points(a), Proof::Points(b)) if a.bits <= b.bits => Proof::Points(a),
            (proof, Proof::Multiplied) => proof,
            (_, other) => other,
        }
    }
}

/// An identity that does not hold.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Wrong {
    /// What remains, if it could be multiplied out.
    pub(crate) rest: Option<Remainder>,
    pub(crate) witness: Witness,
    /// Whether it holds for another choice of the signs of roots, as √(x²) = x.
    pub(crate) branch: bool,
    /// Whether there is certainly no open set of states on which it holds nevertheless.
    pub(crate) almost_everywhere: bool,
}

/// An identity that was not decided.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Open {
    /// What remains, if it could be multiplied out.
    pub(crate) rest: Option<Remainder>,
    pub(crate) why: Why,
}

/// Why an identity was not decided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Why {
    /// It holds to rounding, but rests on a relation between functions, or rounded numbers, that is not known here.
    Relation,
    /// It holds to rounding, but for one choice of the signs of roots only: √x·√y = √(xy).
    Branch,
    /// It holds to rounding, but is too long, has too many roots and conditions, or divides by zero on some side of them.
    TooLong,
    /// No state was met at which it is defined.
    Nowhere,
}

/// What is left of a node.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Remainder {
    /// The terms that do not cancel.
    pub(crate) rest: Id,
    /// The conditions of the case in which they are left, and whether each holds.
    pub(crate) case: Vec<(Id, bool)>,
    /// Whether the rest is certainly not zero.
    pub(crate) certain: bool,
}

impl Remainder {
    /// Whether the rest is a quotient of polynomials.
    pub(crate) fn is_rational(&self, graph: &Graph) -> bool {
        is_made_of(graph, &[self.rest], 1, &[])
    }

    /// Whether the rest is analytic but for poles: then it is zero everywhere, or almost nowhere, since what poles leave of complex
    /// space is connected.
    fn is_meromorphic(&self, graph: &Graph) -> bool {
        self.case.is_empty() && is_made_of(graph, &[self.rest], 1, &MEROMORPHIC)
    }
}

const MEROMORPHIC: [Function; 9] = {
    use Function::{Cos, Cosh, Exp, Exp2, ExpM1, Sin, Sinh, Tan, Tanh};
    [Sin, Cos, Tan, Sinh, Cosh, Tanh, Exp, Exp2, ExpM1]
};

/// Whether nodes are made of sums, products, powers whose exponents have such denominators, and functions of a list.
fn is_made_of(graph: &Graph, nodes: &[Id], denominator: i128, functions: &[Function]) -> bool {
    graph.reachable(nodes).iter().all(|id| match graph.node(*id) {
        Node::Number(_) | Node::Symbol(_) | Node::Linear(..) | Node::Product(_) => true,
        Node::Power(_, exponent) => exponent.denominator <= denominator,
        Node::Call(function, _) => functions.contains(function),
        _ => false,
    })
}

impl Identity {
    pub(crate) fn is_zero(&self) -> bool {
        matches!(self, Identity::Zero(_))
    }

    /// That of so many times as much.
    fn scale(&mut self, graph: &mut Graph, unit: Number) {
        if unit.is_one() {
            return;
        }
        let rest = match self {
            Identity::Zero(_) => return,
            Identity::Open(open) => &mut open.rest,
            Identity::Wrong(wrong) => {
                let value = match wrong.witness.value {
                    Value::Exact(value) => value.to_f64(),
                    Value::Near(value) => value,
                };
                wrong.witness.value = Value::Near(unit.to_f64() * value);
                &mut wrong.rest
            }
        };
        if let Some(rest) = rest {
            rest.rest = graph.scale(unit, rest.rest);
        }
    }

    /// What remains, if it is not zero and could be multiplied out.
    pub(crate) fn rest(&self) -> Option<&Remainder> {
        match self {
            Identity::Zero(_) => None,
            Identity::Wrong(wrong) => wrong.rest.as_ref(),
            Identity::Open(open) => open.rest.as_ref(),
        }
    }
}

/// So many products of two terms are formed in each case; from there on points are faster, and what remains is too long to be read.
const PRODUCTS: usize = 500;

/// Decides whether a node is zero.
pub(crate) fn identity(graph: &mut Graph, root: Id) -> Identity {
    sum_is_zero(graph, &[root])
}

/// Whether a node is proven to be zero, where no reason is wanted if it is not: what floating point shows to differ from zero is not tried.
pub(crate) fn vanishes(graph: &mut Graph, root: Id) -> bool {
    let open = OpenBoundaries::default();
    let proven = |graph: &mut Graph| match multiplied::multiplied(graph, root, &open, PRODUCTS) {
        multiplied::Verdict::Zero => true,
        _ => matches!(residues::residues(graph, root, &open), residues::Verdict::Zero(_)),
    };
    graph.is_zero(root) || !rounding::differs(graph, root) && proven(graph)
}

/// The c, a number times powers of parameters, with which a = c·b is proven.
pub(crate) fn multiple(graph: &mut Graph, a: Id, b: Id) -> Option<Id> {
    let sums = multiplied::Sums::of(graph, &[a, b], PRODUCTS)?;
    let [of_a, of_b] = [0, 1].map(|sum| sums.terms(graph, sum));
    // One term of the one is c times a term of the other.
    let last = *of_b.first()?;
    for term in of_a {
        let c = graph.div(term, last);
        if !graph.reads(c).moves() {
            let other = graph.mul(c, b);
            let difference = graph.sub(a, other);
            if vanishes(graph, difference) {
                return Some(c);
            }
        }
    }
    None
}

/// Leaves the directions along which a node may be constant: floating point does not show that it changes, a derivative may prove that it does not.
pub(crate) fn retain_constant(graph: &Graph, root: Id, directions: &mut Vec<Direction>) {
    rounding::retain_constant(graph, root, directions);
}

/// Whether floating point shows that a matrix is regular at some state.
pub(crate) fn is_regular(graph: &Graph, matrix: &[Vec<Id>]) -> bool {
    rounding::is_regular(graph, matrix)
}

/// Decides whether a sum is zero. Terms are given apart, so that it is seen how large they were when most of them cancelled.
pub(crate) fn sum_is_zero(graph: &mut Graph, terms: &[Id]) -> Identity {
    sum_is_zero_off(graph, terms, &OpenBoundaries::default())
}

/// Decides whether a sum is zero at every state that lies on none of the open boundaries.
fn sum_is_zero_off(graph: &mut Graph, terms: &[Id], open: &OpenBoundaries) -> Identity {
    let root = graph.sum(terms);
    let rest = match multiplied::multiplied(graph, root, open, PRODUCTS) {
        multiplied::Verdict::Zero => return Identity::Zero(Proof::Multiplied),
        multiplied::Verdict::Left(rest) => Some(rest),
        multiplied::Verdict::TooLong => None,
    };
    let why = match residues::residues(graph, root, open) {
        residues::Verdict::Zero(bound) => return Identity::Zero(Proof::Points(bound)),
        residues::Verdict::Branch => Why::Branch,
        residues::Verdict::NotZero => Why::Relation,
        residues::Verdict::GivenUp => Why::TooLong,
    };
    let symbols = symbols(graph, terms);
    let branch = why == Why::Branch;
    let drawn = match rounding::shown(graph, terms, &symbols, open) {
        Shown::Differs(state, value) => Some(Witness { state, value: Value::Near(value) }),
        Shown::Zero => None,
        Shown::Nowhere => return Identity::Open(Open { rest, why: Why::Nowhere }),
    };
    // What is too small to be seen is exact all the same, unless it is left of numbers that were rounded.
    let exact = drawn.is_some() || !witness::has_rounded(graph, terms);
    let witness = exact.then(|| witness::exact_witness(graph, terms, &symbols, open)).flatten();
    match witness.or_else(|| witness::near_witness(graph, terms, &symbols, open)).or(drawn) {
        Some(witness) => {
            // Points have refuted every choice of the signs of roots.
            let with_roots = why == Why::Relation && is_made_of(graph, terms, 2, &[]);
            let almost_everywhere = with_roots || rest.as_ref().is_some_and(|rest| rest.is_meromorphic(graph));
            Identity::Wrong(Box::new(Wrong { rest, witness, branch, almost_everywhere }))
        }
        None => Identity::Open(Open { rest, why }),
    }
}

/// The symbols that are read, in order.
fn symbols(graph: &Graph, terms: &[Id]) -> Vec<Symbol> {
    let symbols: BTreeSet<Symbol> = terms.iter().flat_map(|term| graph.symbols(*term)).collect();
    symbols.into_iter().collect()
}
