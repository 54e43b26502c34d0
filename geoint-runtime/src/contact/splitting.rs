//! One exact flow after the other, and back.

use super::{Clock, Pieces};
use crate::composition::substeps;
use crate::method::{Claims, Method, Probe, Refusal};
use crate::point::{Point, Summation};
use crate::real::Real;

/// e^(h/2 X₁) … e^(h/2 Xₖ₋₁) e^(h Xₖ) e^(h/2 Xₖ₋₁) … e^(h/2 X₁): the exact flows of the pieces of H, the most expensive one in the
/// middle. Order 2, symmetric, a contact map; every piece but the last is evaluated twice a step.
///
/// Where the flow of a piece ends within a step, as that of H = s² does, the step is refused with the name of the piece.
/// A. Bravetti, M. Seri, M. Vermeeren & F. Zadra, Celest. Mech. Dyn. Astr. 132 (2020) 7.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ContactSplitting;

impl<S: Pieces<R>, R: Real> Method<S, R> for ContactSplitting {
    /// The flows, and the step size.
    type Prepared = (S::Flows, R);

    fn claims(&self) -> Claims {
        Claims { order: 2, symmetric: true, symplectic: true, conserves_energy: false }
    }

    fn prepare(&self, system: &S, h: R) -> Self::Prepared {
        (system.prepare_flows(R::from_f64(0.5) * h, h), h)
    }

    #[inline(always)]
    fn step<C: Summation<S::Array>, P: Probe<S, R>>(
        (flows, h): &mut Self::Prepared,
        t: R,
        x: &mut Point<S::Array, C, R>,
        probe: &mut P,
    ) -> Result<(), Refusal> {
        probe.look(t, &x.q, &x.p, &x.s);
        let middle = R::from_f64(0.5).multiply_add(*h, t);
        let last = S::PIECES.len().wrapping_sub(1);
        for i in 0..S::PIECES.len() {
            flow::<S, R, C, P>(i, flows, [t, middle], x, probe);
        }
        for i in (0..last).rev() {
            flow::<S, R, C, P>(i, flows, [middle, middle], x, probe);
        }
        Ok(())
    }
}

/// A flow that begins at the first of two times, if it is not frozen at the second.
#[inline(always)]
fn flow<S: Pieces<R>, R: Real, C: Summation<S::Array>, P: Probe<S, R>>(
    piece: usize,
    flows: &S::Flows,
    [start, frozen]: [R; 2],
    x: &mut Point<S::Array, C, R>,
    probe: &mut P,
) {
    let t = match S::PIECES[piece].clock {
        Clock::Own => start,
        Clock::Stage => frozen,
    };
    S::flow(piece, flows, t, &mut x.q, &mut x.p, &mut x.s);
    probe.flown(S::PIECES[piece].name, || x.is_finite());
}

substeps!([] ContactSplitting);
