//! Nodes as formulas: for messages, documentation and snapshots.

use super::graph::Graph;
use super::hash::HashMap;
use super::id::Id;
use super::node::Node;
use super::number::{Number, Ratio};
use super::op::{Function, Relation, Symbol};
use std::cell::{Cell, RefCell};

/// Longer formulas are cut in messages.
const MESSAGE_LENGTH: usize = 90;

/// More than a message has room for is not printed: most nodes have a character of their own, symbols their names.
const SIZE_OF_MESSAGE: usize = 4 * MESSAGE_LENGTH;

/// Of a longer formula only the beginning is printed: shared nodes are printed again wherever they are read, and a formula can
/// be exponentially longer than its graph.
const MOST_NODES: usize = 1000;

/// The names that users gave to symbols.
pub(crate) trait Naming {
    fn name(&self, symbol: Symbol) -> String;
}

impl<F: Fn(Symbol) -> String> Naming for F {
    fn name(&self, symbol: Symbol) -> String {
        self(symbol)
    }
}

/// Prints nodes with the names that the user gave.
pub(crate) struct Printer<'a> {
    graph: &'a Graph,
    naming: &'a dyn Naming,
    /// What it has named before.
    names: RefCell<HashMap<Symbol, String>>,
    /// How many nodes may still be printed; or how many characters of names, and other nodes.
    left: Cell<usize>,
    /// Whether names count by their characters.
    short: Cell<bool>,
}

/// How tightly an operand must hold together.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Precedence {
    Sum,
    Product,
    Power,
    Atom,
}

impl<'a> Printer<'a> {
    pub(crate) fn new(graph: &'a Graph, naming: &'a dyn Naming) -> Self {
        Printer { graph, naming, names: RefCell::default(), left: Cell::new(0), short: Cell::new(false) }
    }

    /// What users call a symbol.
    pub(crate) fn named(&self, symbol: Symbol) -> String {
        self.names.borrow_mut().entry(symbol).or_insert_with(|| self.naming.name(symbol)).clone()
    }

    /// The whole formula, unless it is very long.
    pub(crate) fn formula(&self, id: Id) -> String {
        self.left.set(MOST_NODES);
        self.short.set(false);
        self.print(id, Precedence::Sum)
    }

    /// The formula, cut if it would not fit into a message.
    pub(crate) fn excerpt(&self, id: Id) -> String {
        self.left.set(SIZE_OF_MESSAGE);
        self.short.set(true);
        Self::cut(self.print(id, Precedence::Sum))
    }

    /// A formula, cut if it would not fit into a message.
    pub(crate) fn cut(formula: String) -> String {
        if formula.chars().count() <= MESSAGE_LENGTH {
            return formula;
        }
        formula.chars().take(MESSAGE_LENGTH).chain(" …".chars()).collect()
    }

    fn print(&self, id: Id, outside: Precedence) -> String {
        let Some(left) = self.left.get().checked_sub(1) else { return "…".into() };
        self.left.set(left);
        let (text, level) = match self.graph.node(id) {
            Node::Number(value) => {
                (number(*value), if value.is_negative() { Precedence::Sum } else { Precedence::Atom })
            }
            Node::Symbol(symbol) => {
                let name = self.named(*symbol);
                if self.short.get() {
                    self.left.set(left.saturating_sub(name.len()));
                }
                (name, Precedence::Atom)
            }
            Node::Linear(constant, terms) => self.linear(*constant, terms),
            Node::Product(_) | Node::Power(..) | Node::Call(Function::RecipPositive, _) => {
                self.fraction(Number::ONE, id)
            }
            Node::Call(function, args) => {
                let args: Vec<_> = args.iter().map(|id| self.print(*id, Precedence::Sum)).collect();
                (format!("{}({})", function.entry().name, args.join(", ")), Precedence::Atom)
            }
            Node::Select(c, a, b) => {
                let [c, a, b] = [c, a, b].map(|id| self.print(*id, Precedence::Sum));
                (format!("if {c} {{ {a} }} else {{ {b} }}"), Precedence::Sum)
            }
            Node::Compare(relation, a, b) => {
                let sign = match relation {
                    Relation::Less => "<",
                    Relation::LessEqual => "≤",
                    Relation::Equal => "=",
                };
                (
                    format!("{} {sign} {}", self.print(*a, Precedence::Sum), self.print(*b, Precedence::Sum)),
                    Precedence::Sum,
                )
            }
            Node::And(a, b) => (
                format!("{} and {}", self.print(*a, Precedence::Atom), self.print(*b, Precedence::Atom)),
                Precedence::Sum,
            ),
            Node::Or(a, b) => (
                format!("{} or {}", self.print(*a, Precedence::Atom), self.print(*b, Precedence::Atom)),
                Precedence::Sum,
            ),
            Node::Not(a) => (format!("not {}", self.print(*a, Precedence::Atom)), Precedence::Product),
            Node::Truth(value) => (value.to_string(), Precedence::Atom),
        };
        if level < outside { format!("({text})") } else { text }
    }

    fn linear(&self, constant: Number, terms: &[(Number, Id)]) -> (String, Precedence) {
        let mut text = String::new();
        // A positive term leads if there is one.
        let mut order: Vec<_> = terms.to_vec();
        if let Some(first) = order.iter().position(|(c, _)| !c.is_negative()) {
            order[..=first].rotate_right(1);
        }
        for (c, id) in order {
            let magnitude = if c.is_negative() { c.neg() } else { c };
            let sign = match (text.is_empty(), c.is_negative()) {
                (true, false) => "",
                (true, true) => "-",
                (false, false) => " + ",
                (false, true) => " - ",
            };
            text += sign;
            text += &self.scaled(magnitude, id);
        }
        if !constant.is_zero() {
            let magnitude = if constant.is_negative() { constant.neg() } else { constant };
            text += if constant.is_negative() { " - " } else { " + " };
            text += &number(magnitude);
        }
        let single = terms.len() == 1 && constant.is_zero() && !terms[0].0.is_negative();
        (text, if single { Precedence::Product } else { Precedence::Sum })
    }

    fn scaled(&self, c: Number, id: Id) -> String {
        match c {
            Number::ONE => self.print(id, Precedence::Product),
            _ => self.fraction(c, id).0,
        }
    }

    /// c·node as one fraction.
    fn fraction(&self, c: Number, id: Id) -> (String, Precedence) {
        let (mut above, mut below) = (vec![], vec![]);
        match c {
            Number::ONE => {}
            Number::Exact(Ratio { numerator, denominator }) if denominator < 100 => {
                above.extend((numerator != 1).then(|| numerator.to_string()));
                below.extend((denominator != 1).then(|| denominator.to_string()));
            }
            _ => above.push(number(c)),
        }
        let mut factors: Vec<(Id, Ratio)> =
            self.graph.factors(id).into_iter().map(|factor| self.quotient(factor)).collect();
        factors.sort_by_key(|(base, _)| *base);
        for (base, exponent) in factors {
            let side = if exponent.numerator < 0 { &mut below } else { &mut above };
            side.push(self.power(base, exponent));
        }
        let alone = below.is_empty() && above.len() == 1;
        let join = |factors: &[String]| factors.join("·");
        let text = match (&above[..], &below[..]) {
            (_, []) => join(&above),
            ([], [one]) => format!("1/{one}"),
            ([], _) => format!("1/({})", join(&below)),
            (_, [one]) => format!("{}/{one}", join(&above)),
            _ => format!("{}/({})", join(&above), join(&below)),
        };
        (text, if alone { Precedence::Power } else { Precedence::Product })
    }

    /// 1/x in the place of a reciprocal that is for positive x alone.
    fn quotient(&self, (base, exponent): (Id, Ratio)) -> (Id, Ratio) {
        match self.graph.node(base) {
            Node::Call(Function::RecipPositive, args) => (args[0], exponent.neg()),
            _ => (base, exponent),
        }
    }

    /// A base to the magnitude of an exponent.
    fn power(&self, base: Id, exponent: Ratio) -> String {
        let n = exponent.numerator.abs();
        match (n, exponent.denominator) {
            (1, 1) => self.print(base, Precedence::Atom),
            (1, _) => format!("√{}", self.print(base, Precedence::Atom)),
            (_, 1) => format!("{}{}", self.print(base, Precedence::Atom), superscript(n)),
            _ => format!("{}^({n}/{})", self.print(base, Precedence::Atom), exponent.denominator),
        }
    }
}

fn superscript(n: i128) -> String {
    n.to_string()
        .chars()
        .map(|c| c.to_digit(10).and_then(|d| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(d as usize)).unwrap_or(c))
        .collect()
}

fn number(value: Number) -> String {
    let (decimal, scientific) = (format!("{}", value.to_f64()), format!("{:e}", value.to_f64()));
    match value {
        // Short decimals are read more easily than fractions, and fractions of short numbers than long decimals.
        _ if decimal.len() <= 8 => decimal,
        Number::Exact(r) if r.numerator.abs().max(r.denominator) < 100_000 => {
            format!("{}/{}", r.numerator, r.denominator)
        }
        _ if decimal.len() <= scientific.len() + 3 => decimal,
        _ => scientific,
    }
}
