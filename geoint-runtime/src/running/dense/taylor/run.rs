//! Runs by Taylor series between the ends of their steps.

use super::super::crossing::{Crossing, Direction};
use super::super::{Dense, back_without_events};
use super::TaylorCrossings;
use crate::running::reported::Reported;
use crate::running::{StepError, TaylorIntegrator};
use crate::scalar::{Real, signed};
use crate::space::Array;
use crate::system::{Jets, StateOf};
use crate::taylor::TaylorMethod;

impl<S: Jets<R>, M: TaylorMethod<S, R>, R: Real> Dense for TaylorIntegrator<S, M, R> {
    fn set_state(&mut self, state: StateOf<S, R>) {
        self.restart(state);
    }

    fn reported(&mut self) -> &mut Reported<R> {
        &mut self.reported
    }

    fn check_start(&self) -> Result<(), StepError> {
        self.steps.check_start()
    }

    fn at(&self, t: R) -> Option<StateOf<S, R>> {
        self.at(t)
    }

    fn end_at(&mut self, t: R) -> Result<(), StepError> {
        self.advance_to(t)
    }

    fn steps_backwards(&self) -> bool {
        self.steps.backwards
    }

    fn between(_: &Self, after: &Self, t: R) -> Result<StateOf<S, R>, StepError> {
        after.at(t).ok_or(StepError::TimePassed { t: signed(t) })
    }
}

impl<S: Jets<R>, M: TaylorMethod<S, R>, R: Real> TaylorIntegrator<S, M, R> {
    /// Where `g` changes sign: a number, or an array of them, all in order of time, also twice within one step. Without end, unless
    /// [`TaylorCrossings::until`] gives one. Forwards, or in the direction of the last step.
    ///
    /// `g` is a function of truncated series, [`Series`](crate::scalar::Series), which stand for the coordinates along a step: written as
    /// it is for numbers. Its zeros are those of a polynomial, all of them; where the series of `g` ends before a step does, of several
    /// polynomials. Jumps count, poles do not. A search that begins where another one has ended does not find that event again; a function
    /// that is zero all along is an error, and so is one that is no finite number.
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
        TaylorCrossings::new(self, direction, g)
    }

    /// Steps to where `g` changes sign first, but not beyond the time `t`: the run is then there, and goes on from there.
    ///
    /// `None` if that does not happen: the run is then at `t`. Events of several functions at one time are reported one by one, as by
    /// [`Dense::until_event`].
    ///
    /// # Errors
    /// See [`StepError`]; the state is then the last good one, and where `g` is no function with events, that at which the search began.
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
        let found = TaylorCrossings::new(self, direction, g).until(t).next().transpose();
        let found = back_without_events(self, start, found)?;
        if let Some(found) = found {
            self.restart(found.state);
            self.reported.add(self.time(), found.which);
        }
        Ok(found)
    }
}
