//! Decides whether a node is zero for all values of its symbols.
//!
//! The node is multiplied out. A node that is too long for this, or that needs relations between functions, is evaluated at points of a finite
//! field. Only these two proofs give the answer [`Identity::Zero`]. It holds wherever the node is defined, and names its proof. A node without a
//! proof is [`Identity::Wrong`], with a state at which it is not zero, or [`Identity::Open`]. Floating point selects between these two, and
//! proves nothing.
//!
//! `claims` states the identities of fields, integrals and structure matrices. `search` and `liouville` find integrals and energies.
mod angles;
pub(crate) mod claims;
mod common_factor;
pub(crate) mod crossings;
pub(crate) mod liouville;
mod multiplied;
mod residues;
mod rounding;
pub(crate) mod search;
mod surface;
mod witness;

use crate::diff;
use crate::ir::{Function, Graph, Id, Node, Number, Symbol};
pub(crate) use angles::{angles, broken_at};
pub(crate) use residues::Bound;
use rounding::Shown;
pub(crate) use rounding::{Direction, is_regular, retain_likely_constant};
use std::collections::{BTreeSet, HashSet};
pub(crate) use witness::{Value, Witness};

/// Comparisons and signs whose boundary, the states with equal sides, is excluded from an identity.
type OpenBoundaries = HashSet<Id>;

/// The answer to the question whether a node is zero.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Identity {
    /// The node is zero wherever it is defined.
    Zero(Proof),
    /// The node is not zero.
    Wrong(Box<Wrong>),
    /// There is neither a proof nor a state at which the node is certainly not zero.
    Open(Open),
}

/// The proof of an identity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Proof {
    /// Exact, by multiplying out.
    Multiplied,
    /// By evaluation over a finite field. The bound limits the probability of an error, if the points count as random.
    Points(Bound),
}

impl Proof {
    /// The proof of a statement that needs two proofs.
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
    /// The terms that do not cancel. Present if the node could be multiplied out.
    pub(crate) rest: Option<Remainder>,
    pub(crate) witness: Witness,
    /// The identity holds for other signs of roots, as √(x²) = x does.
    pub(crate) branch: bool,
    /// There is certainly no open set of states on which the identity holds.
    pub(crate) almost_everywhere: bool,
}

/// An identity that was not decided.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Open {
    /// The terms that do not cancel. Present if the node could be multiplied out.
    pub(crate) rest: Option<Remainder>,
    pub(crate) why: Why,
}

/// The reason why an identity was not proven.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Why {
    /// It needs an unknown relation between functions or rounded numbers, or does not hold. In [`Open`] it holds to rounding.
    Relation,
    /// It holds for some signs of roots only, as √x·√y = √(xy) does. In [`Open`] it holds to rounding.
    Branch,
    /// It is too long, has too many roots and conditions, or divides by zero on one side of a condition. In [`Open`] it holds to rounding.
    TooLong,
    /// It is not defined at any visited state.
    Nowhere,
}

/// The terms of a node that do not cancel.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Remainder {
    /// The sum of these terms.
    pub(crate) rest: Id,
    /// The conditions of the case with this remainder, and whether each holds.
    pub(crate) case: Vec<(Id, bool)>,
    /// The sum is certainly not zero.
    pub(crate) certain: bool,
}

impl Remainder {
    /// Returns whether the rest is a quotient of polynomials.
    pub(crate) fn is_rational(&self, graph: &Graph) -> bool {
        is_made_of(graph, &[self.rest], 1, |_| false)
    }

    /// Returns whether the rest is meromorphic. It is then zero everywhere or almost nowhere, since complex space without poles is connected.
    fn is_meromorphic(&self, graph: &Graph) -> bool {
        self.case.is_empty() && is_made_of(graph, &[self.rest], 1, is_exponential)
    }
}

/// Returns whether a function is rational in exponentials of its argument.
fn is_exponential(function: Function) -> bool {
    use Function::{Cos, Cosh, Exp, Exp2, ExpM1, Sin, Sinh, Tan, Tanh};
    matches!(function, Exp | Exp2 | ExpM1 | Sinh | Cosh | Tanh | Sin | Cos | Tan)
}

/// Returns whether nodes consist of sums, products, allowed functions, and powers whose exponents have denominators up to `denominator`.
fn is_made_of(graph: &Graph, nodes: &[Id], denominator: i128, is_allowed: fn(Function) -> bool) -> bool {
    graph.reachable(nodes).iter().all(|id| match graph.node(*id) {
        Node::Number(_) | Node::Symbol(_) | Node::Linear(..) | Node::Product(_) => true,
        Node::Power(_, exponent) => exponent.denominator <= denominator,
        Node::Call(function, _) => is_allowed(*function),
        _ => false,
    })
}

impl Identity {
    pub(crate) fn is_zero(&self) -> bool {
        matches!(self, Identity::Zero(_))
    }

    /// Turns the answer for a node into the answer for unit·node.
    fn scale(&mut self, graph: &mut Graph, unit: Number) {
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

    /// The terms that do not cancel, if the node is not zero and could be multiplied out.
    pub(crate) fn rest(&self) -> Option<&Remainder> {
        match self {
            Identity::Zero(_) => None,
            Identity::Wrong(wrong) => wrong.rest.as_ref(),
            Identity::Open(open) => open.rest.as_ref(),
        }
    }
}

/// The largest number of products of two terms in each case. Above this number points are faster, and a remainder is too long to be read.
const PRODUCTS: usize = 500;

/// Decides whether a node is zero.
pub(crate) fn identity(graph: &mut Graph, root: Id) -> Identity {
    sum_is_zero(graph, &[root])
}

/// Returns whether a node is proven to be zero. Faster than [`identity`]: no proof is tried if floating point shows that the node is not zero.
pub(crate) fn vanishes(graph: &mut Graph, root: Id) -> bool {
    let open = OpenBoundaries::default();
    let proven = |graph: &mut Graph| {
        let verdict = multiplied::multiplied(graph, root, &open, PRODUCTS);
        verdict == multiplied::Verdict::Zero || residues::residues(graph, root, &open).is_ok()
    };
    graph.is_zero(root) || !rounding::differs(graph, root) && proven(graph)
}

/// Returns c with a = c·b, proven. c is a number times powers of parameters.
pub(crate) fn multiple(graph: &mut Graph, a: Id, b: Id) -> Option<Id> {
    let sums = multiplied::Sums::of(graph, &[a, b], PRODUCTS)?;
    let [terms_of_a, terms_of_b] = [a, b].map(|root| sums.terms(graph, root));
    // The first term of b times c is a term of a.
    let first = *terms_of_b.first()?;
    terms_of_a.into_iter().find_map(|term| {
        let c = graph.div(term, first);
        if graph.reads(c).moves() {
            return None;
        }
        let other = graph.mul(c, b);
        let difference = graph.sub(a, other);
        vanishes(graph, difference).then_some(c)
    })
}

/// Decides whether a sum is zero. The terms are given separately, because their sizes limit the rounding error of the sum.
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
        Ok(bound) => return Identity::Zero(Proof::Points(bound)),
        Err(why) => why,
    };
    let symbols = symbols(graph, terms);
    let drawn = match rounding::shown(graph, terms, &symbols, open) {
        Shown::Differs(state, value) => Some(Witness { state, value: Value::Near(value) }),
        Shown::Zero => None,
        Shown::Nowhere => return Identity::Open(Open { rest, why: Why::Nowhere }),
    };
    // An exact value below the rounding error is a witness, unless the node contains rounded numbers.
    let exact = drawn.is_some() || !witness::has_rounded(graph, terms);
    let witness = exact.then(|| witness::exact_witness(graph, terms, &symbols, open)).flatten();
    let witness = witness.or_else(|| witness::near_witness(graph, terms, &symbols, open)).or(drawn);
    let Some(witness) = witness else { return Identity::Open(Open { rest, why }) };
    // Points have refuted the identity for all signs of roots.
    let is_wrong_for_all_roots = why == Why::Relation && is_made_of(graph, terms, 2, |_| false);
    let almost_everywhere = is_wrong_for_all_roots || rest.as_ref().is_some_and(|rest| rest.is_meromorphic(graph));
    Identity::Wrong(Box::new(Wrong { rest, witness, branch: why == Why::Branch, almost_everywhere }))
}

/// The symbols that nodes read, in order.
fn symbols(graph: &Graph, nodes: &[Id]) -> Vec<Symbol> {
    let symbols: BTreeSet<Symbol> = nodes.iter().flat_map(|node| graph.symbols(*node)).collect();
    symbols.into_iter().collect()
}

/// ∂node/∂symbol.
fn derivative(graph: &mut Graph, node: Id, symbol: Symbol) -> Id {
    diff::jacobian(graph, &[node], &[symbol])[0][0]
}
