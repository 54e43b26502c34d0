//! Implicit methods for every contact Hamiltonian: order, symmetry, the form, the decay of H, shapes, refusals.

use super::cases::*;
use super::laws::decays;
use geoint_runtime::Claims;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::private::ContactEquation;
use geoint_runtime::space::Array;
use geoint_tests::measure::distance;
use geoint_tests::scalars::Dual;

/// Everything that is claimed of both methods on a problem.
macro_rules! claims {
    ($($test:ident: $Case:ident;)*) => { $(
        mod $test {
            use super::*;

            #[test]
            fn orders() {
                let expected = solutions::<$Case>();
                has_order::<$Case, _>("midpoint", ContactMidpoint, &expected);
                has_order::<$Case, _>("discrete gradient", ContactDiscreteGradient, &expected);
                has_order::<$Case, _>("Gauss", ContactGauss::<2>, &expected);
                has_order::<$Case, _>("Gauss", ContactGauss::<3>, &expected);
                has_order::<$Case, _>("midpoint", Suzuki4.of(ContactMidpoint), &expected);
                has_order::<$Case, _>("discrete gradient", Suzuki4.of(ContactDiscreteGradient), &expected);
                has_order::<$Case, _>("midpoint", Yoshida6a.of(ContactMidpoint), &expected);
                has_order::<$Case, _>("discrete gradient", Yoshida6a.of(ContactDiscreteGradient), &expected);
            }

            #[test]
            fn symmetry() {
                symmetric::<$Case, _>(ContactMidpoint);
                symmetric::<$Case, _>(ContactDiscreteGradient);
                symmetric::<$Case, _>(ContactGauss::<2>);
                symmetric::<$Case, _>(Yoshida6a.of(ContactMidpoint));
            }

            #[test]
            fn form() {
                let (defect, factor) = contact_defect::<$Case, _>(ContactMidpoint, 3);
                assert!(defect <= 1e-14, "{defect:.1e}");
                assert!(factor > 0.1 && (factor - 1.0).abs() > 0.01, "{factor}");
                let (defect, _) = contact_defect::<$Case, _>(Suzuki4.of(ContactMidpoint), 2);
                assert!(defect <= 1e-14, "{defect:.1e}");
                let (defect, _) = contact_defect::<$Case, _>(ContactGauss::<2>, 3);
                assert!(defect <= 1e-14, "{defect:.1e}");
                // Control: the measurement detects a defect.
                let (defect, _) = contact_defect::<$Case, _>(ContactDiscreteGradient, 3);
                assert!(defect > 1e-4, "{defect:.1e}");
                let claims = |claims: Claims| [claims.symplectic, claims.conserves_energy];
                assert_eq!(claims(Method::<Coupled>::claims(&ContactMidpoint)), [true, false]);
                assert_eq!(claims(Method::<Coupled>::claims(&ContactDiscreteGradient)), [false, true]);
            }

            #[test]
            fn derivatives() {
                newtons_matrix::<$Case, ContactMidpoint>();
                newtons_matrix::<$Case, ContactDiscreteGradient>();
            }

            #[test]
            fn decay() {
                let system = <$Case>::system::<f64>();
                let worst = decays(system, &<$Case>::start(), 0.1, 400);
                assert!(worst <= 1e-15, "{worst:.1e}");
            }
        }
    )* };
}

claims! {
    damped_pendulum: PendulumCase;
    coupled_masses: CoupledCase;
    without_pieces: EntangledCase;
}
/// Newton's matrix against dual numbers through the equation.
fn newtons_matrix<P: Case, M>()
where
    P::Over<Dual>: ContactEquation<M, Dual>,
{
    type Unknown<P, M> = <<P as Case>::Over<Dual> as ContactEquation<M, Dual>>::Unknown;
    let n = 2 * P::LEN + 1;
    let system = P::system::<Dual>();
    let constants = system.constants(0.3.into());
    let mut x = Unknown::<P, M>::zero();
    x.as_mut_slice().copy_from_slice(&over(P::start()));
    let start = system.begin(&constants, 0.4.into(), &x);
    let image = |d: &Unknown<P, M>| {
        let mut f = Unknown::<P, M>::zero();
        let mut jacobian = Unknown::<P, M>::fill(f);
        system.image(&constants, &start, d, &mut f, &mut jacobian);
        (f, jacobian)
    };
    let mut d = Unknown::<P, M>::zero();
    for (i, d) in d.as_mut_slice().iter_mut().enumerate() {
        *d = (0.2 + 0.1 * (1.7 * i as f64).sin()).into();
    }
    let (_, mut jacobian) = image(&d);
    for j in 0..n {
        let mut moved = d;
        moved.as_mut_slice()[j] = Dual::variable(d.as_slice()[j].value());
        let (f, _) = image(&moved);
        for (i, row) in Unknown::<P, M>::entries::<Unknown<P, M>>(&mut jacobian).iter().enumerate() {
            let unit = f64::from(u8::from(i == j));
            let (entry, expected) = (row.as_slice()[j].value(), unit - f.as_slice()[i].derivative());
            assert!((entry - expected).abs() < 1e-13, "{}, {i}, {j}: {entry}, not {expected}", P::NAME);
        }
    }
}
#[test]
fn nothing_splits_the_entangled() {
    assert!(Entangled::REPORT.contains("none: no rule knows the flow of"), "{}", Entangled::REPORT);
    assert!(Entangled::REPORT.contains("- families that were tried: damped drift, "), "{}", Entangled::REPORT);
    for line in ["`ContactMidpoint`, unknowns 3", "`ContactDiscreteGradient`, unknowns 3"] {
        assert!(Entangled::REPORT.contains(line), "{}", Entangled::REPORT);
    }
    assert!(Coupled::REPORT.contains("`ContactMidpoint`, unknowns 5"), "{}", Coupled::REPORT);
}
/// Without s both are the methods of the Hamiltonian.
#[test]
fn without_the_action() {
    #[contact_hamiltonian(name = Strict)]
    fn strict(q: f64, p: f64, _s: f64) -> f64 {
        p * p / 2.6 * (1.0 + 0.3 * q.sin()) - q.cos()
    }
    #[hamiltonian(name = Plain)]
    fn plain(q: f64, p: f64) -> f64 {
        p * p / 2.6 * (1.0 + 0.3 * q.sin()) - q.cos()
    }
    fn same<M: Method<Strict>, N: Method<Plain>>(method: M, other: N) {
        let mut strict = Strict.integrator(method, 0.2, ContactState::new(1.0, 0.5, 0.3));
        let mut plain = Plain.integrator(other, 0.2, State::new(1.0, 0.5));
        let first = plain.energy();
        strict.advance(100).unwrap();
        plain.advance(100).unwrap();
        let (x, y) = (strict.state(), plain.state());
        assert!((x.q - y.q).abs() + (x.p - y.p).abs() < 1e-12);
        assert!((x.s - 0.3).abs() > 0.5 && first != 0.0);
    }
    same(ContactMidpoint, ImplicitMidpoint);
    same(ContactDiscreteGradient, DiscreteGradient);
}

/// Tests nested coordinates, branches, and a chain with many unknowns. For the chain the fixed point is tried first.
#[test]
fn shapes() {
    #[contact_hamiltonian(name = Nested)]
    fn nested(q: [[f64; 1]; 2], p: [[f64; 1]; 2], s: f64, t: f64, m: [f64; 2], w: f64) -> f64 {
        let kinetic = p[0][0] * p[0][0] / (2.0 * m[0]) + p[1][0] * p[1][0] / (2.0 * m[1]);
        let potential = 0.25 * q[1][0].powi(4) - 0.6 * (q[0][0] - q[1][0]).cos();
        kinetic + potential + (0.3 + 0.2 * (w * t).sin()) * s + 0.1 * s * s
    }
    fn runs<M: Method<Nested> + Method<Coupled>>(method: M) {
        let (m, w) = ([1.3, 0.7], 1.7);
        let mut nested = Nested { m, w }.integrator(method, 0.1, state::<Nested, f64>(FROM, &CoupledCase::start()));
        let mut coupled = Coupled { m, w }.integrator(method, 0.1, state::<Coupled, f64>(FROM, &CoupledCase::start()));
        nested.advance(50).unwrap();
        coupled.advance(50).unwrap();
        assert!(distance(&flat(&nested.state()), &flat(&coupled.state())) < 1e-13);
    }
    runs(ContactMidpoint);
    runs(ContactDiscreteGradient);

    #[contact_hamiltonian(name = Chain)]
    fn chain(q: [f64; 7], p: [f64; 7], s: f64) -> f64 {
        let mut sum = 0.2 * s + 0.05 * s * s;
        for i in 0..7 {
            sum += p[i] * p[i] / (1.0 + 0.1 * i as f64) / 2.0 + q[i].powi(4) / 4.0;
        }
        for i in 1..7 {
            sum += (q[i] - q[i - 1]).powi(2) / 2.0;
        }
        sum
    }
    let start: Vec<f64> = (0..15).map(|i| (f64::from(i) * 1.3).sin() * 0.6).collect();
    let worst = decays(Chain, &start, 0.05, 200);
    assert!(worst <= 1e-15, "{worst:.1e}");

    #[contact_hamiltonian(name = Bouncing)]
    fn bouncing(q: f64, p: f64, s: f64) -> f64 {
        let wall = if q < 0.0 { 8.0 * q * q } else { 0.3 * q * q };
        p * p / 1.4 + wall + 0.1 * s
    }
    let mut sim = Bouncing.integrator(ContactDiscreteGradient, 0.1, ContactState::new(1.0, 0.5, 0.3));
    let (first, mut switches) = (sim.energy(), 0);
    for n in 1..200 {
        let before = sim.state().q;
        sim.step().unwrap();
        switches += u32::from((before < 0.0) != (sim.state().q < 0.0));
        let expected = first * (-0.01 * f64::from(n)).exp();
        assert!((sim.energy() - expected).abs() < 1e-14 * f64::from(n), "{n}");
    }
    assert!(switches > 5);
}

/// Energies that do not read everything, single precision, and vectors.
#[test]
fn edges() {
    #[contact_hamiltonian(name = Decay)]
    fn decay(_q: f64, _p: f64, s: f64) -> f64 {
        0.5 * s
    }
    let start = ContactState::new(1.0, 0.5, 0.3);
    let mut sim = Decay.integrator(ContactMidpoint, 0.1, start);
    sim.advance(10).unwrap();
    let ratio = (0.975_f64 / 1.025).powi(10);
    assert_eq!(sim.state().q, 1.0);
    assert!((sim.state().p - 0.5 * ratio).abs() < 1e-15 && (sim.state().s - 0.3 * ratio).abs() < 1e-15);
    let mut sim = Decay.integrator(ContactDiscreteGradient, 0.1, start);
    sim.advance(10).unwrap();
    assert!((sim.state().s - 0.3 * (-0.5_f64).exp()).abs() < 1e-15);

    #[contact_hamiltonian(name = Short)]
    fn short(q: f32, p: f32, s: f32, m: f32) -> f32 {
        p * p / (2.0 * m) - q.cos() + 0.1 * s
    }
    let mut sim = Short { m: 1.3 }.integrator(ContactDiscreteGradient, 0.1, ContactState::new(1.0, 0.5, 0.3));
    let first = sim.energy();
    sim.advance(20).unwrap();
    assert!((sim.energy() - first * (-0.2_f32).exp()).abs() < 2e-6);

    #[contact_hamiltonian(name = Vectors)]
    fn vectors(q: nalgebra::SVector<f64, 2>, p: nalgebra::SVector<f64, 2>, s: f64, m: f64) -> f64 {
        p.norm_squared() / (2.0 * m) - 1.0 / q.norm() + 0.1 * s
    }
    let (q, p) = ([1.0, 0.2], [0.1, 1.2]);
    let mut sim =
        Vectors { m: 1.3 }.integrator(ContactDiscreteGradient, 0.1, ContactState::new(q.into(), p.into(), 0.0));
    let first = sim.energy();
    sim.advance(20).unwrap();
    assert!((sim.energy() - first * (-0.2_f64).exp()).abs() < 1e-14);
    sim = Vectors { m: 1.3 }.integrator(ContactDiscreteGradient, -0.1, sim.state());
    sim.advance(20).unwrap();
    assert!((sim.state().q - nalgebra::SVector::from(q)).norm() < 1e-13);
}

/// Refused: steps in which the form would change its sign, steps without a solution, and steps out of the domain. The state is kept.
#[test]
fn refusals() {
    let start = ContactState::new(1.0, 0.5, 0.3);
    for (g, h) in [(3.0, 1.0), (-3.0, 1.0), (3.0, -1.0)] {
        let mut sim = Pendulum { g, e: 0.0 }.integrator(ContactMidpoint, h, start);
        assert_eq!(sim.step(), Err(StepError::new(Failure::Singular, 0.0, h)), "{g}, {h}");
        assert_eq!(sim.state(), start);
        sim.set_step_size(0.1);
        sim.step().unwrap();
    }

    fn large<M: Method<Entangled>>(method: M) {
        let start = ContactState::new(0.8, -0.5, 0.4);
        let mut refused = 0;
        for h in [30.0, 300.0, 3e3, 3e5, 3e8, 1e100, 1e300] {
            let mut sim = Entangled { m: 1.6 }.integrator(method, h, start);
            match sim.step() {
                Ok(()) => assert!(flat(&sim.state()).iter().all(|x| x.is_finite()), "h = {h}"),
                Err(StepError { failure: Failure::NotConverged { .. } | Failure::Singular, .. }) => {
                    refused += 1;
                    assert_eq!(sim.state(), start);
                    sim.set_step_size(0.01);
                    sim.step().unwrap();
                }
                Err(other) => panic!("h = {h}: {other}"),
            }
        }
        assert!(refused > 0);
    }
    large(ContactMidpoint);
    large(ContactDiscreteGradient);

    #[contact_hamiltonian(name = Bounded)]
    fn bounded(q: f64, p: f64, s: f64) -> f64 {
        p * p / 1.4 - (1.0 - q).ln().powi(2) + 0.1 * s
    }
    fn leaves<M: Method<Bounded>>(method: M) {
        let start = ContactState::new(0.2, 4.0, 0.3);
        let mut sim = Bounded.integrator(method, 0.2, start);
        let error = sim.advance(100).unwrap_err();
        assert!(
            matches!(error, StepError { failure: Failure::OutsideDomain { what }, .. } if what.contains("ln")),
            "{error}"
        );
        assert!(sim.state().q < 1.0 && sim.energy().is_finite());
        let mut sim = Bounded.integrator(method, 0.2, ContactState::new(1.5, 4.0, 0.3));
        assert!(matches!(sim.step(), Err(StepError { failure: Failure::OutsideDomain { .. }, .. })));
    }
    leaves(ContactMidpoint);
    leaves(ContactDiscreteGradient);
}

/// V jumps where s is 1: no derivative by s says so, but positions and momenta do not move without it.
#[contact_hamiltonian]
fn slope_by_action(q: f64, p: f64, s: f64) -> f64 {
    p * p / 2.6 + if s < 1.0 { q } else { 2.0 * q }
}

#[test]
fn a_condition_that_reads_s_acts_back() {
    fn falls<M: Method<SlopeByAction>>(method: M) {
        for (s, slope) in [(-3.0, 1.0), (3.0, 2.0)] {
            let mut sim = SlopeByAction.integrator(method, 0.05, ContactState::new(0.2, 0.3, s));
            sim.advance(10).unwrap();
            let error = sim.state().p - (0.3 - 0.5 * slope);
            assert!(error.abs() < 1e-15, "{error:e}");
        }
    }
    falls(ContactMidpoint);
    falls(ContactDiscreteGradient);
    falls(ContactGauss::<2>);
    assert!(SlopeByAction::REPORT.contains("s acts back"));
}
