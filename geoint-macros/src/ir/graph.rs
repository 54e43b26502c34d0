//! The graph: interned nodes, simplified while they are built.
//!
//! Equal expressions are one node, so that "is it the same" is a comparison of numbers, shared terms are differentiated
//! once, and emitted once. Constructors fold constants, zeros, ones and signs, and merge equal terms and powers. They
//! never expand a product: how the user factored an expression is numerically meaningful.

use super::hash::HashMap;
use super::number::{Number, Ratio};
use super::op::{Domain, Function, Parity, Relation, Symbol};
use super::table::Table;
use std::cell::RefCell;

/// A node of a [`Graph`]; operands have smaller numbers than what is built of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct Id(u32);

impl Id {
    pub(crate) fn index(self) -> usize {
        self.0 as usize
    }

    pub(super) fn from_index(index: usize) -> Id {
        Id(index as u32)
    }
}

/// An expression in terms of smaller ones. A sum or product over an index that stays a loop would be one more kind of
/// node, with a graph of its own as its body.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Node {
    Number(Number),
    Symbol(Symbol),
    /// constant + Σ coefficient·term, terms in order of their ids; scaling and negation too.
    Linear(Number, Vec<(Number, Id)>),
    /// Π factors, at least two, in order of their ids; no numbers among them.
    Product(Vec<Id>),
    /// A base to an exponent that is an integer or half of one.
    Power(Id, Ratio),
    Call(Function, Vec<Id>),
    /// `if condition { first } else { second }`.
    Select(Id, Id, Id),
    /// Conditions.
    Compare(Relation, Id, Id),
    And(Id, Id),
    Or(Id, Id),
    Not(Id),
    Truth(bool),
}

impl Node {
    pub(crate) fn for_each_child(&self, mut visit: impl FnMut(Id)) {
        match self {
            Node::Number(_) | Node::Symbol(_) | Node::Truth(_) => {}
            Node::Linear(_, terms) => terms.iter().for_each(|(_, id)| visit(*id)),
            Node::Product(ids) | Node::Call(_, ids) => ids.iter().for_each(|id| visit(*id)),
            Node::Power(id, _) | Node::Not(id) => visit(*id),
            Node::Select(c, a, b) => [*c, *a, *b].into_iter().for_each(visit),
            Node::Compare(_, a, b) | Node::And(a, b) | Node::Or(a, b) => [*a, *b].into_iter().for_each(visit),
        }
    }

    pub(crate) fn children(&self) -> Vec<Id> {
        let mut children = vec![];
        self.for_each_child(|child| children.push(child));
        children
    }
}

/// Interned expressions.
#[derive(Clone, Debug, Default)]
pub(crate) struct Graph {
    nodes: Vec<Node>,
    known: HashMap<Node, Id>,
    /// Scratch space of traversals: the number of the traversal that saw a node last.
    seen: RefCell<(u32, Vec<u32>)>,
}

impl Graph {
    pub(crate) fn node(&self, id: Id) -> &Node {
        &self.nodes[id.index()]
    }

    pub(crate) fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Every node, operands first.
    pub(crate) fn ids(&self) -> impl Iterator<Item = Id> + use<> {
        (0..self.nodes.len()).map(Id::from_index)
    }

    /// Every node that the roots are built of, operands first.
    pub(crate) fn reachable(&self, roots: &[Id]) -> Vec<Id> {
        self.traverse(roots, |_| true)
    }

    /// Every node that `root` is built of and that is not `known` yet, operands first. What known nodes are built of is
    /// not looked at.
    pub(crate) fn unknown<T: Copy>(&self, root: Id, known: &Table<T>) -> Vec<Id> {
        self.traverse(&[root], |id| !known.contains(id))
    }

    /// Every node that can be reached through nodes that are `wanted`, operands first.
    fn traverse(&self, roots: &[Id], wanted: impl Fn(Id) -> bool) -> Vec<Id> {
        let mut scratch = self.seen.borrow_mut();
        let (traversal, seen) = &mut *scratch;
        *traversal += 1;
        seen.resize(self.nodes.len(), 0);
        let mut found = vec![];
        let mut open = roots.to_vec();
        while let Some(id) = open.pop() {
            if wanted(id) && std::mem::replace(&mut seen[id.index()], *traversal) != *traversal {
                found.push(id);
                self.node(id).for_each_child(|child| open.push(child));
            }
        }
        found.sort_unstable();
        found
    }

    /// Whether a node is not defined for some values of its operands.
    pub(crate) fn is_partial(&self, id: Id) -> bool {
        match self.node(id) {
            Node::Power(_, exponent) => !exponent.is_integer() || exponent.numerator < 0,
            Node::Call(function, _) => function.entry().domain != Domain::Everywhere,
            _ => false,
        }
    }

    fn intern(&mut self, node: Node) -> Id {
        let next = Id::from_index(self.nodes.len());
        *self.known.entry(node).or_insert_with_key(|node| {
            self.nodes.push(node.clone());
            next
        })
    }

    pub(crate) fn number(&mut self, value: Number) -> Id {
        self.intern(Node::Number(value))
    }

    pub(crate) fn integer(&mut self, value: i64) -> Id {
        self.number(Number::integer(value))
    }

    pub(crate) fn zero(&mut self) -> Id {
        self.integer(0)
    }

    pub(crate) fn symbol(&mut self, symbol: Symbol) -> Id {
        self.intern(Node::Symbol(symbol))
    }

    pub(crate) fn as_number(&self, id: Id) -> Option<Number> {
        match self.node(id) {
            Node::Number(value) => Some(*value),
            _ => None,
        }
    }

    pub(crate) fn is_zero(&self, id: Id) -> bool {
        self.as_number(id).is_some_and(Number::is_zero)
    }

    // ------------------------------------------------------------------------------------------------------ sums

    /// A node as constant + Σ coefficient·term, where a sum with several terms may be taken apart or be one term.
    fn terms(&self, id: Id, apart: bool) -> (Number, Vec<(Number, Id)>) {
        match self.node(id) {
            Node::Number(value) => (*value, vec![]),
            Node::Linear(constant, terms) if apart || (terms.len() == 1 && constant.is_zero()) => {
                (*constant, terms.clone())
            }
            _ => (Number::ZERO, vec![(Number::ONE, id)]),
        }
    }

    /// a + b. A sum on the left is continued; one on the right stays together as it was written, unless some term of it
    /// meets an equal one.
    pub(crate) fn add(&mut self, a: Id, b: Id) -> Id {
        let left = self.terms(a, a != b);
        let right = self.terms(b, false);
        let apart = self.terms(b, true);
        let meets = apart.1.iter().any(|(_, t)| left.1.iter().any(|(_, s)| s == t));
        let right = if meets { apart } else { right };
        self.linear(left.0.add(right.0), left.1.into_iter().chain(right.1).collect())
    }

    pub(crate) fn neg(&mut self, a: Id) -> Id {
        self.scale(Number::MINUS_ONE, a)
    }

    pub(crate) fn sub(&mut self, a: Id, b: Id) -> Id {
        if a == b {
            return self.zero();
        }
        // Sums that share a term are taken apart.
        let (left, right) = (self.terms(a, true), self.terms(b, true));
        if right.1.iter().any(|(_, t)| left.1.iter().any(|(_, s)| s == t)) {
            let negated = right.1.into_iter().map(|(c, t)| (c.neg(), t));
            return self.linear(left.0.add(right.0.neg()), left.1.into_iter().chain(negated).collect());
        }
        let b = self.neg(b);
        self.add(a, b)
    }

    /// Σ of all, equal ones merged.
    pub(crate) fn sum(&mut self, ids: &[Id]) -> Id {
        let mut constant = Number::ZERO;
        let mut all = vec![];
        for id in ids {
            let (c, terms) = self.terms(*id, false);
            constant = constant.add(c);
            all.extend(terms);
        }
        self.linear(constant, all)
    }

    /// c·a.
    pub(crate) fn scale(&mut self, c: Number, a: Id) -> Id {
        if c == Number::ONE {
            return a;
        }
        let (constant, terms) = self.terms(a, false);
        self.linear(constant.mul(c), terms.into_iter().map(|(k, t)| (k.mul(c), t)).collect())
    }

    /// constant + Σ coefficient·term, from terms that are not numbers.
    pub(crate) fn linear(&mut self, constant: Number, mut terms: Vec<(Number, Id)>) -> Id {
        terms.sort_by_key(|(_, id)| *id);
        terms.dedup_by(|next, kept| {
            let same = next.1 == kept.1;
            if same {
                kept.0 = kept.0.add(next.0);
            }
            same
        });
        terms.retain(|(c, _)| !c.is_zero());
        match terms[..] {
            [] => self.number(constant),
            [(Number::ONE, id)] if constant.is_zero() => id,
            // A number times a sum times a number.
            [(c, id)] if constant.is_zero() => match self.node(id) {
                Node::Linear(k, inner) if k.is_zero() && inner.len() == 1 => {
                    let (k, id) = inner[0];
                    self.linear(Number::ZERO, vec![(c.mul(k), id)])
                }
                _ => self.intern(Node::Linear(constant, terms)),
            },
            _ => self.intern(Node::Linear(constant, terms)),
        }
    }

    // -------------------------------------------------------------------------------------------- products, powers

    /// A node as coefficient·rest.
    pub(crate) fn coefficient(&self, id: Id) -> (Number, Id) {
        match self.node(id) {
            Node::Linear(constant, terms) if constant.is_zero() && terms.len() == 1 => terms[0],
            _ => (Number::ONE, id),
        }
    }

    /// Bases and exponents of a product, however nested.
    pub(crate) fn factors(&self, id: Id) -> Vec<(Id, Ratio)> {
        let (mut factors, mut open) = (vec![], vec![id]);
        while let Some(id) = open.pop() {
            match self.node(id) {
                Node::Product(ids) => open.extend(ids),
                Node::Power(base, exponent) => factors.push((*base, *exponent)),
                _ => factors.push((id, Ratio::ONE)),
            }
        }
        factors
    }

    /// a·b. Stays nested as it was written (a product that others use as well is computed once), unless some base
    /// meets an equal one: then powers are merged.
    pub(crate) fn mul(&mut self, a: Id, b: Id) -> Id {
        match (self.as_number(a), self.as_number(b)) {
            (Some(c), _) => return self.scale(c, b),
            (_, Some(c)) => return self.scale(c, a),
            _ => {}
        }
        let ((ca, a), (cb, b)) = (self.coefficient(a), self.coefficient(b));
        let (mut left, mut right) = (self.factors(a), self.factors(b));
        // A product that is the base of the other side's power meets it as a whole.
        if right.iter().any(|(base, _)| *base == a) {
            left = vec![(a, Ratio::ONE)];
        }
        if left.iter().any(|(base, _)| *base == b) {
            right = vec![(b, Ratio::ONE)];
        }
        let meets = right.iter().any(|(base, _)| left.iter().any(|(other, _)| other == base));
        let product = if meets {
            self.merged(left.into_iter().chain(right).collect())
        } else {
            let mut pair = vec![a, b];
            pair.sort();
            self.intern(Node::Product(pair))
        };
        self.scale(ca.mul(cb), product)
    }

    fn merged(&mut self, mut factors: Vec<(Id, Ratio)>) -> Id {
        factors.sort_by_key(|(base, _)| *base);
        let mut powers: Vec<(Id, Ratio)> = vec![];
        for (base, exponent) in factors {
            match powers.last_mut() {
                Some((last, e)) if *last == base => {
                    // Exponents are small; should their sum ever overflow, the factors stay apart.
                    match e.add(exponent) {
                        Some(total) => *e = total,
                        None => powers.push((base, exponent)),
                    }
                }
                _ => powers.push((base, exponent)),
            }
        }
        let mut coefficient = Number::ONE;
        let mut ids = vec![];
        for (base, exponent) in powers {
            let power = self.pow(base, exponent);
            match self.as_number(power) {
                Some(c) => coefficient = coefficient.mul(c),
                None => ids.push(power),
            }
        }
        ids.sort();
        let product = match ids[..] {
            [] => return self.number(coefficient),
            [id] => id,
            _ => self.intern(Node::Product(ids)),
        };
        self.scale(coefficient, product)
    }

    pub(crate) fn product(&mut self, ids: &[Id]) -> Id {
        let one = self.integer(1);
        ids.iter().fold(one, |product, id| self.mul(product, *id))
    }

    pub(crate) fn recip(&mut self, a: Id) -> Id {
        self.pow(a, Ratio::integer(-1))
    }

    pub(crate) fn div(&mut self, a: Id, b: Id) -> Id {
        let b = self.recip(b);
        self.mul(a, b)
    }

    pub(crate) fn sqrt(&mut self, a: Id) -> Id {
        self.pow(a, Ratio::HALF)
    }

    /// baseᵉ for an exponent that is an integer or half of one.
    pub(crate) fn pow(&mut self, base: Id, exponent: Ratio) -> Id {
        if exponent.numerator == 0 {
            return self.integer(1);
        }
        if exponent == Ratio::ONE {
            return base;
        }
        match self.node(base).clone() {
            Node::Number(value) => {
                if let Some(power) = value.pow(exponent) {
                    return self.number(power);
                }
            }
            // (xʳ)ᵉ = xʳᵉ unless a sign was lost on the way: √(x²) is |x|.
            Node::Power(inner, r) if exponent.is_integer() || !r.is_integer() => {
                if let Some(total) = r.mul(exponent).filter(|total| total.denominator <= 2) {
                    return self.pow(inner, total);
                }
            }
            Node::Linear(constant, terms) if constant.is_zero() && terms.len() == 1 => {
                let (c, rest) = terms[0];
                if exponent.is_integer()
                    && let Some(c) = c.pow(exponent)
                {
                    let power = self.pow(rest, exponent);
                    return self.scale(c, power);
                }
            }
            // (b − a)² and (a − b)² are one node.
            Node::Linear(..) if exponent.is_integer() && exponent.numerator % 2 == 0 && self.leads_negative(base) => {
                let positive = self.negated_sum(base);
                return self.pow(positive, exponent);
            }
            _ => {}
        }
        self.intern(Node::Power(base, exponent))
    }

    /// Whether the first coefficient of a sum, or the only one, is negative.
    fn leads_negative(&self, id: Id) -> bool {
        match self.node(id) {
            Node::Linear(_, terms) => terms[0].0.is_negative(),
            Node::Number(value) => value.is_negative(),
            _ => false,
        }
    }

    fn negated_sum(&mut self, id: Id) -> Id {
        let (constant, terms) = self.terms(id, true);
        self.linear(constant.neg(), terms.into_iter().map(|(c, t)| (c.neg(), t)).collect())
    }

    // --------------------------------------------------------------------------------------- functions, conditions

    pub(crate) fn call(&mut self, function: Function, args: &[Id]) -> Id {
        let numbers: Option<Vec<f64>> = args.iter().map(|id| self.as_number(*id).map(Number::to_f64)).collect();
        if let Some(value) = numbers.map(|x| (function.entry().value)(&x)).filter(|value| value.is_finite()) {
            return self.number(Number::float(value));
        }
        match (function.entry().parity, args) {
            (Parity::Odd, &[x]) if self.leads_negative(x) => {
                let x = self.negated_sum(x);
                let value = self.call(function, &[x]);
                self.neg(value)
            }
            (Parity::Even, &[x]) if self.leads_negative(x) => {
                let x = self.negated_sum(x);
                self.call(function, &[x])
            }
            _ => self.intern(Node::Call(function, args.to_vec())),
        }
    }

    pub(crate) fn select(&mut self, condition: Id, first: Id, second: Id) -> Id {
        match self.node(condition) {
            _ if first == second => first,
            Node::Truth(true) => first,
            Node::Truth(false) => second,
            _ => self.intern(Node::Select(condition, first, second)),
        }
    }

    pub(crate) fn compare(&mut self, relation: Relation, a: Id, b: Id) -> Id {
        match (self.as_number(a), self.as_number(b)) {
            (Some(x), Some(y)) if x.compare(y).is_some() => self.truth(relation.holds(x.to_f64(), y.to_f64())),
            _ => self.intern(Node::Compare(relation, a, b)),
        }
    }

    pub(crate) fn truth(&mut self, value: bool) -> Id {
        self.intern(Node::Truth(value))
    }

    pub(crate) fn as_truth(&self, id: Id) -> Option<bool> {
        match self.node(id) {
            Node::Truth(value) => Some(*value),
            _ => None,
        }
    }

    pub(crate) fn and(&mut self, a: Id, b: Id) -> Id {
        match (self.as_truth(a), self.as_truth(b)) {
            (Some(true), _) => b,
            (_, Some(true)) => a,
            (Some(false), _) | (_, Some(false)) => self.truth(false),
            _ => self.intern(Node::And(a, b)),
        }
    }

    pub(crate) fn or(&mut self, a: Id, b: Id) -> Id {
        match (self.as_truth(a), self.as_truth(b)) {
            (Some(false), _) => b,
            (_, Some(false)) => a,
            (Some(true), _) | (_, Some(true)) => self.truth(true),
            _ => self.intern(Node::Or(a, b)),
        }
    }

    pub(crate) fn not(&mut self, a: Id) -> Id {
        match *self.node(a) {
            Node::Truth(value) => self.truth(!value),
            Node::Not(inner) => inner,
            _ => self.intern(Node::Not(a)),
        }
    }
}
