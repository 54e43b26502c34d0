//! A run whose method is named while the program runs.

use super::{Bits, Integrator, Resumable};
use crate::method::{Method, Visitor};
use crate::system::{PhaseSpace, StateOf};
use alloc::boxed::Box;

/// A run behind a pointer, whatever its method, which can be saved.
pub type DynTrajectory<S, R = f64> = Box<dyn Resumable<State = StateOf<S, R>>>;

/// Starts the method of a given name among those of the [`catalogue`](crate::method::catalogue) that it is shown.
///
/// ```
/// use geoint_runtime::method::catalogue;
/// use geoint_runtime::prelude::*;
/// use geoint_runtime::running::Named;
///
/// #[hamiltonian]
/// fn pendulum(q: f64, p: f64, g: f64) -> f64 {
///     p * p / 2.0 - g * q.cos()
/// }
///
/// for name in ["BlanesMoan6", "Gauss<3>", "Suzuki4 of DiscreteGradient"] {
///     let mut named = Named::new(name, Pendulum { g: 9.81 }, 0.01_f64, State::new(1.0, 0.0));
///     catalogue::general(&mut named);
///     catalogue::separable(&mut named);
///     catalogue::discrete_gradient(&mut named);
///     let mut run = named.run().expect("one of these");
///     let energy = run.energy();
///     run.advance_to(10.0)?;
///     assert!((run.energy() / energy - 1.0).abs() < 1e-9, "{name}");
/// }
/// # Ok::<(), StepError>(())
/// ```
#[doc(alias = "method by name")]
pub struct Named<'a, S: PhaseSpace<R>, R: Bits = f64> {
    name: &'a str,
    system: S,
    h: R,
    start: StateOf<S, R>,
    run: Option<DynTrajectory<S, R>>,
}

impl<'a, S: PhaseSpace<R>, R: Bits> Named<'a, S, R> {
    /// A system that will run under the method `name`, with step size `h`, from `start` on.
    pub fn new(name: &'a str, system: S, h: R, start: StateOf<S, R>) -> Self {
        Named { name, system, h, start, run: None }
    }

    /// The run, if the method was among those shown.
    pub fn run(self) -> Option<DynTrajectory<S, R>> {
        self.run
    }
}

impl<S: PhaseSpace<R> + 'static, R: Bits> Visitor<S, R> for Named<'_, S, R> {
    fn visit<M: Method<S, R> + 'static>(&mut self, method: M) {
        if self.run.is_none() && method.name() == *self.name {
            self.run = Some(Box::new(Integrator::new(self.system, method, self.h, self.start)));
        }
    }
}
