//! Steps that report the impulses of their kicks. Error estimates are weighted sums of these impulses.

use super::driver::checked_flow;
use super::flows::Order;
use super::last_kick::LastKick;
use super::moving::Times;
use super::sequence::Sequence;
use crate::method::{Probe, Step};
use crate::scalar::Real;
use crate::space::{Array, Summation};
use crate::system::Separable;

impl<S: Separable<R>, R: Real, O: Order<S, R>, const K: usize> Sequence<S, R, O, K> {
    /// Takes one step and calls `report` with the index and the impulse of each kick. If the step before ended at the same positions, the first kick reuses
    /// the impulse of its last kick.
    ///
    /// Precondition: kicks only add to the momenta.
    #[inline]
    pub(super) fn step_reporting_kicks<C: Summation<S::Phase>, P: Probe<S, R>>(
        &self,
        kick: &mut LastKick<S::Array>,
        Step { system, t, x, probe, .. }: Step<'_, S, R, C, P>,
        mut report: impl FnMut(usize, &S::Array),
    ) {
        for n in 0..=K {
            let start = Times { own: t, other: t };
            let (outer, at) = match n.checked_sub(1) {
                None => (Some(&self.first), start),
                Some(before) if n < K => (Some(&self.outer[before]), self.times(t, before)[1]),
                Some(before) => (self.last.as_ref(), self.times(t, before)[1]),
            };
            if let Some(outer) = outer {
                let known = n == 0 && self.repeats && kick.is_from(&x.z[0]);
                let added = &kick.impulse;
                let impulse = checked_flow(O::DRIFT_IS_OUTER, Step::at(at.other, (system, x, probe)), |x| {
                    if O::DRIFT_IS_OUTER {
                        O::outer(outer, at, x);
                        return None;
                    }
                    Some(match known {
                        true => x.kick_and_report(|x| x.p.add_scaled(R::from_f64(1.0), added)),
                        false => x.kick_and_report(|x| O::outer(outer, at, x)),
                    })
                });
                if let Some(impulse) = impulse {
                    report(n, &impulse);
                    if n == K {
                        *kick = LastKick { known: true, q: x.z[0], impulse };
                    }
                }
            }
            if n < K {
                let ([at, _], inner) = (self.times(t, n), &self.inner[n]);
                let impulse = checked_flow(!O::DRIFT_IS_OUTER, Step::at(at.other, (system, x, probe)), |x| {
                    if O::DRIFT_IS_OUTER {
                        return Some(x.kick_and_report(|x| O::inner(inner, at, x)));
                    }
                    O::inner(inner, at, x);
                    None
                });
                if let Some(impulse) = impulse {
                    report(n, &impulse);
                }
            }
        }
    }
}
