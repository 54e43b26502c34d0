//! Damped systems: in every step the energy falls by exactly the dissipated energy, for any step size. Damping that feeds energy is refused.

mod scenes;

use geoint_runtime::method::implicit::SolvedBy;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::private::{DiscreteField, Inverse, SolvedByGauss};
use geoint_runtime::{Conservative, Separable};
use geoint_tests::measure::{distance, extrapolated, observed_order};
use geoint_tests::problems::{flat, state};
use geoint_tests::scalars::Double;
use scenes::*;
use std::marker::PhantomData;

/// A damped system written by hand: velocity, force and damping coefficients at a point.
type ByHand<R> = (Vec<R>, Vec<R>, Vec<Vec<R>>);

/// Returns the largest h·v·Cv + H₁ − H₀ of a run, relative to the energy at the start. Here v = (q₁ − q₀)/h, which equals ∇̄_pH by the first half of the
/// step. C is evaluated at the mean of both ends. Every step must dissipate energy.
fn imbalance<D: Damped>(h: f64, steps: u64) -> f64 {
    let (system, (q, p)) = (D::system::<f64>(), D::START);
    let mut sim = system.integrator(DiscreteGradient, h, state::<D::Over<f64>, f64>(0.4, q, p));
    let start = sim.energy();
    let mut largest = 0.0_f64;
    for _ in 0..steps {
        let (t, before, energy) = (sim.time(), flat(&sim.state()), sim.energy());
        sim.step().unwrap_or_else(|error| panic!("h = {h}: {error}"));
        let after = flat(&sim.state());
        let mean: Vec<f64> = before.iter().zip(&after).map(|(a, b)| (a + b) / 2.0).collect();
        let (q, p) = mean.split_at(q.len());
        let (_, _, c) = D::by_hand(t + h / 2.0, q, p);
        let v: Vec<f64> = before.iter().zip(&after).take(q.len()).map(|(a, b)| (b - a) / h).collect();
        let lost: f64 = (0..v.len()).map(|i| (0..v.len()).map(|j| v[i] * c[i][j] * v[j]).sum::<f64>()).sum();
        let rounding = 1e-15 * start;
        assert!(sim.energy() <= energy + rounding, "h = {h}: {} after {energy}", sim.energy());
        largest = largest.max((sim.energy() - energy + h * lost).abs() / start);
    }
    assert!(sim.energy() < 0.9 * start, "h = {h}: {} of {start} is left", sim.energy());
    largest
}

#[test]
fn energy_falls_by_what_is_dissipated() {
    fn check<D: Damped>(name: &str, sizes: &[f64]) {
        for h in sizes {
            let imbalance = imbalance::<D>(*h, 400);
            println!("{name}: h = {h}: imbalance {imbalance:.1e}");
            assert!(imbalance <= 2e-15, "{name}: h = {h}: {imbalance:.1e}");
        }
    }
    check::<Duffing>("Duffing", &[0.1, 1.0, 3.0, 10.0]);
    check::<Medium>("Medium", &[0.1, 0.3, 1.0, 3.0]);
    check::<Swing>("Swing", &[0.1, 0.3, 1.0, 3.0]);
}

/// Returns the order of a method in double-double arithmetic, measured against the equation written by hand.
fn order<D: Damped, M: Method<D::Over<Double>, Double>>(method: M) -> f64 {
    let (from, duration, (q, p)) = (0.4, 2.3, D::START);
    let n = q.len();
    let field = |t: Double, y: &[Double]| {
        let (q, p) = y.split_at(n);
        let (v, force, c) = D::by_hand(t, q, p);
        let drag = |i: usize| (0..n).fold(Double::from(0.0), |sum, j| sum + c[i][j] * v[j]);
        v.iter().copied().chain((0..n).map(|i| force[i] - drag(i))).collect::<Vec<_>>()
    };
    let start = state::<D::Over<Double>, Double>(from, q, p);
    let exact = extrapolated(field, from.into(), flat(&start), duration.into(), 40);
    observed_order(|n| {
        let mut sim = D::system::<Double>().integrator(method, Double::from(duration) / n as f64, start);
        sim.advance(n).map_or(f64::INFINITY, |()| distance(&flat(&sim.state()), &exact))
    })
}

#[test]
fn orders_are_those_without_damping() {
    fn check<D: Damped>(name: &str)
    where
        ExplicitEuler: Method<D::Over<Double>, Double>,
    {
        let observed = [
            ("ExplicitEuler", 1.0, order::<D, _>(ExplicitEuler)),
            ("ImplicitMidpoint", 2.0, order::<D, _>(ImplicitMidpoint)),
            ("DiscreteGradient", 2.0, order::<D, _>(DiscreteGradient)),
            ("Gauss::<2>", 4.0, order::<D, _>(Gauss::<2>)),
            ("Gauss::<4>", 8.0, order::<D, _>(Gauss::<4>)),
            ("Suzuki4.of(DiscreteGradient)", 4.0, order::<D, _>(Suzuki4.of(DiscreteGradient))),
        ];
        for (method, expected, observed) in observed {
            println!("{name}: {method} {observed:.3}");
            assert!((observed - expected).abs() <= 0.15, "{name}: {method}: {observed:.3}");
        }
    }
    check::<Duffing>("Duffing");
    check::<Medium>("Medium");
    check::<Swing>("Swing");
}

/// Damping of differences does not change the sum of the momenta. Its matrix is singular on paper, and is not refused.
#[test]
fn relative_damping_keeps_total_momentum() {
    let system = ShockAbsorber { m: [1.3, 0.7], c: 0.3 };
    let mut sim = system.integrator(DiscreteGradient, 0.2, State::new([0.0, 1.0], [0.4, -0.1]));
    let rest = 0.3 * 0.3 / (2.0 * 2.0);
    for state in sim.sampled(1).take(500) {
        let state = state.unwrap();
        assert!((state.p[0] + state.p[1] - 0.3).abs() < 1e-14);
    }
    // The remaining energy belongs to the common motion.
    assert!((sim.energy() - rest).abs() < 1e-8, "{}", sim.energy());
}

/// A linear system needs no Newton iteration. Its step equals the step of the implicit midpoint rule.
#[test]
fn linear_systems_are_solved_at_once() {
    const { assert!(<<Oscillator as DiscreteField>::Inverse as Inverse<[[f64; 2]; 2]>>::EXISTS) };
    const { assert!(!<<VanDerPol as DiscreteField>::Inverse as Inverse<[[f64; 1]; 2]>>::EXISTS) };
    const { assert!(!<<Duffing as DiscreteField>::Inverse as Inverse<[[f64; 1]; 2]>>::EXISTS) };
    let system = Oscillator { m: [1.3, 0.7], k: [0.9, 1.6], c: [0.2, 0.0] };
    let start = State::new([0.4, -0.6], [0.3, 0.8]);
    let mut sim = system.integrator(DiscreteGradient, 0.7, start);
    let mut other = system.integrator(ImplicitMidpoint, 0.7, start);
    sim.advance(50).unwrap();
    other.advance(50).unwrap();
    assert!(distance(&flat(&sim.state()), &flat(&other.state())) < 1e-13);
    // (1 + hc/2m) p₁ = (1 − hc/2m) p₀ − hk (q₀ + q₁)/2 and q₁ = q₀ + h (p₀ + p₁)/2m by hand.
    let [mut q, mut p, m, k, c, h] = [0.4, 0.3, 1.3, 0.9, 0.2, 0.7_f64];
    for _ in 0..50 {
        let next = (p * (1.0 - h * c / (2.0 * m) - h * h * k / (4.0 * m)) - h * k * q)
            / (1.0 + h * c / (2.0 * m) + h * h * k / (4.0 * m));
        (q, p) = (q + h * (p + next) / (2.0 * m), next);
    }
    assert!((q - sim.state().q[0]).abs() + (p - sim.state().p[0]).abs() < 1e-13);
}

#[test]
fn parameters_that_feed_energy_are_refused() {
    fn check<S: DiscreteField<f64> + Hamiltonian<f64> + SolvedByGauss + SolvedBy<DiscreteGradient>>(
        system: S,
        start: State<S::Coordinates>,
        reason: &str,
    ) where
        S::Coordinates: PartialEq,
    {
        let refused = |error: StepError| matches!(error, StepError { failure: Failure::OutsideDomain { what }, .. } if what == reason);
        let mut sim = system.integrator(DiscreteGradient, 0.1, start);
        assert!(refused(sim.advance(10).unwrap_err()), "{reason}");
        assert_eq!(sim.state(), start);
        assert!(refused(system.integrator(Gauss::<2>, 0.1, start).step().unwrap_err()), "{reason}");
    }
    check(Duffing { m: 1.3, k: 0.8, c: -1e-9 }, State::new(0.5, 0.2), "damping that is negative: c");
    let swing = |a, b, d| Swing { m: [1.4, 0.7], a, b, d };
    let start = State::new([0.5, 0.2], [0.0, 0.1]);
    check(swing(-0.1, 0.0, 0.1), start, "damping that is negative: a");
    check(swing(0.1, 0.2001, 0.4), start, "damping that is not positive semidefinite");
    swing(0.1, 0.2, 0.4).integrator(DiscreteGradient, 0.1, start).advance(10).unwrap();
    check(ShockAbsorber { m: [1.3, 0.7], c: -0.1 }, start, "damping that is negative: c");
}

/// If damping becomes negative on the way, the run ends and keeps the last good state.
#[test]
fn damping_that_feeds_energy_on_the_way() {
    fn check<S: Hamiltonian<f64>, M: Method<S, f64>>(start: Integrator<S, M>, reason: &str, good: fn(&[f64]) -> bool)
    where
        S::Coordinates: PartialEq + std::fmt::Debug,
    {
        let (mut sim, name) = (start.clone(), std::any::type_name::<M>());
        let mut energy = sim.energy();
        let error = loop {
            match sim.step() {
                Ok(()) => assert!(sim.energy() <= energy && good(&flat(&sim.state())), "{name}: {:?}", sim.state()),
                Err(error) => break error,
            }
            energy = sim.energy();
            assert!(sim.steps() < 100, "{name}");
        };
        assert!(sim.steps() > 10, "{name}: {:?}", sim.state());
        assert!(error.to_string().contains(reason), "{name}: {error}");
        // A longer run does not cross into the region behind, where the sign is right again.
        for n in sim.steps() + 1..400 {
            let mut through = start.clone();
            assert_eq!(through.advance(n), Err(error), "{name}: {n} steps");
            assert_eq!(through.state(), sim.state(), "{name}: {n} steps");
        }
    }
    let (system, start) = (VanDerPol { m: 1.3, c: 0.4 }, State::new(1.8, 0.2));
    let negative = "damping that is negative: c·(q² - 1)";
    check(system.integrator(DiscreteGradient, 0.05, start), negative, |x| x[0] >= 1.0);
    check(system.integrator(ImplicitMidpoint, 0.05, start), negative, |x| x[0] >= 1.0);
    check(system.integrator(Gauss::<3>, 0.05, start), negative, |x| x[0] >= 1.0);
    let (system, start) = (Twist { m: [1.3, 0.7], c: 0.2 }, State::new([0.2, 0.1], [1.7, 0.0]));
    let indefinite = "damping that is not positive semidefinite";
    check(system.integrator(DiscreteGradient, 0.05, start), indefinite, |x| x[0].abs() <= 1.0);
    check(system.integrator(Gauss::<3>, 0.05, start), indefinite, |x| x[0].abs() <= 1.0);
}

/// Decides at compile time whether a system has a property. The inherent constant, if it exists, hides the constant of the trait.
struct Has<S>(PhantomData<S>);

trait Lacks {
    const FLOWS: bool = false;
    const CONSERVATIVE: bool = false;
}

impl<S> Lacks for Has<S> {}

impl<S: Separable> Has<S> {
    const FLOWS: bool = true;
}

impl<S: Conservative> Has<S> {
    const CONSERVATIVE: bool = true;
}

/// All coefficients are zero: nothing is damped.
#[hamiltonian(damping = [0.0, 0.0])]
fn free(q: [f64; 2], p: [f64; 2], m: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) + q[0].powi(4)
}

/// A central force with friction in one direction.
#[hamiltonian(damping = [c, 0.0])]
fn turntable(q: [f64; 2], p: [f64; 2], c: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / 2.0 + (q[0] * q[0] + q[1] * q[1]).sqrt()
}

/// No force in the second direction, nor in the third but for friction.
#[hamiltonian(damping = [c, 0.0, c])]
fn carriage(q: [f64; 3], p: [f64; 3], c: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / 2.0 + q[0].powi(4)
}

#[test]
fn damped_systems_have_neither_flows_nor_a_conserved_energy() {
    assert_eq!([Has::<Duffing>::FLOWS, Has::<Duffing>::CONSERVATIVE], [false, false]);
    assert_eq!([Has::<Free>::FLOWS, Has::<Free>::CONSERVATIVE], [true, true]);
    assert!(Free::REPORT.contains("- the energy") && !Free::REPORT.contains("Damping"));
    assert!(!Duffing::REPORT.contains("- the energy"));
    assert!(Duffing::REPORT.contains("with C = c\n"), "{}", Duffing::REPORT);
    assert!(ShockAbsorber::REPORT.contains("with C = [[c, -c], [-c, c]]\n"), "{}", ShockAbsorber::REPORT);
    // For one system, damping breaks the angular momentum. For the other, damping does not affect one coordinate, whose momentum is kept.
    assert!(
        Turntable::REPORT.contains("\nConserved by the flow, at least\n- nothing that was found\n"),
        "{}",
        Turntable::REPORT
    );
    assert!(
        Carriage::REPORT.contains("\nConserved by the flow, at least\n- p[1]: H does not read q[1]\n"),
        "{}",
        Carriage::REPORT
    );
    assert!(Swing::REPORT.contains("C = [[a, b], [b, d·(p[0]² + 1)]]"), "{}", Swing::REPORT);
}
