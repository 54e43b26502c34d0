//! Symplectic Euler and Verlet methods, and Verlet's method for rigid bodies.

#![allow(non_upper_case_globals, reason = "methods are values: `system.integrator(StormerVerlet, …)`")]

use super::kinds::KickAndRotations;
use super::table::Flow::{Drift, Kick};
use super::table::Splitting;

/// Kick, drift: p₁ = p₀ − h V'(q₀), q₁ = q₀ + h T'(p₁). Order 1, symplectic; its adjoint is
/// [`SymplecticEulerAdjoint`]. R. de Vogelaere 1956; Hairer, Lubich & Wanner, *Geometric Numerical Integration*,
/// (I.1.9).
#[doc(alias("semi-implicit Euler", "Euler-Cromer", "Euler"))]
pub const SymplecticEuler: Splitting<1> = Splitting::new(1, [Kick(1.0), Drift(1.0)]).named("SymplecticEuler");

/// Drift, kick: q₁ = q₀ + h T'(p₀), p₁ = p₀ − h V'(q₁), the adjoint of [`SymplecticEuler`]. Order 1, symplectic.
pub const SymplecticEulerAdjoint: Splitting<1> =
    Splitting::new(1, [Drift(1.0), Kick(1.0)]).named("SymplecticEulerAdjoint");

/// Half a kick, a drift, half a kick ("velocity Verlet", leapfrog). Order 2, symmetric, symplectic, one force a step.
///
/// Use it if the fastest frequency ω limits the step (it is stable for hω < 2), and not the accuracy.
/// C. Störmer 1907; L. Verlet, Phys. Rev. 159 (1967) 98; Hairer, Lubich & Wanner (I.1.17).
#[doc(alias("leapfrog", "velocity Verlet", "Verlet", "KDK", "kick-drift-kick"))]
pub const StormerVerlet: Splitting<1> = Splitting::new(2, [Kick(0.5), Drift(1.0), Kick(0.5)]).named("StormerVerlet");

/// Half a drift, a kick, half a drift ("position Verlet"): [`StormerVerlet`] with the roles exchanged. Order 2,
/// symmetric, symplectic, one force a step.
#[doc(alias("position Verlet", "drift-kick-drift", "DKD"))]
pub const PositionVerlet: Splitting<1> = Splitting::new(2, [Drift(0.5), Kick(1.0), Drift(0.5)]).named("PositionVerlet");

/// Half a kick, five rotations of every rigid body about its principal axes, half a kick. Order 2, symmetric, symplectic, one torque
/// a step. It needs no series and is cheaper than [`StormerVerlet`], whose drift is the exact flow of the free
/// body. The error is about 1.5 times as large.
///
/// The rotations have order 2, so they would lower the order of higher-order tables. Only this method uses them.
/// A. Dullweber, B. Leimkuhler & R. McLachlan, J. Chem. Phys. 107 (1997) 5840.
#[doc(alias("rigid body splitting", "DLM"))]
pub const FiveRotations: Splitting<1, KickAndRotations> =
    Splitting::of_flows(2, [Kick(0.5), Drift(1.0), Kick(0.5)]).named("FiveRotations");
