//! Families that are known, as loops: which of them are one, and what is done after what.

use super::find::{Finder, Found};
use super::{Families, Family, Indices, Item, Place, Run, Source};
use crate::ir::HashMap;
use crate::schedule::block::{Block, Operand, Register};
use std::collections::HashSet;

impl Finder<'_> {
    pub(super) fn arrange(mut self, targets: &[Option<Place>]) -> Families {
        let (block, readers) = (self.block, self.readers());
        let homes = self.homes(&readers);
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
        let target = |home: usize| if readers[home].is_empty() { self.target(home, targets) } else { None };
        let written: Vec<Source> = targets.iter().flatten().map(|(array, _)| Source::Given(*array)).collect();
        let all = loops.map(|home| (home, self.family(&homes, home, (target(home), &written)))).collect();
        self.members.retain(|_, (family, ..)| homes[*family] == *family);
        Families { all, members: self.members, items: order.items }
    }

    /// Who reads each family: families that read it one by one, or somebody else, by the number after the last one.
    fn readers(&self) -> Vec<Vec<usize>> {
        let nobody = self.found.len();
        let mut readers: Vec<Vec<usize>> = vec![vec![]; nobody];
        let mut read_alone = |operand: &Operand| {
            if let Some(family) = self.family_of(operand) {
                readers[family].push(nobody);
            }
        };
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
        readers
    }

    fn family_of(&self, operand: &Operand) -> Option<usize> {
        let Operand::Register(register) = operand else { return None };
        self.members.get(register).map(|(family, ..)| *family)
    }

    /// In whose loop each family is computed: in the only one where it is read, if it is read there one by one.
    fn homes(&self, readers: &[Vec<usize>]) -> Vec<usize> {
        let mut homes: Vec<usize> = (0..self.found.len()).collect();
        let results: HashSet<usize> = self.block.results.iter().filter_map(|result| self.family_of(result)).collect();
        for family in (0..homes.len()).rev().filter(|family| !results.contains(family)) {
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
    fn family(&self, homes: &[usize], home: usize, (target, written): (Option<Run>, &[Source])) -> Family {
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
        // What is written while it is read may be read at the same place alone.
        let target = target.filter(|target| runs.iter().all(|run| run == target || !written.contains(&run.source)));
        let reads = runs.into_iter().enumerate().map(|(k, run)| (new + k, run)).collect();
        let Found { members, results, .. } = &self.found[home];
        Family { length: members.len(), reads, body, results: results.clone(), target }
    }

    /// Successive places to which the results of a family are written.
    fn target(&self, home: usize, targets: &[Option<Place>]) -> Option<Run> {
        let found = &self.found[home];
        if found.results.len() > 1 {
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
