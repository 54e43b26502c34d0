//! What an expert writes for one system and one method: the other side of every ratio.
//!
//! Kicks of neighbouring steps are merged, h and parameters are folded into constants before the loop, positions and
//! momenta are locals. Only the fractions of the splitting tables are taken from the runtime; nothing else is.

pub(crate) mod chain;
pub(crate) mod damped_oscillator;
pub(crate) mod double_pendulum;
pub(crate) mod free_body;
pub(crate) mod heavy_body;
pub(crate) mod henon_heiles;
mod increments;
pub(crate) mod kepler;
pub(crate) mod lotka_volterra;
pub(crate) mod outer_solar_system;
pub(crate) mod pendulum;
pub(crate) mod perturbed_kepler;

use geoint_runtime::{Composition, Splitting};

/// a·b + c, fused where this build's processor does that in one instruction, as the runtime does it.
#[inline(always)]
fn fma(a: f64, b: f64, c: f64) -> f64 {
    if cfg!(target_feature = "fma") { a.mul_add(b, c) } else { a * b + c }
}

/// A splitting table as a loop runs through it: `first`, then K times an inner and an outer flow a step.
///
/// The last outer flow of a step is merged with the first of the next. After the last step that is `first` too much, which
/// an outer flow of −`first` takes back.
#[derive(Clone, Copy)]
pub(crate) struct Stages<const K: usize> {
    first: f64,
    inner: [f64; K],
    outer: [f64; K],
}

impl<const K: usize> Stages<K> {
    /// Fractions of a step.
    #[inline(always)]
    pub(crate) fn of<O>(table: &Splitting<K, O>) -> Self {
        let (x, last, y) = table.coefficients();
        let merged = |i: usize| if i + 1 < K { x[i + 1] } else { last + x[0] };
        Stages { first: x[0], inner: *y, outer: std::array::from_fn(merged) }
    }

    /// Those of a composition of steps, half an outer flow, an inner one, half an outer flow.
    #[inline(always)]
    pub(crate) fn composed(table: &Composition<K>) -> Self {
        let weights = table.weights();
        let merged = |i: usize| 0.5 * (weights[i] + weights[(i + 1) % K]);
        Stages { first: 0.5 * weights[0], inner: *weights, outer: std::array::from_fn(merged) }
    }

    #[inline(always)]
    fn times(self, outer: f64, inner: f64) -> Self {
        Stages { first: self.first * outer, inner: self.inner.map(|y| y * inner), outer: self.outer.map(|x| x * outer) }
    }
}
