//! Dense output and events of runs by Taylor series.

use super::{Crossings, SeriesFunctions, TaylorCrossings};
use crate::running::StepError;
use crate::running::dense::{Crossing, Direction};
use crate::running::run::Run;
use crate::running::taylor::Series;
use crate::scalar::Real;
use crate::space::Array;
use crate::system::{Jets, StateOf};
use crate::taylor::TaylorMethod;

impl<S: Jets<R>, M: TaylorMethod<S, R>, R: Real> Run<Series<S, M, R>> {
    /// Returns an iterator over the changes of sign of `g`, in order of time, also if there are two within one step. `g` returns a number or an array
    /// of numbers. The iterator has no end, unless [`until`](Crossings::until) sets one. The search goes forwards, or in the direction of the last
    /// step.
    ///
    /// `g` is a function of truncated series, [`Series`](crate::scalar::Series), which represent the coordinates along a step. It is written like a
    /// function of numbers. The search finds all zeros of the polynomial of `g`. If the series of `g` ends before the step does, several polynomials
    /// are used.
    ///
    /// Jumps count, poles do not. A search that starts at the event of an earlier search does not find this event again. A function that is
    /// identically zero, or not finite, is an error.
    ///
    /// ```
    /// use geoint_runtime::prelude::*;
    ///
    /// #[hamiltonian]
    /// fn oscillator(q: f64, p: f64) -> f64 {
    ///     p * p / 2.0 + q * q / 2.0
    /// }
    ///
    /// let mut sim = Oscillator.taylor(Taylor::default(), State::new(0.0, 1.0));
    /// for (n, crossing) in sim.crossings(Direction::Any, |state| state.q * state.p).take(8).enumerate() {
    ///     let t = crossing?.state.t;
    ///     assert!((t - std::f64::consts::FRAC_PI_2 * (n + 1) as f64).abs() < 1e-13);
    /// }
    /// # Ok::<(), StepError>(())
    /// ```
    pub fn crossings<G, F>(&mut self, direction: Direction, g: F) -> TaylorCrossings<'_, S, M, R, F, G>
    where
        G: Array<Real = M::Series>,
        F: Fn(&S::Over<M::Series>) -> G,
    {
        Crossings::new(SeriesFunctions::new(self, g), direction)
    }

    /// Steps to the first change of sign of `g`, but not beyond the time `t`. The run is then at the event and continues from there.
    ///
    /// Returns `None` if there is no such change; the run is then at `t`. Simultaneous events of several functions are reported one by one, as by
    /// [`Dense::until_event`](crate::Dense::until_event).
    ///
    /// # Errors
    /// See [`StepError`]. The state is then the last good one. If `g` has no events ([`Failure::NoEvent`](crate::Failure::NoEvent)), the state is the one
    /// at the start of the search.
    pub fn until_event<G, F>(
        &mut self,
        t: R,
        direction: Direction,
        g: F,
    ) -> Result<Option<Crossing<StateOf<S, R>>>, StepError>
    where
        G: Array<Real = M::Series>,
        F: Fn(&S::Over<M::Series>) -> G,
    {
        let start = self.clone();
        self.crossings(direction, g).until(t).go_to_first(start)
    }
}
