//! The search for names in scopes, with the same rules as in rustc.

use super::value::{Around, Barrier, Callable, Closure, Item, Level, Scopes, Value};
use crate::parse::{Function, Outside};
use std::rc::Rc;

/// Result of the search for a name.
pub(super) enum Found {
    Variable(Value),
    /// An item, and the scopes of the items around it. Items see no variables.
    Item(Item, Scopes),
}

/// Reason why a variable can not be assigned to.
pub(super) enum Refused {
    Unknown,
    Outside(Around),
}

impl Scopes {
    /// Returns the scopes of a function at the top level of its file.
    pub(super) fn of_file(outside: &Rc<Outside>, functions: &[Function]) -> Self {
        let mut scopes = Scopes { outside: outside.clone(), ..Scopes::default() };
        scopes.enter();
        for (name, value) in outside.constants() {
            scopes.declare(name, Item::Import(Value::Integer(value)));
        }
        for function in functions {
            let callable = Rc::new(Callable::of(&function.item));
            let inner = Scopes { is_foreign: true, ..Scopes::of_file(&function.outside, &function.used) };
            scopes.declare(&function.path, Item::Outside(Closure { callable, scopes: Rc::new(inner) }));
        }
        scopes
    }

    pub(super) fn enter(&mut self) {
        self.levels.push(Rc::default());
    }

    pub(super) fn leave(&mut self) {
        self.levels.pop();
    }

    /// Binds a variable in the innermost scope.
    pub(super) fn bind(&mut self, name: &impl ToString, value: Value) {
        if let Some(level) = self.levels.last_mut() {
            Rc::make_mut(level).variables.insert(name.to_string(), value);
        }
    }

    /// Declares an item in the innermost scope.
    pub(super) fn declare(&mut self, name: &impl ToString, item: Item) {
        if let Some(level) = self.levels.last_mut() {
            Rc::make_mut(level).items.insert(name.to_string(), item);
        }
    }

    /// Returns the variable or item of a name.
    pub(super) fn get(&self, name: &str) -> Option<Found> {
        let index = self.level_of(name)?;
        let level = &self.levels[index];
        Some(match level.variables.get(name) {
            Some(value) => Found::Variable(value.clone()),
            None => Found::Item(level.items.get(name)?.clone(), self.items_only(index)),
        })
    }

    /// Returns the innermost level that has a name.
    fn level_of(&self, name: &str) -> Option<usize> {
        self.levels.iter().rposition(|level| level.variables.contains_key(name) || level.items.contains_key(name))
    }

    /// Returns the scopes of an item in the given level.
    fn items_only(&self, level: usize) -> Scopes {
        let items = |level: &Rc<Level>| Rc::new(Level { items: level.items.clone(), ..Level::default() });
        let levels = self.levels[..=level].iter().map(items).collect();
        Scopes { levels, outside: self.outside.clone(), is_foreign: self.is_foreign, ..Scopes::default() }
    }

    /// Returns a variable to assign to.
    pub(super) fn assignable(&mut self, name: &str) -> Result<&mut Value, Refused> {
        let index = self.level_of(name).ok_or(Refused::Unknown)?;
        let is_outside = index < self.barrier.level;
        if is_outside && self.levels[index].variables.contains_key(name) {
            return Err(Refused::Outside(self.barrier.around));
        }
        Rc::make_mut(&mut self.levels[index]).variables.get_mut(name).ok_or(Refused::Unknown)
    }

    /// Makes all variables of the current scopes read-only. Returns the previous barrier.
    pub(super) fn close(&mut self, around: Around) -> Barrier {
        std::mem::replace(&mut self.barrier, Barrier { level: self.levels.len(), around })
    }

    /// Returns the variable with the most similar name. The names differ in case or by one changed, missing, added or swapped letter.
    pub(super) fn similar(&self, unknown: &str) -> Option<&str> {
        let known = self.levels.iter().flat_map(|level| level.variables.keys());
        known.filter(|known| is_similar(known, unknown)).min().map(String::as_str)
    }
}

/// Returns whether two names differ in case only, or by one letter. Names of one letter are similar in case only.
fn is_similar(a: &str, b: &str) -> bool {
    let [a, b] = [a, b].map(|name| name.to_lowercase().chars().collect::<Vec<_>>());
    if a == b {
        return true;
    }
    let (short, long) = if a.len() < b.len() { (&a, &b) } else { (&b, &a) };
    let start = short.iter().zip(long).take_while(|(a, b)| a == b).count();
    let (short, long) = (&short[start..], &long[start..]);
    let is_swapped =
        short.len() >= 2 && long.len() == short.len() && short[..2] == [long[1], long[0]] && short[2..] == long[2..];
    let is_changed = short.len() == long.len() && short[1..] == long[1..];
    let is_added = short.len() + 1 == long.len() && *short == long[1..];
    a.len().min(b.len()) > 1 && (is_swapped || is_changed || is_added)
}
