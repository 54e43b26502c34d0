//! Linear and quadratic functions J of the state that commute with every part Q that the tree of H ends at, and so with H.
//!
//! A step with the tree discrete gradient Σ c·∇Q(m), m the middle of the step, changes J by h Σ c·{J, Q}(m): it keeps what
//! the flow keeps. J is sought among the combinations of a few generators with constant coefficients.

use super::degree::Degrees;
use super::dependence::Dependence;
use super::equations::{Equations, Row, add_multiple};
use super::form::{Expansion, Form, Variable};
use super::generators::{Generator, generators, name};
use super::leaves::leaves;
use crate::ir::{Graph, Id, Ratio};
use crate::parse::Shape;

/// A function of the state that is kept.
#[derive(Debug)]
pub(crate) struct Momentum {
    /// What people call it.
    pub(crate) name: String,
    pub(crate) value: Id,
}

/// All that were found, but for single coordinates: those are kept because H does not read the conjugate one.
pub(super) fn momenta(
    graph: &mut Graph,
    dependence: &Dependence,
    degrees: &Degrees,
    energy: Id,
    coordinates: &Shape,
) -> Vec<Momentum> {
    let generators = generators(coordinates);
    let forms = forms(graph, dependence, degrees, energy);
    let solutions = forms.and_then(|forms| commuting(&moves(&generators, coordinates.len()), &generators, &forms));
    let mut momenta = vec![];
    for solution in solutions.unwrap_or_default() {
        let summands: Vec<&Generator> = solution.keys().map(|g| &generators[*g]).collect();
        if summands.len() > 1 || !summands[0].is_coordinate() {
            let total = solution.values().all(|weight| *weight == Ratio::ONE);
            let zero = graph.zero();
            let weighted = summands.iter().zip(solution.values());
            let value = weighted.fold(zero, |sum, (summand, weight)| summand.add_to(graph, sum, *weight));
            momenta.push(Momentum { name: name(coordinates, &summands, total), value });
        }
    }
    momenta
}

/// The parts that the tree ends at.
fn forms(graph: &Graph, dependence: &Dependence, degrees: &Degrees, energy: Id) -> Option<Vec<Form>> {
    let leaves = leaves(graph, dependence, degrees, energy, 2)?;
    let mut expansion = Expansion::new(graph, degrees);
    leaves.iter().map(|leaf| expansion.leaf(leaf)).collect()
}

/// By variable u the generators J that move it: {u, J} as Σ coefficient·variable.
type Moves = Vec<Vec<(usize, i128, Variable)>>;

fn moves(generators: &[Generator], degrees_of_freedom: usize) -> Moves {
    let mut moves = vec![vec![]; 2 * degrees_of_freedom];
    for (g, generator) in generators.iter().enumerate() {
        for (c, [a, b]) in &generator.terms {
            // {u, a b} = {u, a} b + a {u, b}, and {q, p} = 1 = −{p, q}.
            for (x, rest) in [(*a, *b), (*b, *a)] {
                let (conjugate, sign) = if x % 2 == 0 { (x + 1, -1) } else { (x - 1, 1) };
                if let Some(moves) = moves.get_mut(conjugate as usize) {
                    moves.push((g, sign * c, rest));
                }
            }
        }
    }
    moves
}

/// The combinations of generators whose brackets with all forms vanish, as weights of generators.
fn commuting(moves: &Moves, generators: &[Generator], forms: &[Form]) -> Option<Vec<Row>> {
    let mut equations = Equations::new(generators.len());
    for form in forms {
        let mut bracket = vec![];
        for monomial in form {
            let [a, b] = monomial.variables;
            for (u, rest) in [(a, b), (b, a)] {
                for (g, c, v) in moves.get(u as usize).into_iter().flatten() {
                    let variables = [rest.min(*v), rest.max(*v)];
                    bracket.push(((variables, &monomial.atoms), *g, monomial.number.mul(Ratio::integer(*c))?));
                }
            }
        }
        // Monomials are independent: the coefficient of each vanishes.
        bracket.sort_unstable_by_key(|(monomial, ..)| *monomial);
        for coefficient in bracket.chunk_by(|(a, ..), (b, ..)| a == b) {
            let mut row = Row::new();
            add_multiple(&mut row, Ratio::ONE, coefficient.iter().map(|(_, g, c)| (*g, *c)))?;
            equations.add(row)?;
        }
    }
    equations.solutions()
}
