//! Steps do not leave the domain of the energy: the set where its roots, logarithms and quotients are defined.
//!
//! The tests cover three difficulties. The compiler may simplify the function that bounds the domain. `advance` merges the last flow of a step with
//! the first flow of the next one, so the state between them is not computed. The signs of parameters may decide where the domain ends.

use geoint_runtime::method::implicit::SolvedBy;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::private::{DiscreteField, SolvedByGauss};
use geoint_runtime::{Autonomous, Hamiltonian, Method, QuadraticKinetic, Separable};
use geoint_tests::methods::{self, Visitor};

/// Defines energies H = p²/2m + V(q, p).
macro_rules! energies {
    ($($name:ident($q:ident, $p:ident, $m:ident) $energy:expr => $System:ident;)*) => { $(
        #[hamiltonian]
        fn $name($q: f64, $p: f64, $m: f64) -> f64 {
            $p * $p / (2.0 * $m) + $energy
        }
    )* };
}

energies! {
    // The compiler simplifies √q·√q to q. The energy is still undefined for q < 0.
    root_squared(q, p, m) -q.sqrt() * q.sqrt() => RootSquared;
    root_squared_again(q, p, m) -q.sqrt().powi(2) => RootSquaredAgain;
    in_a_branch(q, p, m) if p > 100.0 { 0.0 } else { -q.sqrt() * q.sqrt() } => InABranch;
    behind_the_left_side(q, p, m) if q > 100.0 || q.sqrt() * q.sqrt() > 50.0 { 0.0 } else { -q } => BehindTheLeftSide;
    first_in_a_branch(q, p, m) {
        let guarded = if q > 5.0 { q.sqrt() } else { 0.0 };
        guarded * 0.0 - q.sqrt() * q.sqrt()
    } => FirstInABranch;
    // V keeps its root, logarithm or arc cosine.
    root(q, p, m) q.sqrt() => Root;
    logarithm(q, p, m) 0.5 * q.ln() => Logarithm;
    logarithm_from_one(q, p, m) (q - 1.0).ln_1p() => LogarithmFromOne;
    arc(q, p, m) (q - 1.0).acos() => Arc;
}

/// Compares `advance(1024)` with 1024 single steps: equal errors at equal steps, and q ≥ 0. Counts the runs that end with an error.
struct Alike<S> {
    name: &'static str,
    system: S,
    refused: u32,
}

impl<S: Hamiltonian<Coordinates = f64>> Visitor<S, f64> for Alike<S> {
    fn visit<M: Method<S> + 'static>(&mut self, method: M) {
        let name = method.name().to_string();
        // From q = 0.05 with p = −0.5 the exact motion of the first system turns back at q < 0, outside of the domain.
        for (q, p, h) in [(0.05, -0.5, 0.001), (0.05, -0.5, 0.02), (0.4, -1.0, 0.07), (1.0, 0.2, 0.05)] {
            let start = State::new(q, p);
            let mut single = self.system.integrator(method, h, start);
            let outcome = (0..1024).try_for_each(|_| single.step());
            let mut bulk = self.system.integrator(method, h, start);
            let (all, one) = ((bulk.advance(1024), bulk.steps()), (outcome, single.steps()));
            assert_eq!(format!("{all:?}"), format!("{one:?}"), "{}, {name}: h = {h} from {start:?}", self.name);
            // Any error counts: an implicit equation or a projection may have no solution near the boundary.
            self.refused += u32::from(outcome.is_err());
            assert!(single.state().q >= 0.0 && bulk.state().q >= 0.0, "{}, {name}: h = {h} from {start:?}", self.name);
        }
    }
}

/// Compares the implicit methods, RK4 and relaxed methods on a system.
fn alike<S: DiscreteField + Autonomous<Coordinates = f64> + SolvedByGauss + SolvedBy<DiscreteGradient>>(
    name: &'static str,
    system: S,
) -> Alike<S> {
    let mut alike = Alike { name, system, refused: 0 };
    alike.visit(RK4);
    alike.visit(ImplicitMidpoint);
    alike.visit(Gauss::<2>);
    alike.visit(DiscreteGradient);
    alike.visit(Gonzalez);
    alike.visit(ItohAbe);
    alike.visit(Suzuki4.of(DiscreteGradient));
    methods::relaxed(&mut alike);
    alike
}

/// Compares the methods of `alike`, and then splitting methods from `tables`. The splitting methods must end at least six runs with an error.
fn split<S: DiscreteField + Autonomous<Coordinates = f64> + SolvedByGauss + SolvedBy<DiscreteGradient>>(
    name: &'static str,
    system: S,
    tables: impl Fn(&mut Alike<S>),
) {
    let mut alike = alike(name, system);
    let before = alike.refused;
    tables(&mut alike);
    assert!(alike.refused > before + 5, "{name}: {}", alike.refused);
}

/// Visits all splitting tables. The points between merged flows depend on the coefficients of the table.
fn every<S: Autonomous<Coordinates = f64> + Separable + QuadraticKinetic>(alike: &mut Alike<S>) {
    methods::separable(alike);
    methods::nystrom(alike);
}

/// One splitting table of each kind.
fn kinds<S: Autonomous<Coordinates = f64> + Separable + QuadraticKinetic>(alike: &mut Alike<S>) {
    methods::kinds_of_separable(alike);
    methods::kinds_of_nystrom(alike);
}

/// `advance` and single steps stop at the same step with the same error. All tables run on one system, one table of each kind on the others.
#[test]
fn batches_and_single_steps_leave_a_domain_alike() {
    split("root_squared", RootSquared { m: 1.3 }, every);
    split("root_squared_again", RootSquaredAgain { m: 1.3 }, kinds);
    assert!(alike("in_a_branch", InABranch { m: 1.3 }).refused > 10);
    split("behind_the_left_side", BehindTheLeftSide { m: 1.3 }, kinds);
    split("first_in_a_branch", FirstInABranch { m: 1.3 }, kinds);
    split("root", Root { m: 1.3 }, kinds);
    split("logarithm", Logarithm { m: 1.3 }, kinds);
    split("logarithm_from_one", LogarithmFromOne { m: 1.3 }, kinds);
    split("arc", Arc { m: 1.3 }, kinds);
}

/// Poles that depend on the signs of parameters.
#[hamiltonian]
fn softened(q: [f64; 2], p: [f64; 2], m: [f64; 2], k: f64, e: f64) -> f64 {
    p[0] * p[0] / (2.0 * m[0]) + p[1] * p[1] / (2.0 * m[1]) - k / (q[0] * q[0] + e * q[1] * q[1] + k * e).sqrt().powi(3)
}

#[hamiltonian]
fn shifted(q: f64, p: f64, m: f64, a: f64) -> f64 {
    p * p / (2.0 * m) + 1.0 / (q * q + a).powi(2)
}

#[hamiltonian]
fn rotor(q: [f64; 2], p: [f64; 2], m: [f64; 2]) -> f64 {
    let s = (q[0] - q[1]).sin();
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * (m[0] + m[1] * s * s)) - q[0].cos() - q[1].cos()
}

/// No step crosses a zero of a denominator, whatever signs the parameters have. A denominator that is positive for usual parameters may vanish for
/// negative ones.
#[test]
fn signs_of_parameters_are_not_assumed() {
    fn check<M: Method<Shifted> + Method<Rotor> + Method<Softened>>(name: &str, method: M) {
        for h in [0.05, 0.1, 0.3, 0.5, 1.0] {
            for (a, inside) in [(-1.0, true), (-1.0, false), (0.0, false), (-1e-3, false), (f64::NAN, false)] {
                let start = if inside { State::new(0.5, 3.0) } else { State::new(2.0, -3.0) };
                let mut sim = Shifted { m: 1.3, a }.integrator(method, h, start);
                let side = |q: f64| (q * q + a > 0.0, q > 0.0 || a != 0.0 && inside);
                while sim.steps() < 100 && sim.step().is_ok() {
                    assert_eq!(side(sim.state().q), side(start.q), "{name}: a = {a}, h = {h}, {:?}", sim.state());
                }
                assert!(!a.is_nan() || sim.steps() == 0, "{name}");
            }
            // With m₀ > 0 and m₁ ≥ 0 the denominator is positive everywhere. With a negative entry it has zeros.
            for (m, walls) in [([1.3, 0.7], false), ([1.3, 0.0], false), ([1.3, -2.0], true), ([-1.3, 2.0], true)] {
                let start = State::new([0.1, 0.2], [0.4, -0.3]);
                let mut sim = Rotor { m }.integrator(method, 0.3 * h, start);
                let inertia = |q: [f64; 2]| m[0] + m[1] * (q[0] - q[1]).sin().powi(2) > 0.0;
                let mut outcome = Ok(());
                while sim.steps() < 200 && outcome.is_ok() {
                    outcome = sim.step();
                    assert_eq!(
                        inertia(sim.state().q),
                        inertia(start.q),
                        "{name}: m = {m:?}, h = {h}, {:?}",
                        sim.state()
                    );
                }
                let refused = matches!(outcome, Err(StepError { failure: Failure::OutsideDomain { .. }, .. }));
                assert!(walls || !refused, "{name}: m = {m:?}, h = {h}, {outcome:?}");
            }
            // The base q₀² + e q₁² + k e is positive for k, e > 0. It vanishes on a line for e = 0, on a hyperbola for e < 0, and on an ellipse for k < 0 < e.
            for (k, e) in [(0.3, 0.5), (0.3, 0.0), (0.3, -0.5), (-0.3, 0.5)] {
                let start = State::new([1.0, 0.2], [-1.0, 0.1]);
                let mut sim = Softened { m: [1.3, 0.7], k, e }.integrator(method, h, start);
                let base = |q: [f64; 2]| q[0] * q[0] + e * q[1] * q[1] + k * e > 0.0;
                while sim.steps() < 60 && sim.step().is_ok() {
                    let q = sim.state().q;
                    assert!(base(q) && (e != 0.0 || q[0] > 0.0), "{name}: k = {k}, e = {e}, h = {h}, {q:?}");
                }
            }
        }
    }
    check("DiscreteGradient", DiscreteGradient);
    check("ImplicitMidpoint", ImplicitMidpoint);
    check("Gauss::<2>", Gauss::<2>);
    check("Gonzalez", Gonzalez);
}

/// Two bodies, and a third one that is softened, in space.
#[hamiltonian]
fn bodies(q: [[f64; 3]; 3], p: [[f64; 3]; 3], m: f64) -> f64 {
    let square = |i: usize, j: usize| {
        let d = [q[i][0] - q[j][0], q[i][1] - q[j][1], q[i][2] - q[j][2]];
        d[0] * d[0] + d[1] * d[1] + d[2] * d[2]
    };
    let mut energy = -1.0 / square(1, 0).sqrt() - 1.0 / (square(2, 0) + 0.01).sqrt();
    for i in 0..3 {
        energy += (p[i][0] * p[i][0] + p[i][1] * p[i][1] + p[i][2] * p[i][2]) / (2.0 * m);
    }
    energy
}

/// A distance is positive if one of its coordinates differs from zero: bodies with one or two equal coordinates are at different places. Only equal
/// positions of the first two bodies are refused. The distance to the third body is softened.
#[test]
fn bodies_in_one_place() {
    let step = |d: [f64; 3]| {
        let rest =
            State::new([[0.5, -2.0, 3.0], [0.5 + d[0], -2.0 + d[1], 3.0 + d[2]], [0.5, -2.0, 3.0]], [[0.0; 3]; 3]);
        Bodies { m: 1.7 }.integrator(PositionVerlet, 1e-9, rest).step()
    };
    for apart in [1.0, -1e-3] {
        for d in [[apart, 0.0, 0.0], [0.0, apart, 0.0], [0.0, 0.0, apart], [apart, apart, 0.0]] {
            assert_eq!(step(d), Ok(()), "{d:?}");
        }
    }
    let refused = step([0.0; 3]);
    assert!(
        matches!(refused, Err(StepError { failure: Failure::OutsideDomain { what }, .. }) if what.contains("root")),
        "{refused:?}"
    );
}
