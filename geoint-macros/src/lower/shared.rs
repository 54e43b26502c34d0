//! Equal calls are inlined once: the same function with the same arguments has the same value.

use super::value::{Callable, Scopes, Value};
use crate::ir::{HashMap, Id};
use std::rc::Rc;

/// A call, by everything that its value depends on.
#[derive(Clone, PartialEq, Eq, Hash)]
pub(super) struct Call {
    /// Addresses of the function and of the variables that a closure sees. `Calls` keeps both alive, so addresses are unique.
    function: [usize; 2],
    arguments: Vec<Part>,
}

/// A part of an argument.
#[derive(Clone, PartialEq, Eq, Hash)]
enum Part {
    Real(Id),
    Integer(i128),
    Truth(Id),
    /// Kind and length of a collection, the elements of which follow.
    Collection(&'static str, usize),
    Function([usize; 2]),
}

/// A call that has been inlined.
#[derive(Clone)]
pub(super) struct Inlined {
    pub(super) value: Value,
    /// Conditions around the call, if nodes that are not defined everywhere were noted with them.
    pub(super) conditions: Option<Vec<Id>>,
}

/// Calls that have been inlined.
#[derive(Default)]
pub(super) struct Calls {
    calls: HashMap<Call, Vec<Inlined>>,
    functions: Vec<(Rc<Callable>, Rc<Scopes>)>,
}

impl Calls {
    /// A call that was inlined under the same conditions, or that does not depend on them.
    pub(super) fn get(&self, call: &Call, conditions: &[Id]) -> Option<&Inlined> {
        let alike = |inlined: &&Inlined| inlined.conditions.as_ref().is_none_or(|own| own == conditions);
        self.calls.get(call)?.iter().find(alike)
    }

    pub(super) fn insert(&mut self, call: Call, (callable, sees): (&Rc<Callable>, &Rc<Scopes>), inlined: Inlined) {
        self.functions.push((callable.clone(), sees.clone()));
        self.calls.entry(call).or_default().push(inlined);
    }
}

impl Call {
    /// `None` if two arguments cannot be compared.
    pub(super) fn of((callable, sees): (&Rc<Callable>, &Rc<Scopes>), arguments: &[Value]) -> Option<Call> {
        let mut parts = vec![];
        arguments.iter().try_for_each(|argument| write(argument, &mut parts))?;
        Some(Call { function: address(callable, sees), arguments: parts })
    }
}

/// Nested functions see items only, which are the same at every call.
fn address(callable: &Rc<Callable>, sees: &Rc<Scopes>) -> [usize; 2] {
    let sees = if callable.name.is_some() { 0 } else { Rc::as_ptr(sees).addr() };
    [Rc::as_ptr(callable).addr(), sees]
}

fn write(value: &Value, parts: &mut Vec<Part>) -> Option<()> {
    let (kind, elements) = match value {
        Value::Real(id) => {
            parts.push(Part::Real(*id));
            return Some(());
        }
        Value::Integer(n) => {
            parts.push(Part::Integer(*n));
            return Some(());
        }
        Value::Truth(id) => {
            parts.push(Part::Truth(*id));
            return Some(());
        }
        Value::Callable(callable, sees) => {
            parts.push(Part::Function(address(callable, sees)));
            return Some(());
        }
        Value::Vector(ids) => ("vector", ids.iter().map(|id| Value::Real(*id)).collect()),
        Value::Quaternion(ids) => ("quaternion", ids.map(Value::Real).to_vec()),
        Value::List(items) => ("list", items.to_vec()),
        Value::Iterator(items) => ("iterator", items.to_vec()),
        Value::Tuple(items) => ("tuple", items.clone()),
        Value::Opaque(_) | Value::Poison => return None,
    };
    parts.push(Part::Collection(kind, elements.len()));
    elements.iter().try_for_each(|element| write(element, parts))
}
