//! Polynomials in (q, p) of degree at most 2, expanded into monomials.

use super::degree::Degrees;
use super::leaves::Leaf;
use crate::ir::{Graph, HashMap, Id, Node, Number, Ratio, Symbol};
use std::rc::Rc;

/// The number of a coordinate: 2i is qᵢ, and 2i + 1 is pᵢ.
pub(super) type Variable = u32;

/// The constant 1 as a variable. A polynomial of degree at most 2 is a quadratic form in q, p and 1.
pub(super) const UNIT: Variable = u32::MAX;

/// An opaque factor of a coefficient: a node free of q and p, or a constant that is not a short ratio.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Atom {
    Node(Id),
    /// A ratio of long parts: its numerator and denominator.
    Long(i128, i128),
    /// The bits of an `f64`.
    Float(u64),
}

impl Atom {
    /// Builds the node of the factor.
    pub(super) fn node(self, graph: &mut Graph) -> Id {
        match self {
            Atom::Node(id) => id,
            Atom::Long(numerator, denominator) => graph.number(Number::Exact(Ratio { numerator, denominator })),
            Atom::Float(bits) => graph.number(Number::Float(bits)),
        }
    }
}

/// Π atomᵉ, in order of the atoms. No exponent is zero.
pub(super) type Atoms = Vec<(Atom, i128)>;

/// number · Π atomᵉ · the product of two variables. Atoms and variables are in order. Different products of atoms count as independent, so terms
/// cancel only if they cancel for all values of the parameters.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Monomial {
    pub(super) variables: [Variable; 2],
    pub(super) atoms: Atoms,
    pub(super) number: Ratio,
}

/// A sum of monomials. Several monomials may have equal variables and atoms.
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
            Number::Exact(ratio) if ratio.fits_f64() => {
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

    /// Returns the product. `None` if its degree is above 2, or if its number is not exact.
    fn mul(&self, other: &Monomial) -> Option<Monomial> {
        let ([a, b], [c, d]) = (self.variables, other.variables);
        let mut variables = [a, b, c, d];
        variables.sort_unstable();
        let [first, second, UNIT, UNIT] = variables else { return None };
        let atoms = product_of_atoms(&self.atoms, &other.atoms)?;
        Some(Monomial { variables: [first, second], atoms, number: self.number.mul(other.number)? })
    }
}

/// Returns the product of two products of atoms. `None` if an exponent is too large.
pub(super) fn product_of_atoms(a: &Atoms, b: &Atoms) -> Option<Atoms> {
    let mut product = a.clone();
    for (atom, exponent) in b {
        match product.binary_search_by_key(atom, |(atom, _)| *atom) {
            Ok(i) => product[i].1 = product[i].1.checked_add(*exponent)?,
            Err(i) => product.insert(i, (*atom, *exponent)),
        }
    }
    product.retain(|(_, exponent)| *exponent != 0);
    Some(product)
}

/// The largest number of products of monomials. Longer expressions are not expanded.
const MAX_PRODUCTS: usize = 20_000;

/// Expands nodes into monomials. All methods return `None` if the result is too long, or if a number is no longer exact.
pub(super) struct Expansion<'a> {
    graph: &'a Graph,
    degrees: &'a Degrees,
    /// Cache of expanded nodes.
    done: HashMap<Id, Rc<Quadratic>>,
    /// The number of products of monomials so far.
    products: usize,
}

impl<'a> Expansion<'a> {
    /// Creates an empty cache. `degrees` are degrees in (q, p).
    pub(super) fn new(graph: &'a Graph, degrees: &'a Degrees) -> Self {
        Expansion { graph, degrees, done: HashMap::default(), products: 0 }
    }

    /// Expands a leaf.
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

    /// Expands a node of degree at most 2.
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

    /// Expands a node. Precondition: its operands are expanded.
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
            // Other powers do not have degree 1 or 2.
            Node::Power(base, exponent) if *exponent == Ratio::integer(2) => {
                let base = self.node(*base)?;
                self.product(&base, &base)
            }
            _ => None,
        }
    }

    /// Multiplies two sums.
    fn product(&mut self, a: &[Monomial], b: &[Monomial]) -> Option<Quadratic> {
        self.products += a.len() * b.len();
        if self.products > MAX_PRODUCTS {
            return None;
        }
        a.iter().flat_map(|a| b.iter().map(|b| a.mul(b))).collect()
    }

    /// Returns a node that is free of q and p as a monomial.
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
