//! Values of expressions, and scopes, which bind names to values. A closure is a value with the scopes around it, so one file defines both.

use crate::ir::{HashMap, Id};
use crate::parse::{Leaf, Outside, Shape};
use proc_macro2::{Ident, TokenStream};
use std::cell::RefCell;
use std::rc::Rc;
use syn::{Expr, ExprBlock, FnArg, ItemFn, Pat};

/// Value of an expression.
#[derive(Clone)]
pub(super) enum Value {
    /// A floating-point number.
    Real(Id),
    /// An integer. All integers are known during lowering.
    Integer(i128),
    /// A condition.
    Truth(Id),
    /// A column vector of nalgebra.
    Vector(Vec<Id>),
    /// A unit quaternion of nalgebra, in the order i, j, k, w.
    Quaternion([Id; 4]),
    /// An array.
    List(Rc<Vec<Value>>),
    /// A range or an iterator. All items are known.
    Iterator(Rc<Vec<Value>>),
    Tuple(Vec<Value>),
    Function(Closure),
    /// An expression of constants from outside of the function. Only rustc knows the value, and whether `/` divides integers.
    Opaque(TokenStream),
    /// Result of a reported error. Operations on it report no further errors.
    Poison,
}

/// A closure or a nested function, with the names in its scope.
#[derive(Clone)]
pub(super) struct Closure {
    pub(super) callable: Rc<Callable>,
    pub(super) scopes: Rc<Scopes>,
}

/// Source of a closure or of a nested function.
pub(super) struct Callable {
    /// Name of a nested function. `None` for closures.
    pub(super) name: Option<String>,
    pub(super) parameters: Vec<Pat>,
    pub(super) body: Expr,
}

/// Nested scopes of one function body. Empty by default.
///
/// A clone shares its levels until either copy changes. Closures capture their environment as a clone.
#[derive(Clone, Default)]
pub(super) struct Scopes {
    pub(super) levels: Vec<Rc<Level>>,
    pub(super) barrier: Barrier,
    /// Constants and type aliases from outside of the function, and aliases of the blocks around.
    pub(super) outside: Rc<Outside>,
    /// Whether the function comes from another file or module than the energy. Unknown names may have another meaning in its file.
    pub(super) is_foreign: bool,
}

/// A block. Its variables are visible after their `let`, its items in the whole block.
#[derive(Clone, Default)]
pub(super) struct Level {
    pub(super) variables: HashMap<String, Value>,
    pub(super) items: HashMap<String, Item>,
}

/// Limit for assignments: variables below the level are read-only.
#[derive(Clone, Copy, Default)]
pub(super) struct Barrier {
    pub(super) level: usize,
    pub(super) around: Around,
}

/// Kind of code whose outer variables are read-only.
#[derive(Clone, Copy, Default)]
pub(super) enum Around {
    Branch,
    #[default]
    Function,
}

/// An item that expressions can name.
#[derive(Clone)]
pub(super) enum Item {
    /// A nested function.
    Function(Rc<Callable>),
    /// A function under `#[energy_function]`.
    Outside(Closure),
    Constant(Rc<Constant>),
    /// A constant of the standard library or of the attribute.
    Import(Value),
}

/// A `const` item. Its value is computed at the first use, because items may refer to later items.
pub(super) struct Constant {
    pub(super) expr: Expr,
    pub(super) value: RefCell<Progress>,
}

/// State of the evaluation of a constant.
#[derive(Clone)]
pub(super) enum Progress {
    Untouched,
    /// Evaluation has started. A use in this state is a cycle.
    Underway,
    Known(Value),
}

impl Callable {
    pub(super) fn of(item: &ItemFn) -> Self {
        let parameters = item.sig.inputs.iter().filter_map(|input| match input {
            FnArg::Typed(typed) => Some((*typed.pat).clone()),
            FnArg::Receiver(_) => None,
        });
        Callable {
            name: Some(item.sig.ident.to_string()),
            parameters: parameters.collect(),
            body: Expr::Block(ExprBlock { attrs: vec![], label: None, block: (*item.block).clone() }),
        }
    }
}

impl Value {
    /// Returns a description for messages.
    pub(super) fn kind(&self) -> &'static str {
        match self {
            Value::Real(_) => "a number",
            Value::Integer(_) => "an integer (write `2.0` for a number)",
            Value::Truth(_) => "a condition",
            Value::Vector(_) => "a vector",
            Value::Quaternion(_) => "an attitude",
            Value::List(_) => "an array",
            Value::Iterator(_) => "an iterator",
            Value::Tuple(items) if items.is_empty() => "nothing: the last expression must be a value",
            Value::Tuple(_) => "a tuple",
            Value::Function(_) => "a function",
            Value::Opaque(_) => "a constant",
            Value::Poison => "an error",
        }
    }

    pub(super) fn unit() -> Value {
        Value::Tuple(vec![])
    }

    pub(super) fn list(items: impl IntoIterator<Item = Value>) -> Value {
        Value::List(Rc::new(items.into_iter().collect()))
    }

    pub(super) fn iterator(items: impl IntoIterator<Item = Value>) -> Value {
        Value::Iterator(Rc::new(items.into_iter().collect()))
    }

    pub(super) fn is_poison(&self) -> bool {
        matches!(self, Value::Poison)
    }

    /// Returns a part of nested arrays, tuples and vectors.
    pub(super) fn part(&self, indices: &[usize]) -> Option<Value> {
        match (indices, self) {
            ([], value) => Some(value.clone()),
            ([i], Value::Vector(ids)) => ids.get(*i).map(|id| Value::Real(*id)),
            ([i, rest @ ..], Value::List(items)) => items.get(*i)?.part(rest),
            ([i, rest @ ..], Value::Tuple(items)) => items.get(*i)?.part(rest),
            _ => None,
        }
    }

    /// Replaces a part of nested arrays, tuples and vectors. `None` if the part does not exist.
    pub(super) fn replace_part(&mut self, indices: &[usize], new: Value) -> Option<()> {
        match (indices, self) {
            ([], value) => *value = new,
            (_, value) if new.is_poison() => *value = Value::Poison,
            ([i], Value::Vector(ids)) => match new {
                Value::Real(id) => *ids.get_mut(*i)? = id,
                _ => return None,
            },
            ([i, rest @ ..], Value::List(items)) => Rc::make_mut(items).get_mut(*i)?.replace_part(rest, new)?,
            ([i, rest @ ..], Value::Tuple(items)) => items.get_mut(*i)?.replace_part(rest, new)?,
            _ => return None,
        }
        Some(())
    }
}

/// Returns the value of an argument. `ids` are its scalars.
pub(super) fn shaped(shape: &Shape, ids: &[Id]) -> Value {
    match shape.extents[..] {
        [] => Value::Real(ids[0]),
        [_] if shape.leaf == Leaf::Vector => Value::Vector(ids.to_vec()),
        [4] if shape.leaf == Leaf::Quaternion => Value::Quaternion([ids[0], ids[1], ids[2], ids[3]]),
        [_] => Value::list(ids.iter().map(|id| Value::Real(*id))),
        [_, ref inner @ ..] => {
            let inner = Shape { extents: inner.to_vec(), leaf: shape.leaf };
            Value::list(ids.chunks(inner.len()).map(|chunk| shaped(&inner, chunk)))
        }
    }
}

/// Returns the index of the component `x`, `y`, `z` or `w`.
pub(super) fn axis(name: &Ident) -> Option<usize> {
    ["x", "y", "z", "w"].iter().position(|axis| name == axis)
}
