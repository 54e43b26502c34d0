//! Packs of alike roots and quotients keep the bits of each number.

use super::machine::{Machine, level};
use crate::diff;
use crate::ir::Symbol;
use crate::parse::{Leaf, Shape};
use crate::schedule::{self, Block, Instruction, Layout, Statement};
use crate::tests::{Noise, lowered};
use proc_macro2::TokenStream;
use quote::quote;

/// Returns the gradient of an energy by q, as one block.
fn forces(item: TokenStream, degrees: u32) -> Block {
    let (_, mut lowered) = lowered(item);
    let gradient = diff::gradient(&mut lowered.graph, lowered.terms.energy, degrees);
    schedule::statements(&mut lowered.graph, &gradient.q)
}

fn gravity(bodies: usize) -> Block {
    let item = quote! {
        fn gravity(q: [[f64; 3]; #bodies], p: [[f64; 3]; #bodies], g: f64, m: [f64; #bodies]) -> f64 {
            let mut h = 0.0;
            for i in 0..#bodies {
                h += p[i][0] * p[i][0] / (2.0 * m[i]);
                for j in 0..i {
                    let [x, y, z] = [q[i][0] - q[j][0], q[i][1] - q[j][1], q[i][2] - q[j][2]];
                    h -= g * m[i] * m[j] / (x * x + y * y + z * z).sqrt();
                }
            }
            h
        }
    };
    forces(item, 3 * bodies as u32)
}

/// Returns a block with packs, if it has any.
fn packed(before: &Block) -> Option<Block> {
    let shape = Shape { extents: vec![], leaf: Leaf::Plain };
    let layout = Layout { coordinates: &shape, parameters: vec![], argument: vec![] };
    let after = schedule::arranged(before.clone(), &layout, &[]);
    assert_eq!(after.operations(), before.operations());
    (count(&after, |statement| matches!(statement, Statement::Pack { .. })) > 0).then_some(after)
}

fn count(block: &Block, what: impl Fn(&Statement) -> bool) -> usize {
    block.statements.iter().filter(|statement| what(statement)).count()
}

fn roots(block: &Block) -> usize {
    count(block, |statement| {
        matches!(
            statement,
            Statement::Let(_, Instruction::Sqrt(_)) | Statement::Pack { instruction: Instruction::Sqrt(_), .. }
        )
    })
}

/// Compares the results of a block before and after the pass, at some points.
fn keeps_its_bits(before: &Block, after: &Block) {
    let mut noise = Noise(7);
    for _ in 0..20 {
        let values: Vec<f64> = (0..200).map(|_| noise.between(-1.5, 1.5)).collect();
        let input = |symbol: Symbol| match symbol {
            Symbol::Position(i) => values[i as usize],
            Symbol::Momentum(i) => values[50 + i as usize],
            Symbol::Parameter(i) => values[100 + i as usize],
            _ => values[199],
        };
        let bits = |block| Machine::new(&[], &input).run(block).iter().map(|x| x.to_bits()).collect::<Vec<_>>();
        assert_eq!(bits(before), bits(after));
    }
}

#[test]
fn roots_of_pairs_are_side_by_side() {
    for bodies in 2..10 {
        let (before, pairs) = (gravity(bodies), bodies * (bodies - 1) / 2);
        assert_eq!(roots(&before), pairs);
        let after = packed(&before);
        let Some(after) = after else {
            assert!(pairs < 8, "{bodies} bodies");
            continue;
        };
        // A pack of three remaining pairs holds the last pair twice. One or two remaining pairs stay alone.
        let alone = if pairs % 4 == 3 { 0 } else { pairs % 4 };
        assert_eq!(roots(&after), alone + pairs.div_ceil(4) - alone.min(1), "{bodies} bodies");
        assert!(after.statements.len() < before.statements.len(), "{bodies} bodies");
        keeps_its_bits(&before, &after);
    }
}

/// Quotients without roots, beside powers, conditions and sines.
#[test]
fn other_forces_keep_their_bits() {
    let molecules = quote! {
        fn molecules(q: [[f64; 2]; 6], p: [[f64; 2]; 6], e: f64, a: f64) -> f64 {
            let mut h = p[0][0];
            for i in 0..6 {
                h += q[i][0].sin() * q[i][1];
                for j in 0..i {
                    let r2 = (q[i][0] - q[j][0]).powi(2) + (q[i][1] - q[j][1]).powi(2);
                    let s = (a * a / r2).powi(3);
                    h += 4.0 * e * (s * s - s) + if r2 < 2.0 { r2 } else { 4.0 - r2 };
                }
            }
            h
        }
    };
    let ring = quote! {
        fn ring(q: [f64; 12], p: [f64; 12], a: f64) -> f64 {
            let mut h = p[0];
            for i in 0..12 {
                let d = q[(i + 1) % 12] - q[i];
                h += a / (1.0 + d * d) + q[i] / (2.0 + q[i] * q[i]).sqrt();
            }
            h
        }
    };
    for (item, degrees) in [(molecules, 12), (ring, 12)] {
        let before = forces(item, degrees);
        let after = packed(&before).expect("many quotients");
        assert!(count(&after, |statement| matches!(statement, Statement::Gather(..))) > 0);
        keeps_its_bits(&before, &after);
    }
}

/// A control: the machine detects exchanged lanes.
#[test]
#[should_panic(expected = "left == right")]
fn exchanged_lanes_are_seen() {
    let before = gravity(6);
    let mut after = packed(&before).expect("fifteen pairs");
    for statement in &mut after.statements {
        if let Statement::Spread(registers, _) = statement {
            registers.swap(0, 1);
        }
    }
    keeps_its_bits(&before, &after);
}

/// Levels of an iteration: packs read prepared numbers.
#[test]
fn prepared_factors_are_read_by_fours() {
    let (_, mut lowered) = lowered(quote! {
        fn gravity(q: [[f64; 2]; 5], p: [[f64; 2]; 5], m: [f64; 5]) -> f64 {
            let mut h = p[0][0];
            for i in 0..5 {
                for j in 0..i {
                    let [x, y] = [q[i][0] - q[j][0], q[i][1] - q[j][1]];
                    h -= m[i] * m[j] / (x * x + y * y).sqrt();
                }
            }
            h
        }
    });
    let gradient = diff::gradient(&mut lowered.graph, lowered.terms.energy, 10);
    let plan = schedule::plan(&mut lowered.graph, |symbol| level(symbol).min(1), &[&[]], &[&gradient.q]);
    let after = packed(&plan.last[0]).expect("ten pairs");
    let is_slot = |x: &schedule::Operand| matches!(x, schedule::Operand::Slot(..));
    let prepared = |statement: &Statement| matches!(statement, Statement::Gather(_, four) if four.iter().all(is_slot));
    assert_eq!(count(&after, prepared), 2);
}
