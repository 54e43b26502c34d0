//! Schedules mean what the graph means. An interpreter runs the statements. Tests compare results with the values of nodes.

mod factors;
mod machine;
mod packs;
mod scenes;

use super::fuzz::{config, energy};
use super::rounding::{is_undecided, rounded};
use super::{Noise, lowered};
use crate::diff;
use crate::ir::{Function, HashMap, Id, Symbol};
use crate::parse::Form;
use crate::schedule::{self, Call, Instruction, JointFunction, Statement};
use crate::tests::eval::eval;
use crate::{lower, parse};
use machine::{Machine, level};
use proptest::prelude::*;
use quote::quote;

#[test]
fn statements_mean_what_the_graph_means() {
    let energies = [
        quote! {
            fn double_pendulum(q: [f64; 2], p: [f64; 2], m1: f64, m2: f64, l1: f64, l2: f64, g: f64) -> f64 {
                let (s, c) = (q[0] - q[1]).sin_cos();
                let numerator = m2 * l2 * l2 * p[0] * p[0] + (m1 + m2) * l1 * l1 * p[1] * p[1]
                    - 2.0 * m2 * l1 * l2 * p[0] * p[1] * c;
                numerator / (2.0 * m2 * l1 * l1 * l2 * l2 * (m1 + m2 * s * s))
                    - (m1 + m2) * g * l1 * q[0].cos() - m2 * g * l2 * q[1].cos()
            }
        },
        quote! {
            fn kepler(q: [f64; 2], p: [f64; 2], t: f64, m: f64, k: f64) -> f64 {
                let r2 = q[0] * q[0] + q[1] * q[1];
                (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) - k * (1.0 + 0.1 * t.sin()) / r2.sqrt() + k / (r2 * r2)
            }
        },
    ];
    for item in energies {
        let (energy, mut lowered) = lowered(item);
        let graph = &mut lowered.graph;
        let structure = crate::analyze::structure(graph, lowered.terms.energy, &energy.coordinates.shape);
        let field = diff::field::discrete(graph, &structure, 2);
        let gradient = diff::gradient(graph, lowered.terms.energy, 2);
        let iteration: Vec<Id> = field.f.iter().chain(field.jacobian.iter().flatten()).copied().collect();
        let before = graph.clone();
        let plan = schedule::plan(graph, level, &[&[], &gradient.q], &[&iteration]);

        let mut noise = Noise(3);
        for _ in 0..50 {
            let mut values: HashMap<Symbol, f64> = HashMap::default();
            let symbols = before.reachable(&[&iteration[..], &gradient.q].concat());
            for id in symbols {
                if let crate::ir::Node::Symbol(symbol) = before.node(id) {
                    values.insert(*symbol, noise.between(0.5, 1.5));
                }
            }
            let input = |symbol: Symbol| values[&symbol];
            let mut slots: Vec<Vec<f64>> = vec![];
            for (store, own) in plan.stores.iter().zip([0, gradient.q.len()]) {
                let results = Machine::new(&slots, &input).run(store);
                slots.push(results[own..].to_vec());
            }
            let results = Machine::new(&slots, &input).run(&plan.last[0]);
            for (root, found) in iteration.iter().zip(results) {
                let expected = eval(&before, *root, &input);
                assert!((found - expected).abs() < 1e-12 * (1.0 + expected.abs()), "{found} {expected}");
            }
        }
    }
}

/// Returns all functions in the iterations of implicit steps.
fn derived(form: Form, graph: &mut crate::ir::Graph, energy: Id) -> Vec<Id> {
    let fields = match form {
        Form::Contact | Form::Herglotz => [diff::contact::midpoint, diff::contact::discrete]
            .map(|equation| {
                let diff::contact::Equation { mut field, end } = equation(graph, energy, 1);
                field.f.extend(end);
                field
            })
            .into(),
        _ => {
            let shape = parse::Shape { extents: vec![], leaf: parse::Leaf::Plain };
            let structure = crate::analyze::structure(graph, energy, &shape);
            let gradient = diff::gradient(graph, energy, 1);
            vec![diff::field::field(graph, &gradient, &structure, 1), diff::field::discrete(graph, &structure, 1)]
        }
    };
    fields.into_iter().flat_map(|field| [field.f, field.jacobian.concat()].concat()).collect()
}

/// ½(2q + p) beside q + p/2: two operations for the mean, and one for the sum with the sine.
#[test]
fn a_sum_times_a_number_is_the_sum_of_multiples_that_is_needed_anyway() {
    let (_, mut lowered) = lowered(quote! {
        fn half_a_sum(q: f64, p: f64) -> f64 {
            (2.0 * q + p) / 2.0 + (q + p / 2.0).sin()
        }
    });
    let plan = schedule::statements(&mut lowered.graph, &[lowered.terms.energy]);
    assert_eq!(plan.operations().arithmetic, 3);
}

/// Negative powers of one base. A root serves whole powers only if the root exists for all values.
#[test]
fn roots_divide_for_whole_powers_only_where_they_exist() {
    let values = |item, q: f64| {
        let (_, mut lowered) = lowered(item);
        let plan = schedule::plan(&mut lowered.graph, level, &[&[], &[]], &[&[lowered.terms.energy]]);
        let input = |symbol: Symbol| if let Symbol::Position(_) = symbol { q } else { 0.5 };
        let mut slots = vec![];
        for store in &plan.stores {
            slots.push(Machine::new(&slots, &input).run(store));
        }
        let divisions = plan.stores.iter().flat_map(|block| &block.statements);
        let divisions = divisions.filter(|statement| matches!(statement, Statement::Let(_, Instruction::Div(..))));
        (slots[1][0], divisions.count())
    };
    let guarded = quote! {
        fn guarded(q: f64, p: f64) -> f64 {
            p / q + if q > 0.0 { q.powf(-0.5) } else { 0.0 }
        }
    };
    assert_eq!(values(guarded, -2.0), (-0.25, 1));
    let charged = quote! {
        fn charged(q: f64, p: f64) -> f64 {
            let r2 = q * q + 1.0;
            p / r2 + r2.powf(-0.5)
        }
    };
    let (value, divisions) = values(charged, 0.75);
    assert!((value - 1.12).abs() < 4.0 * f64::EPSILON && divisions == 1, "{value} {divisions}");
}

proptest! {
    #![proptest_config(config())]

    /// Random energies of both forms and their derivatives have the values of the graph.
    #[test]
    fn random_energies_mean_what_the_graph_means(
        (form, text) in energy(&["q", "p", "q", "p", "t", "a", "w[1]", "0.5", "2.0"]),
        point in prop::array::uniform8(-1.5..1.5),
    ) {
        let energy = parse::energy(form, quote!(), syn::parse_str(&text).expect("a function")).expect("an energy");
        // The compiler refuses constants without a value.
        let Ok(mut lowered) = lower::body(&energy) else { return Ok(()) };
        let roots = [vec![lowered.terms.energy], derived(form, &mut lowered.graph, lowered.terms.energy)].concat();
        let before = lowered.graph.clone();
        let plan = schedule::plan(&mut lowered.graph, level, &[&[], &[]], &[&roots]);
        let input = |symbol: Symbol| match symbol {
            Symbol::Position(_) => point[0],
            Symbol::Momentum(_) | Symbol::Velocity(_) => point[1],
            Symbol::Action => point[2],
            Symbol::PositionIncrement(_) => 0.3 * point[3],
            Symbol::MomentumIncrement(_) => 0.3 * point[4],
            Symbol::ActionIncrement | Symbol::VelocityIncrement(_) | Symbol::Multiplier(_) => 0.3 * point[5],
            Symbol::Time | Symbol::StepStart | Symbol::StepEnd => point[6],
            Symbol::StepLength | Symbol::GradientWeight => 0.1 * point[7],
            Symbol::Parameter(i) => 0.4 + 0.3 * f64::from(i),
        };
        let mut slots: Vec<Vec<f64>> = vec![];
        for store in &plan.stores {
            let results = Machine::new(&slots, &input).run(store);
            slots.push(results);
        }
        let results = Machine::new(&slots, &input).run(&plan.last[0]);
        for (root, found) in roots.iter().zip(results) {
            let expected = rounded(&before, *root, &input);
            // A value that is not finite, or only rounding, is no evidence.
            if expected.value.is_finite() && expected.error.is_finite() && !is_undecided(&before, *root, &input) {
                let difference = (found - expected.value).abs();
                prop_assert!(difference <= 4.0 * f64::EPSILON * expected.error + 1e-290, "{found} {expected:?} of {text}");
            }
        }
    }
}

#[test]
fn values_of_a_branch_are_computed_in_the_branch() {
    let (_, mut lowered) = lowered(quote! {
        fn cold_wall(q: f64, p: f64) -> f64 {
            p * p / 2.0 + if q > 0.0 { q.ln() * q.sin() } else { 0.0 }
        }
    });
    let graph = &mut lowered.graph;
    let gradient = diff::gradient(graph, lowered.terms.energy, 1);
    let roots = vec![lowered.terms.energy, gradient.q[0]];
    let block = schedule::statements(graph, &roots);
    let calls =
        |statement: &Statement| matches!(statement, Statement::Call(_) | Statement::Let(_, Instruction::Call(..)));
    assert!(!block.statements.iter().any(calls), "{block:?}");
    let branches: Vec<_> = block.statements.iter().filter(|s| matches!(s, Statement::If { .. })).collect();
    assert_eq!(branches.len(), 1, "value and slope share one branch: {block:?}");
}

#[test]
fn early_values_are_computed_early() {
    let (_, mut lowered) = lowered(quote! {
        fn pendulum(q: f64, p: f64, m: f64, l: f64, g: f64) -> f64 {
            p * p / (2.0 * m * l * l) - m * g * l * q.cos()
        }
    });
    let graph = &mut lowered.graph;
    let gradient = diff::gradient(graph, lowered.terms.energy, 1);
    let h = graph.symbol(Symbol::StepLength);
    let kick = graph.mul(h, gradient.q[0]);
    let p = graph.symbol(Symbol::Momentum(0));
    let kicked = graph.sub(p, kick);
    let plan = schedule::plan(graph, |symbol| level(symbol).min(1), &[&[]], &[&[kicked]]);
    // A sine, and a product fused with the sum.
    assert_eq!(plan.slots, [1]);
    assert_eq!(plan.last[0].statements.len(), 2, "{:?}", plan.last[0]);
}

/// Orbits of one level are one call. An orbit from the end of another orbit is the next call.
#[test]
fn orbits_of_one_level_are_one_call() {
    let mut graph = crate::ir::Graph::default();
    let [h, mu] = [Symbol::StepLength, Symbol::Parameter(0)].map(|symbol| graph.symbol(symbol));
    let orbit = |graph: &mut crate::ir::Graph, i: u32, offset: Option<Id>| {
        let [q, p] = [Symbol::Position(i), Symbol::Momentum(i)].map(|symbol| graph.symbol(symbol));
        let q = offset.map_or(q, |offset| graph.add(q, offset));
        let squares = [(q, q), (q, p), (p, p)].map(|(a, b)| graph.mul(a, b));
        let one = graph.integer(1);
        let squares = squares.map(|square| graph.add(one, square));
        let args = [squares[0], squares[1], squares[2], mu, h];
        Function::KEPLER.map(|function| graph.call(function, &args))
    };
    let [first, second] = [0, 1].map(|i| orbit(&mut graph, i, None));
    let later = orbit(&mut graph, 2, Some(first[1]));
    let roots = [first, second, later].concat();
    let before = graph.clone();
    let plan = schedule::plan(&mut graph, level, &[&[], &[]], &[&roots]);
    // All orbits have the level of the start of a step. The roots have the level of increments.
    let block = &plan.stores[1];
    let calls: Vec<usize> = block
        .statements
        .iter()
        .filter_map(|statement| match statement {
            Statement::Call(Call { function: JointFunction::Kepler, results, .. }) => Some(results.len()),
            _ => None,
        })
        .collect();
    assert_eq!(calls, [2, 1]);
    let input = |symbol: Symbol| match symbol {
        Symbol::StepLength => 0.3,
        Symbol::Position(i) => 0.7 + 0.1 * f64::from(i),
        Symbol::Momentum(i) => 0.4 - 0.2 * f64::from(i),
        _ => 1.1,
    };
    let mut slots = vec![];
    for store in &plan.stores {
        slots.push(Machine::new(&slots, &input).run(store));
    }
    let results = Machine::new(&slots, &input).run(&plan.last[0]);
    for (root, found) in roots.iter().zip(results) {
        assert_eq!(found, eval(&before, *root, &input));
    }
}
