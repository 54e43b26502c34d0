//! Formulas as Rust expressions: `graph.build(a * x + 1 / b)` builds the nodes of a·x + 1/b.
//!
//! Operators and the functions below only describe a formula. [`Graph::build`] adds its nodes, operands from left to right before their operation.

use super::graph::Graph;
use super::id::Id;
use super::number::{Number, Ratio};
use super::op::Function;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A formula. Its leaves are nodes and numbers.
pub(crate) enum Formula {
    Node(Id),
    Number(Number),
    Binary(fn(&mut Graph, Id, Id) -> Id, Box<[Formula; 2]>),
    Sum(Vec<Formula>),
    Power(Box<Formula>, Ratio),
    Call(Function, Vec<Formula>),
}

impl Graph {
    /// Builds the nodes of a formula.
    pub(crate) fn build(&mut self, formula: impl Into<Formula>) -> Id {
        match formula.into() {
            Formula::Node(id) => id,
            Formula::Number(value) => self.number(value),
            Formula::Binary(operation, operands) => {
                let [a, b] = operands.map(|operand| self.build(operand));
                operation(self, a, b)
            }
            Formula::Sum(terms) => {
                let terms: Vec<Id> = terms.into_iter().map(|term| self.build(term)).collect();
                self.sum(&terms)
            }
            Formula::Power(base, exponent) => {
                let base = self.build(*base);
                self.pow(base, exponent)
            }
            Formula::Call(function, args) => {
                let args: Vec<Id> = args.into_iter().map(|arg| self.build(arg)).collect();
                self.call(function, &args)
            }
        }
    }
}

/// Describes a sum. Unlike `a + b`, it keeps sums among its terms as single terms.
pub(crate) fn sum<const N: usize>(terms: [Formula; N]) -> Formula {
    Formula::Sum(terms.into())
}

/// Describes a power.
pub(crate) fn pow(base: impl Into<Formula>, exponent: Ratio) -> Formula {
    Formula::Power(Box::new(base.into()), exponent)
}

/// Describes a square.
pub(crate) fn squared(base: impl Into<Formula>) -> Formula {
    pow(base, Ratio::integer(2))
}

/// Describes the value of a function.
pub(crate) fn call<const N: usize>(function: Function, args: [impl Into<Formula>; N]) -> Formula {
    Formula::Call(function, args.map(Into::into).into())
}

/// Implements the operators for types of the left and the right operand.
macro_rules! operators {
    ($([$($bound:tt)*] $left:ty, $right:ty;)*) => { $(
        operators!(Add add [$($bound)*] $left, $right);
        operators!(Sub sub [$($bound)*] $left, $right);
        operators!(Mul mul [$($bound)*] $left, $right);
        operators!(Div div [$($bound)*] $left, $right);
    )* };
    ($operator:ident $method:ident [$($bound:tt)*] $left:ty, $right:ty) => {
        impl<$($bound)*> $operator<$right> for $left {
            type Output = Formula;
            fn $method(self, right: $right) -> Formula {
                Formula::Binary(Graph::$method, Box::new([self.into(), right.into()]))
            }
        }
    };
}

operators! {
    [T: Into<Formula>] Id, T;
    [T: Into<Formula>] Number, T;
    [T: Into<Formula>] Formula, T;
    [] i128, Id;
    [] i128, Formula;
}

impl Neg for Id {
    type Output = Formula;
    fn neg(self) -> Formula {
        Number::MINUS_ONE * self
    }
}

impl Neg for Formula {
    type Output = Formula;
    fn neg(self) -> Formula {
        Number::MINUS_ONE * self
    }
}

impl From<Id> for Formula {
    fn from(node: Id) -> Formula {
        Formula::Node(node)
    }
}

impl From<Number> for Formula {
    fn from(number: Number) -> Formula {
        Formula::Number(number)
    }
}

impl From<i128> for Formula {
    fn from(integer: i128) -> Formula {
        Formula::Number(Number::integer(integer))
    }
}
