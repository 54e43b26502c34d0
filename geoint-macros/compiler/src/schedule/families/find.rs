//! Which statements are alike.

use super::{FEWEST, Indices, Place, Run, Source};
use crate::ir::{Function, HashMap, Symbol, hash};
use crate::schedule::block::{Block, Instruction, Operand, Register, Statement};
use std::collections::BTreeMap;

/// Statements of one kind that read successive values.
pub(super) struct Found {
    /// Statements by their numbers.
    pub(super) members: Vec<usize>,
    /// What the first one does.
    pub(super) instruction: Instruction,
    pub(super) results: Vec<Register>,
    pub(super) runs: Vec<Run>,
}

pub(super) struct Finder<'a> {
    pub(super) block: &'a Block,
    place: &'a dyn Fn(Symbol) -> Option<Place>,
    /// What a register is made of, whichever entries of arrays these are, and how many operations one after the other.
    pub(super) colours: HashMap<Register, (u32, u32)>,
    /// The family, the result and the place of a register.
    pub(super) members: HashMap<Register, (usize, usize, usize)>,
    numbers: HashMap<Operand, usize>,
    pub(super) operands: Vec<Operand>,
    pub(super) found: Vec<Found>,
}

impl<'a> Finder<'a> {
    pub(super) fn new(block: &'a Block, place: &'a dyn Fn(Symbol) -> Option<Place>) -> Self {
        Finder {
            block,
            place,
            colours: HashMap::default(),
            members: HashMap::default(),
            numbers: HashMap::default(),
            operands: vec![],
            found: vec![],
        }
    }

    /// All families, those first that others read.
    pub(super) fn find(&mut self) {
        for class in self.classes().into_values().filter(|class| class.len() >= FEWEST) {
            self.divide(class);
        }
    }
}

impl Finder<'_> {
    /// Numbers of statements that do the same to things of the same kind, what needs fewer operations first.
    fn classes(&mut self) -> BTreeMap<(u32, u32), Vec<usize>> {
        let mut classes: BTreeMap<(u32, u32), Vec<usize>> = BTreeMap::new();
        let mut deepest = 0;
        for (number, statement) in self.block.statements.iter().enumerate() {
            let Some((results, instruction)) = parts(statement) else {
                deepest += 1;
                for register in statement.registers() {
                    self.colours.insert(register, (hash::of(&register), deepest));
                }
                continue;
            };
            let mut colours: Vec<(u32, u32)> =
                instruction.operands().iter().map(|operand| self.colour(operand)).collect();
            let depth = 1 + colours.iter().map(|(_, depth)| *depth).max().unwrap_or(0);
            colours[..instruction.commuting()].sort_unstable();
            deepest = deepest.max(depth);
            let colour = hash::of(&(instruction.blank(), results.len(), colours));
            for (k, register) in results.iter().enumerate() {
                self.colours.insert(*register, (colour.wrapping_add(k as u32), depth));
            }
            classes.entry((depth, colour)).or_default().push(number);
        }
        classes
    }

    fn colour(&self, operand: &Operand) -> (u32, u32) {
        let alike = match operand {
            Operand::Register(register) => return self.colours.get(register).copied().unwrap_or_default(),
            Operand::Input(symbol) => (self.place)(*symbol).map(|(array, _)| Source::Given(array)),
            Operand::Slot(level, _) => Some(Source::Slots(*level)),
            _ => None,
        };
        match alike {
            Some(Source::Given(array)) => (hash::of(&(0, array)), 0),
            Some(_) => (hash::of(&1), 0),
            None => (hash::of(operand), 0),
        }
    }

    /// Where an operand is.
    fn address(&mut self, operand: &Operand) -> (Source, Indices) {
        let at = |i: usize| [i as i32, 0, 0];
        match operand {
            Operand::Slot(level, i) => return (Source::Slots(*level), at(*i)),
            Operand::Input(symbol) => {
                if let Some((array, indices)) = (self.place)(*symbol) {
                    return (Source::Given(array), indices);
                }
            }
            Operand::Register(register) => {
                if let Some((family, result, place)) = self.members.get(register) {
                    return (Source::Family(*family, *result), at(*place));
                }
            }
            Operand::Constant(_) | Operand::Truth(_) => {}
        }
        (Source::One(self.number(*operand)), [0; 3])
    }

    fn number(&mut self, operand: Operand) -> usize {
        let next = self.operands.len();
        let number = *self.numbers.entry(operand).or_insert(next);
        if number == next {
            self.operands.push(operand);
        }
        number
    }

    /// Divides statements of one class into those that read successive values.
    fn divide(&mut self, class: Vec<usize>) {
        let mut members = vec![];
        for number in class {
            let Some((results, mut instruction)) = parts(&self.block.statements[number]) else { continue };
            let operands = instruction.operands();
            let mut read: Vec<_> = operands.iter().map(|x| (self.colour(x), self.address(x), *x)).collect();
            read[..instruction.commuting()].sort_by_key(|(colour, address, _)| (*colour, *address));
            instruction.replace(&read.iter().map(|(_, _, operand)| *operand).collect::<Vec<_>>());
            let addresses: Vec<(Source, Indices)> = read.iter().map(|(_, address, _)| *address).collect();
            members.push((addresses, number, results, instruction));
        }
        members.sort_by(|a, b| a.0.cmp(&b.0));
        let mut begin = 0;
        while begin + FEWEST <= members.len() {
            let length = successive(&members[begin..]);
            if length < FEWEST {
                begin += 1;
                continue;
            }
            let (family, all) = (self.found.len(), &members[begin..begin + length]);
            let mut runs = vec![];
            for ((address, next), operand) in all[0].0.iter().zip(&all[1].0).zip(all[0].3.operands()) {
                let step = std::array::from_fn(|i| next.1[i] - address.1[i]);
                // What is the same for all is named before the loop.
                let source = if step == [0; 3] { Source::One(self.number(operand)) } else { address.0 };
                runs.push(Run { source, first: address.1, step });
            }
            self.found.push(Found {
                members: all.iter().map(|(_, number, ..)| *number).collect(),
                instruction: all[0].3.clone(),
                results: all[0].2.clone(),
                runs,
            });
            for (place, (_, _, results, _)) in all.iter().enumerate() {
                for (k, register) in results.iter().enumerate() {
                    self.members.insert(*register, (family, k, place));
                }
            }
            begin += length;
        }
    }
}

type Member = (Vec<(Source, Indices)>, usize, Vec<Register>, Instruction);

/// How many members from the first one on do the same with successive values.
fn successive(members: &[Member]) -> usize {
    let kind = |member: &Member| (member.3.blank(), member.2.len());
    let follows = |k: &usize| {
        let [a, b, first, second] = [&members[k - 1], &members[*k], &members[0], &members[1]];
        let mut operands = a.0.iter().zip(&b.0).zip(first.0.iter().zip(&second.0));
        kind(a) == kind(b)
            && operands.all(|((a, b), (first, second))| {
                a.0 == b.0 && (0..3).all(|i| b.1[i] - a.1[i] == second.1[i] - first.1[i])
            })
    };
    1 + (1..members.len()).take_while(follows).count()
}

/// What a statement computes, and how; a sine with its cosine is the sine with two results.
fn parts(statement: &Statement) -> Option<(Vec<Register>, Instruction)> {
    match statement {
        Statement::Let(
            _,
            Instruction::Compare(..) | Instruction::And(..) | Instruction::Or(..) | Instruction::Not(_),
        ) => None,
        Statement::Let(register, instruction) => Some((vec![*register], instruction.clone())),
        Statement::SinCos(sin, cos, x) => Some((vec![*sin, *cos], Instruction::Call(Function::Sin, vec![*x]))),
        _ => None,
    }
}
