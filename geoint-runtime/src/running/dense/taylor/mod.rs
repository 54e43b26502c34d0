//! Finds all changes of sign of a function of the state along the polynomial of a step, in order of time.

mod pieces;
mod run;

use super::crossing::{Crossing, Direction, MOST_ZERO_STEPS, NEAR_END, check_end, next};
use super::has_reached;
use crate::running::{StepError, TaylorIntegrator};
use crate::scalar::{Real, signed};
use crate::solving::Failure;
use crate::space::Array;
use crate::system::{Jets, StateOf};
use crate::taylor::{self, Roots, TaylorMethod};
use core::fmt::{self, Debug, Formatter};
use pieces::{Piece, RELATIVE_GAP, number};

/// Maximum number of Newton steps. At a triple zero, each step reduces the distance by a third.
const ROUNDS: u32 = 32;

/// Two zeros are dropped if the function between them is below this many rounding errors of its terms.
const ROUNDING: f64 = 4.0;

/// Iterator over the crossings of a run by Taylor series, in order of time. Ends after the first error, or at a time.
pub struct TaylorCrossings<'a, S: Jets<R>, M: TaylorMethod<S, R>, R: Real, F, G> {
    run: &'a mut TaylorIntegrator<S, M, R>,
    g: F,
    direction: Direction,
    end: Option<R>,
    backwards: bool,
    /// Functions along the part of the last step that is being searched.
    piece: Option<Piece<G>>,
    /// Functions at the end of the last step.
    ahead: G,
    /// Sizes of the functions at the ends of the last step.
    scales: G,
    /// Signs at the end of the previous part; 0 if a function had none yet.
    sides: G,
    /// Whether this is the first part of the search. A function that is zero at its start, up to rounding, has its event there already.
    first: bool,
    zeros: u32,
    /// Last zero returned in the piece: its position, and the index of the function.
    given: (f64, usize),
    /// Functions that had a zero next to the end of the last step: 1, otherwise 0.
    near: G,
    /// Number of functions already checked for a zero at the end, once no step is left.
    asked: usize,
    /// Function that has a zero at the end, until its crossing is returned.
    last: Option<usize>,
    done: bool,
}

impl<'a, S: Jets<R>, M: TaylorMethod<S, R>, R: Real, F, G> TaylorCrossings<'a, S, M, R, F, G>
where
    G: Array<Real = M::Series>,
    F: Fn(&S::Over<M::Series>) -> G,
{
    pub(in crate::running) fn new(run: &'a mut TaylorIntegrator<S, M, R>, direction: Direction, g: F) -> Self {
        let backwards = run.pace.backwards;
        TaylorCrossings {
            run,
            g,
            direction,
            end: None,
            backwards,
            piece: None,
            ahead: G::zero(),
            scales: G::zero(),
            sides: G::zero(),
            first: true,
            zeros: 0,
            given: (0.0, 0),
            near: G::zero(),
            asked: 0,
            last: None,
            done: false,
        }
    }

    /// Limits the search to a time, before or after the present time. Zeros at this time, up to rounding, count.
    #[must_use = "the end is that of the iterator that is returned"]
    pub fn until(mut self, t: R) -> Self {
        self.backwards = (t - self.run.time()).any_below(0.0);
        self.end = Some(t);
        self
    }

    /// Takes the next part of a step with the functions along it. Returns `false` if nothing is left.
    fn step(&mut self) -> Result<bool, StepError> {
        check_end(self.end, self.run.time())?;
        if let Some(piece) = self.piece.take() {
            // Signs at the end of the previous part.
            for i in 0..G::LEN {
                let zeros = self.zeros_of(&piece, i);
                let near = zeros.changes().any(|(at, _)| piece.from + at * (piece.to - piece.from) > NEAR_END);
                // If the step ends before the function has left the event at the start of the search, it does not end at another event.
                let near = near || self.begins(&piece) && !self.leaves(&piece, i);
                self.sides.as_mut_slice()[i] = <M::Series as Real>::from_f64(zeros.end());
                self.near.as_mut_slice()[i] = <M::Series as Real>::from_f64(f64::from(u8::from(near)));
            }
            self.first = false;
            if piece.to < 1.0 {
                return self.search(piece.to, 8.0 * (piece.to - piece.from));
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
            return if self.zeros > 0 && self.sides.is_zero() {
                Err(self.zero_all_along())
            } else {
                Ok(self.zero_at_end())
            };
        }
        self.ahead = self.at_end();
        self.search(0.0, self.first_width())
    }

    /// Returns the part of a step that is searched first. A step of a polynomial solution may be much longer than the time in which its state
    /// changes.
    fn first_width(&self) -> f64 {
        (8.0 * self.run.pace.pace_before() / self.run.last_step().abs()).min(1.0)
    }

    fn search(&mut self, from: f64, width: f64) -> Result<bool, StepError> {
        let piece = self.part(from, width)?;
        let coefficients = || piece.values.as_slice().iter().flat_map(|g| M::coefficients(g));
        self.zeros = if G::LEN > 0 && coefficients().all(|g| g.magnitude() == 0.0) { self.zeros + 1 } else { 0 };
        if self.zeros >= MOST_ZERO_STEPS {
            return Err(self.zero_all_along());
        }
        if self.begins(&piece) {
            (0..G::LEN).for_each(|i| self.cross_at_start(&piece, i));
        }
        (self.piece, self.given) = (Some(piece), (-1.0, usize::MAX));
        Ok(true)
    }

    /// Sets the side of a function that crosses zero at the start of the search, at the time of an event of other functions.
    fn cross_at_start(&mut self, piece: &Piece<G>, i: usize) {
        let t = self.run.pace.start().time();
        if !self.run.reported.is_at(t) || number::<S, M, R>(&piece.values.as_slice()[i]).abs() > self.rounding(piece, i)
        {
            return;
        }
        let sign = self.zeros_of(piece, i).start();
        if sign != 0.0 && self.run.reported.takes(i, self.direction.counts(sign)) {
            self.sides.as_mut_slice()[i] = <M::Series as Real>::from_f64(-sign);
        }
    }

    fn zero_all_along(&self) -> StepError {
        StepError::without_step(Failure::NoEvent, signed(self.run.time()))
    }

    /// Finds a function that is zero up to rounding at the end of the search, and had no zero just before. Returns whether there is one; its crossing
    /// is returned next.
    fn zero_at_end(&mut self) -> bool {
        // Without a step, no function has a sign.
        let count = if self.first { 0 } else { G::LEN };
        self.last = (self.asked..count).find(|i| {
            let [value, side, near] =
                [&self.ahead, &self.sides, &self.near].map(|g| number::<S, M, R>(&g.as_slice()[*i]));
            let rounding = || 8.0 * R::epsilon() * self.scale(*i) + 4.0 * self.noise(*i, 1.0);
            side != 0.0 && near == 0.0 && self.direction.counts(-side) && value.abs() <= rounding()
        });
        self.asked = self.last.map_or(count, |i| i + 1);
        self.last.is_some()
    }

    /// Returns the zeros of a function in a piece, with its sign at the start; 0 if it had none yet.
    fn zeros_of(&self, piece: &Piece<G>, i: usize) -> Roots {
        let count = M::coefficients(&piece.values.as_slice()[i]).len();
        let g = self.in_parts(&piece.values, i, piece.to - piece.from);
        let (g, side) = (&g[..count.min(taylor::MOST)], number::<S, M, R>(&self.sides.as_slice()[i]));
        // After a change of sign at the end of a step, rounding may show the change again at the start of the next one.
        let noise = if self.begins(piece) || side * g[0] < 0.0 { self.rounding(piece, i) } else { 0.0 };
        let size: f64 = g.iter().map(|g| g.abs()).sum();
        taylor::roots(g, noise).behind(side).without_pairs(g, ROUNDING * R::epsilon() * size)
    }

    /// Returns the first zero in the piece that was not returned yet.
    fn earliest(&mut self) -> Option<Crossing<StateOf<S, R>>> {
        if let Some(which) = self.last.take() {
            let rises = number::<S, M, R>(&self.sides.as_slice()[which]) < 0.0;
            return Some(Crossing { state: self.run.state(), which, rises });
        }
        let piece = self.piece?;
        let mut first: Option<(f64, usize, f64)> = None;
        for i in 0..G::LEN {
            for (at, sign) in self.zeros_of(&piece, i).changes() {
                let later = (at, i) > self.given || self.given.1 == usize::MAX;
                let earlier = first.is_none_or(|(first, ..)| at < first);
                if later && earlier && self.direction.counts(sign) {
                    first = Some((at, i, sign));
                }
            }
        }
        let (at, which, sign) = first?;
        self.given = (at, which);
        let Some(part) = self.improved(&piece, at, which) else { return self.earliest() };
        let (start, h) = (self.run.pace.start().time(), self.run.last_step());
        let after = part * h;
        let state = self.run.pace.inside(after, start + R::from_f64(after));
        Some(Crossing { state, which, rises: sign > 0.0 })
    }

    /// Improves a zero of the polynomial of a function to a zero of the function itself. Uses Newton's method with the slope of the polynomial.
    /// Returns `None` at a pole.
    fn improved(&self, piece: &Piece<G>, at: f64, i: usize) -> Option<f64> {
        let width = piece.to - piece.from;
        let g = self.in_parts(&piece.values, i, width);
        let slope = |at: f64| (1..g.len()).rev().fold(0.0, |slope, k| slope * at + k as f64 * g[k]);
        let value = |part: f64| number::<S, M, R>(&self.along(part, None).as_slice()[i]);
        let mut part = piece.from + at * width;
        let mut now = value(part);
        // At the start of a piece, and in a piece of the shortest length, a function may jump. Its value is then not zero, but much smaller than next
        // to a pole.
        let scale = self.scale(i);
        let is_pole = |value: f64| scale > 0.0 && value.abs() > scale / RELATIVE_GAP;
        if at == 0.0 {
            return (!is_pole(now)).then_some(part);
        }
        // Convergence is slow at a flat zero. The loop ends when rounding of time prevents a smaller value.
        for _ in 0..ROUNDS {
            let next = part - now / slope((part - piece.from) / width) * width;
            if now == 0.0 || !(next >= piece.from && next <= piece.to) {
                break;
            }
            let there = value(next);
            if there.abs() < now.abs() {
                (part, now) = (next, there);
            } else {
                break;
            }
        }
        (!is_pole(now)).then_some(part)
    }
}

impl<S: Jets<R>, M: TaylorMethod<S, R>, R: Real, F, G> Iterator for TaylorCrossings<'_, S, M, R, F, G>
where
    G: Array<Real = M::Series>,
    F: Fn(&S::Over<M::Series>) -> G,
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

impl<S: Jets<R> + Debug, M: TaylorMethod<S, R>, R: Real, F, G> Debug for TaylorCrossings<'_, S, M, R, F, G> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let mut crossings = f.debug_struct("TaylorCrossings");
        crossings.field("run", self.run).field("direction", &self.direction).finish_non_exhaustive()
    }
}
