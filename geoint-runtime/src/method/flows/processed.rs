//! Tables with a processor: χ⁻¹ ∘ Φ ∘ … ∘ Φ ∘ χ. The kernel Φ is cheap. The processor χ is applied before the first step, and its inverse after the last.

use super::kinds::{Flows, KickAndDrift};
use super::operation::{Operation, Reached};
use super::sequence::Sequence;
use super::steps_of;
use super::table::{Entry, Flow, Splitting};
use crate::method::tables::total::adds_up;
use crate::method::{Claims, Clock, Failure, Handling, Method, Name, Probe, Step, Unwatched};
use crate::scalar::Real;
use crate::space::{Plain, Point, Summation};
use crate::system::{PhaseSpace, Separable};

/// A table with a processor of `P` drifts and kicks, which is applied before the first step of a run.
///
/// The order is that of the processed method. A state is computed by the inverse processor on a copy of the moving point. Reading a state does not change
/// the run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProcessedSplitting<const K: usize, const P: usize, F = KickAndDrift> {
    table: Splitting<K, F>,
    order: u32,
    /// The processor: fractions of h for a drift and the kick after it, and the fraction of h³ for the force gradient of the kick.
    processor: [[f64; 3]; P],
}

impl<const K: usize, const P: usize, F> ProcessedSplitting<K, P, F> {
    /// Returns a table with a processor. The fractions of its drifts, and of its kicks, must add up to 0, so that it does not change the time.
    pub(in crate::method) const fn new(order: u32, table: Splitting<K, F>, processor: [[f64; 3]; P]) -> Self {
        let (mut drifts, mut kicks, mut i) = ([0.0; P], [0.0; P], 0);
        while i < P {
            [drifts[i], kicks[i], _] = processor[i];
            i += 1;
        }
        assert!(
            adds_up(&drifts, 0.0) && adds_up(&kicks, 0.0),
            "the fractions of the drifts, and of the kicks, of a processor add up to 0"
        );
        ProcessedSplitting { table, order, processor }
    }
}

/// Coefficients of the kernel, of the processor and of its inverse. The flows are in order of application, drift and kick in the processor, kick and drift in
/// its inverse. A flow of length 0 is `None`.
#[derive(Clone)]
pub struct Prepared<S: Separable<R>, R: Real, F: Flows<S, R>, const K: usize, const P: usize> {
    kernel: Sequence<S, R, F, K>,
    processor: [[Option<Operation<S, R, F>>; 2]; P],
    inverse: [[Option<Operation<S, R, F>>; 2]; P],
}

impl<S: Separable<R>, R: Real, F: Flows<S, R>, const K: usize, const P: usize> Prepared<S, R, F, K, P> {
    fn of(table: &ProcessedSplitting<K, P, F>, system: &S, h: R) -> Self {
        let kernel = table.table.prepare(system, h);
        let (mut processor, mut inverse) = ([[None; 2]; P], [[None; 2]; P]);
        // The fractions of h that drifts and kicks have reached.
        let [mut drifts, mut kicks] = [0.0; 2];
        for (i, [drift, kick, gradient]) in table.processor.into_iter().enumerate() {
            let operation = |flow: Flow, gradient: f64, own: f64, other: f64| {
                let reached = Reached { own, other };
                (flow.fraction() != 0.0).then(|| Operation::prepare(system, h, Entry { flow, gradient }, reached))
            };
            processor[i][0] = operation(Flow::Drift(drift), 0.0, drifts, kicks);
            inverse[P - 1 - i][1] = operation(Flow::Drift(-drift), 0.0, drifts + drift, kicks);
            drifts += drift;
            processor[i][1] = operation(Flow::Kick(kick), gradient, kicks, drifts);
            inverse[P - 1 - i][0] = operation(Flow::Kick(-kick), -gradient, kicks + kick, drifts);
            kicks += kick;
        }
        Prepared { kernel, processor, inverse }
    }
}

/// Applies the flows of a processor.
// Do not inline: rustc 1.95 vectorises the inlined code wrongly at `opt-level = 3`. The relative energy error of four bodies was 1e-3.
#[inline(never)]
fn apply<S: Separable<R> + PhaseSpace<R, Action = ()>, R: Real, F: Flows<S, R>>(
    operations: &[Option<Operation<S, R, F>>],
    system: &S,
    t: R,
    z: &mut S::Phase,
) {
    let mut x: Point<S::Phase, Plain> = Point::new(*z);
    for operation in operations.iter().flatten() {
        operation.apply(Step::at(t, (system, &mut x, &mut Unwatched)));
    }
    *z = x.z;
}

impl<S, R, F, const K: usize, const P: usize> Method<S, R> for ProcessedSplitting<K, P, F>
where
    S: Separable<R> + PhaseSpace<R, Action = ()>,
    R: Real,
    F: Flows<S, R>,
{
    type Proof = F::Proof;
    type Prepared = Prepared<S, R, F, K, P>;
    type Memory = <Splitting<K, F> as Method<S, R>>::Memory;
    const HANDLING: Handling = Handling { moves_inner_point: true, ..Handling::FASTER_SINGLY };

    fn claims(&self) -> Claims {
        // Not symmetric: the processor is even in h only up to the remaining error, and Φ(−h)Φ(h) differs from the identity by that error.
        Claims { order: self.order, symmetric: false, ..self.table.claims() }
    }

    fn name(&self) -> Name {
        self.table.name()
    }

    fn prepare(&self, system: &S, h: R) -> Self::Prepared {
        Prepared::of(self, system, h)
    }

    fn memory(z: &S::Phase) -> Self::Memory {
        Splitting::<K, F>::memory(z)
    }

    fn enter(prepared: &Self::Prepared, system: &S, t: R, z: &mut S::Phase) {
        apply(prepared.processor.as_flattened(), system, t, z);
    }

    fn leave(prepared: &Self::Prepared, system: &S, t: R, z: &mut S::Phase) {
        apply(prepared.inverse.as_flattened(), system, t, z);
    }

    steps_of!(Splitting<K, F>, |prepared| &prepared.kernel);
}
