//! Tables of splitting methods: fractions of h, in order of application.

use super::flows::{DriftFirst, KickFirst};
use super::kicks::WithGradient;
use crate::method::tables::total::adds_up;
use crate::method::{Claims, Name};
use core::marker::PhantomData;

/// The flow of V or of T for a fraction of h.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Flow {
    /// The flow of V: p ← p − fraction·h ∂V/∂q.
    Kick(f64),
    /// The flow of T: q ← q + fraction·h ∂T/∂p.
    Drift(f64),
}

/// Fractions of h: outer₁, inner₁, outer₂, inner₂, …, inner_K, last, in order of application.
///
/// With `O` = [`KickFirst`] the outer flows are kicks, with [`DriftFirst`] drifts. If `last` is not zero, the last flow of a
/// step and the first flow of the next step are merged. A step costs K force evaluations.
///
/// ```
/// use geoint_runtime::method::splitting::{Flow::{Drift, Kick}, KickFirst};
/// use geoint_runtime::{Splitting, StormerVerlet};
///
/// const LEAPFROG: Splitting<1, KickFirst> = Splitting::<1, KickFirst>::new(2, [Kick(0.5), Drift(1.0), Kick(0.5)]);
/// assert_eq!(LEAPFROG, StormerVerlet::TABLE);
/// ```
///
/// A table whose fractions do not add up to 1 does not compile:
///
/// ```compile_fail,E0080
/// # use geoint_runtime::Splitting;
/// # use geoint_runtime::method::splitting::{Flow::{Drift, Kick}, KickFirst};
/// const LEAPFROG: Splitting<1, KickFirst> = Splitting::<1, KickFirst>::new(2, [Kick(0.5), Drift(1.0), Kick(0.6)]);
/// ```
///
/// A table without flows, or with flows that do not alternate, does not compile:
///
/// ```compile_fail,E0080
/// # use geoint_runtime::Splitting;
/// # use geoint_runtime::method::splitting::KickFirst;
/// const NOTHING: Splitting<0, KickFirst> = Splitting::<0, KickFirst>::new(1, []);
/// ```
///
/// ```compile_fail,E0080
/// # use geoint_runtime::Splitting;
/// # use geoint_runtime::method::splitting::{Flow::{Drift, Kick}, KickFirst};
/// const DRIFTS: Splitting<1, KickFirst> = Splitting::<1, KickFirst>::new(1, [Drift(1.0), Kick(1.0)]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Splitting<const K: usize, O = KickFirst> {
    pub(in crate::method) name: Name,
    claims: Claims,
    pub(super) outer: [f64; K],
    pub(super) inner: [f64; K],
    pub(super) last: f64,
    /// Fractions of h³ for the force gradients of the first K kicks. Only palindromic tables have force gradients.
    pub(super) gradients: [f64; K],
    order: PhantomData<O>,
}

impl<const K: usize, F> Splitting<K, KickFirst<F>> {
    /// Returns a table of flows in order of application, a kick first: 2K flows, or 2K + 1 with a last kick.
    ///
    /// It is symmetric if the flows are a palindrome. The order is not checked.
    ///
    /// # Panics
    /// If K is 0, if kicks and drifts do not alternate, or if the fractions of either do not add up to 1. For a constant table
    /// this is an error of compilation.
    pub const fn new<const N: usize>(order: u32, flows: [Flow; N]) -> Self {
        Self::of_flows(order, true, flows)
    }
}

impl<const K: usize, F> Splitting<K, DriftFirst<F>> {
    /// Returns a table of flows in order of application, a drift first: 2K flows, or 2K + 1 with a last drift.
    ///
    /// It is symmetric if the flows are a palindrome. The order is not checked.
    ///
    /// # Panics
    /// If K is 0, if drifts and kicks do not alternate, or if the fractions of either do not add up to 1. For a constant table
    /// this is an error of compilation.
    pub const fn new<const N: usize>(order: u32, flows: [Flow; N]) -> Self {
        Self::of_flows(order, false, flows)
    }
}

impl<const K: usize, O> Splitting<K, O> {
    /// Returns the table of the flows.
    pub(super) const fn of_flows<const N: usize>(order: u32, kick_first: bool, flows: [Flow; N]) -> Self {
        Self::of_fractions(order, alternating(kick_first, flows))
    }

    /// Returns the table of 2K fractions, or of 2K + 1 fractions with a last outer flow.
    const fn of_fractions<const N: usize>(order: u32, fractions: [f64; N]) -> Self {
        assert!(K >= 1, "a splitting has at least one inner flow");
        assert!(N == 2 * K || N == 2 * K + 1, "a table has K outer and K inner flows, and perhaps a last outer one");
        let (mut outer, mut inner) = ([0.0; K], [0.0; K]);
        let mut i = 0;
        while i < K {
            (outer[i], inner[i]) = (fractions[2 * i], fractions[2 * i + 1]);
            i += 1;
        }
        Self::checked(Name::new("Splitting"), order, outer, inner, if N == 2 * K { 0.0 } else { fractions[2 * K] })
    }

    /// Returns the table with its claims. It is symmetric if the fractions are a palindrome.
    ///
    /// # Panics
    /// If the fractions of the outer or of the inner flows do not add up to 1.
    const fn checked(name: Name, order: u32, outer: [f64; K], inner: [f64; K], last: f64) -> Self {
        let (mut symmetric, mut i) = (true, 0);
        while i < K {
            let mirrored = if i == 0 { last } else { outer[K - i] };
            symmetric = symmetric && outer[i] == mirrored && inner[i] == inner[K - 1 - i];
            i += 1;
        }
        assert!(adds_up(&outer, 1.0 - last), "the fractions of the outer flows add up to 1");
        assert!(adds_up(&inner, 1.0), "the fractions of the inner flows add up to 1");
        let forces = Some(K as u32);
        let claims = Claims { order, symmetric, symplectic: true, conserves_energy: false, perturbed: &[], forces };
        Splitting { name, claims, outer, inner, last, gradients: [0.0; K], order: PhantomData }
    }

    /// Returns a palindromic table, given by the first halves of its fractions (the middle included).
    pub(in crate::method) const fn palindrome<const OUTER: usize, const INNER: usize>(
        name: &'static str,
        order: u32,
        outer: [f64; OUTER],
        inner: [f64; INNER],
    ) -> Self {
        Self::checked(Name::new(name), order, ends(outer), between(inner), outer[0])
    }

    /// Returns the symmetric composition of Verlet steps γ₁h, …, γ_K h with neighbouring outer flows merged.
    pub(in crate::method) fn of_verlet(name: Name, order: u32, gamma: [f64; K]) -> Self {
        let outer = core::array::from_fn(|i| {
            let before = if i == 0 { 0.0 } else { gamma[i - 1] };
            0.5 * (before + gamma[i])
        });
        Self::checked(name, order, outer, gamma, 0.5 * gamma[K - 1])
    }

    /// States the orders sᵢ of a table for H = A + εB, whose error is O(ε hˢ¹ + ε² hˢ² + …).
    pub(in crate::method) const fn near_integrable(mut self, orders: &'static [u32]) -> Self {
        self.claims.perturbed = orders;
        self
    }

    /// Sets the name of the table.
    pub const fn named(mut self, name: &'static str) -> Self {
        self.name = Name::new(name);
        self
    }

    /// The name.
    pub const fn name(&self) -> Name {
        self.name
    }

    /// The claims of the table.
    pub const fn claims(&self) -> Claims {
        self.claims
    }

    /// Fractions of h for the outer flows, the last one included, and for the inner flows.
    pub const fn coefficients(&self) -> (&[f64; K], f64, &[f64; K]) {
        (&self.outer, self.last, &self.inner)
    }

    /// Fractions of h³ for the force gradients of the first K kicks.
    pub const fn gradients(&self) -> &[f64; K] {
        &self.gradients
    }
}

/// Returns the fractions of flows that alternate.
const fn alternating<const N: usize>(kick_first: bool, flows: [Flow; N]) -> [f64; N] {
    let mut fractions = [0.0; N];
    let mut i = 0;
    while i < N {
        fractions[i] = match (flows[i], kick_first == (i % 2 == 0)) {
            (Flow::Kick(fraction), true) | (Flow::Drift(fraction), false) => fraction,
            _ => panic!("kicks and drifts alternate; `KickFirst` begins with a kick, `DriftFirst` with a drift"),
        };
        i += 1;
    }
    fractions
}

impl<const K: usize> Splitting<K, KickFirst<WithGradient>> {
    /// Adds force gradients to the kicks, given by the first half of their fractions of h³.
    pub(in crate::method) const fn with_outer_gradients<const HALF: usize>(mut self, half: [f64; HALF]) -> Self {
        self.gradients = ends(half);
        self
    }
}

impl<const K: usize> Splitting<K, DriftFirst<WithGradient>> {
    /// Adds force gradients to the kicks, given by the first half of their fractions of h³.
    pub(in crate::method) const fn with_inner_gradients<const HALF: usize>(mut self, half: [f64; HALF]) -> Self {
        self.gradients = between(half);
        self
    }
}

/// Returns the first K of K + 1 numbers of a palindrome, given by its first half.
const fn ends<const K: usize, const HALF: usize>(half: [f64; HALF]) -> [f64; K] {
    assert!(HALF == K / 2 + 1);
    let mut all = [0.0; K];
    let mut i = 0;
    while i < K {
        all[i] = half[if i < HALF { i } else { K - i }];
        i += 1;
    }
    all
}

/// Returns the K numbers of a palindrome, given by its first half.
const fn between<const K: usize, const HALF: usize>(half: [f64; HALF]) -> [f64; K] {
    assert!(HALF == K.div_ceil(2));
    let mut all = [0.0; K];
    let mut i = 0;
    while i < K {
        all[i] = half[if i < HALF { i } else { K - 1 - i }];
        i += 1;
    }
    all
}
