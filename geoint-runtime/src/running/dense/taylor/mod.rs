//! Finds changes of sign of functions of series: all zeros of their polynomials along the parts of a step.

mod pieces;
mod run;

use super::crossings::{Crossings, Functions};
use crate::running::{StepError, TaylorIntegrator};
use crate::scalar::{Real, signed};
use crate::space::Array;
use crate::system::{Jets, StateOf};
use crate::taylor::{self, Roots, TaylorMethod};
use pieces::{Piece, RELATIVE_GAP};

/// Maximum number of Newton steps. At a triple zero, each step reduces the distance by a third.
const ROUNDS: u32 = 32;

/// Two zeros are dropped if the function between them is below this many rounding errors of its terms.
const ROUNDING: f64 = 4.0;

/// Iterator over the crossings of a run by Taylor series, in order of time.
pub type TaylorCrossings<'a, S, M, R, F, G> = Crossings<SeriesFunctions<'a, S, M, R, F, G>>;

/// Functions of the truncated series that represent the coordinates of a run by Taylor series.
#[derive(Debug)]
pub struct SeriesFunctions<'a, S: Jets<R>, M: TaylorMethod<S, R>, R: Real, F, G> {
    run: &'a mut TaylorIntegrator<S, M, R>,
    g: F,
    /// Functions at the start and at the end of the last step.
    ends: [G; 2],
    /// Functions along the part of the last step that is being searched.
    piece: Option<Piece<G>>,
}

impl<'a, S: Jets<R>, M: TaylorMethod<S, R>, R: Real, F, G> SeriesFunctions<'a, S, M, R, F, G>
where
    G: Array<Real = M::Series>,
    F: Fn(&S::Over<M::Series>) -> G,
{
    pub(super) fn new(run: &'a mut TaylorIntegrator<S, M, R>, g: F) -> Self {
        SeriesFunctions { run, g, ends: [G::zero(); 2], piece: None }
    }

    /// Returns the part of a step that is searched first. A step of a polynomial solution may be much longer than the time in which its state
    /// changes.
    fn first_width(&self) -> f64 {
        (8.0 * self.run.pace.pace_before() / self.run.last_step().abs()).min(1.0)
    }

    /// Improves a zero of the polynomial of a function to a zero of the function itself. Uses Newton's method with the slope of the polynomial.
    /// Returns `None` at a pole.
    fn improved(&self, piece: &Piece<G>, zero: f64, i: usize) -> Option<f64> {
        let width = piece.to - piece.from;
        let g = self.in_parts(&piece.values, i, width);
        let slope = |at: f64| (1..g.len()).rev().fold(0.0, |slope, k| slope * at + k as f64 * g[k]);
        let value = |part: f64| signed(self.along(part).as_slice()[i]);
        let (mut part, mut now) = (zero, value(zero));
        // At the start of a piece, and in a piece of the shortest length, a function may jump. Its value is then not zero, but much smaller than next
        // to a pole.
        let scale = self.scale(i);
        let is_pole = |value: f64| scale > 0.0 && value.abs() > scale / RELATIVE_GAP;
        if zero == piece.from {
            return (!is_pole(now)).then_some(zero);
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

impl<S: Jets<R>, M: TaylorMethod<S, R>, R: Real, F, G> Functions for SeriesFunctions<'_, S, M, R, F, G>
where
    G: Array<Real = M::Series>,
    F: Fn(&S::Over<M::Series>) -> G,
{
    type Run = TaylorIntegrator<S, M, R>;
    type Values = G;
    type Places = [f64; taylor::MOST];

    fn run(&mut self) -> &mut Self::Run {
        self.run
    }

    fn advance(&mut self, take: impl FnOnce(&mut Self::Run) -> Result<bool, StepError>) -> Result<bool, StepError> {
        self.piece = match self.piece {
            Some(Piece { from, to, .. }) if to < 1.0 => Some(self.part(self.along(to), to, 8.0 * (to - from))?),
            last => {
                if !take(self.run)? {
                    return Ok(false);
                }
                self.ends = [self.along(0.0), self.at_end()];
                let first = self.part(self.ends[0], 0.0, self.first_width())?;
                Some(Piece { begins: last.is_none(), ..first })
            }
        };
        Ok(true)
    }

    fn are_zero(&self) -> bool {
        let values = self.piece.iter().flat_map(|piece| piece.values.as_slice());
        values.flat_map(M::coefficients).all(|g| g.magnitude() == 0.0)
    }

    fn changes(&self, i: usize, side: f64) -> Result<Roots, StepError> {
        let Some(piece) = &self.piece else { return Ok(Roots::none(side)) };
        let count = M::coefficients(&piece.values.as_slice()[i]).len();
        let g = self.in_parts(&piece.values, i, piece.to - piece.from);
        let g = &g[..count.min(taylor::MOST)];
        // After a change of sign at the end of a step, rounding may show the change again at the start of the next one.
        let noise = if piece.begins || side * g[0] < 0.0 { self.rounding(piece, i) } else { 0.0 };
        let size: f64 = g.iter().map(|g| g.abs()).sum();
        let found = taylor::roots(g, noise).behind(side).without_pairs(g, ROUNDING * R::epsilon() * size);
        let found = found.map(|at| piece.from + at * (piece.to - piece.from));
        let starts_at_zero = piece.begins && g[0].abs() <= noise;
        Ok(if starts_at_zero { found.behind(-found.sign) } else { found })
    }

    fn state(&self, i: usize, at: f64) -> Result<Option<StateOf<S, R>>, StepError> {
        let part = self.piece.as_ref().and_then(|piece| self.improved(piece, at, i));
        let start = self.run.pace.start().time();
        let state = |after| self.run.pace.inside(after, start + R::from_f64(after));
        Ok(part.map(|part| state(part * self.run.last_step())))
    }

    fn is_zero_at_end(&self, i: usize) -> bool {
        // If the search ends before the function has left the event at its start, it does not end at another event.
        let is_at_start = self.piece.as_ref().is_none_or(|piece| piece.begins && !self.leaves(piece, i));
        let rounding = || 8.0 * R::epsilon() * self.scale(i) + 4.0 * self.noise(i, 1.0);
        !is_at_start && signed(self.ends[1].as_slice()[i]).abs() <= rounding()
    }
}
