//! Symplectic Euler and Verlet methods, as tables of one inner flow.

use super::delegate;
use super::flows::{DriftFirst, KickFirst};
use super::table::{
    Flow::{Drift, Kick},
    Splitting,
};
use crate::method::{Claims, Clock, Failure, Method, Name, Probe, Step};
use crate::scalar::Real;
use crate::space::{Point, Summation};
use crate::system::Separable;

/// Kick, drift: p₁ = p₀ − h V'(q₀), q₁ = q₀ + h T'(p₁). Order 1, symplectic; its adjoint is
/// [`SymplecticEulerAdjoint`]. R. de Vogelaere 1956; Hairer, Lubich & Wanner, *Geometric Numerical Integration*,
/// (I.1.9).
#[doc(alias("semi-implicit Euler", "Euler-Cromer", "Euler"))]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SymplecticEuler;

impl SymplecticEuler {
    /// Kick, drift.
    pub const TABLE: Splitting<1, KickFirst> = Splitting::<1, KickFirst>::new(1, [Kick(1.0), Drift(1.0)]);
}

/// Drift, kick: q₁ = q₀ + h T'(p₀), p₁ = p₀ − h V'(q₁), the adjoint of [`SymplecticEuler`]. Order 1, symplectic.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SymplecticEulerAdjoint;

impl SymplecticEulerAdjoint {
    /// Drift, kick.
    pub const TABLE: Splitting<1, DriftFirst> = Splitting::<1, DriftFirst>::new(1, [Drift(1.0), Kick(1.0)]);
}

/// Half a kick, a drift, half a kick ("velocity Verlet", leapfrog). Order 2, symmetric, symplectic, one force a step.
///
/// Use it if the fastest frequency ω limits the step (it is stable for hω < 2), and not the accuracy.
/// C. Störmer 1907; L. Verlet, Phys. Rev. 159 (1967) 98; Hairer, Lubich & Wanner (I.1.17).
#[doc(alias("leapfrog", "velocity Verlet", "Verlet", "KDK", "kick-drift-kick"))]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct StormerVerlet;

impl StormerVerlet {
    /// Half a kick, a drift, half a kick.
    pub const TABLE: Splitting<1, KickFirst> = Splitting::<1, KickFirst>::new(2, [Kick(0.5), Drift(1.0), Kick(0.5)]);
}

/// Half a drift, a kick, half a drift ("position Verlet"): [`StormerVerlet`] with the roles exchanged. Order 2,
/// symmetric, symplectic, one force a step.
#[doc(alias("position Verlet", "drift-kick-drift", "DKD"))]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PositionVerlet;

impl PositionVerlet {
    /// Half a drift, a kick, half a drift.
    pub const TABLE: Splitting<1, DriftFirst> = Splitting::<1, DriftFirst>::new(2, [Drift(0.5), Kick(1.0), Drift(0.5)]);
}

delegate!([] SymplecticEuler, Separable, Splitting<1, KickFirst>, |_this| SymplecticEuler::TABLE, Name::new(stringify!(SymplecticEuler)));
delegate!([] SymplecticEulerAdjoint, Separable, Splitting<1, DriftFirst>, |_this| SymplecticEulerAdjoint::TABLE, Name::new(stringify!(SymplecticEulerAdjoint)));
delegate!([] StormerVerlet, Separable, Splitting<1, KickFirst>, |_this| StormerVerlet::TABLE, Name::new(stringify!(StormerVerlet)));
delegate!([] PositionVerlet, Separable, Splitting<1, DriftFirst>, |_this| PositionVerlet::TABLE, Name::new(stringify!(PositionVerlet)));
