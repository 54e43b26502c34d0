//! Methods of arrays and iterators, whose items are known one by one.

use super::Lowering;
use super::value::{Callable, Scopes, Value};
use std::rc::Rc;
use syn::{Expr, ExprMethodCall};

impl Lowering {
    pub(super) fn method_of_array(
        &mut self,
        call: &ExprMethodCall,
        name: &str,
        items: &Rc<Vec<Value>>,
        arguments: &[Value],
    ) -> Value {
        match (name, arguments) {
            ("iter" | "into_iter", []) => Value::Iterator(items.clone()),
            ("len", []) => Value::Integer(items.len() as i128),
            ("windows", [Value::Integer(n @ 1..)]) => {
                let windows = items.windows(count(n));
                Value::iterator(windows.map(|window| Value::list(window.to_vec())))
            }
            ("map", [Value::Callable(function, sees)]) => match self.map(call, items, (function, sees)) {
                Some(mapped) => Value::list(mapped),
                None => Value::Poison,
            },
            _ => self.refuse(
                &call.method,
                format!("arrays have `iter`, `map`, `windows` and `len`; not `{name}` with these arguments"),
            ),
        }
    }

    pub(super) fn method_of_iterator(
        &mut self,
        call: &ExprMethodCall,
        name: &str,
        items: &Rc<Vec<Value>>,
        arguments: &[Value],
    ) -> Value {
        match (name, arguments) {
            ("iter" | "into_iter" | "copied" | "cloned", []) => Value::Iterator(items.clone()),
            ("rev", []) => Value::iterator(items.iter().rev().cloned()),
            ("len" | "count", []) => Value::Integer(items.len() as i128),
            ("enumerate", []) => {
                let pair = |(i, item): (usize, &Value)| Value::Tuple(vec![Value::Integer(i as i128), item.clone()]);
                Value::iterator(items.iter().enumerate().map(pair))
            }
            ("zip", [other]) => match self.list(&call.args[0], other.clone()) {
                Some(other) => {
                    let pair = |(a, b): (&Value, &Value)| Value::Tuple(vec![a.clone(), b.clone()]);
                    Value::iterator(items.iter().zip(other.iter()).map(pair))
                }
                None => Value::Poison,
            },
            ("step_by", [Value::Integer(n @ 1..)]) => Value::iterator(items.iter().step_by(count(n)).cloned()),
            ("skip", [Value::Integer(n @ 0..)]) => Value::iterator(items.iter().skip(count(n)).cloned()),
            ("take", [Value::Integer(n @ 0..)]) => Value::iterator(items.iter().take(count(n)).cloned()),
            ("map", [Value::Callable(function, sees)]) => match self.map(call, items, (function, sees)) {
                Some(mapped) => Value::iterator(mapped),
                None => Value::Poison,
            },
            ("flat_map", [Value::Callable(function, sees)]) => {
                let Some(mapped) = self.map(call, items, (function, sees)) else { return Value::Poison };
                let mut flat = vec![];
                for inner in mapped {
                    match self.list(&call.args[0], inner) {
                        Some(inner) => flat.extend(inner.iter().cloned()),
                        None => return Value::Poison,
                    }
                }
                Value::iterator(flat)
            }
            ("filter", [Value::Callable(function, sees)]) => self.filter(call, items, (function, sees)),
            ("sum", []) => self.reduced(call, items, &syn::BinOp::Add(Default::default())),
            ("product", []) => self.reduced(call, items, &syn::BinOp::Mul(Default::default())),
            ("fold", [start, Value::Callable(function, sees)]) => {
                self.fold(call, items, start.clone(), (function, sees))
            }
            _ => self.refuse(
                &call.method,
                format!(
                    "iterators have `map`, `flat_map`, `filter`, `zip`, `enumerate`, `rev`, `skip`, `take`, `step_by`, `count`, \
                     `sum`, `product` and `fold`; not `{name}` with these arguments"
                ),
            ),
        }
    }

    fn map(
        &mut self,
        call: &ExprMethodCall,
        items: &[Value],
        (function, sees): (&Rc<Callable>, &Rc<Scopes>),
    ) -> Option<Vec<Value>> {
        let said = self.errors.len();
        let mut mapped = vec![];
        for item in items {
            if self.errors.len() > said || self.exhausted(&call.method) {
                return None;
            }
            match self.apply(&call.method, (function, sees), vec![item.clone()]) {
                Value::Poison => return None,
                value => mapped.push(value),
            }
        }
        Some(mapped)
    }

    fn filter(
        &mut self,
        call: &ExprMethodCall,
        items: &[Value],
        (function, sees): (&Rc<Callable>, &Rc<Scopes>),
    ) -> Value {
        let mut kept = vec![];
        for item in items {
            match self.apply(&call.method, (function, sees), vec![item.clone()]) {
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

    /// Sum or product; of nothing it is a number.
    fn reduced(&mut self, call: &ExprMethodCall, items: &[Value], op: &syn::BinOp) -> Value {
        let mut items = items.iter().cloned();
        let Some(mut total) = items.next() else {
            let nothing = if matches!(op, syn::BinOp::Mul(_)) { 1 } else { 0 };
            return Value::Real(self.graph.integer(nothing));
        };
        for item in items {
            total = self.arithmetic(call, op, total, item);
        }
        total
    }

    fn fold(
        &mut self,
        call: &ExprMethodCall,
        items: &[Value],
        start: Value,
        (function, sees): (&Rc<Callable>, &Rc<Scopes>),
    ) -> Value {
        let mut total = start;
        for item in items {
            if self.exhausted(&call.method) {
                return Value::Poison;
            }
            total = self.apply(&call.method, (function, sees), vec![total, item.clone()]);
            if matches!(total, Value::Poison) {
                break;
            }
        }
        total
    }

    /// A value as a list to go over.
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

/// A number of items, of which there are never more than that.
fn count(n: &i128) -> usize {
    usize::try_from(*n).unwrap_or(usize::MAX)
}
