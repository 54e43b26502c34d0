//! Runs whose method is chosen by name at run time.

use super::{Bits, Integrator, Resumable};
use crate::method::{Method, Visitor};
use crate::system::{PhaseSpace, StateOf};
use alloc::boxed::Box;
use alloc::string::String;

/// A boxed run under any method. It can be saved.
pub type DynTrajectory<S, R = f64> = Box<dyn Resumable<State = StateOf<S, R>>>;

/// Starts the method of a given name. The candidates are the methods that functions of the [`catalogue`](crate::method::catalogue) pass to it.
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
/// for name in ["DiscreteGradient", "Suzuki4 of DiscreteGradient"] {
///     let mut named = Named::new(name, Pendulum { g: 9.81 }, 0.01_f64, State::new(1.0, 0.0));
///     catalogue::discrete_gradient(&mut named);
///     let mut run = named.run().expect("one of these");
///     let energy = run.energy();
///     run.advance_to(10.0)?;
///     assert!((run.energy() / energy - 1.0).abs() < 1e-9, "{name}");
/// }
/// # Ok::<(), StepError>(())
/// ```
#[doc(alias = "method by name")]
pub struct Named<S: PhaseSpace<R>, R: Bits = f64> {
    name: String,
    system: S,
    h: R,
    start: StateOf<S, R>,
    run: Option<DynTrajectory<S, R>>,
}

impl<S: PhaseSpace<R>, R: Bits> Named<S, R> {
    /// Prepares a run of `system` under the method `name`, with step size `h`, from `start` on. `Gauss::<3>` and `Gauss<3>` name the same method.
    pub fn new(name: &str, system: S, h: R, start: StateOf<S, R>) -> Self {
        Named { name: name.replace("::<", "<"), system, h, start, run: None }
    }

    /// Returns the run, if one of the candidates has this name.
    pub fn run(self) -> Option<DynTrajectory<S, R>> {
        self.run
    }
}

impl<S: PhaseSpace<R> + 'static, R: Bits> Visitor<S, R> for Named<S, R> {
    fn visit<M: Method<S, R> + 'static>(&mut self, method: M) {
        if self.run.is_none() && method.name() == *self.name.as_str() {
            self.run = Some(Box::new(Integrator::new(self.system, method, self.h, self.start)));
        }
    }
}
