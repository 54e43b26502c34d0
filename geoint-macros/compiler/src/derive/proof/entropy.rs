//! Proofs about x' = L(x) ∇E + M(x) ∇S, and its flow: friction M keeps the energy E, and the structure L keeps the entropy S.

use super::flow::{Flow, Named, Origin, coordinates};
use crate::analyze::{self, Damping, Identity, claims};
use crate::diff;
use crate::diff::equations::{checked_damping, times};
use crate::diff::flow::Conserved;
use crate::ir::{Graph, Id};
use crate::lower::{self, Place};

/// The entropy of a system, with proofs.
#[derive(Debug)]
pub(crate) struct Entropy {
    pub(crate) value: Id,
    pub(crate) place: Place,
    /// M. `None` if it is zero.
    pub(crate) friction: Option<Damping>,
    /// Ok if L ∇S = 0. Errors: the first row that is not zero, and the result of the test.
    pub(crate) of_structure: Result<(), (usize, Identity)>,
    /// Ok if M ∇E = 0. Errors: the first row that is not zero, and the result of the test.
    pub(crate) of_friction: Result<(), (usize, Identity)>,
}

/// Decides whether the entropy is a Casimir of L, and the energy one of M.
pub(crate) fn entropy(graph: &mut Graph, energy: Id, structure: &[Vec<Id>], written: lower::Entropy) -> Entropy {
    let lower::Entropy { value, place, friction } = written;
    let x = coordinates(structure.len());
    Entropy {
        value,
        place,
        of_structure: claims::is_casimir(graph, &x, structure, value),
        of_friction: claims::is_casimir(graph, &x, &friction, energy),
        friction: analyze::damping(graph, Some(friction)).map(|friction| Damping { name: "friction", ..friction }),
    }
}

impl Flow {
    /// Creates the flow x' = L ∇E + M ∇S, which keeps E unless E reads time.
    pub(crate) fn of_entropy(
        graph: &mut Graph,
        energy: Id,
        structure: &[Vec<Id>],
        entropy: Id,
        friction: &Damping,
    ) -> Flow {
        let mut flow = Flow::structured(graph, energy, structure, None);
        let n = structure.len();
        // An entry is NaN at run time where M is not positive semidefinite.
        let mut row = |i| (0..n).map(|j| checked_damping(graph, &friction.matrix, i, j)).collect();
        let friction: Vec<Vec<Id>> = (0..n).map(&mut row).collect();
        let slopes = diff::gradient(graph, entropy, n as u32).q;
        let rates = times(graph, &friction, &slopes);
        for (f, rate) in flow.field.iter_mut().zip(&rates) {
            *f = graph.add(*f, *rate);
        }
        flow.entropy = Some(diff::entropy::step(graph, energy, structure, entropy, &friction));
        let conserved = Conserved { value: entropy, but: Some(rates) };
        flow.kept.push(Named { name: "entropy".into(), conserved, origin: Origin::Entropy });
        flow
    }
}
