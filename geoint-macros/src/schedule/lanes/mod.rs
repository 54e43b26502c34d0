//! Alike operations side by side: four numbers in one register of a processor.
//!
//! The force of a pair of bodies takes a root and a quotient, and does the same as that of every other pair. Left to itself, the compiler packs
//! sums of different pairs as it finds them, otherwise in every program. Each number has the bits that it has alone.

mod arrange;

use super::block::{Block, Instruction, LANES, Operand, Register, Statement};
use crate::ir::HashMap;
use std::collections::BTreeMap;

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
    instruction: Instruction,
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

/// What a routine is given is of one kind.
const GIVEN: Kind = (0, 0);

/// Statements of a block, and which of them are side by side.
struct Lanes<'a> {
    block: &'a Block,
    /// Which statement computes a register.
    makers: HashMap<Register, usize>,
    /// Which ones read it.
    readers: HashMap<Register, Vec<usize>>,
    /// What a register is made of, whatever that reads.
    kinds: HashMap<Register, Kind>,
    /// What each kind does to what kinds.
    known: HashMap<(Instruction, Vec<Kind>), Kind>,
    packs: Vec<Pack>,
    /// The pack of a register, and where it is there.
    places: HashMap<Register, (usize, usize)>,
    next: Register,
}

impl<'a> Lanes<'a> {
    fn of(block: &'a Block) -> Self {
        let next = 1 + block.registers_inside().max().unwrap_or_default();
        let mut lanes = Lanes {
            block,
            makers: HashMap::default(),
            readers: HashMap::default(),
            kinds: HashMap::default(),
            known: HashMap::default(),
            packs: vec![],
            places: HashMap::default(),
            next,
        };
        for (number, statement) in block.statements.iter().enumerate() {
            statement.for_each_operand(&mut |operand| {
                if let Operand::Register(register) = operand {
                    lanes.readers.entry(*register).or_default().push(number);
                }
            });
            for register in statement.registers() {
                let kind = match statement {
                    Statement::Let(_, instruction) => lanes.kind_of(instruction),
                    // Of this kind there is no other.
                    _ => (0, 1 + register),
                };
                lanes.kinds.insert(register, kind);
                lanes.makers.insert(register, number);
            }
        }
        lanes
    }

    fn kind_of(&mut self, instruction: &Instruction) -> Kind {
        let kinds: Vec<Kind> = self.aligned(instruction).iter().map(|operand| self.kind(operand)).collect();
        let depth = 1 + kinds.iter().map(|(depth, _)| *depth).max().unwrap_or(0);
        let next = self.known.len();
        *self.known.entry((instruction.blank(), kinds)).or_insert((depth, next))
    }

    fn kind(&self, operand: &Operand) -> Kind {
        match operand {
            Operand::Register(register) => self.kinds.get(register).copied().unwrap_or(GIVEN),
            _ => GIVEN,
        }
    }

    /// What an instruction reads; of operands that may change places, one of a lesser kind first.
    fn aligned(&self, instruction: &Instruction) -> Vec<Operand> {
        let mut operands = instruction.operands();
        operands[..instruction.commuting()].sort_by_key(|operand| self.kind(operand));
        operands
    }

    /// Registers of roots and quotients of one kind, in order, where there are enough.
    fn classes(&self) -> Vec<Vec<Register>> {
        let mut classes: BTreeMap<Kind, Vec<Register>> = BTreeMap::new();
        for statement in self.block.statements.iter().filter(|statement| is_slow(statement)) {
            for register in statement.registers() {
                classes.entry(self.kinds[&register]).or_default().push(register);
            }
        }
        classes.into_values().filter(|class| class.len() >= FEWEST).collect()
    }

    /// What computes a register, if that is an operation that four numbers can go through at once.
    fn operation(&self, register: Register) -> Option<&'a Instruction> {
        match &self.block.statements[*self.makers.get(&register)?] {
            Statement::Let(_, instruction) => instruction.is_arithmetic().then_some(instruction),
            _ => None,
        }
    }

    /// Puts registers side by side if they are of one kind, and what they are made of.
    fn put(&mut self, members: &[Register]) {
        let free = |(lane, register): (usize, &Register)| {
            !self.places.contains_key(register) && !members[..lane].contains(register)
        };
        let alike = members.iter().all(|register| self.kinds[register] == self.kinds[&members[0]]);
        let Some(instruction) = self.operation(members[0]) else { return };
        if !alike || !members.iter().enumerate().all(free) {
            return;
        }
        let read = |register: &Register| self.operation(*register).map_or(vec![], |other| self.aligned(other));
        let each: Vec<Vec<Operand>> = members.iter().map(read).collect();
        let of = |k: usize| each.iter().map(|operands| operands[k]).collect();
        let operands: Vec<Vec<Operand>> = (0..each[0].len()).map(of).collect();
        let places = members.iter().enumerate().map(|(lane, register)| (*register, (self.packs.len(), lane)));
        self.places.extend(places);
        let (instruction, register) = (instruction.clone(), self.fresh());
        let pack = Pack {
            members: members.to_vec(),
            instruction,
            operands: operands.iter().map(|members| lanes(members)).collect(),
            register,
        };
        self.packs.push(pack);
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
        for reader in self.readers.get(&members[0]).cloned().unwrap_or_default() {
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
            Statement::Let(register, _) => (!self.places.contains_key(register)).then_some(*register),
            _ => None,
        }
    }

    /// What does to a member in the lane `lane` what the statement `first` does to that in the first one.
    fn like(&self, first: usize, member: Register, lane: usize) -> Option<Register> {
        let first = self.made(first)?;
        let read = |register| self.operation(register).map(|instruction| self.aligned(instruction));
        let wanted = read(first)?;
        let fits = |operands: Vec<Operand>| {
            operands.iter().zip(&wanted).all(|(operand, first)| match (operand, first) {
                (Operand::Register(operand), Operand::Register(first)) => {
                    let place = self.places.get(first).filter(|(_, place)| *place == 0);
                    place.is_some_and(|(pack, _)| self.places.get(operand) == Some(&(*pack, lane)))
                }
                (Operand::Register(_), _) | (_, Operand::Register(_)) => false,
                _ => true,
            })
        };
        let mut readers = self.readers.get(&member)?.iter().filter_map(|number| self.made(*number));
        readers.find(|register| self.kinds[register] == self.kinds[&first] && read(*register).is_some_and(fits))
    }

    /// The pack that four operands are.
    fn pack_of(&self, four: &[Operand; LANES]) -> Option<usize> {
        let Operand::Register(first) = four[0] else { return None };
        let (number, _) = *self.places.get(&first)?;
        (lanes(&self.packs[number].members).map(Operand::Register) == *four).then_some(number)
    }
}
