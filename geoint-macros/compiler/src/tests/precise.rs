//! Evaluates graphs with hundreds of digits, by the functions of another crate.

use crate::ir::of_steps;
use crate::ir::{Function, Graph, Id, Node, Number, Symbol};
use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;
use std::collections::HashMap;

pub(super) type Big = FBig<HalfEven, 2>;

/// Returns an exact copy with a precision of `bits`.
pub(super) fn big(x: f64, bits: usize) -> Big {
    Big::try_from(x).expect("a finite number").with_precision(bits).value()
}

fn constant(x: Number, bits: usize) -> Big {
    match x {
        Number::Exact(ratio) => big(ratio.numerator as f64, bits) / big(ratio.denominator as f64, bits),
        Number::Root(c, r) => constant(Number::Exact(c), bits) * big(r as f64, bits).sqrt(),
        Number::Float(_) => big(x.to_f64(), bits),
    }
}

/// Returns the value of `root`. Returns nothing if it does not exist, or if a value on the way exceeds 10⁴⁰.
pub(super) fn value(graph: &Graph, root: Id, bits: usize, symbol: &impl Fn(Symbol) -> Big) -> Option<Big> {
    let mut values: HashMap<Id, Option<Big>> = HashMap::new();
    for id in graph.reachable(&[root]) {
        let value = node(graph, id, bits, symbol, &|id| values[id].clone());
        let value = value.filter(|x| x.to_f64().value().abs() < 1e40);
        values.insert(id, value.map(|x| x.with_precision(bits).value()));
    }
    values.remove(&root)?
}

/// Returns the value of a node. The branch that is not chosen need not have a value.
fn node(
    graph: &Graph,
    id: Id,
    bits: usize,
    symbol: &impl Fn(Symbol) -> Big,
    of: &impl Fn(&Id) -> Option<Big>,
) -> Option<Big> {
    let truth = |x: bool| big(f64::from(u8::from(x)), bits);
    Some(match graph.node(id) {
        Node::Number(x) => constant(*x, bits),
        Node::Symbol(name) => symbol(*name),
        Node::Linear(c, terms) => {
            terms.iter().try_fold(constant(*c, bits), |sum, (c, id)| Some(sum + constant(*c, bits) * of(id)?))?
        }
        Node::Product(ids) => ids.iter().try_fold(big(1.0, bits), |product, id| Some(product * of(id)?))?,
        Node::Power(base, exponent) => {
            let base = of(base)?;
            if base < Big::ZERO && !exponent.is_integer() || base == Big::ZERO && exponent.numerator < 0 {
                return None;
            }
            let base = if exponent.is_integer() { base } else { base.sqrt() };
            base.powi(exponent.numerator.into())
        }
        Node::Call(function, args) => call(*function, &args.iter().map(of).collect::<Option<Vec<_>>>()?, bits)?,
        Node::Select(c, a, b) => of(if of(c)? == Big::ONE { a } else { b })?,
        Node::Compare(relation, a, b) => truth(relation.holds(f64::from(sign(&(of(a)? - of(b)?))), 0.0)),
        Node::And(a, b) => of(a)? * of(b)?,
        Node::Or(a, b) => of(a)?.max(of(b)?),
        Node::Not(a) => truth(of(a)? == Big::ZERO),
        Node::Truth(value) => truth(*value),
    })
}

fn sign(x: &Big) -> i8 {
    match x.cmp(&Big::ZERO) {
        std::cmp::Ordering::Less => -1,
        std::cmp::Ordering::Equal => 0,
        std::cmp::Ordering::Greater => 1,
    }
}

/// Returns the value of a function inside its domain. The match is exhaustive, so that every new function is compared with its definition here.
fn call(function: Function, args: &[Big], bits: usize) -> Option<Big> {
    let x = &args[0];
    let one = &Big::ONE;
    let is_inside = match function {
        Function::Asin | Function::Acos => *x >= -one && x <= one,
        Function::Atan2 => *x != Big::ZERO || args[1] != Big::ZERO,
        Function::Acosh => x >= one,
        Function::Atanh => *x > -one && x < one,
        Function::Ln | Function::Log2 | Function::Log10 | Function::Powf => *x > Big::ZERO,
        Function::Ln1p => *x > -one,
        _ => true,
    };
    is_inside.then(|| match function {
        Function::Sin => x.sin(),
        Function::Cos => x.cos(),
        Function::Tan => x.tan(),
        Function::Asin => x.asin(),
        Function::Acos => x.acos(),
        Function::Atan => x.atan(),
        Function::Atan2 => x.atan2(&args[1]),
        Function::Sinh => x.sinh(),
        Function::Cosh => x.cosh(),
        Function::Tanh => x.tanh(),
        Function::Asinh => x.asinh(),
        Function::Acosh => x.acosh(),
        Function::Atanh => x.atanh(),
        Function::Exp => x.exp(),
        Function::Exp2 => (x * big(2.0, bits).ln()).exp(),
        Function::ExpM1 => x.exp_m1(),
        Function::Ln => x.ln(),
        Function::Ln1p => x.ln_1p(),
        Function::Log2 => x.log2(),
        Function::Log10 => x.log10(),
        Function::Cbrt => x.nth_root(3),
        Function::Hypot => x.hypot(&args[1]),
        Function::Powf => x.powf(&args[1]),
        Function::Abs => big(f64::from(sign(x)), bits) * x,
        Function::Min => x.clone().min(args[1].clone()),
        Function::Max => x.clone().max(args[1].clone()),
        Function::Signum => big(f64::from(sign(x)), bits),
        Function::NotNegative | Function::Bounded | Function::RecipPositive | Function::Provided | of_steps!() => {
            unreachable!("energies are written without helpers")
        }
    })
}
