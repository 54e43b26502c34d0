//! Calls: of closures and nested functions, which are inlined, and of the few others that are known.

use super::shared::{Call, Inlined};
use super::statement::simple_name;
use super::value::{Around, Callable, Scopes, Value};
use super::{Lowering, method};
use crate::ir::Number;
use crate::messages::BY_HAND;
use crate::parse::plain_path;
use quote::ToTokens;
use std::rc::Rc;
use syn::Expr;

impl Lowering {
    /// Calls a closure or nested function.
    pub(super) fn apply(
        &mut self,
        syntax: &impl ToTokens,
        (callable, sees): (&Rc<Callable>, &Rc<Scopes>),
        arguments: Vec<Value>,
    ) -> Value {
        if callable.parameters.len() != arguments.len() {
            let n = callable.parameters.len();
            return self.refuse(syntax, format!("this takes {n} argument{}", if n == 1 { "" } else { "s" }));
        }
        if self.calls.iter().any(|other| Rc::ptr_eq(other, callable)) {
            let name = callable.name.as_deref().unwrap_or("this closure");
            return self
                .refuse(syntax, format!("`{name}` calls itself: nested functions are inlined and cannot recur"));
        }
        let call = Call::of((callable, sees), &arguments);
        if let Some(known) = call.as_ref().and_then(|call| self.inlined_before(call)) {
            return known;
        }
        if self.exhausted(syntax) {
            return Value::Poison;
        }
        self.note_partial();
        let (errors, noted) = (self.errors.len(), self.noted_partial);
        let before = std::mem::replace(&mut self.scopes, Scopes::clone(sees));
        self.calls.push(callable.clone());
        // What is captured may be read, not assigned to.
        self.scopes.close(Around::Function);
        self.scopes.enter();
        for (pattern, argument) in callable.parameters.iter().zip(&arguments) {
            self.bind(pattern, argument.clone());
        }
        let value = self.expr(&callable.body);
        self.calls.pop();
        self.scopes = before;
        // A mistake is reported at every call.
        if let Some(call) = call.filter(|_| self.errors.len() == errors) {
            self.note_partial();
            let conditions = (self.noted_partial > noted).then(|| self.conditions.clone());
            self.inlined.insert(call, (callable, sees), arguments, Inlined { value: value.clone(), conditions });
        }
        value
    }

    /// The value of an equal call, unless nodes of it have to be noted under other conditions.
    fn inlined_before(&mut self, call: &Call) -> Option<Value> {
        let Inlined { value, conditions } = self.inlined.get(call, &self.conditions)?;
        self.noted_partial += usize::from(conditions.is_some());
        Some(value.clone())
    }

    pub(super) fn call(&mut self, call: &syn::ExprCall) -> Value {
        if let Some(name) = simple_name(&call.func)
            && let Some(found) = self.named(&call.func, &name)
        {
            let arguments = call.args.iter().map(|argument| self.expr(argument)).collect();
            return match found {
                Value::Callable(callable, sees) => self.apply(&call.func, (&callable, &sees), arguments),
                Value::Poison => Value::Poison,
                other => self.refuse(&call.func, format!("only functions can be called; this is {}", other.kind())),
            };
        }
        let Expr::Path(path) = &*call.func else {
            return self.refuse(&call.func, "only nested functions and closures can be called");
        };
        if let Some(Value::Callable(callable, sees)) = self.named(&call.func, &plain_path(&path.path)) {
            let arguments = call.args.iter().map(|argument| self.expr(argument)).collect();
            return self.apply(&call.func, (&callable, &sees), arguments);
        }
        let mut segments: Vec<_> = path.path.segments.iter().map(|segment| segment.ident.to_string()).collect();
        if let [owner, _] = &mut segments[..]
            && let Some(syn::Type::Path(path)) = self.scopes.outside().alias(owner)
            && let Some(last) = path.path.segments.last()
        {
            *owner = last.ident.to_string();
        }
        let arguments: Vec<Value> = call.args.iter().map(|argument| self.expr(argument)).collect();
        let (owner, function) = match &segments[..] {
            [.., owner, function] => (owner.as_str(), function.as_str()),
            [function] => ("", function.as_str()),
            [] => ("", ""),
        };
        match (owner, function) {
            ("f64" | "f32", _) if segments.len() == 2 && owner != self.float => {
                let message = format!("all numbers of an energy have one type, here `{}`", self.float);
                self.refuse(&call.func, message)
            }
            ("f64" | "f32", "from") if segments.len() == 2 && arguments.len() == 1 => {
                match arguments.into_iter().next() {
                    Some(Value::Integer(n)) => Value::Real(self.graph.number(Number::float(n as f64))),
                    Some(Value::Opaque(path)) => Value::Real(self.constant(path)),
                    value => value.unwrap_or(Value::Poison),
                }
            }
            ("f64" | "f32", method) if segments.len() == 2 && !arguments.is_empty() => {
                let mut arguments = arguments.into_iter();
                let receiver = arguments.next().unwrap_or(Value::Poison);
                let id = self.real(call, receiver);
                self.method_of_real(&call.func, method, id, arguments.collect())
            }
            (owner, "new") if vector_length(owner) == Some(arguments.len()) => {
                Value::Vector(arguments.into_iter().map(|value| self.real(call, value)).collect())
            }
            (owner, "zeros") if arguments.is_empty() && vector_length(owner).is_some() => {
                let zero = self.graph.zero();
                Value::Vector(vec![zero; vector_length(owner).unwrap_or_default()])
            }
            (owner, "from") if (owner == "SVector" || vector_length(owner).is_some()) && arguments.len() == 1 => {
                let items = match arguments.into_iter().next() {
                    Some(Value::List(items)) => items,
                    _ => return self.refuse(call, "a vector is made from an array"),
                };
                Value::Vector(items.iter().map(|value| self.real(call, value.clone())).collect())
            }
            (owner, _) if is_matrix(owner) => self.refuse(
                &call.func,
                "an energy has vectors, but no matrices: write one as an array of arrays, `[[a, b], [c, d]]`, and its products \
                 as sums",
            ),
            (_, function) if method::is_of_numbers(function) => {
                self.refuse(&call.func, format!("this is a method of numbers: `x.{function}()`"))
            }
            _ => self.outside_function(call, &plain_path(&path.path)),
        }
    }

    /// A function that is not known.
    fn outside_function(&mut self, call: &syn::ExprCall, name: &str) -> Value {
        if self.calls.iter().any(|callable| callable.name.as_deref() == Some(name)) {
            return self.refuse(&call.func, format!("`{name}` calls itself: functions are inlined and cannot recur"));
        }
        let whose =
            self.calls.iter().rev().find_map(|callable| callable.name.as_deref()).filter(|_| self.scopes.are_foreign());
        let message = match whose {
            Some(whose) => format!(
                "where `{whose}` is inlined nothing is known of `{name}`: put `#[energy_function]` above it, and \
                 `#[energy_function(with({name}))]` above `{whose}`"
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

/// Whether a name is that of a type of nalgebra with rows and columns, or of what turns vectors.
fn is_matrix(name: &str) -> bool {
    ["Matrix", "SMatrix", "Rotation", "Quaternion", "UnitQuaternion", "Isometry"]
        .iter()
        .any(|start| name.starts_with(start))
}

/// The length of a vector type of nalgebra that has its length in its name.
fn vector_length(name: &str) -> Option<usize> {
    name.strip_prefix("Vector")?.parse().ok().filter(|n| (1..=6).contains(n))
}
