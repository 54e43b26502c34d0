//! Operations: their names, arities, values on numbers and spelling in Rust. One table.

/// Who a number at the leaves is. Coordinates are numbered in the order in which they are stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) enum Symbol {
    /// A position.
    Q(u32),
    /// A momentum.
    P(u32),
    /// Time.
    T,
    /// A scalar of a parameter, or a constant that the macro cannot see into.
    Parameter(u32),
    /// The length of a step or flow.
    H,
    /// The increment of a position over a step.
    Dq(u32),
    /// The increment of a momentum over a step.
    Dp(u32),
}

/// How two numbers are compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Relation {
    Less,
    LessEqual,
    Equal,
}

impl Relation {
    pub(crate) fn holds(self, a: f64, b: f64) -> bool {
        match self {
            Relation::Less => a < b,
            Relation::LessEqual => a <= b,
            Relation::Equal => a == b,
        }
    }
}

/// Under negation of the argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Parity {
    Odd,
    Even,
    Neither,
}

/// Where a function is defined.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Domain {
    Everywhere,
    /// Its first argument lies in this interval (open or closed: the ends give no finite derivative).
    Interval(f64, f64, &'static str),
}

/// Everything that is known of a function.
pub(crate) struct Entry {
    pub(crate) function: Function,
    /// The method of `f64`, of `Real` and in formulas.
    pub(crate) name: &'static str,
    pub(crate) arity: usize,
    pub(crate) parity: Parity,
    pub(crate) domain: Domain,
    pub(crate) value: fn(&[f64]) -> f64,
    /// Whether users may write it.
    pub(crate) public: bool,
}

macro_rules! functions {
    ($($function:ident $name:ident($($arg:ident),+) $parity:ident $domain:expr, $visibility:ident, $value:expr;)*) => {
        /// A function of one or two numbers that is not a sum, a product or a power.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub(crate) enum Function { $($function),* }

        /// Every function once.
        pub(crate) const FUNCTIONS: &[Entry] = &[$(Entry {
            function: Function::$function,
            name: stringify!($name),
            arity: [$(stringify!($arg)),+].len(),
            parity: Parity::$parity,
            domain: $domain,
            value: |x| {
                let [$($arg),+] = *x else { return f64::NAN };
                $value
            },
            public: visibility!($visibility),
        }),*];
    };
}

macro_rules! visibility {
    (public) => {
        true
    };
    (helper) => {
        false
    };
}

use Domain::{Everywhere, Interval};
const INF: f64 = f64::INFINITY;

functions! {
    Sin sin(x) Odd Everywhere, public, x.sin();
    Cos cos(x) Even Everywhere, public, x.cos();
    Tan tan(x) Odd Everywhere, public, x.tan();
    Asin asin(x) Odd Interval(-1.0, 1.0, "a number beyond ±1"), public, x.asin();
    Acos acos(x) Neither Interval(-1.0, 1.0, "a number beyond ±1"), public, x.acos();
    Atan atan(x) Odd Everywhere, public, x.atan();
    Atan2 atan2(y, x) Neither Everywhere, public, y.atan2(x);
    Sinh sinh(x) Odd Everywhere, public, x.sinh();
    Cosh cosh(x) Even Everywhere, public, x.cosh();
    Tanh tanh(x) Odd Everywhere, public, x.tanh();
    Asinh asinh(x) Odd Everywhere, public, x.asinh();
    Acosh acosh(x) Neither Interval(1.0, INF, "a number below 1"), public, x.acosh();
    Atanh atanh(x) Odd Interval(-1.0, 1.0, "a number beyond ±1"), public, x.atanh();
    Exp exp(x) Neither Everywhere, public, x.exp();
    Exp2 exp2(x) Neither Everywhere, public, x.exp2();
    ExpM1 exp_m1(x) Neither Everywhere, public, x.exp_m1();
    Ln ln(x) Neither Interval(0.0, INF, "a number that is not positive"), public, x.ln();
    Ln1p ln_1p(x) Neither Interval(-1.0, INF, "a number that is not above -1"), public, x.ln_1p();
    Log2 log2(x) Neither Interval(0.0, INF, "a number that is not positive"), public, x.log2();
    Log10 log10(x) Neither Interval(0.0, INF, "a number that is not positive"), public, x.log10();
    Cbrt cbrt(x) Odd Everywhere, public, x.cbrt();
    Hypot hypot(x, y) Neither Everywhere, public, x.hypot(y);
    Powf powf(x, y) Neither Interval(0.0, INF, "a negative number"), public, x.powf(y);
    Abs abs(x) Even Everywhere, public, x.abs();
    Min min(x, y) Neither Everywhere, public, x.min(y);
    Max max(x, y) Neither Everywhere, public, x.max(y);
    Signum signum(x) Neither Everywhere, public, x.signum();
    Sinc sinc(x) Even Everywhere, helper, if x == 0.0 { 1.0 } else { x.sin() / x };
    RecipPositive recip_positive(x) Neither Everywhere, helper, if x > 0.0 { 1.0 / x } else { f64::NAN };
    NotNegative not_negative(x) Neither Everywhere, helper, if x < 0.0 { f64::NAN } else { x };
    Bounded bounded(x, y) Neither Everywhere, helper, if x * x > y * (1.0 + 8.0 * f64::EPSILON) { f64::NAN } else { x };
    SincDerivative sinc_derivative(x) Odd Everywhere, helper,
        if x == 0.0 { 0.0 } else { (x.cos() - x.sin() / x) / x };
    ExpSlope exp(a, b) Neither Everywhere, helper, if a == b { a.exp() } else { (b.exp() - a.exp()) / (b - a) };
    ExpSlopeDerivative exp_derivative(a, b) Neither Everywhere, helper,
        if a == b { a.exp() / 2.0 } else { (b.exp() - (b.exp() - a.exp()) / (b - a)) / (b - a) };
    LnSlope ln(a, b) Neither Everywhere, helper, if a == b { 1.0 / a } else { (b.ln() - a.ln()) / (b - a) };
    LnSlopeDerivative ln_derivative(a, b) Neither Everywhere, helper,
        if a == b { -0.5 / (a * a) } else { (1.0 / b - (b.ln() - a.ln()) / (b - a)) / (b - a) };
}

impl Function {
    pub(crate) fn entry(self) -> &'static Entry {
        &FUNCTIONS[self as usize]
    }

    /// The function that users write as the method `name`.
    pub(crate) fn of_method(name: &str) -> Option<Function> {
        FUNCTIONS.iter().find(|entry| entry.public && entry.name == name).map(|entry| entry.function)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_is_in_order_and_names_are_unique() {
        for (i, entry) in FUNCTIONS.iter().enumerate() {
            assert_eq!(entry.function as usize, i);
            assert!((1..=2).contains(&entry.arity));
            let same = FUNCTIONS.iter().filter(|e| e.name == entry.name && e.public == entry.public).count();
            assert_eq!(same, 1, "{}", entry.name);
        }
    }

    #[test]
    fn parity_is_as_stated() {
        for entry in FUNCTIONS.iter().filter(|e| e.arity == 1) {
            let (plus, minus) = ((entry.value)(&[0.3]), (entry.value)(&[-0.3]));
            match entry.parity {
                // Not every library rounds both sides alike.
                Parity::Odd => assert!((minus + plus).abs() < 1e-15, "{}", entry.name),
                Parity::Even => assert_eq!(minus, plus, "{}", entry.name),
                // Odd, but kept apart: it is constant but for the jump.
                Parity::Neither => assert!(entry.function == Function::Signum || minus != plus, "{}", entry.name),
            }
        }
    }
}
