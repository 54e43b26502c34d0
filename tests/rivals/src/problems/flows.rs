//! A free body.

use super::{AT_THE_END, Problem, Way, adaptive, by_hand, ours, reference, taylors};
use crate::by_hand::free_body::FreeBody;
use crate::field::Field;
use crate::rivals::{Seen, of_field};
use crate::systems::FreeMomentum;
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_tests::scalars::Scalar;
use std::hint::black_box;

const INERTIA: [f64; 3] = [1.0, 2.0, 3.0];

#[derive(Clone, Copy)]
struct Top;

impl Field<3> for Top {
    fn start(&self) -> [f64; 3] {
        [0.5, 1.6, -1.2]
    }
    fn rate<R: Scalar>(_: R, m: &[R; 3], dm: &mut [R; 3]) {
        let w: [R; 3] = std::array::from_fn(|i| m[i] / R::from_f64(INERTIA[i]));
        *dm = [m[1] * w[2] - m[2] * w[1], m[2] * w[0] - m[0] * w[2], m[0] * w[1] - m[1] * w[0]];
    }
}

pub(super) fn euler_top() -> Problem {
    let (duration, system) = (200.0, FreeMomentum { inertia: INERTIA });
    let (judge, reference) = reference(Top, duration, 3.0);
    let way = Way::new(FlowState::new(Top.start()), duration);
    let mut entries = vec![];
    ours! { entries, system, way;
        "rotations" from 500: PoissonSplitting, BlanesMoan4X.of(PoissonSplitting), KahanLi8_17a.of(PoissonSplitting),
            SofroniouSpaletta10_35.of(PoissonSplitting);
        "planes" from 500: PlanarSplitting, KahanLi8_17a.of(PlanarSplitting);
        "Gauss" from 200: Gauss::<2>, Gauss::<3>, Gauss::<4>, Gauss::<6>;
        "integrals kept" from 300: DiscreteGradient, FourthOrder(DiscreteGradient);
        "Runge–Kutta" from 200: DOP853;
    }
    entries.push(adaptive((system, DOP853), way));
    entries.extend(taylors(system, way));
    let (from, list) = (Way::new(Top.start(), duration), |m: [f64; 3]| m.to_vec());
    entries.push(by_hand("DiscreteGradient", 300, from, list, move |h, n, m| {
        FreeBody { inertia: black_box(INERTIA) }.discrete_gradient::<true>(h, n, m)
    }));
    entries.extend(of_field(Top, duration, Seen::End));
    let note = "moments 1, 2, 3, angular momentum (0.5, 1.6, −1.2), T = 200".into();
    Problem { name: "euler_top", title: "Euler's top", note, duration, measured: AT_THE_END, reference, entries, judge }
}
