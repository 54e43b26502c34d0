//! Every splitting for contact systems: order, symmetry, the contact form, laws that are exact.

use crate::measure::{field, run, solution, state};
use geoint_runtime::method::SteppedAs;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::private::ModifiedEnergy;
use geoint_runtime::{Contact, Real};
use geoint_tests::claims::{Geometry, Orders, Symmetry};
use geoint_tests::measure::distance;
use geoint_tests::methods;
use geoint_tests::scalars::{Double, Dual, Scalar};
use geoint_tests::scene::Scene;
use geoint_tests::scenes::*;

/// Tests whole lists of kicks and drifts on one scene, and one method of each kind of step on the other scenes.
macro_rules! claims {
    ($($Scene:ident: $($list:ident)*;)*) => {
        /// Over a time that is not a multiple of any period.
        #[test]
        fn orders() { $(
            let mut orders = Orders::<$Scene>::over(2.3, 4);
            $( methods::$list(&mut orders); )*
            assert!(orders.finish() > 0);
        )* }

        #[test]
        fn forms() {
            // Splittings keep the form without exception. The control is in `controls_fail`.
            let mut controls = 0;
            $(
            let mut geometry = Geometry::<$Scene>::with_step(STEP);
            $( methods::$list(&mut geometry); )*
            controls += geometry.finish();
            )*
            assert_eq!(controls, 0);
        }

        #[test]
        fn symmetry() {
            let mut controls = 0;
            $(
            let mut geometry = Symmetry(Geometry::<$Scene>::with_step(STEP));
            $( methods::$list(&mut geometry); )*
            controls += geometry.0.finish();
            )*
            assert!(controls > 0, "nothing showed what a failure looks like");
        }
    };
}

/// Step length. It is long enough to show the defects of methods.
const STEP: f64 = 0.0625;

claims! {
    Swings: kinds_of_pieces kinds_of_mechanical separable nystrom force_gradient;
    Drives: kinds_of_pieces kinds_of_mechanical kinds_of_separable;
    Stars: kinds_of_pieces kinds_of_separable kinds_of_nystrom kinds_of_force_gradient;
    Coolings: kinds_of_pieces kinds_of_separable kinds_of_nystrom kinds_of_force_gradient;
    Relativists: kinds_of_pieces kinds_of_separable;
    Tangles: kinds_of_pieces;
    Charges: kinds_of_pieces;
    Quartics: kinds_of_separable;
    Blows: kinds_of_separable;
    Masses: kinds_of_force_gradient;
}

/// Control: RK4 is no contact map. The measured defect of the form exceeds 10⁻⁵.
#[test]
fn controls_fail() {
    /// RK4, which ignores the contact form.
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

/// One step is the flow of H + h²H₂ up to h⁵.
#[test]
fn modified_energies() {
    fn defect<P: Scene>(h: f64) -> f64
    where
        P::Over<f64>: SteppedAs<ContactSplitting>,
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
        P::Over<f64>: SteppedAs<ContactSplitting>,
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
