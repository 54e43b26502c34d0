//! Sums take as few operations as by hand, without a loss of digits.

use super::machine::{Machine, level};
use crate::ir::{Id, Symbol};
use crate::schedule::{self, Instruction, Plan, Statement};
use crate::tests::{Noise, lowered};
use proc_macro2::TokenStream;
use quote::quote;

/// Plans a function of q, where p and parameters have an earlier level.
fn planned(item: TokenStream) -> Plan {
    let (_, mut lowered) = lowered(item);
    let energy = lowered.terms.energy;
    of(&mut lowered.graph, &[energy])
}

/// Plans nodes, where p and parameters have an earlier level.
fn of(graph: &mut crate::ir::Graph, roots: &[Id]) -> Plan {
    let early = |symbol: Symbol| usize::from(!matches!(symbol, Symbol::Momentum(_)) && level(symbol) > 0);
    schedule::plan(graph, early, &[&[]], &[roots])
}

#[test]
fn common_factors_are_taken_out() {
    // The number of sums and products, and the number of fused products.
    let cases = [
        // (a·y + b)·x
        (quote!(a * x * y + b * x), 3, 1),
        // (a·x + b)·x
        (quote!(a * x * x + b * x), 3, 1),
        // (b − a·y)·y + a·x²
        (quote!(a * x * x - a * y * y + b * y), 6, 2),
        // a·(y·(x + z) + z·x)
        (quote!(a * x * y + a * y * z + a * z * x), 5, 1),
        // 2·(½ + a·y) is 1 + 2a·y.
        (quote!(2.0 * x * (0.5 + a * y)), 3, 1),
        // 3·(2x − a) is a difference that may be exact,
        (quote!(3.0 * (2.0 * x - a)), 3, 1),
        // and 4·(2x − a) is 8x − 4a.
        (quote!(4.0 * (2.0 * x - a)), 2, 1),
        // No common factor.
        (quote!(x * y + a * z), 3, 1),
        // A common factor without a saving.
        (quote!(x * y + x), 2, 1),
    ];
    for (body, operations, fused) in cases {
        let plan = planned(quote! {
            fn sum(q: [f64; 3], p: [f64; 3]) -> f64 {
                let [x, y, z] = q;
                let [a, b, _] = p;
                let _ = (z, b);
                #body
            }
        });
        let is_fused = |statement: &&Statement| matches!(statement, Statement::Let(_, Instruction::MulAdd(..)));
        let block = &plan.last[0];
        let found = (block.operations().arithmetic, block.statements.iter().filter(is_fused).count());
        assert_eq!(found, (operations, fused), "{body}: {block:?}");
    }
}

/// A product with another use stays whole.
#[test]
fn products_with_other_uses_stay_whole() {
    let (_, mut lowered) = lowered(quote! {
        fn sum(q: [f64; 2], p: [f64; 2]) -> f64 {
            let xy = q[0] * q[1];
            (p[0] * xy + p[1] * q[0]) * xy.sin()
        }
    });
    let energy = lowered.terms.energy;
    let plan = of(&mut lowered.graph, &[energy]);
    // x·y, a·(x·y) + b·x, and the product with the sine.
    assert_eq!(plan.last[0].operations().arithmetic, 5, "{:?}", plan.last[0]);
}

/// x² − y² is zero for x = y, and k(2x − a) is exact near x = a/2. A control expands k(2x − a).
#[test]
fn differences_stay_exact() {
    let run = |item: TokenStream, values: [f64; 5]| {
        let plan = planned(item);
        let input = |symbol: Symbol| match symbol {
            Symbol::Position(i) => values[i as usize],
            Symbol::Momentum(i) => values[3 + i as usize],
            _ => f64::NAN,
        };
        let slots = vec![Machine::new(&[], &input).run(&plan.stores[0])];
        Machine::new(&slots, &input).run(&plan.last[0])[0]
    };
    let squares = quote!(
        fn squares(q: [f64; 3], p: [f64; 3]) -> f64 {
            p[0] * q[0] * q[0] - p[0] * q[1] * q[1] + p[1] * q[2]
        }
    );
    let rest = quote!(
        fn rest(q: [f64; 3], p: [f64; 3]) -> f64 {
            p[1] * (2.0 * q[0] - p[0])
        }
    );
    let expanded = quote!(
        fn rest(q: [f64; 3], p: [f64; 3]) -> f64 {
            2.0 * p[1] * q[0] - p[1] * p[0] + 0.0 * q[1]
        }
    );
    let mut noise = Noise(5);
    let mut differs = false;
    for _ in 0..20 {
        let [x, a, k] = [noise.between(0.5, 1.5), noise.between(0.5, 1.5), noise.between(0.5, 1.5)];
        assert_eq!(run(squares.clone(), [x, x, 0.0, a, k]), 0.0);
        let near = 0.5 * a * (1.0 + 1e-12 * x);
        let values = [near, 0.0, 0.0, a, k];
        assert_eq!(run(rest.clone(), values), k * (2.0 * near - a));
        differs |= run(expanded.clone(), values) != k * (2.0 * near - a);
    }
    assert!(differs);
}
