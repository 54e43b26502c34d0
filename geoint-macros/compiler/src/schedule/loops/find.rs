//! Finds alike statements with successive operands.

use super::FEWEST;
use crate::ir::{Function, HashMap, hash};
use crate::schedule::address::{Address, Computed, Indices, Source, Successive};
use crate::schedule::block::{Block, Statement};
use crate::schedule::call::{Call, JointFunction};
use crate::schedule::instruction::{Instruction, Operand, Register};
use crate::schedule::layout::Layout;
use std::collections::BTreeMap;

/// Alike statements with successive operands.
pub(super) struct Found {
    /// The numbers of the statements.
    pub(super) members: Vec<usize>,
    /// The first statement.
    pub(super) deed: Deed,
    /// One `Successive` for each operand.
    pub(super) entries: Vec<Successive>,
}

/// A possible member of a loop.
#[derive(Clone)]
pub(super) struct Deed {
    pub(super) results: Vec<Register>,
    /// The instruction. A sine with its cosine is a sine with two results.
    pub(super) instruction: Instruction,
}

/// A statement and the addresses of its operands.
struct Member {
    addresses: Vec<Address>,
    number: usize,
    deed: Deed,
}

/// The kind of a value. Alike values have one kind. Depth is the length of the chain of operations before the value.
#[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
struct Kind {
    colour: u32,
    depth: u32,
}

/// Search for loops in a block.
pub(super) struct Finder<'a> {
    pub(super) block: &'a Block,
    layout: &'a Layout<'a>,
    /// The kinds of registers.
    kinds: HashMap<Register, Kind>,
    /// The array and the index of registers in loops.
    pub(super) entries: HashMap<Register, (Computed, usize)>,
    numbers: HashMap<Operand, usize>,
    /// Shared operands by their numbers: all members of a loop read the operand.
    pub(super) operands: Vec<Operand>,
    /// The loops. A loop reads the arrays of earlier loops only.
    pub(super) found: Vec<Found>,
}

impl<'a> Finder<'a> {
    /// Returns a new search.
    pub(super) fn new(block: &'a Block, layout: &'a Layout<'a>) -> Self {
        Finder {
            block,
            layout,
            kinds: HashMap::default(),
            entries: HashMap::default(),
            numbers: HashMap::default(),
            operands: vec![],
            found: vec![],
        }
    }

    /// Finds all loops.
    pub(super) fn find(&mut self) {
        for class in self.classes().into_values().filter(|class| class.len() >= FEWEST) {
            self.divide(class);
        }
    }

    /// Returns the numbers of alike statements by their depth and colour.
    fn classes(&mut self) -> BTreeMap<(u32, u32), Vec<usize>> {
        let mut classes: BTreeMap<(u32, u32), Vec<usize>> = BTreeMap::new();
        let mut deepest = 0;
        for (number, statement) in self.block.statements.iter().enumerate() {
            let Some(Deed { results, instruction }) = Deed::of(statement) else {
                deepest += 1;
                for register in statement.registers() {
                    self.kinds.insert(register, Kind { colour: hash::of(&register), depth: deepest });
                }
                continue;
            };
            let mut kinds: Vec<Kind> = instruction.operands().iter().map(|operand| self.kind(operand)).collect();
            kinds[..instruction.commuting()].sort_unstable();
            let depth = 1 + kinds.iter().map(|kind| kind.depth).max().unwrap_or(0);
            deepest = deepest.max(depth);
            let colour = hash::of(&(instruction.blank(), results.len(), kinds));
            for (k, register) in results.iter().enumerate() {
                self.kinds.insert(*register, Kind { colour: colour.wrapping_add(k as u32), depth });
            }
            classes.entry((depth, colour)).or_default().push(number);
        }
        classes
    }

    /// Returns the kind of an operand. All entries of one array are alike.
    fn kind(&self, operand: &Operand) -> Kind {
        let colour = match operand {
            Operand::Register(register) => return self.kinds.get(register).copied().unwrap_or_default(),
            Operand::Slot(..) => hash::of(&1),
            Operand::Input(symbol) => match Address::of(&self.layout.place(*symbol)) {
                Some(Address { source: Source::Given(array, _), .. }) => hash::of(&(0, array.number())),
                _ => hash::of(operand),
            },
            _ => hash::of(operand),
        };
        Kind { colour, depth: 0 }
    }

    /// Returns the address of an operand.
    fn address(&mut self, operand: &Operand) -> Address {
        let at = |source, i: usize| Address { source, indices: [i as i32, 0, 0] };
        let known = match operand {
            Operand::Slot(level, i) => Some(at(Source::Slots(*level), *i)),
            Operand::Input(symbol) => Address::of(&self.layout.place(*symbol)),
            Operand::Register(register) => {
                self.entries.get(register).map(|(computed, i)| at(Source::Computed(*computed), *i))
            }
            Operand::Constant(_) | Operand::Truth(_) => None,
        };
        known.unwrap_or_else(|| at(Source::One(self.number(*operand)), 0))
    }

    /// Returns the number of a shared operand.
    fn number(&mut self, operand: Operand) -> usize {
        let next = self.operands.len();
        let number = *self.numbers.entry(operand).or_insert(next);
        if number == next {
            self.operands.push(operand);
        }
        number
    }

    /// Divides the statements of one class into loops.
    fn divide(&mut self, class: Vec<usize>) {
        let mut members = vec![];
        for number in class {
            let Some(mut deed) = Deed::of(&self.block.statements[number]) else { continue };
            let operands = deed.instruction.operands();
            let mut read: Vec<_> = operands.iter().map(|x| (self.kind(x), self.address(x), *x)).collect();
            read[..deed.instruction.commuting()].sort_by_key(|(kind, address, _)| (*kind, *address));
            deed.instruction.replace(&read.iter().map(|(_, _, operand)| *operand).collect::<Vec<_>>());
            members.push(Member { addresses: read.iter().map(|(_, address, _)| *address).collect(), number, deed });
        }
        members.sort_by(|a, b| a.addresses.cmp(&b.addresses));
        let mut rest = &members[..];
        while rest.len() >= FEWEST {
            let length = successive(rest);
            if length < FEWEST {
                rest = &rest[1..];
                continue;
            }
            self.add(&rest[..length]);
            rest = &rest[length..];
        }
    }

    /// Adds a loop.
    fn add(&mut self, members: &[Member]) {
        let [first, second, ..] = members else { return };
        let mut entries = vec![];
        for ((address, next), operand) in
            first.addresses.iter().zip(&second.addresses).zip(first.deed.instruction.operands())
        {
            let step = next.minus(address);
            // A shared value gets a name before the loop.
            let source = if step == Indices::default() { Source::One(self.number(operand)) } else { address.source };
            entries.push(Successive { source, first: address.indices, step });
        }
        let array = self.found.len();
        for (i, Member { deed: Deed { results, .. }, .. }) in members.iter().enumerate() {
            for (k, register) in results.iter().enumerate() {
                let part = (results.len() > 1).then_some(k);
                self.entries.insert(*register, (Computed { array, part }, i));
            }
        }
        let numbers = members.iter().map(|member| member.number).collect();
        self.found.push(Found { members: numbers, deed: first.deed.clone(), entries });
    }
}

/// Returns the length of the first sequence of alike members with successive operands.
fn successive(members: &[Member]) -> usize {
    let [first, second, ..] = members else { return members.len() };
    let kind = |member: &Member| (member.deed.instruction.blank(), member.deed.results.len());
    let follows = |pair: &&[Member]| {
        let (a, b) = (&pair[0], &pair[1]);
        let mut addresses = a.addresses.iter().zip(&b.addresses).zip(first.addresses.iter().zip(&second.addresses));
        kind(a) == kind(b)
            && addresses.all(|((a, b), (first, second))| a.source == b.source && b.minus(a) == second.minus(first))
    };
    1 + members.windows(2).take_while(follows).count()
}

impl Deed {
    /// Returns a statement as a possible member of a loop.
    fn of(statement: &Statement) -> Option<Deed> {
        match statement {
            Statement::Let(register, instruction) if !instruction.is_condition() => {
                Some(Deed { results: vec![*register], instruction: instruction.clone() })
            }
            Statement::Call(Call { function: JointFunction::SinCos, results, arguments }) => Some(Deed {
                results: results.concat(),
                instruction: Instruction::Call(Function::Sin, arguments.concat()),
            }),
            _ => None,
        }
    }

    /// Returns the statement with other operands.
    pub(super) fn reading(&self, operands: &[Operand]) -> Statement {
        let mut instruction = self.instruction.clone();
        instruction.replace(operands);
        match &self.results[..] {
            [register] => Statement::Let(*register, instruction),
            results => Statement::Call(Call {
                function: JointFunction::SinCos,
                results: vec![results.to_vec()],
                arguments: vec![instruction.operands()],
            }),
        }
    }

    /// Returns the register of a part of the result.
    pub(super) fn result(&self, part: Option<usize>) -> Register {
        self.results[part.unwrap_or(0)]
    }
}
