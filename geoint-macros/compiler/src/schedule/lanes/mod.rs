//! Alike operations side by side: four numbers in one register of a processor.
//!
//! The force of a pair of bodies takes a root and a quotient, and does the same as that of every other pair. Left to itself, the compiler packs
//! sums of different pairs as it finds them, otherwise in every program. Each number has the bits that it has alone.

mod arrange;

use super::block::{Block, Instruction, LANES, Operand, Register, Statement};
use crate::ir::{Function, HashMap};
use std::collections::BTreeMap;
use std::mem::{Discriminant, discriminant};

/// Fewer alike roots and quotients than this are left alone.
const FEWEST: usize = 8;

/// Fewer numbers than this are left alone: of a register of two, half would do nothing.
const WORTHWHILE: usize = 3;

/// The block with alike roots and quotients side by side, what they are made of, and what is made of them; none where there are few.
pub(crate) fn side_by_side(block: &Block) -> Option<Block> {
    // The cheapest question first: most blocks have few.
    if block.statements.iter().filter(|statement| is_slow(statement)).count() < FEWEST {
        return None;
    }
    let mut packed = Lanes::of(block);
    for class in packed.classes() {
        for members in class.chunks(LANES).filter(|members| members.len() >= WORTHWHILE) {
            packed.put(members);
        }
    }
    let mut number = 0;
    while number < packed.packs.len() {
        packed.follow(number);
        number += 1;
    }
    (number > 0).then(|| packed.arranged())
}

/// Whether a statement is a root or a quotient.
fn is_slow(statement: &Statement) -> bool {
    matches!(statement, Statement::Let(_, Instruction::Sqrt(_) | Instruction::Div(..)))
}

/// Four statements that do the same, each to its own operands; or three, the last one twice.
struct Pack {
    members: Vec<Register>,
    operands: Vec<[Operand; LANES]>,
    /// What holds all of them.
    register: Register,
}

/// What is in each lane: the last one again where others are missing.
fn lanes<T: Copy>(members: &[T]) -> [T; LANES] {
    std::array::from_fn(|lane| members[lane.min(members.len() - 1)])
}

/// How many operations one after the other, and a number: two registers of one kind are made alike, so that neither needs the other.
type Kind = (usize, usize);

/// What an instruction does, whatever it reads: an operation, or a function.
type Deed = (Discriminant<Instruction>, Option<Function>);

/// What a routine is given is of one kind.
const GIVEN: Kind = (0, 0);

/// Statements of a block, and which of them are side by side.
struct Lanes<'a> {
    block: &'a Block,
    /// By registers: which statement computes it.
    makers: Vec<Option<usize>>,
    /// Which ones read it.
    readers: Vec<Vec<usize>>,
    /// What it is made of, whatever that reads.
    kinds: Vec<Kind>,
    /// What is read for it, where four numbers can go through that operation at once; of operands that may change places, one of a lesser kind first.
    operations: Vec<Vec<Operand>>,
    /// In which pack it is, and where there.
    places: Vec<Option<(usize, usize)>>,
    /// What each kind does to what kinds.
    known: HashMap<(Deed, Vec<Kind>), Kind>,
    packs: Vec<Pack>,
    /// Neither the block has this register nor any beyond it.
    next: Register,
}

impl<'a> Lanes<'a> {
    fn of(block: &'a Block) -> Self {
        let next = block.unused();
        let mut lanes = Lanes {
            block,
            makers: vec![None; next],
            readers: vec![vec![]; next],
            kinds: vec![GIVEN; next],
            operations: vec![vec![]; next],
            places: vec![None; next],
            known: HashMap::default(),
            packs: vec![],
            next,
        };
        for (number, statement) in block.statements.iter().enumerate() {
            statement.for_each_operand(&mut |operand| {
                if let Operand::Register(register) = operand {
                    lanes.readers[*register].push(number);
                }
            });
            statement.for_each_register(&mut |register| {
                lanes.makers[register] = Some(number);
                // Of this kind there is no other.
                lanes.kinds[register] = (0, 1 + register);
            });
            if let Statement::Let(register, instruction) = statement {
                lanes.note(*register, instruction);
            }
        }
        lanes
    }

    /// Of what kind an instruction is, and what it reads.
    fn note(&mut self, register: Register, instruction: &Instruction) {
        let function = match instruction {
            Instruction::Call(function, _) => Some(*function),
            _ if instruction.is_arithmetic() => None,
            _ => return,
        };
        let mut operands = instruction.operands();
        if instruction.commuting() == 2 && self.kind(&operands[1]) < self.kind(&operands[0]) {
            operands.swap(0, 1);
        }
        let mut kinds = Vec::with_capacity(operands.len());
        let mut depth = 1;
        for operand in &operands {
            let kind = self.kind(operand);
            depth = if kind.0 < depth { depth } else { kind.0 + 1 };
            kinds.push(kind);
        }
        let next = self.known.len();
        self.kinds[register] =
            *self.known.entry(((discriminant(instruction), function), kinds)).or_insert((depth, next));
        if function.is_none() {
            self.operations[register] = operands;
        }
    }

    fn kind(&self, operand: &Operand) -> Kind {
        match operand {
            Operand::Register(register) => self.kinds[*register],
            _ => GIVEN,
        }
    }

    /// Registers of roots and quotients of one kind, in order, where there are enough.
    fn classes(&self) -> Vec<Vec<Register>> {
        let mut classes: BTreeMap<Kind, Vec<Register>> = BTreeMap::new();
        for statement in self.block.statements.iter().filter(|statement| is_slow(statement)) {
            for register in statement.registers() {
                classes.entry(self.kinds[register]).or_default().push(register);
            }
        }
        classes.into_values().filter(|class| class.len() >= FEWEST).collect()
    }

    /// Puts registers side by side if they are of one kind, and what they are made of.
    fn put(&mut self, members: &[Register]) {
        let free = |(lane, register): (usize, &Register)| {
            self.places[*register].is_none() && !members[..lane].contains(register)
        };
        let (kind, read) = (self.kinds[members[0]], self.operations[members[0]].len());
        let alike = members.iter().all(|register| self.kinds[*register] == kind);
        if read == 0 || !alike || !members.iter().enumerate().all(free) {
            return;
        }
        let of = |k: usize| members.iter().map(|register| self.operations[*register][k]).collect();
        let operands: Vec<Vec<Operand>> = (0..read).map(of).collect();
        for (lane, register) in members.iter().enumerate() {
            self.places[*register] = Some((self.packs.len(), lane));
        }
        let (register, members) = (self.fresh(), members.to_vec());
        let fours = operands.iter().map(|members| lanes(members)).collect();
        self.packs.push(Pack { members, operands: fours, register });
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

    fn fresh(&mut self) -> Register {
        self.next += 1;
        self.next - 1
    }

    /// Puts side by side what is made of a pack, of other packs and of what the routine is given.
    fn follow(&mut self, number: usize) {
        let members = self.packs[number].members.clone();
        for reader in self.readers[members[0]].clone() {
            let others = members.iter().enumerate().skip(1).map(|(lane, member)| self.like(reader, *member, lane));
            if let Some(all) = [self.made(reader)].into_iter().chain(others).collect::<Option<Vec<_>>>() {
                self.put(&all);
            }
        }
    }

    /// What a statement computes, if that may be put side by side. Signs are left to what reads them: a difference takes no more than a sum.
    fn made(&self, number: usize) -> Option<Register> {
        match &self.block.statements[number] {
            Statement::Let(_, Instruction::Neg(_)) => None,
            Statement::Let(register, _) => self.places[*register].is_none().then_some(*register),
            _ => None,
        }
    }

    /// What does to a member in the lane `lane` what the statement `first` does to that in the first one.
    fn like(&self, first: usize, member: Register, lane: usize) -> Option<Register> {
        let first = self.made(first)?;
        let fits = |register: &Register| {
            let mut operands = self.operations[*register].iter().zip(&self.operations[first]);
            operands.all(|(operand, first)| match (operand, first) {
                (Operand::Register(operand), Operand::Register(first)) => self.places[*first]
                    .is_some_and(|(pack, place)| place == 0 && self.places[*operand] == Some((pack, lane))),
                (Operand::Register(_), _) | (_, Operand::Register(_)) => false,
                _ => true,
            })
        };
        let mut readers = self.readers[member].iter().filter_map(|number| self.made(*number));
        readers.find(|register| self.kinds[*register] == self.kinds[first] && fits(register))
    }

    /// The pack that four operands are.
    fn pack_of(&self, four: &[Operand; LANES]) -> Option<usize> {
        let Operand::Register(first) = four[0] else { return None };
        let (number, _) = self.places[first]?;
        (lanes(&self.packs[number].members).map(Operand::Register) == *four).then_some(number)
    }
}
