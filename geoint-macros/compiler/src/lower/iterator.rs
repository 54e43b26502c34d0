//! Methods of arrays and iterators. All items are known.

use super::Lowering;
use super::value::{Closure, Value};
use std::rc::Rc;
use syn::{BinOp, Expr, ExprMethodCall};

impl Lowering {
    pub(super) fn method_of_array(&mut self, call: &ExprMethodCall, items: &[Value], arguments: &[Value]) -> Value {
        let name = &call.method;
        match (name.to_string().as_str(), arguments) {
            ("iter" | "into_iter", []) => Value::iterator(items.iter().cloned()),
            ("len", []) => Value::Integer(items.len() as i128),
            ("windows", [Value::Integer(n @ 1..)]) => {
                Value::iterator(items.windows(count(n)).map(|window| Value::list(window.iter().cloned())))
            }
            ("map", [Value::Function(function)]) => self.map(call, items, function).map_or(Value::Poison, Value::list),
            _ => self.refuse(
                &call.method,
                format!("arrays have `iter`, `map`, `windows` and `len`; not `{name}` with these arguments"),
            ),
        }
    }

    pub(super) fn method_of_iterator(&mut self, call: &ExprMethodCall, items: &[Value], arguments: &[Value]) -> Value {
        let name = &call.method;
        match (name.to_string().as_str(), arguments) {
            ("iter" | "into_iter" | "copied" | "cloned", []) => Value::iterator(items.iter().cloned()),
            ("rev", []) => Value::iterator(items.iter().rev().cloned()),
            ("len" | "count", []) => Value::Integer(items.len() as i128),
            ("enumerate", []) => {
                let pair = |(i, item): (usize, &Value)| Value::Tuple(vec![Value::Integer(i as i128), item.clone()]);
                Value::iterator(items.iter().enumerate().map(pair))
            }
            ("zip", [other]) => {
                let Some(other) = self.list(&call.args[0], other.clone()) else { return Value::Poison };
                let pair = |(a, b): (&Value, &Value)| Value::Tuple(vec![a.clone(), b.clone()]);
                Value::iterator(items.iter().zip(other.iter()).map(pair))
            }
            ("step_by", [Value::Integer(n @ 1..)]) => Value::iterator(items.iter().step_by(count(n)).cloned()),
            ("skip", [Value::Integer(n @ 0..)]) => Value::iterator(items.iter().skip(count(n)).cloned()),
            ("take", [Value::Integer(n @ 0..)]) => Value::iterator(items.iter().take(count(n)).cloned()),
            ("map", [Value::Function(function)]) => {
                self.map(call, items, function).map_or(Value::Poison, Value::iterator)
            }
            ("flat_map", [Value::Function(function)]) => {
                let Some(mapped) = self.map(call, items, function) else { return Value::Poison };
                let lists: Option<Vec<_>> = mapped.into_iter().map(|inner| self.list(&call.args[0], inner)).collect();
                lists.map_or(Value::Poison, |lists| Value::iterator(lists.iter().flat_map(|list| list.iter().cloned())))
            }
            ("filter", [Value::Function(function)]) => self.filter(call, items, function),
            ("sum", []) => self.reduced(call, items, &BinOp::Add(Default::default())),
            ("product", []) => self.reduced(call, items, &BinOp::Mul(Default::default())),
            ("fold", [start, Value::Function(function)]) => self.fold(call, items, start.clone(), function),
            _ => self.refuse(
                &call.method,
                format!(
                    "iterators have `map`, `flat_map`, `filter`, `zip`, `enumerate`, `rev`, `skip`, `take`, `step_by`, `count`, \
                     `sum`, `product` and `fold`; not `{name}` with these arguments"
                ),
            ),
        }
    }

    /// Calls a function for each item. `None` after an error.
    fn map(&mut self, call: &ExprMethodCall, items: &[Value], function: &Closure) -> Option<Vec<Value>> {
        let errors = self.errors.len();
        let mut mapped = vec![];
        for item in items {
            if self.errors.len() > errors || self.exhausted(&call.method) {
                return None;
            }
            match self.apply(&call.method, function, vec![item.clone()]) {
                Value::Poison => return None,
                value => mapped.push(value),
            }
        }
        Some(mapped)
    }

    fn filter(&mut self, call: &ExprMethodCall, items: &[Value], function: &Closure) -> Value {
        let mut kept = vec![];
        for item in items {
            match self.apply(&call.method, function, vec![item.clone()]) {
                Value::Truth(truth) => match self.graph.as_truth(truth) {
                    Some(true) => kept.push(item.clone()),
                    Some(false) => {}
                    None => return self.refuse(&call.args[0], "a filter may depend on indices, not on data: use `if`"),
                },
                Value::Poison => return Value::Poison,
                _ => return self.refuse(&call.args[0], "a filter has a condition"),
            }
        }
        Value::iterator(kept)
    }

    /// Returns the sum or product of all items. An empty iterator gives the number 0 or 1.
    fn reduced(&mut self, call: &ExprMethodCall, items: &[Value], op: &BinOp) -> Value {
        let Some((first, others)) = items.split_first() else {
            let empty = if matches!(op, BinOp::Mul(_)) { 1 } else { 0 };
            return Value::Real(self.graph.integer(empty));
        };
        others.iter().fold(first.clone(), |total, item| self.arithmetic(call, op, total, item.clone()))
    }

    fn fold(&mut self, call: &ExprMethodCall, items: &[Value], start: Value, function: &Closure) -> Value {
        let mut total = start;
        for item in items {
            if self.exhausted(&call.method) {
                return Value::Poison;
            }
            total = self.apply(&call.method, function, vec![total, item.clone()]);
            if total.is_poison() {
                break;
            }
        }
        total
    }

    /// Returns the items of a value that can be iterated over.
    pub(super) fn list(&mut self, syntax: &Expr, value: Value) -> Option<Rc<Vec<Value>>> {
        match value {
            Value::List(items) | Value::Iterator(items) => return Some(items),
            Value::Vector(ids) => return Some(Rc::new(ids.into_iter().map(Value::Real).collect())),
            Value::Poison => {}
            other => {
                self.refuse(syntax, format!("loops go over ranges, arrays and iterators; this is {}", other.kind()));
            }
        }
        None
    }
}

/// Returns a number of items. Larger numbers than `usize::MAX` mean all items.
fn count(n: &i128) -> usize {
    usize::try_from(*n).unwrap_or(usize::MAX)
}
