//! Operations: their names, arities, values on numbers and spelling in Rust. One table.

/// A number at a leaf of the graph. Coordinates are numbered in the order in which they are stored. The order of the variants decides the order of
/// operations in emitted code.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) enum Symbol {
    /// A position.
    Position(u32),
    /// A momentum.
    Momentum(u32),
    /// A velocity of a Lagrangian.
    Velocity(u32),
    /// The action of a contact system.
    Action,
    /// Time.
    Time,
    /// A scalar of a parameter, or a constant that the macro cannot see into.
    Parameter(u32),
    /// The length of a step or flow.
    StepLength,
    /// The time at which a step starts.
    StepStart,
    /// The time at which a step ends. The next step starts at this time.
    StepEnd,
    /// The weight of the force gradient in a kick.
    GradientWeight,
    /// The increment of a position over a step.
    PositionIncrement(u32),
    /// The increment of a momentum over a step.
    MomentumIncrement(u32),
    /// The increment of the action over a step.
    ActionIncrement,
    /// The increment of a velocity over a step.
    VelocityIncrement(u32),
    /// The multiplier of a constraint.
    Multiplier(u32),
}

impl Symbol {
    /// Whether this is a position, a momentum, a velocity or the action.
    pub(crate) fn is_coordinate(self) -> bool {
        matches!(self, Symbol::Position(_) | Symbol::Momentum(_) | Symbol::Velocity(_) | Symbol::Action)
    }
}

/// How two numbers are compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Relation {
    Less,
    LessEqual,
    Equal,
}

impl Relation {
    pub(crate) fn holds<T: PartialOrd>(self, a: T, b: T) -> bool {
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
    /// Whether users may write it; if not, it is a helper of the runtime, and `value` is not known to the macro.
    pub(crate) public: bool,
}

macro_rules! functions {
    ($($function:ident $name:ident($($arg:ident),+) $parity:ident $domain:expr $(, $value:expr)? $(=> $kind:ident)?;)*) => {
        /// A function of numbers that is not a sum, a product or a power.
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
                value!($name($($arg),+) $($value)? $($kind)?)
            },
            public: public!($($value)?),
        }),*];
    };
}

macro_rules! value {
    // No function of numbers.
    ($name:ident($($arg:ident),+) matrix) => {{
        let _ = ($($arg),+,);
        f64::NAN
    }};
    ($name:ident($($arg:ident),+) $value:expr) => {
        $value
    };
    // The runtime has the only formula of a helper, and nothing but tests can call it.
    ($name:ident($($arg:ident),+)) => {{
        #[cfg(test)]
        let value = geoint_runtime::slope::$name($($arg),+);
        #[cfg(not(test))]
        let (value, _) = (f64::NAN, [$($arg),+]);
        value
    }};
}

macro_rules! public {
    ($value:expr) => {
        true
    };
    () => {
        false
    };
}

use Domain::{Everywhere, Interval};
const INF: f64 = f64::INFINITY;

functions! {
    Sin sin(x) Odd Everywhere, x.sin();
    Cos cos(x) Even Everywhere, x.cos();
    Tan tan(x) Odd Everywhere, x.tan();
    Asin asin(x) Odd Interval(-1.0, 1.0, "a number beyond ±1"), x.asin();
    Acos acos(x) Neither Interval(-1.0, 1.0, "a number beyond ±1"), x.acos();
    Atan atan(x) Odd Everywhere, x.atan();
    Atan2 atan2(y, x) Neither Everywhere, y.atan2(x);
    Sinh sinh(x) Odd Everywhere, x.sinh();
    Cosh cosh(x) Even Everywhere, x.cosh();
    Tanh tanh(x) Odd Everywhere, x.tanh();
    Asinh asinh(x) Odd Everywhere, x.asinh();
    Acosh acosh(x) Neither Interval(1.0, INF, "a number below 1"), x.acosh();
    Atanh atanh(x) Odd Interval(-1.0, 1.0, "a number beyond ±1"), x.atanh();
    Exp exp(x) Neither Everywhere, x.exp();
    Exp2 exp2(x) Neither Everywhere, x.exp2();
    ExpM1 exp_m1(x) Neither Everywhere, x.exp_m1();
    Ln ln(x) Neither Interval(0.0, INF, "a number that is not positive"), x.ln();
    Ln1p ln_1p(x) Neither Interval(-1.0, INF, "a number that is not above -1"), x.ln_1p();
    Log2 log2(x) Neither Interval(0.0, INF, "a number that is not positive"), x.log2();
    Log10 log10(x) Neither Interval(0.0, INF, "a number that is not positive"), x.log10();
    Cbrt cbrt(x) Odd Everywhere, x.cbrt();
    Hypot hypot(x, y) Neither Everywhere, x.hypot(y);
    Powf powf(x, y) Neither Interval(0.0, INF, "a negative number"), x.powf(y);
    Abs abs(x) Even Everywhere, x.abs();
    Min min(x, y) Neither Everywhere, x.min(y);
    Max max(x, y) Neither Everywhere, x.max(y);
    Signum signum(x) Neither Everywhere, x.signum();
    // Helpers of divided differences, in the runtime's module `slope`; users cannot write them.
    RecipPositive recip_positive(x) Neither Everywhere;
    // Of projections.
    RecipAbove recip_above(x, y) Neither Everywhere;
    Scaled scaled(x, y) Neither Everywhere;
    // Of damping.
    NotNegative not_negative(x) Neither Everywhere;
    Bounded bounded(x, y) Neither Everywhere;
    Provided provided(x, y) Neither Everywhere;
    Root root(x) Neither Interval(0.0, INF, "a negative number");
    Sinc sinc(x) Even Everywhere;
    SincDerivative sinc_derivative(x) Odd Everywhere;
    Sinhc sinhc(x) Even Everywhere;
    SinhcDerivative sinhc_derivative(x) Odd Everywhere;
    Arc arc(y, x) Neither Everywhere;
    ArcDerivative arc_derivative(y, x) Neither Everywhere;
    ExpSlope exp(a, b) Neither Everywhere;
    ExpSlopeDerivative exp_derivative(a, b) Neither Everywhere;
    Exp2Slope exp2(a, b) Neither Everywhere;
    LnSlope ln(a, b) Neither Everywhere;
    LnSlopeDerivative ln_derivative(a, b) Neither Everywhere;
    TanhSlope tanh(a, b) Neither Everywhere;
    TanhSlopeDerivative tanh_derivative(a, b) Neither Everywhere;
    PowfSlope powf(a, b, r) Neither Everywhere;
    PowfSlopeDerivative powf_derivative(a, b, r) Neither Everywhere;
    AbsSlope abs(a, b) Neither Everywhere;
    AbsSlopeDerivative abs_derivative(a, b) Neither Everywhere;
    // Of exact flows.
    Phi1 phi_1(x) Neither Everywhere;
    Phi1Derivative phi_1_derivative(x) Neither Everywhere;
    StumpffC0 stumpff_c0(x) Neither Everywhere;
    StumpffC1 stumpff_c1(x) Neither Everywhere;
    StumpffC1Derivative stumpff_c1_derivative(x) Neither Everywhere;
    DecayMean decay_mean(r, k) Neither Everywhere;
    AtMost at_most(x, y) Neither Everywhere;
    Rest rest(z, change) Neither Everywhere;
    Grown grown(x, rest, change) Neither Everywhere;
    // Of linear flows in two degrees of freedom.
    SineAt sine_at(b, c) Neither Everywhere;
    SineSlope sine_slope(b, c) Neither Everywhere;
    CosineAt cosine_at(b, c) Neither Everywhere;
    CosineSlope cosine_slope(b, c) Neither Everywhere;
    // Of linear flows in more: exp(A) − 1 of a matrix, by its size and its entries with their places, and a row of it times a vector.
    FlowMatrix flow_matrix(size, place, entry) Neither Everywhere => matrix;
    FlowChange flow_change(row, matrix, x) Neither Everywhere => matrix;
    // Of motion about a centre.
    Spread spread(x, s, kappa, square, h) Neither Everywhere;
    Swept swept(x, s, kappa, square, h) Neither Everywhere;
    // The four results of one call.
    KeplerF kepler_f(square, eta, speed, mu, h) Neither Everywhere;
    KeplerG kepler_g(square, eta, speed, mu, h) Neither Everywhere;
    KeplerFRate kepler_f_rate(square, eta, speed, mu, h) Neither Everywhere;
    KeplerGRate kepler_g_rate(square, eta, speed, mu, h) Neither Everywhere;
}

/// Functions of the same arguments that share their work.
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
    /// The functions that one call of Kepler's motion computes together, in order.
    pub(crate) const KEPLER: [Function; 4] =
        [Function::KeplerF, Function::KeplerG, Function::KeplerFRate, Function::KeplerGRate];

    /// Those of linear flows in two degrees of freedom.
    pub(crate) const LINEAR_FLOW: [Function; 4] =
        [Function::SineAt, Function::SineSlope, Function::CosineAt, Function::CosineSlope];

    /// Whether this is not a number where a flow has ended.
    pub(crate) fn ends_flows(self) -> bool {
        use Function::*;
        matches!(self, NotNegative | RecipPositive | AtMost | Powf | Spread | Swept) || Self::KEPLER.contains(&self)
    }

    /// The function that shares the work of this one.
    pub(crate) fn partner(self) -> Option<Function> {
        PARTNERS.iter().find_map(|[a, b]| match self {
            f if f == *a => Some(*b),
            f if f == *b => Some(*a),
            _ => None,
        })
    }

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
                // Not every library rounds both sides alike.
                Parity::Odd => assert!((minus + plus).abs() < 1e-15, "{}", entry.name),
                Parity::Even => assert_eq!(minus, plus, "{}", entry.name),
                // Odd, but kept apart: it is constant but for the jump.
                Parity::Neither => assert!(entry.function == Function::Signum || minus != plus, "{}", entry.name),
            }
        }
    }
}
