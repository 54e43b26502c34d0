//! Implicit methods for every contact Hamiltonian: order, symmetry, the form, the decay of H, refusals.

use geoint_runtime::array::Array;
use geoint_runtime::contact::ImplicitStep;
use geoint_runtime::prelude::*;
use geoint_runtime::{Claims, Contact, Coordinates, Real};
use geoint_tests::measure::{LOOKS, distance, extrapolated, observed_order};
use geoint_tests::scalars::{Double, Dual, Scalar};

/// A pendulum with damping that grows with s.
#[contact_hamiltonian]
fn pendulum(q: f64, p: f64, s: f64, g: f64, e: f64) -> f64 {
    p * p / 2.0 - q.cos() + g * s + e * s * s / 2.0
}

/// Two masses, coupled, under damping that depends on time.
#[contact_hamiltonian]
fn coupled(q: [f64; 2], p: [f64; 2], s: f64, t: f64, m: [f64; 2], w: f64) -> f64 {
    let kinetic = p[0] * p[0] / (2.0 * m[0]) + p[1] * p[1] / (2.0 * m[1]);
    kinetic - 0.6 * (q[0] - q[1]).cos() + 0.25 * q[1].powi(4) + (0.3 + 0.2 * (w * t).sin()) * s + 0.1 * s * s
}

/// No sum of pieces with known flows.
#[contact_hamiltonian]
fn entangled(q: f64, p: f64, s: f64, m: f64) -> f64 {
    p * p / (2.0 * m) * (q * s).cosh() + 0.3 * (q * p).sin() * s + 0.5 * q * q
}

/// A system, where it starts, and its equation written by hand.
trait Case {
    const NAME: &'static str;
    const LEN: usize;
    type Over<R: Scalar>: Contact<R>;
    fn system<R: Scalar>() -> Self::Over<R>;
    fn start() -> Vec<f64>;
    fn field<R: Scalar>(t: R, x: &[R]) -> Vec<R>;
}

type Point<S, R> = geoint_runtime::ContactState<<S as PhaseSpace<R>>::Coordinates>;

fn real<R: Scalar>(x: f64) -> R {
    R::from_f64(x)
}

struct CoupledCase;
impl Case for CoupledCase {
    const NAME: &'static str = "coupled";
    const LEN: usize = 2;
    type Over<R: Scalar> = Coupled<R>;
    fn system<R: Scalar>() -> Coupled<R> {
        Coupled { m: [real(1.3), real(0.7)], w: real(1.7) }
    }
    fn start() -> Vec<f64> {
        vec![0.9, -0.4, 0.5, 0.8, 0.3]
    }
    fn field<R: Scalar>(t: R, x: &[R]) -> Vec<R> {
        let [q0, q1, p0, p1, s] = [x[0], x[1], x[2], x[3], x[4]];
        let c = |x: f64| real::<R>(x);
        let drag = c(0.3) + c(0.2) * (c(1.7) * t).sin();
        let sigma = drag + c(0.2) * s;
        let twist = c(0.6) * (q0 - q1).sin();
        let kinetic = p0 * p0 / c(2.6) + p1 * p1 / c(1.4);
        let rest = c(0.25) * q1 * q1 * q1 * q1 - c(0.6) * (q0 - q1).cos() + drag * s + c(0.1) * s * s;
        vec![p0 / c(1.3), p1 / c(0.7), -twist - p0 * sigma, twist - q1 * q1 * q1 - p1 * sigma, kinetic - rest]
    }
}

struct EntangledCase;
impl Case for EntangledCase {
    const NAME: &'static str = "entangled";
    const LEN: usize = 1;
    type Over<R: Scalar> = Entangled<R>;
    fn system<R: Scalar>() -> Entangled<R> {
        Entangled { m: real(1.6) }
    }
    fn start() -> Vec<f64> {
        vec![0.8, -0.5, 0.4]
    }
    fn field<R: Scalar>(_: R, x: &[R]) -> Vec<R> {
        let [q, p, s] = [x[0], x[1], x[2]];
        let c = |x: f64| real::<R>(x);
        let (cosh, sinh) = ((q * s).cosh(), (q * s).sinh());
        let (sin, cos) = ((q * p).sin(), (q * p).cos());
        let energy = p * p / c(3.2) * cosh + c(0.3) * sin * s + c(0.5) * q * q;
        let along_p = p / c(1.6) * cosh + c(0.3) * q * cos * s;
        let along_q = p * p / c(3.2) * s * sinh + c(0.3) * p * cos * s + q;
        let along_s = p * p / c(3.2) * q * sinh + c(0.3) * sin;
        vec![along_p, -along_q - p * along_s, p * along_p - energy]
    }
}

fn state<S: Contact<R>, R: Scalar>(t: f64, x: &[R]) -> Point<S, R> {
    let n = S::Array::LEN;
    let (mut q, mut p) = (S::Array::zero(), S::Array::zero());
    q.as_mut_slice().copy_from_slice(&x[..n]);
    p.as_mut_slice().copy_from_slice(&x[n..2 * n]);
    ContactState::at(real(t), Coordinates::from_array(q), Coordinates::from_array(p), x[2 * n])
}

fn flat<Q: Coordinates>(state: &ContactState<Q>) -> Vec<Q::Real> {
    let (q, p) = (state.q.into_array(), state.p.into_array());
    q.as_slice().iter().chain(p.as_slice()).chain([&state.s]).copied().collect()
}

fn over<R: Scalar>(x: Vec<f64>) -> Vec<R> {
    x.into_iter().map(real).collect()
}

const FROM: f64 = 0.4;
const FOR: f64 = 1.9;

/// The error in double-double, in the root-mean-square of all looks.
fn error<P: Case, M: Method<P::Over<Double>, Double>>(method: M, n: u64, expected: &[Vec<Double>]) -> f64 {
    let start = state::<P::Over<Double>, Double>(FROM, &over(P::start()));
    let mut sim = P::system::<Double>().integrator(method, Double::from(FOR) / n as f64, start);
    let mut sum = 0.0;
    for expected in expected {
        if sim.advance(n / LOOKS).is_err() {
            return f64::INFINITY;
        }
        sum += distance(&flat(&sim.state()), expected).powi(2);
    }
    (sum / LOOKS as f64).sqrt()
}

fn solutions<P: Case>() -> Vec<Vec<Double>> {
    let solve = |look: u64| {
        let part = Double::from(FOR) * look as f64 / LOOKS as f64;
        extrapolated(P::field::<Double>, FROM.into(), over(P::start()), part, 6 * look as usize)
    };
    (1..=LOOKS).map(solve).collect()
}

fn has_order<P: Case, M: Method<P::Over<Double>, Double>>(name: &str, method: M, expected: &[Vec<Double>]) {
    let order = observed_order(|n| error::<P, M>(method, n, expected));
    let claimed = f64::from(method.claims().order);
    assert!((order - claimed).abs() < 0.15, "{name} on {}: order {order:.3}, not {claimed}", P::NAME);
}

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
                has_order::<$Case, _>("midpoint", Suzuki4.of(ContactMidpoint), &expected);
                has_order::<$Case, _>("discrete gradient", Suzuki4.of(ContactDiscreteGradient), &expected);
                has_order::<$Case, _>("midpoint", Yoshida6a.of(ContactMidpoint), &expected);
                has_order::<$Case, _>("discrete gradient", Yoshida6a.of(ContactDiscreteGradient), &expected);
            }

            #[test]
            fn symmetry() {
                symmetric::<$Case, _>(ContactMidpoint);
                symmetric::<$Case, _>(ContactDiscreteGradient);
                symmetric::<$Case, _>(Yoshida6a.of(ContactMidpoint));
            }

            #[test]
            fn form() {
                let (defect, factor) = contact_defect::<$Case, _>(ContactMidpoint, 3);
                assert!(defect <= 1e-12, "{defect:.1e}");
                assert!(factor > 0.1 && (factor - 1.0).abs() > 0.01, "{factor}");
                let (defect, _) = contact_defect::<$Case, _>(Suzuki4.of(ContactMidpoint), 2);
                assert!(defect <= 1e-12, "{defect:.1e}");
                // The control: it is seen.
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
                assert!(worst <= 2e-14, "{worst:.1e}");
            }
        }
    )* };
}

claims! {
    coupled_masses: CoupledCase;
    without_pieces: EntangledCase;
}

fn symmetric<P: Case, M: Method<P::Over<f64>, f64>>(method: M) {
    for h in [0.02, 0.15] {
        let start = state::<P::Over<f64>, f64>(FROM, &P::start());
        let mut sim = P::system::<f64>().integrator(method, h, start);
        sim.advance(3).unwrap();
        let away = distance(&flat(&sim.state()), &P::start());
        sim.set_step_size(-h);
        sim.advance(3).unwrap();
        let defect = distance(&flat(&sim.state()), &P::start());
        assert!(away > 0.01 && defect <= 1e-13, "{}: {away}, {defect:.1e}", P::NAME);
    }
}

/// Newton's matrix against dual numbers through the equation.
fn newtons_matrix<P: Case, M>()
where
    P::Over<Dual>: ImplicitStep<M, Dual>,
{
    type Unknown<P, M> = <<P as Case>::Over<Dual> as ImplicitStep<M, Dual>>::Unknown;
    let n = 2 * P::LEN + 1;
    let constants = P::system::<Dual>().constants(0.3.into());
    let mut x = Unknown::<P, M>::zero();
    x.as_mut_slice().copy_from_slice(&over(P::start()));
    let start = P::Over::<Dual>::begin(&constants, 0.4.into(), &x);
    let image = |d: &Unknown<P, M>| {
        let mut f = Unknown::<P, M>::zero();
        let mut jacobian = Unknown::<P, M>::fill(f);
        P::Over::<Dual>::image(&constants, &start, d, &mut f, &mut jacobian);
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
            let (entry, expected) = (row.as_slice()[j].value(), f.as_slice()[i].derivative());
            assert!((entry - expected).abs() < 1e-13, "{}, {i}, {j}: {entry}, not {expected}", P::NAME);
        }
    }
}

/// The largest entry of φ*(ds − p dq) − λ (ds − p dq) with λ from ∂/∂s, and λ.
fn contact_defect<P: Case, M: Method<P::Over<Dual>, Dual>>(method: M, steps: u64) -> (f64, f64) {
    let n = P::LEN;
    let form = |seed: usize| {
        let mut x = over::<Dual>(P::start());
        x[seed] = Dual::variable(x[seed].value());
        let mut sim = P::system::<Dual>().integrator(method, 0.15.into(), state::<P::Over<Dual>, Dual>(FROM, &x));
        sim.advance(steps).unwrap();
        let end = flat(&sim.state());
        let work: f64 = (0..n).map(|i| end[n + i].value() * end[i].derivative()).sum();
        end[2 * n].derivative() - work
    };
    let (start, factor) = (P::start(), form(2 * n));
    let along_q = (0..n).map(|i| (form(i) + factor * start[n + i]).abs());
    let along_p = (0..n).map(|i| form(n + i).abs());
    (along_q.chain(along_p).fold(0.0, f64::max), factor)
}

/// How far H̄ = (p̄·Δq − Δs)/h is from the logarithmic mean of H at both ends, that is H(x₀)(e^z − 1)/z with
/// H(x₁) = H(x₀) e^z, in the worst step. Whatever ∂H/∂s was taken.
fn decays<S: ImplicitStep<ContactDiscreteGradient>>(system: S, start: &[f64], h: f64, steps: usize) -> f64 {
    let n = S::Array::LEN;
    let mut sim = system.integrator(ContactDiscreteGradient, h, state::<S, f64>(FROM, start));
    let (mut worst, mut change) = (0.0_f64, 0.0_f64);
    for _ in 0..steps {
        let before = sim.state();
        sim.step().unwrap();
        let after = sim.state();
        let middle = before.t + 0.5 * h;
        let energy = |x: &Point<S, f64>| system.hamiltonian(middle, &x.q.into_array(), &x.p.into_array(), &x.s);
        let [first, last] = [energy(&before), energy(&after)];
        let (x, y) = (flat(&before), flat(&after));
        let work: f64 = (0..n).map(|i| 0.5 * (x[n + i] + y[n + i]) * (y[i] - x[i])).sum();
        let mean = (work - (y[2 * n] - x[2 * n])) / h;
        let z = (last / first).ln();
        worst = worst.max((mean * z - (last - first)).abs() / (x[2 * n].abs() + 1.0));
        change = change.max(z.abs());
    }
    assert!(change > 1e-3, "H decays: {change:.1e}");
    worst
}

#[test]
fn nothing_splits_the_entangled() {
    assert!(Entangled::REPORT.contains("none: no rule knows the flow of"), "{}", Entangled::REPORT);
    for line in ["`ContactMidpoint`, unknowns 3", "`ContactDiscreteGradient`, unknowns 3"] {
        assert!(Entangled::REPORT.contains(line), "{}", Entangled::REPORT);
    }
    assert!(Coupled::REPORT.contains("`ContactMidpoint`, unknowns 5"), "{}", Coupled::REPORT);
}

/// H₁ = H₀ exp(−h g_s) with g_s written by hand, in each step.
#[test]
fn the_law_of_decay() {
    for e in [0.0, 0.2] {
        let system = Pendulum { g: 0.1, e };
        for h in [0.01, 0.1, 0.7] {
            let mut sim = system.integrator(ContactDiscreteGradient, h, ContactState::new(1.0, 0.5, 0.3));
            for _ in 0..300 {
                let (before, first) = (sim.state(), sim.energy());
                sim.step().unwrap();
                let decay = h * (0.1 + e * 0.5 * (before.s + sim.state().s));
                let defect = (sim.energy() - first * (-decay).exp()).abs();
                let terms = 1.0 + before.p.powi(2) / 2.0 + 0.1 * before.s.abs() + e * before.s.powi(2);
                assert!(defect <= 3e-15 * terms, "e = {e}, h = {h}: {defect:.1e}");
            }
        }
    }
}

/// Figures that were computed beforehand by another program.
#[test]
fn figures() {
    let solution = |e: f64| {
        let field = |_, x: &[Double]| {
            let [q, p, s] = [x[0], x[1], x[2]];
            let sigma = Double::from(0.1) + s * e;
            vec![p, -q.sin() - p * sigma, p * p * 0.5 + q.cos() - s * 0.1 - s * s * (0.5 * e)]
        };
        extrapolated(field, 0.0.into(), over(vec![1.0, 0.5, 0.3]), 4.0.into(), 20)
            .iter()
            .map(|x| x.value())
            .collect::<Vec<_>>()
    };
    let run = |e: f64, h: f64| {
        let mut sim = Pendulum { g: 0.1, e }.integrator(ContactDiscreteGradient, h, ContactState::new(1.0, 0.5, 0.3));
        let first = sim.energy();
        sim.advance((4.0 / h).round() as u64).unwrap();
        (flat(&sim.state()), sim.energy(), first)
    };
    let exact = solution(0.0);
    for (h, expected) in [(0.1, 3.00e-3), (0.05, 7.50e-4), (0.025, 1.88e-4)] {
        let error = distance(&run(0.0, h).0, &exact);
        assert!((error / expected - 1.0).abs() < 0.05, "h = {h}: {error:.2e}");
    }
    let (_, last, first) = run(0.0, 0.1);
    assert!((last - first * (-0.4_f64).exp()).abs() <= 5e-15);
    let exact = solution(0.2);
    let energy = exact[1].powi(2) / 2.0 - exact[0].cos() + 0.1 * exact[2] + 0.1 * exact[2].powi(2);
    let gap = (run(0.2, 0.1).1 - energy).abs();
    assert!((gap / 7.7e-5 - 1.0).abs() < 0.05, "{gap:.2e}");
}

/// The level H = 0 stays, whatever the step, and H keeps its sign beside it.
#[test]
fn the_zero_level() {
    let system = Entangled { m: 1.6 };
    let energy = |s: f64| system.energy(&ContactState::new(0.3, -0.4, s));
    let (mut low, mut high) = (0.0, 4.0);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if energy(low) * energy(middle) <= 0.0 { high = middle } else { low = middle }
    }
    assert!(energy(low).abs() < 1e-14, "{low}: {}", energy(low));
    for h in [0.05, 0.2] {
        let mut sim = system.integrator(ContactDiscreteGradient, h, ContactState::new(0.3, -0.4, low));
        for _ in 0..10 {
            sim.step().unwrap();
            assert!(sim.energy().abs() <= 2e-13, "h = {h}: {:.1e}", sim.energy());
        }
        // The control.
        let mut sim = system.integrator(ContactMidpoint, h, ContactState::new(0.3, -0.4, low));
        sim.advance(10).unwrap();
        assert!(sim.energy().abs() > 1e-7, "h = {h}: {:.1e}", sim.energy());
    }
}

/// With constant damping the form shrinks by a number that is known.
#[test]
fn the_factor_of_the_form() {
    struct Constant;
    impl Case for Constant {
        const NAME: &'static str = "constant";
        const LEN: usize = 1;
        type Over<R: Scalar> = Pendulum<R>;
        fn system<R: Scalar>() -> Pendulum<R> {
            Pendulum { g: real(0.4), e: real(0.0) }
        }
        fn start() -> Vec<f64> {
            vec![1.0, 0.5, 0.3]
        }
        fn field<R: Scalar>(_: R, _: &[R]) -> Vec<R> {
            vec![]
        }
    }
    let (defect, factor) = contact_defect::<Constant, _>(ContactMidpoint, 3);
    let (less, more): (f64, f64) = (1.0 - 0.15 * 0.4 / 2.0, 1.0 + 0.15 * 0.4 / 2.0);
    assert!(defect < 1e-13 && (factor - (less / more).powi(3)).abs() < 1e-14, "{defect:.1e}, {factor}");
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

/// Nested coordinates, branches, and so many unknowns that the fixed point is tried first.
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
    assert!(worst <= 2e-14, "{worst:.1e}");

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

/// No step where the form would change its sign, where there is no solution, and outside the domain; the state stays.
#[test]
fn refusals() {
    let start = ContactState::new(1.0, 0.5, 0.3);
    for (g, h) in [(3.0, 1.0), (-3.0, 1.0), (3.0, -1.0)] {
        let mut sim = Pendulum { g, e: 0.0 }.integrator(ContactMidpoint, h, start);
        assert_eq!(sim.step(), Err(StepError::Singular { t: 0.0 }), "{g}, {h}");
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
                Err(StepError::NotConverged { .. } | StepError::Singular { .. }) => {
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
        assert!(matches!(error, StepError::OutsideDomain { what, .. } if what.contains("ln")), "{error}");
        assert!(sim.state().q < 1.0 && sim.energy().is_finite());
        let mut sim = Bounded.integrator(method, 0.2, ContactState::new(1.5, 4.0, 0.3));
        assert!(matches!(sim.step(), Err(StepError::OutsideDomain { .. })));
    }
    leaves(ContactMidpoint);
    leaves(ContactDiscreteGradient);
}
