//! Rigid bodies: splits H = T(m) + V(r, t), or T(m) + T(p) + V(r, q, t) with centres of mass, into its parts. T must be quadratic in the momentum of
//! each body and of the centres. Otherwise the term that prevents the split is returned.

use super::separable::{Separated, is_momentum, not_quadratic, split};
use super::{identity, terms};
use crate::diff;
use crate::ir::substitute::at_zero;
use crate::ir::{Graph, Id, Symbol};
use crate::messages::{BODIES_COUPLED, BODY_COUPLED, BODY_NOT_QUADRATIC, CENTRES_COUPLED};

/// The energy Σ (½ m·Jm + b·m) + T(p) + V(r, q, t), with a polynomial T of degree 2.
#[derive(Debug)]
pub(crate) struct Bodies {
    pub(crate) energy: Id,
    pub(crate) kinetic: Id,
    pub(crate) potential: Id,
    /// ∂T/∂m of each body, then ∂T/∂p of each centre of mass.
    pub(crate) velocity: Vec<[Id; 3]>,
    /// J and b of each body.
    pub(crate) inertia: Vec<Inertia>,
    /// M⁻¹ of the centres of mass.
    pub(crate) inverse_mass: Vec<Vec<Id>>,
    /// ∂T/∂p at zero momenta.
    pub(crate) streaming: Vec<Id>,
    pub(crate) autonomous: bool,
}

/// T = ½ m·Jm + b·m of one body. The entries are numbers or functions of parameters.
#[derive(Debug)]
pub(crate) struct Inertia {
    /// J.
    pub(crate) inverse: [[Id; 3]; 3],
    /// b.
    pub(crate) constant: [Id; 3],
}

impl Inertia {
    /// Returns whether J is diagonal in the frame of the body and no rotor spins in the body (b = 0).
    pub(crate) fn is_principal(&self, graph: &Graph) -> bool {
        let mut entries = (0..3).flat_map(|i| (0..3).map(move |j| (i, j)));
        entries.all(|(i, j)| i == j || graph.is_zero(self.inverse[i][j]))
            && self.constant.iter().all(|entry| graph.is_zero(*entry))
    }

    /// Returns an axis of symmetry: the moments of inertia about both other axes are one expression.
    pub(crate) fn symmetry(&self, graph: &Graph) -> Option<usize> {
        let [a, b, c] = [0, 1, 2].map(|i| self.inverse[i][i]);
        let axes = [(2, a == b), (0, b == c), (1, c == a)];
        axes.into_iter().find(|(_, equal)| *equal && self.is_principal(graph)).map(|(axis, _)| axis)
    }
}

/// Returns the momenta of a body or of a centre of mass. The fourth number of a pure quaternion is zero.
pub(crate) fn momenta(row: u32) -> [Symbol; 3] {
    [0, 1, 2].map(|i| Symbol::Momentum(4 * row + i))
}

/// Splits the energy of `bodies` rigid bodies. Rows from `bodies` to `rows` are centres of mass. Errors: a term, and the reason why it is refused.
pub(crate) fn bodies(graph: &mut Graph, energy: Id, bodies: u32, rows: u32) -> Result<Bodies, (Id, &'static str)> {
    let Separated { kinetic, potential } = split(graph, energy).map_err(|term| (term, BODY_COUPLED))?;
    if let Some(term) = not_quadratic(graph, kinetic) {
        return Err((term, BODY_NOT_QUADRATIC));
    }
    let velocity = velocity(graph, kinetic, rows);
    let centres: Vec<Symbol> = (bodies..rows).flat_map(momenta).collect();
    let mut inertia = vec![];
    for (velocity, body) in velocity.iter().zip(0..bodies) {
        let others: Vec<Symbol> = (0..bodies).filter(|other| *other != body).flat_map(momenta).collect();
        for (others, why) in [(&others, BODIES_COUPLED), (&centres, CENTRES_COUPLED)] {
            if depends(graph, velocity, others) {
                return Err((coupling_term(graph, kinetic, body, others), why));
            }
        }
        let slopes = diff::jacobian(graph, velocity, &momenta(body));
        let inverse = core::array::from_fn(|i| core::array::from_fn(|j| at_rest(graph, slopes[i][j])));
        inertia.push(Inertia { inverse, constant: velocity.map(|entry| at_rest(graph, entry)) });
    }
    let of_centres: Vec<Id> = velocity.iter().skip(bodies as usize).flatten().copied().collect();
    let mut inverse_mass = diff::jacobian(graph, &of_centres, &centres);
    for entry in inverse_mass.iter_mut().flatten() {
        *entry = at_rest(graph, *entry);
    }
    let streaming = of_centres.into_iter().map(|entry| at_rest(graph, entry)).collect();
    let autonomous = !graph.reads(energy).t;
    Ok(Bodies { energy, kinetic, potential, velocity, inertia, inverse_mass, streaming, autonomous })
}

/// Returns ∂T/∂m of each body, then ∂T/∂p of each centre of mass.
fn velocity(graph: &mut Graph, kinetic: Id, rows: u32) -> Vec<[Id; 3]> {
    let slopes = diff::gradient(graph, kinetic, 4 * rows).p;
    (0..rows as usize).map(|row| [0, 1, 2].map(|i| slopes[4 * row + i])).collect()
}

/// Returns a node at zero momenta. A node that does not depend on momenta keeps its value, even if its expression reads them.
fn at_rest(graph: &mut Graph, id: Id) -> Id {
    at_zero(graph, id, is_momentum)
}

/// Returns whether the velocity of a body depends on some momenta. Precondition: velocities are linear in momenta.
fn depends(graph: &mut Graph, velocity: &[Id; 3], momenta: &[Symbol]) -> bool {
    let rows = diff::jacobian(graph, velocity, momenta);
    rows.concat().into_iter().any(|entry| {
        let entry = at_rest(graph, entry);
        !identity(graph, entry).is_zero()
    })
}

/// Returns the first term of T that makes the velocity of a body depend on some momenta.
fn coupling_term(graph: &mut Graph, kinetic: Id, body: u32, others: &[Symbol]) -> Id {
    let couples = |graph: &mut Graph, term: Id| {
        let velocity = momenta(body).map(|momentum| diff::partial_derivative(graph, term, momentum));
        depends(graph, &velocity, others)
    };
    terms(graph, kinetic).into_iter().find(|term| couples(graph, *term)).unwrap_or(kinetic)
}
