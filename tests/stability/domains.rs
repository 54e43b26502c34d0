//! Domains that are left: functions that were simplified away, edges between the ends of merged steps, signs of parameters. One step at a
//! time comes to the same as all at once.

use geoint_runtime::prelude::*;
use geoint_runtime::system::{ByField, Collocated, DiscreteField};
use geoint_runtime::{Autonomous, Hamiltonian, Method, QuadraticKinetic, Separable};
use geoint_tests::methods::{self, Visitor};

macro_rules! energies {
    ($($name:ident($q:ident, $p:ident, $m:ident) $energy:expr => $System:ident;)*) => { $(
        #[hamiltonian]
        fn $name($q: f64, $p: f64, $m: f64) -> f64 {
            $p * $p / (2.0 * $m) + $energy
        }
    )* };
}

energies! {
    // Simplified away: −q, −q, q, q.
    root_squared(q, p, m) -q.sqrt() * q.sqrt() => RootSquared;
    root_squared_again(q, p, m) -q.sqrt().powi(2) => RootSquaredAgain;
    in_a_branch(q, p, m) if p > 100.0 { 0.0 } else { -q.sqrt() * q.sqrt() } => InABranch;
    behind_the_left_side(q, p, m) if q > 100.0 || q.sqrt() * q.sqrt() > 50.0 { 0.0 } else { -q } => BehindTheLeftSide;
    first_in_a_branch(q, p, m) {
        let guarded = if q > 5.0 { q.sqrt() } else { 0.0 };
        guarded * 0.0 - q.sqrt() * q.sqrt()
    } => FirstInABranch;
    // Still there.
    root(q, p, m) q.sqrt() => Root;
    logarithm(q, p, m) 0.5 * q.ln() => Logarithm;
    logarithm_from_one(q, p, m) (q - 1.0).ln_1p() => LogarithmFromOne;
    arc(q, p, m) (q - 1.0).acos() => Arc;
}

struct Alike<S> {
    name: &'static str,
    system: S,
    refused: u32,
}

impl<S: Hamiltonian<Coordinates = f64>> Visitor<S, f64> for Alike<S> {
    fn visit<M: Method<S> + 'static>(&mut self, method: M) {
        let name = method.name().to_string();
        // From 0.05 with −0.5 the force turns the first back inside of q < 0.
        for (q, p, h) in [(0.05, -0.5, 0.001), (0.05, -0.5, 0.02), (0.4, -1.0, 0.07), (1.0, 0.2, 0.05)] {
            let start = State::new(q, p);
            let mut single = self.system.integrator(method, h, start);
            let outcome = (0..1024).try_for_each(|_| single.step());
            let mut bulk = self.system.integrator(method, h, start);
            let (all, one) = ((bulk.advance(1024), bulk.steps()), (outcome, single.steps()));
            assert_eq!(format!("{all:?}"), format!("{one:?}"), "{}, {name}: h = {h} from {start:?}", self.name);
            // (Implicit methods may have no solution, and projections no way back.)
            self.refused += u32::from(outcome.is_err());
            assert!(single.state().q >= 0.0 && bulk.state().q >= 0.0, "{}, {name}: h = {h} from {start:?}", self.name);
        }
    }
}

fn alike<S: DiscreteField + Autonomous<Coordinates = f64> + Collocated<Stages = ByField>>(
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

/// And of these every table on one system, since the ends of merged steps follow from coefficients; on others one of each kind.
fn split<S: DiscreteField + Autonomous<Coordinates = f64> + Collocated<Stages = ByField>>(
    name: &'static str,
    system: S,
    tables: impl Fn(&mut Alike<S>),
) {
    let mut alike = alike(name, system);
    let before = alike.refused;
    tables(&mut alike);
    assert!(alike.refused > before + 5, "{name}: {}", alike.refused);
}

fn every<S: Autonomous<Coordinates = f64> + Separable + QuadraticKinetic>(alike: &mut Alike<S>) {
    methods::separable(alike);
    methods::nystrom(alike);
}

fn kinds<S: Autonomous<Coordinates = f64> + Separable + QuadraticKinetic>(alike: &mut Alike<S>) {
    methods::kinds_of_separable(alike);
    methods::kinds_of_nystrom(alike);
}

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

/// Whatever the parameters are, no step is taken over what they make of the denominator.
#[test]
fn signs_of_parameters_are_no_belief() {
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
            // Positive ones ask nothing; a negative one makes walls.
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
                let refused = matches!(outcome, Err(StepError::OutsideDomain { .. }));
                assert!(walls || !refused, "{name}: m = {m:?}, h = {h}, {outcome:?}");
            }
            // Through the centre of an ellipse that a negative weight makes a pair of lines.
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

/// A sum of squares is asked for its first one alone where that is positive: bodies that have one coordinate in common, or two, are apart.
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
    assert!(matches!(refused, Err(StepError::OutsideDomain { what, .. }) if what.contains("root")), "{refused:?}");
}
