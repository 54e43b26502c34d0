//! Tests that hold in all coordinates.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_tests::measure::distance;
use geoint_tests::outer_planets;
use geoint_tests::problems::flat;
use nalgebra::Vector3;

/// Defines the energies of this file in some coordinates, and their tests.
macro_rules! frame {
    ($frame:ident, $coordinates:ident) => {
        pub(crate) mod $frame {
            use super::*;

            /// Bodies under their mutual gravity.
            #[hamiltonian(coordinates = $coordinates)]
            pub(crate) fn outer_planets(q: [Vector3<f64>; 6], p: [Vector3<f64>; 6], m: [f64; 6], g: f64) -> f64 {
                let mut energy = 0.0;
                for i in 0..6 {
                    energy += p[i].norm_squared() / (2.0 * m[i]);
                    for j in 0..i {
                        energy -= g * m[i] * m[j] / (q[i] - q[j]).norm();
                    }
                }
                energy
            }

            /// A flattened star whose gravity is not quite Newton's, two planets, and a tide from outside.
            #[hamiltonian(coordinates = $coordinates)]
            fn further(
                q: [[f64; 3]; 3],
                p: [[f64; 3]; 3],
                t: f64,
                m: [f64; 3],
                g: f64,
                relativity: f64,
                flattening: f64,
                tide: f64,
            ) -> f64 {
                let mut energy = 0.0;
                for i in 0..3 {
                    energy += (p[i][0] * p[i][0] + p[i][1] * p[i][1] + p[i][2] * p[i][2]) / (2.0 * m[i]);
                    for j in 0..i {
                        let d = [q[i][0] - q[j][0], q[i][1] - q[j][1], q[i][2] - q[j][2]];
                        let square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
                        energy -= g * m[i] * m[j] / square.sqrt();
                        if j == 0 {
                            energy -= relativity * m[i] / square;
                            let legendre = (3.0 * d[2] * d[2] / square - 1.0) / 2.0;
                            energy += flattening * m[i] * legendre / (square * square.sqrt());
                        }
                    }
                    energy += tide * m[i] * (q[i][2] * q[i][2] - q[i][0] * q[i][1] * (0.3 * t).cos());
                }
                energy
            }

            /// A nucleus and two electrons: they repel each other.
            #[hamiltonian(coordinates = $coordinates)]
            fn helium(q: [[f64; 2]; 3], p: [[f64; 2]; 3], m: [f64; 3], charge: [f64; 3]) -> f64 {
                let mut energy = 0.0;
                for i in 0..3 {
                    energy += (p[i][0] * p[i][0] + p[i][1] * p[i][1]) / (2.0 * m[i]);
                    for j in 0..i {
                        energy += charge[i] * charge[j] / (q[i][0] - q[j][0]).hypot(q[i][1] - q[j][1]);
                    }
                }
                energy
            }

            pub(crate) const OUTER: OuterPlanets = OuterPlanets { m: outer_planets::MASSES, g: outer_planets::G };

            #[test]
            fn energies_and_momenta_do_not_drift() {
                type Bodies = State<[Vector3<f64>; 6]>;
                let mut sim = OUTER.integrator(Aba10_6_4, 100.0, outer_planets::start()).compensated();
                let moment = |x: &Bodies| (0..6).map(|i| x.q[i].cross(&x.p[i])).sum::<Vector3<f64>>();
                let (energy, before) = (sim.energy(), moment(&sim.state()));
                sim.advance(20_000).expect("no collision");
                assert!((sim.energy() / energy - 1.0).abs() < 1e-14, "{:e}", sim.energy() / energy - 1.0);
                assert!((moment(&sim.state()) - before).norm() < 5e-14 * before.norm());
            }

            #[test]
            #[ignore = "optimised only: a million steps"]
            fn energies_do_not_drift_in_a_million_steps() {
                let mut sim = OUTER.integrator(Aba10_6_4, 100.0, outer_planets::start()).compensated();
                let energy = sim.energy();
                for _ in 0..100 {
                    sim.advance(10_000).expect("no collision");
                    // Measured: 4e-14 in coordinates of Jacobi, 7e-14 in heliocentric ones.
                    assert!((sim.energy() / energy - 1.0).abs() < 2e-13, "{:e}", sim.energy() / energy - 1.0);
                }
            }

            #[test]
            fn the_state_is_that_of_the_user() {
                let start = outer_planets::start();
                let mut sim = OUTER.integrator(Saba4, 300.0, start);
                assert_eq!(sim.state(), start);
                assert_eq!(sim.energy(), OUTER.energy(&start));
                sim.advance(100).expect("no collision");
                let mut single = OUTER.integrator(Saba4, 300.0, start);
                (0..100).for_each(|_| single.step().expect("no collision"));
                assert!(outer_planets::error(&sim.state(), &single.state()) < 1e-13);
                // The step is symmetric, so the steps backwards return to the start.
                sim.set_step_size(-300.0);
                sim.advance(100).expect("no collision");
                assert!(outer_planets::error(&sim.state(), &start) < 1e-12);
            }

            /// Additional terms belong to the rest: general relativity as a correction in 1/r², a flattened star, a tide that depends on time.
            #[test]
            fn further_terms_are_part_of_the_rest() {
                let system = Further { m: [1.3, 2e-3, 5e-4], g: 0.9, relativity: 2e-3, flattening: 3e-3, tide: 1e-3 };
                let q = [[0.1, -0.2, 0.05], [1.2, 0.3, 0.1], [-2.0, 1.9, -0.4]];
                let v = [[0.02, 0.01, 0.0], [-0.2, 0.9, 0.1], [-0.45, -0.4, 0.05]];
                let p = std::array::from_fn(|i| v[i].map(|v| v * system.m[i]));
                let start = State { t: 0.7, ..State::new(q, p) };
                let mut exact = system.integrator(BceRkn17_8, 0.01, start);
                exact.advance(2000).expect("no collision");
                let error = |steps: u64| {
                    let mut sim = system.integrator(Aba8_4, 20.0 / steps as f64, start);
                    sim.advance(steps).expect("no collision");
                    distance(&flat(&sim.state()), &flat(&exact.state()))
                };
                let [long, short] = [800, 1600].map(error);
                assert!(short < 1e-8, "{short:e}");
                assert!(long / short > 3.5, "{long:e} {short:e}");
                // Control: small terms change the result.
                let mut newton = Further { relativity: 0.0, flattening: 0.0, tide: 0.0, ..system }.integrator(BceRkn17_8, 0.01, start);
                newton.advance(2000).expect("no collision");
                assert!(distance(&flat(&newton.state()), &flat(&exact.state())) > 1e-3);
            }

            #[test]
            fn charges_are_bodies_as_well() {
                let system = Helium { m: [7000.0, 1.0, 1.0], charge: [2.0, -1.0, -1.0] };
                let start = State::new([[0.0; 2], [1.0, 0.1], [-1.9, 0.3]], [[0.0, -1.9], [0.1, 1.2], [0.0, -0.7]]);
                let mut exact = system.integrator(BceRkn17_8, 0.001, start);
                exact.advance(3000).expect("no collision");
                let mut sim = system.integrator(Aba8_4, 0.002, start);
                sim.advance(1500).expect("no collision");
                let error = distance(&flat(&sim.state()), &flat(&exact.state()));
                assert!(error < 1e-6, "{error:e}");
            }

            /// The orbit of a very light body equals its limit for mass 0, even if its attraction is lost to rounding.
            #[test]
            fn test_particles() {
                let with = |mass: f64| {
                    let mut system = OUTER;
                    system.m[5] = mass;
                    let mut start = outer_planets::start();
                    start.p[5] = Vector3::from(outer_planets::VELOCITIES[5]) * mass;
                    let mut sim = system.integrator(Aba10_6_4, 400.0, start);
                    sim.advance(500).expect("no collision");
                    sim.state().q[5]
                };
                let limit = with(1e-30);
                assert!((with(1e-20) - limit).norm() < 1e-11 * limit.norm());
                assert!((with(1e-5) - limit).norm() > 1e-9 * limit.norm());
            }

            /// A mass of zero is refused, because the velocity would divide by it.
            #[test]
            fn masses_of_zero_are_refused() {
                for body in 0..6 {
                    let mut massless = OUTER;
                    massless.m[body] = 0.0;
                    let start = outer_planets::start();
                    let mut sim = massless.integrator(WisdomHolman, 100.0, start);
                    let expected = format!("division by zero: m[{body}]");
                    let refused = sim.advance(10);
                    assert!(matches!(refused, Err(StepError { failure: Failure::OutsideDomain { what }, .. }) if what == expected), "{refused:?}");
                    assert_eq!(sim.state(), start);
                }
            }

            #[test]
            fn bodies_at_one_place_are_refused() {
                let mut together = outer_planets::start();
                together.q[3] = together.q[2];
                let mut sim = OUTER.integrator(Aba10_6_4, 100.0, together);
                let refused = sim.advance(10);
                let Err(StepError { failure: Failure::OutsideDomain { what }, .. }) = refused else { panic!("{refused:?}") };
                assert!(what.contains("q[3]") && what.contains("q[2]"), "{what}");
                assert_eq!(sim.state(), together);
            }

            /// A step of half a period of the innermost planet, or more, is wrong but gives no error.
            #[test]
            fn steps_that_mean_nothing_are_taken() {
                for h in [2000.0, 5000.0] {
                    let mut sim = OUTER.integrator(WisdomHolman, h, outer_planets::start());
                    sim.advance(20).expect("numbers");
                    assert!(sim.state().q.iter().all(|q| q.iter().all(|x| x.is_finite())));
                }
            }

            /// Bodies in another order than the order of their distances make the rest larger. The result stays right.
            #[test]
            fn bodies_in_any_order() {
                let order = [0, 5, 2, 4, 1, 3];
                let arranged = OuterPlanets { m: order.map(|i| OUTER.m[i]), ..OUTER };
                let start = outer_planets::start();
                let mut sim = arranged.integrator(Aba10_6_4, 50.0, State::new(order.map(|i| start.q[i]), order.map(|i| start.p[i])));
                let mut exact = OUTER.integrator(BceRkn17_8, 40.0, start);
                sim.advance(400).expect("no collision");
                exact.advance(500).expect("no collision");
                let (found, mut state) = (sim.state(), exact.state());
                (state.q, state.p) = (order.map(|i| state.q[i]), order.map(|i| state.p[i]));
                let error = outer_planets::error(&found, &state);
                assert!(error < 1e-9, "{error:e}");
            }
        }
    };
}

frame!(in_jacobi_s, jacobi);
frame!(heliocentric, heliocentric);

/// All coordinates describe the same energy, so their runs end at the same state.
#[test]
fn all_coordinates_lead_to_the_same_place() {
    let run = |state: State<[Vector3<f64>; 6]>, error: f64| {
        let mut exact = in_jacobi_s::OUTER.integrator(BceRkn17_8, 40.0, outer_planets::start());
        exact.advance(5000).expect("no collision");
        assert!(outer_planets::error(&state, &exact.state()) < error);
    };
    let mut first = in_jacobi_s::OUTER.integrator(Aba10_6_4, 200.0, outer_planets::start());
    first.advance(1000).expect("no collision");
    run(first.state(), 1e-11);
    let mut second = heliocentric::OUTER.integrator(Aba10_6_4, 200.0, outer_planets::start());
    second.advance(1000).expect("no collision");
    run(second.state(), 1e-11);
}
