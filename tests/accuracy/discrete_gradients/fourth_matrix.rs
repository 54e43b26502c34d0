//! The equation of a step of order 4: its matrix is its derivative, and its solution keeps the energy.

use geoint_runtime::prelude::*;
use geoint_runtime::private::{FourthOrderField, Span};
use geoint_tests::problems::{DoublePendulum, HenonHeiles};

/// The image of an increment, and the matrix there.
fn evaluated<S>(system: &S, h: f64, z: &[[f64; 2]; 2], d: &[[f64; 2]; 2]) -> ([f64; 4], [[f64; 4]; 4])
where
    S: FourthOrderField<Phase = [[f64; 2]; 2]>,
{
    let parameters = system.fourth_parameters(h);
    let begun = system.fourth_begin(&parameters, Span::of([0.0, h], h), z);
    let (mut image, mut rows) = ([[0.0; 2]; 2], [[[[0.0; 2]; 2]; 2]; 2]);
    system.fourth_slope(&parameters, &begun, d, &mut image, &mut rows);
    let (image, rows) = (image.as_flattened(), rows.as_flattened());
    let row = |i: usize| core::array::from_fn(|j| rows[i].as_flattened()[j]);
    (core::array::from_fn(|i| image[i]), core::array::from_fn(row))
}

/// The largest difference between the matrix and 1 − ∂(image)/∂d, by central difference quotients, for an increment of the size of a step.
fn difference<S: FourthOrderField<Phase = [[f64; 2]; 2]>>(system: &S, h: f64, z: &[[f64; 2]; 2]) -> f64 {
    let (d, part) = ([[0.3 * h, -0.2 * h], [0.1 * h, 0.4 * h]], 1e-5);
    let (_, matrix) = evaluated(system, h, z, &d);
    let mut largest = 0.0_f64;
    for j in 0..4 {
        let at = |distance: f64| {
            let mut moved = d;
            moved.as_flattened_mut()[j] += distance;
            evaluated(system, h, z, &moved).0
        };
        let (above, below) = (at(part), at(-part));
        for i in 0..4 {
            let expected = f64::from(u8::from(i == j)) - (above[i] - below[i]) / (2.0 * part);
            largest = largest.max((matrix[i][j] - expected).abs());
        }
    }
    largest
}

/// The matrix lacks the derivative of the metric, which is of order h³ or higher.
#[test]
fn matrices_are_derivatives() {
    fn check<S: FourthOrderField<Phase = [[f64; 2]; 2]>>(name: &str, system: &S, z: &[[f64; 2]; 2]) {
        let [long, short] = [0.1, 0.05].map(|h| difference(system, h, z));
        println!("{name}: {long:.1e} {short:.1e}");
        assert!(long < 1e-2 && short < long / 6.0, "{name}: {long:.1e} {short:.1e}");
    }
    let heiles = HenonHeiles { m: [1.3, 0.8], lambda: 1.0 };
    check("Hénon–Heiles", &heiles, &[[0.1, 0.1], [0.4, 0.2]]);
    let pendulums = DoublePendulum { m1: 1.0, m2: 0.7, l1: 1.0, l2: 0.8, g: 9.81 };
    check("double pendulum", &pendulums, &[[0.5, -0.4], [0.7, 0.3]]);
}

/// 10⁵ steps of each length keep the energy to rounding.
#[test]
fn energies() {
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
