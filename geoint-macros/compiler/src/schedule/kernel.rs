//! Kernels: routines that share prepared values, and the times at which their symbols are known.

use super::block::{Block, Operations};
use super::levels::{KnownLevels, Slots};
use super::lowering::Lowering;
use crate::ir::{Graph, Id, Symbol};

/// The times at which symbols are known. Each level but the last is a routine that stores values for later levels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Levels {
    /// All symbols at once.
    One,
    /// Parameters and h; all other symbols.
    Prepared,
    /// Parameters and h; the time at which a step is frozen; the state.
    Frozen,
    /// Parameters and h; nothing; the state with its time.
    Unfrozen,
    /// Parameters and h; the start of a step; the iterates.
    Iterated,
}

impl Levels {
    /// Returns the number of levels before the last.
    fn stores(self) -> usize {
        match self {
            Levels::One => 0,
            Levels::Prepared => 1,
            Levels::Frozen | Levels::Unfrozen | Levels::Iterated => 2,
        }
    }

    /// Returns the level at which a symbol is known.
    fn of(self, symbol: Symbol) -> usize {
        match symbol {
            _ if self == Levels::One => 0,
            Symbol::Parameter(_) | Symbol::StepLength | Symbol::GradientWeight => 0,
            Symbol::Time if self == Levels::Frozen => 1,
            Symbol::Position(_) | Symbol::Momentum(_) | Symbol::Velocity(_) | Symbol::Action
                if self == Levels::Iterated =>
            {
                1
            }
            Symbol::Time | Symbol::StepStart | Symbol::StepEnd if self == Levels::Iterated => 1,
            _ => self.stores(),
        }
    }
}

/// The routines of the last level, as the nodes that each computes, and the levels of their symbols.
#[derive(Clone, Debug)]
pub(crate) struct Kernel {
    pub(crate) levels: Levels,
    pub(crate) routines: Vec<Vec<Id>>,
}

impl Kernel {
    /// Returns a kernel of one routine.
    pub(crate) fn new(levels: Levels, roots: Vec<Id>) -> Kernel {
        Kernel { levels, routines: vec![roots] }
    }

    /// Returns the statements of all routines.
    pub(crate) fn plan(&self, graph: &mut Graph) -> Plan {
        let none: &[Id] = &[];
        let routines: Vec<&[Id]> = self.routines.iter().map(Vec::as_slice).collect();
        plan(graph, |symbol| self.levels.of(symbol), &vec![none; self.levels.stores()], &routines)
    }
}

/// The statements of all routines of a kernel.
#[derive(Clone, Debug)]
pub(crate) struct Plan {
    /// For each level but the last, the routine that stores values for later levels. Its results are its own roots, then
    /// the slots.
    pub(crate) stores: Vec<Block>,
    /// The routines of the last level.
    pub(crate) last: Vec<Block>,
    /// The number of slots of each level but the last.
    pub(crate) slots: Vec<usize>,
}

impl Plan {
    /// Returns the operations of the first routine of the last level.
    pub(crate) fn operations(&self) -> Operations {
        self.last[0].operations()
    }
}

/// Plans the routines of a kernel. `stores` are the own roots of the routine of each level but the last, `last` the roots of
/// the routines of the last level.
pub(crate) fn plan(graph: &mut Graph, level: impl Fn(Symbol) -> usize, stores: &[&[Id]], last: &[&[Id]]) -> Plan {
    let mut levels = KnownLevels::new(level);
    let mut slots = vec![Slots::default(); stores.len()];
    let last = last.iter().map(|roots| Lowering::run(graph, &mut levels, &mut slots, stores.len(), roots)).collect();
    let mut store_blocks = vec![];
    for (level, own) in stores.iter().enumerate().rev() {
        // The slots of this level are complete, because only later levels read them.
        let roots = [own, &slots[level].nodes[..]].concat();
        store_blocks.push(Lowering::run(graph, &mut levels, &mut slots, level, &roots));
    }
    store_blocks.reverse();
    Plan { stores: store_blocks, last, slots: slots.iter().map(|slots| slots.width).collect() }
}
