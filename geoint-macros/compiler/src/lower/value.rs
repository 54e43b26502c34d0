//! What expressions evaluate to while a body is lowered, and what the names in them stand for: values and scopes hold each other.

use crate::ir::{HashMap, Id};
use crate::parse::{Leaf, Outside, Shape};
use proc_macro2::TokenStream;
use std::cell::RefCell;
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
    /// A unit quaternion of nalgebra: i, j, k, w.
    Quaternion([Id; 4]),
    /// An array.
    List(Rc<Vec<Value>>),
    /// A range, or an iterator over something.
    Iterator(Rc<Vec<Value>>),
    Tuple(Vec<Value>),
    /// A closure or a nested function, with what it sees.
    Callable(Rc<Callable>, Rc<Scopes>),
    /// A constant that lives outside the function, or what is computed from such constants alone. Only rustc knows its
    /// value, and whether its `/` is that of integers.
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
}

impl Callable {
    /// A function that is written as an item.
    pub(super) fn of(item: &syn::ItemFn) -> Self {
        let parameters = item.sig.inputs.iter().filter_map(|input| match input {
            syn::FnArg::Typed(typed) => Some((*typed.pat).clone()),
            syn::FnArg::Receiver(_) => None,
        });
        Callable {
            name: Some(item.sig.ident.to_string()),
            parameters: parameters.collect(),
            body: syn::Expr::Block(syn::ExprBlock { attrs: vec![], label: None, block: (*item.block).clone() }),
        }
    }
}

/// A `const` item, evaluated when it is first used: items may refer to later ones.
pub(super) struct Constant {
    pub(super) expr: syn::Expr,
    pub(super) value: RefCell<Progress>,
}

/// Nested scopes of one function body. A clone shares its levels until one of both changes: that is how a closure
/// captures what it sees.
#[derive(Clone)]
pub(super) struct Scopes {
    pub(super) levels: Vec<Rc<Level>>,
    /// Variables of levels below this one may not be assigned to: they are outside of this branch or function.
    pub(super) closed_below: (usize, Around),
    /// What is known of the file around the function.
    pub(super) outside: Rc<Outside>,
    /// Whether that is another file, or module, than the energy's.
    pub(super) foreign: bool,
}

/// A block: variables are visible from their `let` on, items from its first line on.
#[derive(Clone, Default)]
pub(super) struct Level {
    pub(super) variables: HashMap<String, Value>,
    pub(super) items: HashMap<String, Item>,
}

/// An item that can be named in an expression.
#[derive(Clone)]
pub(super) enum Item {
    Function(Rc<Callable>),
    /// A function from outside of the energy, and what it sees.
    Outside(Rc<Callable>, Rc<Scopes>),
    Constant(Rc<Constant>),
    /// A constant of the standard library under the name that `use` gives it.
    Import(Value),
}

/// What has variables of its own, and may not assign to others.
#[derive(Clone, Copy)]
pub(super) enum Around {
    Branch,
    Function,
}

/// How far the evaluation of a constant is.
#[derive(Clone)]
pub(super) enum Progress {
    Untouched,
    /// Whoever asks now is part of the definition.
    Underway,
    Known(Value),
}

impl Value {
    /// What this is, for messages.
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
            Value::Callable(..) => "a function",
            Value::Opaque(_) => "a constant",
            Value::Poison => "an error",
        }
    }

    pub(super) fn unit() -> Value {
        Value::Tuple(vec![])
    }

    pub(super) fn list(items: Vec<Value>) -> Value {
        Value::List(Rc::new(items))
    }

    pub(super) fn iterator(items: impl IntoIterator<Item = Value>) -> Value {
        Value::Iterator(Rc::new(items.into_iter().collect()))
    }
}

/// Scalars in the shape of an argument.
pub(super) fn shaped(shape: &Shape, ids: &[Id]) -> Value {
    match shape.extents[..] {
        [] => Value::Real(ids[0]),
        [_] if shape.leaf == Leaf::Vector => Value::Vector(ids.to_vec()),
        [4] if shape.leaf == Leaf::Quaternion => Value::Quaternion([ids[0], ids[1], ids[2], ids[3]]),
        [_] => Value::list(ids.iter().map(|id| Value::Real(*id)).collect()),
        [_, ref inner @ ..] => {
            let inner = Shape { extents: inner.to_vec(), leaf: shape.leaf };
            Value::list(ids.chunks(inner.len()).map(|chunk| shaped(&inner, chunk)).collect())
        }
    }
}

/// The index of a component that is named by its axis.
pub(super) fn axis(name: &proc_macro2::Ident) -> Option<usize> {
    ["x", "y", "z", "w"].iter().position(|axis| name == axis)
}
