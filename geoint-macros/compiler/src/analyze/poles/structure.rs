//! The zeros of a node, derived from its form: the smaller nodes that vanish there, and tests that exclude zeros on a straight line.

use super::super::degree::Degrees;
use crate::ir::{Function, Graph, HashMap, Id, Node, Number, Ratio, Sign, Symbol};
use std::collections::{BTreeSet, HashSet};

/// A test that excludes zeros on a straight line, given values at both ends.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Quick {
    /// Affine forms that vanish together, if the parameters have the given signs. The vectors a and b of their values at both ends exclude a zero if
    /// a·b > 0, because a + τ(b − a) is zero only if a and b are opposite.
    Forms(Vec<Id>, Signs),
    /// A sine or cosine of an affine argument. Equal signs at both ends exclude a zero if the argument changes by less than π.
    Angle { value: Id, argument: Id },
    /// A node with the zeros of sin(multiple·argument) for an affine argument. The sine is not built yet.
    SineOf { multiple: Number, argument: Id },
}

impl Quick {
    /// Returns whether the test compares the signs of the node itself.
    pub(super) fn is_sign_of(&self, id: Id) -> bool {
        match self {
            Quick::Forms(forms, _) => forms[..] == [id],
            Quick::Angle { value, .. } => *value == id,
            Quick::SineOf { .. } => false,
        }
    }

    /// Builds the sine of the test.
    pub(super) fn build(&mut self, graph: &mut Graph) {
        if let Quick::SineOf { multiple, argument } = *self {
            let argument = graph.scale(multiple, argument);
            *self = Quick::Angle { value: graph.call(Function::Sin, &[argument]), argument };
        }
    }
}

/// Assumed signs of nodes that read parameters only.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Signs {
    pub(crate) positive: Vec<Id>,
    pub(crate) not_negative: Vec<Id>,
}

/// The curvature of a function on every straight line.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Curvature {
    Concave,
    Convex,
}

impl Curvature {
    fn opposite(self) -> Curvature {
        match self {
            Curvature::Concave => Curvature::Convex,
            Curvature::Convex => Curvature::Concave,
        }
    }
}

/// Finds zeros of nodes.
pub(super) struct Zeros {
    /// Degrees in coordinates and time.
    degrees: Degrees,
}

/// A node whose zeros are zeros of a larger node.
pub(super) struct Zero {
    pub(super) node: Id,
    /// The test that excludes a zero, if there is one.
    pub(super) quick: Option<Quick>,
}

/// The places where a node is 1.
enum One {
    /// The zeros of another node.
    At(Id),
    /// The zeros of the sine of a multiple of another node.
    Periodic { multiple: Number, argument: Id },
}

/// Affine forms that vanish together, if parameters have the assumed signs.
#[derive(Clone, Default)]
struct Forms {
    forms: BTreeSet<Id>,
    signs: Signs,
}

impl Zeros {
    /// Prepares the search for zeros of some nodes.
    pub(super) fn new(graph: &Graph, terms: &[Id]) -> Self {
        let degrees = Degrees::of(graph, terms, |symbol| symbol.is_coordinate() || symbol == Symbol::Time);
        Zeros { degrees }
    }

    /// Returns nodes of which at least one vanishes wherever `root` does. Nodes that do not move are left out.
    pub(super) fn of(&self, graph: &Graph, root: Id) -> Vec<Zero> {
        use Function::{Abs, Asin, Asinh, Atan, Cbrt, Cos, ExpM1, Sin, Sinh, Tanh};
        let (mut open, mut seen, mut zeros) = (vec![root], HashSet::new(), vec![]);
        while let Some(id) = open.pop() {
            if graph.is_positive(id) || !graph.reads(id).moves() || !seen.insert(id) {
                continue;
            }
            match graph.node(id) {
                Node::Product(factors) => open.extend(factors),
                Node::Linear(constant, terms) if constant.is_zero() && terms.len() == 1 => open.push(terms[0].1),
                Node::Power(base, exponent) if exponent.numerator > 0 => open.push(*base),
                Node::Power(..) => {}
                Node::Call(Abs | Cbrt | Sinh | Tanh | Asinh | Atan | Asin | ExpM1, args) => open.push(args[0]),
                Node::Call(Sin | Cos, args) if self.is_affine(args[0]) => {
                    zeros.push(Zero { node: id, quick: Some(Quick::Angle { value: id, argument: args[0] }) });
                }
                // c − c·f vanishes where f is 1.
                Node::Linear(constant, terms)
                    if terms.len() == 1 && constant.neg() == terms[0].0 && !self.is_affine(id) =>
                {
                    match self.where_one(graph, terms[0].1) {
                        Some(One::At(argument)) => open.push(argument),
                        Some(One::Periodic { multiple, argument }) => {
                            zeros.push(Zero { node: id, quick: Some(Quick::SineOf { multiple, argument }) });
                        }
                        None => zeros.push(Zero { node: id, quick: None }),
                    }
                }
                _ => {
                    let forms = self.forms(graph, id, &mut HashMap::default());
                    let quick = forms.map(|Forms { forms, signs }| Quick::Forms(forms.into_iter().collect(), signs));
                    zeros.push(Zero { node: id, quick });
                }
            }
        }
        zeros
    }

    /// Returns the places where a node is 1.
    fn where_one(&self, graph: &Graph, id: Id) -> Option<One> {
        use Function::{Cos, Cosh, Exp, Exp2};
        match graph.node(id) {
            Node::Call(Cosh | Exp | Exp2, args) => Some(One::At(args[0])),
            Node::Call(Cos, args) if self.is_affine(args[0]) => {
                Some(One::Periodic { multiple: Number::HALF, argument: args[0] })
            }
            // cos² = 1 where the sine vanishes.
            Node::Power(base, exponent) if *exponent == Ratio::integer(2) => match graph.node(*base) {
                Node::Call(Cos, args) if self.is_affine(args[0]) => {
                    Some(One::Periodic { multiple: Number::ONE, argument: args[0] })
                }
                Node::Call(Cosh, args) => Some(One::At(args[0])),
                _ => None,
            },
            _ => None,
        }
    }

    /// Returns affine forms that all vanish wherever `id` does. `known` is a cache of the forms of other nodes.
    fn forms(&self, graph: &Graph, id: Id, known: &mut HashMap<Id, Option<Forms>>) -> Option<Forms> {
        if let Some(known) = known.get(&id) {
            return known.clone();
        }
        let forms = self.new_forms(graph, id, known);
        known.insert(id, forms.clone());
        forms
    }

    /// Computes the forms of a node that is not in the cache.
    fn new_forms(&self, graph: &Graph, id: Id, known: &mut HashMap<Id, Option<Forms>>) -> Option<Forms> {
        if self.is_affine(id) {
            return Some(Forms { forms: BTreeSet::from([id]), signs: Signs::default() });
        }
        // If no summand is negative anywhere, the sum vanishes only where all summands vanish.
        let mut together = |parts: &[Id]| {
            let mut all = Forms::default();
            for part in parts {
                let Forms { forms, signs } = self.forms(graph, *part, known)?;
                all.forms.extend(forms);
                all.signs.positive.extend(signs.positive);
                all.signs.not_negative.extend(signs.not_negative);
            }
            Some(all)
        };
        match graph.node(id) {
            Node::Linear(constant, terms) => {
                if constant.is_negative() || terms.iter().any(|(c, _)| c.is_negative()) {
                    return None;
                }
                let (constant, moving): (Vec<Id>, Vec<Id>) =
                    terms.iter().map(|(_, term)| term).partition(|id| !graph.reads(**id).moves());
                if !moving.iter().all(|id| self.is_square(graph, *id)) {
                    return None;
                }
                let mut all = together(&moving)?;
                all.signs.not_negative.extend(constant.iter().filter(|id| graph.sign(**id) == Sign::Unknown));
                Some(all)
            }
            Node::Product(factors) => {
                let (constant, moving): (Vec<Id>, Vec<Id>) = factors.iter().partition(|id| !graph.reads(**id).moves());
                let [moving] = moving[..] else { return None };
                let mut all = together(&[moving])?;
                all.signs.positive.extend(constant);
                Some(all)
            }
            Node::Power(base, exponent) if exponent.numerator > 0 => together(&[*base]),
            Node::Call(Function::Abs | Function::Hypot, args) => together(args),
            _ => None,
        }
    }

    /// Returns whether a node is nowhere negative if its constant factors are not negative.
    fn is_square(&self, graph: &Graph, id: Id) -> bool {
        match graph.node(id) {
            Node::Product(factors) => factors.iter().all(|id| !graph.reads(*id).moves() || self.is_square(graph, *id)),
            _ => graph.sign(id) != Sign::Unknown,
        }
    }

    /// Returns whether a node is affine in coordinates and time.
    fn is_affine(&self, id: Id) -> bool {
        self.degrees.at_most(id, 1)
    }

    /// Returns whether a node may be negative between two points at which it is not negative.
    pub(super) fn has_gap(&self, graph: &Graph, id: Id) -> bool {
        graph.sign(id) == Sign::Unknown && graph.reads(id).moves() && !self.is_concave(graph, id)
    }

    /// Returns whether the form of a node implies that it is concave. Between two points, a concave node is not below the smaller of both values.
    pub(super) fn is_concave(&self, graph: &Graph, id: Id) -> bool {
        self.bends(graph, id, Curvature::Concave)
    }

    /// Returns whether the form of a node implies its curvature.
    fn bends(&self, graph: &Graph, id: Id, curvature: Curvature) -> bool {
        if self.is_affine(id) {
            return true;
        }
        let affine = |args: &[Id]| args.iter().all(|arg| self.is_affine(*arg));
        match graph.node(id) {
            Node::Linear(_, terms) => terms.iter().all(|(c, term)| {
                let of_term = if c.is_negative() { curvature.opposite() } else { curvature };
                self.bends(graph, *term, of_term)
            }),
            Node::Product(factors) => {
                let (constant, moving): (Vec<Id>, Vec<Id>) = factors.iter().partition(|id| !graph.reads(**id).moves());
                let signed = constant.iter().all(|id| graph.sign(*id) != Sign::Unknown);
                signed && matches!(moving[..], [moving] if self.bends(graph, moving, curvature))
            }
            Node::Power(base, exponent) => {
                curvature == Curvature::Convex
                    && exponent.is_integer()
                    && exponent.numerator > 0
                    && exponent.numerator % 2 == 0
                    && affine(&[*base])
            }
            Node::Call(Function::Abs | Function::Hypot | Function::Cosh | Function::Exp | Function::Exp2, args) => {
                curvature == Curvature::Convex && affine(args)
            }
            _ => false,
        }
    }
}
