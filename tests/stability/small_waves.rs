//! Forces that cancel: the rounding of a residual is the rounding of its terms. A step is accepted if its residual is at this level, and refused otherwise.

use geoint_runtime::method::implicit::SolvedBy;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::private::Collocation;
use geoint_runtime::{Hamiltonian, IntoIntegrator, Method, Real};
use geoint_tests::measure::Noise;
use geoint_tests::problems::*;

/// A ring of springs that pull with a force of 1 at rest.
macro_rules! rings {
    ($($function:ident $n:literal $real:ident;)*) => { $(
        #[hamiltonian]
        fn $function(q: [$real; $n], p: [$real; $n], m: $real) -> $real {
            let mut h = 0.0;
            for i in 0..$n {
                h += p[i] * p[i] / (2.0 * m) + (q[i] - q[(i + 1) % $n]).exp();
            }
            h
        }
    )* };
}

rings! {
    ring_5 5 f64;
    ring_8 8 f64;
    ring_12 12 f64;
    short_ring 7 f32;
}

/// Atoms in a row at their distances of rest.
#[hamiltonian]
fn row(q: [f64; 13], p: [f64; 13], m: f64) -> f64 {
    let mut h = 0.0;
    for i in 0..13 {
        h += p[i] * p[i] / (2.0 * m);
    }
    for i in 0..12 {
        let r = q[i + 1] - q[i] + 1.122_462_048_309_373;
        let s = 1.0 / r.powi(6);
        h += 4.0 * (s * s - s);
    }
    h
}

/// The same ring, not separable.
#[hamiltonian]
fn coupled_ring(q: [f64; 4], p: [f64; 4], m: f64) -> f64 {
    let mut h = 0.0;
    for i in 0..4 {
        h += p[i] * p[i] / (2.0 * m) * (1.0 + q[i] * q[i]) + (q[i] - q[(i + 1) % 4]).exp();
    }
    h
}

/// Starts with random states of amplitudes down to `smallest`, and with single displacements. Asserts that each run succeeds and keeps the energy, relative
/// to the energy.
fn runs<S: Hamiltonian<R>, M: Method<S, R>, R: Real + PartialOrd>(name: &str, system: S, method: M, smallest: f64) {
    let n = <S::Array as geoint_runtime::space::Array>::LEN;
    let mut noise = Noise::new(3);
    let mut worst = 0.0_f64;
    // An unoptimised build tests every fourth decade.
    for decade in (3..).step_by(if cfg!(debug_assertions) { 4 } else { 1 }) {
        let size = 10.0_f64.powi(-decade);
        if size < smallest {
            break;
        }
        for h in [0.3, 0.1, 0.01, 0.001] {
            let mut random = || -> Vec<f64> { noise.by_ref().take(n).map(|x| size * x).collect() };
            let (q, p) = (random(), random());
            let site: Vec<f64> = (0..n).map(|i| if i == 0 { size } else { 0.0 }).collect();
            for (q, p) in [(q, p), (site, vec![0.0; n])] {
                let mut sim = system.integrator(method, R::from_f64(h), state::<S, R>(0.0, &q, &p));
                let energy = sim.energy();
                let outcome = sim.advance(40);
                assert!(
                    outcome.is_ok(),
                    "{name}, {}, size {size:.0e}, h {h}, step {}: {outcome:?}",
                    method.name(),
                    sim.steps()
                );
                worst = worst.max(((sim.energy() - energy) / energy).magnitude());
            }
        }
    }
    if method.claims().conserves_energy {
        assert!(worst <= 8.0 * R::epsilon(), "{name}: {worst:.1e}");
    }
}

/// Waves down to amplitudes below the rounding of the distances between neighbours.
#[test]
fn small_waves_are_solved() {
    runs("ring of 12", Ring12 { m: 1.7 }, DiscreteGradient, 1e-16);
    runs("ring of 12", Ring12 { m: 1.7 }, ImplicitMidpoint, 1e-17);
    runs("ring of 5", Ring5 { m: 0.6 }, Gauss::<2>, 1e-16);
    runs("ring of 5", Ring5 { m: 0.6 }, Projection(RK4, Energy), 1e-11);
    runs("ring of 5", Ring5 { m: 0.6 }, Relaxation(RK4), 1e-11);
    runs("row of 13", Row { m: 1.3 }, DiscreteGradient, 1e-20);
    runs("row of 13", Row { m: 1.3 }, ImplicitMidpoint, 1e-20);
    runs("coupled ring", CoupledRing { m: 1.7 }, DiscreteGradient, 1e-16);
    runs("coupled ring", CoupledRing { m: 1.7 }, Gauss::<2>, 1e-16);
    runs("short ring", ShortRing { m: 1.7 }, DiscreteGradient, 1e-9);
    runs("short ring", ShortRing { m: 1.7 }, ImplicitMidpoint, 1e-9);
}

/// Small waves with methods that are solved without an exact derivative.
#[test]
fn small_waves_without_a_derivative() {
    runs("ring of 5", Ring5 { m: 0.6 }, Gonzalez, 1e-14);
    runs("ring of 5", Ring5 { m: 0.6 }, MeanValue::<2>, 1e-14);
    runs("ring of 5", Ring5 { m: 0.6 }, ItohAbePair, 1e-14);
    runs("coupled ring", CoupledRing { m: 1.7 }, FourthOrder(MeanValue::<3>), 1e-11);
    runs("coupled ring", CoupledRing { m: 1.7 }, FourthOrder(SymmetrisedItohAbe), 1e-11);
    runs("short ring", ShortRing { m: 1.7 }, Gonzalez, 1e-6);
}

/// The mean velocity of the tree discrete gradient, projected.
#[test]
fn small_waves_of_order_four() {
    runs("ring of 5", Ring5 { m: 0.6 }, FourthOrder(DiscreteGradient), 1e-16);
}

/// Regression test: these steps were the first to be refused.
#[test]
fn single_displacements() {
    let mut q = [0.0; 8];
    q[0] = 1e-3;
    assert_eq!(Ring8 { m: 1.0 }.integrator(DiscreteGradient, 0.1, State::new(q, [0.0; 8])).advance(100), Ok(()));
    let mut q = [0.0; 5];
    q[0] = 1e-8;
    assert_eq!(Ring5 { m: 1.0 }.integrator(ImplicitMidpoint, 0.2, State::new(q, [0.0; 5])).advance(100), Ok(()));
}

/// Charges on the corners of a square, held by springs.
#[hamiltonian]
fn corners(q: [[f64; 2]; 4], p: [[f64; 2]; 4], m: f64, k: f64) -> f64 {
    let mut h = 0.0;
    for i in 0..4 {
        h += (p[i][0] * p[i][0] + p[i][1] * p[i][1]) / (2.0 * m);
        for j in 0..i {
            let r = (q[i][0] - q[j][0]).hypot(q[i][1] - q[j][1]);
            h += k / r + k * r.powi(3);
        }
    }
    h
}

/// A breathing square with small transverse waves. The rounding of a small momentum is the rounding of the forces at its site, far below the sizes of other
/// momenta.
#[test]
fn small_waves_beside_large_ones() {
    fn check<M: Method<Corners>>(method: M) {
        let mut noise = Noise::new(5);
        for (h, size) in [(0.3, 1e-8), (0.3, 1e-9), (0.1, 1e-9), (0.1, 1e-10)] {
            for _ in 0..3 {
                let mut q = [[0.7, 0.0], [0.0, 0.7], [-0.7, 0.0], [0.0, -0.7]];
                for (x, wave) in q.as_flattened_mut().iter_mut().zip(noise.by_ref()) {
                    *x += size * wave;
                }
                let mut sim = Corners { m: 1.3, k: 0.7 }.integrator(method, h, State::new(q, [[0.0; 2]; 4]));
                assert_eq!(sim.advance(20), Ok(()), "{}, size {size:.0e}, h {h}", method.name());
            }
        }
    }
    check(DiscreteGradient);
    check(ImplicitMidpoint);
    check(Gauss::<2>);
}

/// A force that jumps: where the middle of a step would have to be at the jump, the midpoint rule has no solution.
#[hamiltonian]
fn kinked(q: f64, p: f64, m: f64, k: f64, kink: f64) -> f64 {
    p * p / (2.0 * m) + k * (1.0 - q.cos()) + kink * q.abs()
}

/// Returns |x₁ − x₀ − hJ∇H((x₀ + x₁)/2)|, minus its change under a rounding of the midpoint, relative to x₀, x₁ and their difference.
fn residual<S: Hamiltonian<f64>>(system: &S, h: f64, from: &State<S::Coordinates>, to: &State<S::Coordinates>) -> f64 {
    use geoint_runtime::space::{Array, Snapshot};
    let [x0, x1] = [from, to].map(flat);
    let n = x0.len() / 2;
    let rates = |middle: &[f64]| -> Vec<f64> {
        let middle = state::<S, f64>(0.0, &middle[..n], &middle[n..]);
        let mut rates = S::Phase::zero();
        system.rate(0.0, &middle.parts().1, &mut rates);
        Array::as_slice(&rates).to_vec()
    };
    let middle: Vec<f64> = x0.iter().zip(&x1).map(|(a, b)| 0.5 * (a + b)).collect();
    let here = rates(&middle);
    let mut rounding = vec![0.0; 2 * n];
    for j in 0..2 * n {
        let mut moved = middle.clone();
        moved[j] *= 1.0 + 2.0 * f64::EPSILON;
        for (sum, (a, b)) in rounding.iter_mut().zip(rates(&moved).iter().zip(&here)) {
            *sum += (h * (a - b)).abs();
        }
    }
    let excess = |i: usize| (x1[i] - x0[i] - h * here[i]).abs() - rounding[i];
    (0..2 * n).map(|i| excess(i) / (x0[i].abs() + x1[i].abs() + (h * here[i]).abs())).fold(0.0, f64::max)
}

/// Long steps from random starts are refused, or end at a solution to rounding.
#[test]
fn what_is_accepted_is_a_solution() {
    fn check<S: Collocation<f64> + Hamiltonian<f64> + SolvedBy<ImplicitMidpoint> + SolvedBy<Gauss<3>>>(
        name: &str,
        system: S,
        reach: f64,
        refused: core::ops::Range<usize>,
    ) {
        let n = <S::Array as geoint_runtime::space::Array>::LEN;
        let (mut noise, mut refusals) = (Noise::new(11), 0);
        for _ in 0..400 {
            let mut random = || -> Vec<f64> { noise.by_ref().take(n).map(|x| reach * x).collect() };
            let start = state::<S, f64>(0.0, &random(), &random());
            let h = 0.1 * 100.0_f64.powf(0.5 + 0.5 * noise.next().unwrap_or_default());
            let mut sim = system.integrator(ImplicitMidpoint, h, start);
            match sim.step() {
                Ok(()) => {
                    let residual = residual(&system, h, &start, &sim.state());
                    assert!(residual <= 1e-13, "{name}, h = {h}: {residual:.1e} from {start:?}");
                }
                Err(_) => refusals += 1,
            }
        }
        println!("{name}: {refusals} refused");
        assert!(refused.contains(&refusals), "{name}: {refusals}");
    }
    check("pendulum", Pendulum::system::<f64>(), 2.0, 1..200);
    check("double pendulum", DoublePendulum::system::<f64>(), 1.0, 1..300);
    check("kink", Kinked { m: 1.3, k: 0.8, kink: 0.3 }, 0.5, 10..300);
    check("small kink", Kinked { m: 1.3, k: 0.8, kink: 1e-5 }, 0.01, 1..300);
    check("toda", Toda::system::<f64>(), 0.5, 0..200);
}
