//! Is what is left of x − g(x), where corrections do not shrink any more, rounding?

use super::iteration::Iteration;
use crate::solving::equation::{Observer, StepEquation};
use crate::solving::noise;
use crate::solving::rounding::is_of_last_digits;
use crate::space::{Array, Square};

impl<A: Array> Iteration<A> {
    /// Whether what is left of x − g(x) follows from the last digits of coordinates. Of copies: what is pointed at would be in memory in all iterations.
    #[cold]
    #[inline(never)]
    pub(super) fn is_of_last_digits(&self, origin: A, left: A, matrix: Square<A>) -> bool {
        let mut sizes = self.sizes;
        // Without x: far from where the system has been, all may be rounding.
        sizes.include(&origin, &A::zero());
        is_of_last_digits(&sizes, &left, &matrix)
    }

    /// Whether what is left of x − g(x) is rounding.
    #[cold]
    #[inline(never)]
    pub(super) fn is_noise<W: Observer + ?Sized, E: StepEquation<A, W>>(
        &self,
        x: A,
        (delta, farther): (A, f64),
        equation: E,
        watch: &mut W,
    ) -> bool {
        let mut unused = A::fill(A::zero());
        let mut sizes = self.sizes;
        sizes.include(&equation.origin(), &x);
        watch.pause(true);
        let residual = |x: &A| Some(equation.residual(watch, x, &mut unused));
        let noise = noise::measure(&sizes, &x, (&delta, farther), self.kinds, residual);
        watch.pause(false);
        // Here last: who watches has seen the solution last.
        noise::explains(&noise, &equation.residual(watch, &x, &mut unused), &sizes)
    }
}
