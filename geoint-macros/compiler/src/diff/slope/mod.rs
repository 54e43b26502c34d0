//! Divided differences f[a, b] = (f(b) − f(a))/(b − a) of every operation, in closed form.
//!
//! A node has a value at both ends of a step, and an increment. Its rule gives coefficients c, called slopes, with Δnode = Σ c·Δoperand exactly. A
//! reverse sweep over them gives the tree discrete gradient. It is symmetric in both ends, equals the gradient if the ends coincide, and is free of
//! cancellation and of 0/0. If a denominator or the argument of a logarithm changes its sign during the step, the slope is NaN.
//!
//! W. Kahan & R. Fateman, SIGSAM Bulletin 33 (1999) 7; T. Matsubara, A. Ishikawa & T. Yaguchi, NeurIPS 2020.

mod branch;
mod ends;
mod function;
mod power;

use super::sweep::{Entries, Step, reverse};
use crate::ir::{Graph, Id, Node};
pub(super) use ends::Slopes;
pub(crate) use ends::{coordinate_at_end, coordinate_in_middle};

impl Slopes {
    /// Computes the tree discrete gradient of `root`.
    pub(super) fn gradient(&mut self, graph: &mut Graph, root: Id) -> Entries {
        reverse(graph, root, &mut |graph, id| self.step(graph, id))
    }

    /// The slopes of a node with respect to its operands, or directly to the coordinates.
    fn step(&mut self, graph: &mut Graph, id: Id) -> Step {
        Step::Operands(match graph.node(id).clone() {
            Node::Number(_)
            | Node::Symbol(_)
            | Node::Compare(..)
            | Node::And(..)
            | Node::Or(..)
            | Node::Not(_)
            | Node::Truth(_) => vec![],
            Node::Linear(_, terms) => terms.into_iter().map(|(c, term)| (term, graph.number(c))).collect(),
            Node::Product(factors) => self.product(graph, factors),
            Node::Power(base, exponent) => {
                let end = self.end(graph, base);
                vec![(base, power::slope(graph, base, end, exponent))]
            }
            Node::Call(function, args) => self.function(graph, id, function, &args),
            Node::Select(..) => return Step::Coordinates(self.branch(graph, id)),
        })
    }

    /// (f g)[a, b] = f[a, b]·mean(g) + mean(f)·g[a, b], applied factor by factor.
    fn product(&mut self, graph: &mut Graph, factors: Vec<Id>) -> Vec<(Id, Id)> {
        let one = graph.integer(1);
        let (mut before, mut slopes) = (one, Vec::<(Id, Id)>::new());
        for factor in factors {
            let mean = self.mean(graph, factor);
            let own = if slopes.is_empty() { one } else { self.mean(graph, before) };
            for (_, slope) in &mut slopes {
                *slope = graph.mul(*slope, mean);
            }
            slopes.push((factor, own));
            before = graph.mul(before, factor);
        }
        slopes
    }
}
