//! Linear and quadratic functions J of the state that commute with H, such as momenta and angular momenta.
//!
//! H is a function of quadratic expressions Q, the leaves of its tree: in p²/2m − k/√(q·q) these are p² and q·q. At worst the leaves are single coordinates. J is
//! sought among the functions that commute with every leaf, so J commutes with H.
//!
//! Discrete-gradient steps keep J, too: the discrete gradient of the tree is Σ c·∇Q(m), with numbers c and the midpoint m of the step. J is at most quadratic, so
//! a step changes J by exactly h Σ c·{J, Q}(m) = 0.
//!
//! J is a linear combination of generators: polynomials of degree 1 or 2 that have a usual name, such as pₓ or x p_y − y p_x. Coefficients are numbers, or numbers
//! times a weight, a product of powers of parameters. For each generator one weight is
//! tried beside 1: the weight by which its bracket can cancel brackets of other generators. This keeps the linear equations small. An integral with
//! other coefficients is not found.
//!
//! In lists of variables, 2i and 2i + 1 are qᵢ and pᵢ, and the last variable is the constant 1.

use super::generators::{Generator, Summand, generators, name};
use super::weights::{Term, Weight, divide_by_common, weights};
use crate::analyze::degree::Degrees;
use crate::analyze::equations::{Equations, Row, add_multiple};
use crate::analyze::leaves::leaves;
use crate::analyze::quadratic::{Atom, Expansion, Quadratic, Variable, product_of_atoms};
use crate::ir::{Graph, Id, Ratio, Reads};
use crate::parse::Shape;
use std::collections::BTreeMap;

/// A conserved function of the state, linear or quadratic.
#[derive(Debug)]
pub(crate) struct Conserved {
    /// The usual name of the function.
    pub(crate) name: String,
    pub(crate) value: Id,
}

/// A generator with a product of parameters as its weight. The linear equations determine its coefficient, a number.
struct Unknown {
    generator: usize,
    weight: Weight,
}

/// Finds conserved functions. Single coordinates are left out: the report states them as coordinates whose conjugate H does not read.
pub(in crate::analyze) fn momenta(
    graph: &mut Graph,
    degrees: &Degrees,
    energy: Id,
    coordinates: &Shape,
) -> Vec<Conserved> {
    of_generators(graph, degrees, energy, coordinates, &generators(coordinates))
}

/// Finds the conserved functions that are combinations of some generators.
pub(super) fn of_generators(
    graph: &mut Graph,
    degrees: &Degrees,
    energy: Id,
    coordinates: &Shape,
    generators: &[Generator],
) -> Vec<Conserved> {
    let found = quadratics(graph, degrees, energy).and_then(|quadratics| {
        let brackets = brackets(&brackets_of_variables(generators, coordinates.len()), &quadratics)?;
        // Weights must be constant, so they must read parameters only.
        let steady = |atom: &Atom| match atom {
            Atom::Node(id) => graph.reads(*id) == Reads::default(),
            _ => true,
        };
        let mut unknowns: Vec<Unknown> =
            (0..generators.len()).map(|generator| Unknown { generator, weight: vec![] }).collect();
        for (generator, weight) in weights(generators.len(), &brackets, steady).into_iter().enumerate() {
            if !weight.is_empty() {
                unknowns.push(Unknown { generator, weight });
            }
        }
        let solutions = commuting(&unknowns, generators.len(), &brackets)?;
        Some((unknowns, solutions))
    });
    let Some((unknowns, solutions)) = found else { return vec![] };

    // The solutions are a reduced basis, so each conserved coordinate is a solution with one entry.
    let single_coordinate = |solution: &Row| match solution.keys().collect::<Vec<_>>()[..] {
        [u] => generators[unknowns[*u].generator].coordinate(),
        _ => None,
    };
    let conserved_coordinates: Vec<Variable> = solutions.iter().filter_map(single_coordinate).collect();
    let mut momenta = vec![];
    for solution in &solutions {
        let mut weights: Vec<Weight> = solution.keys().map(|u| unknowns[*u].weight.clone()).collect();
        divide_by_common(&mut weights);
        let summands: Vec<Summand<'_>> = solution
            .iter()
            .zip(&weights)
            .map(|((u, number), weight)| Summand {
                generator: &generators[unknowns[*u].generator],
                number: *number,
                weight,
            })
            .collect();
        // Functions of conserved coordinates give no new conserved function.
        if summands.iter().all(|summand| summand.generator.is_function_of(&conserved_coordinates)) {
            continue;
        }
        let zero = graph.zero();
        let value = summands.iter().fold(zero, |sum, summand| {
            let weight = weight_node(graph, summand.weight);
            summand.generator.add_to(graph, sum, summand.number, weight)
        });
        // After the division, solutions that differ by a parameter as a factor have equal values.
        if momenta.iter().all(|known: &Conserved| known.value != value) {
            momenta.push(Conserved { name: name(coordinates, &summands), value });
        }
    }
    momenta
}

/// Builds a product of powers of parameters.
fn weight_node(graph: &mut Graph, weight: &Weight) -> Id {
    let mut product = graph.integer(1);
    for (atom, exponent) in weight {
        let base = atom.node(graph);
        let power = graph.pow(base, Ratio::integer(*exponent));
        product = graph.mul(product, power);
    }
    product
}

/// Expands the leaves of the tree of H, which are polynomials of degree 2 at most. `None` if a rational number overflows; then no function is found.
fn quadratics(graph: &Graph, degrees: &Degrees, energy: Id) -> Option<Vec<Quadratic>> {
    let leaves = leaves(graph, degrees, energy, 2)?;
    let mut expansion = Expansion::new(graph, degrees);
    leaves.iter().map(|leaf| expansion.leaf(leaf)).collect()
}

/// A term of the bracket {u, J} of a variable u with a generator J: `coefficient·variable`.
#[derive(Clone)]
struct BracketTerm {
    generator: usize,
    coefficient: i128,
    variable: Variable,
}

/// Returns the terms of {u, J} for all generators J, by the variable u.
fn brackets_of_variables(generators: &[Generator], degrees_of_freedom: usize) -> Vec<Vec<BracketTerm>> {
    let mut terms = vec![vec![]; 2 * degrees_of_freedom];
    for (g, generator) in generators.iter().enumerate() {
        for (c, [a, b]) in &generator.terms {
            // {u, a b} = {u, a} b + a {u, b}, and {q, p} = 1 = −{p, q}.
            for (x, variable) in [(*a, *b), (*b, *a)] {
                let (conjugate, sign) = if x % 2 == 0 { (x + 1, -1) } else { (x - 1, 1) };
                // The constant has no conjugate: its number is out of range.
                if let Some(terms) = terms.get_mut(conjugate as usize) {
                    terms.push(BracketTerm { generator: g, coefficient: sign * c, variable });
                }
            }
        }
    }
    terms
}

/// Returns the brackets of all generators with each quadratic expression, sorted by variables. `None` if a rational number overflows.
fn brackets<'a>(of_variables: &[Vec<BracketTerm>], quadratics: &'a [Quadratic]) -> Option<Vec<Vec<Term<'a>>>> {
    let of = |quadratic: &'a Quadratic| {
        let mut bracket = vec![];
        for monomial in quadratic {
            let [a, b] = monomial.variables;
            for (u, rest) in [(a, b), (b, a)] {
                for BracketTerm { generator, coefficient, variable } in
                    of_variables.get(u as usize).into_iter().flatten()
                {
                    let variables = [rest.min(*variable), rest.max(*variable)];
                    let number = monomial.number.mul(Ratio::integer(*coefficient))?;
                    bracket.push(Term { variables, generator: *generator, atoms: &monomial.atoms, number });
                }
            }
        }
        bracket.sort_by_key(|term: &Term<'_>| term.variables);
        Some(bracket)
    };
    quadratics.iter().map(of).collect()
}

/// Returns a reduced basis of the combinations of unknowns whose brackets with all quadratic expressions vanish.
fn commuting(unknowns: &[Unknown], generators: usize, brackets: &[Vec<Term<'_>>]) -> Option<Vec<Row>> {
    let mut of_generator = vec![vec![]; generators];
    for (number, Unknown { generator, weight }) in unknowns.iter().enumerate() {
        of_generator[*generator].push((number, weight));
    }
    let mut equations = Equations::new(unknowns.len());
    for bracket in brackets {
        // The coefficient of each monomial must vanish. Relations between atoms, such as sin² + cos² = 1, are not used: J may be missed, never wrong.
        let mut coefficients: BTreeMap<([Variable; 2], Weight), Row> = BTreeMap::new();
        for Term { variables, generator, atoms, number } in bracket {
            for (unknown, weight) in &of_generator[*generator] {
                let coefficient = coefficients.entry((*variables, product_of_atoms(atoms, weight)?)).or_default();
                add_multiple(coefficient, Ratio::ONE, [(*unknown, *number)])?;
            }
        }
        for coefficient in coefficients.into_values() {
            equations.add(coefficient)?;
        }
    }
    equations.solutions()
}
