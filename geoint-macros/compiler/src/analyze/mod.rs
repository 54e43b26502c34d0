//! Facts about an energy, proven from its graph. A fact that does not hold has a witness. Messages are elsewhere.

mod acting;
mod action;
mod damping;
mod degree;
mod terms;
mod separable;
mod steep;
mod bodies;
mod leaves;
mod quadratic;
mod equations;
mod forces;
mod conserved;
mod mean_value;
mod enclosable;
mod poles;
mod jumps;
mod turns;
mod identity;
mod rolling;

use crate::diff::{self, constraint::Row};
use crate::ir::{Graph, Id, Node, Reads, Symbol};
use crate::parse::Shape;
pub(crate) use acting::Acting;
pub(crate) use action::{decay_of, with_decay_of_time};
pub(crate) use bodies::{Bodies, bodies, momenta as momenta_of_body};
pub(crate) use conserved::{
    Conserved, Dissipated, decay, dissipated, dissipated_by_velocities, dissipated_on_constraints, noether,
    translations,
};
pub(crate) use damping::{Damping, Flaw};
pub(crate) use degree::Degrees;
pub(crate) use forces::Forces;
pub(crate) use identity::{
    Direction, Identity, Proof, Remainder, Value, Why, Witness, Wrong, angles, broken_at, claims, crossings, identity,
    is_regular, liouville, multiple, retain_likely_constant, search, vanishes,
};
pub(crate) use jumps::{Jump, conditions, jump_of, jumps};
pub(crate) use mean_value::MeanValue;
pub(crate) use poles::{Pole, Quick, has_edge, poles};
pub(crate) use rolling::{Binding, bindings, integral, is_rate};
use separable::Separated;
pub(crate) use separable::{not_affine, not_quadratic};
pub(crate) use steep::is_steep;
pub(crate) use turns::{irregular_turn, turning_terms};

/// The facts on which emission relies. Facts about H do not depend on damping.
#[derive(Debug)]
pub(crate) struct Structure {
    pub(crate) energy: Id,
    pub(crate) split: Split,
    /// Whether H does not read t.
    pub(crate) autonomous: bool,
    /// Coordinates that H does not read and whose momenta neither damping nor forces change. These momenta are conserved.
    pub(crate) cyclic: Vec<u32>,
    /// Momenta that H does not read. Their coordinates are constant.
    pub(crate) resting: Vec<u32>,
    /// Whether a condition in H reads the state.
    pub(crate) switches: bool,
    /// The degree of H, if it is a polynomial in (q, p).
    pub(crate) degree: Option<u32>,
    /// Other functions that the flow and the tree discrete gradient conserve.
    pub(crate) momenta: Vec<Conserved>,
    pub(crate) mean_value: MeanValue,
    pub(crate) damping: Option<Damping>,
    pub(crate) forces: Option<Forces>,
}

/// The split of H into a function of p and a function of q.
#[derive(Debug)]
pub(crate) enum Split {
    Separable(Parts),
    /// A term that reads both q and p.
    Coupled(Id),
}

/// H = kinetic(p, t) + potential(q, t).
#[derive(Debug)]
pub(crate) struct Parts {
    pub(crate) kinetic: Id,
    pub(crate) potential: Id,
    /// A term of the kinetic part that is not a polynomial in p of degree at most 2 with constant coefficients, if any.
    pub(crate) not_quadratic: Option<Id>,
}

impl Structure {
    /// Returns the parts of a separable H.
    pub(crate) fn parts(&self) -> Option<&Parts> {
        match &self.split {
            Split::Separable(parts) => Some(parts),
            Split::Coupled(_) => None,
        }
    }

    /// Returns the parts if T is quadratic with a constant mass matrix.
    pub(crate) fn quadratic_parts(&self) -> Option<&Parts> {
        self.parts().filter(|parts| parts.not_quadratic.is_none())
    }

    /// Adds damping, unless all of its coefficients are zero.
    pub(crate) fn damped(mut self, graph: &Graph, matrix: Option<Vec<Vec<Id>>>) -> Structure {
        self.damping = damping(graph, matrix);
        self.remove_changed_momenta(graph);
        self
    }

    /// Adds forces without an energy.
    pub(crate) fn forced(mut self, graph: &Graph, forces: Option<Forces>) -> Structure {
        self.forces = forces;
        self.remove_changed_momenta(graph);
        self
    }

    /// Removes momenta that damping or a force changes.
    fn remove_changed_momenta(&mut self, graph: &Graph) {
        let acting = Acting { damping: self.damping.as_ref(), forces: self.forces.as_ref() };
        self.cyclic.retain(|i| !acting.on_momentum(graph, *i));
        self.momenta.retain(|momentum| !acting.on(graph, momentum));
    }

    /// Returns whether neither damping nor other forces act.
    pub(crate) fn conservative(&self) -> bool {
        self.damping.is_none() && self.forces.is_none()
    }

    /// Returns the parts if each has its own flow.
    pub(crate) fn flows(&self) -> Option<&Parts> {
        self.parts().filter(|_| self.conservative())
    }

    /// Returns the parts if the differential equation has second order: T is quadratic, and neither damping nor other forces act.
    pub(crate) fn reduced(&self) -> Option<&Parts> {
        self.quadratic_parts().filter(|_| self.conservative())
    }

    /// Returns whether no right-hand side reads t.
    pub(crate) fn timeless(&self) -> bool {
        let mut others =
            self.damping.iter().map(|damping| damping.reads).chain(self.forces.iter().map(|forces| forces.reads));
        self.autonomous && others.all(|reads| !reads.t)
    }

    /// Returns whether the right-hand sides are linear and autonomous.
    pub(crate) fn linear(&self) -> bool {
        let constant = self.damping.as_ref().is_none_or(|damping| damping.reads == Reads::default());
        self.autonomous && constant && self.forces.is_none() && self.degree.is_some_and(|degree| degree <= 2)
    }

    /// Returns whether the flow conserves H.
    pub(crate) fn conserves_energy(&self) -> bool {
        self.autonomous && self.conservative()
    }
}

/// Classifies a damping matrix. `None` if all entries are zero.
pub(crate) fn damping(graph: &Graph, matrix: Option<Vec<Vec<Id>>>) -> Option<Damping> {
    matrix.and_then(|matrix| Damping::of(graph, matrix))
}

/// Returns whether nodes are polynomials of degree at most `degree` in the symbols that `counts` selects.
pub(crate) fn is_polynomial_in(graph: &Graph, roots: &[Id], degree: u32, counts: impl Fn(Symbol) -> bool) -> bool {
    let degrees = Degrees::of(graph, roots, counts);
    roots.iter().all(|root| degrees.at_most(*root, degree))
}

/// Returns the degree of a node in the symbols that `counts` selects. `None` if it is not a polynomial.
pub(crate) fn degree_in(graph: &Graph, root: Id, counts: impl Fn(Symbol) -> bool) -> Option<u32> {
    Degrees::of(graph, &[root], counts).get(root)
}

/// Returns the terms of a sum and of nested sums.
pub(crate) fn terms(graph: &mut Graph, root: Id) -> Vec<Id> {
    terms_where(graph, root, |_| false)
}

/// Returns the terms of a sum and of nested sums. A sum with factors that are free of q and p is split if `splits` accepts the kinds of coordinates
/// that the sum reads.
pub(crate) fn terms_where(graph: &mut Graph, root: Id, splits: impl Fn(Reads) -> bool) -> Vec<Id> {
    let terms = terms::Sums::new(graph).terms(root, splits);
    terms.into_iter().map(|term| term.build(graph)).collect()
}

/// Returns the terms of a sum, of nested sums, and of sums with factors that are free of q and p.
pub(crate) fn single_terms(graph: &mut Graph, root: Id) -> Vec<Id> {
    terms_where(graph, root, |_| true)
}

/// Finds the facts about H with constraints A v + b = 0. A momentum that commutes with the leaves of H + λ·g for every λ commutes with the leaves of H
/// and of every g. A momentum p·ξ must also have Aξ = 0 for rows that bind velocities only. H changes by −λ·b.
pub(crate) fn bound(graph: &mut Graph, energy: Id, rows: &[Row], coordinates: &Shape) -> Structure {
    let mut terms = vec![energy];
    for (k, value) in (0..).zip(rows.iter().filter_map(|row| row.value)) {
        let multiplier = graph.symbol(Symbol::Multiplier(k));
        terms.push(graph.mul(multiplier, value));
    }
    let sum = graph.sum(&terms);
    let mut structure = structure(graph, sum, coordinates);
    let free = |value: Id| !graph.reads_any(value, |symbol| matches!(symbol, Symbol::Multiplier(_)));
    structure.momenta.retain(|momentum| free(momentum.value));
    let momenta: Vec<Symbol> = (0..coordinates.len() as u32).map(Symbol::Momentum).collect();
    for row in rows.iter().filter(|row| row.value.is_none()) {
        structure.cyclic.retain(|i| graph.is_zero(row.gradient[*i as usize]));
        structure.momenta.retain(|momentum| {
            let direction = diff::jacobian(graph, &[momentum.value], &momenta).concat();
            let along = graph.dot(&row.gradient, &direction);
            identity::vanishes(graph, along)
        });
    }
    structure.autonomous &= rows.iter().all(|row| graph.is_zero(row.drift));
    structure
}

/// Finds the facts about H.
pub(crate) fn structure(graph: &mut Graph, energy: Id, coordinates: &Shape) -> Structure {
    let split = match separable::split(graph, energy) {
        Ok(Separated { kinetic, potential }) => {
            let not_quadratic = separable::not_quadratic(graph, kinetic);
            Split::Separable(Parts { kinetic, potential, not_quadratic })
        }
        Err(term) => Split::Coupled(term),
    };
    let degrees = Degrees::of(graph, &[energy], Symbol::is_canonical);
    let symbols = graph.symbols(energy);
    let unread =
        |symbol: fn(u32) -> Symbol| (0..coordinates.len() as u32).filter(|i| !symbols.contains(&symbol(*i))).collect();
    Structure {
        energy,
        split,
        autonomous: !graph.reads(energy).t,
        cyclic: unread(Symbol::Position),
        resting: unread(Symbol::Momentum),
        switches: graph.reachable(&[energy]).into_iter().any(|id| match graph.node(id) {
            Node::Select(condition, ..) => graph.reads(*condition).state(),
            _ => false,
        }),
        degree: degrees.get(energy),
        momenta: conserved::momenta(graph, &degrees, energy, coordinates),
        mean_value: mean_value::mean_value(graph, &degrees, energy),
        damping: None,
        forces: None,
    }
}

/// Returns whether the motion of positions and momenta depends on s. `decay` is ∂H/∂s, and `slopes` are their other derivatives. A derivative may
/// read s through a condition even if ∂H/∂s does not read the state.
pub(crate) fn acts_back(graph: &Graph, decay: Id, slopes: impl IntoIterator<Item = Id>) -> bool {
    graph.reads(decay).state() || slopes.into_iter().any(|slope| graph.reads(slope).s)
}
