//! Polynomials of degree 2 at most in (q, p), multiplied out.

use super::degree::Degrees;
use super::leaves::Leaf;
use crate::ir::{Graph, HashMap, Id, Node, Number, Ratio, Symbol};
use std::rc::Rc;

/// A coordinate: 2i is qᵢ, 2i + 1 is pᵢ.
pub(super) type Variable = u32;

/// In place of a coordinate: a polynomial of degree 2 at most is a quadratic form in q, p and 1.
pub(super) const UNIT: Variable = u32::MAX;

/// What is not known while compiling: a node free of q and p, or a constant that is no short ratio.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Atom {
    Node(Id),
    /// Numerator and denominator.
    Long(i128, i128),
    Float(u64),
}

impl Atom {
    /// What it stands for.
    pub(super) fn node(self, graph: &mut Graph) -> Id {
        match self {
            Atom::Node(id) => id,
            Atom::Long(numerator, denominator) => graph.number(Number::Exact(Ratio { numerator, denominator })),
            Atom::Float(bits) => graph.number(Number::Float(bits)),
        }
    }
}

/// number · Π atomᵉ · the product of two variables; atoms and variables in order. Different products of atoms count as
/// independent: what cancels does so whatever the parameters are.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Monomial {
    pub(super) variables: [Variable; 2],
    pub(super) atoms: Vec<(Atom, i128)>,
    pub(super) number: Ratio,
}

/// A sum of monomials; several may have the same variables and atoms.
pub(super) type Quadratic = Vec<Monomial>;

impl Monomial {
    const ONE: Monomial = Monomial { variables: [UNIT; 2], atoms: vec![], number: Ratio::ONE };

    fn variable(variable: Variable) -> Monomial {
        Monomial { variables: [variable, UNIT], ..Monomial::ONE }
    }

    /// numberᵉ.
    fn number(number: Number, power: i128) -> Option<Monomial> {
        let magnitude = match number {
            // Long ratios would soon be too long to be multiplied.
            Number::Exact(ratio) if ratio.is_short() => {
                return match number.pow(Ratio::integer(power))? {
                    Number::Exact(number) => Some(Monomial { number, ..Monomial::ONE }),
                    Number::Root(..) | Number::Float(_) => None,
                };
            }
            Number::Exact(ratio) => Atom::Long(ratio.numerator.abs(), ratio.denominator),
            Number::Root(..) | Number::Float(_) => Atom::Float(number.to_f64().abs().to_bits()),
        };
        let sign = if number.is_negative() && power % 2 != 0 { -1 } else { 1 };
        Some(Monomial { number: Ratio::integer(sign), atoms: vec![(magnitude, power)], ..Monomial::ONE })
    }

    /// The product; `None` if it is of degree 3, or its number is not exact.
    fn mul(&self, other: &Monomial) -> Option<Monomial> {
        let ([a, b], [c, d]) = (self.variables, other.variables);
        let mut variables = [a, b, c, d];
        variables.sort_unstable();
        let mut atoms = self.atoms.clone();
        for (atom, power) in &other.atoms {
            match atoms.binary_search_by_key(atom, |(atom, _)| *atom) {
                Ok(i) => atoms[i].1 = atoms[i].1.checked_add(*power)?,
                Err(i) => atoms.insert(i, (*atom, *power)),
            }
        }
        atoms.retain(|(_, power)| *power != 0);
        let [first, second, UNIT, UNIT] = variables else { return None };
        Some(Monomial { variables: [first, second], atoms, number: self.number.mul(other.number)? })
    }
}

/// Energies are short; what has more terms than this is not multiplied out.
const MAX_TERMS: usize = 20_000;

/// Multiplies out. What is too long, or has numbers that are no longer exact, gives `None`.
pub(super) struct Expansion<'a> {
    graph: &'a Graph,
    degrees: &'a Degrees,
    done: HashMap<Id, Rc<Quadratic>>,
    terms: usize,
}

impl<'a> Expansion<'a> {
    pub(super) fn new(graph: &'a Graph, degrees: &'a Degrees) -> Self {
        Expansion { graph, degrees, done: HashMap::default(), terms: 0 }
    }

    /// The parts of a leaf, multiplied out.
    pub(super) fn leaf(&mut self, leaf: &Leaf) -> Option<Quadratic> {
        let mut form = vec![];
        match leaf {
            Leaf::Sum(terms) => {
                for term in terms {
                    let mut product = vec![Monomial::number(term.scale, 1)?];
                    for id in &term.factors {
                        let factor = self.node(*id)?;
                        product = self.product(&product, &factor)?;
                    }
                    form.extend(product);
                }
            }
            Leaf::Squares(sides) => {
                for side in sides {
                    let side = self.node(*side)?;
                    form.extend(self.product(&side, &side)?);
                }
            }
        }
        Some(form)
    }

    /// A node of degree 2 at most.
    fn node(&mut self, root: Id) -> Option<Rc<Quadratic>> {
        if self.degrees.get(root) == Some(0) {
            return Some(Rc::new(vec![self.constant(root)?]));
        }
        if !self.done.contains_key(&root) {
            for id in self.graph.reachable(&[root]) {
                if self.degrees.get(id) != Some(0) && !self.done.contains_key(&id) {
                    let form = Rc::new(self.expand(id)?);
                    self.done.insert(id, form);
                }
            }
        }
        self.done.get(&root).cloned()
    }

    /// A node whose operands are done.
    fn expand(&mut self, id: Id) -> Option<Quadratic> {
        match self.graph.node(id) {
            Node::Symbol(Symbol::Position(i)) => Some(vec![Monomial::variable(2 * i)]),
            Node::Symbol(Symbol::Momentum(i)) => Some(vec![Monomial::variable(2 * i + 1)]),
            Node::Linear(constant, terms) => {
                let mut form = vec![];
                if !constant.is_zero() {
                    form.push(Monomial::number(*constant, 1)?);
                }
                for (c, term) in terms {
                    let term = self.node(*term)?;
                    form.extend(self.product(&[Monomial::number(*c, 1)?], &term)?);
                }
                Some(form)
            }
            Node::Product(ids) => ids.iter().try_fold(vec![Monomial::ONE], |form, id| {
                let other = self.node(*id)?;
                self.product(&form, &other)
            }),
            // No other power is of degree 1 or 2.
            Node::Power(base, exponent) if *exponent == Ratio::integer(2) => {
                let base = self.node(*base)?;
                self.product(&base, &base)
            }
            _ => None,
        }
    }

    fn product(&mut self, a: &[Monomial], b: &[Monomial]) -> Option<Quadratic> {
        self.terms += a.len() * b.len();
        if self.terms > MAX_TERMS {
            return None;
        }
        a.iter().flat_map(|a| b.iter().map(|b| a.mul(b))).collect()
    }

    /// A node that is free of q and p.
    fn constant(&self, root: Id) -> Option<Monomial> {
        let mut product = Monomial::ONE;
        let mut open = vec![(root, 1)];
        while let Some((id, power)) = open.pop() {
            let factor = match self.graph.node(id) {
                Node::Number(number) => Monomial::number(*number, power)?,
                Node::Linear(Number::ZERO, terms) if terms.len() == 1 => {
                    let (c, rest) = terms[0];
                    open.push((rest, power));
                    Monomial::number(c, power)?
                }
                Node::Product(ids) => {
                    open.extend(ids.iter().map(|id| (*id, power)));
                    continue;
                }
                Node::Power(base, exponent) if exponent.is_integer() => {
                    open.push((*base, power.checked_mul(exponent.numerator)?));
                    continue;
                }
                _ => Monomial { atoms: vec![(Atom::Node(id), power)], ..Monomial::ONE },
            };
            product = product.mul(&factor)?;
        }
        Some(product)
    }
}
