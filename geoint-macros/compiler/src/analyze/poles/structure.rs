//! The zeros of a node, from its form: where they are those of smaller nodes, and how they are excluded on a straight line.

use super::super::degree::Degrees;
use crate::ir::{Function, Graph, HashMap, Id, Node, Number, Ratio, Sign, Symbol};
use std::collections::{BTreeSet, HashSet};

/// A test that excludes zeros on a straight line, from values at both of its ends.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Quick {
    /// Affine forms that vanish together. Not if the vectors a and b of their values at both ends have a·b > 0: a + τ(b − a) is zero
    /// only if a and b are opposite. That holds if the signs of parameters are as assumed.
    Forms(Vec<Id>, Signs),
    /// A sine or cosine, and its argument, which is affine: not if it has the same sign at both ends, and the argument moves by less than
    /// π.
    Angle { value: Id, argument: Id },
    /// The sine of a multiple of an affine argument, which has the same zeros, before it is built.
    SineOf(Number, Id),
}

impl Quick {
    /// Whether the test compares signs of a node itself.
    pub(super) fn is_sign_of(&self, id: Id) -> bool {
        match self {
            Quick::Forms(forms, _) => forms[..] == [id],
            Quick::Angle { value, .. } => *value == id,
            Quick::SineOf(..) => false,
        }
    }

    /// The test with the sine built.
    pub(super) fn build(&mut self, graph: &mut Graph) {
        if let Quick::SineOf(multiple, argument) = *self {
            let argument = graph.scale(multiple, argument);
            *self = Quick::Angle { value: graph.call(Function::Sin, &[argument]), argument };
        }
    }
}

/// Signs of nodes that read parameters alone.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Signs {
    pub(crate) positive: Vec<Id>,
    pub(crate) not_negative: Vec<Id>,
}

impl Signs {
    fn join(&mut self, other: Signs) {
        self.positive.extend(other.positive);
        self.not_negative.extend(other.not_negative);
    }
}

/// Finds zeros.
pub(super) struct Zeros {
    /// In coordinates and time.
    degrees: Degrees,
}

/// Where a node is 1.
enum One {
    /// Where another one vanishes.
    At(Id),
    /// Where the sine of a multiple of another one vanishes.
    Periodic(Number, Id),
}

/// Forms that vanish together, under assumptions.
type Forms = Option<(BTreeSet<Id>, Signs)>;

impl Zeros {
    pub(super) fn new(graph: &Graph, terms: &[Id]) -> Self {
        let degrees = Degrees::of(graph, terms, |symbol| symbol.is_coordinate() || symbol == Symbol::Time);
        Zeros { degrees }
    }

    /// Nodes of which one vanishes where `root` does, those left out that do not move.
    pub(super) fn of(&self, graph: &Graph, root: Id) -> Vec<(Id, Option<Quick>)> {
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
                    zeros.push((id, Some(Quick::Angle { value: id, argument: args[0] })));
                }
                // c − c·f vanishes where f is 1.
                Node::Linear(constant, terms)
                    if terms.len() == 1 && constant.neg() == terms[0].0 && !self.is_affine(id) =>
                {
                    match self.where_one(graph, terms[0].1) {
                        Some(One::At(argument)) => open.push(argument),
                        Some(One::Periodic(multiple, argument)) => {
                            zeros.push((id, Some(Quick::SineOf(multiple, argument))))
                        }
                        None => zeros.push((id, None)),
                    }
                }
                _ => {
                    let forms = self.forms(graph, id, &mut HashMap::default());
                    zeros.push((id, forms.map(|(forms, signs)| Quick::Forms(forms.into_iter().collect(), signs))));
                }
            }
        }
        zeros
    }

    /// Where a node is 1.
    fn where_one(&self, graph: &Graph, id: Id) -> Option<One> {
        use Function::{Cos, Cosh, Exp, Exp2};
        match graph.node(id) {
            Node::Call(Cosh | Exp | Exp2, args) => Some(One::At(args[0])),
            Node::Call(Cos, args) if self.is_affine(args[0]) => Some(One::Periodic(Number::HALF, args[0])),
            // cos² = 1 where the sine vanishes.
            Node::Power(base, exponent) if *exponent == Ratio::integer(2) => match graph.node(*base) {
                Node::Call(Cos, args) if self.is_affine(args[0]) => Some(One::Periodic(Number::ONE, args[0])),
                Node::Call(Cosh, args) => Some(One::At(args[0])),
                _ => None,
            },
            _ => None,
        }
    }

    /// Affine forms that all vanish where `id` does, if parameters have certain signs. `known` are those of other nodes.
    fn forms(&self, graph: &Graph, id: Id, known: &mut HashMap<Id, Forms>) -> Forms {
        if let Some(known) = known.get(&id) {
            return known.clone();
        }
        let forms = self.new_forms(graph, id, known);
        known.insert(id, forms.clone());
        forms
    }

    fn new_forms(&self, graph: &Graph, id: Id, known: &mut HashMap<Id, Forms>) -> Forms {
        if self.is_affine(id) {
            return Some((BTreeSet::from([id]), Signs::default()));
        }
        // Where a sum vanishes whose summands are nowhere negative, all of them do.
        let mut together = |parts: &[Id]| {
            let (mut forms, mut signs) = (BTreeSet::new(), Signs::default());
            for part in parts {
                let (others, assumed) = self.forms(graph, *part, known)?;
                forms.extend(others);
                signs.join(assumed);
            }
            Some((forms, signs))
        };
        match graph.node(id) {
            Node::Linear(constant, terms) => {
                if constant.is_negative() || terms.iter().any(|(c, _)| c.is_negative()) {
                    return None;
                }
                let (constant, moving): (Vec<Id>, Vec<Id>) =
                    terms.iter().map(|(_, term)| term).partition(|id| !graph.reads(**id).moves());
                let (forms, mut signs) =
                    moving.iter().all(|id| self.is_square(graph, *id)).then(|| together(&moving))??;
                signs.not_negative.extend(constant.iter().filter(|id| graph.sign(**id) == Sign::Unknown));
                Some((forms, signs))
            }
            Node::Product(factors) => {
                let (constant, moving): (Vec<Id>, Vec<Id>) = factors.iter().partition(|id| !graph.reads(**id).moves());
                let [moving] = moving[..] else { return None };
                let (forms, mut signs) = together(&[moving])?;
                signs.positive.extend(constant);
                Some((forms, signs))
            }
            Node::Power(base, exponent) if exponent.numerator > 0 => together(&[*base]),
            Node::Call(Function::Abs | Function::Hypot, args) => together(args),
            _ => None,
        }
    }

    /// Whether a node is nowhere negative if its constant factors are not.
    fn is_square(&self, graph: &Graph, id: Id) -> bool {
        match graph.node(id) {
            Node::Product(factors) => factors.iter().all(|id| !graph.reads(*id).moves() || self.is_square(graph, *id)),
            _ => graph.sign(id) != Sign::Unknown,
        }
    }

    pub(super) fn is_affine(&self, id: Id) -> bool {
        self.degrees.get(id).is_some_and(|degree| degree <= 1)
    }

    /// Whether a node may be negative between two points at which it is not.
    pub(super) fn has_gap(&self, graph: &Graph, id: Id) -> bool {
        graph.sign(id) == Sign::Unknown && graph.reads(id).moves() && !self.is_concave(graph, id)
    }

    /// Whether a node is concave by its form: between two points it is not below the smaller of its values there.
    pub(super) fn is_concave(&self, graph: &Graph, id: Id) -> bool {
        self.bends(graph, id, true)
    }

    /// Whether a node is concave, or else convex, by its form.
    fn bends(&self, graph: &Graph, id: Id, concave: bool) -> bool {
        if self.is_affine(id) {
            return true;
        }
        let affine = |args: &[Id]| args.iter().all(|arg| self.is_affine(*arg));
        match graph.node(id) {
            Node::Linear(_, terms) => {
                terms.iter().all(|(c, term)| self.bends(graph, *term, concave != c.is_negative()))
            }
            Node::Product(factors) => {
                let (constant, moving): (Vec<Id>, Vec<Id>) = factors.iter().partition(|id| !graph.reads(**id).moves());
                let signed = constant.iter().all(|id| graph.sign(*id) != Sign::Unknown);
                signed && matches!(moving[..], [moving] if self.bends(graph, moving, concave))
            }
            Node::Power(base, exponent) => {
                !concave
                    && exponent.is_integer()
                    && exponent.numerator > 0
                    && exponent.numerator % 2 == 0
                    && affine(&[*base])
            }
            Node::Call(Function::Abs | Function::Hypot | Function::Cosh | Function::Exp | Function::Exp2, args) => {
                !concave && affine(args)
            }
            _ => false,
        }
    }
}
