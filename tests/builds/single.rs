//! `f32`: every method runs as long as in `f64`, and its energy obeys the same law, to the rounding of `f32`.

use geoint_runtime::prelude::*;
use geoint_runtime::{Claims, Hamiltonian, IntoIntegrator, Method, Real};
use geoint_tests::methods::{self, Visitor};
use geoint_tests::problems::*;
use std::marker::PhantomData;

/// Without optimisation the long run of every method would take half an hour.
const STEPS: u64 = if cfg!(debug_assertions) { 2_000 } else { 100_000 };

/// Samples of the energy in a run.
const SAMPLES: u64 = 200;

/// The largest error of the energy in a run.
fn largest<S: Hamiltonian<R>, M: Method<S, R>, R: Real>(
    system: S,
    method: M,
    h: f32,
    start: State<S::Coordinates>,
) -> Result<f64, StepError> {
    let mut sim = system.integrator(method, R::from_f64(h.into()), start);
    let energy = sim.energy();
    (0..SAMPLES).try_fold(0.0, |largest: f64, _| {
        sim.advance(STEPS / SAMPLES)?;
        Ok(largest.max((sim.energy() - energy).magnitude()))
    })
}

/// Explicit Euler gains energy until everything is lost.
fn is_control(claims: Claims) -> bool {
    claims.order == 1 && !claims.symplectic && !claims.conserves_energy
}

/// Methods on a problem in `f64`: the errors of those that do not keep the energy.
struct Long<P> {
    h: f32,
    errors: Vec<(String, f64)>,
    problem: PhantomData<P>,
}

impl<P: Problem> Visitor<P::Over<f64>, f64> for Long<P> {
    fn visit<M: Method<P::Over<f64>, f64> + 'static>(&mut self, method: M) {
        let name = method.name().to_string();
        let claims = method.claims();
        if !claims.conserves_energy && !is_control(claims) {
            self.errors.push((name, largest(P::system::<f64>(), method, self.h, P::initial::<f64>(0.0)).unwrap()));
        }
    }
}

/// The same methods in `f32`, and the terms of the energy.
struct Single<P> {
    long: Long<P>,
    terms: f64,
    failures: Vec<String>,
}

impl<P: Problem> Visitor<P::Over<f32>, f32> for Single<P> {
    fn visit<M: Method<P::Over<f32>, f32> + 'static>(&mut self, method: M) {
        let name = method.name().to_string();
        if is_control(method.claims()) {
            return;
        }
        let error = largest(P::system::<f32>(), method, self.long.h, P::initial::<f32>(0.0));
        // Rounding walks at random.
        let walk = 4.0 * f64::from(f32::EPSILON) * self.terms * (STEPS as f64).sqrt();
        let law = self.long.errors.iter().find(|long| long.0 == name).map_or(0.0, |long| long.1);
        println!("{:16} {name:40} {:.1e}; as f64 {law:.1e}, walk {walk:.1e}", P::NAME, error.unwrap_or(f64::NAN));
        if !matches!(error, Ok(error) if error <= 1.1 * law + walk) {
            self.failures.push(format!("{name}: {error:?}; as f64 {law:.1e}, walk {walk:.1e}"));
        }
    }
}

macro_rules! every_kind {
    ($($test:ident: $System:ident, $h:literal, $terms:literal, $($list:ident)*;)*) => { $(
        #[test]
        fn $test() {
            let mut long = Long::<$System> { h: $h, errors: vec![], problem: PhantomData };
            $( methods::$list(&mut long); )*
            let mut single = Single { long, terms: $terms, failures: vec![] };
            $( methods::$list(&mut single); )*
            assert!(single.failures.is_empty(), "{}", single.failures.join("\n"));
        }
    )* };
}

every_kind! {
    pendulum: Pendulum, 0.05, 20.0, kinds_of_general kinds_of_discrete_gradient projected relaxed kinds_of_separable kinds_of_nystrom;
    coupled: DoublePendulum, 0.03, 10.0, kinds_of_general kinds_of_discrete_gradient kinds_of_itoh_abe itoh_abe_one_way projected relaxed;
    henon_heiles: HenonHeiles, 0.1, 0.3, kinds_of_general kinds_of_discrete_gradient kinds_of_itoh_abe kinds_of_cubic projected relaxed
        kinds_of_separable kinds_of_force_gradient;
}
