//! Runs whose method is chosen by name at run time.

use super::nearest::Nearest;
use super::{Bits, Integrator, Resumable};
use crate::method::{Method, Visitor};
use crate::system::{PhaseSpace, StateOf};
use alloc::boxed::Box;
use alloc::string::String;
use alloc::vec::Vec;
use core::fmt;

/// A boxed run under any method. It can be saved.
pub type DynTrajectory<S, R = f64> = Box<dyn Resumable<State = StateOf<S, R>>>;

/// Starts the method of a given name. The candidates are the methods that functions of the [`catalogue`](crate::method::catalogue) pass to it.
///
/// Names are those of `method.name()`: `Gauss::<3>` is `Gauss<3>`, and `Suzuki4.of(RK4)` is `Suzuki4 of RK4`. Case matters. The run has fixed steps.
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
///     let mut run = named.run()?;
///     let energy = run.energy();
///     run.advance_to(10.0)?;
///     assert!((run.energy() / energy - 1.0).abs() < 1e-9, "{name}");
/// }
///
/// // Another name is an error that suggests the nearest names.
/// let mut named = Named::new("discretegradient", Pendulum { g: 9.81 }, 0.01_f64, State::new(1.0, 0.0));
/// catalogue::discrete_gradient(&mut named);
/// let error = named.run().err().expect("the case differs");
/// assert_eq!(error.to_string(), "no candidate has the name `discretegradient`; did you mean `DiscreteGradient`?");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "method by name")]
pub struct Named<S: PhaseSpace<R>, R: Bits = f64> {
    name: String,
    system: S,
    h: R,
    start: StateOf<S, R>,
    run: Option<DynTrajectory<S, R>>,
    nearest: Nearest,
}

impl<S: PhaseSpace<R>, R: Bits> Named<S, R> {
    /// Prepares a run of `system` under the method `name`, with step size `h`, from `start` on. `Gauss::<3>` and `Gauss<3>` name the same method.
    pub fn new(name: &str, system: S, h: R, start: StateOf<S, R>) -> Self {
        let name = name.replace("::<", "<");
        Named { nearest: Nearest::to(&name), name, system, h, start, run: None }
    }

    /// Returns the run.
    ///
    /// # Errors
    /// If no candidate has this name. The error suggests the nearest names of candidates.
    pub fn run(self) -> Result<DynTrajectory<S, R>, UnknownMethod> {
        self.run.ok_or_else(|| UnknownMethod { name: self.name, nearest: self.nearest.names() })
    }
}

impl<S: PhaseSpace<R> + 'static, R: Bits> Visitor<S, R> for Named<S, R> {
    fn visit<M: Method<S, R> + 'static>(&mut self, method: M) {
        if self.run.is_some() {
            return;
        }
        let name = method.name();
        if name == *self.name.as_str() {
            self.run = Some(Box::new(Integrator::new(self.system, method, self.h, self.start)));
        } else {
            self.nearest.offer(name);
        }
    }
}

/// No candidate of [`Named`] has the name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownMethod {
    name: String,
    nearest: Vec<String>,
}

impl UnknownMethod {
    /// Returns the name that no candidate has.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Returns the nearest names of candidates by edit distance, the best one first. At most three, and none if all are far.
    pub fn nearest(&self) -> &[String] {
        &self.nearest
    }
}

impl fmt::Display for UnknownMethod {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "no candidate has the name `{}`", self.name)?;
        for (i, name) in self.nearest.iter().enumerate() {
            let before = match i {
                0 => "; did you mean ",
                _ if i + 1 < self.nearest.len() => ", ",
                _ => " or ",
            };
            write!(f, "{before}`{name}`")?;
        }
        f.write_str(if self.nearest.is_empty() { "" } else { "?" })
    }
}

impl core::error::Error for UnknownMethod {}
