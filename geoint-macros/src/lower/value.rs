//! What expressions evaluate to while a body is lowered.

use crate::ir::Id;
use crate::parse::Shape;
use proc_macro2::TokenStream;
use std::collections::HashMap;
use std::rc::Rc;

/// A value during lowering.
#[derive(Clone)]
pub(super) enum Value {
    /// A number.
    Real(Id),
    /// An integer; all of them are known.
    Integer(i128),
    /// A condition.
    Truth(Id),
    /// A column vector of nalgebra.
    Vector(Vec<Id>),
    /// An array, a range, or an iterator over something.
    List(Vec<Value>),
    Tuple(Vec<Value>),
    Callable(Rc<Callable>),
    /// A constant that lives outside the function.
    Opaque(TokenStream),
    /// What has been reported already.
    Poison,
}

/// A closure or a nested function.
pub(super) struct Callable {
    /// The name of a nested function.
    pub(super) name: Option<String>,
    pub(super) parameters: Vec<syn::Pat>,
    pub(super) body: syn::Expr,
    /// What a closure sees; nested functions see only items, which are bound when they are called.
    pub(super) visible: HashMap<String, Value>,
}

impl Value {
    /// What this is, for messages.
    pub(super) fn kind(&self) -> &'static str {
        match self {
            Value::Real(_) => "a number",
            Value::Integer(_) => "an integer (write `2.0` for a number)",
            Value::Truth(_) => "a condition",
            Value::Vector(_) => "a vector",
            Value::List(_) => "an array or iterator",
            Value::Tuple(items) if items.is_empty() => "nothing: the last expression must be a value",
            Value::Tuple(_) => "a tuple",
            Value::Callable(_) => "a function",
            Value::Opaque(_) => "a constant",
            Value::Poison => "an error",
        }
    }

    pub(super) fn unit() -> Value {
        Value::Tuple(vec![])
    }
}

/// Scalars in the shape of an argument.
pub(super) fn shaped(shape: &Shape, ids: &[Id]) -> Value {
    match shape.extents[..] {
        [] => Value::Real(ids[0]),
        [_] if shape.vector => Value::Vector(ids.to_vec()),
        [_] => Value::List(ids.iter().map(|id| Value::Real(*id)).collect()),
        [_, ref inner @ ..] => {
            let inner = Shape { extents: inner.to_vec(), vector: shape.vector };
            Value::List(ids.chunks(inner.len()).map(|chunk| shaped(&inner, chunk)).collect())
        }
    }
}
