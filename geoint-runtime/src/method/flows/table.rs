//! Tables of splitting methods: fractions of h, in order of application.

use super::kinds::{KickAndDrift, WithGradient};
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

impl Flow {
    /// The fraction of h.
    pub(super) const fn fraction(self) -> f64 {
        match self {
            Flow::Kick(fraction) | Flow::Drift(fraction) => fraction,
        }
    }
}

/// A flow of a table. A kick may have a force gradient.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Entry {
    pub(super) flow: Flow,
    /// The fraction of h³ for the force gradient.
    pub(super) gradient: f64,
}

/// A splitting method for H = T(p) + V(q): kicks and drifts for fractions of h in alternation, in order of application.
///
/// With outer and inner flows it is outer₁, inner₁, outer₂, inner₂, …, inner_K, and perhaps a last outer flow. The outer flows are kicks or drifts. If there is a
/// last outer flow, it is merged with the first flow of the next step. A step of a long run costs K force evaluations. `F` is the kind of the flows.
///
/// ```
/// use geoint_runtime::method::flows::Flow::{Drift, Kick};
/// use geoint_runtime::{Splitting, StormerVerlet};
///
/// const LEAPFROG: Splitting<1> = Splitting::new(2, [Kick(0.5), Drift(1.0), Kick(0.5)]);
/// assert_eq!(LEAPFROG.named("StormerVerlet"), StormerVerlet);
/// ```
///
/// A table whose fractions do not add up to 1 does not compile:
///
/// ```compile_fail,E0080
/// # use geoint_runtime::Splitting;
/// # use geoint_runtime::method::flows::Flow::{Drift, Kick};
/// const LEAPFROG: Splitting<1> = Splitting::new(2, [Kick(0.5), Drift(1.0), Kick(0.6)]);
/// ```
///
/// A table without flows, or with flows that do not alternate, does not compile:
///
/// ```compile_fail,E0080
/// # use geoint_runtime::Splitting;
/// const NOTHING: Splitting<0> = Splitting::new(1, []);
/// ```
///
/// ```compile_fail,E0080
/// # use geoint_runtime::Splitting;
/// # use geoint_runtime::method::flows::Flow::{Drift, Kick};
/// const KICKS: Splitting<1> = Splitting::new(1, [Kick(0.5), Kick(0.5), Drift(1.0)]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Splitting<const K: usize, F = KickAndDrift> {
    name: Name,
    claims: Claims,
    /// Whether the outer flows are kicks.
    kick_first: bool,
    outer: [f64; K],
    inner: [f64; K],
    last: f64,
    /// Fractions of h³ for the force gradients of the first K kicks. Only palindromic tables have force gradients.
    gradients: [f64; K],
    kind: PhantomData<F>,
}

impl<const K: usize> Splitting<K> {
    /// Returns a table of flows in order of application: 2K flows, or 2K + 1 with a last outer flow.
    ///
    /// It is symmetric if the flows are a palindrome. The order is not checked.
    ///
    /// # Panics
    /// If K is 0, if kicks and drifts do not alternate, or if the fractions of either do not add up to 1. For a constant table
    /// this is an error of compilation.
    pub const fn new<const N: usize>(order: u32, flows: [Flow; N]) -> Self {
        Self::of_flows(order, flows)
    }

    /// Returns the composition of steps of a table with one pair of flows, of the lengths γ₁h, …, γ_K h, with neighbouring outer flows merged.
    ///
    /// `order` is that of the composition of a symmetric map. If the map is not symmetric, the composition has order 1.
    pub(in crate::method) fn composed(name: Name, order: u32, gamma: &[f64; K], map: &Splitting<1>) -> Self {
        let outer = core::array::from_fn(|i| {
            let before = if i == 0 { 0.0 } else { gamma[i - 1] * map.last };
            before + gamma[i] * map.outer[0]
        });
        let order = if map.claims.symmetric { order } else { 1 };
        Self::checked(name.of(map.name), order, map.kick_first, outer, *gamma, gamma[K - 1] * map.last)
    }
}

impl<const K: usize, F> Splitting<K, F> {
    /// Returns the table of the flows; see [`new`](Splitting::new).
    pub(super) const fn of_flows<const N: usize>(order: u32, flows: [Flow; N]) -> Self {
        assert!(K >= 1, "a splitting has at least one inner flow");
        assert!(N == 2 * K || N == 2 * K + 1, "a table has K outer and K inner flows, and perhaps a last outer one");
        let kick_first = matches!(flows[0], Flow::Kick(_));
        let (mut fractions, mut i) = ([[0.0; 2]; K], 0);
        while i < N {
            assert!(matches!(flows[i], Flow::Kick(_)) == (kick_first == (i % 2 == 0)), "kicks and drifts alternate");
            if i < 2 * K {
                fractions[i / 2][i % 2] = flows[i].fraction();
            }
            i += 1;
        }
        let (mut outer, mut inner) = ([0.0; K], [0.0; K]);
        i = 0;
        while i < K {
            [outer[i], inner[i]] = fractions[i];
            i += 1;
        }
        let last = if N == 2 * K { 0.0 } else { flows[N - 1].fraction() };
        Self::checked(Name::new("Splitting"), order, kick_first, outer, inner, last)
    }

    /// Returns the table with its claims. It is symmetric if the fractions are a palindrome.
    ///
    /// # Panics
    /// If the fractions of the outer or of the inner flows do not add up to 1.
    const fn checked(name: Name, order: u32, kick_first: bool, outer: [f64; K], inner: [f64; K], last: f64) -> Self {
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
        Splitting { name, claims, kick_first, outer, inner, last, gradients: [0.0; K], kind: PhantomData }
    }

    /// Returns a palindromic table that begins with a kick, given by the first halves of its kicks and drifts (the middle included).
    pub(in crate::method) const fn kick_first<const KICKS: usize, const DRIFTS: usize>(
        name: &'static str,
        order: u32,
        kicks: [f64; KICKS],
        drifts: [f64; DRIFTS],
    ) -> Self {
        Self::checked(Name::new(name), order, true, ends(kicks), between(drifts), kicks[0])
    }

    /// Returns a palindromic table that begins with a drift, given by the first halves of its drifts and kicks (the middle included).
    pub(in crate::method) const fn drift_first<const DRIFTS: usize, const KICKS: usize>(
        name: &'static str,
        order: u32,
        drifts: [f64; DRIFTS],
        kicks: [f64; KICKS],
    ) -> Self {
        Self::checked(Name::new(name), order, false, ends(drifts), between(kicks), drifts[0])
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

    /// The i-th flow in order of application, from 0 to 2K. A table without a last outer flow has the fraction 0 there.
    pub(super) const fn entry(&self, i: usize) -> Entry {
        // Tables with force gradients are palindromes: the last kick is the first one.
        let (fraction, place) = match (i == 2 * K, i % 2) {
            (true, _) => (self.last, 0),
            (_, 0) => (self.outer[i / 2], i / 2),
            _ => (self.inner[i / 2], i / 2),
        };
        if i.is_multiple_of(2) == self.kick_first {
            Entry { flow: Flow::Kick(fraction), gradient: self.gradients[place] }
        } else {
            Entry { flow: Flow::Drift(fraction), gradient: 0.0 }
        }
    }

    /// The last flow of a step together with the first flow of the next.
    pub(super) const fn joint(&self) -> Entry {
        let (start, end) = (self.entry(0), self.entry(2 * K));
        let (fraction, gradient) = (start.flow.fraction() + end.flow.fraction(), start.gradient + end.gradient);
        Entry { flow: if self.kick_first { Flow::Kick(fraction) } else { Flow::Drift(fraction) }, gradient }
    }

    /// Whether the outer flows are kicks.
    pub const fn is_kick_first(&self) -> bool {
        self.kick_first
    }

    /// Fractions of h³ for the force gradients of the first K kicks.
    pub const fn gradients(&self) -> &[f64; K] {
        &self.gradients
    }
}

impl<const K: usize> Splitting<K, WithGradient> {
    /// Adds force gradients to the kicks, given by the first half of their fractions of h³.
    pub(in crate::method) const fn with_gradients<const HALF: usize>(mut self, half: [f64; HALF]) -> Self {
        self.gradients = if self.kick_first { ends(half) } else { between(half) };
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
