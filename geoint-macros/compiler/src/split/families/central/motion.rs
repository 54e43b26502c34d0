//! The motion of y in its plane, as a function of |y|², y·y' and |y'|².

use super::super::super::scalar::{Angle, rotation};
use super::centre::Form;
use crate::ir::formula::{call, squared, sum};
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
        let angle = graph.build(square * squared(h));
        (cosine, sine, versine(graph, angle))
    };
    let growth = graph.div(start.radial, start.square);
    let twist = start.twist(graph);
    let push = graph.scale(Number::integer(2), start.strength);
    let push = (0..2).fold(push, |push, _| graph.div(push, start.square));
    let kappa = graph.add(twist, push);
    // x − 1, ρ² − 1 and ρ − 1.
    let ahead = graph.build(growth * sine - less);
    let x = graph.build(1 + ahead);
    let [spread, swept] = [Function::Spread, Function::Swept].map(|f| graph.call(f, &[x, sine, kappa, square, h]));
    let further = graph.build(sum([ahead * (1 + x), kappa * sine * sine]) / (1 + spread));
    // ρ' − ε, which is small in a short step.
    let shorter = graph.build(sum([ahead * cosine, -less, -further]));
    let (turned, pushed) = (graph.build(square * x * sine), graph.build(kappa * sine * cosine));
    let pull = graph.build(sum([growth * shorter, -turned, pushed.into()]) / spread);
    if start.forms.len() == 1 {
        // y' = εy.
        let zero = graph.zero();
        return Motion { f: further, g: zero, f_rate: pull, g_rate: zero };
    }
    let rate = graph.add(growth, pull);
    let angle = graph.build(twist * squared(swept));
    let (along, short) = (graph.call(Function::StumpffC0, &[angle]), versine(graph, angle));
    let across = graph.build(swept * call(Function::StumpffC1, [angle]));
    // F − 1 = (ρ − 1) cos − (1 − cos) − ρεσ and G = ρσ.
    let g = graph.mul(spread, across);
    let f = graph.build(further * along - (short + growth * g));
    // Ḟ = cos (ρ' − ε/ρ) − σ (ερ' + l²/ρ) and Ġ − 1 = ρ'σ − ((1 − cos) + (ρ − 1))/ρ.
    let relative = graph.div(further, spread);
    let outward = graph.build(pull + growth * relative);
    let inward = graph.build(twist / spread + growth * rate);
    let f_rate = graph.build(along * outward - across * inward);
    let g_rate = graph.build(rate * across - (short / spread + relative));
    Motion { f, g, f_rate, g_rate }
}

/// Returns 1 − cos √z = z/2·c₁(z/4)² with Stumpff's function c₁.
fn versine(graph: &mut Graph, z: Id) -> Id {
    let quarter = Number::Exact(Ratio { numerator: 1, denominator: 4 });
    let half_sine = graph.build(call(Function::StumpffC1, [quarter * z]));
    graph.build(Number::HALF * (z * half_sine * half_sine))
}

impl Start<'_> {
    /// Returns l² as a sum of squares, without a difference of nearly equal products.
    fn twist(&self, graph: &mut Graph) -> Id {
        let mut terms = vec![];
        for n in 0..self.forms.len() {
            for m in 0..n {
                let [y, v] = [&self.y, &self.v];
                let area = graph.build(squared((y[m] * v[n] - y[n] * v[m]) / self.square));
                terms.push(graph.build(self.forms[m].weight * self.forms[n].weight * area));
            }
        }
        graph.sum(&terms)
    }
}
