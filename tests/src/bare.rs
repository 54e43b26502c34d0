//! Steps of a method without an integrator, for programs that build a thousand methods.
//!
//! An [`Integrator`](geoint_runtime::Integrator) has several copies of every step: for one step and for many, with and without an observer. This type
//! has one copy. The tests of integrators cover their additions.

use crate::scalars::Scalar;
use crate::scene::{Scene, flat, point};
use geoint_runtime::method::{Effort, Failure, Observer, Probe, Step};
use geoint_runtime::space::{Plain, Point, Snapshot};
use geoint_runtime::{Method, PhaseSpace, Real};

/// A method on a scene.
pub struct Bare<P: Scene, M: Method<P::Over<R>, R>, R: Scalar> {
    system: P::Over<R>,
    method: M,
    prepared: M::Prepared,
    memory: M::Memory,
    start: R,
    h: R,
    steps: u64,
    x: PointOf<P, R>,
    evaluations: Count,
}

/// A point in the phase space of a scene.
type PointOf<P, R> =
    Point<<<P as Scene>::Over<R> as PhaseSpace<R>>::Phase, Plain, <<P as Scene>::Over<R> as PhaseSpace<R>>::Action>;

/// Points at which an energy was evaluated to solve an equation.
struct Count(u64);

impl Observer for Count {
    fn pause(&mut self, _: bool) {}
}

impl<S: PhaseSpace<R>, R: Real> Probe<S, R> for Count {
    const EFFORT: Effort = Effort::Fast;

    fn visit(&mut self, _: R, _: &S::Phase, _: &S::Action) {
        self.0 += 1;
    }
}

impl<P: Scene, M: Method<P::Over<R>, R>, R: Scalar> Bare<P, M, R> {
    /// The method with steps of length `h`, from a time and a list of coordinates on.
    pub fn new(method: M, h: R, t: R, x: &[R]) -> Self {
        let system = P::over::<R>();
        let (start, z, action) = point::<<P::Over<R> as PhaseSpace<R>>::State>(t, x).parts();
        let (prepared, memory) = (method.prepare(&system, h), M::memory(&z));
        let mut x = Point::with_action(z, action);
        M::enter(&prepared, &system, start, &mut x.z);
        Bare { system, method, prepared, memory, start, h, steps: 0, x, evaluations: Count(0) }
    }

    /// Takes one step.
    ///
    /// # Errors
    /// Fails if the step has no result.
    #[inline(never)]
    pub fn step(&mut self) -> Result<(), Failure> {
        let [t, end] = [self.steps, self.steps + 1].map(|n| self.at(n));
        let step = Step { system: &self.system, t, end, x: &mut self.x, probe: &mut self.evaluations };
        M::step(&self.prepared, &mut self.memory, step)?;
        self.steps += 1;
        Ok(())
    }

    /// Takes `steps` steps.
    ///
    /// # Errors
    /// Fails if a step has no result.
    pub fn advance(&mut self, steps: u64) -> Result<(), Failure> {
        (0..steps).try_for_each(|_| self.step())
    }

    /// The time now.
    pub fn time(&self) -> R {
        self.at(self.steps)
    }

    fn at(&self, step: u64) -> R {
        self.start + R::from_f64(step as f64) * self.h + self.x.ahead.value()
    }

    fn seen(&self) -> <P::Over<R> as PhaseSpace<R>>::State {
        let mut z = self.x.z;
        M::leave(&self.prepared, &self.system, self.time(), &mut z);
        Snapshot::of(self.time(), z, self.x.s)
    }

    /// All coordinates now.
    pub fn state(&self) -> Vec<R> {
        flat(&self.seen())
    }

    /// The energy now.
    pub fn energy(&self) -> R {
        self.system.energy(&self.seen())
    }

    /// At how many points an energy was evaluated to solve an equation.
    pub fn evaluations(&self) -> u64 {
        self.evaluations.0
    }

    /// Goes back from here.
    #[must_use]
    pub fn back(self) -> Self {
        let (t, x) = (self.time(), self.state());
        Bare::new(self.method, -self.h, t, &x)
    }
}
