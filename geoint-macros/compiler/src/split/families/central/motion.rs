//! The motion of y in its plane, as a function of |y|², y·y' and |y'|².

use super::super::super::scalar::{Angle, rotation};
use super::centre::Form;
use crate::ir::{Function, Graph, Id, Number, Ratio, Symbol};

/// The flow of y: y(h) = F y + G y', y'(h) = Ḟ y + Ġ y'.
pub(super) struct Motion {
    /// F − 1.
    pub(super) f: Id,
    /// G.
    pub(super) g: Id,
    /// Ḟ.
    pub(super) f_rate: Id,
    /// Ġ − 1.
    pub(super) g_rate: Id,
}

/// A centre and the start of the motion about it.
pub(super) struct Start<'a> {
    /// The index of the centre.
    pub(super) number: usize,
    pub(super) lambda: Id,
    /// λg.
    pub(super) strength: Id,
    pub(super) forms: &'a [Form],
    pub(super) y: Vec<Id>,
    /// y'.
    pub(super) v: Vec<Id>,
    /// |y|².
    pub(super) square: Id,
    /// y·y'.
    pub(super) radial: Id,
    /// |y'|².
    pub(super) speed: Id,
}

/// Returns the motion about k/2|y|² + b|y|²/2 with `bound` = b.
///
/// Let a = |y|, ε = y·y'/a², l² = (|y|²|y'|² − (y·y')²)/a⁴, κ = l² + λk/a⁴, C = cos ωh, S = sin ωh/ω, ω² = λb, x = C + εS and ρ² = x² + κS².
/// Then y rotates by lT with T = ∫ dt/ρ², and its length becomes ρa. Below, cos = cos lT and σ = sin(lT)/l. Quantities near 1 are computed by
/// their difference from 1.
pub(super) fn about_inverse_square(graph: &mut Graph, start: &Start<'_>, bound: Id) -> Motion {
    let (h, one) = (graph.symbol(Symbol::StepLength), graph.integer(1));
    let square = graph.mul(start.lambda, bound);
    let (cosine, sine, less) = if graph.is_zero(square) {
        (one, h, graph.zero())
    } else {
        let (cosine, sine) = rotation(graph, square, h, Angle::Any);
        let h2 = graph.pow(h, Ratio::integer(2));
        let angle = graph.mul(square, h2);
        (cosine, sine, versine(graph, angle))
    };
    let growth = graph.div(start.radial, start.square);
    let twist = start.twist(graph);
    let push = graph.scale(Number::integer(2), start.strength);
    let push = (0..2).fold(push, |push, _| graph.div(push, start.square));
    let kappa = graph.add(twist, push);
    // x − 1, ρ² − 1 and ρ − 1.
    let grown = graph.mul(growth, sine);
    let ahead = graph.sub(grown, less);
    let x = graph.add(one, ahead);
    let [spread, swept] = [Function::Spread, Function::Swept].map(|f| graph.call(f, &[x, sine, kappa, square, h]));
    let further = {
        let twice = graph.add(one, x);
        let terms = [graph.mul(ahead, twice), graph.product(&[kappa, sine, sine])];
        let rise = graph.sum(&terms);
        let both = graph.add(one, spread);
        graph.div(rise, both)
    };
    // ρ' − ε, which is small in a short step.
    let pull = {
        let terms = [graph.mul(ahead, cosine), graph.neg(less), graph.neg(further)];
        let shorter = graph.sum(&terms);
        let turned = graph.product(&[square, x, sine]);
        let pushed = graph.product(&[kappa, sine, cosine]);
        let terms = [graph.mul(growth, shorter), graph.neg(turned), pushed];
        let change = graph.sum(&terms);
        graph.div(change, spread)
    };
    if start.forms.len() == 1 {
        // y' = εy.
        let zero = graph.zero();
        return Motion { f: further, g: zero, f_rate: pull, g_rate: zero };
    }
    let rate = graph.add(growth, pull);
    let swept_squared = graph.pow(swept, Ratio::integer(2));
    let angle = graph.mul(twist, swept_squared);
    let (along, short) = (graph.call(Function::StumpffC0, &[angle]), versine(graph, angle));
    let across = graph.call(Function::StumpffC1, &[angle]);
    let across = graph.mul(swept, across);
    // F − 1 = (ρ − 1) cos − (1 − cos) − ρεσ and G = ρσ.
    let g = graph.mul(spread, across);
    let f = {
        let further = graph.mul(further, along);
        let back = graph.mul(growth, g);
        let back = graph.add(short, back);
        graph.sub(further, back)
    };
    // Ḟ = cos (ρ' − ε/ρ) − σ (ερ' + l²/ρ) and Ġ − 1 = ρ'σ − ((1 − cos) + (ρ − 1))/ρ.
    let relative = graph.div(further, spread);
    let f_rate = {
        let outward = graph.mul(growth, relative);
        let outward = graph.add(pull, outward);
        let [turned, grown] = [graph.div(twist, spread), graph.mul(growth, rate)];
        let inward = graph.add(turned, grown);
        let [outward, inward] = [(along, outward), (across, inward)].map(|(a, b)| graph.mul(a, b));
        graph.sub(outward, inward)
    };
    let g_rate = {
        let [grown, short] = [graph.mul(rate, across), graph.div(short, spread)];
        let short = graph.add(short, relative);
        graph.sub(grown, short)
    };
    Motion { f, g, f_rate, g_rate }
}

/// Returns 1 − cos √z = z/2·c₁(z/4)² with Stumpff's function c₁.
fn versine(graph: &mut Graph, z: Id) -> Id {
    let quarter = graph.scale(Number::Exact(Ratio { numerator: 1, denominator: 4 }), z);
    let half_sine = graph.call(Function::StumpffC1, &[quarter]);
    let product = graph.product(&[z, half_sine, half_sine]);
    graph.scale(Number::HALF, product)
}

impl Start<'_> {
    /// Returns l² as a sum of squares, without a difference of nearly equal products.
    fn twist(&self, graph: &mut Graph) -> Id {
        let mut terms = vec![];
        for n in 0..self.forms.len() {
            for m in 0..n {
                let [first, second] = [(m, n), (n, m)].map(|(i, j)| graph.mul(self.y[i], self.v[j]));
                let area = graph.sub(first, second);
                let area = graph.div(area, self.square);
                let area = graph.pow(area, Ratio::integer(2));
                terms.push(graph.product(&[self.forms[m].weight, self.forms[n].weight, area]));
            }
        }
        graph.sum(&terms)
    }
}
