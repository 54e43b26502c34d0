//! Symplectic Euler and Verlet methods, and Verlet's method for rigid bodies.
//!
//! All are for H = T(p) + V(q): a kick is the flow of V, and a drift is the flow of T. `Splitting<1>` has one kick or drift between two outer flows, and costs one
//! force a step in a run: the last flow of a step is merged with the first one of the next.

#![allow(non_upper_case_globals, reason = "methods are values: `system.integrator(StormerVerlet, …)`")]

use super::delegate;
use super::kinds::KickAndRotations;
use super::table::Flow::{Drift, Kick};
use super::table::Splitting;
use crate::method::{Claims, Clock, Failure, Method, Name, Probe, Step};
use crate::scalar::Real;
use crate::space::{Point, Summation};
use crate::system::Separable;

/// Kick, drift: p₁ = p₀ − h V'(q₀), q₁ = q₀ + h T'(p₁). Order 1, symplectic; its adjoint is
/// [`SymplecticEulerAdjoint`]. R. de Vogelaere 1956; Hairer, Lubich & Wanner, *Geometric Numerical Integration*,
/// (I.1.9).
#[doc(alias("semi-implicit Euler", "Euler-Cromer"))]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SymplecticEuler;

impl SymplecticEuler {
    /// Kick, drift.
    pub const TABLE: Splitting<1> = Splitting::new(1, [Kick(1.0), Drift(1.0)]).named("SymplecticEuler");
}

/// Drift, kick: q₁ = q₀ + h T'(p₀), p₁ = p₀ − h V'(q₁), the adjoint of [`SymplecticEuler`]. Order 1, symplectic.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SymplecticEulerAdjoint;

impl SymplecticEulerAdjoint {
    /// Drift, kick.
    pub const TABLE: Splitting<1> = Splitting::new(1, [Drift(1.0), Kick(1.0)]).named("SymplecticEulerAdjoint");
}

// These two are types of their own, not tables, so that `Yoshida4.of(SymplecticEuler)` does not compile: they are not symmetric.
delegate!([] SymplecticEuler, [Separable<R>], Splitting<1>, |_this| SymplecticEuler::TABLE);
delegate!([] SymplecticEulerAdjoint, [Separable<R>], Splitting<1>, |_this| SymplecticEulerAdjoint::TABLE);

/// Half a kick, a drift, half a kick ("velocity Verlet", leapfrog). Order 2, symmetric, symplectic, one force a step.
///
/// Use it if stability limits the step (hω < 2 for the fastest frequency ω), not accuracy.
/// C. Störmer 1907; L. Verlet, Phys. Rev. 159 (1967) 98; Hairer, Lubich & Wanner (I.1.17).
#[doc(alias("leapfrog", "velocity Verlet", "Verlet", "KDK", "kick-drift-kick"))]
pub const StormerVerlet: Splitting<1> = Splitting::new(2, [Kick(0.5), Drift(1.0), Kick(0.5)]).named("StormerVerlet");

/// Half a drift, a kick, half a drift ("position Verlet"): [`StormerVerlet`] with the roles exchanged. Order 2,
/// symmetric, symplectic, one force a step.
#[doc(alias("position Verlet", "drift-kick-drift", "DKD"))]
pub const PositionVerlet: Splitting<1> = Splitting::new(2, [Drift(0.5), Kick(1.0), Drift(0.5)]).named("PositionVerlet");

/// Half a kick, five rotations of every rigid body about its principal axes, half a kick. Order 2, symmetric, symplectic, one torque
/// a step. It needs no series and is cheaper than [`StormerVerlet`], whose drift is the exact flow of the free
/// body. In the tests the error is about 1.5 times as large.
///
/// The rotations have order 2, so they would lower the order of higher-order tables. Only this method uses them.
/// A. Dullweber, B. Leimkuhler & R. McLachlan, J. Chem. Phys. 107 (1997) 5840.
#[doc(alias("rigid body splitting", "DLM"))]
pub const FiveRotations: Splitting<1, KickAndRotations> =
    // With `KickAndRotations`, a drift stands for rotations about the axes 1, 2, 3, 2, 1. All but the third take half of the time.
    Splitting::of_flows(2, [Kick(0.5), Drift(1.0), Kick(0.5)]).named("FiveRotations");
