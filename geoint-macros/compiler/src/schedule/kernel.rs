//! Kernels: routines that share prepared numbers. Each symbol is known at one level; each level has a routine.

use super::block::Block;
use super::levels::{KnownLevels, Slots};
use super::lowering::Lowering;
use super::operations::Operations;
use super::passes::arranged;
use super::routine::Routine;
use super::scheduler::Scheduler;
use super::space::Argument;
use crate::ir::{Graph, Id, Symbol};

/// The levels at which symbols become known. Every level but the last stores numbers for later levels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Levels {
    /// All symbols at one level.
    One,
    /// Parameters and h; then all other symbols.
    Prepared,
    /// Parameters and h; then the time at which a step is frozen; then the state.
    Frozen,
    /// Parameters and h; then nothing; then the state and time. Pieces with their own clock have as many levels as frozen pieces.
    Unfrozen,
    /// Parameters and h; then the start of a step; then the iterates.
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
            Symbol::Time | Symbol::StepStart | Symbol::StepEnd if self == Levels::Iterated => 1,
            _ if self == Levels::Iterated && symbol.is_coordinate() => 1,
            _ => self.stores(),
        }
    }

    /// Schedules routines, given by their nodes.
    fn plan(self, graph: &mut Graph, routines: &[&[Id]]) -> Plan {
        let none: &[Id] = &[];
        plan(graph, |symbol| self.of(symbol), &vec![none; self.stores()], routines)
    }
}

/// Returns the cost of computing some nodes at the last level, in units of one sum.
pub(crate) fn cost(graph: &mut Graph, levels: Levels, nodes: &[Id]) -> usize {
    levels.plan(graph, &[nodes]).last.iter().map(|block| block.operations().weight()).sum()
}

/// Routines that share prepared numbers.
#[derive(Clone, Debug)]
pub(crate) struct Kernel {
    pub(crate) levels: Levels,
    /// The array with the start of a step, for [`Levels::Iterated`].
    pub(crate) start: Option<Argument>,
    pub(crate) routines: Vec<Routine>,
    /// The routine of each level but the last. Its results are the numbers that later levels read.
    pub(crate) stores: Vec<Block>,
    /// The number of results of each of these routines.
    pub(crate) slots: Vec<usize>,
}

/// The result of [`Kernel::routine`] for an unknown name.
static NONE: Routine =
    Routine { name: "", argument: None, outputs: vec![], block: Block { statements: vec![], results: vec![] } };

impl Kernel {
    /// Creates a kernel without statements.
    pub(crate) fn new(levels: Levels, routines: Vec<Routine>) -> Kernel {
        Kernel { levels, start: None, routines, stores: vec![], slots: vec![] }
    }

    /// Returns a routine by name, or an empty routine if the kernel lacks it.
    pub(crate) fn routine(&self, name: &str) -> &Routine {
        self.find(name).unwrap_or(&NONE)
    }

    /// Returns a routine by name.
    pub(crate) fn find(&self, name: &str) -> Option<&Routine> {
        self.routines.iter().find(|routine| routine.name == name)
    }

    /// Computes the statements of all routines.
    pub(crate) fn schedule(&mut self, scheduler: &mut Scheduler<'_>) {
        let nodes: Vec<Vec<Id>> = self.routines.iter().map(Routine::nodes).collect();
        let nodes: Vec<&[Id]> = nodes.iter().map(Vec::as_slice).collect();
        let Plan { stores, last, slots } = self.levels.plan(scheduler.graph, &nodes);
        for (routine, block) in self.routines.iter_mut().zip(last) {
            routine.block = block;
            routine.arrange(scheduler);
        }
        let arrange = |(level, block)| {
            let start = self.start.as_ref().filter(|_| level > 0);
            arranged(block, &scheduler.places(start), &[])
        };
        self.stores = stores.into_iter().enumerate().map(arrange).collect();
        self.slots = slots;
    }

    /// Returns the cost of the first routine.
    pub(crate) fn operations(&self) -> Operations {
        self.routines.first().map_or_else(Operations::default, Routine::operations)
    }
}

/// Statements of routines that share prepared numbers.
#[derive(Clone, Debug)]
pub(crate) struct Plan {
    /// The routine of each level but the last. Its results are its own roots, then the slots.
    pub(crate) stores: Vec<Block>,
    /// The routines of the last level.
    pub(crate) last: Vec<Block>,
    /// The number of slots of each level but the last.
    pub(crate) slots: Vec<usize>,
}

/// Schedules routines. `stores` has the roots of the routine of each storing level, `last` the roots of each routine of the last level.
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
