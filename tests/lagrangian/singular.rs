//! Mass matrices that are singular somewhere. No implicit step leads over such a place, whether the determinant changes its sign or not.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

/// M = q₀ A with a positive A of four rows: its determinant is positive on both sides.
#[lagrangian]
fn even(q: [f64; 4], v: [f64; 4], m: f64) -> f64 {
    let coupled =
        v[0] * v[1] * (q[0] - q[1]).cos() + v[1] * v[2] * (q[1] - q[2]).cos() + v[2] * v[3] * (q[2] - q[3]).cos();
    let squares = v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + v[3] * v[3];
    0.5 * m * q[0] * (squares + 0.4 * coupled) - 0.5 * q[1] * q[1]
}

/// A sum of squares that vanish together where q₀ = 0.
#[lagrangian]
fn squares(q: [f64; 3], v: [f64; 3], m: f64) -> f64 {
    let shifted = v[1] + 0.3 * v[0] * q[2].cos();
    0.5 * m * (q[0] * v[0]).powi(2) + 0.5 * shifted * shifted + 0.7 * (v[2] + 0.2 * v[1] * q[0].sin()).powi(2)
        - 0.5 * q[1] * q[1]
        - 0.5 * q[2] * q[2]
}

/// The same with an action.
#[lagrangian]
fn braked(q: [f64; 3], v: [f64; 3], s: f64, m: f64) -> f64 {
    let shifted = v[1] + 0.3 * v[0] * q[2].cos();
    0.5 * m * (q[0] * v[0]).powi(2) + 0.5 * shifted * shifted + 0.7 * (v[2] + 0.2 * v[1] * q[0].sin()).powi(2)
        - 0.5 * q[1] * q[1]
        - 0.5 * q[2] * q[2]
        - 0.01 * s
}

/// p = v³ − av has no inertia at v = ±√(a/3): rest is between.
#[lagrangian]
fn crystal(q: f64, v: f64, a: f64) -> f64 {
    0.25 * v.powi(4) - 0.5 * a * v * v - 0.5 * q * q
}

/// Returns whether steps reach a state with `crossed`. A refusal should come before.
fn leads_over<S: PhaseSpace, M: Method<S>>(
    (system, method, start): (S, M, S::State),
    h: f64,
    crossed: impl Fn(&S::State) -> bool,
) -> bool
where
    S::State: Copy + PartialEq + std::fmt::Debug,
{
    let mut sim = Integrator::new(system, method, h, start);
    for _ in 0..(5.0 / h) as usize {
        let before = sim.state();
        if let Err(error) = sim.step() {
            assert_eq!(sim.state(), before);
            assert!(!matches!(error, StepError { failure: Failure::NonFinite, .. }), "{error}");
            return false;
        }
        if crossed(&sim.state()) {
            return true;
        }
    }
    false
}

macro_rules! stay {
    ($system:expr, $start:expr, $crossed:expr, $($method:expr),*) => { $(
        for h in [0.01, 0.037, 0.1, 0.3, 1.0] {
            assert!(!leads_over(($system, $method, $start), h, $crossed), "{} by {h}", stringify!($method));
        }
    )* };
}

#[test]
fn no_step_leads_over_an_even_zero_of_the_determinant() {
    let system = Even { m: 0.7 };
    let start = system.at([0.5, 0.2, -0.1, 0.3], [-1.5, 0.3, 0.2, 0.0]);
    stay!(system, start, |state: &State<[f64; 4]>| state.q[0] <= 0.0, ImplicitMidpoint, Gauss::<2>, DiscreteGradient);
    let system = Squares { m: 0.7 };
    let start = system.at([0.5, 0.2, -0.1], [-1.5, 0.3, 0.2]);
    stay!(system, start, |state: &State<[f64; 3]>| state.q[0] <= 0.0, ImplicitMidpoint, Gauss::<2>, DiscreteGradient);
}

#[test]
fn nor_with_an_action() {
    let system = Braked { m: 0.7 };
    let start = system.at([0.5, 0.2, -0.1], [-1.5, 0.3, 0.2], 0.0);
    let crossed = |state: &ContactState<[f64; 3]>| state.q[0] <= 0.0;
    stay!(system, start, crossed, ContactMidpoint, ContactGauss::<2>, ContactDiscreteGradient);
}

/// From rest: with −a for its mass v grows towards √(a/3), where it would have to jump.
#[test]
fn no_step_leads_over_a_velocity_without_inertia() {
    let system = Crystal { a: 0.8 };
    let start = system.at(1.0, 0.0);
    let crossed = |state: &State<f64>| system.velocity(state).abs() > (0.8_f64 / 3.0).sqrt();
    stay!(system, start, crossed, ImplicitMidpoint, Gauss::<2>, Gauss::<3>);
}

/// A body falls through a horizon, where a pivot of the mass matrix vanishes, but not its determinant.
#[test]
fn a_regular_mass_matrix_may_have_no_regular_pivot() -> Result<(), StepError> {
    #[lagrangian]
    fn falling(q: [f64; 3], v: [f64; 3], m: f64) -> f64 {
        let r = q[1];
        0.5 * (-(1.0 - 2.0 * m / r) * v[0] * v[0] + 2.0 * v[0] * v[1] + r * r * v[2] * v[2])
    }
    let system = Falling { m: 1.0 };
    let start = system.at([0.0, 3.0, 0.0], [1.2, -0.4, 0.05]);
    let mut fine = system.integrator(Gauss::<4>, 0.01, start);
    fine.advance(240)?;
    let exact = fine.state().q;
    assert!(exact[1] < 1.8, "{exact:?}");
    macro_rules! falls {
        ($($method:expr => $error:literal),*) => { $(
            let mut sim = system.integrator($method, 0.02, start);
            let energy = sim.energy();
            sim.advance(120)?;
            let error = (0..3).fold(0.0, |error, i| f64::max(error, (sim.state().q[i] - exact[i]).abs()));
            assert!(error < $error, "{}: {error:e}", stringify!($method));
            assert!((sim.energy() - energy).abs() < $error);
            assert!((sim.state().p[0] - start.p[0]).abs() < 1e-13);
        )* };
    }
    falls!(ImplicitMidpoint => 1e-2, Gauss::<2> => 1e-5, Gauss::<3> => 1e-8);
    let mut sim = system.integrator(DiscreteGradient, 0.02, start);
    let energy = sim.energy();
    sim.advance(120)?;
    assert!((sim.energy() - energy).abs() < 1e-13);
    Ok(())
}

/// The mass jumps at a wall. Its slope vanishes on both sides, but the mass is not constant.
#[test]
fn masses_may_jump() -> Result<(), StepError> {
    #[lagrangian]
    fn stepped(q: f64, v: f64, m: f64) -> f64 {
        (if q > 0.0 { m } else { 2.0 * m }) * v * v / 2.0 - 0.1 * q
    }
    #[hamiltonian]
    fn by_hand(q: f64, p: f64, m: f64) -> f64 {
        p * p / (2.0 * if q > 0.0 { m } else { 2.0 * m }) + 0.1 * q
    }
    let start = Stepped { m: 0.7 }.at(0.3, -0.7);
    let mut sim = Stepped { m: 0.7 }.integrator(DiscreteGradient, 0.05, start);
    let mut other = ByHand { m: 0.7 }.integrator(DiscreteGradient, 0.05, start);
    sim.advance(40)?;
    other.advance(40)?;
    assert!(sim.state().q < -0.5 && (sim.state().q - other.state().q).abs() < 1e-14, "{:?}", sim.state());

    // Where steps are solved for velocities.
    #[lagrangian]
    fn coupled(q: [f64; 3], v: [f64; 3], m: f64) -> f64 {
        let m = if q[0] > 0.0 { m } else { 2.0 * m };
        let squares = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        let both = v[0] * v[1] * (q[0] - q[1]).cos() + v[1] * v[2] * (q[2] - q[1]).cos();
        0.5 * m * squares + 0.2 * both + q[0].cos()
    }
    let system = Coupled { m: 0.7 };
    let mut sim = system.integrator(DiscreteGradient, 0.05, system.at([0.3, 0.1, 0.2], [-0.5, 0.1, 0.3]));
    let energy = sim.energy();
    let mut sides = [false; 2];
    for _ in 0..100 {
        sim.step()?;
        assert!((sim.energy() - energy).abs() < 1e-13);
        sides[usize::from(sim.state().q[0] > 0.0)] = true;
    }
    assert_eq!(sides, [true; 2]);
    Ok(())
}

/// Masses that vanish at a time, with or without a change of sign.
#[test]
fn no_step_leads_over_a_time_without_inertia() {
    #[lagrangian]
    fn leaking(q: f64, v: f64, t: f64, m: f64) -> f64 {
        (m - t) * v * v - 0.5 * q * q
    }
    #[lagrangian]
    fn pulsing(q: [f64; 3], v: [f64; 3], t: f64, m: f64) -> f64 {
        let both = v[0] * v[1] * (q[0] - q[1]).cos() + v[1] * v[2] * (q[2] - q[1]).cos();
        (m - t).powi(2) * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + 0.3 * both) - 0.5 * q[0] * q[0]
    }
    let (one, three) = (Leaking { m: 1.01 }, Pulsing { m: 1.01 });
    let start = one.at(0.3, 0.5);
    stay!(one, start, |state: &State<f64>| state.t > 1.01, ImplicitMidpoint, Gauss::<2>, DiscreteGradient);
    let start = three.at([0.3, 0.1, 0.2], [0.5, 0.1, 0.3]);
    stay!(three, start, |state: &State<[f64; 3]>| state.t > 1.01, ImplicitMidpoint, Gauss::<2>, DiscreteGradient);
}

/// Masses of both signs: the determinant is negative all along.
#[test]
fn velocities_may_have_masses_of_both_signs() -> Result<(), StepError> {
    #[lagrangian]
    fn mixed(q: [f64; 3], v: [f64; 3], m: f64) -> f64 {
        let turned = v[2] + 0.3 * v[0] * q[1].cos();
        m * v[0] * v[1] + 0.5 * turned * turned - q[0] * q[1] - 0.5 * q[2] * q[2]
    }
    #[hamiltonian]
    fn by_hand(q: [f64; 3], p: [f64; 3], m: f64) -> f64 {
        p[1] * (p[0] - 0.3 * q[1].cos() * p[2]) / m + 0.5 * p[2] * p[2] + q[0] * q[1] + 0.5 * q[2] * q[2]
    }
    let system = Mixed { m: 0.7 };
    assert!(Mixed::<f64>::REPORT.contains("steps are solved for v"));
    let start = system.at([0.3, 0.2, -0.1], [-0.4, 0.5, 0.3]);
    macro_rules! same {
        ($($method:expr),*) => { $(
            let mut one = system.integrator($method, 0.05, start);
            let mut other = ByHand { m: 0.7 }.integrator($method, 0.05, start);
            one.advance(40)?;
            other.advance(40)?;
            let far = (0..3).fold(0.0, |far, i| f64::max(far, (one.state().q[i] - other.state().q[i]).abs()));
            assert!(far < 1e-12, "{far:e}");
        )* };
    }
    same!(ImplicitMidpoint, Gauss::<2>, Gauss::<3>);
    let mut sim = system.integrator(DiscreteGradient, 0.05, start);
    let energy = sim.energy();
    sim.advance(40)?;
    assert!((sim.energy() - energy).abs() < 1e-13);
    Ok(())
}

/// s falls to the pole of 1/s before t = 0.25. Stages of longer steps come to lie behind it, from where s grows again.
#[test]
fn no_stage_is_behind_a_pole_of_the_action() {
    #[lagrangian]
    fn falling(q: f64, v: f64, s: f64) -> f64 {
        0.5 * v * v - 0.5 * q * q - 1.0 / s - 2.0
    }
    #[lagrangian]
    fn falling_together(q: [f64; 3], v: [f64; 3], s: f64) -> f64 {
        let [u, w] = [v[0] + 0.2 * v[1] * q[2].cos(), v[1] + 0.3 * v[2] * q[1].sin()];
        0.5 * (u * u + w * w + v[2] * v[2]) - 0.5 * (q[0] * q[0] + q[1] * q[1] + q[2] * q[2]) - 1.0 / s - 2.0
    }
    #[contact_hamiltonian]
    fn rising(q: f64, p: f64, s: f64) -> f64 {
        0.5 * p * p + 0.5 * q * q + 1.0 / s + 2.0
    }
    let start = Falling.at(0.5, 0.2, 1.0);
    stay!(Falling, start, |state: &ContactState<f64>| state.t > 0.25, ContactGauss::<2>, ContactGauss::<3>);
    stay!(Rising, start, |state: &ContactState<f64>| state.t > 0.25, ContactGauss::<2>, ContactGauss::<3>);
    let start = FallingTogether.at([0.5; 3], [0.2; 3], 1.0);
    for h in [0.17, 0.2, 0.25] {
        let crossed = |state: &ContactState<[f64; 3]>| state.t > 0.26;
        assert!(!leads_over((FallingTogether, ContactGauss::<3>, start), h, crossed), "{h}");
    }
}

/// A wall 1/q repels a particle in long steps, in all forms of the stages. No stage lies behind the wall, because the end would be thrown off from there.
#[test]
fn no_stage_is_behind_a_wall() {
    #[hamiltonian]
    fn wall(q: f64, p: f64) -> f64 {
        0.5 * p * p + 1.0 / q
    }
    #[lagrangian]
    fn in_phase_space(q: [f64; 2], v: [f64; 2]) -> f64 {
        q[1] * v[0] - 0.5 * q[1] * q[1] - 1.0 / q[0]
    }
    #[lagrangian]
    fn together(q: [f64; 3], v: [f64; 3]) -> f64 {
        let [u, w] = [v[0] + 0.2 * v[1] * q[2].cos(), v[1] + 0.3 * v[2] * q[1].sin()];
        0.5 * (u * u + w * w + v[2] * v[2]) - 1.0 / q[0]
    }
    /// Steps that are taken, at most 40.
    fn taken<S: PhaseSpace, M: Method<S>>(system: S, method: M, h: f64, start: S::State) -> u64 {
        let mut sim = Integrator::new(system, method, h, start);
        let outcome = sim.advance(40);
        assert!(
            outcome.is_ok() || matches!(outcome, Err(StepError { failure: Failure::OutsideDomain { .. }, .. })),
            "{outcome:?}"
        );
        sim.steps()
    }
    let start = State::new(1.0, -10.0);
    assert!(taken(Wall, Gauss::<2>, 0.05, start) < 40);
    // The solution that is continuous in h comes back from the wall: 1/q at the stages turns p round.
    let mut sim = Integrator::new(InPhaseSpace, Gauss::<2>, 0.05, InPhaseSpace.at([1.0, -10.0]));
    for _ in 0..40 {
        sim.step().unwrap();
        let [q, p] = sim.state().x;
        assert!(q > 0.0 && p.abs() < 15.0, "q = {q}, p = {p}");
    }
    assert!(sim.state().x[1] > 0.0);
    let start = Together.at([1.0, 0.2, 0.1], [-3.0, 0.0, 0.0]);
    // In a long step, the iteration starts far from the solution. The step still turns the momentum round, with the error of the method.
    let mut sim = Integrator::new(Together, Gauss::<3>, 2.0, start);
    let energy = sim.energy();
    sim.step().unwrap();
    assert!(sim.state().q[0] > 3.0 && sim.state().p[0] > 2.8, "{:?}", sim.state());
    assert!((sim.energy() - energy).abs() < 0.4, "{}", sim.energy() - energy);
    // With shorter steps all come back.
    assert_eq!(taken(Wall, Gauss::<2>, 0.005, State::new(1.0, -3.0)), 40);
    assert_eq!(taken(Together, Gauss::<3>, 0.02, start), 40);
}

/// q₁²v₀ − H is of first order, with Ω = −2q₁.
#[test]
fn no_step_leads_over_a_singular_form() {
    #[lagrangian]
    fn fold(q: [f64; 2], v: [f64; 2]) -> f64 {
        q[1] * q[1] * v[0] - 0.5 * q[0] * q[0] - q[1]
    }
    let start = Fold.at([-1.0, 0.5]);
    stay!(Fold, start, |state: &FlowState<[f64; 2]>| state.x[1] <= 0.0, ImplicitMidpoint, Gauss::<2>, DiscreteGradient);
    let mut sim = Fold.integrator(Gauss::<2>, 0.5, start);
    assert!((0..20).any(|_| sim.step().is_err()));
    assert!(sim.state().x[1] > 0.0);
    // If the form is singular at the start, the error names the division by zero.
    macro_rules! named {
        ($($method:expr),*) => { $(
            let text = Fold.integrator($method, 0.1, Fold.at([-1.0, 0.0])).step().expect_err("singular").to_string();
            assert!(text.contains("division by zero: q[1]"), "{}: {text}", stringify!($method));
        )* };
    }
    named!(ImplicitMidpoint, Gauss::<2>, DiscreteGradient, RK4);
}
