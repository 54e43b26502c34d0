//! The equation of a step of order 4 with a matrix that is made of one Hessian.

use geoint_runtime::prelude::*;
use geoint_runtime::system::{FourthOrderField, Span};
use geoint_tests::problems::{DoublePendulum, HenonHeiles};

/// The image of an increment, and 1 − its derivative.
fn equation<S, const NEARLY: bool>(system: &S, h: f64, z: &[[f64; 2]; 2]) -> ([[f64; 2]; 2], [[f64; 4]; 4])
where
    S: FourthOrderField<Phase = [[f64; 2]; 2]>,
{
    let parameters = system.fourth_parameters(h);
    let begun = system.fourth_begin(&parameters, Span::of([0.0, h], h), z);
    let (mut d, mut rows) = ([[0.0; 2]; 2], [[[[0.0; 2]; 2]; 2]; 2]);
    for _ in 0..20 {
        let mut image = d;
        system.fourth_slope::<NEARLY>(&parameters, &begun, &d, &mut image, &mut rows);
        d = image;
    }
    let rows = rows.as_flattened();
    (d, core::array::from_fn(|i| core::array::from_fn(|j| rows[i].as_flattened()[j])))
}

/// The largest entries of A, of what is missing of it, and of the images' difference.
fn sizes<S: FourthOrderField<Phase = [[f64; 2]; 2]>>(system: &S, h: f64, z: &[[f64; 2]; 2]) -> [f64; 3] {
    let ((exact, whole), (same, part)) = (equation::<S, false>(system, h, z), equation::<S, true>(system, h, z));
    let (mut size, mut missing, mut difference) = (0.0_f64, 0.0_f64, 0.0_f64);
    for i in 0..4 {
        for j in 0..4 {
            let one = f64::from(u8::from(i == j));
            size = size.max((one - whole[i][j]).abs());
            missing = missing.max((whole[i][j] - part[i][j]).abs());
        }
        difference = difference.max((exact.as_flattened()[i] - same.as_flattened()[i]).abs());
    }
    [size, missing, difference]
}

fn lacks_its_square<S: FourthOrderField<Phase = [[f64; 2]; 2]>>(name: &str, system: &S, z: &[[f64; 2]; 2]) {
    let mut last = None;
    for h in [0.02, 0.01, 0.005] {
        let [size, missing, difference] = sizes(system, h, z);
        println!("{name}, h = {h}: {size:.2e}, {missing:.2e}");
        assert_eq!(difference, 0.0, "{name}: another image");
        assert!(missing > 0.0 && missing < 2.0 * size * size, "{name}, h = {h}: {missing:.1e} of {size:.1e}");
        if let Some(before) = last.replace(missing) {
            let factor: f64 = before / missing;
            assert!((3.5..4.5).contains(&factor), "{name}, h = {h}: {factor}");
        }
    }
}

#[test]
fn what_one_hessian_misses_is_of_the_order_of_the_square() {
    let heiles = HenonHeiles { m: [1.3, 0.8], lambda: 1.0 };
    lacks_its_square("Hénon–Heiles", &heiles, &[[0.1, 0.1], [0.4, 0.2]]);
    lacks_its_square("Hénon–Heiles, near rest", &heiles, &[[1e-4, 0.0], [0.0, 2e-4]]);
    let pendulums = DoublePendulum { m1: 1.0, m2: 0.7, l1: 1.0, l2: 0.8, g: 9.81 };
    lacks_its_square("double pendulum", &pendulums, &[[0.5, -0.4], [0.7, 0.3]]);
}

/// Steps that are corrected by a series, and others: the energy is kept by both, and so is the order between them.
#[test]
fn energies_of_steps_that_are_corrected_by_a_series() {
    let system = HenonHeiles { m: [1.0, 1.0], lambda: 1.0 };
    for h in [0.005, 0.01, 0.02, 0.05] {
        let mut sim = system.integrator(FourthOrder(DiscreteGradient), h, State::new([0.1, 0.1], [0.4, 0.2]));
        let (start, mut largest) = (sim.energy(), 0.0_f64);
        for _ in 0..100 {
            sim.advance(1000).unwrap();
            largest = largest.max((sim.energy() / start - 1.0).abs());
        }
        println!("h = {h}: {largest:.1e}");
        assert!(largest < 4e-15, "h = {h}: {largest:.1e}");
    }
}
