//! A number that counts its operations. The count covers every operation that a step executes, whatever code emitted it.

use super::{arithmetic, compared};
use core::cell::Cell;
use geoint_runtime::Real;

thread_local! {
    static TALLY: Cell<Tally> = const { Cell::new(Tally { arithmetic: 0, divisions: 0, functions: 0 }) };
}

/// How much has been done.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Sums, differences, products.
    pub arithmetic: u64,
    /// Quotients and roots.
    pub divisions: u64,
    /// Other functions; a sine with its cosine counts as two.
    pub functions: u64,
}

impl Tally {
    /// Counts the operations of `run` on this thread.
    pub fn during(run: impl FnOnce()) -> Tally {
        let before = TALLY.get();
        run();
        let after = TALLY.get();
        Tally {
            arithmetic: after.arithmetic - before.arithmetic,
            divisions: after.divisions - before.divisions,
            functions: after.functions - before.functions,
        }
    }

    /// Returns the operations in units of a sum: a quotient counts ten, a function twenty. The weight is for comparisons and is no measurement.
    pub fn weight(self) -> u64 {
        self.arithmetic + 10 * self.divisions + 20 * self.functions
    }
}

/// A number.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Tallied(f64);

impl Tallied {
    /// The number.
    pub fn value(self) -> f64 {
        self.0
    }
}

impl From<f64> for Tallied {
    fn from(x: f64) -> Self {
        Tallied(x)
    }
}

fn add(x: f64) -> Tallied {
    TALLY.set(Tally { arithmetic: TALLY.get().arithmetic + 1, ..TALLY.get() });
    Tallied(x)
}

fn divide(x: f64) -> Tallied {
    TALLY.set(Tally { divisions: TALLY.get().divisions + 1, ..TALLY.get() });
    Tallied(x)
}

fn call(x: f64) -> Tallied {
    TALLY.set(Tally { functions: TALLY.get().functions + 1, ..TALLY.get() });
    Tallied(x)
}

arithmetic! { Tallied:
    Add::add, AddAssign::add_assign = |a, b| add(a.0 + b.0);
    Sub::sub, SubAssign::sub_assign = |a, b| add(a.0 - b.0);
    Mul::mul, MulAssign::mul_assign = |a, b| add(a.0 * b.0);
    Div::div, DivAssign::div_assign = |a, b| divide(a.0 / b.0);
}

impl core::ops::Neg for Tallied {
    type Output = Self;
    fn neg(self) -> Self {
        Tallied(-self.0)
    }
}

macro_rules! functions {
    ($count:ident: $($function:ident($($y:ident)?)),*) => { $(
        fn $function(self $(, $y: Self)?) -> Self {
            $count(self.0.$function($($y.0)?))
        }
    )* };
}

impl Real for Tallied {
    compared!();
    fn from_f64(x: f64) -> Self {
        Tallied(x)
    }
    fn magnitude(self) -> f64 {
        self.0.abs()
    }
    fn any_below(self, bound: f64) -> bool {
        self.0 < bound
    }
    fn smallest() -> f64 {
        f64::MIN_POSITIVE
    }
    fn epsilon() -> f64 {
        f64::EPSILON
    }
    fn abs(self) -> Self {
        Tallied(self.0.abs())
    }
    fn min(self, y: Self) -> Self {
        Tallied(self.0.min(y.0))
    }
    fn max(self, y: Self) -> Self {
        Tallied(self.0.max(y.0))
    }
    fn signum(self) -> Self {
        Tallied(self.0.signum())
    }
    functions!(divide: sqrt());
    functions!(call: cbrt(), hypot(y), sin(), cos(), tan(), asin(), acos(), atan(), atan2(y), sinh(), cosh(), tanh(), asinh(), acosh(),
        atanh(), exp(), exp2(), exp_m1(), ln(), ln_1p(), log2(), log10(), powf(y));
}
