//! Calls. Closures, nested functions and energy functions are inlined. A few functions of numbers and vectors are known.

use super::shared::{Call, Inlined};
use super::statement::simple_name;
use super::value::{Around, Closure, Value};
use super::{Lowering, method};
use crate::ir::Number;
use crate::messages::BY_HAND;
use crate::parse::{plain_path, vector_length};
use quote::ToTokens;
use std::rc::Rc;
use syn::{Expr, ExprCall, ExprPath, Type};

impl Lowering {
    /// Inlines a closure or a function.
    pub(super) fn apply(&mut self, syntax: &impl ToTokens, function: &Closure, arguments: Vec<Value>) -> Value {
        let callable = &function.callable;
        if callable.parameters.len() != arguments.len() {
            let n = callable.parameters.len();
            return self.refuse(syntax, format!("this takes {n} argument{}", if n == 1 { "" } else { "s" }));
        }
        if self.calls.iter().any(|other| Rc::ptr_eq(other, callable)) {
            let name = callable.name.as_deref().unwrap_or("this closure");
            return self
                .refuse(syntax, format!("`{name}` calls itself: nested functions are inlined and cannot recur"));
        }
        let call = Call::of(function, &arguments);
        if let Some(Inlined { value, conditions }) =
            call.as_ref().and_then(|call| self.inlined.get(call, &self.conditions))
        {
            // The calls around this one depend on the same conditions.
            self.noted_partial += usize::from(conditions.is_some());
            return value.clone();
        }
        if self.exhausted(syntax) {
            return Value::Poison;
        }
        self.note_partial();
        let (errors, noted) = (self.errors.len(), self.noted_partial);
        let before = std::mem::replace(&mut self.scopes, (*function.scopes).clone());
        self.calls.push(callable.clone());
        // The function may read the captured variables, but not assign to them.
        self.scopes.close(Around::Function);
        self.scopes.enter();
        for (pattern, argument) in callable.parameters.iter().zip(&arguments) {
            self.bind(pattern, argument.clone());
        }
        let value = self.expr(&callable.body);
        self.calls.pop();
        self.scopes = before;
        // A call with an error is not cached, so that every call reports the error.
        if let Some(call) = call.filter(|_| self.errors.len() == errors) {
            self.note_partial();
            let conditions = (self.noted_partial > noted).then(|| self.conditions.clone());
            self.inlined.insert(call, function, arguments, Inlined { value: value.clone(), conditions });
        }
        value
    }

    /// Evaluates a call by name.
    pub(super) fn call(&mut self, call: &ExprCall) -> Value {
        let path = match &*call.func {
            Expr::Path(path) => Some(path),
            _ => None,
        };
        let name = simple_name(&call.func).or_else(|| path.map(|path| plain_path(&path.path)));
        let found = name.and_then(|name| self.named(&call.func, &name));
        if found.is_none() && path.is_none() {
            return self.refuse(&call.func, "only nested functions and closures can be called");
        }
        let arguments: Vec<Value> = call.args.iter().map(|argument| self.expr(argument)).collect();
        match (found, path) {
            (Some(Value::Function(function)), _) => self.apply(&call.func, &function, arguments),
            (Some(Value::Poison), _) => Value::Poison,
            (Some(other), _) => {
                self.refuse(&call.func, format!("only functions can be called; this is {}", other.kind()))
            }
            (None, Some(path)) => self.known_function(call, path, arguments),
            (None, None) => Value::Poison,
        }
    }

    /// Calls a function of `f64` or of vectors.
    fn known_function(&mut self, call: &ExprCall, path: &ExprPath, arguments: Vec<Value>) -> Value {
        let mut segments: Vec<_> = path.path.segments.iter().map(|segment| segment.ident.to_string()).collect();
        if let [owner, _] = &mut segments[..]
            && let Some(Type::Path(path)) = self.scopes.outside.alias(owner)
            && let Some(last) = path.path.segments.last()
        {
            *owner = last.ident.to_string();
        }
        let (owner, function) = match &segments[..] {
            [.., owner, function] => (owner.as_str(), function.as_str()),
            [function] => ("", function.as_str()),
            [] => ("", ""),
        };
        match (owner, function, &arguments[..], vector_length(owner)) {
            ("f64" | "f32", ..) if segments.len() == 2 && owner != self.float => {
                let message = format!("all numbers of an energy have one type, here `{}`", self.float);
                self.refuse(&call.func, message)
            }
            ("f64" | "f32", "from", [argument], _) if segments.len() == 2 => match argument.clone() {
                Value::Integer(n) => Value::Real(self.graph.number(Number::float(n as f64))),
                Value::Opaque(path) => Value::Real(self.constant(path)),
                value => value,
            },
            ("f64" | "f32", method, [receiver, others @ ..], _) if segments.len() == 2 => {
                let id = self.real(call, receiver.clone());
                self.method_of_real(&call.func, method, id, others.to_vec())
            }
            (_, "new", arguments, Some(length)) if length == arguments.len() => {
                Value::Vector(arguments.iter().map(|value| self.real(call, value.clone())).collect())
            }
            (_, "zeros", [], Some(length)) => Value::Vector(vec![self.graph.zero(); length]),
            ("SVector", "from", [argument], _) | (_, "from", [argument], Some(_)) => match argument {
                Value::List(items) => {
                    Value::Vector(items.iter().map(|value| self.real(call, value.clone())).collect())
                }
                _ => self.refuse(call, "a vector is made from an array"),
            },
            (owner, ..) if is_matrix(owner) => self.refuse(
                &call.func,
                "an energy has vectors, but no matrices: write one as an array of arrays, `[[a, b], [c, d]]`, and its products \
                 as sums",
            ),
            (_, function, ..) if method::is_of_numbers(function) => {
                self.refuse(&call.func, format!("this is a method of numbers: `x.{function}()`"))
            }
            _ => self.unknown_function(call, &plain_path(&path.path)),
        }
    }

    /// Refuses an unknown function. The message is an advice to make it known.
    fn unknown_function(&mut self, call: &ExprCall, name: &str) -> Value {
        if self.calls.iter().any(|callable| callable.name.as_deref() == Some(name)) {
            return self.refuse(&call.func, format!("`{name}` calls itself: functions are inlined and cannot recur"));
        }
        let mut callers = self.calls.iter().rev().filter_map(|callable| callable.name.as_deref());
        let message = match callers.next().filter(|_| self.scopes.is_foreign) {
            Some(caller) => format!(
                "where `{caller}` is inlined nothing is known of `{name}`: put `#[energy_function]` above it, and \
                 `#[energy_function(with({name}))]` above `{caller}`"
            ),
            None => format!(
                "the macro cannot see into functions outside of the energy: put `#[energy_function]` above this one and name \
                 it in the attribute, `with({name})`; a function of another crate becomes a nested `fn`, by its formula or an \
                 approximation, see {BY_HAND}"
            ),
        };
        self.refuse(&call.func, message)
    }
}

/// Returns whether a name is a type of nalgebra for matrices, rotations or quaternions.
fn is_matrix(name: &str) -> bool {
    ["Matrix", "SMatrix", "Rotation", "Quaternion", "UnitQuaternion", "Isometry"]
        .iter()
        .any(|start| name.starts_with(start))
}
