//! Tests Newton's iteration on x = a + b x + c x² with the origin 100. The unknown is small beside its origin, as an impulse is beside a momentum. Limit: the
//! unknowns are not coupled; `linear_tests.rs` tests eliminations.

use super::equation::{Effort, Solution, Solver, StepEquation, Units};
use super::newton::{MOST_UNKNOWNS, Newton};
use super::{Failure, Observer};
use crate::space::Array;

/// Counts evaluations with a derivative (`residuals`) and without (`images`).
#[derive(Default)]
struct Count {
    residuals: u32,
    images: u32,
}

impl Observer for Count {
    fn pause(&mut self, _: bool) {}
}

/// The equation x = a + b x + c x² for each unknown.
#[derive(Clone, Copy)]
struct Curved {
    a: f64,
    b: f64,
    c: f64,
}

impl Curved {
    fn right_side(&self, x: f64) -> f64 {
        self.a + x * (self.b + self.c * x)
    }
}

impl<const N: usize> StepEquation<[f64; N], Count> for Curved
where
    [f64; N]: Array<Real = f64, Map<[f64; N]> = [[f64; N]; N]>,
{
    const EFFORT: Effort = Effort::Fast;

    fn origin(&self) -> [f64; N] {
        [100.0; N]
    }
    fn guess(&self) -> [f64; N] {
        [self.a; N]
    }
    fn residual(&self, count: &mut Count, x: &[f64; N], matrix: &mut [[f64; N]; N]) -> [f64; N] {
        count.residuals += 1;
        *matrix = [[0.0; N]; N];
        for i in 0..N {
            matrix[i][i] = 1.0 - self.b - 2.0 * self.c * x[i];
        }
        x.map(|x| x - self.right_side(x))
    }
    fn image(&self, count: &mut Count, x: &[f64; N]) -> [f64; N] {
        count.images += 1;
        x.map(|x| self.right_side(x))
    }
}

/// Returns the solution that is 0 for a = 0.
fn solution(Curved { a, b, c }: Curved) -> f64 {
    let p = 1.0 - b;
    2.0 * a / (p + (p * p - 4.0 * a * c).sqrt())
}

/// Returns the equation of step n, whose coefficients oscillate with 0.05 rad per step.
fn slowly_changing(n: u32) -> Curved {
    let phase = 0.05 * f64::from(n);
    Curved { a: 1.5 + phase.sin(), b: 0.1 * phase.cos(), c: 0.01 }
}

/// The predictor has its eleven terms after step 10. Step 11, the first one with an extrapolated guess, evaluates twice.
const LAST_OF_START: u32 = 11;

#[test]
fn extrapolated_guesses_need_one_evaluation() {
    let (mut newton, mut count) = (Newton::<[f64; 1]>::new(Units { alike: 1, kinds: 1 }), Count::default());
    for n in 0..1000 {
        let equation = slowly_changing(n);
        let Solution { x, rounding_error, .. } = newton.solve(&equation, &mut count).expect("a solution");
        let error = x[0] + rounding_error[0] - solution(equation);
        assert!(error.abs() < 2e-15, "step {n}: {error:e}");
        if n == LAST_OF_START {
            count = Count::default();
        }
    }
    // Of the steps after the start, 15 are multiples of 64 and evaluate twice.
    assert_eq!(count.residuals, 999 - LAST_OF_START + 15);
}

#[test]
fn many_unknowns_are_solved_without_a_matrix() {
    const N: usize = MOST_UNKNOWNS + 4;
    let (mut newton, mut count) = (Newton::<[f64; N]>::new(Units { alike: N, kinds: 1 }), Count::default());
    for n in 0..100 {
        let equation = slowly_changing(n);
        let Solution { x, .. } = newton.solve(&equation, &mut count).expect("a solution");
        // Without the rounding error of the last correction, the digits of the origin limit x.
        assert!(x.iter().all(|x| (x - solution(equation)).abs() < 1e-14), "step {n}");
    }
    assert!(count.residuals == 0 && count.images > 100);
}

/// x = g(x) = a + 3x has one solution, and 1 − g' = −2. With one unknown the determinant is negative: the solution is not reached from x = 0 as the right side
/// grows from 0. With two unknowns it is (−2)², so the solution is accepted: a limit of the test of the sign.
#[test]
fn solutions_with_a_negative_determinant_are_refused() {
    let found = Newton::<[f64; 2]>::new(Units { alike: 1, kinds: 2 })
        .solve(&Curved { a: 1.0, b: 3.0, c: 0.0 }, &mut Count::default());
    assert!(found.is_ok(), "the determinant of two unknowns is positive");
    let found = Newton::<[f64; 1]>::new(Units { alike: 1, kinds: 1 })
        .solve(&Curved { a: 1.0, b: 3.0, c: 0.0 }, &mut Count::default());
    assert_eq!(found.map(|found| found.x), Err(Failure::Singular));
}

#[test]
fn equations_without_a_solution_are_refused() {
    let found = Newton::<[f64; 1]>::new(Units { alike: 1, kinds: 1 })
        .solve(&Curved { a: 1.0, b: 0.0, c: 1.0 }, &mut Count::default());
    assert!(found.is_err());
}
