//! Runs are values. They are moved and cloned, never copied by mistake. Large runs fit on the stack of a thread, without optimisation, too.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::{Adaptive, Composed, Integrator, RungeKutta, TaylorIntegrator};
use std::mem::size_of_val;
use std::thread;

/// Sixteen masses in a ring, heavier where they are: positions and momenta are coupled.
#[hamiltonian]
fn ring(q: [f64; 16], p: [f64; 16]) -> f64 {
    let mut energy = 0.0;
    for i in 0..16 {
        let next = q[(i + 1) % 16];
        energy += p[i] * p[i] / (2.0 + q[i] * q[i]) + (next - q[i]).powi(2) / 2.0 + q[i].powi(4);
    }
    energy
}

fn start() -> State<[f64; 16]> {
    State::new(core::array::from_fn(|i| 0.1 * (i as f64).sin()), [0.0; 16])
}

/// Compile-time check that a type is not `Copy`. A type that is not `Copy` has one implementation of the trait. A `Copy` type has two, so the call is
/// ambiguous for rustc.
trait Moved<Which> {
    fn is_moved() {}
}
impl<T> Moved<()> for T {}
impl<T: Copy> Moved<u8> for T {}

#[test]
fn a_run_is_no_copy() {
    <Integrator<Ring, ImplicitMidpoint> as Moved<_>>::is_moved();
    <Integrator<Ring, Composed<DiscreteGradient, 17>> as Moved<_>>::is_moved();
    <Adaptive<Ring, RungeKutta<12>> as Moved<_>>::is_moved();
    <TaylorIntegrator<Ring, Taylor> as Moved<_>>::is_moved();
}

/// Default stack size of a thread in Rust.
const STACK: usize = 2 << 20;

fn on_a_thread(run: impl FnOnce() + Send + 'static) {
    thread::Builder::new().stack_size(STACK).spawn(run).expect("a thread").join().expect("a run");
}

#[test]
fn large_runs_fit_on_the_stack_of_a_thread() {
    on_a_thread(|| {
        let mut run = Ring.integrator(KahanLi8_17a.of(DiscreteGradient), 0.01, start());
        assert!(size_of_val(&run) > 50_000, "no large run: {}", size_of_val(&run));
        let energy = run.energy();
        run.advance(3).unwrap();
        let mut again = run.clone();
        again.advance_to(0.1).unwrap();
        assert!((again.energy() - energy).abs() < 1e-14);
    });
    on_a_thread(|| {
        let mut run = Ring.integrator(Gauss::<4>, 0.01, start());
        run.advance(3).unwrap();
        run.clone().advance_to(0.1).unwrap();
    });
    on_a_thread(|| {
        let mut run = Ring.adaptive(KahanLi8_17a.of(DiscreteGradient), 1e-6, start());
        assert!(size_of_val(&run) > 100_000, "no large run: {}", size_of_val(&run));
        run.advance_to(0.1).unwrap();
    });
}
