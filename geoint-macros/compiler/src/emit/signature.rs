//! Tables of the runtime's traits that some systems lack: associated types, and signatures of methods.

/// A type in a signature.
#[derive(Clone, Copy)]
pub(super) enum Ty {
    /// The scalar.
    Number,
    Index,
    /// Start, midpoint and end of a step.
    Span,
    /// The array of positions, or of momenta.
    Array,
    /// The array of all coordinates.
    Phase,
    /// `R`, or `()` without an action.
    Action,
    /// A number for each coordinate.
    PerCoordinate,
    /// An associated type of the trait.
    Associated(&'static str),
    Square(&'static Ty),
    Pair(&'static Ty),
    Ref(&'static Ty),
    Mut(&'static Ty),
}

/// An associated type in the implementation of a trait that a system lacks.
#[derive(Clone, Copy)]
pub(super) enum Absent {
    /// A type without values. A method that takes a reference to it cannot be called.
    Never,
    Unit,
    Is(Ty),
}

/// The attribute `inline` of a method. Methods of an absent trait have no attribute.
#[derive(Clone, Copy)]
pub(super) enum Inline {
    Hint,
    Always,
}

/// The signature of a method with `&self`.
pub(super) struct Method {
    pub(super) inline: Inline,
    pub(super) name: &'static str,
    /// Patterns and types. The pattern `s or _` is `_` in a system without an action.
    pub(super) arguments: &'static [(&'static str, Ty)],
    pub(super) returns: Option<Ty>,
    /// True if a comma follows the last argument, as in a list over several lines.
    pub(super) is_wide: bool,
}

/// A trait of the runtime that a system may lack.
pub(super) struct Trait {
    pub(super) name: &'static str,
    /// True if the trait has the associated type `Proof`.
    pub(super) has_proof: bool,
    pub(super) associated: &'static [(&'static str, Absent)],
    /// The required methods.
    pub(super) methods: &'static [Method],
    /// The methods with a default.
    pub(super) provided: &'static [Method],
}

/// A type of a signature in the syntax of Rust. `[T] x 2` is an array of two.
macro_rules! ty {
    (&mut $($of:tt)+) => { $crate::emit::signature::Ty::Mut(&$crate::emit::signature::ty!($($of)+)) };
    (& $($of:tt)+) => { $crate::emit::signature::Ty::Ref(&$crate::emit::signature::ty!($($of)+)) };
    ([$($of:tt)+] x 2) => { $crate::emit::signature::Ty::Pair(&$crate::emit::signature::ty!($($of)+)) };
    (Square<$of:ident>) => { $crate::emit::signature::Ty::Square(&$crate::emit::signature::ty!($of)) };
    (R) => { $crate::emit::signature::Ty::Number };
    (usize) => { $crate::emit::signature::Ty::Index };
    (Span) => { $crate::emit::signature::Ty::Span };
    (Array) => { $crate::emit::signature::Ty::Array };
    (Phase) => { $crate::emit::signature::Ty::Phase };
    (Action) => { $crate::emit::signature::Ty::Action };
    (PerCoordinate) => { $crate::emit::signature::Ty::PerCoordinate };
    ($associated:ident) => { $crate::emit::signature::Ty::Associated(stringify!($associated)) };
}

/// Signatures of methods: `Always fn kick("prepared": {&Kick}, "t": {R}) -> Kick;`. The word `wide` after the arguments sets [`Method::is_wide`].
macro_rules! methods {
    ($($inline:ident fn $name:ident($($pattern:literal: {$($ty:tt)+}),*) $($wide:ident)? $(-> $returns:ident)?;)*) => {
        &[$($crate::emit::signature::Method {
            inline: $crate::emit::signature::Inline::$inline,
            name: stringify!($name),
            arguments: &[$(($pattern, $crate::emit::signature::ty!($($ty)+))),*],
            returns: methods!(@returns $($returns)?),
            is_wide: methods!(@wide $($wide)?),
        }),*]
    };
    (@returns) => { None };
    (@returns $ty:ident) => { Some($crate::emit::signature::ty!($ty)) };
    (@wide) => { false };
    (@wide wide) => { true };
}
pub(super) use {methods, ty};
