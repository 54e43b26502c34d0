//! Statements of Aung's thesis (2000) and of the talk on contact integrators, one by one.

use crate::references::{ARM, DOUBLE_PENDULUM};
use crate::systems::*;
use geoint_runtime::Hamiltonian;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

/// A slope by differences of order 4.
fn slope(f: impl Fn(f64) -> f64) -> f64 {
    let h = 1e-3;
    (f(-2.0 * h) - 8.0 * f(-h) + 8.0 * f(h) - f(2.0 * h)) / (12.0 * h)
}

/// Example 2.2.1. The thesis leaves the energy of this Lagrangian in x', where it is no Hamiltonian. In p the mass 1 + 2εx divides p², and the energy
/// is singular at x = −1/(2ε).
#[test]
fn the_first_example_in_momenta() {
    let (system, q, v) = (Cubic { epsilon: 0.2, delta: 0.1 }, 0.8, 0.5);
    let state = system.at(q, v);
    let p = state.p;
    assert!((state.p - (1.0 + 0.4 * q) * v).abs() < 1e-16);
    let in_momenta = state.p.powi(2) / (2.0 * (1.0 + 0.4 * q)) + 0.5 * q * q + 0.1 * q.powi(3);
    assert!((system.energy(&state) - in_momenta).abs() < 1e-15);
    // In x' the energy is ½(1 + 2εx)x'² + …, with another derivative at constant p.
    let at = |by: f64| system.energy(&State::new(q + by, p));
    let wrong = |by: f64| 0.5 * (1.0 + 0.4 * (q + by)) * v * v + 0.5 * (q + by).powi(2) + 0.1 * (q + by).powi(3);
    let mut slopes = [[0.0]; 2];
    system.gradient(0.0, &[[q], [state.p]], &mut slopes);
    assert!((slope(at) - slopes[0][0]).abs() < 1e-10);
    assert!((slope(wrong) - slopes[0][0]).abs() > 0.05);
}

/// Example 2.2.7: H = −p²q + q² − 2pq + F(p) from p' = p² − 2q + 2p. The thesis asks for F' = F; every F will do, because it is in the other
/// equation alone.
#[test]
fn the_last_example_for_any_function_of_momenta() {
    #[hamiltonian]
    fn exponential(q: f64, p: f64) -> f64 {
        -p * p * q + q * q - 2.0 * p * q + p.exp()
    }
    #[hamiltonian]
    fn other(q: f64, p: f64) -> f64 {
        -p * p * q + q * q - 2.0 * p * q + p.sin() * p * p
    }
    for (q, p) in [(0.3, -0.4), (1.2, 0.7)] {
        let z = [[q], [p]];
        let (mut one, mut two) = ([[0.0_f64]; 2], [[0.0_f64]; 2]);
        Exponential.gradient(0.0, &z, &mut one);
        Other.gradient(0.0, &z, &mut two);
        let rate = p * p - 2.0 * q + 2.0 * p;
        assert!((-one[0][0] - rate).abs() < 1e-15 && (-two[0][0] - rate).abs() < 1e-15);
        assert!((one[1][0] - two[1][0]).abs() > 0.1);
    }
}

/// 2.2.7 and 2.2.8: L and H are conjugate, p·v = L + H, also for ln v, which is concave; and 2.2.14: dH/dt = −∂L/∂t.
#[test]
fn the_transform_is_an_involution() {
    #[lagrangian]
    fn logarithm(q: f64, v: f64, k: f64) -> f64 {
        k * v.ln() - q * q
    }
    let (system, v) = (Logarithm { k: 1.3 }, 0.7);
    let state = system.at(0.4, v);
    let p = state.p;
    assert!((state.p - 1.3 / 0.7).abs() < 1e-15);
    assert!((state.p * v - system.lagrangian(0.0, 0.4, v) - system.energy(&state)).abs() < 1e-15);
    assert!((system.velocity(&state) - v).abs() < 1e-15);
    // ∂H/∂p = v.
    assert!((slope(|by| system.energy(&State::new(0.4, p + by))) - v).abs() < 1e-10);
    let (system, v) = (MovingPivot { a: 0.1, omega: 20.0, g: 9.81 }, 0.4);
    let state = system.at_time(0.3, 1.1, v);
    let p = state.p;
    let by_time = slope(|by| system.energy(&State::at(0.3 + 0.1 * by, 1.1, p)));
    let of_lagrangian = slope(|by| system.lagrangian(0.3 + 0.1 * by, 1.1, v));
    assert!((by_time + of_lagrangian).abs() < 1e-7, "{by_time} {of_lagrangian}");
}

/// 2.1.11 to 2.1.19, and Herglotz' equations: along a solution q' = v, s' = L and d/dt ∂L/∂v = ∂L/∂q + ∂L/∂s ∂L/∂v + F.
#[test]
fn the_equations_are_lagranges() {
    /// q, v, p and s at a time.
    type At<const N: usize> = ([f64; N], [f64; N], [f64; N], f64);
    fn follows<const N: usize>(
        at: impl Fn(f64) -> At<N>,
        lagrangian: impl Fn([f64; N], [f64; N], f64) -> f64,
        force: [f64; N],
    ) {
        let (q, v, p, s) = at(0.0);
        let growth = slope(|by| lagrangian(q, v, s + by));
        let action = slope(|t| at(t).3) - lagrangian(q, v, s);
        assert!(action.abs() < 1e-9 || growth.abs() < 1e-9, "{action:e} {growth}");
        for i in 0..N {
            let moved = |by: f64| {
                let mut q = q;
                q[i] += by;
                q
            };
            let by_position = slope(|by| lagrangian(moved(by), v, s));
            assert!((slope(|t| at(t).0[i]) - v[i]).abs() < 1e-9);
            let rate = slope(|t| at(t).2[i]);
            assert!((rate - by_position - growth * p[i] - force[i]).abs() < 1e-8, "{rate} {by_position} {growth}");
        }
    }
    macro_rules! at {
        ($system:expr, $start:expr, |$state:ident, $v:ident| $given:expr) => {{
            let (system, start) = ($system, $start);
            move |by: f64| {
                let mut sim = system.integrator(DOP853, if by == 0.0 { 1.0 } else { by }, start);
                if by != 0.0 {
                    sim.step().expect("a step");
                }
                let ($state, $v) = (sim.state(), system.velocity(&sim.state()));
                $given
            }
        }};
    }
    // With an energy, with velocities as unknowns, with time in L, with an action, with a force.
    let (q, v) = ([0.4, 1.1], [0.7, -0.3]);
    let system = DOUBLE_PENDULUM;
    let run = at!(system, system.at(q, v), |state, v| (state.q, v, state.p, 0.0));
    follows(run, |q, v, _| system.lagrangian(0.0, q, v), [0.0; 2]);
    let system = ARM;
    let run = at!(system, system.at([0.5, 0.4, -0.3], [0.1, 0.3, 1.0]), |state, v| (state.q, v, state.p, 0.0));
    follows(run, |q, v, _| system.lagrangian(0.0, q, v), [0.0; 3]);
    let system = MovingPivot { a: 0.1, omega: 2.0, g: 9.81 };
    let run = at!(system, system.at_time(0.3, 1.1, 0.4), |state, v| ([state.q], [v], [state.p], 0.0));
    follows(run, |[q], [v], _| system.lagrangian(0.3, q, v), [0.0]);
    let system = Growing { a: 0.1 };
    let run = at!(system, system.at_time(0.3, 1.0, 0.5, 0.3), |state, v| ([state.q], [v], [state.p], state.s));
    follows(run, |[q], [v], s| system.lagrangian(0.3, q, v, s), [0.0]);
    let system = Pulled { gamma: 0.2, c: 0.3 };
    let run = at!(system, system.at(1.0, 0.5, 0.3), |state, v| ([state.q], [v], [state.p], state.s));
    follows(run, |[q], [v], s| system.lagrangian(0.0, q, v, s), [-0.3 * 0.5 + 0.5 * 1.0]);
}

/// A pendulum with an action, friction and a force.
#[lagrangian(rayleigh = 0.5 * c * v * v, force = 0.5 * q * q)]
fn pulled(q: f64, v: f64, s: f64, gamma: f64, c: f64) -> f64 {
    0.35 * (1.0 + 0.1 * q * q) * v * v + q.cos() - gamma * s * s
}

/// 2.1.23 to 2.1.25: a charge in a magnetic field that grows has a potential V(q, q', t), and its energy changes by induction.
#[test]
fn a_potential_of_velocities_need_not_be_conservative() -> Result<(), StepError> {
    #[lagrangian]
    fn induced(q: [f64; 2], v: [f64; 2], t: f64, m: f64, rate: f64) -> f64 {
        let field = 1.0 + rate * t;
        0.5 * m * (v[0] * v[0] + v[1] * v[1]) + 0.5 * field * (q[0] * v[1] - q[1] * v[0]) - 0.1 * q[0].powi(4)
    }
    let gained = |rate: f64| {
        let system = Induced { m: 0.7, rate };
        let mut sim = system.integrator(DiscreteGradient, 0.1, system.at([1.0, 0.2], [0.3, 0.6]));
        let energy = sim.energy();
        sim.advance(100).map(|()| sim.energy() - energy)
    };
    let [steady, growing] = [gained(0.0)?, gained(0.3)?];
    assert!(steady.abs() < 1e-13 && growing.abs() > 0.1, "{steady:e} {growing}");
    assert!(Induced::<f64>::REPORT.contains("H depends on time"));
    Ok(())
}

/// The talk's variational integrators: D₁L(q_j, q_{j+1}) + D₂L(q_{j−1}, q_j) = 0. Positions of the midpoint rule satisfy this equation with L(q₀, q₁)
/// = h L((q₀ + q₁)/2, (q₁ − q₀)/h). The momenta are −D₁L and D₂L.
#[test]
fn the_midpoint_rule_is_variational() -> Result<(), StepError> {
    let h = 0.05;
    let discrete = |q0: [f64; 2], q1: [f64; 2]| {
        let (q, v) = ([0, 1].map(|i| 0.5 * (q0[i] + q1[i])), [0, 1].map(|i| (q1[i] - q0[i]) / h));
        h * DOUBLE_PENDULUM.lagrangian(0.0, q, v)
    };
    let mut sim = DOUBLE_PENDULUM.integrator(ImplicitMidpoint, h, DOUBLE_PENDULUM.at([0.0, 1.4], [0.3, 0.0]));
    let mut states = vec![sim.state()];
    for _ in 0..3 {
        sim.step()?;
        states.push(sim.state());
    }
    let moved = |mut q: [f64; 2], i: usize, by: f64| {
        q[i] += by;
        q
    };
    for (before, after) in states.iter().zip(&states[1..]) {
        for i in 0..2 {
            let first = slope(|by| discrete(moved(before.q, i, by), after.q));
            let second = slope(|by| discrete(before.q, moved(after.q, i, by)));
            assert!((before.p[i] + first).abs() < 1e-8 && (after.p[i] - second).abs() < 1e-8);
        }
    }
    Ok(())
}

/// The discrete Lagrangian of the trapezoidal rule gives Störmer and Verlet, also as a recursion of three terms.
#[test]
fn leapfrog_is_variational() -> Result<(), StepError> {
    let (m, g, h) = (0.7, 9.81, 0.1);
    #[lagrangian]
    fn pendulum(q: f64, v: f64, m: f64, g: f64) -> f64 {
        0.5 * m * v * v + m * g * q.cos()
    }
    let system = Pendulum { m, g };
    let mut sim = system.integrator(StormerVerlet, h, system.at(1.1, 0.2));
    let discrete = |q0: f64, q1: f64| {
        let v = (q1 - q0) / h;
        0.5 * h * (system.lagrangian(0.0, q0, v) + system.lagrangian(0.0, q1, v))
    };
    let mut q = [sim.state().q; 3];
    for n in 0..6 {
        let before = sim.state();
        sim.step()?;
        let after = sim.state();
        assert!((before.p + slope(|by| discrete(before.q + by, after.q))).abs() < 1e-8);
        assert!((after.p - slope(|by| discrete(before.q, after.q + by))).abs() < 1e-8);
        q = [q[1], q[2], after.q];
        if n >= 1 {
            let recursion = q[2] - 2.0 * q[1] + q[0] + h * h * g * q[1].sin();
            assert!(recursion.abs() < 1e-14, "{recursion:e}");
        }
    }
    Ok(())
}

/// The talk's discrete Herglotz principle: s₁ − s₀ = h L_d, p₀ = −h D₁/(1 + h D₃), p₁ = h D₂/(1 − h D₄) for L_d in the middle of the step.
#[test]
fn the_contact_midpoint_rule_is_that_of_herglotz() -> Result<(), StepError> {
    let (system, h) = (Growing { a: 0.1 }, 0.1);
    let mut sim = system.integrator(ContactMidpoint, h, system.at(1.0, 0.5, 0.3));
    for _ in 0..5 {
        let before = sim.state();
        sim.step()?;
        let after = sim.state();
        let discrete = |[q0, q1, s0, s1]: [f64; 4]| {
            system.lagrangian(before.t + 0.5 * h, 0.5 * (q0 + q1), (q1 - q0) / h, 0.5 * (s0 + s1))
        };
        let at = [before.q, after.q, before.s, after.s];
        let partial = |i: usize| {
            slope(|by| {
                let mut at = at;
                at[i] += by;
                discrete(at)
            })
        };
        assert!((after.s - before.s - h * discrete(at)).abs() < 1e-14);
        assert!((before.p + h * partial(0) / (1.0 + h * partial(2))).abs() < 1e-8);
        assert!((after.p - h * partial(1) / (1.0 - h * partial(3))).abs() < 1e-8);
    }
    Ok(())
}
