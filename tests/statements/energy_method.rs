//! T37 and T38: the energy method of the thesis for M d'' + K(d) = F(t) with several d, equations (3.1.1) to (3.1.6), and the balance (3.1.7).
//!
//! The scheme is written here as it is printed. The library has no such method, because the quotient κ is 0/0 where U is extremal along the orbit.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_tests::scalars::Dual;

/// The masses of the scheme, with the inverse of M = [[2, 0.3], [0.3, 1]] as a quadratic form, and forces that depend on time.
#[hamiltonian]
fn pushed(q: [f64; 2], p: [f64; 2], t: f64, strength: f64) -> f64 {
    let kinetic = (p[0] * p[0] - 0.6 * p[0] * p[1] + 2.0 * p[1] * p[1]) / 3.82;
    let spring = (q[0] * q[0] + q[1] * q[1]) / 2.0 + q[0] * q[0] * q[1] * q[1] / 2.0 + q[1].powi(4) / 4.0;
    kinetic + spring - strength * (0.4 * (1.3 * t).sin() * q[0] + 0.2 * (2.0 * t).cos() * q[1])
}

const START: Motion = Motion { d: [0.9, 0.4], v: [-0.2, 0.7] };

/// Positions d and velocities v.
#[derive(Clone, Copy, Debug)]
struct Motion {
    d: [f64; 2],
    v: [f64; 2],
}

fn times_mass(v: [Dual; 2]) -> [Dual; 2] {
    [v[0] * 2.0 + v[1] * 0.3, v[0] * 0.3 + v[1]]
}

fn potential(d: [Dual; 2]) -> Dual {
    (d[0] * d[0] + d[1] * d[1]) / 2.0 + d[0] * d[0] * d[1] * d[1] / 2.0 + d[1].powi(4) / 4.0
}

/// K = ∂U/∂d.
fn stiffness(d: [Dual; 2]) -> [Dual; 2] {
    [d[0] + d[0] * d[1] * d[1], d[1] + d[0] * d[0] * d[1] + d[1].powi(3)]
}

fn force(t: f64) -> [f64; 2] {
    [0.4 * (1.3 * t).sin(), 0.2 * (2.0 * t).cos()]
}

fn mean(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [0, 1].map(|i| (a[i] + b[i]) / 2.0)
}

impl Motion {
    /// T + U.
    fn energy(&self) -> f64 {
        let (d, v) = (self.d.map(Dual::from), self.v.map(Dual::from));
        let momentum = times_mass(v);
        ((v[0] * momentum[0] + v[1] * momentum[1]) / 2.0 + potential(d)).value()
    }

    /// Takes a step of the scheme under a constant force, by Newton's iteration for v₁. Returns `None` if the iteration ends far from a solution.
    ///
    /// d₁ − d₀ = h (v₀ + v₁)/2, M(v₁ − v₀) + hκk = hF, k = (K₀ + K₁)/2, κ = (U₁ − U₀)/((d₁ − d₀)·k).
    fn step(&self, h: f64, force: [f64; 2]) -> Option<Motion> {
        let (d0, v0) = (self.d.map(Dual::from), self.v.map(Dual::from));
        let position = |v: [Dual; 2]| [0, 1].map(|i| d0[i] + (v0[i] + v[i]) * (h / 2.0));
        let residual = |v: [Dual; 2]| {
            let d = position(v);
            let (first, last) = (stiffness(d0), stiffness(d));
            let k = [0, 1].map(|i| (first[i] + last[i]) / 2.0);
            let work = (d[0] - d0[0]) * k[0] + (d[1] - d0[1]) * k[1];
            let quotient = (potential(d) - potential(d0)) / work;
            let gained = times_mass([v[0] - v0[0], v[1] - v0[1]]);
            [0, 1].map(|i| gained[i] + quotient * k[i] * h - h * force[i])
        };
        let (mut v, mut before) = (self.v, f64::INFINITY);
        for _ in 0..40 {
            let at = v.map(Dual::from);
            let [f, g] = residual(at).map(Dual::value);
            let [a, b] = residual([Dual::variable(v[0]), at[1]]).map(Dual::derivative);
            let [c, e] = residual([at[0], Dual::variable(v[1])]).map(Dual::derivative);
            let correction = [(e * f - c * g) / (a * e - b * c), (a * g - b * f) / (a * e - b * c)];
            v = [v[0] - correction[0], v[1] - correction[1]];
            let size = correction[0].abs().max(correction[1].abs());
            if size >= before && size < 1e-12 {
                return Some(Motion { d: position(v.map(Dual::from)).map(Dual::value), v });
            }
            before = size;
        }
        None
    }
}

#[test]
fn the_scheme_has_the_printed_balance_of_energy() {
    let expected = [-1.023_585_97, 0.591_713_37, 0.123_291_11, 0.144_607_81];
    for (h, noted) in [(0.1_f64, 2.00e-2), (0.05, 5.12e-3), (0.025, 1.23e-3)] {
        let steps = (5.0 / h).round() as i32;
        let (mut now, mut worst) = (START, 0.0_f64);
        for n in 0..steps {
            let [t0, t1] = [n, n + 1].map(|n| f64::from(n) * h);
            let force = mean(force(t0), force(t1));
            let next = now.step(h, force).expect("a step");
            let work: f64 = (0..2).map(|i| (next.d[i] - now.d[i]) * force[i]).sum();
            worst = worst.max((next.energy() - now.energy() - work).abs());
            now = next;
        }
        // The identity (3.1.7) with the mean of F at both ends, as printed.
        assert!(worst < 1e-15, "h = {h}: {worst:e}");
        let error = [now.d, now.v].concat().iter().zip(expected).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
        assert!((error / noted - 1.0).abs() < 5e-3, "h = {h}: {error:e}");
    }
}

/// The energy without the work of the force.
fn kept(state: &State<[f64; 2]>) -> f64 {
    Pushed { strength: 0.0 }.energy(state)
}

/// M v.
fn momenta(v: [f64; 2]) -> [f64; 2] {
    times_mass(v.map(Dual::from)).map(Dual::value)
}

/// The library's steps solve the same equations. Control: `DiscreteGradient` takes F in the middle of a step, so the printed balance is off by h²F''/8.
#[test]
fn the_discrete_gradient_has_another_balance() -> Result<(), StepError> {
    let (system, h) = (Pushed { strength: 1.0 }, 0.1);
    let start = State::new(START.d, momenta(START.v));
    let mut exact = system.integrator(Gauss::<6>, 0.05, start);
    exact.advance(100)?;
    let end = exact.state();
    let momenta = momenta([0.123_291_11, 0.144_607_81]);
    for (found, expected) in end.q.iter().chain(&end.p).zip([-1.023_585_97, 0.591_713_37, momenta[0], momenta[1]]) {
        assert!((found - expected).abs() < 1.5e-8, "{found} {expected}");
    }
    let mut sim = system.integrator(DiscreteGradient, h, start);
    let (mut printed, mut middle) = (0.0_f64, 0.0_f64);
    for _ in 0..50 {
        let before = sim.state();
        sim.step()?;
        let after = sim.state();
        let work = |force: [f64; 2]| (0..2).map(|i| (after.q[i] - before.q[i]) * force[i]).sum::<f64>();
        let gained = kept(&after) - kept(&before);
        printed = printed.max((gained - work(mean(force(before.t), force(after.t)))).abs());
        middle = middle.max((gained - work(force(before.t + h / 2.0))).abs());
    }
    assert!(middle < 3e-15 && printed > 1e-5, "{middle:e} {printed:e}");
    Ok(())
}

/// Without a force the scheme finds no step at about t = 10.6 (h = 0.1) and 52.4 (h = 0.02), where κ is close to 0/0. The discrete gradient goes on.
#[test]
fn the_quotient_ends_runs_with_several_coordinates() -> Result<(), StepError> {
    for (h, noted) in [(0.1, 10.6), (0.02, 52.4)] {
        let mut now = START;
        let mut steps = 0;
        while let Some(next) = now.step(h, [0.0; 2]) {
            now = next;
            steps += 1;
            assert!(f64::from(steps) * h < 200.0, "the scheme goes on");
        }
        assert!((f64::from(steps) * h - noted).abs() < 0.05, "h = {h}: no step at t = {}", f64::from(steps) * h);
    }
    let mut sim = Pushed { strength: 0.0 }.integrator(DiscreteGradient, 0.1, State::new(START.d, momenta(START.v)));
    let energy = sim.energy();
    sim.advance(2000)?;
    assert!((sim.energy() - energy).abs() < 1e-13, "{:e}", sim.energy() - energy);
    Ok(())
}
