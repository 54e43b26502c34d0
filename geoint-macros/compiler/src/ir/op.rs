//! Comparisons and functions. One table holds the names, arities, domains and values of all functions. Sums, products and powers are nodes of their own.

/// A comparison of two numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Relation {
    Less,
    LessEqual,
    Equal,
}

impl Relation {
    /// Returns whether the relation holds between `a` and `b`.
    pub(crate) fn holds<T: PartialOrd>(self, a: T, b: T) -> bool {
        match self {
            Relation::Less => a < b,
            Relation::LessEqual => a <= b,
            Relation::Equal => a == b,
        }
    }
}

/// The symmetry of a function of one argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Parity {
    Odd,
    Even,
    Neither,
}

/// The domain of a function.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Domain {
    Everywhere,
    /// The first argument lies in this interval. The value at an end may exist, as for asin, or not, as for ln; the derivative there is not finite. The text names
    /// an argument outside of the interval. `analyze/poles` knows the poles of tan.
    Interval(f64, f64, &'static str),
}

/// The row of a function in the table.
pub(crate) struct Entry {
    pub(crate) function: Function,
    /// The name of the method of `f64` and of `Real`, or of the helper in the runtime's module `slope`. Formulas in messages use the name, too.
    pub(crate) name: &'static str,
    pub(crate) arity: usize,
    pub(crate) parity: Parity,
    pub(crate) domain: Domain,
    pub(crate) value: fn(&[f64]) -> f64,
    /// Whether users may call the function. The other functions are helpers of the runtime, and the macro cannot evaluate them.
    pub(crate) public: bool,
}

/// Defines `Function`, `FUNCTIONS` and the pattern `of_steps!`. Functions of energies are separate from functions that only steps use.
macro_rules! functions {
    (energies { $($energy:ident $row:tt)* } steps { $($step:ident $step_row:tt)* }) => {
        /// A function of numbers that is neither a sum nor a product nor a power.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub(crate) enum Function { $($energy,)* $($step),* }

        /// All functions in the order of the variants.
        pub(crate) const FUNCTIONS: &[Entry] = &[$(entry!($energy $row),)* $(entry!($step $step_row)),*];

        /// The pattern of the functions that appear in divided differences and flows only. It keeps matches exhaustive.
        macro_rules! of_steps {
            () => { $($crate::ir::Function::$step)|* };
        }
        pub(crate) use of_steps;
    };
}

/// Builds the row of a function.
macro_rules! entry {
    ($function:ident ($name:ident($($arg:ident),+) $parity:ident $domain:expr $(, $value:expr)? $(=> $kind:ident)?)) => {
        Entry {
            function: Function::$function,
            name: stringify!($name),
            arity: [$(stringify!($arg)),+].len(),
            parity: Parity::$parity,
            domain: $domain,
            value: |x| {
                let [$($arg),+] = *x else { return f64::NAN };
                value!($name($($arg),+) $($value)? $($kind)?)
            },
            public: !stringify!($($value)?).is_empty(),
        }
    };
}

/// Evaluates a function at numbers.
macro_rules! value {
    // A matrix has no value.
    ($name:ident($($arg:ident),+) matrix) => {{
        let _ = ($($arg),+,);
        f64::NAN
    }};
    ($name:ident($($arg:ident),+) $value:expr) => {
        $value
    };
    // Only the runtime has the formula of a helper, and only tests can call the runtime.
    ($name:ident($($arg:ident),+)) => {{
        #[cfg(test)]
        let value = geoint_runtime::private::slope::$name($($arg),+);
        #[cfg(not(test))]
        let (value, _) = (f64::NAN, [$($arg),+]);
        value
    }};
}

use Domain::{Everywhere, Interval};
const INF: f64 = f64::INFINITY;

functions! {
    energies {
        Sin (sin(x) Odd Everywhere, x.sin())
        Cos (cos(x) Even Everywhere, x.cos())
        Tan (tan(x) Odd Everywhere, x.tan())
        Asin (asin(x) Odd Interval(-1.0, 1.0, "a number beyond ±1"), x.asin())
        Acos (acos(x) Neither Interval(-1.0, 1.0, "a number beyond ±1"), x.acos())
        Atan (atan(x) Odd Everywhere, x.atan())
        Atan2 (atan2(y, x) Neither Everywhere, y.atan2(x))
        Sinh (sinh(x) Odd Everywhere, x.sinh())
        Cosh (cosh(x) Even Everywhere, x.cosh())
        Tanh (tanh(x) Odd Everywhere, x.tanh())
        Asinh (asinh(x) Odd Everywhere, x.asinh())
        Acosh (acosh(x) Neither Interval(1.0, INF, "a number below 1"), x.acosh())
        Atanh (atanh(x) Odd Interval(-1.0, 1.0, "a number beyond ±1"), x.atanh())
        Exp (exp(x) Neither Everywhere, x.exp())
        Exp2 (exp2(x) Neither Everywhere, x.exp2())
        ExpM1 (exp_m1(x) Neither Everywhere, x.exp_m1())
        Ln (ln(x) Neither Interval(0.0, INF, "a number that is not positive"), x.ln())
        Ln1p (ln_1p(x) Neither Interval(-1.0, INF, "a number that is not above -1"), x.ln_1p())
        Log2 (log2(x) Neither Interval(0.0, INF, "a number that is not positive"), x.log2())
        Log10 (log10(x) Neither Interval(0.0, INF, "a number that is not positive"), x.log10())
        Cbrt (cbrt(x) Odd Everywhere, x.cbrt())
        Hypot (hypot(x, y) Neither Everywhere, x.hypot(y))
        Powf (powf(x, y) Neither Interval(0.0, INF, "a negative number"), x.powf(y))
        Abs (abs(x) Even Everywhere, x.abs())
        Min (min(x, y) Neither Everywhere, x.min(y))
        Max (max(x, y) Neither Everywhere, x.max(y))
        Signum (signum(x) Neither Everywhere, x.signum())
        // Helpers of the runtime's module `slope`, which states their formulas. Users cannot call them. They are here because energies contain them: projections and
        // damping put them into f.
        RecipPositive (recip_positive(x) Neither Everywhere)
        NotNegative (not_negative(x) Neither Everywhere)
        Bounded (bounded(x, y) Neither Everywhere)
        Provided (provided(x, y) Neither Everywhere)
    }
    steps {
        // All of these are helpers of the runtime's module `slope`, which states their formulas.
        // Projections.
        RecipAbove (recip_above(x, y) Neither Everywhere)
        Scaled (scaled(x, y) Neither Everywhere)
        // Divided differences.
        Root (root(x) Neither Interval(0.0, INF, "a negative number"))
        Sinc (sinc(x) Even Everywhere)
        SincDerivative (sinc_derivative(x) Odd Everywhere)
        Sinhc (sinhc(x) Even Everywhere)
        SinhcDerivative (sinhc_derivative(x) Odd Everywhere)
        Arc (arc(y, x) Neither Everywhere)
        ArcDerivative (arc_derivative(y, x) Neither Everywhere)
        ExpSlope (exp(a, b) Neither Everywhere)
        ExpSlopeDerivative (exp_derivative(a, b) Neither Everywhere)
        Exp2Slope (exp2(a, b) Neither Everywhere)
        LnSlope (ln(a, b) Neither Everywhere)
        LnSlopeDerivative (ln_derivative(a, b) Neither Everywhere)
        TanhSlope (tanh(a, b) Neither Everywhere)
        TanhSlopeDerivative (tanh_derivative(a, b) Neither Everywhere)
        PowfSlope (powf(a, b, r) Neither Everywhere)
        PowfSlopeDerivative (powf_derivative(a, b, r) Neither Everywhere)
        AbsSlope (abs(a, b) Neither Everywhere)
        AbsSlopeDerivative (abs_derivative(a, b) Neither Everywhere)
        // Exact flows.
        Phi1 (phi_1(x) Neither Everywhere)
        Phi1Derivative (phi_1_derivative(x) Neither Everywhere)
        StumpffC0 (stumpff_c0(x) Neither Everywhere)
        StumpffC1 (stumpff_c1(x) Neither Everywhere)
        StumpffC1Derivative (stumpff_c1_derivative(x) Neither Everywhere)
        DecayMean (decay_mean(r, k) Neither Everywhere)
        AtMost (at_most(x, y) Neither Everywhere)
        Rest (rest(z, change) Neither Everywhere)
        Grown (grown(x, rest, change) Neither Everywhere)
        // Linear flows in two degrees of freedom.
        SineAt (sine_at(b, c) Neither Everywhere)
        SineSlope (sine_slope(b, c) Neither Everywhere)
        CosineAt (cosine_at(b, c) Neither Everywhere)
        CosineSlope (cosine_slope(b, c) Neither Everywhere)
        // Linear flows in more degrees of freedom: exp(A) − 1, with the size of A and then, for each entry, its place and its value (the arity is the
        // least number); and a row of exp(A) − 1 times a vector.
        FlowMatrix (flow_matrix(size, place, entry) Neither Everywhere => matrix)
        FlowChange (flow_change(row, matrix, x) Neither Everywhere => matrix)
        // Motion about a centre.
        Spread (spread(x, s, kappa, square, h) Neither Everywhere)
        Swept (swept(x, s, kappa, square, h) Neither Everywhere)
        // Kepler's motion: the four results of one call.
        KeplerF (kepler_f(square, eta, speed, mu, h) Neither Everywhere)
        KeplerG (kepler_g(square, eta, speed, mu, h) Neither Everywhere)
        KeplerFRate (kepler_f_rate(square, eta, speed, mu, h) Neither Everywhere)
        KeplerGRate (kepler_g_rate(square, eta, speed, mu, h) Neither Everywhere)
    }
}

/// Pairs of functions of the same arguments that share their work, and that the runtime computes by one call.
const PARTNERS: [[Function; 2]; 10] = {
    use Function::*;
    [
        [Sin, Cos],
        [Sinc, SincDerivative],
        [Sinhc, SinhcDerivative],
        [Arc, ArcDerivative],
        [ExpSlope, ExpSlopeDerivative],
        [LnSlope, LnSlopeDerivative],
        [TanhSlope, TanhSlopeDerivative],
        [PowfSlope, PowfSlopeDerivative],
        [AbsSlope, AbsSlopeDerivative],
        [StumpffC1, StumpffC1Derivative],
    ]
};

impl Function {
    /// The functions of Kepler's motion, in the order of the results of one call.
    pub(crate) const KEPLER: [Function; 4] =
        [Function::KeplerF, Function::KeplerG, Function::KeplerFRate, Function::KeplerGRate];

    /// The functions of linear flows in two degrees of freedom.
    pub(crate) const LINEAR_FLOW: [Function; 4] =
        [Function::SineAt, Function::SineSlope, Function::CosineAt, Function::CosineSlope];

    /// Returns whether flows use the function to become NaN where they have ended, as a fall into a centre. A logarithm is NaN outside its domain,
    /// too, but no flow relies on it.
    pub(crate) fn ends_flows(self) -> bool {
        use Function::*;
        matches!(self, NotNegative | RecipPositive | AtMost | Powf | Spread | Swept) || Self::KEPLER.contains(&self)
    }

    /// Returns the function that shares the work of this function.
    pub(crate) fn partner(self) -> Option<Function> {
        let pair = PARTNERS.iter().find(|pair| pair.contains(&self))?;
        pair.iter().copied().find(|function| *function != self)
    }

    /// Returns the row of the table.
    pub(crate) fn entry(self) -> &'static Entry {
        &FUNCTIONS[self as usize]
    }

    /// Returns the function that users call as the method `name`.
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
            assert!((1..=5).contains(&entry.arity));
            let same = FUNCTIONS.iter().filter(|e| e.name == entry.name && e.public == entry.public).count();
            assert_eq!(same, 1, "{}", entry.name);
        }
    }

    #[test]
    fn parity_is_as_stated() {
        for entry in FUNCTIONS.iter().filter(|e| e.arity == 1) {
            let (plus, minus) = ((entry.value)(&[0.3]), (entry.value)(&[-0.3]));
            match entry.parity {
                // Some mathematical libraries round both sides differently.
                Parity::Odd => assert!((minus + plus).abs() < 1e-15, "{}", entry.name),
                Parity::Even => assert_eq!(minus, plus, "{}", entry.name),
                // `signum` is odd, but the table treats it as piecewise constant.
                Parity::Neither => assert!(entry.function == Function::Signum || minus != plus, "{}", entry.name),
            }
        }
    }
}
