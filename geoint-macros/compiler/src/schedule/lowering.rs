//! Lowers the nodes of one routine to statements.

use super::block::{Block, Statement};
use super::instruction::{Instruction, Operand, Register};
use super::levels::{KnownLevels, Slots};
use crate::ir::{Function, Graph, HashIndex, HashMap, Id, Node, Number, Ratio, Symbol, Table, hash};

/// A class of powers of one base: half-integer exponents, or whole ones.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Powers {
    Halves,
    Whole,
}

impl Powers {
    /// Returns the class of an exponent.
    pub(super) fn of(exponent: Ratio) -> Powers {
        if exponent.is_integer() { Powers::Whole } else { Powers::Halves }
    }
}

/// The divisor of the division for several negative powers of a base.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Of {
    Base,
    Root,
}

/// A routine, or a branch in it, during lowering.
#[derive(Default)]
pub(super) struct Scope {
    pub(super) block: Block,
    pub(super) values: Table<Operand>,
    /// The numbers of statements by the hashes of their instructions.
    numbered: HashIndex,
    /// The unconditional nodes: the scope computes each of them in any case.
    pub(super) always: Table<()>,
}

impl Scope {
    /// Returns the value of an instruction with a hash, if the scope has one.
    fn known(&self, hash: u32, instruction: &Instruction) -> Option<Register> {
        let statements = self.block.statements.as_slice();
        let is = |number: usize| matches!(&statements[number], Statement::Let(_, other) if other == instruction);
        self.numbered.find(hash, is).and_then(|number| match &statements[number] {
            Statement::Let(register, _) => Some(*register),
            _ => None,
        })
    }
}

/// Returns the statements that compute some nodes, if all symbols are known at once.
pub(crate) fn statements(graph: &mut Graph, nodes: &[Id]) -> Block {
    Lowering::run(graph, &mut KnownLevels::new(|_| 0), &mut [], 0, nodes)
}

/// The lowering of a routine.
pub(super) struct Lowering<'a, F> {
    pub(super) graph: &'a mut Graph,
    pub(super) levels: &'a mut KnownLevels<F>,
    slots: &'a mut [Slots],
    pub(super) level: usize,
    pub(super) uses: Table<usize>,
    /// Sums that remain after a factor was taken out.
    pub(super) factored_out: Table<()>,
    pub(super) scopes: Vec<Scope>,
    /// The time at which each register is ready, in units of one sum, if an operation waits for its operands only.
    ready: Vec<u32>,
    /// The bases of several negative powers.
    pub(super) reciprocals: HashMap<(Id, Powers), Of>,
}

impl<'a, F: Fn(Symbol) -> usize> Lowering<'a, F> {
    /// Returns the routine of `level` that computes `roots`.
    pub(super) fn run(
        graph: &'a mut Graph,
        levels: &'a mut KnownLevels<F>,
        slots: &'a mut [Slots],
        level: usize,
        roots: &[Id],
    ) -> Block {
        let mut uses: Table<usize> = Table::default();
        let mut count = |id: Id| uses.insert(id, uses.get(id).unwrap_or(0) + 1);
        let reachable = graph.reachable(roots);
        for id in &reachable {
            graph.node(*id).for_each_child(&mut count);
        }
        roots.iter().copied().for_each(count);
        let mut lowering = Lowering {
            graph,
            levels,
            slots,
            level,
            uses,
            factored_out: Table::default(),
            scopes: vec![],
            ready: vec![],
            reciprocals: HashMap::default(),
        };
        lowering.count_multiples(&reachable);
        lowering.find_reciprocals(&reachable);
        lowering.block(roots)
    }

    /// Counts the uses of multiples of sums.
    fn count_multiples(&mut self, reachable: &[Id]) {
        for id in reachable {
            let Node::Linear(_, terms) = self.graph.node(*id) else { continue };
            let is_multiple = |(c, id): &&(Number, Id)| !c.is_one() && matches!(self.graph.node(*id), Node::Linear(..));
            let multiples: Vec<(Number, Id)> = terms.iter().filter(is_multiple).copied().collect();
            for (c, sum) in multiples {
                let (_, other) = self.multiple(c, sum);
                if let Some(uses) = self.uses.get(other).filter(|_| other != sum) {
                    self.uses.insert(other, uses + 1);
                }
            }
        }
    }

    /// Lowers `roots` to a routine or a branch.
    pub(super) fn block(&mut self, roots: &[Id]) -> Block {
        let always = self.always(roots);
        self.scopes.push(Scope { always, ..Scope::default() });
        let mut results = vec![];
        for root in roots {
            results.push(self.operand(*root));
        }
        let mut block = self.scopes.pop().map(|scope| scope.block).unwrap_or_default();
        block.results = results;
        block
    }

    /// Returns the unconditional nodes of this level: `roots` need them in any case.
    fn always(&mut self, roots: &[Id]) -> Table<()> {
        let mut seen: Table<()> = Table::default();
        let mut open = roots.to_vec();
        while let Some(id) = open.pop() {
            if seen.contains(id) || self.levels.of(self.graph, id) != Some(self.level) {
                continue;
            }
            seen.insert(id, ());
            match self.graph.node(id) {
                Node::Select(condition, _, _) => open.push(*condition),
                node => node.for_each_child(|child| {
                    if !seen.contains(child) {
                        open.push(child);
                    }
                }),
            }
        }
        seen
    }

    // ------------------------------------------------------------------------------------------------------ values

    /// Returns the value of a node. Lowers the node if the value is not known.
    pub(super) fn operand(&mut self, id: Id) -> Operand {
        match self.graph.node(id) {
            Node::Number(value) => return Operand::Constant(*value),
            Node::Truth(value) => return Operand::Truth(*value),
            _ => {}
        }
        // Slots hold numbers. A condition is decided again at each level.
        match self.levels.of(self.graph, id) {
            Some(level) if level < self.level && !self.graph.node(id).is_condition() => {
                return Operand::Slot(level, self.slots[level].slot(self.graph, id));
            }
            _ => {}
        }
        if let Node::Symbol(symbol) = self.graph.node(id) {
            return Operand::Input(*symbol);
        }
        if let Some(known) = self.known(id) {
            return known;
        }
        // The outermost scope with this unconditional node computes the value.
        let last = self.scopes.len() - 1;
        let home = self.scopes.iter().position(|scope| scope.always.contains(id)).unwrap_or(last);
        let inner = if home < last { self.scopes.split_off(home + 1) } else { vec![] };
        let operand = self.compute(id);
        self.scopes[home].values.insert(id, operand);
        self.scopes.extend(inner);
        operand
    }

    /// Returns the value of a node, if it is known.
    pub(super) fn known(&self, id: Id) -> Option<Operand> {
        for scope in &self.scopes {
            if let Some(known) = scope.values.get(id) {
                return Some(known);
            }
        }
        None
    }

    /// Returns the value of an instruction. Equal instructions are one statement.
    pub(super) fn emit(&mut self, instruction: Instruction) -> Operand {
        if let Instruction::Neg(Operand::Constant(value)) = instruction {
            return Operand::Constant(value.neg());
        }
        let hash = hash::of(&instruction);
        for scope in &self.scopes {
            if let Some(known) = scope.known(hash, &instruction) {
                return Operand::Register(known);
            }
        }
        let register = self.register(instruction.ready(|operand| self.ready(operand)));
        if let Some(scope) = self.scopes.last_mut() {
            scope.numbered.insert(hash, scope.block.statements.len());
        }
        self.push(Statement::Let(register, instruction));
        Operand::Register(register)
    }

    /// Returns a new register with the time at which the value is ready.
    pub(super) fn register(&mut self, ready: u32) -> Register {
        self.ready.push(ready);
        self.ready.len() - 1
    }

    /// Returns the time at which an operand is ready.
    pub(super) fn ready(&self, operand: &Operand) -> u32 {
        if let Operand::Register(register) = operand { self.ready[*register] } else { 0 }
    }

    /// Lowers a node by its kind. Its value is not known yet.
    fn compute(&mut self, id: Id) -> Operand {
        match self.graph.node(id).clone() {
            Node::Number(value) => Operand::Constant(value),
            Node::Truth(value) => Operand::Truth(value),
            Node::Symbol(symbol) => Operand::Input(symbol),
            Node::Linear(constant, terms) => self.linear(constant, terms),
            Node::Product(_) => self.product(id),
            Node::Power(base, exponent) => self.power(base, exponent),
            Node::Call(function, args) if Function::KEPLER.contains(&function) => self.kepler(id, &args),
            Node::Call(Function::FlowMatrix, args) => self.flow_matrix(&args),
            Node::Call(Function::FlowChange, args) => self.flow_change(id, &args),
            Node::Call(function, args) => self.call(function, &args),
            Node::Select(condition, _, _) => self.select(id, condition),
            Node::Compare(relation, a, b) => self.binary(a, b, |a, b| Instruction::Compare(relation, a, b)),
            Node::And(a, b) => self.binary(a, b, Instruction::And),
            Node::Or(a, b) => self.binary(a, b, Instruction::Or),
            Node::Not(a) => {
                let a = self.operand(a);
                self.emit(Instruction::Not(a))
            }
        }
    }

    /// Lowers two nodes, then an instruction with both as operands.
    fn binary(&mut self, a: Id, b: Id, instruction: impl Fn(Operand, Operand) -> Instruction) -> Operand {
        let (a, b) = (self.operand(a), self.operand(b));
        self.emit(instruction(a, b))
    }

    /// Adds a statement to the innermost scope.
    pub(super) fn push(&mut self, statement: Statement) {
        if let Some(scope) = self.scopes.last_mut() {
            scope.block.statements.push(statement);
        }
    }
}
