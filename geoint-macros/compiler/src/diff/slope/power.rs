//! Divided differences of powers with an integer or half-integer exponent: exact polynomials of both ends.

use crate::ir::formula::pow;
use crate::ir::{Function, Graph, Id, Node, Number, Ratio};

/// (xʳ)[a, b].
pub(super) fn slope(graph: &mut Graph, a: Id, b: Id, exponent: Ratio) -> Id {
    let n = exponent.numerator;
    if !exponent.is_integer() {
        // xᵐᐟ² = (√x)ᵐ and √[a, b] = 1/(√a + √b). For m > 1, xᵐᐟ² has a slope at 0, so the quotient must stay finite there.
        let [a, b] = [a, b].map(|x| if n > 1 { graph.call(Function::Root, &[x]) } else { graph.sqrt(x) });
        let sum = graph.add(a, b);
        if n == -1 {
            // −1/(ab(a + b)) takes one division instead of two.
            return graph.build(-pow(a * b * sum, Ratio::integer(-1)));
        }
        let outer = slope(graph, a, b, Ratio::integer(n));
        return graph.div(outer, sum);
    }
    if n < 0 {
        // −(x⁻ⁿ)[a, b]/(ab)⁻ⁿ
        let slope = slope(graph, a, b, Ratio::integer(-n));
        let reciprocal = reciprocal(graph, a, b);
        return graph.build(-(slope * pow(reciprocal, Ratio::integer(-n))));
    }
    match n {
        0 => graph.zero(),
        1 => graph.integer(1),
        3 => {
            let (squares, product) = (sum_of_powers(graph, a, b, Ratio::integer(2)), graph.mul(a, b));
            graph.sum(&[product, squares])
        }
        // x²ᵐ = (xᵐ)²
        _ if n % 2 == 0 => {
            let half = Ratio::integer(n / 2);
            let outer = slope(graph, a, b, half);
            let sum = sum_of_powers(graph, a, b, half);
            graph.mul(outer, sum)
        }
        // xⁿ = x·xⁿ⁻¹. Both parts are nonnegative.
        _ => {
            let even = Ratio::integer(n - 1);
            let (outer, sum) = (slope(graph, a, b, even), graph.add(a, b));
            let parts = [graph.mul(outer, sum), sum_of_powers(graph, a, b, even)];
            let twice = graph.sum(&parts);
            graph.scale(Number::HALF, twice)
        }
    }
}

/// aⁿ + bⁿ.
fn sum_of_powers(graph: &mut Graph, a: Id, b: Id, n: Ratio) -> Id {
    graph.build(pow(a, n) + pow(b, n))
}

/// 1/(ab), or NaN if there is a pole between a and b. Roots are nonnegative and need no check.
fn reciprocal(graph: &mut Graph, a: Id, b: Id) -> Id {
    let product = graph.mul(a, b);
    match graph.node(a) {
        Node::Power(_, exponent) if !exponent.is_integer() => graph.recip(product),
        _ => graph.call(Function::RecipPositive, &[product]),
    }
}
