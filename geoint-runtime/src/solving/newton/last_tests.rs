//! Which correction is the last one, and what it leaves.

use super::{Found, Newton};
use crate::solving::equation::{Observer, StepEquation};

/// How often an equation was evaluated.
#[derive(Default)]
struct Counted(u32);

impl Observer for Counted {
    fn pause(&mut self, _: bool) {}
}

/// x = a + cx² beside something large. The guess misses by what the eleven increments were rounded by, some 10⁻⁵.
#[derive(Clone, Copy)]
struct Bent<const SETTLED: bool>(f64);

const ORIGIN: f32 = 30.0;
const C: f64 = 0.03;

impl<const SETTLED: bool> Bent<SETTLED> {
    fn solution(&self) -> f64 {
        2.0 * self.0 / (1.0 + (1.0 - 4.0 * C * self.0).sqrt())
    }
}

impl<const SETTLED: bool> StepEquation<[f32; 1], Counted> for Bent<SETTLED> {
    const PATIENT: bool = false;
    const SETTLED: bool = SETTLED;

    fn origin(&self) -> [f32; 1] {
        [ORIGIN]
    }
    fn explicit(&self) -> [f32; 1] {
        [self.0 as f32]
    }
    fn evaluate(&self, counted: &mut Counted, [x]: &[f32; 1], matrix: &mut [[f32; 1]; 1]) -> [f32; 1] {
        [*x - self.residual_at(counted, &[*x], &[*x], matrix)[0]]
    }
    fn residual_at(&self, counted: &mut Counted, [x]: &[f32; 1], _: &[f32; 1], matrix: &mut [[f32; 1]; 1]) -> [f32; 1] {
        counted.0 += 1;
        let x = f64::from(*x);
        *matrix = [[(1.0 - 2.0 * C * x) as f32]];
        [(x - self.0 - C * x * x) as f32]
    }
}

/// Evaluations of so many steps, and the largest error of a solution that carries what it rounds off.
fn run<const SETTLED: bool>(steps: u32) -> (u32, f64) {
    let (mut newton, mut counted, mut worst) = (Newton::<[f32; 1]>::new(1, 1), Counted::default(), 0.0_f64);
    for n in 0..steps {
        let equation = Bent::<SETTLED>(1.5 + (0.05 * f64::from(n)).sin());
        let Found { x: [x], lost: [lost], outcome } = newton.solve(&equation, &mut counted);
        assert!(outcome.is_ok());
        worst = worst.max((f64::from(x) + f64::from(lost) - equation.solution()).abs());
    }
    (counted.0, worst)
}

#[test]
fn where_steps_are_settled_a_correction_may_leave_a_thousandth_of_the_last_digit() {
    let [(settled, left), (exact, nothing)] = [run::<true>(1000), run::<false>(1000)];
    assert!(settled < 1100 && exact > 1800, "evaluations: {settled} and {exact}");
    let last_digit = f64::from(f32::EPSILON * ORIGIN);
    assert!(left < last_digit / 1024.0, "{left:.1e}");
    assert!(nothing < 0.1 * left, "{nothing:.1e} and {left:.1e}");
}
