//! Methods of numbers, integers and vectors.

use super::Lowering;
use super::value::Value;
use crate::ir::op::FUNCTIONS;
use crate::ir::{Function, Id, Number, Ratio};
use quote::{ToTokens, quote};
use syn::ExprMethodCall;

impl Lowering {
    pub(super) fn method_call(&mut self, call: &ExprMethodCall) -> Value {
        let receiver = self.expr(&call.receiver);
        let name = call.method.to_string();
        let arguments: Vec<Value> = call.args.iter().map(|argument| self.expr(argument)).collect();
        if receiver.is_poison() || arguments.iter().any(Value::is_poison) {
            return Value::Poison;
        }
        if matches!(name.as_str(), "clone" | "to_owned") && arguments.is_empty() {
            return receiver;
        }
        match receiver {
            Value::Real(id) => self.method_of_real(&call.method, &name, id, arguments),
            // The constant may be an integer, and `/` on the result a division of integers.
            Value::Opaque(path) if matches!(name.as_str(), "abs" | "signum") && arguments.is_empty() => {
                let method = &call.method;
                Value::Opaque(quote!(#path.#method()))
            }
            Value::Opaque(_) if matches!(name.as_str(), "min" | "max") && is_opaque(&arguments) => {
                self.refuse(&call.method, "this is known to rustc alone: make it a constant outside of the function")
            }
            Value::Opaque(path) => {
                let id = self.constant(path);
                self.method_of_real(&call.method, &name, id, arguments)
            }
            Value::Vector(ids) => self.method_of_vector(call, &ids, &arguments),
            Value::Quaternion(ids) => self.method_of_quaternion(call, &ids, &arguments),
            Value::List(items) => self.method_of_array(call, &items, &arguments),
            Value::Iterator(items) => self.method_of_iterator(call, &items, &arguments),
            Value::Integer(n) => self.method_of_integer(call, n, &arguments),
            other => self.refuse(&call.method, format!("{} has no such method", other.kind())),
        }
    }

    fn method_of_integer(&mut self, call: &ExprMethodCall, n: i128, arguments: &[Value]) -> Value {
        let result = match (call.method.to_string().as_str(), arguments) {
            ("pow", [Value::Integer(k)]) => {
                u32::try_from(*k).ok().and_then(|k| n.checked_pow(k)).ok_or("this power is out of bounds")
            }
            ("abs", []) => Ok(n.saturating_abs()),
            ("min", [Value::Integer(k)]) => Ok(n.min(*k)),
            ("max", [Value::Integer(k)]) => Ok(n.max(*k)),
            ("rem_euclid", [Value::Integer(k)]) => n.checked_rem_euclid(*k).ok_or("this integer cannot be computed"),
            _ => Err("integers have `pow`, `abs`, `min`, `max` and `rem_euclid`; write `2.0` for a number"),
        };
        result.map_or_else(|message| self.refuse(&call.method, message), Value::Integer)
    }

    /// Calls a method of a number. All functions with a derivative rule are methods.
    pub(super) fn method_of_real(&mut self, syntax: &impl ToTokens, name: &str, x: Id, arguments: Vec<Value>) -> Value {
        if let (Some(function), true) = (Function::of_method(name), name != "powf") {
            if function.entry().arity != arguments.len() + 1 {
                let n = function.entry().arity - 1;
                let plural = if n == 1 { "" } else { "s" };
                return self.refuse(syntax, format!("`{name}` takes {n} argument{plural}"));
            }
            let mut args = vec![x];
            args.extend(arguments.into_iter().map(|value| self.real(syntax, value)));
            return Value::Real(self.graph.call(function, &args));
        }
        if let ("powi", [power]) = (name, &arguments[..]) {
            return match self.integer(syntax, power.clone()) {
                Some(n @ -64..=64) => Value::Real(self.graph.pow(x, Ratio::integer(n))),
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
            ("clamp", [low, high]) => {
                let raised = graph.call(Function::Max, &[x, *low]);
                Value::Real(graph.call(Function::Min, &[raised, *high]))
            }
            ("sin_cos", []) => {
                Value::Tuple([Function::Sin, Function::Cos].map(|f| Value::Real(graph.call(f, &[x]))).to_vec())
            }
            ("to_radians", []) => Value::Real(graph.scale(Number::float(std::f64::consts::PI / 180.0), x)),
            ("to_degrees", []) => Value::Real(graph.scale(Number::float(180.0 / std::f64::consts::PI), x)),
            _ => self.refuse(
                syntax,
                format!(
                    "`{name}` has no derivative rule; numbers have {}. Write another smooth function as a nested `fn`, by \
                     its formula or an approximation",
                    of_numbers().collect::<Vec<_>>().join(", ")
                ),
            ),
        }
    }

    fn method_of_vector(&mut self, call: &ExprMethodCall, ids: &[Id], arguments: &[Value]) -> Value {
        let (name, graph) = (&call.method, &mut self.graph);
        match (name.to_string().as_str(), arguments) {
            ("dot", [Value::Vector(other)]) if other.len() == ids.len() => Value::Real(graph.dot(ids, other)),
            ("norm_squared", []) => Value::Real(graph.dot(ids, ids)),
            ("norm" | "magnitude", []) => {
                let square = graph.dot(ids, ids);
                Value::Real(graph.sqrt(square))
            }
            ("cross", [Value::Vector(other)]) if ids.len() == 3 && other.len() == 3 => {
                Value::Vector(self.cross_product(ids, other).to_vec())
            }
            ("len", []) => Value::Integer(ids.len() as i128),
            ("iter", []) => Value::iterator(ids.iter().map(|id| Value::Real(*id))),
            ("sum", []) => Value::Real(graph.sum(ids)),
            _ => self.refuse(
                &call.method,
                format!(
                    "vectors have `dot`, `norm`, `norm_squared`, `cross`, `sum`, `iter` and components; not `{name}`"
                ),
            ),
        }
    }
}

/// Returns the names of all methods of numbers.
fn of_numbers() -> impl Iterator<Item = &'static str> {
    let others = ["sqrt", "powi", "recip", "mul_add", "clamp", "sin_cos", "to_radians", "to_degrees"];
    FUNCTIONS.iter().filter(|entry| entry.public).map(|entry| entry.name).chain(others)
}

/// Returns whether numbers have a method of the given name.
pub(super) fn is_of_numbers(name: &str) -> bool {
    of_numbers().any(|method| method == name)
}

/// Returns whether only rustc can evaluate the arguments.
fn is_opaque(arguments: &[Value]) -> bool {
    arguments.iter().all(|value| matches!(value, Value::Opaque(_) | Value::Integer(_)))
}
