//! Corrections by two terms of a series, where no more of them counts.

use super::{Found, Newton};
use crate::solving::linear;
use crate::space::vector::sum;
use crate::space::{Array, Square};

impl<A: Array> Newton<A> {
    /// Returns the guess corrected by two terms, if this correction is the last one and the third term is below rounding. `matrix` may then lack
    /// terms of the order of its square. The size of the correction matters: across a bend of the energy the matrix is another one, and a correction
    /// over the bend is wrong however small its second term is. One unknown is corrected by a reciprocal.
    #[inline(always)]
    pub(super) fn by_series(&mut self, guess: A, first: &A, matrix: &Square<A>) -> Option<Found<A>> {
        let second = linear::second_term(matrix, first);
        self.iteration.by_series = self.iteration.is_last_term(&second);
        // A correction that is too large for one step need not be in the next.
        let is_last = self.iteration.by_series && self.iteration.is_last_if_settled(first);
        is_last.then(|| Found::corrected(guess, &sum(first, &second)))
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Found, Newton};
    use crate::solving::equation::{Observer, StepEquation};

    /// How often an equation was evaluated: with its derivative, and with part of it.
    #[derive(Default)]
    struct Counted([u32; 2]);

    impl Observer for Counted {
        fn pause(&mut self, _: bool) {}
    }

    /// xᵢ = aᵢ + b xᵢ₊₁ beside something large, as the impulses of many short steps are.
    #[derive(Clone, Copy)]
    struct Chain {
        a: f64,
        b: f64,
    }

    impl Chain {
        fn constant(&self, i: usize) -> f64 {
            self.a * (1.0 + i as f64 / 3.0)
        }

        /// Σ bᵏ aᵢ₊ₖ, over whole rounds of a ring.
        fn solution(&self, i: usize) -> f64 {
            let round: f64 = (0..4).map(|k| self.b.powi(k as i32) * self.constant((i + k) % 4)).sum();
            round / (1.0 - self.b.powi(4))
        }

        fn image(&self, x: &[f32; 4]) -> [f32; 4] {
            core::array::from_fn(|i| (self.constant(i) + self.b * f64::from(x[(i + 1) % 4])) as f32)
        }

        /// 1 − A, and what of it may be missing.
        fn matrix(&self, missing: f64) -> [[f32; 4]; 4] {
            core::array::from_fn(|i| {
                let mut row = [0.0; 4];
                row[i] = 1.0;
                row[(i + 1) % 4] = -self.b as f32;
                row[(i + 2) % 4] = (missing * self.b * self.b) as f32;
                row
            })
        }
    }

    impl StepEquation<[f32; 4], Counted> for Chain {
        const PATIENT: bool = false;
        const SETTLED: bool = true;
        const NEARLY: bool = true;

        fn origin(&self) -> [f32; 4] {
            [100.0; 4]
        }
        fn explicit(&self) -> [f32; 4] {
            self.image(&[0.0; 4])
        }
        fn evaluate(&self, counted: &mut Counted, x: &[f32; 4], matrix: &mut [[f32; 4]; 4]) -> [f32; 4] {
            counted.0[0] += 1;
            *matrix = self.matrix(0.0);
            self.image(x)
        }
        fn nearly(&self, counted: &mut Counted, x: &[f32; 4], matrix: &mut [[f32; 4]; 4]) -> [f32; 4] {
            counted.0[1] += 1;
            *matrix = self.matrix(1.0);
            self.image(x)
        }
    }

    #[test]
    fn a_matrix_that_lacks_its_square_is_enough_for_two_terms() {
        let (mut newton, mut counted) = (Newton::<[f32; 4]>::new(1, 4), Counted::default());
        let mut largest = 0.0_f64;
        for n in 0..1000 {
            let phase = 0.01 * f64::from(n);
            let equation = Chain { a: 1.5 + phase.sin(), b: 0.01 * phase.cos() };
            let Found { x, lost, outcome } = newton.solve(&equation, &mut counted);
            assert!(outcome.is_ok());
            for i in 0..4 {
                let exact = equation.solution(i);
                largest = largest.max((f64::from(x[i]) + f64::from(lost[i]) - exact).abs());
            }
        }
        // Of numbers near 100 the last digit is 8e-6; that of the image is 2e-7.
        assert!(largest < 1e-6, "{largest:.1e}");
        let [whole, part] = counted.0;
        assert!(part > 900 && whole < 100, "{whole} and {part}");
    }

    #[test]
    fn where_two_terms_are_not_enough_the_whole_matrix_is_asked() {
        let (mut newton, mut counted) = (Newton::<[f32; 4]>::new(1, 4), Counted::default());
        for n in 0..1000 {
            let equation = Chain { a: if n % 2 == 0 { 1.0 } else { 3.0 }, b: 0.1 };
            let Found { x, lost, outcome } = newton.solve(&equation, &mut counted);
            assert!(outcome.is_ok());
            for i in 0..4 {
                let found = f64::from(x[i]) + f64::from(lost[i]);
                assert!((found - equation.solution(i)).abs() < 1e-6, "step {n}: {found}");
            }
        }
        let [whole, part] = counted.0;
        assert!(whole >= 1000 && part < 100, "{whole} and {part}");
    }
}
