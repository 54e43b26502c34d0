//! Units: states of 10¹⁵⁰ and 10⁻¹⁵⁰, and of 10¹⁵ and 10⁻¹⁵ in `f32`, move like states near 1, to the last bit. Products of parameters must be
//! numbers with all their digits. Integrals must be, too, if a method asks for their change.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

/// Tests a free body whose moments of inertia and angular velocities have units of powers of two. In its unit of time the motion is unchanged.
macro_rules! free_bodies {
    ($real:ident, $top:ident $body:ident $momenta:ident, states $states:expr, inertia $inertia:expr, values $values:expr) => {
        use super::*;

        fn power(k: i32) -> $real {
            (2.0 as $real).powi(k)
        }

        /// Coordinates after ten steps, in plain units; and how many steps there were.
        fn run<S: PhaseSpace<$real, State = FlowState<[$real; 3]>>, M: Method<S, $real>>(
            system: S,
            method: M,
            state: i32,
            time: i32,
        ) -> (Vec<u64>, u64) {
            let start = [0.5, 0.8, -0.4].map(|x: $real| x * power(state));
            let mut sim = Integrator::new(system, method, 0.3 * power(time), FlowState::new(start));
            let _ = sim.advance(10);
            (sim.state().x.iter().map(|x| f64::from(x * power(-state)).to_bits()).collect(), sim.steps())
        }

        fn check<M>(method: M, states: &[i32], inertia: &[i32])
        where
            M: Method<$top, $real> + Method<$body, $real> + Method<$momenta, $real>,
        {
            let moments = |j: i32| [1.1, 2.3, 2.9].map(|moment: $real| moment * power(j));
            let all = |j: i32, k: i32| {
                let [a, b, c] = moments(j);
                [
                    run($top { a, b, c }, method, k, -k),
                    run($body { inertia: [a, b, c] }, method, k, -k),
                    // Angular momenta.
                    run($momenta { inertia: [a, b, c] }, method, j + k, -k),
                ]
            };
            let plain = all(0, 0);
            assert!(plain.iter().all(|(_, steps)| *steps == 10), "{}", Method::<$top, $real>::name(&method));
            for &k in states {
                assert_eq!(all(0, k), plain, "{}, states of 2^{k}", Method::<$top, $real>::name(&method));
            }
            for &j in inertia {
                assert_eq!(all(j, 0), plain, "{}, inertia of 2^{j}", Method::<$top, $real>::name(&method));
                assert_eq!(all(j, -j), plain, "{}, inertia of 2^{j}", Method::<$top, $real>::name(&method));
            }
        }

        #[test]
        fn free_bodies_in_all_units() {
            check(DiscreteGradient, &$states, &$inertia);
            check(FourthOrder(DiscreteGradient), &$states, &$inertia);
            check(Suzuki4.of(DiscreteGradient), &$states, &$inertia);
            check(ImplicitMidpoint, &$states, &$inertia);
            check(Gauss::<2>, &$states, &$inertia);
            check(Kahan, &$states, &$inertia);
            check(RK4, &$states, &$inertia);
            // These methods need the change of integrals.
            check(Projection(RK4, Energy), &$values, &$values);
            check(Relaxation(RK4), &$values, &$values);
        }
    };
}

mod double {
    #[vector_field(keeps(
        energy = (a * x[0] * x[0] + b * x[1] * x[1] + c * x[2] * x[2]) / 2.0,
        momentum = (a * a * x[0] * x[0] + b * b * x[1] * x[1] + c * c * x[2] * x[2]) / 2.0,
    ))]
    pub(super) fn velocities(x: [f64; 3], a: f64, b: f64, c: f64) -> [f64; 3] {
        [(b - c) / a * x[1] * x[2], (c - a) / b * x[2] * x[0], (a - b) / c * x[0] * x[1]]
    }

    #[hamiltonian(structure = |i, j| {
        let k = 3 - i - j;
        (if j == i + 1 { -1.0 } else { 1.0 }) * inertia[k] * x[k] / (inertia[i] * inertia[j])
    })]
    pub(super) fn structured(x: [f64; 3], inertia: [f64; 3]) -> f64 {
        (0..3).map(|i| inertia[i] * x[i] * x[i] / 2.0).sum()
    }

    #[hamiltonian(structure = so3)]
    pub(super) fn momenta(x: [f64; 3], inertia: [f64; 3]) -> f64 {
        (0..3).map(|i| x[i] * x[i] / (2.0 * inertia[i])).sum()
    }

    free_bodies!(f64, Velocities Structured Momenta, states [-498, 498], inertia [-330, 330], values [-330, 330]);
}

mod single {
    #[vector_field(keeps(
        energy = (a * x[0] * x[0] + b * x[1] * x[1] + c * x[2] * x[2]) / 2.0,
        momentum = (a * a * x[0] * x[0] + b * b * x[1] * x[1] + c * c * x[2] * x[2]) / 2.0,
    ))]
    pub(super) fn velocities(x: [f32; 3], a: f32, b: f32, c: f32) -> [f32; 3] {
        [(b - c) / a * x[1] * x[2], (c - a) / b * x[2] * x[0], (a - b) / c * x[0] * x[1]]
    }

    #[hamiltonian(structure = |i, j| {
        let k = 3 - i - j;
        (if j == i + 1 { -1.0 } else { 1.0 }) * inertia[k] * x[k] / (inertia[i] * inertia[j])
    })]
    pub(super) fn structured(x: [f32; 3], inertia: [f32; 3]) -> f32 {
        (0..3).map(|i| inertia[i] * x[i] * x[i] / 2.0).sum()
    }

    #[hamiltonian(structure = so3)]
    pub(super) fn momenta(x: [f32; 3], inertia: [f32; 3]) -> f32 {
        (0..3).map(|i| x[i] * x[i] / (2.0 * inertia[i])).sum()
    }

    free_bodies!(f32, Velocities Structured Momenta, states [-50, 50], inertia [-40, 40], values [-30, 30]);
}

/// A step with more turns than a number has digits resolves nothing. Staying at the start is no step, so the step moves or is refused.
#[test]
fn steps_of_endless_turns_are_refused() {
    let turns = |method: &str, outcome: Result<(), StepError>, [before, after]: [[f64; 3]; 2]| match outcome {
        Ok(()) => assert!(before != after, "{method} stays"),
        Err(_) => assert_eq!(before, after, "{method}"),
    };
    let start = [0.5, 0.8, -0.4];
    for a in [1e-200, 1e-150, 1e-100, 1e-50, 1e-20, 1e20, 1e50, 1e100, 1e150] {
        for h in [0.1, 1e-3] {
            let mut sim = double::Velocities { a, b: 2.0, c: 3.0 }.integrator(
                FourthOrder(DiscreteGradient),
                h,
                FlowState::new(start),
            );
            turns("velocities", sim.step(), [start, sim.state().x]);
            let system = double::Structured { inertia: [a, 2.0, 3.0] };
            let mut sim = system.integrator(FourthOrder(DiscreteGradient), h, FlowState::new(start));
            turns("structured", sim.step(), [start, sim.state().x]);
            if a < 1.0 {
                let system = double::Momenta { inertia: [a, 2.0, 3.0] };
                let mut sim = system.integrator(FourthOrder(DiscreteGradient), h, FlowState::new(start));
                turns("momenta", sim.step(), [start, sim.state().x]);
            }
        }
    }
}
