//! Represents a function of the state along a step as a polynomial, over the whole step or over parts of it.
//!
//! The series of a function may end before the step does. Examples are √q at q = 0, logarithms and quotients. The function |q| has a different series
//! on either side of 0. The polynomial is therefore compared with the function at the end of a part. If they differ, the part is shortened to an eighth. The
//! next part starts with a series about its own start.

use super::SeriesFunctions;
use crate::running::StepError;
use crate::running::dense::noise::noise;
use crate::scalar::{Real, signed};
use crate::solving::Failure;
use crate::space::{Action, Array, Snapshot};
use crate::system::Jets;
use crate::taylor::{self, Steps, TaylorMethod};

/// Accepted difference between the polynomial and the function at the end of a part, relative to the size of the function. Zeros are found by the
/// polynomial and improved by the function.
pub(super) const RELATIVE_GAP: f64 = 1.0 / (1 << 20) as f64;
/// A difference below this many rounding errors is accepted.
const ROUNDINGS: f64 = 64.0;
/// Accepted relative difference for steps of fixed length, whose accuracy is not known.
const RELATIVE_GAP_FIXED: f64 = 1.0 / (1 << 10) as f64;

/// Shortest part, as a fraction of the step. A function that differs even there has a jump or an end.
const SHORTEST: f64 = 1.0 / (1_u64 << 40) as f64;

/// The functions along a part of the last step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece<G> {
    pub(super) from: f64,
    pub(super) to: f64,
    /// Whether the search begins with this part. A function that is zero at its start, up to rounding, is then at the event of an earlier search.
    pub(super) begins: bool,
    /// Series about the start of the part, in the unit of time of the step.
    pub(super) values: G,
}

impl<S: Jets<R>, M: TaylorMethod<S, R>, R: Real, F, G> SeriesFunctions<'_, S, M, R, F, G>
where
    G: Array<Real = M::Series>,
    F: Fn(&S::Over<M::Series>) -> G,
{
    /// Returns the functions along a part of the last step, from their series about its start `from`. The part is at most `width` long.
    pub(super) fn part(&self, values: G, from: f64, width: f64) -> Result<Piece<G>, StepError> {
        let is_finite = |g: &M::Series| M::coefficients(g).iter().all(|g| g.magnitude().is_finite());
        if !values.as_slice().iter().all(is_finite) {
            return Err(self.no_event(from));
        }
        // The end must differ from the start, even if the first part is very short.
        let shortest = (SHORTEST * self.first_width()).max(4.0 * f64::EPSILON * from).max(f64::MIN_POSITIVE);
        let to = (from + self.within_reach(&values, width.min(1.0 - from)).max(shortest)).min(1.0);
        let mut piece = Piece { from, to, begins: false, values };
        while !self.agrees(&piece) {
            if piece.to - from <= shortest {
                if self.at(piece.to).as_slice().iter().any(|g| !g.magnitude().is_finite()) {
                    return Err(self.no_event(from));
                }
                break;
            }
            piece.to = from + 0.125 * (piece.to - from);
        }
        Ok(piece)
    }

    /// Returns the length, at most `width`, up to which the series of all functions converge fast enough. The roots found by them are improved later.
    fn within_reach(&self, values: &G, width: f64) -> f64 {
        let count = self.run.order().min(taylor::MOST);
        let reach = |i| taylor::reach(&self.in_parts(values, i, width)[..count], self.run.pace.part_of_radius());
        width * (0..G::LEN).map(reach).fold(1.0, f64::min)
    }

    /// Returns whether the series of a piece agree with the functions at its end.
    fn agrees(&self, piece: &Piece<G>) -> bool {
        let end_values = self.at(piece.to);
        let part = match self.run.method().steps() {
            Steps::Tolerance(tolerance) => RELATIVE_GAP.max(tolerance),
            Steps::Length(_) => RELATIVE_GAP_FIXED,
        };
        (0..G::LEN).all(|i| {
            let value: f64 = self.in_parts(&piece.values, i, piece.to - piece.from).iter().sum();
            let [start, end] = [&piece.values, &end_values].map(|g| signed(g.as_slice()[i]));
            let gap = (value - end).abs();
            // Different signs mean a zero elsewhere, even if the difference is small.
            let same = value * end >= 0.0 && gap <= part * start.abs().max(end.abs());
            // Numbers below the normal range have too few digits to agree.
            same || gap <= R::smallest() || gap <= ROUNDINGS * self.noise(i, piece.to) || gap <= self.rounding(piece, i)
        })
    }

    /// Returns the uncertainty of a function at the start of a piece. It is caused by the rounding of the coordinates, and of the time of an event
    /// there. The event was found in another step, so the change over a typical step counts, not only the change over this piece.
    pub(super) fn rounding(&self, piece: &Piece<G>, i: usize) -> f64 {
        let width = self.run.pace.pace_before() / self.run.last_step().abs();
        let count = self.run.order().min(taylor::MOST);
        let reach = taylor::reach(&self.in_parts(&piece.values, i, width)[..count], 0.5);
        let whole = self.changes(piece, i, width * reach.min(1.0));
        let changes = self.changes(piece, i, piece.to - piece.from);
        let changes = if whole < f64::INFINITY { changes.max(whole) } else { changes };
        f64::max(4.0 * self.noise(i, piece.from), 8.0 * R::epsilon() * changes)
    }

    /// Returns whether a function changes by more than rounding within the first piece of a search.
    pub(super) fn leaves(&self, piece: &Piece<G>, i: usize) -> bool {
        let start = piece.values.as_slice()[i].magnitude();
        start + self.changes(piece, i, piece.to - piece.from) > self.rounding(piece, i)
    }

    /// Returns an upper bound for the change of a function in a piece of this width.
    fn changes(&self, piece: &Piece<G>, i: usize, width: f64) -> f64 {
        self.in_parts(&piece.values, i, width)[1..].iter().map(|g| g.abs()).sum()
    }

    /// Returns the size of a function at the ends of the last step.
    pub(super) fn scale(&self, i: usize) -> f64 {
        let [start, end] = self.ends.map(|g| g.as_slice()[i].magnitude());
        start.max(end)
    }

    /// Returns the polynomial of a function, with time as a fraction of a piece of this width.
    pub(super) fn in_parts(&self, values: &G, i: usize, width: f64) -> [f64; taylor::MOST] {
        let unit = self.run.pace.start().unit;
        let coefficients = M::coefficients(&values.as_slice()[i]);
        taylor::in_parts(coefficients.iter().map(|c| signed(*c)), width * self.run.last_step() / unit)
    }

    /// Returns the rounding error of a function at a part of the last step.
    pub(super) fn noise(&self, i: usize, part: f64) -> f64 {
        noise(&self.series(part), |state| signed((self.g)(state).as_slice()[i]))
    }

    /// Returns the series of the functions about a part of the last step, or about its end.
    fn at(&self, part: f64) -> G {
        if part < 1.0 { self.along(part) } else { self.ends[1] }
    }

    /// Returns the series of the functions about a part of the last step, from its polynomial.
    pub(super) fn along(&self, part: f64) -> G {
        (self.g)(&self.series(part))
    }

    /// Returns the series of the functions at the end of the last step.
    pub(super) fn at_end(&self) -> G {
        let expansion = self.run.pace.here();
        let jet = &expansion.jet.as_ref()[..self.run.order()];
        let coordinate = |i: usize| {
            M::series(|n| match n {
                0 => expansion.coordinate(i),
                n => jet.get(n - 1).map_or(R::from_f64(0.0), |x| x.at(i)),
            })
        };
        (self.g)(&state_of::<S, M, R>(coordinate, expansion.time(), expansion.unit))
    }

    /// Returns the series of the state about a part of the last step.
    fn series(&self, part: f64) -> S::Over<M::Series> {
        let (expansion, order) = (self.run.pace.start(), self.run.order());
        let after = part * self.run.last_step();
        let by = R::from_f64(after / expansion.unit);
        let jet = &expansion.jet.as_ref()[..order];
        let coordinate = |i: usize| {
            let mut x = M::fill(R::from_f64(0.0));
            let x = x.as_mut();
            x[0] = expansion.coordinate(i);
            for (x, term) in x[1..].iter_mut().zip(jet) {
                *x = term.at(i);
            }
            if part != 0.0 {
                taylor::shift(&mut x[..order], jet[order - 1].at(i), by);
            }
            M::series(|n| x[n])
        };
        state_of::<S, M, R>(coordinate, expansion.time() + R::from_f64(after), expansion.unit)
    }

    /// Returns the error that a function is not a number at a part of the last step.
    fn no_event(&self, part: f64) -> StepError {
        let start = self.run.pace.start().time();
        StepError::without_step(Failure::NoEvent, signed(start) + part * self.run.last_step())
    }
}

/// Returns the state with these series of the coordinates, at the time `now`.
fn state_of<S: Jets<R>, M: TaylorMethod<S, R>, R: Real>(
    coordinate: impl Fn(usize) -> M::Series,
    now: R,
    unit: f64,
) -> S::Over<M::Series> {
    let mut z = <<S::Over<M::Series> as Snapshot>::Phase as Array>::zero();
    let mut s = <<S::Over<M::Series> as Snapshot>::Action as Action<_>>::zero();
    for (i, x) in z.as_mut_slice().iter_mut().enumerate() {
        *x = coordinate(i);
    }
    for s in s.numbers_mut() {
        *s = coordinate(S::Phase::LEN);
    }
    let t = M::series(|n| match n {
        0 => now,
        1 => R::from_f64(unit),
        _ => R::from_f64(0.0),
    });
    S::Over::of(t, z, s)
}
