//! Which coordinates a node reads.

use super::op::Symbol;

/// What a node reads of phase space.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Reads {
    pub(crate) q: bool,
    pub(crate) p: bool,
    pub(crate) v: bool,
    pub(crate) s: bool,
    pub(crate) t: bool,
}

impl Reads {
    /// Whether a position, a momentum, a velocity or the action is read.
    pub(crate) fn state(self) -> bool {
        self.q || self.p || self.v || self.s
    }

    /// Whether the value changes along a motion.
    pub(crate) fn moves(self) -> bool {
        self.state() || self.t
    }

    /// What reading a symbol is.
    pub(super) fn of(symbol: Symbol) -> Reads {
        let none = Reads::default();
        match symbol {
            Symbol::Q(_) | Symbol::Dq(_) => Reads { q: true, ..none },
            Symbol::P(_) | Symbol::Dp(_) => Reads { p: true, ..none },
            Symbol::V(_) | Symbol::Dv(_) => Reads { v: true, ..none },
            Symbol::S | Symbol::Ds => Reads { s: true, ..none },
            Symbol::T => Reads { t: true, ..none },
            Symbol::Parameter(_) | Symbol::Multiplier(_) | Symbol::H | Symbol::G => none,
        }
    }

    /// How many of q, p and s are read.
    pub(crate) fn kinds(self) -> usize {
        [self.q, self.p, self.s].into_iter().filter(|reads| *reads).count()
    }

    /// What one or the other reads.
    pub(crate) fn or(self, other: Reads) -> Reads {
        Reads {
            q: self.q || other.q,
            p: self.p || other.p,
            v: self.v || other.v,
            s: self.s || other.s,
            t: self.t || other.t,
        }
    }
}
