//! Rigid bodies: H = T(m) + V(r, t) with T quadratic in the momentum of each body? The parts, or the term that is in the way.

use super::separable::{not_quadratic, split};
use super::{Identity, identity, terms};
use crate::diff;
use crate::ir::substitute::Substitution;
use crate::ir::{Graph, Id, Symbol};
use crate::messages::{BODIES_COUPLED, BODY_COUPLED, BODY_NOT_QUADRATIC};

/// H = Σ (½ m·Jm + b·m) + V(r, t).
#[derive(Debug)]
pub(crate) struct Bodies {
    pub(crate) energy: Id,
    pub(crate) kinetic: Id,
    pub(crate) potential: Id,
    /// ∂T/∂m, one a momentum of each body.
    pub(crate) velocity: Vec<[Id; 3]>,
    /// J and b of each body: numbers, and functions of parameters.
    pub(crate) inertia: Vec<Inertia>,
    pub(crate) autonomous: bool,
}

/// T = ½ m·Jm + b·m of one body.
#[derive(Debug)]
pub(crate) struct Inertia {
    pub(crate) inverse: [[Id; 3]; 3],
    pub(crate) constant: [Id; 3],
}

impl Inertia {
    /// Whether the frame of the body is that of its principal axes, and nothing spins in it.
    pub(crate) fn is_principal(&self, graph: &Graph) -> bool {
        let axes = (0..3).flat_map(|i| (0..3).filter(move |j| i != *j).map(move |j| (i, j)));
        axes.into_iter().all(|(i, j)| graph.is_zero(self.inverse[i][j]))
            && self.constant.iter().all(|entry| graph.is_zero(*entry))
    }
}

/// The momenta of a body; the fourth number of a pure quaternion is zero.
pub(crate) fn momenta(body: u32) -> [Symbol; 3] {
    [0, 1, 2].map(|i| Symbol::P(4 * body + i))
}

/// The parts of the energy of so many bodies, or a term and what is wrong with it.
pub(crate) fn bodies(graph: &mut Graph, energy: Id, bodies: u32) -> Result<Bodies, (Id, &'static str)> {
    let (kinetic, potential) = split(graph, energy).map_err(|term| (term, BODY_COUPLED))?;
    if let Some(term) = not_quadratic(graph, kinetic) {
        return Err((term, BODY_NOT_QUADRATIC));
    }
    let slopes = diff::gradient(graph, kinetic, 4 * bodies).p;
    let velocity: Vec<[Id; 3]> = slopes.chunks(4).map(|body| [body[0], body[1], body[2]]).collect();
    let mut inertia = vec![];
    for (velocity, body) in velocity.iter().zip(0..bodies) {
        let others: Vec<Symbol> = (0..bodies).filter(|other| *other != body).flat_map(momenta).collect();
        if depends(graph, velocity, &others) {
            return Err((coupling_term(graph, kinetic, bodies), BODIES_COUPLED));
        }
        let rows = diff::jacobian(graph, velocity, &momenta(body));
        let inverse = core::array::from_fn(|i| core::array::from_fn(|j| at_rest(graph, rows[i][j])));
        inertia.push(Inertia { inverse, constant: velocity.map(|entry| at_rest(graph, entry)) });
    }
    let autonomous = !super::reads(graph, energy).t;
    Ok(Bodies { energy, kinetic, potential, velocity, inertia, autonomous })
}

/// What does not depend on momenta may be taken where they are zero.
fn at_rest(graph: &mut Graph, id: Id) -> Id {
    Substitution::new(|graph: &mut Graph, symbol| matches!(symbol, Symbol::P(_)).then(|| graph.zero())).apply(graph, id)
}

/// Whether velocities, which are linear in momenta, depend on some of them.
fn depends(graph: &mut Graph, velocity: &[Id; 3], momenta: &[Symbol]) -> bool {
    let rows = diff::jacobian(graph, velocity, momenta);
    rows.concat().into_iter().any(|entry| {
        let entry = at_rest(graph, entry);
        !graph.is_zero(entry) && !matches!(identity(graph, entry), Identity::Zero(_))
    })
}

/// The first term of T by which the velocity of a body depends on the momentum of another one.
fn coupling_term(graph: &mut Graph, kinetic: Id, bodies: u32) -> Id {
    let couples = |graph: &mut Graph, term: Id| {
        let slopes = diff::gradient(graph, term, 4 * bodies).p;
        (0..bodies).any(|body| {
            let at = 4 * body as usize;
            let others: Vec<Symbol> = (0..bodies).filter(|other| *other != body).flat_map(momenta).collect();
            depends(graph, &[slopes[at], slopes[at + 1], slopes[at + 2]], &others)
        })
    };
    terms(graph, kinetic).into_iter().find(|term| couples(graph, *term)).unwrap_or(kinetic)
}
