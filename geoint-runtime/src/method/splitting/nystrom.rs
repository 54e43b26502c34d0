//! Tables for a quadratic T.

use super::delegate;
use super::flows::{KickFirst, Order};
use super::table::Splitting;
use crate::method::{Claims, Clock, Method, Name, Probe, Refusal, Step};
use crate::scalar::Real;
use crate::space::{Point, Summation};
use crate::system::QuadraticKinetic;

/// A table of Runge–Kutta–Nyström type: its order conditions use \[V, \[V, \[V, T\]\]\] = 0, so T must be quadratic.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nystrom<const K: usize, O = KickFirst>(pub(in crate::method) Splitting<K, O>);

impl<const K: usize, O> Nystrom<K, O> {
    /// The table.
    pub const fn table(&self) -> &Splitting<K, O> {
        &self.0
    }
}

delegate!([const K: usize, O: Order<S, R>,] Nystrom<K, O>, QuadraticKinetic, Splitting<K, O>, |this| this.0, this.0.name());
