//! One routine: nodes to statements.

use super::block::{Block, Instruction, Operand, Register, Statement};
use super::levels::{KnownLevels, Slots};
use crate::ir::{Function, Graph, HashIndex, HashMap, Id, Node, Number, Ratio, Symbol, Table, hash};

/// Powers of one base.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Powers {
    Halves,
    Whole,
}

impl Powers {
    pub(super) fn of(exponent: Ratio) -> Powers {
        if exponent.is_integer() { Powers::Whole } else { Powers::Halves }
    }
}

/// What divides 1, once, for several negative powers of one base, which are products of that.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Of {
    Base,
    Root,
}

/// A routine, or a branch in it, while it is being written.
#[derive(Default)]
pub(super) struct Scope {
    pub(super) block: Block,
    pub(super) values: Table<Operand>,
    /// Statements by their instructions.
    numbered: HashIndex,
    /// What is computed here whatever the conditions are.
    pub(super) always: Table<()>,
}

impl Scope {
    /// The value of an instruction with a hash, if there is one.
    fn known(&self, hash: u32, instruction: &Instruction) -> Option<Register> {
        let statements = self.block.statements.as_slice();
        let is = |number: usize| matches!(&statements[number], Statement::Let(_, other) if other == instruction);
        self.numbered.find(hash, is).and_then(|number| match &statements[number] {
            Statement::Let(register, _) => Some(*register),
            _ => None,
        })
    }
}

pub(super) struct Lowering<'a, F> {
    pub(super) graph: &'a mut Graph,
    pub(super) levels: &'a mut KnownLevels<F>,
    slots: &'a mut [Slots],
    pub(super) level: usize,
    pub(super) uses: Table<usize>,
    /// Sums out of which a factor was taken.
    pub(super) factored_out: Table<()>,
    pub(super) scopes: Vec<Scope>,
    /// When each register is there, in units of one sum, if nothing has to wait for anything but its operands.
    ready: Vec<u32>,
    /// Bases of which several negative powers are needed.
    pub(super) reciprocals: HashMap<(Id, Powers), Of>,
}

impl<'a, F: Fn(Symbol) -> usize> Lowering<'a, F> {
    /// The routine of `level` that computes `roots`.
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

    /// Sums that stand for multiples of others are used there as well.
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

    fn block(&mut self, roots: &[Id]) -> Block {
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

    /// What is needed for `roots` whatever the conditions are, at this level.
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

    /// The value of a node, computed if it is not known yet.
    pub(super) fn operand(&mut self, id: Id) -> Operand {
        match self.graph.node(id) {
            Node::Number(value) => return Operand::Constant(*value),
            Node::Truth(value) => return Operand::Truth(*value),
            _ => {}
        }
        // Slots hold numbers; a condition is decided again where it is needed.
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
        // Computed as far outside as it is needed whatever the conditions are.
        let last = self.scopes.len() - 1;
        let home = self.scopes.iter().position(|scope| scope.always.contains(id)).unwrap_or(last);
        let inner = if home < last { self.scopes.split_off(home + 1) } else { vec![] };
        let operand = self.compute(id);
        self.scopes[home].values.insert(id, operand);
        self.scopes.extend(inner);
        operand
    }

    pub(super) fn known(&self, id: Id) -> Option<Operand> {
        for scope in &self.scopes {
            if let Some(known) = scope.values.get(id) {
                return Some(known);
            }
        }
        None
    }

    /// The value of an instruction; equal ones are one statement.
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
            scope.block.statements.push(Statement::Let(register, instruction));
        }
        Operand::Register(register)
    }

    pub(super) fn register(&mut self, ready: u32) -> Register {
        self.ready.push(ready);
        self.ready.len() - 1
    }

    /// When an operand is there.
    pub(super) fn ready(&self, operand: &Operand) -> u32 {
        if let Operand::Register(register) = operand { self.ready[*register] } else { 0 }
    }

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
            Node::Call(Function::FlowChange, args) => self.flow_change(&args),
            Node::Call(function, args) => self.call(function, &args),
            Node::Select(condition, _, _) => self.select(id, condition),
            Node::Compare(relation, a, b) => {
                let (a, b) = (self.operand(a), self.operand(b));
                self.emit(Instruction::Compare(relation, a, b))
            }
            Node::And(a, b) => {
                let (a, b) = (self.operand(a), self.operand(b));
                self.emit(Instruction::And(a, b))
            }
            Node::Or(a, b) => {
                let (a, b) = (self.operand(a), self.operand(b));
                self.emit(Instruction::Or(a, b))
            }
            Node::Not(a) => {
                let a = self.operand(a);
                self.emit(Instruction::Not(a))
            }
        }
    }

    // ------------------------------------------------------------------------------------------ functions, branches

    /// A function, and beside it the one that shares its work, if that is needed too: sine and cosine are one call, a mean and its
    /// derivative have the same branches.
    fn call(&mut self, function: Function, args: &[Id]) -> Operand {
        let values: Vec<Operand> = args.iter().map(|arg| self.operand(*arg)).collect();
        let partner = function.partner().map(|partner| (partner, self.graph.call(partner, args)));
        let wanted =
            |id: Id| self.scopes.last().is_some_and(|scope| scope.always.contains(id)) && self.known(id).is_none();
        let Some((partner, id)) = partner.filter(|(_, id)| wanted(*id)) else {
            return self.emit(Instruction::Call(function, values));
        };
        let (own, others) = match function {
            Function::Sin | Function::Cos => {
                let ready = self.ready(&values[0]) + Instruction::CALL_LATENCY;
                let (sin, cos) = (self.register(ready), self.register(ready));
                if let Some(scope) = self.scopes.last_mut() {
                    scope.block.statements.push(Statement::SinCos(sin, cos, values[0]));
                }
                let both = [sin, cos].map(Operand::Register);
                if function == Function::Sin { both.into() } else { (both[1], both[0]) }
            }
            _ => {
                let own = self.emit(Instruction::Call(function, values.clone()));
                (own, self.emit(Instruction::Call(partner, values)))
            }
        };
        if let Some(scope) = self.scopes.last_mut() {
            scope.values.insert(id, others);
        }
        own
    }

    /// All selections by one condition that do not need each other, as one `if`.
    fn select(&mut self, id: Id, condition: Id) -> Operand {
        let mut group = vec![id];
        let always: Vec<Id> = self.scopes.last().map(|scope| scope.always.ids().collect()).unwrap_or_default();
        let candidates: Vec<Id> = always
            .into_iter()
            .filter(|other| matches!(self.graph.node(*other), Node::Select(c, _, _) if *c == condition))
            .filter(|other| *other != id && self.known(*other).is_none())
            .collect();
        for other in candidates {
            let needs = |a: Id, b: Id| self.graph.reachable(&[a]).contains(&b);
            if group.iter().all(|member| !needs(other, *member) && !needs(*member, other)) {
                group.push(other);
            }
        }
        let condition = self.operand(condition);
        let arms = |graph: &Graph, pick: fn(Id, Id) -> Id| -> Vec<Id> {
            let arm = |id: &Id| match graph.node(*id) {
                Node::Select(_, first, second) => pick(*first, *second),
                _ => *id,
            };
            group.iter().map(arm).collect()
        };
        let (first, second) = (arms(self.graph, |a, _| a), arms(self.graph, |_, b| b));
        let (first, second) = (self.block(&first), self.block(&second));
        let ready = first.results.iter().chain(&second.results).map(|x| self.ready(x)).max().unwrap_or(0);
        let registers: Vec<Register> = group.iter().map(|_| self.register(ready)).collect();
        if let Some(scope) = self.scopes.last_mut() {
            for (id, register) in group.iter().zip(&registers) {
                scope.values.insert(*id, Operand::Register(*register));
            }
            scope.block.statements.push(Statement::If { registers: registers.clone(), condition, first, second });
        }
        Operand::Register(registers[0])
    }
}
