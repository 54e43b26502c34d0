//! Rigid bodies: H = T(m) + V(r, t) with T quadratic in the momentum of each body; or T(m) + T(p) + V(r, q, t) with centres of mass? The
//! parts, or the term that is in the way.

use super::separable::{not_quadratic, split};
use super::{Identity, identity, terms};
use crate::diff;
use crate::ir::substitute::Substitution;
use crate::ir::{Graph, Id, Symbol};
use crate::messages::{BODIES_COUPLED, BODY_COUPLED, BODY_NOT_QUADRATIC, CENTRES_COUPLED};

/// H = Σ (½ m·Jm + b·m) + V(r, q, t), and a polynomial of degree 2 in p.
#[derive(Debug)]
pub(crate) struct Bodies {
    pub(crate) energy: Id,
    pub(crate) kinetic: Id,
    pub(crate) potential: Id,
    /// ∂T/∂m, one a momentum of each body; then ∂T/∂p, one a centre of mass.
    pub(crate) velocity: Vec<[Id; 3]>,
    /// J and b of each body: numbers, and functions of parameters.
    pub(crate) inertia: Vec<Inertia>,
    /// M⁻¹ of the centres of mass, and their velocities at rest.
    pub(crate) inverse_mass: Vec<Vec<Id>>,
    pub(crate) streaming: Vec<Id>,
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

    /// An axis of symmetry: the moments of inertia about both others are one expression.
    pub(crate) fn symmetry(&self, graph: &Graph) -> Option<usize> {
        let [a, b, c] = [0, 1, 2].map(|i| self.inverse[i][i]);
        let axes = [(2, a == b), (0, b == c), (1, c == a)];
        axes.into_iter().find(|(_, equal)| *equal && self.is_principal(graph)).map(|(axis, _)| axis)
    }
}

/// The momenta of a row: of a body, or of a centre of mass; the fourth number of a pure quaternion is zero.
pub(crate) fn momenta(row: u32) -> [Symbol; 3] {
    [0, 1, 2].map(|i| Symbol::Momentum(4 * row + i))
}

/// The parts of the energy of so many bodies, or a term and what is wrong with it. Further rows are centres of mass.
pub(crate) fn bodies(graph: &mut Graph, energy: Id, bodies: u32, rows: u32) -> Result<Bodies, (Id, &'static str)> {
    let (kinetic, potential) = split(graph, energy).map_err(|term| (term, BODY_COUPLED))?;
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
                return Err((coupling_term(graph, kinetic, (body, rows), others), why));
            }
        }
        let slopes = diff::jacobian(graph, velocity, &momenta(body));
        let inverse = core::array::from_fn(|i| core::array::from_fn(|j| at_rest(graph, slopes[i][j])));
        inertia.push(Inertia { inverse, constant: velocity.map(|entry| at_rest(graph, entry)) });
    }
    let moving = velocity[bodies as usize..].concat();
    let slopes = diff::jacobian(graph, &moving, &centres);
    let inverse_mass =
        slopes.into_iter().map(|row| row.into_iter().map(|entry| at_rest(graph, entry)).collect()).collect();
    let streaming = moving.into_iter().map(|entry| at_rest(graph, entry)).collect();
    let autonomous = !graph.reads(energy).t;
    Ok(Bodies { energy, kinetic, potential, velocity, inertia, inverse_mass, streaming, autonomous })
}

/// ∂T/∂m and ∂T/∂p.
fn velocity(graph: &mut Graph, kinetic: Id, rows: u32) -> Vec<[Id; 3]> {
    let slopes = diff::gradient(graph, kinetic, 4 * rows).p;
    slopes.chunks(4).map(|row| [row[0], row[1], row[2]]).collect()
}

/// What does not depend on momenta may be taken where they are zero.
fn at_rest(graph: &mut Graph, id: Id) -> Id {
    Substitution::new(|graph: &mut Graph, symbol| matches!(symbol, Symbol::Momentum(_)).then(|| graph.zero()))
        .apply(graph, id)
}

/// Whether velocities, which are linear in momenta, depend on some of them.
fn depends(graph: &mut Graph, velocity: &[Id; 3], momenta: &[Symbol]) -> bool {
    let rows = diff::jacobian(graph, velocity, momenta);
    rows.concat().into_iter().any(|entry| {
        let entry = at_rest(graph, entry);
        !graph.is_zero(entry) && !matches!(identity(graph, entry), Identity::Zero(_))
    })
}

/// The first term of T by which the velocity of a body depends on some momenta.
fn coupling_term(graph: &mut Graph, kinetic: Id, (body, rows): (u32, u32), others: &[Symbol]) -> Id {
    let couples = |graph: &mut Graph, term: Id| {
        let velocity = velocity(graph, term, rows)[body as usize];
        depends(graph, &velocity, others)
    };
    terms(graph, kinetic).into_iter().find(|term| couples(graph, *term)).unwrap_or(kinetic)
}
