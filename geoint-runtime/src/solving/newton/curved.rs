//! An equation of one unknown, to try corrections with.

use crate::solving::equation::{Observer, StepEquation};

/// How often an equation was evaluated.
pub(super) struct Count(pub(super) u32);

impl Observer for Count {
    fn pause(&mut self, _: bool) {}
}

/// x = a + bx + cx² beside something large, as the impulses of short steps are beside a momentum.
#[derive(Clone, Copy)]
pub(super) struct Curved {
    pub(super) a: f64,
    pub(super) b: f64,
    pub(super) c: f64,
}

impl Curved {
    fn right_side(&self, x: f32) -> f64 {
        self.a + f64::from(x) * (self.b + self.c * f64::from(x))
    }

    fn derivative(&self, x: f32) -> [[f32; 1]; 1] {
        [[(1.0 - self.b - 2.0 * self.c * f64::from(x)) as f32]]
    }
}

impl StepEquation<[f32; 1], Count> for Curved {
    const PATIENT: bool = false;
    const SETTLED: bool = true;

    fn origin(&self) -> [f32; 1] {
        [100.0]
    }
    fn explicit(&self) -> [f32; 1] {
        [self.a as f32]
    }
    fn evaluate(&self, count: &mut Count, [x]: &[f32; 1], matrix: &mut [[f32; 1]; 1]) -> [f32; 1] {
        count.0 += 1;
        *matrix = self.derivative(*x);
        [self.right_side(*x) as f32]
    }
    fn residual_at(&self, count: &mut Count, [x]: &[f32; 1], _: &[f32; 1], matrix: &mut [[f32; 1]; 1]) -> [f32; 1] {
        count.0 += 1;
        *matrix = self.derivative(*x);
        [(f64::from(*x) - self.right_side(*x)) as f32]
    }
}
