//! Alike statements as arrays: what a chain of many masses does for each of its springs is written once, in a loop.

use super::block::{Block, Instruction, Operand, Register, Statement};
use crate::ir::{Function, HashMap, Symbol, hash};
use std::collections::{BTreeMap, HashSet};

/// Fewer alike statements than this are written one by one: what is small stays in registers.
const FEWEST: usize = 16;

/// A block is written with loops if at most one of so many statements is left alone.
const MOST_ALONE: usize = 4;

/// Where something is in an array that the routine is given: the number of the array, and indices, the last one first.
pub(crate) type Place = (usize, Indices);
pub(crate) type Indices = [i32; 3];

/// What values are read from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Source {
    /// One operand, by a number: the same for all.
    One(usize),
    /// An array that the routine is given, by its number.
    Given(usize),
    /// What the routine of an earlier level has stored.
    Slots(usize),
    /// Another family, and which of its results.
    Family(usize, usize),
}

/// Successive values: the `i`-th is at `first + i·step`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Run {
    pub(crate) source: Source,
    pub(crate) first: Indices,
    pub(crate) step: Indices,
}

/// Values that are computed alike, as an array.
#[derive(Clone, Debug)]
pub(crate) struct Family {
    pub(crate) length: usize,
    /// What the `i`-th one reads, and what that is called in the body.
    pub(crate) reads: Vec<(Register, Run)>,
    /// What is computed, under the names that it has for the first one.
    pub(crate) body: Vec<(Vec<Register>, Instruction)>,
    pub(crate) results: Vec<Register>,
    /// Where the routine writes its results, if it does nothing else with them.
    pub(crate) target: Option<Run>,
}

/// A block whose alike statements are arrays.
#[derive(Debug)]
pub(crate) struct Families {
    /// By numbers.
    pub(crate) all: BTreeMap<usize, Family>,
    /// The family, the result and the place of each register that is read elsewhere.
    pub(crate) members: HashMap<Register, (usize, usize, usize)>,
    /// What is done, in order.
    pub(crate) items: Vec<Item>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Item {
    Statement(usize),
    Family(usize),
}

/// Alike statements of a block, if nearly all are alike; results are written to `targets`, if it says where.
pub(crate) fn families(
    block: &Block,
    place: &dyn Fn(Symbol) -> Option<Place>,
    targets: impl FnOnce() -> Vec<Option<Place>>,
) -> Option<Families> {
    if block.statements.len() < FEWEST || !block.statements.iter().any(|statement| reads_of_many(statement, place)) {
        return None;
    }
    let mut finder = Finder {
        block,
        place,
        colours: HashMap::default(),
        members: HashMap::default(),
        numbers: HashMap::default(),
        operands: vec![],
        found: vec![],
    };
    for class in finder.classes().into_values().filter(|class| class.len() >= FEWEST) {
        finder.divide(class);
    }
    let alike: usize = finder.found.iter().map(|family| family.members.len()).sum();
    let alone = block.statements.len() - alike;
    (alike > 0 && alone * MOST_ALONE <= block.statements.len()).then(|| finder.arrange(&targets()))
}

/// Whether a statement reads an array that is long enough.
fn reads_of_many(statement: &Statement, place: &dyn Fn(Symbol) -> Option<Place>) -> bool {
    let mut found = false;
    statement.for_each_operand(&mut |operand| {
        if let Operand::Input(symbol @ (Symbol::Q(i) | Symbol::P(i) | Symbol::V(i) | Symbol::Dq(i) | Symbol::Dp(i))) =
            operand
            && *i as usize + 1 >= FEWEST
        {
            let last = place(*symbol).and_then(|(_, indices)| indices.into_iter().max());
            found |= last.is_some_and(|last| last as usize + 1 >= FEWEST);
        }
    });
    found
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

/// Leaves of an instruction what it does.
fn blank(instruction: &mut Instruction) {
    let nothing = vec![Operand::Truth(false); instruction.operands().len()];
    instruction.replace(&nothing);
}

/// Statements of one kind that read successive values.
struct Found {
    /// Statements by their numbers.
    members: Vec<usize>,
    /// What the first one does.
    instruction: Instruction,
    results: Vec<Register>,
    runs: Vec<Run>,
}

struct Finder<'a> {
    block: &'a Block,
    place: &'a dyn Fn(Symbol) -> Option<Place>,
    /// What a register is made of, whichever entries of arrays these are, and how many operations one after the other.
    colours: HashMap<Register, (u32, u32)>,
    members: HashMap<Register, (usize, usize, usize)>,
    numbers: HashMap<Operand, usize>,
    operands: Vec<Operand>,
    found: Vec<Found>,
}

impl Finder<'_> {
    /// Numbers of statements that do the same to things of the same kind, what needs fewer operations first.
    fn classes(&mut self) -> BTreeMap<(u32, u32), Vec<usize>> {
        let mut classes: BTreeMap<(u32, u32), Vec<usize>> = BTreeMap::new();
        let mut deepest = 0;
        for (number, statement) in self.block.statements.iter().enumerate() {
            let Some((results, mut instruction)) = parts(statement) else {
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
            blank(&mut instruction);
            let colour = hash::of(&(&instruction, results.len(), colours));
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

/// Families that are known, as loops.
impl Finder<'_> {
    fn arrange(mut self, targets: &[Option<Place>]) -> Families {
        let (block, homes) = (self.block, self.homes());
        let mut item_of: Vec<Item> = (0..block.statements.len()).map(Item::Statement).collect();
        for (found, home) in self.found.iter().zip(&homes) {
            found.members.iter().for_each(|number| item_of[*number] = Item::Family(*home));
        }
        let (mut statements, mut makers) = (HashMap::default(), HashMap::default());
        for (number, statement) in block.statements.iter().enumerate() {
            let together: &mut Vec<usize> = statements.entry(item_of[number]).or_default();
            together.push(number);
            makers.extend(statement.registers().into_iter().map(|register| (register, item_of[number])));
        }
        let mut order = Order { block, statements, makers, seen: HashSet::default(), items: vec![] };
        item_of.into_iter().for_each(|item| order.visit(item));
        let loops = (0..homes.len()).filter(|home| homes[*home] == *home);
        let all = loops.map(|home| (home, self.family(&homes, home, targets))).collect();
        self.members.retain(|_, (family, ..)| homes[*family] == *family);
        Families { all, members: self.members, items: order.items }
    }

    /// In whose loop each family is computed: in the only one where it is read, if it is read there one by one.
    fn homes(&self) -> Vec<usize> {
        let nobody = self.found.len();
        let mut readers: Vec<Vec<usize>> = vec![vec![]; nobody];
        let mut read_alone = |operand: &Operand| {
            if let Operand::Register(register) = operand
                && let Some((family, ..)) = self.members.get(register)
            {
                readers[*family].push(nobody);
            }
        };
        self.block.results.iter().for_each(&mut read_alone);
        self.operands.iter().for_each(&mut read_alone);
        let mut alone = vec![true; self.block.statements.len()];
        self.found.iter().flat_map(|found| &found.members).for_each(|number| alone[*number] = false);
        for (statement, _) in self.block.statements.iter().zip(alone).filter(|(_, alone)| *alone) {
            statement.for_each_operand(&mut read_alone);
        }
        for (reader, found) in self.found.iter().enumerate() {
            for run in &found.runs {
                if let Source::Family(family, _) = run.source {
                    let one_by_one = run.first == [0; 3] && run.step == [1, 0, 0];
                    let as_long = self.found[family].members.len() == found.members.len();
                    readers[family].push(if one_by_one && as_long { reader } else { nobody });
                }
            }
        }
        let mut homes: Vec<usize> = (0..nobody).collect();
        for family in (0..nobody).rev() {
            let mut at_home = readers[family].iter().map(|reader| homes.get(*reader));
            if let Some(Some(first)) = at_home.next()
                && at_home.all(|other| other == Some(first))
            {
                homes[family] = *first;
            }
        }
        homes
    }

    /// The loop of a family, and of those that are computed in it.
    fn family(&self, homes: &[usize], home: usize, targets: &[Option<Place>]) -> Family {
        let new = 1 + self.colours.keys().max().copied().unwrap_or_default();
        let (mut runs, mut body): (Vec<Run>, _) = (vec![], vec![]);
        for found in (0..=home).filter(|other| homes[*other] == home).map(|other| &self.found[other]) {
            let mut operands = vec![];
            for run in &found.runs {
                operands.push(match run.source {
                    Source::One(number) => self.operands[number],
                    Source::Family(family, result) if homes[family] == home => {
                        Operand::Register(self.found[family].results[result])
                    }
                    _ => {
                        let known = runs.iter().position(|other| other == run);
                        let place = known.unwrap_or(runs.len());
                        runs.extend(known.is_none().then_some(*run));
                        Operand::Register(new + place)
                    }
                });
            }
            let mut instruction = found.instruction.clone();
            instruction.replace(&operands);
            body.push((found.results.clone(), instruction));
        }
        let written: Vec<Source> = targets.iter().flatten().map(|(array, _)| Source::Given(*array)).collect();
        // What is written while it is read may be read at the same place alone.
        let target = self
            .target(home, targets)
            .filter(|target| runs.iter().all(|run| run == target || !written.contains(&run.source)));
        let reads = runs.into_iter().enumerate().map(|(k, run)| (new + k, run)).collect();
        let Found { members, results, .. } = &self.found[home];
        Family { length: members.len(), reads, body, results: results.clone(), target }
    }

    /// Successive places to which the results of a family are written, if nobody else reads them.
    fn target(&self, home: usize, targets: &[Option<Place>]) -> Option<Run> {
        let found = &self.found[home];
        if found.results.len() > 1 || self.is_read_inside(home) {
            return None;
        }
        let mut places = vec![None; found.members.len()];
        for (result, target) in self.block.results.iter().zip(targets) {
            if let Operand::Register(register) = result
                && let Some((family, _, place)) = self.members.get(register)
                && *family == home
                && places[*place].replace((*target)?).is_some()
            {
                return None;
            }
        }
        let places: Vec<Place> = places.into_iter().collect::<Option<_>>()?;
        let (array, first) = places[0];
        let step: Indices = std::array::from_fn(|i| places[1].1[i] - first[i]);
        let follows = |pair: &[Place]| pair[1].0 == array && (0..3).all(|i| pair[1].1[i] - pair[0].1[i] == step[i]);
        places.windows(2).all(follows).then_some(Run { source: Source::Given(array), first, step })
    }

    /// Whether a statement reads a member of a family.
    fn is_read_inside(&self, home: usize) -> bool {
        let mut found = false;
        for statement in &self.block.statements {
            statement.for_each_operand(&mut |operand| {
                if let Operand::Register(register) = operand {
                    found |= self.members.get(register).is_some_and(|(family, ..)| *family == home);
                }
            });
        }
        found
    }
}

/// What is done after what.
struct Order<'a> {
    block: &'a Block,
    statements: HashMap<Item, Vec<usize>>,
    makers: HashMap<Register, Item>,
    seen: HashSet<Item>,
    items: Vec<Item>,
}

impl Order<'_> {
    /// All that an item needs, and the item.
    fn visit(&mut self, item: Item) {
        if !self.seen.insert(item) {
            return;
        }
        let mut needed = vec![];
        for number in &self.statements[&item] {
            self.block.statements[*number].for_each_operand(&mut |operand| {
                if let Operand::Register(register) = operand {
                    needed.extend(self.makers.get(register));
                }
            });
        }
        needed.into_iter().for_each(|other| self.visit(other));
        self.items.push(item);
    }
}

type Member = (Vec<(Source, Indices)>, usize, Vec<Register>, Instruction);

/// How many members from the first one on do the same with successive values.
fn successive(members: &[Member]) -> usize {
    let kind = |member: &Member| {
        let mut instruction = member.3.clone();
        blank(&mut instruction);
        (instruction, member.2.len())
    };
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
