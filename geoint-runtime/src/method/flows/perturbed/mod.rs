//! Methods for H = A + B. The part A has an exact flow, and the rest B is a kick.
//!
//! If B/A is of the size ε, the error of a method is a sum over powers of ε. A method of orders (s₁, s₂, …) has the error O(ε hˢ¹ + ε² hˢ² + …).

mod inner;

pub use inner::Inner;

use crate::method::{Claims, Clock, Failure, Handling, Method, Name, Probe, Step};
use crate::scalar::Real;
use crate::space::{Point, Summation};
use crate::system::Perturbed;
use inner::StateProbe;

/// A table of kicks and drifts for H = A + B. The exact flow of A replaces the drift, and B replaces V.
///
/// It takes every table, as in `Perturbation(BlanesMoan4)`. Tables of Runge–Kutta–Nyström type or with force gradients need an A of
/// degree 2 in p.
///
/// ```
/// use geoint_runtime::methods::*;
/// use geoint_runtime::prelude::*;
///
/// /// A star and two planets.
/// #[hamiltonian(coordinates = jacobi)]
/// fn planets(q: [[f64; 2]; 3], p: [[f64; 2]; 3], m: [f64; 3], g: f64) -> f64 {
///     let mut energy = 0.0;
///     for i in 0..3 {
///         energy += (p[i][0] * p[i][0] + p[i][1] * p[i][1]) / (2.0 * m[i]);
///         for j in 0..i {
///             energy -= g * m[i] * m[j] / (q[i][0] - q[j][0]).hypot(q[i][1] - q[j][1]);
///         }
///     }
///     energy
/// }
///
/// let system = Planets { m: [1.0, 1e-3, 3e-4], g: 1.0 };
/// let start = State::new([[0.0, 0.0], [1.0, 0.0], [-2.5, 0.0]], [[0.0, 0.0], [0.0, 1e-3], [0.0, -1.9e-4]]);
/// // Steps of a tenth of the inner planet's year.
/// let mut sim = system.integrator(Perturbation(BlanesMoanSrkn11b), 0.6, start);
/// let energy = sim.energy();
/// sim.advance(1000)?;
/// assert!((sim.energy() / energy - 1.0).abs() < 1e-10);
/// # Ok::<(), StepError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Perturbation<M>(pub M);

/// Coefficients of the table.
#[derive(Clone, Debug)]
pub struct Prepared<P> {
    table: P,
    /// The reason why the inner coordinates do not exist for these parameters. Every step is then refused.
    unsuitable: Option<&'static str>,
}

/// Limits the claims of a table to order 2 if the flow of B is replaced by a symmetric step of order 2.
fn limit_by_rest<S: Perturbed<R>, R: Real>(claims: Claims) -> Claims {
    if S::REST_IS_EXACT { claims } else { Claims { order: claims.order.min(2), perturbed: &[], ..claims } }
}

impl<S: Perturbed<R>, R: Real, M: Method<Inner<S>, R>> Method<S, R> for Perturbation<M> {
    type Proof = M::Proof;
    type Prepared = Prepared<M::Prepared>;
    type Memory = M::Memory;
    const HANDLING: Handling = Handling { moves_inner_point: S::INNER || M::HANDLING.moves_inner_point, ..M::HANDLING };

    fn claims(&self) -> Claims {
        limit_by_rest::<S, R>(self.0.claims())
    }

    fn name(&self) -> Name {
        // Tables made for H = A + B have names of their own.
        if self.0.claims().perturbed.is_empty() { Name::new("Perturbation").of(self.0.name()) } else { self.0.name() }
    }

    fn prepare(&self, system: &S, h: R) -> Self::Prepared {
        Prepared { table: self.0.prepare(&Inner(*system), h), unsuitable: system.unsuitable() }
    }

    fn memory(z: &S::Phase) -> Self::Memory {
        M::memory(z)
    }

    #[inline(always)]
    fn enter(prepared: &Self::Prepared, system: &S, t: R, z: &mut S::Phase) {
        system.enter(z);
        M::enter(&prepared.table, &Inner(*system), t, z);
    }

    #[inline(always)]
    fn leave(prepared: &Self::Prepared, system: &S, t: R, z: &mut S::Phase) {
        M::leave(&prepared.table, &Inner(*system), t, z);
        system.leave(z);
    }

    #[inline(always)]
    fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        prepared: &Self::Prepared,
        memory: &mut Self::Memory,
        Step { system, t, end, x, probe }: Step<'_, S, R, C, P>,
    ) -> Result<(), Failure> {
        Failure::outside(prepared.unsuitable)?;
        let probe = &mut StateProbe { system, probe };
        M::step(&prepared.table, memory, Step { system: &Inner(*system), t, end, x, probe })
    }

    #[inline(always)]
    fn advance<C: Summation<S::Phase>>(
        prepared: &Self::Prepared,
        memory: &mut Self::Memory,
        system: &S,
        clock: &Clock<R>,
        steps: u64,
        x: &mut Point<S::Phase, C, S::Action>,
    ) -> Result<(), Failure> {
        Failure::outside(prepared.unsuitable)?;
        M::advance(&prepared.table, memory, &Inner(*system), clock, steps, x)
    }
}
