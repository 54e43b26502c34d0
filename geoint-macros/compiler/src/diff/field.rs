//! The differential equation y' = f(y) and its derivative, as implicit methods solve it: with derivatives of H, or with divided differences.
//!
//! If nothing is damped and T is quadratic, the equation is of second order in q, and f is the force −∂V/∂q.
//! T then enters all methods in one form, [`SecondOrder`].

use super::equations;
use super::forward::jacobian;
use super::gradient::{Gradient, discrete_gradient};
use super::slope::coordinate_in_middle;
use crate::analyze::Structure;
use crate::ir::substitute::Substitution;
use crate::ir::{Graph, Id, Symbol};

/// A right-hand side f and its derivative.
#[derive(Clone, Debug)]
pub(crate) struct Field {
    /// The coordinates y, or their increments during a step if f consists of divided differences.
    pub(crate) unknowns: Vec<Symbol>,
    pub(crate) f: Vec<Id>,
    /// The entry in row i and column j is ∂fᵢ/∂unknownⱼ.
    pub(crate) jacobian: Vec<Vec<Id>>,
}

impl Field {
    /// Adds the derivative to a right-hand side.
    pub(crate) fn new(graph: &mut Graph, unknowns: Vec<Symbol>, f: Vec<Id>) -> Field {
        let jacobian = jacobian(graph, &f, &unknowns);
        Field { unknowns, f, jacobian }
    }

    /// Returns the rates of positions. Absent in an equation of second order, whose right-hand side is the force alone.
    pub(crate) fn velocity(&self, degrees: usize) -> Option<&[Id]> {
        (self.f.len() > degrees).then(|| &self.f[..degrees])
    }

    /// Returns the rates of momenta.
    pub(crate) fn force(&self, degrees: usize) -> &[Id] {
        &self.f[self.f.len() - degrees..]
    }
}

/// The part of a quadratic T in an equation of second order, as functions of the momenta.
#[derive(Debug)]
pub(crate) struct SecondOrder {
    /// ∂T/∂p.
    pub(crate) velocity: Vec<Id>,
    /// M⁻¹.
    pub(crate) inverse_mass: Vec<Vec<Id>>,
    /// M⁻¹p.
    pub(crate) acceleration: Vec<Id>,
}

/// The field at a point.
pub(crate) fn field(graph: &mut Graph, gradient: &Gradient, structure: &Structure, degrees: u32) -> Field {
    let f = right_side(graph, gradient, structure, |_, entry| entry);
    let unknowns = unknowns(structure, degrees, Symbol::Position, Symbol::Momentum);
    let mut field = Field::new(graph, unknowns, f);
    if structure.conservative() {
        match structure.reduced() {
            Some(_) => symmetrise(&mut field.jacobian),
            None => share_canonical(graph, &mut field.jacobian),
        }
    }
    field
}

/// Copies the lower triangle of a symmetric matrix to the upper one. Equal second derivatives may be written differently, so one of each pair is computed.
pub(super) fn symmetrise(matrix: &mut [Vec<Id>]) {
    for i in 0..matrix.len() {
        for j in 0..i {
            matrix[j][i] = matrix[i][j];
        }
    }
}

/// Computes one of each pair of equal second derivatives in J∇²H.
fn share_canonical(graph: &mut Graph, jacobian: &mut [Vec<Id>]) {
    let n = jacobian.len() / 2;
    for i in 0..n {
        for j in 0..n {
            jacobian[i][j] = graph.neg(jacobian[n + j][n + i]);
            if i < j {
                jacobian[i][n + j] = jacobian[j][n + i];
                jacobian[n + i][j] = jacobian[n + j][i];
            }
        }
    }
}

/// The field between two points, with the tree discrete gradient, and with damping and forces at their mean. Time is the middle of the step.
pub(crate) fn discrete(graph: &mut Graph, structure: &Structure, degrees: u32) -> Field {
    let root = structure.reduced().map_or(structure.energy, |parts| parts.potential);
    let gradient = discrete_gradient(graph, root, degrees);
    let mut mean = Substitution::new(coordinate_in_middle);
    let f = right_side(graph, &gradient, structure, |graph, entry| mean.apply(graph, entry));
    let unknowns = unknowns(structure, degrees, Symbol::PositionIncrement, Symbol::MomentumIncrement);
    Field::new(graph, unknowns, f)
}

/// The rates of q and p, or for an equation of second order the force alone.
fn right_side(
    graph: &mut Graph,
    gradient: &Gradient,
    structure: &Structure,
    place: impl FnMut(&mut Graph, Id) -> Id,
) -> Vec<Id> {
    let rates = equations::hamilton(graph, gradient, structure, place);
    if structure.reduced().is_some() { rates.p } else { rates.concat() }
}

fn unknowns(structure: &Structure, degrees: u32, q: fn(u32) -> Symbol, p: fn(u32) -> Symbol) -> Vec<Symbol> {
    let momenta = if structure.reduced().is_some() { 0 } else { degrees };
    (0..degrees).map(q).chain((0..momenta).map(p)).collect()
}

/// Returns the part of T if the equation is of second order.
pub(crate) fn second_order(
    graph: &mut Graph,
    gradient: &Gradient,
    structure: &Structure,
    degrees: u32,
) -> Option<SecondOrder> {
    structure.reduced()?;
    let symbols: Vec<Symbol> = (0..degrees).map(Symbol::Momentum).collect();
    let inverse_mass = jacobian(graph, &gradient.p, &symbols);
    let momenta: Vec<Id> = symbols.iter().map(|symbol| graph.symbol(*symbol)).collect();
    let acceleration = equations::times(graph, &inverse_mass, &momenta);
    Some(SecondOrder { velocity: gradient.p.clone(), inverse_mass, acceleration })
}
