//! Every splitting for contact systems: order, symmetry, the contact form, laws that are exact.

use crate::measure::{field, run, solution, state};
use geoint_runtime::prelude::*;
use geoint_runtime::{Contact, ForceGradient, Mechanical, ModifiedEnergy, Pieces, QuadraticKinetic, Real};
use geoint_tests::measure::{distance, error, form_defect, observed_order, solutions, symmetry_defect};
use geoint_tests::scalars::{Double, Dual, Scalar};
use geoint_tests::scene::Scene;
use geoint_tests::scenes::*;

/// What is done with a method.
trait Visitor<P: Scene> {
    fn visit<M>(&mut self, name: &'static str, method: M)
    where
        M: Method<P::Over<f64>> + Method<P::Over<Double>, Double> + Method<P::Over<Dual>, Dual>;
}

macro_rules! visit {
    ($visitor:ident: $($method:expr),* $(,)?) => { $( $visitor.visit(stringify!($method), $method); )* };
}

/// Methods for every split.
fn split<P: Scene>(visitor: &mut impl Visitor<P>)
where
    P::Over<f64>: Pieces<ContactSplitting>,
    P::Over<Double>: Pieces<ContactSplitting, Double>,
    P::Over<Dual>: Pieces<ContactSplitting, Dual>,
{
    visit!(visitor: ContactSplitting, BlanesMoan4X, BlanesMoan6X);
    visit!(visitor: Yoshida4.of(ContactSplitting), Suzuki4.of(ContactSplitting), McLachlan4.of(ContactSplitting),
        Yoshida6a.of(ContactSplitting), McLachlan6_9.of(ContactSplitting), KahanLi8_17a.of(ContactSplitting));
}

/// Methods for T + g·s + V.
fn mechanical<P: Scene>(visitor: &mut impl Visitor<P>)
where
    P::Over<f64>: Mechanical,
    P::Over<Double>: Mechanical<Double>,
    P::Over<Dual>: Mechanical<Dual>,
{
    visit!(visitor: ContactLeapfrog, Yoshida4.of(ContactLeapfrog), Yoshida6a.of(ContactLeapfrog));
    visit!(visitor: SymplecticEuler, SymplecticEulerAdjoint, StormerVerlet, PositionVerlet, ForestRuth4, PEFRL, BlanesMoan4,
        BlanesMoan6, Suzuki4.of(PositionVerlet), KahanLi8_17a.of(StormerVerlet));
}

/// Methods for an exact flow of T + g·s with quadratic T.
fn nystrom<P: Scene>(visitor: &mut impl Visitor<P>)
where
    P::Over<f64>: QuadraticKinetic,
    P::Over<Double>: QuadraticKinetic<Double>,
    P::Over<Dual>: QuadraticKinetic<Dual>,
{
    visit!(visitor: BlanesMoanSrkn6b, BlanesMoanSrkn11b, BlanesMoanSrkn14a, BceRkn17_8, BceRkn19_8);
}

/// Methods for that, with force gradients.
fn force_gradient<P: Scene>(visitor: &mut impl Visitor<P>)
where
    P::Over<f64>: ForceGradient,
    P::Over<Double>: ForceGradient<Double>,
    P::Over<Dual>: ForceGradient<Dual>,
{
    visit!(visitor: TakahashiImada2, Chin4A, Chin4B, Chin4C, Chin4D);
    visit!(visitor: Omelyan4_4F2GV, Omelyan4_5F2GP, Omelyan6_5F3GP, Omelyan6_5F4GV, Omelyan8_11F11GP);
}

/// Orders, symmetry, the form.
#[derive(Default)]
struct Geometry {
    failures: Vec<String>,
    /// The solution of the scene that was met last.
    solved: Option<(&'static str, Vec<Vec<Double>>)>,
}

impl Geometry {
    fn solutions<P: Scene>(&mut self) -> &[Vec<Double>] {
        let solved = self.solved.take().filter(|solved| solved.0 == P::NAME);
        &self.solved.insert(solved.unwrap_or_else(|| (P::NAME, solutions::<P>(DURATION, 4)))).1
    }
}

/// Not a multiple of any period.
const DURATION: f64 = 2.3;
/// A step long enough for what is not kept to show.
const STEP: f64 = 0.0625;

impl<P: Scene> Visitor<P> for Geometry {
    fn visit<M>(&mut self, name: &'static str, method: M)
    where
        M: Method<P::Over<f64>> + Method<P::Over<Double>, Double> + Method<P::Over<Dual>, Dual>,
    {
        let claims = Method::<P::Over<f64>>::claims(&method);
        let solutions = self.solutions::<P>();
        let order = observed_order(|n| error::<P, M>(method, DURATION, n, solutions).unwrap_or(f64::INFINITY));
        let symmetry = symmetry_defect::<P, M>(method, STEP, 4).expect("a step");
        let form = form_defect::<P, M>(method, STEP, 4).expect("a step");
        println!("{:10} {name:36} order {order:5.2}  symmetry {symmetry:7.1e}  form {form:7.1e}", P::NAME);
        let claimed = f64::from(claims.order);
        if (order - claimed).abs() > 0.15 {
            self.failures.push(format!("{}, {name}: order {order:.2}", P::NAME));
        }
        if claims.symmetric != (symmetry < 1e-13) {
            self.failures.push(format!("{}, {name}: symmetry {symmetry:.1e}", P::NAME));
        }
        if claims.symplectic && form > 1e-12 {
            self.failures.push(format!("{}, {name}: form {form:.1e}", P::NAME));
        }
    }
}

#[test]
fn claims_hold() {
    let mut geometry = Geometry::default();
    split::<Swings>(&mut geometry);
    mechanical::<Swings>(&mut geometry);
    nystrom::<Swings>(&mut geometry);
    force_gradient::<Swings>(&mut geometry);
    split::<Drives>(&mut geometry);
    mechanical::<Drives>(&mut geometry);
    split::<Stars>(&mut geometry);
    mechanical::<Stars>(&mut geometry);
    nystrom::<Stars>(&mut geometry);
    force_gradient::<Stars>(&mut geometry);
    split::<Coolings>(&mut geometry);
    mechanical::<Coolings>(&mut geometry);
    nystrom::<Coolings>(&mut geometry);
    force_gradient::<Coolings>(&mut geometry);
    split::<Relativists>(&mut geometry);
    mechanical::<Relativists>(&mut geometry);
    split::<Tangles>(&mut geometry);
    split::<Charges>(&mut geometry);
    mechanical::<Quartics>(&mut geometry);
    mechanical::<Blows>(&mut geometry);
    force_gradient::<Masses>(&mut geometry);
    assert!(geometry.failures.is_empty(), "{}", geometry.failures.join("\n"));
}

/// A method of another order is seen, and one that is no contact map.
#[test]
fn controls_fail() {
    /// RK4 without a thought of the form.
    fn rk4<R: Scalar, S: Contact<R>>(system: &S, t: R, x: &[R], h: R) -> Vec<R> {
        let real = R::from_f64;
        let ahead = |h: R, slope: &[R]| x.iter().zip(slope).map(|(x, f)| *x + h * *f).collect::<Vec<R>>();
        let a = field(system, t, x);
        let b = field(system, t + h * real(0.5), &ahead(h * real(0.5), &a));
        let c = field(system, t + h * real(0.5), &ahead(h * real(0.5), &b));
        let d = field(system, t + h, &ahead(h, &c));
        (0..x.len()).map(|i| x[i] + h / real(6.0) * (a[i] + real(2.0) * (b[i] + c[i]) + d[i])).collect()
    }
    let (t, x) = Drives::start();
    let mut forms = vec![];
    for j in 0..x.len() {
        let mut x: Vec<Dual> = x.iter().map(|x| Dual::from(*x)).collect();
        x[j] = Dual::variable(x[j].value());
        let end = rk4(&Drives::over::<Dual>(), Dual::from(t), &x, Dual::from(0.3));
        forms.push(end[4].derivative() - (0..2).map(|i| end[2 + i].value() * end[i].derivative()).sum::<f64>());
    }
    let defect = (0..2).map(|j| (forms[j] + forms[4] * x[2 + j]).abs()).fold(0.0, f64::max);
    assert!(defect > 1e-5, "{defect:.1e}");
}

/// Runge–Kutta–Nyström tables are unchanged: \[V, \[V, \[V, T + g·s\]\]\] = 0. The largest error of q, p, s after T = 10.
#[test]
fn table_of_the_damped_pendulum() {
    let bob = Bob { gamma: 0.1 };
    let exact = solution(&Bob::<Double> { gamma: Double::from(0.1) }, 0.0, &[1.0, 0.5, 0.3], 10.0, 20);
    macro_rules! row {
        ($method:expr, $bound:expr, [$($error:expr),*]) => {
            for (h, noted) in [0.4, 0.2, 0.1, 0.05].into_iter().zip([$($error),*]) {
                let found = run(bob, $method, (0.0, &[1.0, 0.5, 0.3]), h, (10.0_f64 / h).round() as u64).unwrap();
                let error = found.iter().zip(&exact).map(|(x, y)| (Double::from(*x) - *y).magnitude()).fold(0.0, f64::max);
                assert!((error / noted - 1.0).abs() < $bound, "{}, {h}: {error:.2e}, not {noted:.2e}", stringify!($method));
            }
        };
    }
    row!(ContactLeapfrog, 0.01, [3.42e-2, 8.48e-3, 2.12e-3, 5.29e-4]);
    row!(Chin4A, 0.01, [5.24e-6, 3.26e-7, 2.04e-8, 1.27e-9]);
    row!(BlanesMoanSrkn6b, 0.01, [9.19e-7, 6.10e-8, 3.87e-9, 2.43e-10]);
    row!(BlanesMoanSrkn11b, 0.02, [1.29e-9, 2.00e-11]);
}

/// The pendulum of the table.
#[contact_hamiltonian]
fn bob(q: f64, p: f64, s: f64, gamma: f64) -> f64 {
    p * p / 2.0 - q.cos() + gamma * s
}

/// One step is the flow of H + h²H₂ but for h⁵.
#[test]
fn modified_energies() {
    fn defect<P: Scene>(h: f64) -> f64
    where
        P::Over<f64>: Pieces<ContactSplitting>,
        P::Over<Dual>: ModifiedEnergy<Dual>,
    {
        let (t, x) = P::start();
        let step = run(P::over::<f64>(), ContactSplitting, (t, &x), h, 1).unwrap();
        let system = P::over::<Dual>();
        let field = |now: f64, x: &[f64]| -> Vec<f64> {
            let value = |j: usize| {
                let mut x: Vec<Dual> = x.iter().map(|x| Dual::from(*x)).collect();
                if let Some(x) = x.get_mut(j) {
                    *x = Dual::variable(x.value());
                }
                ModifiedEnergy::modified_energy(&system, Dual::from(h), &state(Dual::from(now), &x))
            };
            let n = x.len() / 2;
            let slopes: Vec<f64> = (0..x.len()).map(|j| value(j).derivative()).collect();
            let rates = slopes[n..2 * n].to_vec();
            let forces = (0..n).map(|i| -slopes[i] - x[n + i] * slopes[2 * n]);
            let action = (0..n).map(|i| x[n + i] * rates[i]).sum::<f64>() - value(usize::MAX).value();
            rates.iter().copied().chain(forces).chain([action]).collect()
        };
        let exact = geoint_tests::measure::extrapolated(field, t, x.clone(), h, 1);
        distance(&step, &exact)
    }
    fn check<P: Scene>()
    where
        P::Over<f64>: Pieces<ContactSplitting>,
        P::Over<Dual>: ModifiedEnergy<Dual>,
    {
        let [coarse, fine] = [0.1, 0.05].map(defect::<P>);
        let order = (coarse / fine).log2();
        println!("{}: {coarse:.1e} {fine:.1e} {order:.2}", P::NAME);
        assert!((order - 5.0).abs() < 0.4, "{}: {order:.2}", P::NAME);
    }
    check::<Swings>();
    check::<Drives>();
    check::<Stars>();
    check::<Tangles>();
}
