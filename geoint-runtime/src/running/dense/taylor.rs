//! Where a function of the state changes sign along the polynomial of a step: all its zeros, in order.

use super::crossings::{Crossing, Direction, ZEROS, next};
use super::has_reached;
use crate::running::{StepError, TaylorIntegrator};
use crate::scalar::{Real, signed};
use crate::space::{Action, Array, Snapshot};
use crate::system::{Jets, StateOf};
use crate::taylor::{self, TaylorMethod};
use core::fmt::{self, Debug, Formatter};

/// The crossings of a run by Taylor series, in order; ends after the first error, or at a time.
pub struct TaylorCrossings<'a, S: Jets<R>, M: TaylorMethod, R: Real, F, G> {
    run: &'a mut TaylorIntegrator<S, M, R>,
    g: F,
    direction: Direction,
    end: Option<R>,
    backwards: bool,
    /// The functions along the last step.
    values: Option<G>,
    /// Signs at the end of the last step; 0 where there was none yet.
    sides: G,
    zeros: u32,
    /// Up to which part of the last step zeros have been given out, and the functions that had one there.
    given: (f64, usize),
    done: bool,
}

impl<'a, S: Jets<R>, M: TaylorMethod, R: Real, F, G> TaylorCrossings<'a, S, M, R, F, G>
where
    G: Array<Real = M::Series<R>>,
    F: Fn(&S::Over<M::Series<R>>) -> G,
{
    pub(in crate::running) fn new(run: &'a mut TaylorIntegrator<S, M, R>, direction: Direction, g: F) -> Self {
        let backwards = run.step_size() < 0.0;
        let (end, values) = (None, None);
        TaylorCrossings {
            run,
            g,
            direction,
            end,
            backwards,
            values,
            sides: G::zero(),
            zeros: 0,
            given: (0.0, 0),
            done: false,
        }
    }

    /// The same up to a time, before or after now.
    pub fn until(mut self, t: R) -> Self {
        self.backwards = (t - self.run.time()).any_below(0.0);
        self.end = Some(t);
        self
    }

    /// The next step, and the functions along it; `false` if there is none.
    fn step(&mut self) -> Result<bool, StepError> {
        // The signs at the end of the step before.
        if let Some(values) = self.values.take() {
            for i in 0..G::LEN {
                let side = self.zeros_of(&values, i).1;
                self.sides.as_mut_slice()[i] = M::Series::<R>::from_f64(side);
            }
        }
        let stepped = match self.end {
            Some(t) if has_reached(self.run.time(), t, self.backwards) => false,
            Some(t) => self.run.step_towards(t)?,
            None => {
                self.run.step_towards(R::from_f64(if self.backwards { f64::NEG_INFINITY } else { f64::INFINITY }))?
            }
        };
        if !stepped {
            return Ok(false);
        }
        let values = self.along();
        let t = signed(self.run.time());
        let coefficients = || values.as_slice().iter().flat_map(|g| M::coefficients(g).iter().map(|g| g.magnitude()));
        if coefficients().any(f64::is_nan) {
            return Err(StepError::NoEvent { t });
        }
        self.zeros = if G::LEN > 0 && coefficients().all(|g| g == 0.0) { self.zeros + 1 } else { 0 };
        if self.zeros >= ZEROS {
            return Err(StepError::NoEvent { t });
        }
        (self.values, self.given) = (Some(values), (-1.0, usize::MAX));
        Ok(true)
    }

    /// The functions along the last step, in its own time.
    fn along(&self) -> G {
        let (expansion, start, _) = self.run.steps.last_expansion();
        let jet = &expansion.jet.as_ref()[..self.run.order()];
        let coordinate = |i: usize| {
            M::series(|n| match n {
                0 => expansion.x.at(i),
                n => jet.get(n - 1).map_or(R::from_f64(0.0), |x| x.at(i)),
            })
        };
        let mut z = <<S::Over<M::Series<R>> as Snapshot>::Phase as Array>::zero();
        let mut s = <<S::Over<M::Series<R>> as Snapshot>::Action as Action<_>>::zero();
        for (i, x) in z.as_mut_slice().iter_mut().enumerate() {
            *x = coordinate(i);
        }
        for s in s.numbers_mut() {
            *s = coordinate(S::Phase::LEN);
        }
        let t = M::series(|n| match n {
            0 => start,
            1 => R::from_f64(expansion.unit),
            _ => R::from_f64(0.0),
        });
        (self.g)(&S::Over::of(t, z, s))
    }

    /// The parts of the last step at which a function is zero, with the sign that it has in the beginning; and its sign at the end.
    fn zeros_of(&self, values: &G, i: usize) -> (Zeros, f64) {
        let (expansion, _, h) = self.run.steps.last_expansion();
        let coefficients = M::coefficients(&values.as_slice()[i]);
        let g = taylor::in_parts(coefficients.iter().map(|c| signed(*c)), h / expansion.unit);
        let inner = taylor::roots(&g[..coefficients.len().min(taylor::MOST)]);
        let side = signed(M::coefficients(&self.sides.as_slice()[i])[0]);
        // A change of sign in the joint of two steps.
        let joint = side * inner.sign < 0.0;
        let odd = inner.as_slice().len() % 2 == 1;
        let end = if odd { -inner.sign } else { inner.sign };
        (Zeros { inner, joint }, if end == 0.0 { side } else { end })
    }

    /// The first zero in the last step that has not been given out.
    fn earliest(&mut self) -> Option<Crossing<StateOf<S, R>>> {
        let values = self.values?;
        let mut first: Option<(f64, usize, f64)> = None;
        for i in 0..G::LEN {
            let (zeros, _) = self.zeros_of(&values, i);
            for (at, sign) in zeros.iter() {
                let later = (at, i) > self.given || self.given.1 == usize::MAX;
                let earlier = first.is_none_or(|(first, ..)| at < first);
                if later && earlier && self.direction.counts(sign) {
                    first = Some((at, i, sign));
                }
            }
        }
        let (at, which, sign) = first?;
        self.given = (at, which);
        let (_, start, h) = self.run.steps.last_expansion();
        let after = at * h;
        let state = self.run.steps.inside(after, start + R::from_f64(after));
        Some(Crossing { state, which, rises: sign > 0.0 })
    }
}

/// The zeros of a function in a step.
struct Zeros {
    inner: taylor::Roots,
    /// Whether there is one where the step begins.
    joint: bool,
}

impl Zeros {
    /// Where they are, with the sign behind each.
    fn iter(&self) -> impl Iterator<Item = (f64, f64)> {
        let mut sign = self.inner.sign;
        let joint = self.joint.then_some((0.0, sign));
        joint.into_iter().chain(self.inner.as_slice().iter().map(move |at| {
            sign = -sign;
            (*at, sign)
        }))
    }
}

impl<S: Jets<R>, M: TaylorMethod, R: Real, F, G> Iterator for TaylorCrossings<'_, S, M, R, F, G>
where
    G: Array<Real = M::Series<R>>,
    F: Fn(&S::Over<M::Series<R>>) -> G,
{
    type Item = Result<Crossing<StateOf<S, R>>, StepError>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.done {
            return None;
        }
        let found = next(self, |search| search.earliest().map(Ok), Self::step);
        self.done = !matches!(found, Some(Ok(_)));
        found
    }
}

impl<S: Jets<R> + Debug, M: TaylorMethod, R: Real, F, G> Debug for TaylorCrossings<'_, S, M, R, F, G> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let mut crossings = f.debug_struct("TaylorCrossings");
        crossings.field("run", self.run).field("direction", &self.direction).finish_non_exhaustive()
    }
}
