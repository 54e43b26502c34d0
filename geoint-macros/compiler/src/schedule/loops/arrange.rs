//! Arranges the loops of a block: loops inside of other loops, targets, and the order of statements.

use super::find::{Finder, Found};
use crate::ir::HashMap;
use crate::schedule::address::{Address, Indices, Source, Successive};
use crate::schedule::block::{Block, Loop, Statement};
use crate::schedule::instruction::{Operand, Register};
use crate::schedule::layout::Place;
use std::collections::{BTreeMap, HashSet};

/// The number of a statement, or of the array of a loop.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Item {
    Statement(usize),
    Loop(usize),
}

impl Finder<'_> {
    /// Returns the block with loops.
    pub(super) fn arrange(self, targets: &[Place]) -> Block {
        let (block, readers) = (self.block, self.readers());
        let homes = self.homes(&readers);
        let mut items: Vec<Item> = (0..block.statements.len()).map(Item::Statement).collect();
        for (found, home) in self.found.iter().zip(&homes) {
            found.members.iter().for_each(|number| items[*number] = Item::Loop(*home));
        }
        let written: Vec<Option<Address>> = targets.iter().map(Address::of).collect();
        let mut loops: BTreeMap<usize, Loop> = BTreeMap::new();
        for home in (0..homes.len()).filter(|home| homes[*home] == *home) {
            let target = if readers[home].is_empty() { self.target(home, &written) } else { None };
            loops.insert(home, self.fused(&homes, home, target, &written));
        }
        let mut statements = vec![];
        for item in Order::of(block, items) {
            match item {
                Item::Statement(number) => statements.push(block.statements[number].clone()),
                Item::Loop(home) => {
                    let computed = loops.get(&home).filter(|each| each.target.is_none()).cloned();
                    statements.extend(computed.map(Statement::Loop));
                }
            }
        }
        for (place, result) in targets.iter().zip(&block.results) {
            // The loop stands in the place of its first entry, and writes all entries.
            let entry = self.entry_of(result).map(|(home, i)| (i, &loops[&home]));
            match entry.filter(|(_, each)| each.target.is_some()) {
                None => statements.push(Statement::Write(place.clone(), *result)),
                Some((0, each)) => statements.push(Statement::Loop(each.clone())),
                Some(_) => {}
            }
        }
        Block { statements, results: if targets.is_empty() { block.results.clone() } else { vec![] } }
    }

    /// Returns the array and the index of an operand in a loop.
    fn entry_of(&self, operand: &Operand) -> Option<(usize, usize)> {
        let Operand::Register(register) = operand else { return None };
        self.entries.get(register).map(|(computed, i)| (computed.array, *i))
    }

    /// Returns the readers of each array: the loops that read the array entry by entry. A number beyond all loops is any other reader.
    fn readers(&self) -> Vec<Vec<usize>> {
        let other = self.found.len();
        let mut readers: Vec<Vec<usize>> = vec![vec![]; other];
        let mut read = |operand: &Operand| {
            if let Some((array, _)) = self.entry_of(operand) {
                readers[array].push(other);
            }
        };
        self.operands.iter().for_each(&mut read);
        let members: HashSet<usize> = self.found.iter().flat_map(|found| &found.members).copied().collect();
        for (number, statement) in self.block.statements.iter().enumerate() {
            if !members.contains(&number) {
                statement.for_each_operand(&mut read);
            }
        }
        for (reader, found) in self.found.iter().enumerate() {
            for successive in &found.entries {
                if let Source::Computed(computed) = successive.source {
                    let one_by_one = successive.first == [0; 3] && successive.step == [1, 0, 0];
                    let as_long = self.found[computed.array].members.len() == found.members.len();
                    readers[computed.array].push(if one_by_one && as_long { reader } else { other });
                }
            }
        }
        readers
    }

    /// Returns the home of each array: the loop whose body computes the entries. If one loop alone reads the array, entry by entry,
    /// the home is this reader. Otherwise the home is the array's own loop.
    fn homes(&self, readers: &[Vec<usize>]) -> Vec<usize> {
        let mut homes: Vec<usize> = (0..self.found.len()).collect();
        let results: HashSet<usize> =
            self.block.results.iter().filter_map(|result| self.entry_of(result)).map(|(array, _)| array).collect();
        for array in (0..homes.len()).rev().filter(|array| !results.contains(array)) {
            let mut found = readers[array].iter().map(|reader| homes.get(*reader));
            if let Some(Some(first)) = found.next()
                && found.all(|other| other == Some(first))
            {
                homes[array] = *first;
            }
        }
        homes
    }

    /// Returns the loop of an array. The body also computes all other arrays with this home.
    fn fused(&self, homes: &[usize], home: usize, target: Option<Successive>, written: &[Option<Address>]) -> Loop {
        let unused = 1 + self.block.registers().into_iter().max().unwrap_or_default();
        let (mut entries, mut body): (Vec<Successive>, _) = (vec![], vec![]);
        for found in (0..=home).filter(|other| homes[*other] == home).map(|other| &self.found[other]) {
            let mut operands = vec![];
            for successive in &found.entries {
                operands.push(match successive.source {
                    Source::One(number) => self.operands[number],
                    Source::Computed(computed) if homes[computed.array] == home => {
                        Operand::Register(self.found[computed.array].deed.result(computed.part))
                    }
                    _ => {
                        let known = entries.iter().position(|other| other == successive);
                        entries.extend(known.is_none().then_some(*successive));
                        Operand::Register(unused + known.unwrap_or(entries.len() - 1))
                    }
                });
            }
            body.push(found.deed.reading(&operands));
        }
        // A member may read only its own entry of an array of the targets.
        let is_written = |source| written.iter().flatten().any(|address| address.source == source);
        let target = target
            .filter(|target| entries.iter().all(|successive| successive == target || !is_written(successive.source)));
        let Found { members, deed, .. } = &self.found[home];
        Loop {
            array: home,
            length: members.len(),
            reads: entries.into_iter().enumerate().map(|(k, successive)| (unused + k, successive)).collect(),
            body,
            results: deed.results.clone(),
            members: members.iter().map(|number| self.block.statements[*number].registers()).collect(),
            target,
        }
    }

    /// Returns the targets of a loop, if the results have successive targets.
    fn target(&self, home: usize, written: &[Option<Address>]) -> Option<Successive> {
        let Found { members, deed, .. } = &self.found[home];
        if deed.results.len() > 1 {
            return None;
        }
        let mut addresses: Vec<Option<Address>> = vec![None; members.len()];
        for (result, address) in self.block.results.iter().zip(written) {
            if let Some((_, i)) = self.entry_of(result).filter(|(array, _)| *array == home)
                && addresses[i].replace((*address)?).is_some()
            {
                return None;
            }
        }
        let addresses: Vec<Address> = addresses.into_iter().collect::<Option<_>>()?;
        let [first, second, ..] = addresses[..] else { return None };
        let step: Indices = second.minus(&first);
        let follows = |pair: &[Address]| pair[1].source == first.source && pair[1].minus(&pair[0]) == step;
        addresses.windows(2).all(follows).then_some(Successive { source: first.source, first: first.indices, step })
    }
}

/// Sorts items: operands first.
struct Order<'a> {
    block: &'a Block,
    statements: HashMap<Item, Vec<usize>>,
    makers: HashMap<Register, Item>,
    seen: HashSet<Item>,
    sorted: Vec<Item>,
}

impl Order<'_> {
    /// Returns the items in order, given the item of each statement.
    fn of(block: &Block, items: Vec<Item>) -> Vec<Item> {
        let (mut statements, mut makers): (HashMap<Item, Vec<usize>>, _) = (HashMap::default(), HashMap::default());
        for ((number, statement), item) in block.statements.iter().enumerate().zip(&items) {
            statements.entry(*item).or_default().push(number);
            makers.extend(statement.registers().into_iter().map(|register| (register, *item)));
        }
        let mut order = Order { block, statements, makers, seen: HashSet::default(), sorted: vec![] };
        items.into_iter().for_each(|item| order.visit(item));
        order.sorted
    }

    /// Adds an item after the items of its operands.
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
        self.sorted.push(item);
    }
}
