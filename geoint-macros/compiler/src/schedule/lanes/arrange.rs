//! Packs that are known, as statements: what is done after what.

use super::{Lanes, Pack};
use crate::ir::HashMap;
use crate::schedule::block::{Block, LANES, Operand, Register, Statement};

impl Lanes<'_> {
    /// The statements in an order in which each finds what it reads.
    pub(super) fn arranged(&self) -> Block {
        let mut alone = vec![false; self.next];
        let mut read = |operand: &Operand| {
            if let Operand::Register(register) = operand {
                alone[*register] = true;
            }
        };
        for statement in self.block.statements.iter().filter(|statement| self.pack_with(statement).is_none()) {
            statement.for_each_operand(&mut read);
        }
        self.block.results.iter().for_each(&mut read);
        let gathered = self.packs.iter().flat_map(|pack| &pack.operands).filter(|four| self.pack_of(four).is_none());
        gathered.flatten().for_each(&mut read);
        let (seen, gathers, next) = (vec![false; self.block.statements.len()], HashMap::default(), self.next);
        let mut order = Order { lanes: self, alone, seen, gathers, next, statements: vec![] };
        (0..self.block.statements.len()).for_each(|number| order.statement(number));
        Block { statements: order.statements, results: self.block.results.clone() }
    }

    /// The pack to which a statement belongs.
    fn pack_with(&self, statement: &Statement) -> Option<usize> {
        match statement {
            Statement::Let(register, _) => self.places[*register].map(|(pack, _)| pack),
            _ => None,
        }
    }
}

/// What is done after what.
struct Order<'a> {
    lanes: &'a Lanes<'a>,
    /// Registers that are read one by one.
    alone: Vec<bool>,
    /// Statements that are written, also as a part of a pack.
    seen: Vec<bool>,
    gathers: HashMap<[Operand; LANES], Register>,
    next: Register,
    statements: Vec<Statement>,
}

impl Order<'_> {
    /// All that a statement reads, and the statement.
    fn statement(&mut self, number: usize) {
        let lanes = self.lanes;
        let statement = &lanes.block.statements[number];
        if let Some(pack) = lanes.pack_with(statement) {
            return self.pack(pack);
        }
        if std::mem::replace(&mut self.seen[number], true) {
            return;
        }
        statement.for_each_operand(&mut |operand| self.operand(operand));
        self.statements.push(statement.clone());
    }

    fn operand(&mut self, operand: &Operand) {
        if let Operand::Register(register) = operand
            && let Some(number) = self.lanes.makers[*register]
        {
            self.statement(number);
        }
    }

    /// All that a pack reads, the pack, and its members where they are read one by one.
    fn pack(&mut self, number: usize) {
        let lanes = self.lanes;
        let Pack { members, operands, register } = &lanes.packs[number];
        let Some(maker) = lanes.makers[members[0]] else { return };
        let Statement::Let(_, instruction) = &lanes.block.statements[maker] else { return };
        if std::mem::replace(&mut self.seen[maker], true) {
            return;
        }
        let operands: Vec<Operand> = operands.iter().map(|four| Operand::Register(self.four(four))).collect();
        let mut instruction = instruction.clone();
        instruction.replace(&operands);
        self.statements.push(Statement::Let(*register, instruction));
        if members.iter().any(|member| self.alone[*member]) {
            self.statements.push(Statement::Spread(members.clone(), *register));
        }
    }

    /// The register that holds four operands.
    fn four(&mut self, four: &[Operand; LANES]) -> Register {
        if let Some(number) = self.lanes.pack_of(four) {
            self.pack(number);
            return self.lanes.packs[number].register;
        }
        if let Some(known) = self.gathers.get(four) {
            return *known;
        }
        four.iter().for_each(|operand| self.operand(operand));
        let register = self.next;
        self.next += 1;
        self.gathers.insert(*four, register);
        self.statements.push(Statement::Gather(register, *four));
        register
    }
}
