//! The terms of H that are put together to pieces.

use super::families::piece;
use super::flow::Space;
use super::linear_motion::{is_quadratic, linear_motion, monomials};
use super::products::multiplied_out;
use crate::analyze;
use crate::ir::{Graph, Id, Reads};

/// With more terms than this those that read the same parts of phase space stay together: all subsets are tried.
const MAX_ATOMS: usize = 7;

/// The terms of H. Those that read positions alone, momenta alone or the action alone are never parted; without an action those that are
/// quadratic are parted from the others, or all together where some of them couple; or a term that is in no piece.
pub(super) fn atoms(graph: &mut Graph, energy: Id, space: Space) -> Result<Vec<Id>, Id> {
    let mut open = analyze::terms(graph, energy);
    open.reverse();
    let mut classes = Classes(vec![]);
    while let Some(term) = open.pop() {
        let reads = Reads { t: false, ..graph.reads(term) };
        if reads.kinds() > 1 && piece(graph, term, space).is_none() {
            match distributed(graph, term, space) {
                Some(parts) => {
                    open.extend(parts);
                    continue;
                }
                // Without an action no family needs a term that has no flow of its own, unless another one takes it away.
                None if !space.action && !open.iter().any(|other| is_multiple(graph, term, *other)) => {
                    return Err(term);
                }
                None => {}
            }
        }
        // What moves nothing is in no piece.
        if space.action || reads.state() {
            classes.add(graph, reads, term);
        }
    }
    let mut atoms = vec![];
    if !space.action {
        atoms.extend(classes.take_linear_motion(graph, space));
        classes.part_potential(graph);
    }
    let apart = atoms.len() + classes.apart();
    for (reads, terms) in classes.0 {
        if reads.kinds() > 1 && apart <= MAX_ATOMS {
            atoms.extend(terms);
        } else {
            let together = graph.sum(&terms);
            // What reads one kind alone stays together, unless no rule knows the sum.
            if apart <= MAX_ATOMS && piece(graph, together, space).is_none() {
                atoms.extend(terms);
            } else {
                atoms.push(together);
            }
        }
    }
    Ok(atoms)
}

/// Whether two terms differ by a number alone.
fn is_multiple(graph: &Graph, term: Id, other: Id) -> bool {
    graph.coefficient(term).1 == graph.coefficient(other).1
}

/// What each class of terms reads, and its terms.
struct Classes(Vec<(Reads, Vec<Id>)>);

impl Classes {
    fn add(&mut self, graph: &mut Graph, reads: Reads, term: Id) {
        let class = match self.0.iter().position(|(other, _)| *other == reads) {
            Some(class) => class,
            None => {
                self.0.push((reads, vec![]));
                self.0.len() - 1
            }
        };
        // What powers of sums were taken apart into meets again.
        let (_, terms) = &mut self.0[class];
        match terms.iter_mut().find(|other| is_multiple(graph, term, **other)) {
            Some(other) => *other = graph.add(*other, term),
            None => terms.push(term),
        }
    }

    /// How many atoms there are, if what couples comes apart.
    fn apart(&self) -> usize {
        self.0.iter().map(|(reads, terms)| if reads.kinds() > 1 { terms.len() } else { 1 }).sum()
    }

    /// The quadratic terms, if some of them couple and their flow is known: that is linear, and without an error if they stay together,
    /// however fast it is.
    fn take_linear_motion(&mut self, graph: &mut Graph, space: Space) -> Option<Id> {
        let all: Vec<Id> = self.0.iter().flat_map(|(_, terms)| terms.clone()).collect();
        let (taken, together) = linear_motion(graph, &all, space)?;
        for (_, terms) in &mut self.0 {
            terms.retain(|term| !taken.contains(term));
        }
        self.0.retain(|(_, terms)| !terms.is_empty());
        Some(together)
    }

    /// The quadratic terms of a potential may go with those of the momenta.
    fn part_potential(&mut self, graph: &mut Graph) {
        let potential = Reads { q: true, ..Reads::default() };
        let Some(class) = self.0.iter().position(|(reads, _)| *reads == potential) else { return };
        let terms = self.0[class].1.clone();
        let (bound, rest): (Vec<Id>, Vec<Id>) = terms.into_iter().partition(|term| is_quadratic(graph, *term));
        if !bound.is_empty() && !rest.is_empty() {
            self.0[class].1 = bound;
            self.0.insert(class + 1, (potential, rest));
        }
    }
}

/// A product with a sum that couples, or a power of one, as a sum of products; without an action every polynomial that couples.
fn distributed(graph: &mut Graph, term: Id, space: Space) -> Option<Vec<Id>> {
    multiplied_out(graph, term, |graph, sum| graph.reads(sum).kinds() > 1)
        .or_else(|| if space.action { None } else { monomials(graph, term) })
}
