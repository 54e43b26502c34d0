//! Atoms: the parts of H that the search for pieces combines and never separates.

use super::families::piece;
use super::flow::Space;
use super::linear_motion::{is_of_degree, linear_motion, monomials};
use super::products::multiplied_out;
use crate::analyze;
use crate::ir::{Graph, Id, Reads};

/// The largest number of atoms for which coupling terms stay separate. The search tries all subsets of atoms.
const MAX_ATOMS: usize = 7;

/// Returns the atoms of H, or a term that belongs to no piece as the error.
///
/// Terms that read only positions, only momenta or only the action form one atom for each kind. Without an action, the quadratic terms of the
/// potential form their own atom. If quadratic terms couple positions and momenta, all quadratic terms form one atom.
pub(super) fn atoms(graph: &mut Graph, energy: Id, space: Space) -> Result<Vec<Id>, Id> {
    let mut open = analyze::terms(graph, energy);
    open.reverse();
    let mut classes = Classes(vec![]);
    while let Some(term) = open.pop() {
        let reads = Reads { t: false, ..graph.reads(term) };
        if reads.kinds() > 1 && piece(graph, term, space).is_none() {
            match expanded(graph, term, space) {
                Some(parts) => {
                    open.extend(parts);
                    continue;
                }
                // Without an action, every family splits into terms with flows of their own. Only a term that cancels this term could help.
                None if !space.action && !open.iter().any(|other| is_multiple(graph, term, *other)) => {
                    return Err(term);
                }
                None => {}
            }
        }
        // Without an action, constant terms move nothing and belong to no piece.
        if space.action || reads.state() {
            classes.add(graph, reads, term);
        }
    }
    let mut atoms = vec![];
    if !space.action {
        atoms.extend(classes.take_linear_motion(graph, space));
        classes.separate_quadratic_potential(graph);
    }
    let few = atoms.len() + classes.count_if_coupling_terms_separate() <= MAX_ATOMS;
    for Class { reads, terms } in classes.0 {
        if few && reads.kinds() > 1 {
            atoms.extend(terms);
            continue;
        }
        let together = graph.sum(&terms);
        // Terms of one kind stay together, unless no family knows the flow of their sum.
        if few && piece(graph, together, space).is_none() {
            atoms.extend(terms);
        } else {
            atoms.push(together);
        }
    }
    Ok(atoms)
}

/// Returns whether two terms differ only by a numerical factor.
fn is_multiple(graph: &Graph, term: Id, other: Id) -> bool {
    graph.coefficient(term).1 == graph.coefficient(other).1
}

/// Terms that read the same kinds of coordinates.
struct Class {
    reads: Reads,
    terms: Vec<Id>,
}

struct Classes(Vec<Class>);

impl Classes {
    /// Adds a term. Terms that differ by a number are merged: expanded powers of sums produce them.
    fn add(&mut self, graph: &mut Graph, reads: Reads, term: Id) {
        let Some(class) = self.0.iter_mut().find(|class| class.reads == reads) else {
            self.0.push(Class { reads, terms: vec![term] });
            return;
        };
        match class.terms.iter_mut().find(|other| is_multiple(graph, term, **other)) {
            Some(other) => *other = graph.add(*other, term),
            None => class.terms.push(term),
        }
    }

    /// Returns the number of atoms if every coupling term is an atom and every other class is one atom.
    fn count_if_coupling_terms_separate(&self) -> usize {
        self.0.iter().map(|class| if class.reads.kinds() > 1 { class.terms.len() } else { 1 }).sum()
    }

    /// Removes the quadratic terms and returns their sum, if some of them couple and their flow is known. As one piece, linear motion has
    /// no splitting error.
    fn take_linear_motion(&mut self, graph: &mut Graph, space: Space) -> Option<Id> {
        let all: Vec<Id> = self.0.iter().flat_map(|class| class.terms.clone()).collect();
        let taken = linear_motion(graph, &all, space)?;
        for class in &mut self.0 {
            class.terms.retain(|term| !taken.terms.contains(term));
        }
        self.0.retain(|class| !class.terms.is_empty());
        Some(taken.energy)
    }

    /// Separates the quadratic terms of the potential, so that they can join the kinetic energy.
    fn separate_quadratic_potential(&mut self, graph: &mut Graph) {
        let potential = Reads { q: true, ..Reads::default() };
        let Some(i) = self.0.iter().position(|class| class.reads == potential) else { return };
        let (quadratic, others): (Vec<Id>, Vec<Id>) =
            self.0[i].terms.iter().partition(|term| is_of_degree(graph, **term, 2));
        if !quadratic.is_empty() && !others.is_empty() {
            self.0[i].terms = quadratic;
            self.0.insert(i + 1, Class { reads: potential, terms: others });
        }
    }
}

/// Expands a product with a sum that couples, or with a power of the sum. Without an action, expands every polynomial.
fn expanded(graph: &mut Graph, term: Id, space: Space) -> Option<Vec<Id>> {
    multiplied_out(graph, term, |graph, sum| graph.reads(sum).kinds() > 1)
        .or_else(|| if space.action { None } else { monomials(graph, term) })
}
