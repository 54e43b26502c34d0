//! Exact flows of pieces, one after the other and back.
//!
//! With Φ(h) for all flows in order and Φ*(h) for them in reverse, every table here is Φ*(β_K h) Φ(α_K h) … Φ*(β₁h) Φ(α₁h). The last
//! flow of a Φ and the first one of the Φ* behind it belong to one piece and are merged. Time, where it is frozen, moves
//! before all flows of Φ and after all flows of Φ*: between Φ and Φ* it is the same for all flows.

use crate::method::composition::substeps;
use crate::method::tables::total::adds_up;
use crate::method::{Claims, Clock, Method, Name, Probe, Refusal, Step, Unwatched};
use crate::scalar::Real;
use crate::space::{PerCoordinate, Point, Summation};
use crate::system::{Clock as PieceClock, Pieces};

/// e^(h/2 X₁) … e^(h/2 Xₖ₋₁) e^(h Xₖ) e^(h/2 Xₖ₋₁) … e^(h/2 X₁): the exact flows of the pieces of H, with a kick or else the most
/// expensive flow in the middle. Order 2, symmetric, a contact map; the flow of every piece but the last is applied twice a step.
///
/// Where the flow of a piece ends within a step, as that of H = s² does, the step is refused with the name of the piece.
/// A. Bravetti, M. Seri, M. Vermeeren & F. Zadra, Celest. Mech. Dyn. Astr. 132 (2020) 7.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ContactSplitting;

/// What a step needs.
#[derive(Clone, Copy, Debug)]
pub struct Prepared<F, R> {
    flows: F,
    /// The first flow of a step merged with the last one of the step before.
    merged: F,
    half: R,
}

impl<S: Pieces<R>, R: Real> Method<S, R> for ContactSplitting {
    type Proof = <S as Pieces<R>>::Proof;
    type Prepared = Prepared<S::Flows, R>;
    type Memory = ();

    fn claims(&self) -> Claims {
        Claims { order: 2, symmetric: true, symplectic: true, conserves_energy: false, forces: Some(1) }
    }

    fn name(&self) -> Name {
        Name::new("ContactSplitting")
    }

    fn prepare(&self, system: &S, h: R) -> Self::Prepared {
        let half = R::from_f64(0.5) * h;
        Prepared { flows: system.prepare_flows(half, h), merged: system.prepare_flows(h, h), half }
    }

    fn memory() {}

    #[inline(always)]
    fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        Prepared { flows, half, .. }: &Self::Prepared,
        (): &mut (),
        mut step: Step<'_, S, R, C, P>,
    ) -> Result<(), Refusal> {
        let (all, start, middle) = (S::PIECES.len(), step.t, step.t + *half);
        let frozen = step.system.freeze(flows, middle);
        step.probe.visit(start, &step.x.z, &step.x.s);
        pass(0..all, (flows, &frozen), step.part(start));
        pass((0..all - 1).rev(), (flows, &frozen), step.part(middle));
        Ok(())
    }

    #[inline(always)]
    fn advance<C: Summation<S::Phase>>(
        prepared: &Self::Prepared,
        (): &mut (),
        system: &S,
        clock: &Clock<R>,
        steps: u64,
        x: &mut Point<S::Phase, C, S::Action>,
    ) -> Result<(), Refusal> {
        let Prepared { flows, merged, half } = prepared;
        let (all, probe) = (S::PIECES.len(), &mut Unwatched);
        // Flows at frozen time begin anew with every step.
        if all < 2 || S::PIECES[0].clock == PieceClock::Stage {
            let step = |n| Self::step(prepared, &mut (), Step { system, t: clock.at(n), x, probe });
            return (0..steps).try_for_each(step);
        }
        let Some(last) = steps.checked_sub(1) else { return Ok(()) };
        let start = clock.at(0);
        pass(0..1, (flows, &system.freeze(flows, start)), Step { system, t: start, x, probe });
        for n in 0..steps {
            let (t, middle) = (clock.at(n), clock.at(n) + *half);
            let frozen = system.freeze(flows, middle);
            let outer = if n == last { flows } else { merged };
            pass(1..all, (flows, &frozen), Step { system, t, x, probe });
            pass((1..all - 1).rev(), (flows, &frozen), Step { system, t: middle, x, probe });
            pass(0..1, (outer, &frozen), Step { system, t: middle, x, probe });
        }
        Ok(())
    }
}

/// The flows of some pieces one after the other, each from the time of `step` on.
#[inline(always)]
fn pass<S: Pieces<R>, R: Real, C: Summation<S::Phase>, P: Probe<S, R>>(
    pieces: impl Iterator<Item = usize>,
    (flows, frozen): (&S::Flows, &S::Frozen),
    Step { system, t, x, probe }: Step<'_, S, R, C, P>,
) {
    for piece in pieces {
        if C::PLAIN {
            // An action that is not followed is dropped here, and with it what it is computed from.
            let mut unread = x.s;
            let s = if C::ACTION { &mut x.s } else { &mut unread };
            system.flow(piece, flows, frozen, t, &mut x.z, s);
        } else {
            let d = system.increments(piece, flows, frozen, t, &PerCoordinate::of(x));
            x.add_everywhere(&d);
        }
        probe.flown(S::PIECES[piece].name, || x.is_finite());
    }
}

substeps!([] ContactSplitting);

/// A table for any number of pieces: Φ*(β_K h) Φ(α_K h) … Φ*(β₁h) Φ(α₁h), K flows of the last piece a step.
///
/// For three pieces and more these are better than compositions of [`ContactSplitting`]. S. Blanes, F. Casas & A. Murua,
/// arXiv:2006.06317; that tables for two pieces serve for any number: R. I. McLachlan, SIAM J. Sci. Comput. 16 (1995) 151.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PieceComposition<const K: usize> {
    name: Name,
    order: u32,
    /// (α, β), in order of application.
    weights: [[f64; 2]; K],
}

impl<const K: usize> PieceComposition<K> {
    /// A palindrome α₁, β₁, α₂, …, β_K given by its first half.
    pub(crate) const fn palindrome(name: &'static str, order: u32, half: [f64; K]) -> Self {
        let mut weights = [[0.0; 2]; K];
        let mut i = 0;
        while i < 2 * K {
            weights[i / 2][i % 2] = half[if i < K { i } else { 2 * K - 1 - i }];
            i += 1;
        }
        assert!(adds_up(weights.as_flattened(), 1.0), "the weights add up to 1");
        PieceComposition { name: Name::new(name), order, weights }
    }

    /// The order.
    pub const fn order(&self) -> u32 {
        self.order
    }

    /// (α, β), in order of application.
    pub const fn weights(&self) -> &[[f64; 2]; K] {
        &self.weights
    }
}

/// Φ(αh), then Φ*(βh).
#[derive(Clone, Copy, Debug)]
pub struct Pair<F, R> {
    forth: F,
    back: F,
    /// Where Φ begins, and where it meets Φ*, after the start of the step.
    at: [R; 2],
}

impl<S: Pieces<R>, R: Real, const K: usize> Method<S, R> for PieceComposition<K> {
    type Proof = <S as Pieces<R>>::Proof;
    type Prepared = [Pair<S::Flows, R>; K];
    type Memory = ();

    fn claims(&self) -> Claims {
        Claims { order: self.order, symmetric: true, symplectic: true, conserves_energy: false, forces: Some(K as u32) }
    }

    fn name(&self) -> Name {
        self.name
    }

    fn prepare(&self, system: &S, h: R) -> Self::Prepared {
        core::array::from_fn(|i| {
            let [alpha, beta] = self.weights[i];
            let before: f64 = self.weights[..i].as_flattened().iter().sum();
            let part = |fraction: f64| R::from_f64(fraction) * h;
            Pair {
                forth: system.prepare_flows(part(alpha), part(alpha + beta)),
                back: system.prepare_flows(part(beta), part(beta)),
                at: [part(before), part(before + alpha)],
            }
        })
    }

    fn memory() {}

    #[inline]
    fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
        prepared: &Self::Prepared,
        (): &mut (),
        mut step: Step<'_, S, R, C, P>,
    ) -> Result<(), Refusal> {
        let all = S::PIECES.len();
        for Pair { forth, back, at: [start, middle] } in prepared {
            let (start, middle) = (step.t + *start, step.t + *middle);
            let frozen = [forth, back].map(|flows| step.system.freeze(flows, middle));
            step.probe.visit(start, &step.x.z, &step.x.s);
            pass(0..all, (forth, &frozen[0]), step.part(start));
            pass((0..all - 1).rev(), (back, &frozen[1]), step.part(middle));
        }
        Ok(())
    }
}
