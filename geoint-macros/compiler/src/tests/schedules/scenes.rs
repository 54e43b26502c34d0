//! Loops, packs, branches and calls with several results mean what the graph means.

use super::machine::{Machine, level};
use crate::diff;
use crate::ir::{Function, Graph, Id, Symbol};
use crate::parse::{Leaf, Shape};
use crate::schedule::{self, Array, Block, JointFunction, Layout, Place, Statement};
use crate::tests::eval::eval;
use crate::tests::{Noise, lowered};
use proc_macro2::TokenStream;
use quote::quote;

/// Functions of a system, and the places of its numbers.
struct Scene {
    graph: Graph,
    roots: Vec<Id>,
    coordinates: Shape,
    parameters: Vec<Shape>,
    /// Symbols in the array of the emitted function.
    argument: Vec<(Symbol, Vec<usize>)>,
    /// The places to which the results are written. Nothing if the routine returns them.
    targets: Vec<Place>,
}

impl Scene {
    /// Returns the functions that `roots` derives from an energy.
    fn new(item: TokenStream, roots: impl FnOnce(&mut Graph, Id, u32) -> Vec<Id>) -> Scene {
        let (energy, mut lowered) = lowered(item);
        let roots = roots(&mut lowered.graph, lowered.terms.energy, energy.degrees());
        Scene {
            graph: lowered.graph,
            roots,
            coordinates: energy.coordinates.shape.clone(),
            parameters: energy.parameters().map(|parameter| parameter.shape.clone()).collect(),
            argument: vec![],
            targets: vec![],
        }
    }

    fn layout(&self) -> Layout<'_> {
        let argument = self.argument.clone();
        Layout { coordinates: &self.coordinates, parameters: self.parameters.iter().collect(), argument }
    }

    /// Plans the functions, and changes the last block by `change`. Compares its results with the values of the nodes. Returns the last
    /// block.
    fn checked(&self, levels: usize, change: impl Fn(&mut Block)) -> Block {
        let mut graph = self.graph.clone();
        let none: &[Id] = &[];
        let of_symbol = |symbol: Symbol| level(symbol).min(levels);
        let plan = schedule::plan(&mut graph, of_symbol, &vec![none; levels], &[&self.roots]);
        let layout = self.layout();
        let stores: Vec<Block> =
            plan.stores.iter().map(|block| schedule::arranged(block.clone(), &layout, &[])).collect();
        let mut last = schedule::arranged(plan.last[0].clone(), &layout, &self.targets);
        assert_eq!(last.operations(), plan.last[0].operations());
        change(&mut last);
        let degrees = self.coordinates.len() as u32;
        let scalars: usize = self.parameters.iter().map(Shape::len).sum();
        let symbols: Vec<Symbol> = (0..degrees)
            .flat_map(|i| [Symbol::Position(i), Symbol::Momentum(i)])
            .chain((0..scalars as u32).map(Symbol::Parameter))
            .chain(self.argument.iter().map(|(symbol, _)| *symbol))
            .collect();
        let mut noise = Noise(11);
        for _ in 0..5 {
            let values: Vec<f64> = symbols.iter().map(|_| noise.between(0.5, 1.5)).collect();
            let known = |symbol: Symbol| symbols.iter().position(|other| *other == symbol).map(|i| values[i]);
            let input = |symbol: Symbol| known(symbol).unwrap_or(0.3);
            let mut slots: Vec<Vec<f64>> = vec![];
            for store in &stores {
                slots.push(Machine::new(&slots, &input).with(&layout, symbols.clone()).run(store));
            }
            let mut machine = Machine::new(&slots, &input).with(&layout, symbols.clone());
            let mut results = machine.run(&last);
            results.extend(self.targets.iter().map(|place| machine.memory[place]));
            assert_eq!(results.len(), self.roots.len());
            for (root, found) in self.roots.iter().zip(results) {
                let expected = eval(&self.graph, *root, &input);
                let close = (found - expected).abs() < 1e-12 * (1.0 + expected.abs());
                assert!(close, "the routine gives {found}, the graph {expected}");
            }
        }
        last
    }
}

fn loops(block: &Block) -> usize {
    block.statements.iter().filter(|statement| matches!(statement, Statement::Loop(_))).count()
}

/// A chain of 64 masses.
fn chain(roots: impl FnOnce(&mut Graph, Id, u32) -> Vec<Id>) -> Scene {
    let item = quote! {
        fn chain(q: [f64; 64], p: [f64; 64], alpha: f64) -> f64 {
            let mut energy = q[0] * q[0] / 2.0;
            for i in 0..64 {
                energy += p[i] * p[i] / 2.0;
            }
            for i in 1..64 {
                let d = q[i] - q[i - 1];
                energy += d * d / 2.0 + alpha * d * d * d / 3.0 + d.cos();
            }
            energy
        }
    };
    Scene::new(item, roots)
}

/// Returns the momenta after a kick.
fn kicked(graph: &mut Graph, energy: Id, degrees: u32) -> Vec<Id> {
    let slopes = diff::gradient(graph, energy, degrees).q;
    let h = graph.symbol(Symbol::StepLength);
    let kick = |(i, slope): (usize, Id)| {
        let (p, impulse) = (graph.symbol(Symbol::Momentum(i as u32)), graph.mul(h, slope));
        graph.sub(p, impulse)
    };
    slopes.into_iter().enumerate().map(kick).collect()
}

/// The kick of a chain, which writes the momenta.
fn kick() -> Scene {
    let mut scene = chain(kicked);
    scene.targets = (0..64).map(|i| Place { array: Array::Momentum, indices: vec![i] }).collect();
    scene
}

#[test]
fn loops_of_a_chain_mean_what_the_graph_means() {
    for levels in [0, 1] {
        let block = kick().checked(levels, |_| {});
        assert!(loops(&block) >= 2 && block.statements.len() < 20, "{block:?}");
        let written = |statement: &Statement| matches!(statement, Statement::Loop(each) if each.target.is_some());
        assert!(block.statements.iter().any(written), "{block:?}");
        assert!(loops(&chain(kicked).checked(levels, |_| {})) >= 2);
    }
}

/// Divided differences read two arrays: the coordinates, and the unknowns of the step.
#[test]
fn loops_over_unknowns_mean_what_the_graph_means() {
    let mut scene = chain(|graph, energy, degrees| {
        let diff::Gradient { q, p, .. } = diff::discrete_gradient(graph, energy, degrees);
        [q, p].concat()
    });
    let unknowns = [Symbol::PositionIncrement, Symbol::MomentumIncrement].into_iter().enumerate();
    scene.argument = unknowns.flat_map(|(half, of)| (0..64).map(move |i| (of(i), vec![half, i as usize]))).collect();
    assert!(loops(&scene.checked(2, |_| {})) >= 2);
}

/// Loops over rows of coordinates and parameters, with sines beside cosines.
#[test]
fn loops_over_rows_mean_what_the_graph_means() {
    let item = quote! {
        fn row(q: [[f64; 2]; 20], p: [[f64; 2]; 20], m: [f64; 20], k: f64) -> f64 {
            let mut energy = 0.0;
            for i in 0..20 {
                let [x, y] = [q[i][0] - q[(i + 1) % 20][0], q[i][1]];
                energy += (p[i][0] * p[i][0] + p[i][1] * p[i][1]) / m[i] - k * x.cos() * y.sin() + (x * x + y * y).sqrt();
            }
            energy
        }
    };
    let scene = Scene::new(item, |graph, energy, degrees| {
        let diff::Gradient { q, p, .. } = diff::gradient(graph, energy, degrees);
        [q, p].concat()
    });
    let pairs = |statement: &Statement| matches!(statement, Statement::Loop(each) if each.results.len() == 2);
    assert!(scene.checked(0, |_| {}).statements.iter().any(pairs));
    scene.checked(1, |_| {});
}

#[test]
fn packs_and_branches_mean_what_the_graph_means() {
    let item = quote! {
        fn molecules(q: [[f64; 2]; 6], p: [[f64; 2]; 6], e: f64, a: f64) -> f64 {
            let mut h = 0.0;
            for i in 0..6 {
                h += q[i][0].sin() * q[i][1] + p[i][0] * p[i][0] * q[i][0].cos();
                for j in 0..i {
                    let r2 = (q[i][0] - q[j][0]).powi(2) + (q[i][1] - q[j][1]).powi(2) + 0.5;
                    let s = (a * a / r2).powi(3);
                    h += 4.0 * e * (s * s - s) + if r2 < 0.7 { r2 * r2 } else { 4.0 - r2 };
                }
            }
            h
        }
    };
    let scene = Scene::new(item, kicked);
    let block = scene.checked(1, |_| {});
    let has = |what: fn(&Statement) -> bool| block.statements.iter().any(what);
    assert!(has(|statement| matches!(statement, Statement::Pack { .. })));
    assert!(has(|statement| matches!(statement, Statement::If { .. })));
    assert!(has(|statement| matches!(statement, Statement::Call(call) if call.function == JointFunction::SinCos)));
}

/// exp(A) − 1 times x, with A in slots and in a register.
#[test]
fn linear_flows_mean_what_the_graph_means() {
    let mut graph = Graph::default();
    let h = graph.symbol(Symbol::StepLength);
    let mut args = vec![graph.integer(3)];
    for place in [0, 1, 4, 5, 6] {
        let a = graph.symbol(Symbol::Parameter(place));
        let entry = graph.mul(h, a);
        args.extend([graph.integer(i128::from(place)), entry]);
    }
    let matrix = graph.call(Function::FlowMatrix, &args);
    let x = [0, 1, 2].map(|i| graph.symbol(Symbol::Position(i)));
    let roots = (0..3).map(|row| {
        let row = graph.integer(row);
        graph.call(Function::FlowChange, &[row, matrix, x[0], x[1], x[2]])
    });
    let roots = roots.collect();
    let shape = |extent| Shape { extents: vec![extent], leaf: Leaf::Plain };
    let scene =
        Scene { graph, roots, coordinates: shape(3), parameters: vec![shape(7)], argument: vec![], targets: vec![] };
    for levels in [0, 1] {
        let block = scene.checked(levels, |_| {});
        let calls = block.statements.iter().filter(|statement| matches!(statement, Statement::Call(_))).count();
        assert_eq!(calls, 2 - levels);
    }
}

/// A control: loops that read the next entry, and loops in another order, give other results.
#[test]
#[should_panic(expected = "the routine gives")]
fn shifted_loops_are_seen() {
    kick().checked(1, |block| {
        for statement in &mut block.statements {
            if let Statement::Loop(each) = statement {
                each.reads.iter_mut().for_each(|(_, run)| run.first = [0; 3]);
            }
        }
    });
}

/// A control: the machine runs statements in order.
#[test]
#[should_panic(expected = "no entry found for key")]
fn exchanged_loops_are_seen() {
    kick().checked(1, |block| block.statements.reverse());
}
