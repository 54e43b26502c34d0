//! Cache of inlined calls. Two calls of one function with equal arguments have equal values, so the second reuses the first.

use super::value::{Closure, Value};
use crate::ir::{HashMap, Id};
use std::rc::Rc;

/// Key of a call. The value of the call depends on nothing else.
#[derive(Clone, PartialEq, Eq, Hash)]
pub(super) struct Call(Vec<Part>);

/// Part of a key.
#[derive(Clone, PartialEq, Eq, Hash)]
enum Part {
    Real(Id),
    Integer(i128),
    Truth(Id),
    /// Kind and length of a collection. Its elements follow.
    Collection(&'static str, usize),
    /// Addresses of a function and of its environment. Invariant: `Calls` keeps both alive, so no other function gets the same address.
    Function([usize; 2]),
}

/// An inlined call.
#[derive(Clone)]
pub(super) struct Inlined {
    pub(super) value: Value,
    /// Conditions (`if`) around the call, if the function has nodes that are not defined everywhere, such as a root. `None` if any call can reuse the value.
    ///
    /// The nodes have been noted under these conditions, so calls under other conditions can not reuse the value.
    pub(super) conditions: Option<Vec<Id>>,
}

/// Inlined calls of a body.
#[derive(Default)]
pub(super) struct Calls {
    calls: HashMap<Call, Vec<Inlined>>,
    /// Functions and arguments of all calls.
    alive: Vec<Value>,
}

impl Calls {
    /// Returns an equal call that was inlined under the same conditions, or without dependence on conditions.
    pub(super) fn get(&self, call: &Call, conditions: &[Id]) -> Option<&Inlined> {
        let is_valid = |inlined: &&Inlined| inlined.conditions.as_ref().is_none_or(|own| own == conditions);
        self.calls.get(call)?.iter().find(is_valid)
    }

    /// Stores an inlined call under its key.
    pub(super) fn insert(&mut self, call: Call, function: &Closure, arguments: Vec<Value>, inlined: Inlined) {
        self.alive.push(Value::Function(function.clone()));
        self.alive.extend(arguments);
        self.calls.entry(call).or_default().push(inlined);
    }
}

impl Call {
    /// Returns the key of a call. `None` if an argument is poison or a constant from outside of the function.
    pub(super) fn of(function: &Closure, arguments: &[Value]) -> Option<Call> {
        let mut parts = vec![Part::Function(address(function))];
        arguments.iter().try_for_each(|argument| append(argument, &mut parts))?;
        Some(Call(parts))
    }
}

/// Returns the addresses of a function and of its environment. The environment of nested functions contains only items and is the same at every call.
fn address(Closure { callable, scopes }: &Closure) -> [usize; 2] {
    let scopes = if callable.name.is_some() { 0 } else { Rc::as_ptr(scopes).addr() };
    [Rc::as_ptr(callable).addr(), scopes]
}

/// Appends the key of an argument.
fn append(value: &Value, parts: &mut Vec<Part>) -> Option<()> {
    let mut collection = |kind: &'static str, elements: &[Value]| {
        parts.push(Part::Collection(kind, elements.len()));
        elements.iter().try_for_each(|element| append(element, parts))
    };
    let part = match value {
        Value::Real(id) => Part::Real(*id),
        Value::Integer(n) => Part::Integer(*n),
        Value::Truth(id) => Part::Truth(*id),
        Value::Function(function) => Part::Function(address(function)),
        Value::Vector(ids) => return collection("vector", &ids.iter().map(|id| Value::Real(*id)).collect::<Vec<_>>()),
        Value::Quaternion(ids) => return collection("quaternion", &ids.map(Value::Real)),
        Value::List(items) => return collection("list", items),
        Value::Iterator(items) => return collection("iterator", items),
        Value::Tuple(items) => return collection("tuple", items),
        Value::Opaque(_) | Value::Poison => return None,
    };
    parts.push(part);
    Some(())
}
