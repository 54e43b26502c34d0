//! The differential equation as implicit methods solve it: y' = f(y) and its derivative, with derivatives of H and with
//! divided differences.
//!
//! If T is quadratic it is one of second order in q, with the force f = −∂V/∂q: T is then the same for every method.

use super::forward::jacobian;
use super::{Gradient, MissingSlope, discrete_gradient};
use crate::analyze::Structure;
use crate::ir::{Graph, Id, Symbol};

/// f and its derivative.
#[derive(Debug)]
pub(crate) struct Field {
    /// y; or its increment, between whose ends divided differences are taken.
    pub(crate) unknowns: Vec<Symbol>,
    pub(crate) f: Vec<Id>,
    /// ∂fᵢ/∂unknownⱼ, a row an entry of f.
    pub(crate) jacobian: Vec<Vec<Id>>,
}

/// What T adds to an equation of second order, as functions of the momenta.
#[derive(Debug)]
pub(crate) struct SecondOrder {
    /// ∂T/∂p.
    pub(crate) velocity: Vec<Id>,
    /// M⁻¹p.
    pub(crate) acceleration: Vec<Id>,
}

/// f at a point.
pub(crate) fn field(graph: &mut Graph, gradient: &Gradient, structure: &Structure, degrees: u32) -> Field {
    let f = right_side(graph, gradient, structure);
    let unknowns = unknowns(structure, degrees, Symbol::Q, Symbol::P);
    let mut jacobian = jacobian(graph, &f, &unknowns);
    // ∇²H is symmetric: of two equal derivatives, which may be written differently, one is computed.
    let n = degrees as usize;
    for i in 0..n {
        for j in 0..n {
            if structure.quadratic_parts().is_some() {
                if i < j {
                    jacobian[i][j] = jacobian[j][i];
                }
                continue;
            }
            jacobian[i][j] = graph.neg(jacobian[n + j][n + i]);
            if i < j {
                jacobian[i][n + j] = jacobian[j][n + i];
                jacobian[n + i][j] = jacobian[n + j][i];
            }
        }
    }
    Field { unknowns, f, jacobian }
}

/// f between two points, with the tree discrete gradient.
pub(crate) fn discrete(graph: &mut Graph, structure: &Structure, degrees: u32) -> Result<Field, MissingSlope> {
    let root = structure.quadratic_parts().map_or(structure.energy, |parts| parts.potential);
    let gradient = discrete_gradient(graph, root, degrees)?;
    let f = right_side(graph, &gradient, structure);
    let unknowns = unknowns(structure, degrees, Symbol::Dq, Symbol::Dp);
    let jacobian = jacobian(graph, &f, &unknowns);
    Ok(Field { unknowns, f, jacobian })
}

/// −∇_qH; or J∇H if T is not quadratic.
fn right_side(graph: &mut Graph, gradient: &Gradient, structure: &Structure) -> Vec<Id> {
    let force: Vec<Id> = gradient.q.iter().map(|slope| graph.neg(*slope)).collect();
    if structure.quadratic_parts().is_some() { force } else { [gradient.p.clone(), force].concat() }
}

fn unknowns(structure: &Structure, degrees: u32, q: fn(u32) -> Symbol, p: fn(u32) -> Symbol) -> Vec<Symbol> {
    let momenta = if structure.quadratic_parts().is_some() { 0 } else { degrees };
    (0..degrees).map(q).chain((0..momenta).map(p)).collect()
}

/// What T adds, if it is quadratic.
pub(crate) fn second_order(
    graph: &mut Graph,
    gradient: &Gradient,
    structure: &Structure,
    degrees: u32,
) -> Option<SecondOrder> {
    structure.quadratic_parts()?;
    let momenta: Vec<Symbol> = (0..degrees).map(Symbol::P).collect();
    let inverse_mass = jacobian(graph, &gradient.p, &momenta);
    let row = |row: &Vec<Id>| {
        let mut terms = vec![];
        for (entry, momentum) in row.iter().zip(&momenta) {
            let momentum = graph.symbol(*momentum);
            terms.push(graph.mul(*entry, momentum));
        }
        graph.sum(&terms)
    };
    let acceleration = inverse_mass.iter().map(row).collect();
    Some(SecondOrder { velocity: gradient.p.clone(), acceleration })
}
