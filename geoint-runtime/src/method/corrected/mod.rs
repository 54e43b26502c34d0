//! Steps of any method, put right: projected to invariants, or lengthened until the energy is what it was.
//!
//! ```
//! use geoint_runtime::prelude::*;
//!
//! /// Planar pendulum; q in rad, p in kg m²/s.
//! #[hamiltonian]
//! fn pendulum(q: f64, p: f64, m: f64, l: f64, g: f64) -> f64 {
//!     p * p / (2.0 * m * l * l) - m * g * l * q.cos()
//! }
//!
//! let system = Pendulum { m: 0.7, l: 1.2, g: 9.81 };
//! let start = State::new(2.0, 0.0);
//! let mut plain = system.integrator(RK4, 0.05, start);
//! let mut projected = system.integrator(Projection(RK4, Energy), 0.05, start);
//! let mut relaxed = system.integrator(Relaxation(RK4), 0.05, start);
//! let energy = plain.energy();
//! plain.advance(10_000)?;
//! projected.advance(10_000)?;
//! relaxed.advance(10_000)?;
//! let error = |now: f64| (now / energy - 1.0).abs();
//! assert!(error(plain.energy()) > 1e-5);
//! assert!(error(projected.energy()) < 1e-12 && error(relaxed.energy()) < 1e-12);
//! # Ok::<(), StepError>(())
//! ```
//!
//! Invariants of one's own implement [`Invariants`]: the front page of the crate has an example.

pub mod invariants;
pub mod projection;
pub mod relaxation;
mod series;

pub use invariants::{Energy, Integrals, Invariants};
pub use projection::Projection;
pub use relaxation::Relaxation;

use crate::scalar::Real;
use crate::solving::size::Sizes;
use crate::space::{Array, Compensated, Record, Summation, Tape};

/// What a step hands on to the next one.
#[derive(Clone, Copy, Debug)]
pub struct Memory<M, A: Array> {
    method: M,
    scales: Scales<A>,
    /// Corrections may be smaller than the last digit of a coordinate, and all of one sign.
    sums: Compensated<A>,
}

impl<M, A: Array> Memory<M, A> {
    fn new(method: M) -> Self {
        Memory { method, scales: Scales::new(), sums: Compensated::new() }
    }
}

impl<M: Record<A::Real>, A: Array> Record<A::Real> for Memory<M, A> {
    fn record(&mut self, tape: &mut impl Tape<A::Real>) {
        self.method.record(tape);
        self.scales.record(tape);
        self.sums.record(tape);
    }
}

/// How large coordinates are, and how far steps have moved them lately.
#[derive(Clone, Copy, Debug)]
struct Scales<A> {
    sizes: Sizes<A>,
    moved: Sizes<A>,
}

/// A coordinate that has moved is worth no more than what it moves by in so many steps: its distance from zero may mean nothing.
const STEPS: f64 = 1024.0;

impl<A: Array> Scales<A> {
    fn new() -> Self {
        Scales { sizes: Sizes::new(), moved: Sizes::new() }
    }

    #[inline]
    fn include(&mut self, before: &A, moved: &A) {
        self.sizes.include(before, moved);
        self.moved.include(&A::zero(), moved);
    }

    /// What distances are measured in.
    #[inline]
    fn units(&self) -> Sizes<A> {
        let mut units = self.sizes;
        for (unit, moved) in units.entries().iter_mut().zip(self.moved.as_slice()) {
            let reached = STEPS * moved.magnitude();
            if reached > 0.0 && reached < unit.magnitude() {
                *unit = A::Real::from_f64(reached);
            }
        }
        units
    }
}

impl<A: Array> Record<A::Real> for Scales<A> {
    fn record(&mut self, tape: &mut impl Tape<A::Real>) {
        self.sizes.record(tape);
        self.moved.record(tape);
    }
}
