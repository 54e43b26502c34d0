//! Orders of all tables.

use super::*;

/// Errors of the heavy body at t = 5 with n, 2n, … steps.
fn row<M: Method<HeavyBody, Proof = ()>>(method: M, n: u64, expected: &[f64], order: f64) {
    let name = method.name();
    let errors: Vec<f64> = (0..expected.len()).map(|i| error(&end(heavy(), method, 5.0, n << i), HEAVY)).collect();
    println!("{name:20} {errors:?}");
    for (error, expected) in errors.iter().zip(expected) {
        // The smallest errors are rounding for the most part.
        let tolerance = if *expected < 2e-12 { 0.2 } else { 0.02 };
        assert!((error / expected - 1.0).abs() < tolerance, "{name}: {errors:?}, expected {expected:.3e}");
    }
    let found = (errors[errors.len() - 2] / errors[errors.len() - 1]).log2();
    let tolerance = if errors[errors.len() - 1] < 2e-12 { 0.15 } else { 0.05 };
    assert!((found - order).abs() < tolerance, "{name}: order {found:.3}");
}

#[test]
fn every_kind_of_table_has_its_order() {
    row(StormerVerlet, 25, &[7.464e-3, 1.865e-3, 4.663e-4], 2.0);
    row(FiveRotations, 25, &[1.147e-2, 2.895e-3, 7.253e-4], 2.0);
    row(BlanesMoan4, 25, &[2.964e-7, 1.849e-8, 1.155e-9], 4.0);
    row(BlanesMoanSrkn6b, 25, &[3.162e-8, 2.249e-9, 1.449e-10], 3.96);
    row(Chin4A, 25, &[5.446e-6, 3.370e-7, 2.101e-8], 4.0);
    row(BlanesMoanSrkn11b, 20, &[8.625e-10, 1.343e-11], 6.01);
    row(BlanesMoanSrkn14a, 20, &[3.327e-11, 6.1e-13], 5.85);
    row(BceRkn17_8, 10, &[2.248e-9, 9.476e-12], 7.89);
    assert!(error(&end(heavy(), BlanesMoanSrkn14a, 5.0, 20), HEAVY) <= 4e-11);
}

/// Observes the order of all methods of the catalogue that need only kicks and drifts. The errors of the observed steps are above rounding.
///
/// The second part is the solution at t = 2.
struct Orders(Vec<String>, BodyState<UnitQuaternion<f64>>);

impl Visitor<HeavyBody> for Orders {
    fn visit<M: Method<HeavyBody> + 'static>(&mut self, method: M) {
        let claimed = method.claims().order;
        let errors = |n: u64| {
            let mut sim = Integrator::new(heavy(), method, 2.0 / n as f64, start());
            sim.advance(n).unwrap();
            let coarse = sim.state();
            (coarse.m - self.1.m).amax().max((coarse.r.coords - self.1.r.coords).amax())
        };
        let steps = [2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256];
        // The last pair above rounding gives the order, because the order is a property of short steps.
        let mut order = 0.0;
        for pair in steps.windows(2) {
            let (coarse, fine) = (errors(pair[0]), errors(pair[1]));
            if fine < 1e-12 {
                break;
            }
            order = (coarse / fine).ln() / (pair[1] as f64 / pair[0] as f64).ln();
        }
        println!("{:20} {claimed} {order:.2}", method.name());
        if order < f64::from(claimed) - 0.35 {
            self.0.push(format!("{}: order {order:.2}", method.name()));
        }
    }
}

#[test]
fn every_table_of_the_catalogue_has_its_order() {
    let mut orders = Orders(vec![], end(heavy(), BlanesMoanSrkn14a, 2.0, 200));
    catalogue::separable(&mut orders);
    catalogue::quadratic_kinetic(&mut orders);
    catalogue::force_gradient(&mut orders);
    catalogue::principal_axes(&mut orders);
    assert!(orders.0.is_empty(), "{:#?}", orders.0);
}

/// The control: rotations in place of the exact drift have order 2 in a table of order 4.
#[test]
fn five_rotations_would_cost_a_table_its_order() {
    let system = heavy();
    let error_with = |n: u64, rotations: bool| {
        let (table, h) = (&BlanesMoan4, 5.0 / n as f64);
        let (outer, last, inner) = table.coefficients();
        let (_, [mut r, mut m], ()) = geoint_runtime::space::Snapshot::parts(start());
        let kick = |w: f64, r: &mut [[f64; 4]; 1], m: &mut [[f64; 4]; 1]| {
            system.kick(&Separable::prepare_kick(&system, w * h), 0.0, r, m, &mut ());
        };
        for _ in 0..n {
            for (outer, inner) in outer.iter().zip(inner) {
                kick(*outer, &mut r, &mut m);
                let drift = Separable::prepare_drift(&system, inner * h);
                if rotations {
                    system.rotate(&drift, &mut r, &mut m);
                } else {
                    system.drift(&drift, 0.0, &mut r, &mut m, &mut ());
                }
            }
            kick(last, &mut r, &mut m);
        }
        error(&geoint_runtime::space::Snapshot::of(5.0, [r, m], ()), HEAVY)
    };
    for (rotations, expected) in [(false, [2.964e-7, 1.849e-8, 1.155e-9]), (true, [7.3e-4, 1.8e-4, 4.6e-5])] {
        let errors = [25, 50, 100].map(|n| error_with(n, rotations));
        println!("{rotations} {errors:?}");
        for (error, expected) in errors.iter().zip(expected) {
            assert!((error / expected - 1.0).abs() < 0.03, "{errors:?}");
        }
        let order = (errors[1] / errors[2]).log2();
        assert!((order - if rotations { 2.0 } else { 4.0 }).abs() < 0.05, "order {order:.3}");
    }
}
