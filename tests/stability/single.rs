//! `f32`: every method runs as long as in `f64`, and its energy obeys the same law, to the rounding of `f32`.

use geoint_runtime::prelude::*;
use geoint_runtime::{Hamiltonian, Method, Real};
use geoint_tests::methods::{self, Visitor};
use geoint_tests::problems::*;
use std::marker::PhantomData;

/// Without optimisation the long run of every method would take half an hour.
const STEPS: u64 = if cfg!(debug_assertions) { 2_000 } else { 100_000 };

/// Samples of the energy in a run.
const SAMPLES: u64 = 200;

/// A list of methods on a problem with a step size, and the terms of its energy.
struct Single<P> {
    h: f32,
    terms: f64,
    steps: u64,
    failures: Vec<String>,
    problem: PhantomData<P>,
}

impl<P: Problem> Single<P> {
    fn new(h: f32, terms: f64, steps: u64) -> Self {
        Single { h, terms, steps, failures: vec![], problem: PhantomData }
    }

    fn finish(self) {
        assert!(self.failures.is_empty(), "{}:\n{}", P::NAME, self.failures.join("\n"));
    }

    /// The largest error of the energy.
    fn error<S: Hamiltonian<R>, M: Method<S, R>, R: Real>(
        &self,
        system: S,
        method: M,
        h: R,
        start: State<S::Coordinates>,
    ) -> Result<f64, StepError> {
        let mut sim = geoint_runtime::Run::integrator(system, method, h, start);
        let energy = sim.energy();
        (0..SAMPLES).try_fold(0.0, |largest: f64, _| {
            sim.advance(self.steps / SAMPLES)?;
            Ok(largest.max((sim.energy() - energy).magnitude()))
        })
    }
}

impl<P: Problem> Visitor<P::Over<f32>, f32> for Single<P>
where
    P::Over<f32>: Hamiltonian<f32>,
{
    fn visit<M: Method<P::Over<f32>, f32>>(&mut self, name: &'static str, method: M) {
        let claims = method.claims();
        // Explicit Euler gains energy until it is lost.
        if claims.order == 1 && !claims.symplectic && !claims.conserves_energy {
            return;
        }
        let error = self.error(P::system::<f32>(), method, self.h, P::initial::<f32>(0.0));
        // Rounding walks at random.
        let walk = 2.0 * f64::from(f32::EPSILON) * self.terms * (self.steps as f64).sqrt();
        let bound = if claims.conserves_energy { walk } else { f64::INFINITY };
        println!("{:16} {name:40} {:.1e}, of rounding {walk:.1e}", P::NAME, error.unwrap_or(f64::NAN));
        if !matches!(error, Ok(error) if error <= bound) {
            self.failures.push(format!("{name}: {error:?}, at most {bound:.1e}"));
        }
    }
}

macro_rules! every_method {
    ($($test:ident: $System:ident, $h:literal, $terms:literal, $($list:ident)*;)*) => { $(
        #[test]
        fn $test() {
            let mut single = Single::<$System>::new($h, $terms, STEPS);
            $( methods::$list(&mut single); )*
            single.finish();
        }
    )* };
}

every_method! {
    pendulum: Pendulum, 0.05, 20.0, general discrete_gradient projected relaxed separable nystrom;
    coupled: DoublePendulum, 0.03, 10.0, general discrete_gradient itoh_abe itoh_abe_one_way projected relaxed;
    henon_heiles: HenonHeiles, 0.1, 0.3, general discrete_gradient itoh_abe cubic projected relaxed separable force_gradient;
}
