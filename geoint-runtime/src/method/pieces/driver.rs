//! Exact flows of pieces, one after the other and back.
//!
//! With Φ(h) for all flows in order and Φ*(h) for them in reverse, every table here is Φ*(β_K h) Φ(α_K h) … Φ*(β₁h) Φ(α₁h). The last
//! flow of a Φ and the first one of the Φ* behind it belong to one piece and are merged. Time, where it is frozen, moves
//! before all flows of Φ and after all flows of Φ*: between Φ and Φ* it is the same for all flows.

use crate::method::open::Open;
use crate::method::{Claims, Clock, Probe, Refusal, Step, Unwatched, check_way};
use crate::scalar::Real;
use crate::space::{Array, PerCoordinate, Point, Summation};
use crate::system::{Clock as PieceClock, Evaluations, Piece, Pieces, Poles};

/// A splitting by its name: which pieces of a system it takes.
#[doc(alias("operator splitting", "symplectic"))]
pub trait Splitting: Copy + Default {
    /// What it is called.
    const NAME: &'static str;
    /// Whether tables merge the first flow of a part of the step with the last one of the part before.
    const MERGES: bool = false;
}

/// What a step needs.
#[derive(Clone, Copy, Debug)]
pub struct Prepared<F, R> {
    flows: F,
    /// The first flow of a step together with the last one of the step before.
    merged: F,
    half: R,
    poles: Poles,
}

/// What every composition of exact flows claims, of order `order` with so many flows of the last piece.
pub(super) fn claims<S: Pieces<M, R>, M, R: Real>(order: u32, flows: u32) -> Claims {
    let (symplectic, conserves_energy) = (S::SYMPLECTIC, S::CONSERVES_ENERGY);
    Claims { order, symmetric: true, symplectic, conserves_energy, perturbed: &[], forces: Some(flows) }
}

pub(super) fn prepare<S: Pieces<M, R>, M, R: Real>(system: &S, h: R) -> Prepared<S::Flows, R> {
    let half = R::from_f64(0.5) * h;
    Prepared {
        flows: system.prepare_flows(half, h),
        merged: system.prepare_flows(h, h),
        half,
        poles: Poles::of(system),
    }
}

/// The flows in order, and back. A step that does not begin a call has for its first flow also the last one of the step before, and one
/// that does not end it leaves its own to the next.
#[inline(always)]
pub(super) fn step<S: Pieces<M, R>, M, R: Real, C: Summation<S::Phase>, P: Probe<S, R>>(
    Prepared { flows, merged, half, poles }: &Prepared<S::Flows, R>,
    open: &mut Open<S::Phase, S::Action>,
    mut step: Step<'_, S, R, C, P>,
    [begins, ends]: [bool; 2],
) -> Result<(), Refusal> {
    let (all, joined) = (S::PIECES.len(), merges::<S, M, R>());
    let [t, middle, end] = [step.t, step.t + *half, step.end];
    let frozen = step.system.freeze(flows, middle);
    step.probe.visit(t, &step.x.z, &step.x.s);
    let meets = joined && (!begins || open.return_to(t, step.x).is_some());
    let (first, from) = if meets { (merged, t - *half) } else { (flows, t) };
    pass::<S, M, R, C, P>(0..1, (first, &frozen, poles), step.part([from; 2]))?;
    pass::<S, M, R, C, P>(1..all, (flows, &frozen, poles), step.part([t; 2]))?;
    pass::<S, M, R, C, P>((1..all - 1).rev(), (flows, &frozen, poles), step.part([middle; 2]))?;
    if !joined {
        let last = 0..usize::from(all > 1);
        return pass::<S, M, R, C, P>(last, (flows, &frozen, poles), step.part([middle; 2]));
    }
    if ends {
        open.leave(step.x);
        pass::<S, M, R, C, P>(0..1, (flows, &frozen, poles), step.part([middle; 2]))?;
        open.end([t, end], step.x);
    }
    Ok(())
}

/// Steps of which neighbours share a flow.
#[inline(always)]
pub(super) fn advance<S: Pieces<M, R>, M, R: Real, C: Summation<S::Phase>>(
    prepared: &Prepared<S::Flows, R>,
    open: &mut Open<S::Phase, S::Action>,
    system: &S,
    clock: &Clock<R>,
    steps: u64,
    x: &mut Point<S::Phase, C, S::Action>,
) -> Result<(), Refusal> {
    // In a local of this loop numbers stay in registers.
    let mut here = *x;
    for n in 0..steps {
        let [t, end] = [clock.at(n), clock.at(n + 1)];
        let one = Step { system, t, end, x: &mut here, probe: &mut Unwatched };
        step::<S, M, R, C, _>(prepared, open, one, [n == 0, n + 1 == steps])?;
    }
    *x = here;
    Ok(())
}

/// Whether two flows of the first piece, one after the other, are one: flows at frozen time begin anew with every part of a step, and a
/// solution is no flow.
pub(super) fn merges<S: Pieces<M, R>, M, R: Real>() -> bool {
    S::PIECES.len() > 1 && S::PIECES[0].clock == PieceClock::Own && !S::PIECES[0].solved
}

/// A splitting as a method.
macro_rules! splitting {
    ($($name:ident)*) => { $(
        impl<S: Pieces<$name, R>, R: Real> Method<S, R> for $name {
            type Proof = <S as Pieces<$name, R>>::Proof;
            type Prepared = driver::Prepared<S::Flows, R>;
            type Memory = Open<S::Phase, S::Action>;

            fn claims(&self) -> Claims {
                driver::claims::<S, $name, R>(2, 1)
            }

            fn name(&self) -> Name {
                Name::new($name::NAME)
            }

            fn prepare(&self, system: &S, h: R) -> Self::Prepared {
                driver::prepare(system, h)
            }

            fn memory() -> Self::Memory {
                Open::unknown()
            }

            #[inline(always)]
            fn step<C: Summation<S::Phase>, P: Probe<S, R>>(
                prepared: &Self::Prepared,
                open: &mut Self::Memory,
                step: Step<'_, S, R, C, P>,
            ) -> Result<(), Refusal> {
                driver::step::<S, $name, R, C, P>(prepared, open, step, [true; 2])
            }

            #[inline(always)]
            fn advance<C: Summation<S::Phase>>(
                prepared: &Self::Prepared,
                open: &mut Self::Memory,
                system: &S,
                clock: &Clock<R>,
                steps: u64,
                x: &mut Point<S::Phase, C, S::Action>,
            ) -> Result<(), Refusal> {
                driver::advance::<S, $name, R, C>(prepared, open, system, clock, steps, x)
            }
        }
    )* };
}
pub(super) use splitting;

/// Whether some are solved for: of all others nothing is asked behind them.
const fn solves(pieces: &[Piece]) -> bool {
    let mut i = 0;
    while i < pieces.len() {
        if pieces[i].solved {
            return true;
        }
        i += 1;
    }
    false
}

/// The flows of some pieces one after the other, each from the time of `step` on. Those that are solved for do not jump over a pole.
#[inline(always)]
pub(super) fn pass<S: Pieces<M, R>, M, R: Real, C: Summation<S::Phase>, P: Probe<S, R>>(
    pieces: impl Iterator<Item = usize>,
    (flows, frozen, poles): (&S::Flows, &S::Frozen, &Poles),
    Step { system, t, x, probe, .. }: Step<'_, S, R, C, P>,
) -> Result<(), Refusal> {
    for piece in pieces {
        let solved = const { solves(S::PIECES) } && S::PIECES[piece].solved;
        let before = (x.z, x.s);
        let named = P::EFFORT.is_thorough() && S::PIECES[piece].may_end && x.is_finite();
        if C::PLAIN {
            // An action that is not followed is dropped here, and with it what it is computed from.
            let mut unread = x.s;
            let s = if C::ACTION { &mut x.s } else { &mut unread };
            system.flow(piece, flows, frozen, t, &mut x.z, s);
        } else {
            let d = system.increments(piece, flows, frozen, t, &PerCoordinate::of(x));
            x.add_everywhere(&d);
        }
        let name = S::PIECES[piece].name;
        if solved && x.z.is_finite() {
            let Point { z, s, needs_recheck, .. } = &mut *x;
            let way = ([t; 2], [&before.0, &*z], [&before.1, &*s]);
            check_way::<S, R, P>(poles, Evaluations::AtPoints, system, way, needs_recheck)?;
        } else if solved && named {
            probe.unsolved(name);
        } else if named {
            probe.flown(name, || x.is_finite());
        }
    }
    Ok(())
}
