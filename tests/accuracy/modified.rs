//! What Störmer and Verlet's steps keep in place of the energy.

use geoint_runtime::prelude::*;
use geoint_runtime::{Coordinates, ModifiedEnergy};
use geoint_tests::measure::{distance, extrapolated};
use geoint_tests::problems::*;
use geoint_tests::scalars::Dual;

/// How far one step is from the flow of H + h²H₂, by derivatives of that.
fn defect<P: Problem>(h: f64) -> f64
where
    P::Over<f64>: geoint_runtime::Separable,
    P::Over<Dual>: ModifiedEnergy<Dual>,
{
    let start = P::initial::<f64>(0.4);
    let mut sim = P::system::<f64>().integrator(StormerVerlet, h, start);
    sim.step().unwrap();
    let system = P::system::<Dual>();
    let field = |t: f64, x: &[f64]| -> Vec<f64> {
        let n = x.len() / 2;
        let slope = |j: usize| {
            let mut x: Vec<Dual> = x.iter().map(|x| Dual::from(*x)).collect();
            x[j] = Dual::variable(x[j].value());
            let (q, p) = x.split_at(n);
            let state = State::at(Dual::from(t), coordinates(q), coordinates(p));
            system.modified_energy(Dual::from(h), &state).derivative()
        };
        (n..2 * n).map(slope).chain((0..n).map(|j| -slope(j))).collect()
    };
    distance(&flat(&sim.state()), &extrapolated(field, 0.4, flat(&start), h, 1))
}

fn coordinates<Q: Coordinates<Real = Dual>>(x: &[Dual]) -> Q {
    use geoint_runtime::array::Array;
    let mut array = Q::Array::zero();
    array.as_mut_slice().copy_from_slice(x);
    Q::from_array(array)
}

/// One step is the flow of H + h²H₂ but for h⁵, and that of H but for h³.
#[test]
fn a_step_is_a_flow() {
    fn check<P: Problem>()
    where
        P::Over<f64>: geoint_runtime::Separable,
        P::Over<Dual>: ModifiedEnergy<Dual>,
    {
        let [coarse, fine] = [0.1, 0.05].map(defect::<P>);
        let order = (coarse / fine).log2();
        println!("{:16} {coarse:.1e} {fine:.1e} {order:.2}", P::NAME);
        assert!((order - 5.0).abs() < 0.4, "{}: {order:.2}", P::NAME);
    }
    check::<HenonHeiles>();
    check::<ThreeBodies>();
    check::<Toda>();
    check::<Relativistic>();
    check::<DrivenPendulum>();
    check::<Breathing>();
}
