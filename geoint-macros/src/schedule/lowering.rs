//! One routine: nodes to statements.

use super::block::{Block, Instruction, Operand, Register, Statement};
use crate::ir::{Function, Graph, HashMap, Id, Node, Number, Ratio, Symbol, Table};

/// The level of every node; constants have none.
pub(super) struct Levels<F> {
    of_symbol: F,
    known: Table<Option<usize>>,
}

impl<F: Fn(Symbol) -> usize> Levels<F> {
    pub(super) fn new(of_symbol: F) -> Self {
        Levels { of_symbol, known: Table::default() }
    }

    fn of(&mut self, graph: &Graph, id: Id) -> Option<usize> {
        if let Some(level) = self.known.get(id) {
            return level;
        }
        for id in graph.unknown(id, &self.known) {
            let level = match graph.node(id) {
                Node::Symbol(symbol) => Some((self.of_symbol)(*symbol)),
                Node::Number(_) | Node::Truth(_) => None,
                // What is made of constants but is not one, like 1/0, is known first.
                node => Some(node.children().iter().filter_map(|child| self.known[*child]).max().unwrap_or(0)),
            };
            self.known.insert(id, level);
        }
        self.known[id]
    }
}

/// A routine, or a branch in it, while it is being written.
#[derive(Default)]
struct Scope {
    block: Block,
    values: Table<Operand>,
    numbered: HashMap<Instruction, Operand>,
    /// What is computed here whatever the conditions are.
    always: Table<()>,
}

/// A summand or factor: a sign and a value, or a product that has not been taken yet.
#[derive(Clone, Copy)]
struct Term {
    negative: bool,
    value: Operand,
    times: Option<Operand>,
}

pub(super) struct Lowering<'a, F> {
    graph: &'a mut Graph,
    levels: &'a mut Levels<F>,
    slots: &'a mut Vec<Vec<Id>>,
    level: usize,
    uses: Table<usize>,
    scopes: Vec<Scope>,
    /// When each register is there, in units of one sum, if nothing has to wait for anything but its operands.
    ready: Vec<u32>,
    /// Bases of which several negative powers are needed, and whether halves are among the exponents.
    reciprocals: HashMap<Id, bool>,
}

impl<'a, F: Fn(Symbol) -> usize> Lowering<'a, F> {
    /// The routine of `level` that computes `roots`.
    pub(super) fn run(
        graph: &'a mut Graph,
        levels: &'a mut Levels<F>,
        slots: &'a mut Vec<Vec<Id>>,
        level: usize,
        roots: &[Id],
    ) -> Block {
        let mut uses: Table<usize> = Table::default();
        let mut count = |id: Id| uses.insert(id, uses.get(id).unwrap_or(0) + 1);
        for id in graph.reachable(roots) {
            graph.node(id).for_each_child(&mut count);
        }
        roots.iter().copied().for_each(count);
        let mut lowering = Lowering {
            graph,
            levels,
            slots,
            level,
            uses,
            scopes: vec![],
            ready: vec![],
            reciprocals: HashMap::default(),
        };
        lowering.find_reciprocals(roots);
        lowering.block(roots)
    }

    fn block(&mut self, roots: &[Id]) -> Block {
        let always = self.always(roots);
        self.scopes.push(Scope { always, ..Scope::default() });
        let results = roots.iter().map(|root| self.operand(*root)).collect();
        let mut block = self.scopes.pop().map(|scope| scope.block).unwrap_or_default();
        block.results = results;
        block
    }

    /// What is needed for `roots` whatever the conditions are, at this level.
    fn always(&mut self, roots: &[Id]) -> Table<()> {
        let mut seen: Table<()> = Table::default();
        let mut open = roots.to_vec();
        while let Some(id) = open.pop() {
            if self.levels.of(self.graph, id) != Some(self.level) || seen.contains(id) {
                continue;
            }
            seen.insert(id, ());
            match self.graph.node(id) {
                Node::Select(condition, _, _) => open.push(*condition),
                node => node.for_each_child(|child| open.push(child)),
            }
        }
        seen
    }

    // ------------------------------------------------------------------------------------------------------ values

    /// The value of a node, computed if it is not known yet.
    fn operand(&mut self, id: Id) -> Operand {
        match self.graph.node(id) {
            Node::Number(value) => return Operand::Constant(*value),
            Node::Truth(value) => return Operand::Truth(*value),
            _ => {}
        }
        // Slots hold numbers; a condition is decided again where it is needed.
        match self.levels.of(self.graph, id) {
            Some(level) if level < self.level && !self.is_condition(id) => return self.slot(level, id),
            _ => {}
        }
        if let Node::Symbol(symbol) = self.graph.node(id) {
            return Operand::Input(*symbol);
        }
        if let Some(known) = self.known(id) {
            return known;
        }
        // Computed as far outside as it is needed whatever the conditions are.
        let home = self.scopes.iter().position(|scope| scope.always.contains(id)).unwrap_or(self.scopes.len() - 1);
        let inner = self.scopes.split_off(home + 1);
        let operand = self.compute(id);
        self.scopes[home].values.insert(id, operand);
        self.scopes.extend(inner);
        operand
    }

    fn is_condition(&self, id: Id) -> bool {
        matches!(self.graph.node(id), Node::Compare(..) | Node::And(..) | Node::Or(..) | Node::Not(_))
    }

    fn known(&self, id: Id) -> Option<Operand> {
        self.scopes.iter().find_map(|scope| scope.values.get(id))
    }

    fn slot(&mut self, level: usize, id: Id) -> Operand {
        let slots = &mut self.slots[level];
        let index = slots.iter().position(|other| *other == id).unwrap_or_else(|| {
            slots.push(id);
            slots.len() - 1
        });
        Operand::Slot(level, index)
    }

    /// The value of an instruction; equal ones are one statement.
    fn emit(&mut self, instruction: Instruction) -> Operand {
        if let Instruction::Neg(Operand::Constant(value)) = instruction {
            return Operand::Constant(value.neg());
        }
        if let Some(known) = self.scopes.iter().find_map(|scope| scope.numbered.get(&instruction)) {
            return *known;
        }
        let register = self.register(instruction.ready(|operand| self.ready(operand)));
        let operand = Operand::Register(register);
        if let Some(scope) = self.scopes.last_mut() {
            scope.block.statements.push(Statement::Let(register, instruction.clone()));
            scope.numbered.insert(instruction, operand);
        }
        operand
    }

    fn register(&mut self, ready: u32) -> Register {
        self.ready.push(ready);
        self.ready.len() - 1
    }

    /// When an operand is there.
    fn ready(&self, operand: &Operand) -> u32 {
        if let Operand::Register(register) = operand { self.ready[*register] } else { 0 }
    }

    fn compute(&mut self, id: Id) -> Operand {
        match self.graph.node(id).clone() {
            Node::Number(value) => Operand::Constant(value),
            Node::Truth(value) => Operand::Truth(value),
            Node::Symbol(symbol) => Operand::Input(symbol),
            Node::Linear(constant, terms) => self.linear(constant, terms),
            Node::Product(_) => {
                let term = self.product(Number::ONE, id);
                self.single(term)
            }
            Node::Power(base, exponent) => self.power(base, exponent),
            Node::Call(function @ (Function::Sin | Function::Cos), args) => self.trigonometric(function, args[0]),
            Node::Call(function, args) => {
                let args = args.iter().map(|arg| self.operand(*arg)).collect();
                self.emit(Instruction::Call(function, args))
            }
            Node::Select(condition, _, _) => self.select(id, condition),
            Node::Compare(relation, a, b) => {
                let (a, b) = (self.operand(a), self.operand(b));
                self.emit(Instruction::Compare(relation, a, b))
            }
            Node::And(a, b) => {
                let (a, b) = (self.operand(a), self.operand(b));
                self.emit(Instruction::And(a, b))
            }
            Node::Or(a, b) => {
                let (a, b) = (self.operand(a), self.operand(b));
                self.emit(Instruction::Or(a, b))
            }
            Node::Not(a) => {
                let a = self.operand(a);
                self.emit(Instruction::Not(a))
            }
        }
    }

    // -------------------------------------------------------------------------------------------------------- sums

    fn linear(&mut self, constant: Number, terms: Vec<(Number, Id)>) -> Operand {
        // What is known earlier is added up earlier.
        let (now, early): (Vec<_>, Vec<_>) =
            terms.into_iter().partition(|(_, id)| self.levels.of(self.graph, *id) == Some(self.level));
        let mut summands = vec![];
        match early[..] {
            [] if constant.is_zero() => {}
            [] => summands.push(Term {
                negative: constant.is_negative(),
                value: Operand::Constant(if constant.is_negative() { constant.neg() } else { constant }),
                times: None,
            }),
            [(Number::MINUS_ONE, id)] if constant.is_zero() => {
                let value = self.operand(id);
                summands.push(Term { negative: true, value, times: None });
            }
            _ => {
                let sum = self.graph.linear(constant, early);
                let value = self.operand(sum);
                summands.push(Term { negative: false, value, times: None });
            }
        }
        for (c, id) in now {
            summands.push(self.product(c, id));
        }
        // What is there last is added last. Start with something that is there already and needs no sign.
        summands.sort_by_key(|term| self.ready(&term.value).max(term.times.map_or(0, |times| self.ready(&times))));
        let start = summands
            .iter()
            .position(|term| !term.negative && term.times.is_none())
            .or_else(|| summands.iter().position(|term| !term.negative))
            .unwrap_or(0);
        let first = summands.remove(start);
        let mut sum = self.single(first);
        for term in summands {
            sum = match term {
                Term { negative: false, value, times: None } => self.emit(Instruction::Add(sum, value)),
                Term { negative: true, value, times: None } => self.emit(Instruction::Sub(sum, value)),
                Term { negative, value, times: Some(other) } => {
                    let value = if negative { self.emit(Instruction::Neg(value)) } else { value };
                    self.emit(Instruction::MulAdd(value, other, sum))
                }
            };
        }
        sum
    }

    /// A term as one value.
    fn single(&mut self, term: Term) -> Operand {
        let value = match term.times {
            Some(other) => self.emit(Instruction::Mul(term.value, other)),
            None => term.value,
        };
        if term.negative { self.emit(Instruction::Neg(value)) } else { value }
    }

    // ---------------------------------------------------------------------------------------------------- products

    /// c·node, its last multiplication left to be fused. What is known earlier is multiplied earlier, c with it.
    fn product(&mut self, c: Number, id: Id) -> Term {
        let mut factors = vec![];
        self.flat_factors(id, true, &mut factors);
        let (now, early): (Vec<Id>, Vec<Id>) =
            factors.into_iter().partition(|id| self.levels.of(self.graph, *id) == Some(self.level));
        let mut negative = false;
        let mut above = vec![];
        if early.is_empty() {
            negative = c.is_negative();
            let magnitude = if negative { c.neg() } else { c };
            if magnitude != Number::ONE {
                above.push(Operand::Constant(magnitude));
            }
        } else {
            let prefactor = self.graph.product(&early);
            let prefactor = self.graph.scale(c, prefactor);
            above.push(self.operand(prefactor));
        }
        let mut below = vec![];
        for id in now {
            match *self.graph.node(id) {
                Node::Power(base, exponent)
                    if exponent.numerator < 0 && self.is_single(id) && !self.reciprocals.contains_key(&base) =>
                {
                    below.push(self.positive_power(base, exponent));
                }
                _ => above.push(self.operand(id)),
            }
        }
        let denominator = below.into_iter().reduce(|a, b| self.emit(Instruction::Mul(a, b)));
        let last = if denominator.is_none() && above.len() > 1 { above.pop() } else { None };
        let numerator = above.into_iter().reduce(|a, b| self.emit(Instruction::Mul(a, b)));
        let value = match (numerator, denominator) {
            (Some(a), Some(b)) => self.emit(Instruction::Div(a, b)),
            (None, Some(b)) => self.emit(Instruction::Div(Operand::Constant(Number::ONE), b)),
            (Some(a), None) => a,
            (None, None) => Operand::Constant(Number::ONE),
        };
        Term { negative, value, times: last }
    }

    /// The factors of a product, taken apart where nothing else needs it as a whole.
    fn flat_factors(&mut self, id: Id, root: bool, factors: &mut Vec<Id>) {
        match self.graph.node(id).clone() {
            Node::Product(ids) if root || self.is_single(id) => {
                for id in ids {
                    self.flat_factors(id, false, factors);
                }
            }
            _ => factors.push(id),
        }
    }

    /// Whether a node has one use and no value yet.
    fn is_single(&self, id: Id) -> bool {
        self.uses.get(id).is_none_or(|uses| uses <= 1) && self.known(id).is_none()
    }

    // ------------------------------------------------------------------------------------------------------ powers

    fn find_reciprocals(&mut self, roots: &[Id]) {
        let mut exponents: HashMap<Id, Vec<Ratio>> = HashMap::default();
        for id in self.graph.reachable(roots) {
            match *self.graph.node(id) {
                Node::Power(base, exponent)
                    if exponent.numerator < 0 && self.levels.of(self.graph, id) == Some(self.level) =>
                {
                    exponents.entry(base).or_default().push(exponent);
                }
                _ => {}
            }
        }
        let several = exponents.into_iter().filter(|(_, exponents)| exponents.len() > 1);
        self.reciprocals = several.map(|(base, all)| (base, all.iter().any(|e| !e.is_integer()))).collect();
    }

    fn power(&mut self, base: Id, exponent: Ratio) -> Operand {
        if let (true, Some(halves)) = (exponent.numerator < 0, self.reciprocals.get(&base).copied()) {
            // One division for all of them: 1/x or 1/√x, and products of that.
            let x = self.operand(base);
            let x = if halves { self.emit(Instruction::Sqrt(x)) } else { x };
            let reciprocal = self.emit(Instruction::Div(Operand::Constant(Number::ONE), x));
            let n = exponent.numerator.unsigned_abs();
            return self.repeated(reciprocal, if halves && exponent.is_integer() { 2 * n } else { n });
        }
        let power = self.positive_power(base, exponent);
        if exponent.numerator < 0 { self.emit(Instruction::Div(Operand::Constant(Number::ONE), power)) } else { power }
    }

    /// base to the magnitude of an exponent, by squaring, with one square root for halves.
    fn positive_power(&mut self, base: Id, exponent: Ratio) -> Operand {
        let x = self.operand(base);
        let n = exponent.numerator.unsigned_abs();
        if exponent.is_integer() {
            return self.repeated(x, n);
        }
        let root = self.emit(Instruction::Sqrt(x));
        match n / 2 {
            0 => root,
            whole => {
                let power = self.repeated(x, whole);
                self.emit(Instruction::Mul(power, root))
            }
        }
    }

    /// xⁿ for n ≥ 1.
    fn repeated(&mut self, x: Operand, n: u64) -> Operand {
        if n <= 1 {
            return x;
        }
        let half = self.repeated(x, n / 2);
        let square = self.emit(Instruction::Mul(half, half));
        if n.is_multiple_of(2) { square } else { self.emit(Instruction::Mul(square, x)) }
    }

    // ------------------------------------------------------------------------------------------ functions, branches

    /// One call where both sine and cosine are needed.
    fn trigonometric(&mut self, function: Function, arg: Id) -> Operand {
        let other = if function == Function::Sin { Function::Cos } else { Function::Sin };
        let value = self.operand(arg);
        let partner = self.graph.call(other, &[arg]);
        let wanted = self.scopes.last().is_some_and(|scope| scope.always.contains(partner));
        if !wanted || self.known(partner).is_some() {
            return self.emit(Instruction::Call(function, vec![value]));
        }
        let ready = self.ready(&value) + Instruction::CALL_LATENCY;
        let (sin, cos) = (self.register(ready), self.register(ready));
        let (own, others) = if function == Function::Sin { (sin, cos) } else { (cos, sin) };
        if let Some(scope) = self.scopes.last_mut() {
            scope.block.statements.push(Statement::SinCos(sin, cos, value));
            scope.values.insert(partner, Operand::Register(others));
        }
        Operand::Register(own)
    }

    /// All selections by one condition that do not need each other, as one `if`.
    fn select(&mut self, id: Id, condition: Id) -> Operand {
        let mut group = vec![id];
        let always: Vec<Id> = self.scopes.last().map(|scope| scope.always.ids().collect()).unwrap_or_default();
        let candidates: Vec<Id> = always
            .into_iter()
            .filter(|other| matches!(self.graph.node(*other), Node::Select(c, _, _) if *c == condition))
            .filter(|other| *other != id && self.known(*other).is_none())
            .collect();
        for other in candidates {
            let needs = |a: Id, b: Id| self.graph.reachable(&[a]).contains(&b);
            if group.iter().all(|member| !needs(other, *member) && !needs(*member, other)) {
                group.push(other);
            }
        }
        let condition = self.operand(condition);
        let arms = |graph: &Graph, pick: fn(Id, Id) -> Id| -> Vec<Id> {
            let arm = |id: &Id| match graph.node(*id) {
                Node::Select(_, first, second) => pick(*first, *second),
                _ => *id,
            };
            group.iter().map(arm).collect()
        };
        let (first, second) = (arms(self.graph, |a, _| a), arms(self.graph, |_, b| b));
        let (first, second) = (self.block(&first), self.block(&second));
        let ready = first.results.iter().chain(&second.results).map(|x| self.ready(x)).max().unwrap_or(0);
        let registers: Vec<Register> = group.iter().map(|_| self.register(ready)).collect();
        if let Some(scope) = self.scopes.last_mut() {
            for (id, register) in group.iter().zip(&registers) {
                scope.values.insert(*id, Operand::Register(*register));
            }
            scope.block.statements.push(Statement::If { registers: registers.clone(), condition, first, second });
        }
        Operand::Register(registers[0])
    }
}
