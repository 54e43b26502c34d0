//! Packs: alike operations on four numbers in one register of the processor.
//!
//! The force of a pair of bodies takes a root and a quotient. The forces of all pairs are alike. Without this pass, rustc packs sums of
//! different pairs, differently in every program. A number has the same bits in a pack as alone.

mod arrange;

use super::block::{Block, LANES, Statement};
use super::instruction::{Instruction, Operand, Register};
use crate::ir::HashMap;
use std::collections::BTreeMap;

/// The fewest alike roots or quotients for packs.
const FEWEST: usize = 8;

/// The fewest members of a pack. Half of the lanes of two members would be idle.
const FEWEST_MEMBERS: usize = 3;

/// Returns the block with packs of alike roots and quotients, of their operands, and of their readers. Returns nothing for a few roots and
/// quotients.
pub(super) fn with_packs(block: &Block) -> Option<Block> {
    // Most blocks have few roots and quotients. This test is cheap.
    if block.statements.iter().filter(|statement| is_slow(statement)).count() < FEWEST {
        return None;
    }
    let mut packs = Packs::of(block);
    for class in packs.classes() {
        for members in class.chunks(LANES).filter(|members| members.len() >= FEWEST_MEMBERS) {
            packs.put(members);
        }
    }
    let mut number = 0;
    while number < packs.all.len() {
        packs.follow(number);
        number += 1;
    }
    (number > 0).then(|| packs.arranged())
}

/// Returns whether a statement is a root or a quotient.
fn is_slow(statement: &Statement) -> bool {
    matches!(statement, Statement::Let(_, Instruction::Sqrt(_) | Instruction::Div(..)))
}

/// Three or four statements that apply one operation to their own operands.
struct Pack {
    members: Vec<Register>,
    operands: Vec<[Operand; LANES]>,
    /// The register of the results.
    register: Register,
}

/// Returns the contents of the lanes. The last member also fills the remaining lanes.
fn lanes<T: Copy>(members: &[T]) -> [T; LANES] {
    std::array::from_fn(|lane| members[lane.min(members.len() - 1)])
}

/// The kind of a value. Alike values have one kind. Depth is the length of the chain of operations before the value. Two registers of one
/// kind have one depth, so neither needs the other.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
struct Kind {
    depth: usize,
    number: usize,
}

/// The kind of all inputs.
const GIVEN: Kind = Kind { depth: 0, number: 0 };

/// The statements of a block, and their packs. Most lists are indexed by registers.
struct Packs<'a> {
    block: &'a Block,
    /// The statement of the register.
    makers: Vec<Option<usize>>,
    /// The readers of the register.
    readers: Vec<Vec<usize>>,
    kinds: Vec<Kind>,
    /// The operands of the register's operation, if packs may have this operation. Of exchangeable operands, the lesser kind is first.
    operations: Vec<Vec<Operand>>,
    /// The pack of the register, and the lane.
    lanes: Vec<Option<(usize, usize)>>,
    /// The kind of a result, by the operation and the kinds of its operands.
    known: HashMap<(Instruction, Vec<Kind>), Kind>,
    all: Vec<Pack>,
    /// The first unused register.
    next: Register,
}

impl<'a> Packs<'a> {
    /// Returns the statements of a block without packs.
    fn of(block: &'a Block) -> Self {
        let next = block.unused();
        let mut packs = Packs {
            block,
            makers: vec![None; next],
            readers: vec![vec![]; next],
            kinds: vec![GIVEN; next],
            operations: vec![vec![]; next],
            lanes: vec![None; next],
            known: HashMap::default(),
            all: vec![],
            next,
        };
        for (number, statement) in block.statements.iter().enumerate() {
            statement.for_each_operand(&mut |operand| {
                if let Operand::Register(register) = operand {
                    packs.readers[*register].push(number);
                }
            });
            statement.for_each_register(&mut |register| {
                packs.makers[register] = Some(number);
                // No other register has this kind.
                packs.kinds[register] = Kind { depth: 0, number: 1 + register };
            });
            if let Statement::Let(register, instruction) = statement
                && !instruction.is_condition()
            {
                packs.add(*register, instruction);
            }
        }
        packs
    }

    /// Adds the kind and the operands of an instruction.
    fn add(&mut self, register: Register, instruction: &Instruction) {
        let mut operands = instruction.operands();
        if instruction.commuting() == 2 && self.kind(&operands[1]) < self.kind(&operands[0]) {
            operands.swap(0, 1);
        }
        let kinds: Vec<Kind> = operands.iter().map(|operand| self.kind(operand)).collect();
        let depth = kinds.iter().map(|kind| kind.depth + 1).max().unwrap_or(1);
        let number = self.known.len();
        self.kinds[register] = *self.known.entry((instruction.blank(), kinds)).or_insert(Kind { depth, number });
        if instruction.is_arithmetic() {
            self.operations[register] = operands;
        }
    }

    /// Returns the kind of an operand.
    fn kind(&self, operand: &Operand) -> Kind {
        match operand {
            Operand::Register(register) => self.kinds[*register],
            _ => GIVEN,
        }
    }

    /// Returns the registers of roots and quotients, in order, for each kind with enough registers.
    fn classes(&self) -> Vec<Vec<Register>> {
        let mut classes: BTreeMap<Kind, Vec<Register>> = BTreeMap::new();
        for statement in self.block.statements.iter().filter(|statement| is_slow(statement)) {
            for register in statement.registers() {
                classes.entry(self.kinds[register]).or_default().push(register);
            }
        }
        classes.into_values().filter(|class| class.len() >= FEWEST).collect()
    }

    /// Makes a pack of registers of one kind. Makes packs of their operands, too.
    fn put(&mut self, members: &[Register]) {
        let free = |(lane, register): (usize, &Register)| {
            self.lanes[*register].is_none() && !members[..lane].contains(register)
        };
        let (kind, read) = (self.kinds[members[0]], self.operations[members[0]].len());
        let alike = members.iter().all(|register| self.kinds[*register] == kind);
        if read == 0 || !alike || !members.iter().enumerate().all(free) {
            return;
        }
        let of = |k: usize| members.iter().map(|register| self.operations[*register][k]).collect();
        let operands: Vec<Vec<Operand>> = (0..read).map(of).collect();
        for (lane, register) in members.iter().enumerate() {
            self.lanes[*register] = Some((self.all.len(), lane));
        }
        let fours = operands.iter().map(|members| lanes(members)).collect();
        self.all.push(Pack { members: members.to_vec(), operands: fours, register: self.next });
        self.next += 1;
        for members in operands {
            let registers = members.iter().map(|operand| match operand {
                Operand::Register(register) => Some(*register),
                _ => None,
            });
            if let Some(registers) = registers.collect::<Option<Vec<_>>>() {
                self.put(&registers);
            }
        }
    }

    /// Makes packs of the readers of a pack, if they read only packs and inputs.
    fn follow(&mut self, number: usize) {
        let members = self.all[number].members.clone();
        for reader in self.readers[members[0]].clone() {
            let others = members.iter().enumerate().skip(1).map(|(lane, member)| self.like(reader, *member, lane));
            if let Some(all) = [self.made(reader)].into_iter().chain(others).collect::<Option<Vec<_>>>() {
                self.put(&all);
            }
        }
    }

    /// Returns the register of a possible member of a pack. A change of sign stays alone: its reader takes a difference instead of a sum.
    fn made(&self, number: usize) -> Option<Register> {
        match &self.block.statements[number] {
            Statement::Let(_, Instruction::Neg(_)) => None,
            Statement::Let(register, _) => self.lanes[*register].is_none().then_some(*register),
            _ => None,
        }
    }

    /// Returns the reader of `member` in the lane `lane` that is alike to the reader `first` of the member in lane 0.
    fn like(&self, first: usize, member: Register, lane: usize) -> Option<Register> {
        let first = self.made(first)?;
        let fits = |register: &Register| {
            let mut operands = self.operations[*register].iter().zip(&self.operations[first]);
            operands.all(|(operand, first)| match (operand, first) {
                (Operand::Register(operand), Operand::Register(first)) => self.lanes[*first]
                    .is_some_and(|(pack, place)| place == 0 && self.lanes[*operand] == Some((pack, lane))),
                (Operand::Register(_), _) | (_, Operand::Register(_)) => false,
                _ => true,
            })
        };
        let mut readers = self.readers[member].iter().filter_map(|number| self.made(*number));
        readers.find(|register| self.kinds[*register] == self.kinds[first] && fits(register))
    }

    /// Returns the pack whose members are these operands.
    fn pack_of(&self, four: &[Operand; LANES]) -> Option<usize> {
        let Operand::Register(first) = four[0] else { return None };
        let (number, _) = self.lanes[first]?;
        (lanes(&self.all[number].members).map(Operand::Register) == *four).then_some(number)
    }
}
