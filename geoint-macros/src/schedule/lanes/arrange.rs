//! Packs that are known, as statements: what is done after what.

use super::{Lanes, Pack};
use crate::ir::HashMap;
use crate::schedule::block::{Block, LANES, Operand, Register, Statement};
use std::collections::HashSet;

impl Lanes<'_> {
    /// The statements in an order in which each finds what it reads.
    pub(super) fn arranged(&self) -> Block {
        let mut alone: HashSet<Register> = HashSet::new();
        let mut read = |operand: &Operand| {
            if let Operand::Register(register) = operand {
                alone.insert(*register);
            }
        };
        let packed =
            |statement: &Statement| statement.registers().iter().any(|register| self.places.contains_key(register));
        let unpacked = self.block.statements.iter().filter(|statement| !packed(statement));
        unpacked.for_each(|statement| statement.for_each_operand(&mut read));
        self.block.results.iter().for_each(&mut read);
        let gathered = self.packs.iter().flat_map(|pack| &pack.operands).filter(|four| self.pack_of(four).is_none());
        gathered.flatten().for_each(&mut read);
        let (seen, gathers, next) = (HashSet::new(), HashMap::default(), self.next);
        let mut order = Order { lanes: self, alone, seen, gathers, next, statements: vec![] };
        (0..self.block.statements.len()).for_each(|number| order.statement(number));
        Block { statements: order.statements, results: self.block.results.clone() }
    }
}

/// What is done after what.
struct Order<'a> {
    lanes: &'a Lanes<'a>,
    /// Registers that are read one by one.
    alone: HashSet<Register>,
    /// Statements that are written, also as a part of a pack.
    seen: HashSet<usize>,
    gathers: HashMap<[Operand; LANES], Register>,
    next: Register,
    statements: Vec<Statement>,
}

impl Order<'_> {
    /// All that a statement reads, and the statement.
    fn statement(&mut self, number: usize) {
        let lanes = self.lanes;
        let statement = &lanes.block.statements[number];
        let place = statement.registers().iter().find_map(|register| lanes.places.get(register));
        if let Some((pack, _)) = place {
            return self.pack(*pack);
        }
        if !self.seen.insert(number) {
            return;
        }
        let mut read = vec![];
        statement.for_each_operand(&mut |operand| read.push(*operand));
        read.iter().for_each(|operand| self.operand(operand));
        self.statements.push(statement.clone());
    }

    fn operand(&mut self, operand: &Operand) {
        if let Operand::Register(register) = operand
            && let Some(number) = self.lanes.makers.get(register)
        {
            self.statement(*number);
        }
    }

    /// All that a pack reads, the pack, and its members where they are read one by one.
    fn pack(&mut self, number: usize) {
        let lanes = self.lanes;
        let Pack { members, instruction, operands, register } = &lanes.packs[number];
        if !self.seen.insert(lanes.makers[&members[0]]) {
            return;
        }
        let operands: Vec<Operand> = operands.iter().map(|four| Operand::Register(self.four(four))).collect();
        let mut instruction = instruction.clone();
        instruction.replace(&operands);
        self.statements.push(Statement::Let(*register, instruction));
        if members.iter().any(|member| self.alone.contains(member)) {
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
