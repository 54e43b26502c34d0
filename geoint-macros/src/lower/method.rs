//! Methods: of numbers, of vectors, of arrays and iterators.

use super::Lowering;
use super::value::Value;
use crate::ir::op::FUNCTIONS;
use crate::ir::{Function, Id, Number};
use quote::ToTokens;
use syn::{Expr, ExprMethodCall};

impl Lowering {
    pub(super) fn method_call(&mut self, call: &ExprMethodCall) -> Value {
        let receiver = self.expr(&call.receiver);
        let name = call.method.to_string();
        let arguments: Vec<Value> = call.args.iter().map(|argument| self.expr(argument)).collect();
        if matches!(receiver, Value::Poison) || arguments.iter().any(|value| matches!(value, Value::Poison)) {
            return Value::Poison;
        }
        if matches!(name.as_str(), "clone" | "to_owned") && arguments.is_empty() {
            return receiver;
        }
        match receiver {
            Value::Real(id) => self.method_of_real(&call.method, &name, id, arguments),
            Value::Opaque(path) => {
                let id = self.constant(path);
                self.method_of_real(&call.method, &name, id, arguments)
            }
            Value::Vector(ids) => self.method_of_vector(call, &name, ids, arguments),
            Value::List(items) => self.method_of_list(call, &name, items, arguments),
            Value::Integer(n) => match (name.as_str(), &arguments[..]) {
                ("pow", [Value::Integer(k)]) => match u32::try_from(*k).ok().and_then(|k| n.checked_pow(k)) {
                    Some(n) => Value::Integer(n),
                    None => self.refuse(&call.method, "this power is out of bounds"),
                },
                ("abs", []) => Value::Integer(n.saturating_abs()),
                _ => self.refuse(&call.method, "integers have `pow` and `abs`; write `2.0` for a number"),
            },
            other => self.refuse(&call.method, format!("{} has no such method", other.kind())),
        }
    }

    pub(super) fn method_of_real(&mut self, syntax: &impl ToTokens, name: &str, x: Id, arguments: Vec<Value>) -> Value {
        if let (Some(function), true) = (Function::of_method(name), name != "powf") {
            if function.entry().arity != arguments.len() + 1 {
                let n = function.entry().arity - 1;
                return self.refuse(syntax, format!("`{name}` takes {n} arguments"));
            }
            let mut args = vec![x];
            args.extend(arguments.into_iter().map(|value| self.real(syntax, value)));
            return Value::Real(self.graph.call(function, &args));
        }
        if let ("powi", [power]) = (name, &arguments[..]) {
            return match self.integer(syntax, power.clone()) {
                Some(n @ -64..=64) => Value::Real(self.integer_power(x, n as i64)),
                Some(_) => self.refuse(syntax, "exponents go from -64 to 64; write a larger power with `exp` and `ln`"),
                None => Value::Poison,
            };
        }
        let arguments: Vec<Id> = arguments.into_iter().map(|value| self.real(syntax, value)).collect();
        let graph = &mut self.graph;
        match (name, &arguments[..]) {
            ("sqrt", []) => Value::Real(graph.sqrt(x)),
            ("recip", []) => Value::Real(graph.recip(x)),
            ("powf", [y]) => Value::Real(self.power(x, *y)),
            ("mul_add", [a, b]) => {
                let product = graph.mul(x, *a);
                Value::Real(graph.add(product, *b))
            }
            ("sin_cos", []) => {
                Value::Tuple([Function::Sin, Function::Cos].map(|f| Value::Real(graph.call(f, &[x]))).to_vec())
            }
            ("to_radians", []) => Value::Real(graph.scale(Number::float(std::f64::consts::PI / 180.0), x)),
            ("to_degrees", []) => Value::Real(graph.scale(Number::float(180.0 / std::f64::consts::PI), x)),
            _ => {
                let names: Vec<_> = FUNCTIONS.iter().filter(|entry| entry.public).map(|entry| entry.name).collect();
                self.refuse(
                    syntax,
                    format!(
                        "`{name}` has no derivative rule; numbers have {}, sqrt, powi, recip, mul_add, sin_cos, \
                         to_radians, to_degrees",
                        names.join(", ")
                    ),
                )
            }
        }
    }

    fn method_of_vector(&mut self, call: &ExprMethodCall, name: &str, ids: Vec<Id>, arguments: Vec<Value>) -> Value {
        let graph = &mut self.graph;
        match (name, &arguments[..]) {
            ("dot", [Value::Vector(other)]) if other.len() == ids.len() => Value::Real(dot(graph, &ids, other)),
            ("norm_squared", []) => Value::Real(dot(graph, &ids, &ids)),
            ("norm" | "magnitude", []) => {
                let square = dot(graph, &ids, &ids);
                Value::Real(graph.sqrt(square))
            }
            ("cross", [Value::Vector(other)]) if ids.len() == 3 && other.len() == 3 => {
                let mut component = |i: usize| {
                    let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                    let (first, second) = (graph.mul(ids[j], other[k]), graph.mul(ids[k], other[j]));
                    graph.sub(first, second)
                };
                Value::Vector((0..3).map(&mut component).collect())
            }
            ("len", []) => Value::Integer(ids.len() as i128),
            ("iter", []) => Value::List(ids.into_iter().map(Value::Real).collect()),
            ("sum", []) => Value::Real(graph.sum(&ids)),
            _ => self.refuse(
                &call.method,
                format!("vectors have `dot`, `norm`, `norm_squared`, `cross`, `sum`, `iter` and components; not `{name}`"),
            ),
        }
    }

    fn method_of_list(&mut self, call: &ExprMethodCall, name: &str, items: Vec<Value>, arguments: Vec<Value>) -> Value {
        match (name, &arguments[..]) {
            ("iter" | "into_iter" | "copied" | "cloned", []) => Value::List(items),
            ("rev", []) => Value::List(items.into_iter().rev().collect()),
            ("len" | "count", []) => Value::Integer(items.len() as i128),
            ("enumerate", []) => {
                let pair = |(i, item)| Value::Tuple(vec![Value::Integer(i as i128), item]);
                Value::List(items.into_iter().enumerate().map(pair).collect())
            }
            ("zip", [other]) => match self.list(&call.args[0], other.clone()) {
                Some(other) => {
                    let pair = |(a, b)| Value::Tuple(vec![a, b]);
                    Value::List(items.into_iter().zip(other).map(pair).collect())
                }
                None => Value::Poison,
            },
            ("skip", [Value::Integer(n)]) => Value::List(items.into_iter().skip((*n).max(0) as usize).collect()),
            ("take", [Value::Integer(n)]) => Value::List(items.into_iter().take((*n).max(0) as usize).collect()),
            ("windows", [Value::Integer(n @ 1..)]) => {
                Value::List(items.windows(*n as usize).map(|window| Value::List(window.to_vec())).collect())
            }
            ("map" | "flat_map", [Value::Callable(function)]) => {
                let mut mapped = vec![];
                for item in items {
                    if self.exhausted(&call.method) {
                        return Value::Poison;
                    }
                    let value = self.apply(&call.method, function, vec![item]);
                    match (name, value) {
                        ("flat_map", value) => match self.list(&call.args[0], value) {
                            Some(inner) => mapped.extend(inner),
                            None => return Value::Poison,
                        },
                        (_, Value::Poison) => return Value::Poison,
                        (_, value) => mapped.push(value),
                    }
                }
                Value::List(mapped)
            }
            ("filter", [Value::Callable(function)]) => self.filter(call, items, &function.clone()),
            ("sum", []) => self.sum(call, items),
            _ => self.refuse(
                &call.method,
                format!(
                    "arrays and iterators have `iter`, `map`, `flat_map`, `filter`, `zip`, `enumerate`, `windows`, \
                     `rev`, `skip`, `take`, `len` and `sum`; not `{name}` with these arguments"
                ),
            ),
        }
    }

    fn filter(
        &mut self,
        call: &ExprMethodCall,
        items: Vec<Value>,
        function: &std::rc::Rc<super::value::Callable>,
    ) -> Value {
        let mut kept = vec![];
        for item in items {
            match self.apply(&call.method, function, vec![item.clone()]) {
                Value::Truth(truth) => match self.graph.as_truth(truth) {
                    Some(true) => kept.push(item),
                    Some(false) => {}
                    None => return self.refuse(&call.args[0], "a filter may depend on indices, not on data: use `if`"),
                },
                Value::Poison => return Value::Poison,
                _ => return self.refuse(&call.args[0], "a filter has a condition"),
            }
        }
        Value::List(kept)
    }

    fn sum(&mut self, call: &ExprMethodCall, items: Vec<Value>) -> Value {
        let mut items = items.into_iter();
        let Some(mut total) = items.next() else {
            return Value::Real(self.graph.zero());
        };
        for item in items {
            total = self.arithmetic(call, &syn::BinOp::Add(Default::default()), total, item);
        }
        match total {
            Value::Opaque(path) => Value::Real(self.constant(path)),
            total => total,
        }
    }

    /// A value as a list to go over.
    pub(super) fn list(&mut self, syntax: &Expr, value: Value) -> Option<Vec<Value>> {
        match value {
            Value::List(items) => return Some(items),
            Value::Vector(ids) => return Some(ids.into_iter().map(Value::Real).collect()),
            Value::Poison => {}
            other => {
                self.refuse(syntax, format!("loops go over ranges, arrays and iterators; this is {}", other.kind()));
            }
        }
        None
    }
}

fn dot(graph: &mut crate::ir::Graph, a: &[Id], b: &[Id]) -> Id {
    let products: Vec<Id> = a.iter().zip(b).map(|(a, b)| graph.mul(*a, *b)).collect();
    graph.sum(&products)
}
