//! Equal calls are inlined once: the same function with the same arguments has the same value.

use super::value::{Callable, Scopes, Value};
use crate::ir::{HashMap, Id};
use std::rc::Rc;

/// The key of a call: its value depends on nothing else.
#[derive(Clone, PartialEq, Eq, Hash)]
pub(super) struct Call {
    /// Addresses of the function and of the variables that a closure sees. Invariant: `Calls` keeps every function of its keys alive, so that no address is
    /// used again for another function.
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
    /// The conditions (`if`) around the call, if the function has nodes that are not defined everywhere, such as a root. Each such node has been noted with
    /// these conditions, so the result serves no call under other ones. `None` if any call may take the result.
    pub(super) conditions: Option<Vec<Id>>,
}

/// Calls that have been inlined.
#[derive(Default)]
pub(super) struct Calls {
    calls: HashMap<Call, Vec<Inlined>>,
    /// The functions of all keys, called ones and arguments.
    functions: Vec<(Rc<Callable>, Rc<Scopes>)>,
    arguments: Vec<Vec<Value>>,
}

impl Calls {
    /// Returns an equal call that was inlined under the same conditions, or that does not depend on them.
    pub(super) fn get(&self, call: &Call, conditions: &[Id]) -> Option<&Inlined> {
        let alike = |inlined: &&Inlined| inlined.conditions.as_ref().is_none_or(|own| own == conditions);
        self.calls.get(call)?.iter().find(alike)
    }

    /// Stores an inlined call, of which `call` is the key.
    pub(super) fn insert(
        &mut self,
        call: Call,
        (callable, sees): (&Rc<Callable>, &Rc<Scopes>),
        arguments: Vec<Value>,
        inlined: Inlined,
    ) {
        self.functions.push((callable.clone(), sees.clone()));
        if call.arguments.iter().any(|part| matches!(part, Part::Function(_))) {
            self.arguments.push(arguments);
        }
        self.calls.entry(call).or_default().push(inlined);
    }
}

impl Call {
    /// Returns the key of a call. `None` if an argument has no key: values that the language does not know, and those after a mistake.
    pub(super) fn of((callable, sees): (&Rc<Callable>, &Rc<Scopes>), arguments: &[Value]) -> Option<Call> {
        let mut parts = vec![];
        arguments.iter().try_for_each(|argument| append(argument, &mut parts))?;
        Some(Call { function: address(callable, sees), arguments: parts })
    }
}

/// Returns the addresses of a function and of the variables that it sees. Nested functions see items only, which are the same at every call.
fn address(callable: &Rc<Callable>, sees: &Rc<Scopes>) -> [usize; 2] {
    let sees = if callable.name.is_some() { 0 } else { Rc::as_ptr(sees).addr() };
    [Rc::as_ptr(callable).addr(), sees]
}

/// Appends the key of an argument.
fn append(value: &Value, parts: &mut Vec<Part>) -> Option<()> {
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
    elements.iter().try_for_each(|element| append(element, parts))
}
