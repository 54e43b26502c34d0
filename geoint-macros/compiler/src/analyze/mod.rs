//! Facts about an energy, each proven from its graph, each with a witness where it does not hold. No messages.

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
mod spared;
mod conserved;
mod mean_value;
mod enclosable;
mod poles;
mod jumps;
mod turns;
mod identity;

use crate::ir::{Graph, Id, Node, Reads, Symbol};
use crate::parse::Shape;
pub(crate) use bodies::{Bodies, bodies, momenta as momenta_of_body};
pub(crate) use conserved::{Dissipated, Momentum, decay, dissipated, dissipated_by_velocities, noether, translations};
pub(crate) use damping::{Damping, Flaw};
pub(crate) use degree::Degrees;
pub(crate) use forces::Forces;
pub(crate) use identity::{
    Direction, Identity, Proof, Remainder, Value, Why, Witness, angles, broken_at, claims, crossings, identity,
    is_regular, liouville, multiple, retain_constant, search, vanishes,
};
pub(crate) use jumps::{Jump, conditions, decided, jumps};
pub(crate) use mean_value::MeanValue;
pub(crate) use poles::{Pole, Quick, has_edge, poles};
pub(crate) use separable::{not_affine, not_quadratic};
pub(crate) use spared::Spared;
pub(crate) use steep::is_steep;
pub(crate) use turns::turning_terms;

/// All facts that emission may rely on. Those of H hold whether or not there is damping.
#[derive(Debug)]
pub(crate) struct Structure {
    pub(crate) energy: Id,
    pub(crate) split: Split,
    /// Whether H reads t.
    pub(crate) autonomous: bool,
    /// Coordinates that H does not read, and whose momenta are not damped: those are conserved.
    pub(crate) cyclic: Vec<u32>,
    /// Momenta that H does not read: their coordinates stand still.
    pub(crate) resting: Vec<u32>,
    /// Whether a condition in H reads the state.
    pub(crate) switches: bool,
    /// The degree of H as a polynomial in (q, p), if it is one.
    pub(crate) degree: Option<u32>,
    /// What else is kept by the flow, and by the tree discrete gradient.
    pub(crate) momenta: Vec<Momentum>,
    pub(crate) mean_value: MeanValue,
    pub(crate) damping: Option<Damping>,
    pub(crate) forces: Option<Forces>,
}

/// Whether H is a sum of a part in p and a part in q.
#[derive(Debug)]
pub(crate) enum Split {
    Separable(Parts),
    /// A term that reads both.
    Coupled(Id),
}

/// H = kinetic(p, t) + potential(q, t).
#[derive(Debug)]
pub(crate) struct Parts {
    pub(crate) kinetic: Id,
    pub(crate) potential: Id,
    /// `None` if the kinetic part is a polynomial of degree 2 in p with constant coefficients, else a term that is not.
    pub(crate) not_quadratic: Option<Id>,
}

impl Structure {
    pub(crate) fn parts(&self) -> Option<&Parts> {
        match &self.split {
            Split::Separable(parts) => Some(parts),
            Split::Coupled(_) => None,
        }
    }

    /// The parts, if T is quadratic with a constant mass matrix.
    pub(crate) fn quadratic_parts(&self) -> Option<&Parts> {
        self.parts().filter(|parts| parts.not_quadratic.is_none())
    }

    /// The same facts with damping, unless all of its coefficients are zero.
    pub(crate) fn damped(mut self, graph: &Graph, matrix: Option<Vec<Vec<Id>>>) -> Structure {
        self.damping = damping(graph, matrix);
        self.keep_spared(graph);
        self
    }

    /// The same facts with forces that no energy gives.
    pub(crate) fn forced(mut self, graph: &Graph, forces: Option<Forces>) -> Structure {
        self.forces = forces;
        self.keep_spared(graph);
        self
    }

    /// Leaves out momenta that damping or a force changes.
    fn keep_spared(&mut self, graph: &Graph) {
        let spared = Spared { damping: self.damping.as_ref(), forces: self.forces.as_ref() };
        self.cyclic.retain(|i| spared.coordinate(graph, *i));
        self.momenta.retain(|momentum| spared.momentum(graph, momentum));
    }

    /// Whether H alone moves the state.
    pub(crate) fn conservative(&self) -> bool {
        self.damping.is_none() && self.forces.is_none()
    }

    /// The parts, if each has a flow of its own.
    pub(crate) fn flows(&self) -> Option<&Parts> {
        self.parts().filter(|_| self.conservative())
    }

    /// The parts, if the differential equation is one of second order: T is quadratic, and nothing is damped.
    pub(crate) fn reduced(&self) -> Option<&Parts> {
        self.quadratic_parts().filter(|_| self.conservative())
    }

    /// Whether no right-hand side reads t.
    pub(crate) fn timeless(&self) -> bool {
        let mut others =
            self.damping.iter().map(|damping| damping.reads).chain(self.forces.iter().map(|forces| forces.reads));
        self.autonomous && others.all(|reads| !reads.t)
    }

    /// Whether the right-hand sides are linear and do not depend on time.
    pub(crate) fn linear(&self) -> bool {
        let constant = self.damping.as_ref().is_none_or(|damping| damping.reads == Reads::default());
        self.autonomous && constant && self.forces.is_none() && self.degree.is_some_and(|degree| degree <= 2)
    }

    /// Whether H is the same at all times.
    pub(crate) fn conserves_energy(&self) -> bool {
        self.autonomous && self.conservative()
    }
}

/// Damping, unless all of its coefficients are zero.
pub(crate) fn damping(graph: &Graph, matrix: Option<Vec<Vec<Id>>>) -> Option<Damping> {
    matrix.and_then(|matrix| damping::damping(graph, matrix))
}

/// Whether nodes are polynomials of a degree at most in x.
pub(crate) fn is_polynomial(graph: &Graph, roots: &[Id], degree: u32) -> bool {
    is_polynomial_in(graph, roots, degree, Symbol::is_coordinate)
}

/// Whether nodes are polynomials of a degree at most in some symbols.
pub(crate) fn is_polynomial_in(graph: &Graph, roots: &[Id], degree: u32, counts: impl Fn(Symbol) -> bool) -> bool {
    let degrees = Degrees::of(graph, roots, counts);
    roots.iter().all(|root| degrees.get(*root).is_some_and(|d| d <= degree))
}

/// The degree of a node as a polynomial in some symbols, if it is one.
pub(crate) fn degree_in(graph: &Graph, root: Id, counts: impl Fn(Symbol) -> bool) -> Option<u32> {
    Degrees::of(graph, &[root], counts).get(root)
}

/// The terms of a sum, those of sums in it included.
pub(crate) fn terms(graph: &mut Graph, root: Id) -> Vec<Id> {
    terms_where(graph, root, |_| false)
}

/// The same, where a sum with a common factor is taken apart if it reads what `apart` asks for.
pub(crate) fn terms_where(graph: &mut Graph, root: Id, apart: impl Fn(Reads) -> bool) -> Vec<Id> {
    let terms = terms::Sums::new(graph).terms(root, apart);
    terms.into_iter().map(|term| term.build(graph)).collect()
}

/// The same with sums taken apart that have a common factor free of q and p.
pub(crate) fn single_terms(graph: &mut Graph, root: Id) -> Vec<Id> {
    let terms = terms::Sums::new(graph).terms(root, |_| true);
    terms.into_iter().map(|term| term.build(graph)).collect()
}

/// Facts of H and functions g of positions together: a momentum that commutes with the parts of H + λ·g for every λ does with those of H,
/// and of every g.
pub(crate) fn bound(graph: &mut Graph, energy: Id, constraints: &[Id], coordinates: &Shape) -> Structure {
    let mut terms = vec![energy];
    for (k, constraint) in (0..).zip(constraints) {
        let multiplier = graph.symbol(Symbol::Multiplier(k));
        terms.push(graph.mul(multiplier, *constraint));
    }
    let sum = graph.sum(&terms);
    let mut structure = structure(graph, sum, coordinates);
    let free = |value: Id| !graph.reads_any(value, |symbol| matches!(symbol, Symbol::Multiplier(_)));
    structure.momenta.retain(|momentum| free(momentum.value));
    structure
}

/// Finds everything.
pub(crate) fn structure(graph: &mut Graph, energy: Id, coordinates: &Shape) -> Structure {
    let split = match separable::split(graph, energy) {
        Ok((kinetic, potential)) => {
            let not_quadratic = separable::not_quadratic(graph, kinetic);
            Split::Separable(Parts { kinetic, potential, not_quadratic })
        }
        Err(term) => Split::Coupled(term),
    };
    let degrees = Degrees::of(graph, &[energy], |symbol| matches!(symbol, Symbol::Position(_) | Symbol::Momentum(_)));
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

/// Whether positions and momenta do not move without s, which decay at the rate ∂H/∂s and move by these derivatives else: by a condition a
/// derivative reads s, too, where nothing is differentiated by it.
pub(crate) fn acts_back(graph: &Graph, decay: Id, slopes: impl IntoIterator<Item = Id>) -> bool {
    graph.reads(decay).state() || slopes.into_iter().any(|slope| graph.reads(slope).s)
}
