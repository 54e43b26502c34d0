//! The derivatives of every operation with respect to its operands: one exhaustive match for nodes, and one for functions.

use crate::ir::{Function, Graph, Id, Node, Number, Ratio, Relation};

/// The derivative of a node with respect to its operands.
#[derive(Debug)]
pub(super) enum Derivative {
    /// The change is Σ coefficient·(change of operand). The pairs are (operand, coefficient).
    Chain(Vec<(Id, Id)>),
    /// A condition and its two branches. The change is that of the branch taken.
    Branch(Id, Id, Id),
}

/// Computes the partial derivatives of a node.
pub(super) fn derivative(graph: &mut Graph, id: Id) -> Derivative {
    Derivative::Chain(match graph.node(id).clone() {
        Node::Number(_)
        | Node::Symbol(_)
        | Node::Compare(..)
        | Node::And(..)
        | Node::Or(..)
        | Node::Not(_)
        | Node::Truth(_) => vec![],
        Node::Linear(_, terms) => terms.into_iter().map(|(c, term)| (term, graph.number(c))).collect(),
        Node::Product(factors) => {
            let others = |k: usize| factors.iter().enumerate().filter(move |(i, _)| *i != k).map(|(_, id)| *id);
            (0..factors.len()).map(|k| (factors[k], graph.product(&others(k).collect::<Vec<_>>()))).collect()
        }
        Node::Power(base, exponent) => {
            // Exponents are small, so the subtraction does not overflow.
            let lower = exponent.add(Ratio::integer(-1)).unwrap_or(exponent);
            let power = graph.pow(base, lower);
            vec![(base, graph.scale(Number::Exact(exponent), power))]
        }
        Node::Call(function, args) => {
            let partials = function_partials(graph, id, function, &args);
            args.into_iter().zip(partials).collect()
        }
        Node::Select(condition, first, second) => return Derivative::Branch(condition, first, second),
    })
}

/// Computes the partial derivatives of `value = function(args)`, in the order of the arguments.
fn function_partials(g: &mut Graph, value: Id, function: Function, args: &[Id]) -> Vec<Id> {
    let (x, y) = (args[0], *args.get(1).unwrap_or(&args[0]));
    let one = g.integer(1);
    let square = |g: &mut Graph, x: Id| g.pow(x, Ratio::integer(2));
    // (1 − x)(1 + x) does not cancel near ±1, unlike 1 − x².
    let circle = |g: &mut Graph, x: Id| {
        let (minus, plus) = (g.sub(one, x), g.add(one, x));
        g.mul(minus, plus)
    };
    let inverse_sqrt = |g: &mut Graph, x: Id| g.pow(x, Ratio { numerator: -1, denominator: 2 });
    // 1/x is finite for x < 0, where a logarithm is undefined. A step would cross the boundary of the domain unnoticed.
    let recip_positive = |g: &mut Graph, x: Id| g.call(Function::RecipPositive, &[x]);
    let logarithm = |g: &mut Graph, base: f64| {
        let reciprocal = recip_positive(g, x);
        g.scale(Number::float(1.0 / base), reciprocal)
    };
    match function {
        Function::Sin => vec![g.call(Function::Cos, &[x])],
        Function::Cos => {
            let sin = g.call(Function::Sin, &[x]);
            vec![g.neg(sin)]
        }
        Function::Tan => {
            let square = square(g, value);
            vec![g.add(one, square)]
        }
        Function::Asin | Function::Acos => {
            let circle = circle(g, x);
            let slope = inverse_sqrt(g, circle);
            vec![if function == Function::Asin { slope } else { g.neg(slope) }]
        }
        Function::Atan => {
            let square = square(g, x);
            let sum = g.add(one, square);
            vec![g.recip(sum)]
        }
        Function::Atan2 => {
            // args are (y, x) of the point.
            let squares = [square(g, x), square(g, y)];
            let radius = g.sum(&squares);
            let (by_y, by_x) = (g.div(y, radius), g.div(x, radius));
            vec![by_y, g.neg(by_x)]
        }
        Function::Sinh => vec![g.call(Function::Cosh, &[x])],
        Function::Cosh => vec![g.call(Function::Sinh, &[x])],
        Function::Tanh => {
            let cosh = g.call(Function::Cosh, &[x]);
            vec![g.pow(cosh, Ratio::integer(-2))]
        }
        Function::Asinh => {
            let square = square(g, x);
            let sum = g.add(one, square);
            vec![inverse_sqrt(g, sum)]
        }
        Function::Acosh => {
            let (minus, plus) = (g.sub(x, one), g.add(x, one));
            let product = g.mul(minus, plus);
            vec![inverse_sqrt(g, product)]
        }
        Function::Atanh => {
            let circle = circle(g, x);
            vec![recip_positive(g, circle)]
        }
        Function::Exp => vec![value],
        Function::Exp2 => vec![g.scale(Number::float(std::f64::consts::LN_2), value)],
        Function::ExpM1 => vec![g.call(Function::Exp, &[x])],
        Function::Ln => vec![recip_positive(g, x)],
        Function::Ln1p => {
            let sum = g.add(one, x);
            vec![recip_positive(g, sum)]
        }
        Function::Log2 => vec![logarithm(g, std::f64::consts::LN_2)],
        Function::Log10 => vec![logarithm(g, std::f64::consts::LN_10)],
        Function::Cbrt => {
            let power = g.pow(value, Ratio::integer(-2));
            vec![g.scale(Number::integer(3).pow(Ratio::integer(-1)).unwrap_or(Number::ONE), power)]
        }
        Function::Hypot => vec![g.div(x, value), g.div(y, value)],
        Function::Powf => {
            let lower = g.sub(y, one);
            let power = match g.as_number(lower) {
                Some(Number::Exact(ratio)) if ratio.denominator <= 2 => g.pow(x, ratio),
                _ => g.call(Function::Powf, &[x, lower]),
            };
            let ln = g.call(Function::Ln, &[x]);
            vec![g.mul(y, power), g.mul(value, ln)]
        }
        Function::Abs => vec![g.call(Function::Signum, &[x])],
        Function::Min | Function::Max => {
            let zero = g.zero();
            let [low, high] = if function == Function::Min { [x, y] } else { [y, x] };
            let first = g.compare(Relation::LessEqual, low, high);
            vec![g.select(first, one, zero), g.select(first, zero, one)]
        }
        Function::Signum => vec![g.zero()],
        Function::RecipPositive => {
            let square = square(g, value);
            vec![g.neg(square)]
        }
        Function::RecipAbove => {
            let square = square(g, value);
            vec![g.neg(square), g.zero()]
        }
        Function::Scaled => vec![g.call(Function::Scaled, &[one, y]), g.zero()],
        // The other arguments are conditions.
        Function::NotNegative => vec![one],
        Function::Bounded | Function::AtMost | Function::Provided => vec![one, g.zero()],
        // Grown is x·eᶻ with change = eᶻ − 1. Its argument `change` carries the dependence on z.
        Function::Rest => vec![g.zero(), g.zero()],
        Function::Grown => vec![g.call(Function::Grown, &[one, y, args[2]]), g.zero(), x],
        Function::Root => {
            let reciprocal = g.recip(value);
            vec![g.scale(Number::HALF, reciprocal)]
        }
        Function::Sinc => vec![g.call(Function::SincDerivative, &[x])],
        Function::Sinhc => vec![g.call(Function::SinhcDerivative, &[x])],
        Function::Arc => {
            // args are (y, x) of the point.
            let squares = [square(g, x), square(g, y)];
            let radius = g.sum(&squares);
            let by_x = g.recip(radius);
            vec![g.call(Function::ArcDerivative, &[x, y]), g.neg(by_x)]
        }
        Function::ExpSlope => slope_partials(g, Function::ExpSlopeDerivative, args),
        // 2ˣ = exp(x ln 2).
        Function::Exp2Slope => {
            let ln_2 = Number::float(std::f64::consts::LN_2);
            let ends = [g.scale(ln_2, x), g.scale(ln_2, y)];
            let partials = slope_partials(g, Function::ExpSlopeDerivative, &ends);
            partials.into_iter().map(|partial| g.scale(ln_2.mul(ln_2), partial)).collect()
        }
        Function::LnSlope => slope_partials(g, Function::LnSlopeDerivative, args),
        Function::TanhSlope => slope_partials(g, Function::TanhSlopeDerivative, args),
        // Only the ends vary: the exponent is constant.
        Function::PowfSlope => slope_partials(g, Function::PowfSlopeDerivative, args),
        Function::AbsSlope => slope_partials(g, Function::AbsSlopeDerivative, args),
        // (|a| − a sgn b)/(|a| + |b|)² is a part of the slope of `signum`.
        Function::AbsSlopeDerivative => {
            let [sizes, signs] = [Function::Abs, Function::Signum].map(|f| [x, y].map(|end| g.call(f, &[end])));
            let size = g.sum(&sizes);
            let jump = g.sub(signs[0], signs[1]);
            let jump = g.div(jump, size);
            let [by_a, by_b] = signs.map(|sign| {
                let product = g.mul(sign, value);
                g.scale(Number::integer(-2), product)
            });
            let by_a = g.add(by_a, jump);
            vec![g.div(by_a, size), g.div(by_b, size)]
        }
        Function::Phi1 => vec![g.call(Function::Phi1Derivative, &[x])],
        Function::StumpffC0 => {
            let sine = g.call(Function::StumpffC1, &[x]);
            vec![g.scale(Number::HALF.neg(), sine)]
        }
        Function::StumpffC1 => vec![g.call(Function::StumpffC1Derivative, &[x])],
        Function::SineAt
        | Function::SineSlope
        | Function::CosineAt
        | Function::CosineSlope
        | Function::FlowMatrix
        | Function::FlowChange
        | Function::Spread
        | Function::Swept
        | Function::KeplerF
        | Function::KeplerG
        | Function::KeplerFRate
        | Function::KeplerGRate
        | Function::DecayMean
        | Function::Phi1Derivative
        | Function::StumpffC1Derivative
        | Function::SincDerivative
        | Function::SinhcDerivative
        | Function::ArcDerivative
        | Function::ExpSlopeDerivative
        | Function::LnSlopeDerivative
        | Function::TanhSlopeDerivative
        | Function::PowfSlopeDerivative => {
            unreachable!("divided differences and flows are differentiated once")
        }
    }
}

/// The partial derivatives of f[a, b]. By f[a, b] = f[b, a], one helper gives both.
fn slope_partials(g: &mut Graph, derivative: Function, args: &[Id]) -> Vec<Id> {
    let mut swapped = args.to_vec();
    swapped.swap(0, 1);
    vec![g.call(derivative, &swapped), g.call(derivative, args)]
}
