//! Prints nodes as formulas for messages, documentation and snapshots.

use super::graph::Graph;
use super::hash::HashMap;
use super::id::Id;
use super::node::Node;
use super::number::{Number, Ratio};
use super::op::{Function, Relation};
use super::symbol::Symbol;
use std::cell::{Cell, RefCell};

/// Messages cut formulas with more characters than this.
const MESSAGE_LENGTH: usize = 90;

/// The budget of a formula in a message. A node costs 1, and a symbol also costs the length of its name.
const BUDGET_OF_MESSAGE: usize = 4 * MESSAGE_LENGTH;

/// The largest number of nodes in a formula. Shared nodes are printed wherever they are read, so a formula can be exponentially longer than its
/// graph.
const MOST_NODES: usize = 1000;

/// The names that users gave to symbols.
pub(crate) trait Naming {
    /// Returns the name of a symbol.
    fn name(&self, symbol: Symbol) -> String;
}

impl<F: Fn(Symbol) -> String> Naming for F {
    fn name(&self, symbol: Symbol) -> String {
        self(symbol)
    }
}

/// Prints nodes with the names of a [`Naming`].
pub(crate) struct Printer<'a> {
    graph: &'a Graph,
    naming: &'a dyn Naming,
    /// Cache of names, filled on demand.
    names: RefCell<HashMap<Symbol, String>>,
    /// The rest of the budget. The formula breaks off when it is zero.
    budget: Cell<usize>,
    /// Whether the names of symbols cost their lengths.
    names_cost: Cell<bool>,
}

/// The precedence of an operator. An operand with a lower precedence than its place gets parentheses.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Precedence {
    Sum,
    Product,
    Power,
    Atom,
}

impl<'a> Printer<'a> {
    /// Creates a printer of the nodes of a graph.
    pub(crate) fn new(graph: &'a Graph, naming: &'a dyn Naming) -> Self {
        Printer { graph, naming, names: RefCell::default(), budget: Cell::new(0), names_cost: Cell::new(false) }
    }

    /// Returns the name of a symbol.
    pub(crate) fn named(&self, symbol: Symbol) -> String {
        self.names.borrow_mut().entry(symbol).or_insert_with(|| self.naming.name(symbol)).clone()
    }

    /// Prints a formula. A very long formula breaks off after [`MOST_NODES`] nodes.
    pub(crate) fn formula(&self, id: Id) -> String {
        self.budget.set(MOST_NODES);
        self.names_cost.set(false);
        self.print(id, Precedence::Sum)
    }

    /// Prints a formula for a message and cuts it to [`MESSAGE_LENGTH`].
    pub(crate) fn excerpt(&self, id: Id) -> String {
        self.budget.set(BUDGET_OF_MESSAGE);
        self.names_cost.set(true);
        Self::cut(self.print(id, Precedence::Sum))
    }

    /// Cuts a formula to [`MESSAGE_LENGTH`].
    pub(crate) fn cut(formula: String) -> String {
        if formula.chars().count() <= MESSAGE_LENGTH {
            return formula;
        }
        formula.chars().take(MESSAGE_LENGTH).chain(" …".chars()).collect()
    }

    /// Prints a node as an operand of an operator with the precedence `outside`.
    fn print(&self, id: Id, outside: Precedence) -> String {
        let Some(budget) = self.budget.get().checked_sub(1) else { return "…".into() };
        self.budget.set(budget);
        let both = |a: Id, operator: &str, b: Id, precedence: Precedence| {
            (format!("{} {operator} {}", self.print(a, precedence), self.print(b, precedence)), Precedence::Sum)
        };
        let (text, level) = match self.graph.node(id) {
            Node::Number(value) => {
                (number(*value), if value.is_negative() { Precedence::Sum } else { Precedence::Atom })
            }
            Node::Symbol(symbol) => {
                let name = self.named(*symbol);
                if self.names_cost.get() {
                    self.budget.set(budget.saturating_sub(name.len()));
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
                both(*a, sign, *b, Precedence::Sum)
            }
            Node::And(a, b) => both(*a, "and", *b, Precedence::Atom),
            Node::Or(a, b) => both(*a, "or", *b, Precedence::Atom),
            Node::Not(a) => (format!("not {}", self.print(*a, Precedence::Atom)), Precedence::Product),
            Node::Truth(value) => (value.to_string(), Precedence::Atom),
        };
        if level < outside { format!("({text})") } else { text }
    }

    /// Prints a sum. A positive term leads, if there is one.
    fn linear(&self, constant: Number, terms: &[(Number, Id)]) -> (String, Precedence) {
        let mut text = String::new();
        let mut order = terms.to_vec();
        if let Some(first) = order.iter().position(|(c, _)| !c.is_negative()) {
            order[..=first].rotate_right(1);
        }
        for (c, id) in order {
            let magnitude = if c.is_negative() { c.neg() } else { c };
            text += match (text.is_empty(), c.is_negative()) {
                (true, false) => "",
                (true, true) => "-",
                (false, false) => " + ",
                (false, true) => " - ",
            };
            text += &match magnitude {
                Number::ONE => self.print(id, Precedence::Product),
                _ => self.fraction(magnitude, id).0,
            };
        }
        if !constant.is_zero() {
            let magnitude = if constant.is_negative() { constant.neg() } else { constant };
            text += if constant.is_negative() { " - " } else { " + " };
            text += &number(magnitude);
        }
        let single = terms.len() == 1 && constant.is_zero() && !terms[0].0.is_negative();
        (text, if single { Precedence::Product } else { Precedence::Sum })
    }

    /// Prints c·node as one fraction.
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
        let mut factors = self.graph.factors(id);
        for (base, exponent) in &mut factors {
            // The reciprocal of a positive node is printed as 1/x.
            if let Node::Call(Function::RecipPositive, args) = self.graph.node(*base) {
                (*base, *exponent) = (args[0], exponent.neg());
            }
        }
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

    /// Prints a base to the magnitude of an exponent.
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
        // Prefer short decimals to fractions, and fractions of short numbers to long decimals.
        _ if decimal.len() <= 8 => decimal,
        Number::Exact(r) if r.numerator.abs().max(r.denominator) < 100_000 => {
            format!("{}/{}", r.numerator, r.denominator)
        }
        _ if decimal.len() <= scientific.len() + 3 => decimal,
        _ => scientific,
    }
}
