//! Writes the packs of a block as statements, after the statements of their operands.

use super::{Pack, Packs};
use crate::ir::HashMap;
use crate::schedule::block::{Block, LANES, Statement};
use crate::schedule::instruction::{Operand, Register};

impl Packs<'_> {
    /// Returns the block with packs.
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
        let gathered = self.all.iter().flat_map(|pack| &pack.operands).filter(|four| self.pack_of(four).is_none());
        gathered.flatten().for_each(&mut read);
        let seen = vec![false; self.block.statements.len()];
        let mut order =
            Order { packs: self, alone, seen, gathers: HashMap::default(), next: self.next, statements: vec![] };
        (0..self.block.statements.len()).for_each(|number| order.statement(number));
        Block { statements: order.statements, results: self.block.results.clone() }
    }

    /// Returns the pack of a statement.
    fn pack_with(&self, statement: &Statement) -> Option<usize> {
        match statement {
            Statement::Let(register, _) => self.lanes[*register].map(|(pack, _)| pack),
            _ => None,
        }
    }
}

/// Sorts statements and packs: operands first.
struct Order<'a> {
    packs: &'a Packs<'a>,
    /// Registers with a reader outside of packs.
    alone: Vec<bool>,
    /// Statements in the list below, alone or in a pack.
    seen: Vec<bool>,
    gathers: HashMap<[Operand; LANES], Register>,
    next: Register,
    statements: Vec<Statement>,
}

impl Order<'_> {
    /// Adds a statement after the statements of its operands.
    fn statement(&mut self, number: usize) {
        let packs = self.packs;
        let statement = &packs.block.statements[number];
        if let Some(pack) = packs.pack_with(statement) {
            return self.pack(pack);
        }
        if std::mem::replace(&mut self.seen[number], true) {
            return;
        }
        statement.for_each_operand(&mut |operand| self.operand(operand));
        self.statements.push(statement.clone());
    }

    /// Adds the statement of an operand.
    fn operand(&mut self, operand: &Operand) {
        if let Operand::Register(register) = operand
            && let Some(number) = self.packs.makers[*register]
        {
            self.statement(number);
        }
    }

    /// Adds a pack after its operands. Spreads the results for readers outside of packs.
    fn pack(&mut self, number: usize) {
        let packs = self.packs;
        let Pack { members, operands, register } = &packs.all[number];
        let Some(maker) = packs.makers[members[0]] else { return };
        let Statement::Let(_, instruction) = &packs.block.statements[maker] else { return };
        if std::mem::replace(&mut self.seen[maker], true) {
            return;
        }
        let operands: Vec<Operand> = operands.iter().map(|four| Operand::Register(self.four(four))).collect();
        let mut instruction = instruction.clone();
        instruction.replace(&operands);
        self.statements.push(Statement::Pack { register: *register, instruction, members: members.len() });
        if members.iter().any(|member| self.alone[*member]) {
            self.statements.push(Statement::Spread(members.clone(), *register));
        }
    }

    /// Returns the register of four operands. Adds its statement.
    fn four(&mut self, four: &[Operand; LANES]) -> Register {
        if let Some(number) = self.packs.pack_of(four) {
            self.pack(number);
            return self.packs.all[number].register;
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
