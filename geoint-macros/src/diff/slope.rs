//! Divided differences f[a, b] = (f(b) − f(a))/(b − a) of every operation, in closed form.
//!
//! A node has a value at both ends of a step and an increment; its rule gives coefficients c with
//! Δnode = Σ c·Δoperand, exactly. Swept in reverse these are the tree discrete gradient: symmetric in both ends, the
//! gradient where they meet, and without cancellation or 0/0.

use super::rules::Rule;
use crate::ir::substitute::Substitution;
use crate::ir::{Function, Graph, HashMap, Id, Node, Number, Ratio, Symbol};

/// A term that has no divided difference yet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct MissingSlope(pub(crate) Id);

type Replace = fn(&mut Graph, Symbol) -> Option<Id>;

/// Divided differences between (q, p) and (q + dq, p + dp).
pub(super) struct Slopes {
    end: Substitution<Replace>,
    affine_increments: HashMap<Id, Option<Id>>,
    increments: HashMap<Id, Id>,
}

impl Default for Slopes {
    fn default() -> Self {
        let end: Replace = |graph, symbol| {
            let increment = increment_of(graph, symbol)?;
            let start = graph.symbol(symbol);
            Some(graph.add(start, increment))
        };
        Slopes { end: Substitution::new(end), affine_increments: HashMap::default(), increments: HashMap::default() }
    }
}

fn increment_of(graph: &mut Graph, symbol: Symbol) -> Option<Id> {
    match symbol {
        Symbol::Q(i) => Some(graph.symbol(Symbol::Dq(i))),
        Symbol::P(i) => Some(graph.symbol(Symbol::Dp(i))),
        _ => None,
    }
}

impl Slopes {
    /// The slopes of a node with respect to its operands.
    pub(super) fn rule(&mut self, graph: &mut Graph, id: Id) -> Result<Rule, MissingSlope> {
        let missing = Err(MissingSlope(id));
        Ok(Rule::Chain(match graph.node(id).clone() {
            Node::Number(_) | Node::Symbol(_) => vec![],
            Node::Linear(_, terms) => terms.into_iter().map(|(c, term)| (term, graph.number(c))).collect(),
            // (f g)[a, b] = f[a, b]·mean(g) + mean(f)·g[a, b], factor after factor.
            Node::Product(factors) => {
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
            Node::Power(base, exponent) => {
                let (a, b) = (base, self.end(graph, base));
                vec![(base, power_slope(graph, a, b, exponent))]
            }
            Node::Call(function, args) => {
                let x = args[0];
                let slope = match function {
                    // cos m·sinc(Δ/2) and −sin m·sinc(Δ/2) with the mean m.
                    Function::Sin | Function::Cos => {
                        let (mean, increment) = (self.mean(graph, x), self.increment(graph, x)?);
                        let half = graph.scale(Number::HALF, increment);
                        let sinc = graph.call(Function::Sinc, &[half]);
                        let other = if function == Function::Sin { Function::Cos } else { Function::Sin };
                        let value = graph.call(other, &[mean]);
                        let slope = graph.mul(value, sinc);
                        if function == Function::Sin { slope } else { graph.neg(slope) }
                    }
                    Function::Exp => {
                        let end = self.end(graph, x);
                        graph.call(Function::ExpSlope, &[x, end])
                    }
                    Function::Ln => {
                        let end = self.end(graph, x);
                        graph.call(Function::LnSlope, &[x, end])
                    }
                    _ => return missing,
                };
                vec![(x, slope)]
            }
            Node::Select(..) | Node::Compare(..) | Node::And(..) | Node::Or(..) | Node::Not(_) | Node::Truth(_) => {
                return missing;
            }
        }))
    }

    /// The value at the end of the step.
    fn end(&mut self, graph: &mut Graph, id: Id) -> Id {
        match self.affine_increment(graph, id) {
            Some(increment) => graph.add(id, increment),
            None => self.end.apply(graph, id),
        }
    }

    /// (start + end)/2.
    fn mean(&mut self, graph: &mut Graph, id: Id) -> Id {
        match self.affine_increment(graph, id) {
            Some(increment) => {
                let half = graph.scale(Number::HALF, increment);
                graph.add(id, half)
            }
            None => {
                let end = self.end(graph, id);
                let sum = graph.add(id, end);
                graph.scale(Number::HALF, sum)
            }
        }
    }

    /// end − start, from the increments of the coordinates: never a difference of two values.
    fn increment(&mut self, graph: &mut Graph, id: Id) -> Result<Id, MissingSlope> {
        if let Some(increment) = self.affine_increment(graph, id).or_else(|| self.increments.get(&id).copied()) {
            return Ok(increment);
        }
        let Rule::Chain(slopes) = self.rule(graph, id)? else { return Err(MissingSlope(id)) };
        let mut parts = vec![];
        for (operand, slope) in slopes {
            let increment = self.increment(graph, operand)?;
            parts.push(graph.mul(slope, increment));
        }
        let increment = graph.sum(&parts);
        self.increments.insert(id, increment);
        Ok(increment)
    }

    /// The increment of a node that is affine in the coordinates; it does not depend on where the step starts.
    fn affine_increment(&mut self, graph: &mut Graph, id: Id) -> Option<Id> {
        if let Some(known) = self.affine_increments.get(&id) {
            return *known;
        }
        let increment = match graph.node(id).clone() {
            Node::Symbol(symbol) => Some(increment_of(graph, symbol).unwrap_or_else(|| graph.zero())),
            Node::Linear(_, terms) => terms
                .into_iter()
                .map(|(c, term)| self.affine_increment(graph, term).map(|increment| graph.scale(c, increment)))
                .collect::<Option<Vec<_>>>()
                .map(|parts| graph.sum(&parts)),
            node => {
                let constant = node.children().iter().all(|child| {
                    self.affine_increment(graph, *child).is_some_and(|increment| graph.is_zero(increment))
                });
                constant.then(|| graph.zero())
            }
        };
        self.affine_increments.insert(id, increment);
        increment
    }
}

/// (xʳ)[a, b].
fn power_slope(graph: &mut Graph, a: Id, b: Id, exponent: Ratio) -> Id {
    if exponent.is_integer() {
        return integer_slope(graph, a, b, exponent.numerator);
    }
    // xᵐᐟ² = (√x)ᵐ and √[a, b] = 1/(√a + √b).
    let (a, b) = (graph.sqrt(a), graph.sqrt(b));
    let sum = graph.add(a, b);
    let slope = integer_slope(graph, a, b, exponent.numerator);
    graph.div(slope, sum)
}

/// (xⁿ)[a, b].
fn integer_slope(graph: &mut Graph, a: Id, b: Id, n: i64) -> Id {
    if n < 0 {
        // −(x⁻ⁿ)[a, b]/(ab)⁻ⁿ
        let slope = integer_slope(graph, a, b, -n);
        let ab = graph.mul(a, b);
        let power = graph.pow(ab, Ratio::integer(n));
        let product = graph.mul(slope, power);
        return graph.neg(product);
    }
    match n {
        0 => graph.zero(),
        1 => graph.integer(1),
        n if n % 2 == 0 => {
            // (xᵐ)[a, b]·(aᵐ + bᵐ), m = n/2
            let half = Ratio::integer(n / 2);
            let slope = integer_slope(graph, a, b, n / 2);
            let (am, bm) = (graph.pow(a, half), graph.pow(b, half));
            let sum = graph.add(am, bm);
            graph.mul(slope, sum)
        }
        n => {
            let terms: Vec<Id> = (0..n)
                .map(|i| {
                    let (first, second) = (graph.pow(a, Ratio::integer(i)), graph.pow(b, Ratio::integer(n - 1 - i)));
                    graph.mul(first, second)
                })
                .collect();
            graph.sum(&terms)
        }
    }
}
