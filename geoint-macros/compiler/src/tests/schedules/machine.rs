//! An interpreter of statements.

use crate::ir::{Function, HashMap, Symbol};
use crate::schedule::{
    Array, Block, Call, Computed, Instruction, JointFunction, Layout, Loop, Operand, Place, Register, Source,
    Statement, Successive,
};

/// Contents of a pack.
type Lanes = [f64; 4];

/// A routine while it runs.
pub(super) struct Machine<'a> {
    registers: HashMap<Register, f64>,
    packs: HashMap<Register, Lanes>,
    /// Registers of matrices, column by column.
    matrices: HashMap<Register, Vec<f64>>,
    /// The arrays that loops have computed. An entry has one number, or a number for each part.
    arrays: HashMap<usize, Vec<Vec<f64>>>,
    /// The arrays that the routine was given. Loops read and write them.
    pub(super) memory: HashMap<Place, f64>,
    slots: &'a [Vec<f64>],
    input: &'a dyn Fn(Symbol) -> f64,
}

impl<'a> Machine<'a> {
    /// Returns a routine that has not started.
    pub(super) fn new(slots: &'a [Vec<f64>], input: &'a dyn Fn(Symbol) -> f64) -> Self {
        Machine {
            registers: HashMap::default(),
            packs: HashMap::default(),
            matrices: HashMap::default(),
            arrays: HashMap::default(),
            memory: HashMap::default(),
            slots,
            input,
        }
    }

    /// Stores symbols in the arrays that the routine is given.
    pub(super) fn with(mut self, layout: &Layout<'_>, symbols: impl IntoIterator<Item = Symbol>) -> Self {
        for symbol in symbols {
            self.memory.insert(layout.place(symbol), (self.input)(symbol));
        }
        self
    }

    /// Runs a block. Returns its results: a number, or all numbers of a matrix.
    pub(super) fn run(&mut self, block: &Block) -> Vec<f64> {
        for statement in &block.statements {
            self.statement(statement);
        }
        let mut results = vec![];
        for operand in &block.results {
            match operand {
                Operand::Register(register) if self.matrices.contains_key(register) => {
                    results.extend(&self.matrices[register]);
                }
                _ => results.push(self.operand(operand)),
            }
        }
        results
    }

    fn statement(&mut self, statement: &Statement) {
        match statement {
            Statement::Let(register, instruction) => {
                let value = self.value(instruction);
                self.registers.insert(*register, value);
            }
            Statement::Call(call) => self.call(call),
            Statement::If { registers, condition, first, second } => {
                let values = self.run(if self.operand(condition) == 1.0 { first } else { second });
                self.registers.extend(registers.iter().copied().zip(values));
            }
            Statement::Loop(each) => self.repeat(each),
            Statement::Gather(register, four) => {
                let four = four.map(|x| self.operand(&x));
                self.packs.insert(*register, four);
            }
            Statement::Pack { register, instruction, members } => {
                assert!((3..=4).contains(members));
                let each = [0, 1, 2, 3].map(|lane| {
                    let registers = self.packs.iter().map(|(register, four)| (*register, four[lane])).collect();
                    Machine { registers, ..Machine::new(self.slots, self.input) }.value(instruction)
                });
                self.packs.insert(*register, each);
            }
            Statement::Spread(registers, pack) => {
                let four = self.packs[pack];
                self.registers.extend(registers.iter().copied().zip(four));
            }
            Statement::Write(place, value) => {
                let value = self.operand(value);
                self.memory.insert(place.clone(), value);
            }
        }
    }

    fn call(&mut self, Call { function, results, arguments }: &Call) {
        for (registers, arguments) in results.iter().zip(arguments) {
            let values = match (function, &arguments[..]) {
                (JointFunction::SinCos, [x]) => vec![self.operand(x).sin(), self.operand(x).cos()],
                (JointFunction::Kepler, orbit) => {
                    let orbit: Vec<f64> = orbit.iter().map(|x| self.operand(x)).collect();
                    Function::KEPLER.map(|function| (function.entry().value)(&orbit)).into()
                }
                (JointFunction::FlowMatrix { size, places }, entries) => {
                    let mut a = vec![0.0; size * size];
                    places.iter().zip(entries).for_each(|(place, entry)| a[*place] = self.operand(entry));
                    self.matrices.insert(registers[0], flow_matrix(*size, &a));
                    return;
                }
                (JointFunction::FlowChange, [matrix, x @ ..]) => {
                    let x: Vec<f64> = x.iter().map(|x| self.operand(x)).collect();
                    times(self.matrix(matrix, x.len()), &x)
                }
                _ => panic!("{function:?} of {arguments:?}"),
            };
            self.registers.extend(registers.iter().copied().zip(values));
        }
    }

    /// Returns the numbers of a matrix, which a register or slots hold.
    fn matrix(&self, operand: &Operand, size: usize) -> &[f64] {
        match operand {
            Operand::Slot(level, first) => &self.slots[*level][*first..first + size * size],
            Operand::Register(register) => &self.matrices[register],
            _ => panic!("{operand:?} is no matrix"),
        }
    }

    fn repeat(&mut self, each: &Loop) {
        for i in 0..each.length {
            for (register, successive) in &each.reads {
                let value = self.entry(successive, i);
                self.registers.insert(*register, value);
            }
            each.body.iter().for_each(|statement| self.statement(statement));
            let values: Vec<f64> = each.results.iter().map(|register| self.registers[register]).collect();
            match &each.target {
                Some(target) => {
                    let (place, old) = (place(target, i), values[0]);
                    assert!(self.memory.insert(place, old).is_some(), "a loop writes to an entry that exists");
                }
                None => self.arrays.entry(each.array).or_default().push(values),
            }
        }
        // Registers of the body belong to the loop.
        for statement in &each.body {
            let (Statement::Let(..) | Statement::Call(_)) = statement else { panic!("{statement:?} in a loop") };
            for register in registers(statement) {
                self.registers.remove(&register);
            }
        }
        if each.target.is_none() {
            assert_eq!(each.members.len(), each.length);
            for (registers, values) in each.members.iter().zip(&self.arrays[&each.array]) {
                self.registers.extend(registers.iter().zip(values).map(|(register, value)| (*register, *value)));
            }
        }
    }

    /// Returns the entry of a loop that member i reads.
    fn entry(&self, successive: &Successive, i: usize) -> f64 {
        let index = place(successive, i).indices.last().copied().unwrap_or_default();
        match successive.source {
            Source::Given(..) => self.memory[&place(successive, i)],
            Source::Slots(level) => self.slots[level][index],
            Source::Computed(Computed { array, part }) => self.arrays[&array][index][part.unwrap_or(0)],
            Source::One(_) => panic!("an operand that all members share is read before the loop"),
        }
    }

    fn operand(&self, operand: &Operand) -> f64 {
        match operand {
            Operand::Constant(value) => value.to_f64(),
            Operand::Truth(value) => f64::from(u8::from(*value)),
            Operand::Input(symbol) => (self.input)(*symbol),
            Operand::Slot(level, index) => self.slots[*level][*index],
            // A register that is read before it is written is a mistake of the schedule.
            Operand::Register(register) => self.registers[register],
        }
    }

    fn value(&self, instruction: &Instruction) -> f64 {
        let of = |operand: &Operand| self.operand(operand);
        let truth = |x: bool| f64::from(u8::from(x));
        match instruction {
            Instruction::Neg(a) => -of(a),
            Instruction::Add(a, b) => of(a) + of(b),
            Instruction::Sub(a, b) => of(a) - of(b),
            Instruction::Mul(a, b) => of(a) * of(b),
            Instruction::Div(a, b) => of(a) / of(b),
            Instruction::MulAdd(a, b, c) => of(a) * of(b) + of(c),
            Instruction::Sqrt(a) => of(a).sqrt(),
            Instruction::Call(function, args) => (function.entry().value)(&args.iter().map(of).collect::<Vec<_>>()),
            Instruction::Compare(relation, a, b) => truth(relation.holds(of(a), of(b))),
            Instruction::And(a, b) => of(a) * of(b),
            Instruction::Or(a, b) => of(a).max(of(b)),
            Instruction::Not(a) => 1.0 - of(a),
        }
    }
}

/// Returns the registers of a statement in the body of a loop.
fn registers(statement: &Statement) -> Vec<Register> {
    Block { statements: vec![statement.clone()], results: vec![] }.registers()
}

/// Returns the place of the entry of a loop that belongs to member i.
fn place(successive: &Successive, i: usize) -> Place {
    let (array, rank) = match successive.source {
        Source::Given(array, rank) => (array, rank),
        _ => (Array::Number(Symbol::Time), 1),
    };
    let index = |k: usize| usize::try_from(successive.first[k] + successive.step[k] * i as i32).expect("an index");
    Place { array, indices: (0..rank).rev().map(index).collect() }
}

/// Returns exp(A) − 1 by its series for a part of A, and squarings.
fn flow_matrix(size: usize, a: &[f64]) -> Vec<f64> {
    const HALVINGS: i32 = 6;
    let column = |matrix: &[f64], j: usize| matrix[j * size..(j + 1) * size].to_vec();
    let product = |a: &[f64], b: &[f64]| -> Vec<f64> { (0..size).flat_map(|j| times(a, &column(b, j))).collect() };
    let part: Vec<f64> = a.iter().map(|x| x / 2.0_f64.powi(HALVINGS)).collect();
    let (mut term, mut sum) = (part.clone(), part.clone());
    for k in 2..20 {
        term = product(&part, &term).iter().map(|x| x / f64::from(k)).collect();
        sum.iter_mut().zip(&term).for_each(|(sum, term)| *sum += term);
    }
    for _ in 0..HALVINGS {
        let square = product(&sum, &sum);
        sum.iter_mut().zip(square).for_each(|(sum, square)| *sum = 2.0 * *sum + square);
    }
    sum
}

/// Returns the product of a matrix, column by column, and a vector.
fn times(matrix: &[f64], x: &[f64]) -> Vec<f64> {
    let size = x.len();
    (0..size).map(|row| (0..size).map(|j| matrix[j * size + row] * x[j]).sum()).collect()
}

/// Levels of a Newton iteration: parameters and h, the start of the step, the increment.
pub(super) fn level(symbol: Symbol) -> usize {
    match symbol {
        Symbol::Parameter(_) | Symbol::StepLength | Symbol::GradientWeight => 0,
        Symbol::Position(_)
        | Symbol::Momentum(_)
        | Symbol::Velocity(_)
        | Symbol::Action
        | Symbol::Time
        | Symbol::StepStart
        | Symbol::StepEnd => 1,
        Symbol::PositionIncrement(_)
        | Symbol::MomentumIncrement(_)
        | Symbol::ActionIncrement
        | Symbol::VelocityIncrement(_)
        | Symbol::Multiplier(_) => 2,
    }
}
