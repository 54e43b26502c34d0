//! Motion about a centre: a potential of the length of y, whose components are forms in the positions.
//!
//! With T = p·Wp/2 and |y|² = Σ κₘ yₘ², yₘ = aₘ·q + cₘ, components are accelerated along y alone if κₘ aₘ·Waₙ is λ for m = n, else 0. Then
//! y moves in a plane, y(h) = F y + G y' and y'(h) = Ḟ y + Ġ y' with numbers F to Ġ, and q and p follow, because W aₘ and aₘ are all that
//! they are accelerated along. One body about a fixed centre and two bodies about each other are such motions, and oscillators and walls of
//! one coordinate.

use super::super::flow::{Flow, Group};
use super::super::polynomial::{Polynomial, is_free, is_momentum};
use super::super::scalar::rotation;
use super::super::time::Clock;
use crate::analyze;
use crate::ir::{Function, Graph, Id, Node, Number, Ratio, Symbol};

/// A form in the positions: its coefficients, its constant, and its weight in |y|².
struct Form {
    coefficients: Vec<Id>,
    constant: Id,
    weight: Id,
}

/// A term g·|y|ⁿ of the potential.
struct Centre {
    strength: Id,
    forms: Vec<Form>,
    square: Id,
}

/// p·Wp/2 with the terms of a potential that are powers of lengths, and the sum of all others.
struct Central {
    inverse_mass: Vec<Vec<Id>>,
    centres: Vec<Centre>,
    rest: Id,
}

/// F − 1, G, Ḟ and Ġ − 1.
type Motion = [Id; 4];

/// p·Wp/2 + Σ k/2|y|² + b|y|²/2, of which each y is accelerated by itself.
pub(in super::super) fn inverse_square(graph: &mut Graph, group: &Group) -> Option<Flow> {
    let central = Central::of(graph, group, Ratio::integer(-2))?;
    let bound = central.oscillators(graph)?;
    central.flow(graph, group, |graph, at| about_inverse_square(graph, at, bound[at.number]))
}

/// p·Wp/2 − Σ k/|y|.
pub(in super::super) fn kepler(graph: &mut Graph, group: &Group) -> Option<Flow> {
    let central = Central::of(graph, group, Ratio::integer(-1))?;
    // On a line every motion ends in the centre, or leaves it alone.
    if !is_free(graph, central.rest, &Symbol::is_coordinate) || central.centres.iter().any(|c| c.forms.len() < 2) {
        return None;
    }
    central.flow(graph, group, |graph, at| {
        let attraction = graph.neg(at.strength);
        let args = [at.square, at.falling, at.speed, attraction, graph.symbol(Symbol::H)];
        Function::KEPLER.map(|function| graph.call(function, &args))
    })
}

/// A centre and the motion about it at the start.
struct Start<'a> {
    number: usize,
    lambda: Id,
    /// λg.
    strength: Id,
    forms: &'a [Form],
    y: Vec<Id>,
    v: Vec<Id>,
    /// |y|², y·y' and |y'|².
    square: Id,
    falling: Id,
    speed: Id,
}

/// With a = |y|, ε = y·y'/a² and l² = |y|²|y'|² − (y·y')² over a⁴, κ = l² + λk/a⁴, x = C + εS and ρ² = x² + κS²: y has turned by lT, T = ∫ dt/ρ²,
/// and is ρa long. What is near 1 in short steps is written by its difference from 1.
fn about_inverse_square(graph: &mut Graph, at: &Start<'_>, bound: Id) -> Motion {
    let (h, one) = (graph.symbol(Symbol::H), graph.integer(1));
    let square = graph.mul(at.lambda, bound);
    let (cosine, sine, less) = if graph.is_zero(square) {
        (one, h, graph.zero())
    } else {
        let (cosine, sine) = rotation(graph, square, h, false);
        let h2 = graph.pow(h, Ratio::integer(2));
        let angle = graph.mul(square, h2);
        (cosine, sine, versine(graph, angle))
    };
    let growth = graph.div(at.falling, at.square);
    let twist = at.twist(graph);
    let push = graph.scale(Number::integer(2), at.strength);
    let push = (0..2).fold(push, |push, _| graph.div(push, at.square));
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
    // ρ' − ε: what little of it is left where a short step is taken.
    let pull = {
        let terms = [graph.mul(ahead, cosine), graph.neg(less), graph.neg(further)];
        let shorter = graph.sum(&terms);
        let turned = graph.product(&[square, x, sine]);
        let pushed = graph.product(&[kappa, sine, cosine]);
        let terms = [graph.mul(growth, shorter), graph.neg(turned), pushed];
        let change = graph.sum(&terms);
        graph.div(change, spread)
    };
    if at.forms.len() == 1 {
        // y' is εy.
        let zero = graph.zero();
        return [further, zero, pull, zero];
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
    [f, g, f_rate, g_rate]
}

/// 1 − cos √z = z/2·c₁(z/4)².
fn versine(graph: &mut Graph, z: Id) -> Id {
    let quarter = graph.scale(Number::Exact(Ratio { numerator: 1, denominator: 4 }), z);
    let half_sine = graph.call(Function::StumpffC1, &[quarter]);
    let product = graph.product(&[z, half_sine, half_sine]);
    graph.scale(Number::HALF, product)
}

impl Start<'_> {
    /// l², without a difference of two products that are nearly equal.
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

impl Central {
    /// The parts of an energy whose lengths stand to the power `power`.
    fn of(graph: &mut Graph, group: &Group, power: Ratio) -> Option<Central> {
        let reads_time = |symbol: Symbol| symbol == Symbol::T && group.clock == Clock::Own;
        if !is_free(graph, group.energy, &|symbol| symbol == Symbol::S || reads_time(symbol)) {
            return None;
        }
        let divides = |id: Id| matches!(graph.node(id), Node::Power(base, r) if r.numerator < 0 && analyze::reads(graph, *base).q);
        if !graph.reachable(&[group.energy]).into_iter().any(divides) {
            return None;
        }
        let powers = Polynomial::of(graph, group.energy, &is_momentum)?;
        let mut inverse_mass = vec![vec![graph.zero(); group.degrees as usize]; group.degrees as usize];
        let mut potential = graph.zero();
        for (monomial, coefficient) in powers.into_terms() {
            let constant = is_free(graph, coefficient, &Symbol::is_coordinate);
            let momenta: Vec<(usize, Ratio)> = monomial
                .iter()
                .filter_map(
                    |(symbol, power)| if let Symbol::P(i) = symbol { Some((*i as usize, *power)) } else { None },
                )
                .collect();
            match momenta[..] {
                [] => potential = coefficient,
                [(i, power)] if constant && power == Ratio::integer(2) => {
                    inverse_mass[i][i] = graph.scale(Number::integer(2), coefficient);
                }
                [(i, Ratio::ONE), (j, Ratio::ONE)] if constant => {
                    (inverse_mass[i][j], inverse_mass[j][i]) = (coefficient, coefficient);
                }
                _ => return None,
            }
        }
        let (mut centres, mut rest) = (vec![], vec![]);
        for term in analyze::single_terms(graph, potential) {
            match centre(graph, term, power, group.degrees) {
                Some(centre) => centres.push(centre),
                None => rest.push(term),
            }
        }
        let rest = graph.sum(&rest);
        (!centres.is_empty()).then_some(Central { inverse_mass, centres, rest })
    }

    /// b of each centre, if the rest is Σ b|y|²/2 and a constant.
    fn oscillators(&self, graph: &mut Graph) -> Option<Vec<Id>> {
        let powers = Polynomial::of(graph, self.rest, &Symbol::is_coordinate)?;
        let (mut bound, mut rest) = (vec![], self.rest);
        for centre in &self.centres {
            let own = Polynomial::of(graph, centre.square, &Symbol::is_coordinate)?;
            let of = |powers: &Polynomial, graph: &mut Graph, i: u32| powers.coefficient(graph, &[(Symbol::Q(i), 2)]);
            let i = (0..self.inverse_mass.len() as u32).find(|i| {
                let square = of(&own, graph, *i);
                !graph.is_zero(square)
            })?;
            let [square, given] = [&own, &powers].map(|powers| of(powers, graph, i));
            let half = graph.div(given, square);
            let energy = graph.mul(half, centre.square);
            rest = graph.sub(rest, energy);
            bound.push(graph.scale(Number::integer(2), half));
        }
        let left = Polynomial::of(graph, rest, &Symbol::is_coordinate)?;
        let constant =
            left.into_terms().all(|(monomial, c)| monomial.is_empty() || analyze::identity(graph, c).is_zero());
        constant.then_some(bound)
    }

    /// The flow, if every y is accelerated along itself.
    fn flow(
        &self,
        graph: &mut Graph,
        group: &Group,
        motion: impl Fn(&mut Graph, &Start<'_>) -> Motion,
    ) -> Option<Flow> {
        let mut flow = Flow::rest(graph, group.degrees);
        let (q, p, h) = (flow.q.clone(), flow.p.clone(), graph.symbol(Symbol::H));
        // W aₘ of all forms so far, with aₘ.
        let mut before: Vec<(Vec<Id>, Vec<Id>)> = vec![];
        let mut free = self.inverse_mass.clone();
        for (number, centre) in self.centres.iter().enumerate() {
            let forms = &centre.forms;
            let pushes: Vec<Vec<Id>> = forms
                .iter()
                .map(|form| self.inverse_mass.iter().map(|row| dot(graph, row, &form.coefficients)).collect())
                .collect();
            for (m, form) in forms.iter().enumerate() {
                if before.iter().any(|(push, _)| !vanishes(graph, push, &form.coefficients))
                    || pushes[..m].iter().any(|push| !vanishes(graph, push, &form.coefficients))
                {
                    return None;
                }
            }
            let of_form = |graph: &mut Graph, m: usize| {
                let own = dot(graph, &pushes[m], &forms[m].coefficients);
                graph.mul(forms[m].weight, own)
            };
            let lambda = of_form(graph, 0);
            for m in 0..forms.len() {
                let other = of_form(graph, m);
                let difference = graph.sub(other, lambda);
                if graph.is_zero(lambda) || !analyze::identity(graph, difference).is_zero() {
                    return None;
                }
            }
            let y: Vec<Id> = forms.iter().map(|form| form.value(graph, &q)).collect();
            let v: Vec<Id> = pushes.iter().map(|push| dot(graph, push, &p)).collect();
            let [square, falling, speed] = [(&y, &y), (&y, &v), (&v, &v)].map(|(a, b)| {
                let products =
                    (0..forms.len()).map(|m| graph.product(&[forms[m].weight, a[m], b[m]])).collect::<Vec<_>>();
                graph.sum(&products)
            });
            let strength = graph.mul(lambda, centre.strength);
            let start = Start { number, lambda, strength, forms, y, v, square, falling, speed };
            let [f, g, f_rate, g_rate] = motion(graph, &start);
            for (m, push) in pushes.iter().enumerate() {
                let share = graph.div(forms[m].weight, lambda);
                let [moved, kicked] = [[f, g], [f_rate, g_rate]].map(|[by_y, by_v]| {
                    let terms = [graph.mul(by_y, start.y[m]), graph.mul(by_v, start.v[m])];
                    graph.sum(&terms)
                });
                for i in 0..q.len() {
                    let along = graph.mul(share, push[i]);
                    let moved = graph.mul(along, moved);
                    flow.q[i] = graph.add(flow.q[i], moved);
                    let kicked = graph.product(&[share, forms[m].coefficients[i], kicked]);
                    flow.p[i] = graph.add(flow.p[i], kicked);
                    for j in 0..q.len() {
                        let bound = graph.mul(along, push[j]);
                        free[i][j] = graph.sub(free[i][j], bound);
                    }
                }
            }
            before.extend(pushes.into_iter().zip(forms.iter().map(|form| form.coefficients.clone())));
        }
        // What no centre accelerates.
        for (i, row) in free.into_iter().enumerate() {
            for (entry, p) in row.into_iter().zip(&p) {
                if !analyze::identity(graph, entry).is_zero() {
                    let moved = graph.product(&[h, entry, *p]);
                    flow.q[i] = graph.add(flow.q[i], moved);
                }
            }
        }
        Some(flow)
    }
}

impl Form {
    /// A sum of positions with constant coefficients.
    fn of(graph: &mut Graph, id: Id, weight: Id, degrees: u32) -> Option<Form> {
        let powers = Polynomial::of(graph, id, &Symbol::is_coordinate)?;
        let position = |symbol: &Symbol| matches!(symbol, Symbol::Q(_));
        let linear = powers.has_only(|monomial| {
            monomial.is_empty() || monomial.keys().all(position) && monomial.values().eq([&Ratio::ONE])
        });
        let moves = powers.terms().any(|(monomial, _)| !monomial.is_empty());
        (linear && moves).then(|| Form {
            coefficients: (0..degrees).map(|i| powers.coefficient(graph, &[(Symbol::Q(i), 1)])).collect(),
            constant: powers.coefficient(graph, &[]),
            weight,
        })
    }

    fn value(&self, graph: &mut Graph, q: &[Id]) -> Id {
        let along = dot(graph, &self.coefficients, q);
        graph.add(along, self.constant)
    }
}

/// g and y of g·|y|ⁿ, if a term is that.
fn centre(graph: &mut Graph, term: Id, power: Ratio, degrees: u32) -> Option<Centre> {
    let (c, rest) = graph.coefficient(term);
    let (mut strength, mut found) = (graph.number(c), None);
    for (base, exponent) in graph.factors(rest) {
        if is_free(graph, base, &Symbol::is_coordinate) {
            let factor = graph.pow(base, exponent);
            strength = graph.mul(strength, factor);
        } else {
            found = Some(length(graph, base, exponent, power, degrees)?).filter(|_| found.is_none());
            found.as_ref()?;
        }
    }
    let (forms, square) = found?;
    Some(Centre { strength, forms, square })
}

/// y and |y|² of a base whose power is |y|ⁿ: a form, the length of two, or a sum of squares.
fn length(graph: &mut Graph, base: Id, exponent: Ratio, power: Ratio, degrees: u32) -> Option<(Vec<Form>, Id)> {
    let one = graph.integer(1);
    let two = Ratio::integer(2);
    if exponent == power {
        let components = match graph.node(base).clone() {
            Node::Call(Function::Hypot, args) => args,
            _ => vec![base],
        };
        let squares: Vec<Id> = components.iter().map(|y| graph.pow(*y, two)).collect();
        let square = graph.sum(&squares);
        let forms: Option<Vec<Form>> = components.into_iter().map(|y| Form::of(graph, y, one, degrees)).collect();
        return forms.map(|forms| (forms, square));
    }
    if exponent.mul(two)? != power {
        return None;
    }
    let mut forms = vec![];
    for term in analyze::single_terms(graph, base) {
        let (c, rest) = graph.coefficient(term);
        let (mut weight, mut form) = (graph.number(c), None);
        for (base, exponent) in graph.factors(rest) {
            if is_free(graph, base, &Symbol::is_coordinate) {
                let factor = graph.pow(base, exponent);
                weight = graph.mul(weight, factor);
            } else {
                form = Some(base).filter(|_| form.is_none() && exponent == two);
                form?;
            }
        }
        forms.push(Form::of(graph, form?, weight, degrees)?);
    }
    Some((forms, base))
}

/// a·b.
fn dot(graph: &mut Graph, a: &[Id], b: &[Id]) -> Id {
    let products: Vec<Id> = a.iter().zip(b).map(|(a, b)| graph.mul(*a, *b)).collect();
    graph.sum(&products)
}

/// a·b = 0?
fn vanishes(graph: &mut Graph, a: &[Id], b: &[Id]) -> bool {
    let product = dot(graph, a, b);
    analyze::identity(graph, product).is_zero()
}
