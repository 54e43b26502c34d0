//! Kick and drift in alternation: one driver for every table of a splitting method.
//!
//! A table says in which order and for which fractions of h the flows of T and V are applied. Time goes along twice: a
//! kick happens at the time that the drifts so far have reached, a drift at the time that the kicks so far have
//! reached. In the space extended by both clocks T and V are still exact flows, so that no table loses its order when
//! T or V depends on time.

mod kicks;

use crate::method::{Claims, Clock, Method, Probe, Refusal, Step, Unwatched};
use crate::scalar::Real;
use crate::space::{Point, Summation};
use crate::system::{QuadraticKinetic, Separable};
use core::marker::PhantomData;
pub use kicks::{DriftFirst, KickFirst, WithGradient};
use kicks::{Moving, Order, Times, Weight};

/// A table of fractions of h: outer₁, inner₁, outer₂, inner₂, …, inner_K, last, in order of application.
///
/// With `O` = [`KickFirst`] the outer flows are kicks, with [`DriftFirst`] drifts. If `last` is not zero the last flow
/// of a step and the first of the next are merged: K force evaluations a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Splitting<const K: usize, O = KickFirst> {
    claims: Claims,
    outer: [f64; K],
    inner: [f64; K],
    last: f64,
    /// What the first K kicks have of the force gradient, as parts of h³; only tables that read the same from both ends have any.
    gradients: [f64; K],
    order: PhantomData<O>,
}

impl<const K: usize, O> Splitting<K, O> {
    /// A table as it stands.
    pub const fn new(order: u32, symmetric: bool, outer: [f64; K], inner: [f64; K], last: f64) -> Self {
        let claims = Claims { order, symmetric, symplectic: true, conserves_energy: false };
        Splitting { claims, outer, inner, last, gradients: [0.0; K], order: PhantomData }
    }

    /// A table that reads the same from both ends, given by its first halves (the middle included).
    pub(crate) const fn palindrome<const OUTER: usize, const INNER: usize>(
        order: u32,
        outer: [f64; OUTER],
        inner: [f64; INNER],
    ) -> Self {
        Self::new(order, true, ends(outer), between(inner), outer[0])
    }

    /// A symmetric composition of Verlet steps γ₁h, …, γ_K h with neighbouring outer flows merged.
    pub(crate) fn of_verlet(order: u32, gamma: [f64; K]) -> Self {
        let outer = core::array::from_fn(|i| {
            let before = if i == 0 { 0.0 } else { gamma[i - 1] };
            0.5 * (before + gamma[i])
        });
        Self::new(order, true, outer, gamma, 0.5 * gamma[K - 1])
    }

    /// What the table promises.
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

impl<const K: usize> Splitting<K, KickFirst<WithGradient>> {
    /// With force gradients, by their first half.
    pub(crate) const fn with_outer_gradients<const HALF: usize>(mut self, half: [f64; HALF]) -> Self {
        self.gradients = ends(half);
        self
    }
}

impl<const K: usize> Splitting<K, DriftFirst<WithGradient>> {
    /// With force gradients, by their first half.
    pub(crate) const fn with_inner_gradients<const HALF: usize>(mut self, half: [f64; HALF]) -> Self {
        self.gradients = between(half);
        self
    }
}

/// The first K of K + 1 numbers that read the same from both ends, by their first half.
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

/// K numbers that read the same from both ends, by their first half.
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

/// A table multiplied by h: the flows of a step and the times in it at which they happen.
#[derive(Clone, Copy, Debug)]
pub struct Sequence<S: Separable<R>, R: Real, O: Order<S, R>, const K: usize> {
    first: O::Outer,
    inner: [O::Inner; K],
    /// What follows each inner flow while the steps go on: the last flow of a step is merged with the first of the next.
    outer: [O::Outer; K],
    /// What follows the last inner flow where the steps end.
    last: Option<O::Outer>,
    inner_at: [R; K],
    outer_at: [R; K],
}

impl<S: Separable<R>, R: Real, O: Order<S, R>, const K: usize> Sequence<S, R, O, K> {
    fn prepare(table: &Splitting<K, O>, system: &S, h: R) -> Self {
        let part = |fraction: f64| R::from_f64(fraction) * h;
        let reached = |fractions: &[f64]| part(fractions.iter().sum());
        let cube = h * h * h;
        let weight = |fraction: f64, gradient: f64| Weight {
            h: part(fraction),
            gradient: (gradient != 0.0).then(|| R::from_f64(gradient) * cube),
        };
        let outer = |fraction, gradient| O::prepare_outer(system, weight(fraction, gradient));
        let first = (table.outer[0], table.gradients[0]);
        let last = (table.last != 0.0).then_some((table.last, table.gradients[0]));
        let merged = last.map_or(first, |last| (first.0 + last.0, first.1 + last.1));
        Sequence {
            first: outer(first.0, first.1),
            inner: core::array::from_fn(|i| O::prepare_inner(system, weight(table.inner[i], table.gradients[i]))),
            outer: core::array::from_fn(|i| match i + 1 {
                next if next < K => outer(table.outer[next], table.gradients[next]),
                _ => outer(merged.0, merged.1),
            }),
            last: last.map(|(fraction, gradient)| outer(fraction, gradient)),
            inner_at: core::array::from_fn(|i| reached(&table.outer[..=i])),
            outer_at: core::array::from_fn(|i| if i + 1 < K { reached(&table.inner[..=i]) } else { h }),
        }
    }

    /// The times of the i-th inner flow of a step from `t`, and of the outer flow behind it.
    #[inline(always)]
    fn times(&self, t: R, i: usize) -> [Times<R>; 2] {
        let before = if i == 0 { t } else { t + self.outer_at[i - 1] };
        let (outers, inners) = (t + self.inner_at[i], t + self.outer_at[i]);
        [Times { own: before, other: outers }, Times { own: outers, other: inners }]
    }

    /// inner₁, outer₂, inner₂, …, inner_K, last.
    #[inline(always)]
    fn finish<C: Summation<S::Array>, P: Probe<S, R>>(&self, Step { system, t, x, probe }: Step<'_, S, R, C, P>) {
        for i in 0..K {
            let [inner_at, outer_at] = self.times(t, i);
            probe.visit(inner_at.other, &x.q, &x.p, &x.s);
            O::inner(&self.inner[i], inner_at, moving(system, x));
            let next = if i + 1 < K { Some(&self.outer[i]) } else { self.last.as_ref() };
            if let Some(outer) = next {
                probe.visit(outer_at.other, &x.q, &x.p, &x.s);
                O::outer(outer, outer_at, moving(system, x));
            }
        }
    }

    #[inline(always)]
    fn step<C: Summation<S::Array>, P: Probe<S, R>>(&self, step: Step<'_, S, R, C, P>) {
        let Step { system, t, x, probe } = step;
        probe.visit(t, &x.q, &x.p, &x.s);
        O::outer(&self.first, Times { own: t, other: t }, moving(system, x));
        self.finish(Step { system, t, x, probe });
    }

    #[inline(always)]
    fn advance<C: Summation<S::Array>>(
        &self,
        system: &S,
        clock: &Clock<R>,
        steps: u64,
        point: &mut Point<S::Array, C, S::Action>,
    ) {
        let Some(final_step) = steps.checked_sub(1) else { return };
        // In locals of this loop, q and p stay in registers.
        let (mut q, mut p, mut s, mut sums) = (point.q, point.p, point.s, point.sums);
        macro_rules! x {
            () => {
                Moving { system, q: &mut q, p: &mut p, s: &mut s, sums: &mut sums }
            };
        }
        let start = clock.at(0);
        O::outer(&self.first, Times { own: start, other: start }, x!());
        for n in 0..final_step {
            let t = clock.at(n);
            for i in 0..K {
                let [inner_at, outer_at] = self.times(t, i);
                O::inner(&self.inner[i], inner_at, x!());
                O::outer(&self.outer[i], outer_at, x!());
            }
        }
        (point.q, point.p, point.s, point.sums) = (q, p, s, sums);
        self.end(system, clock.at(final_step), point);
    }

    /// Apart from the loop, whose flows are then the only ones that the optimiser arranges registers for: inlined, this
    /// makes the loop over six bodies up to a fifth slower.
    #[inline(never)]
    fn end<C: Summation<S::Array>>(&self, system: &S, t: R, x: &mut Point<S::Array, C, S::Action>) {
        self.finish(Step { system, t, x, probe: &mut Unwatched });
    }
}

#[inline(always)]
fn moving<'a, S: Separable<R>, R: Real, C>(
    system: &'a S,
    x: &'a mut Point<S::Array, C, S::Action>,
) -> Moving<'a, S, R, C> {
    Moving { system, q: &mut x.q, p: &mut x.p, s: &mut x.s, sums: &mut x.sums }
}

impl<S: Separable<R>, R: Real, O: Order<S, R>, const K: usize> Method<S, R> for Splitting<K, O> {
    type Prepared = Sequence<S, R, O, K>;
    type Memory = ();

    fn claims(&self) -> Claims {
        self.claims
    }

    fn prepare(&self, system: &S, h: R) -> Self::Prepared {
        Sequence::prepare(self, system, h)
    }

    fn memory() {}

    #[inline(always)]
    fn step<C: Summation<S::Array>, P: Probe<S, R>>(
        prepared: &Self::Prepared,
        (): &mut (),
        step: Step<'_, S, R, C, P>,
    ) -> Result<(), Refusal> {
        prepared.step(step);
        Ok(())
    }

    #[inline(always)]
    fn advance<C: Summation<S::Array>>(
        prepared: &Self::Prepared,
        (): &mut (),
        system: &S,
        clock: &Clock<R>,
        steps: u64,
        x: &mut Point<S::Array, C, S::Action>,
    ) -> Result<(), Refusal> {
        prepared.advance(system, clock, steps, x);
        Ok(())
    }
}

/// A method that is another one under a stricter condition or another name.
macro_rules! delegate {
    ($(#[$doc:meta])* [$($generics:tt)*] $method:ty, $system:ident, $inner:ty, |$this:ident| $table:expr) => {
        $(#[$doc])*
        impl<$($generics)* S: $system<R>, R: Real> Method<S, R> for $method
        where
            $inner: Method<S, R, Memory = ()>,
        {
            type Prepared = <$inner as Method<S, R>>::Prepared;
            type Memory = ();

            fn claims(&self) -> Claims {
                let $this = self;
                $table.claims()
            }
            fn prepare(&self, system: &S, h: R) -> Self::Prepared {
                let $this = self;
                Method::prepare(&$table, system, h)
            }
            fn memory() {}
            #[inline(always)]
            fn step<C: Summation<S::Array>, P: Probe<S, R>>(
                prepared: &Self::Prepared,
                memory: &mut (),
                step: Step<'_, S, R, C, P>,
            ) -> Result<(), Refusal> {
                <$inner as Method<S, R>>::step(prepared, memory, step)
            }
            #[inline(always)]
            fn advance<C: Summation<S::Array>>(
                prepared: &Self::Prepared,
                memory: &mut (),
                system: &S,
                clock: &Clock<R>,
                steps: u64,
                x: &mut Point<S::Array, C, S::Action>,
            ) -> Result<(), Refusal> {
                <$inner as Method<S, R>>::advance(prepared, memory, system, clock, steps, x)
            }
        }
    };
}

/// A table of Runge–Kutta–Nyström type: its order conditions use \[V, \[V, \[V, T\]\]\] = 0, so T must be quadratic.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nystrom<const K: usize, O = KickFirst>(pub(crate) Splitting<K, O>);

impl<const K: usize, O> Nystrom<K, O> {
    /// The table.
    pub const fn table(&self) -> &Splitting<K, O> {
        &self.0
    }
}

delegate!([const K: usize, O: Order<S, R>,] Nystrom<K, O>, QuadraticKinetic, Splitting<K, O>, |this| this.0);

/// Kick, drift: p₁ = p₀ − h V'(q₀), q₁ = q₀ + h T'(p₁). Order 1, symplectic; its adjoint is
/// [`SymplecticEulerAdjoint`]. R. de Vogelaere 1956; Hairer, Lubich & Wanner, *Geometric Numerical Integration*,
/// (I.1.9).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SymplecticEuler;

/// Drift, kick: q₁ = q₀ + h T'(p₀), p₁ = p₀ − h V'(q₁), the adjoint of [`SymplecticEuler`]. Order 1, symplectic.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SymplecticEulerAdjoint;

/// Half a kick, a drift, half a kick ("velocity Verlet", leapfrog). Order 2, symmetric, symplectic, one force a step.
///
/// The method of choice when the step is set by the fastest frequency ω (stable for hω < 2) and not by accuracy.
/// C. Störmer 1907; L. Verlet, Phys. Rev. 159 (1967) 98; Hairer, Lubich & Wanner (I.1.17).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct StormerVerlet;

/// Half a drift, a kick, half a drift ("position Verlet"): [`StormerVerlet`] with the roles exchanged. Order 2,
/// symmetric, symplectic, one force a step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PositionVerlet;

delegate!([] SymplecticEuler, Separable, Splitting<1, KickFirst>, |_this| Splitting::<1, KickFirst>::new(1, false, [1.0], [1.0], 0.0));
delegate!([] SymplecticEulerAdjoint, Separable, Splitting<1, DriftFirst>, |_this| Splitting::<1, DriftFirst>::new(1, false, [1.0], [1.0], 0.0));
delegate!([] StormerVerlet, Separable, Splitting<1, KickFirst>, |_this| Splitting::<1, KickFirst>::new(2, true, [0.5], [1.0], 0.5));
delegate!([] PositionVerlet, Separable, Splitting<1, DriftFirst>, |_this| Splitting::<1, DriftFirst>::new(2, true, [0.5], [1.0], 0.5));
