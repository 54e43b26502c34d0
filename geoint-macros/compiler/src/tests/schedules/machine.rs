//! An interpreter of statements.

use crate::ir::{Function, HashMap, Symbol};
use crate::schedule::{Block, Instruction, Operand, Statement};

/// Runs statements.
pub(super) struct Machine<'a> {
    registers: HashMap<usize, f64>,
    /// Registers of four numbers side by side.
    fours: HashMap<usize, [f64; 4]>,
    slots: &'a [Vec<f64>],
    input: &'a dyn Fn(Symbol) -> f64,
}

impl<'a> Machine<'a> {
    pub(super) fn new(slots: &'a [Vec<f64>], input: &'a dyn Fn(Symbol) -> f64) -> Self {
        Machine { registers: HashMap::default(), fours: HashMap::default(), slots, input }
    }

    pub(super) fn run(&mut self, block: &Block) -> Vec<f64> {
        for statement in &block.statements {
            match statement {
                Statement::Let(register, instruction) if self.is_of_fours(instruction) => {
                    let each = [0, 1, 2, 3].map(|lane| {
                        let registers = self.fours.iter().map(|(register, four)| (*register, four[lane])).collect();
                        Machine { registers, ..Machine::new(self.slots, self.input) }.value(instruction)
                    });
                    self.fours.insert(*register, each);
                }
                Statement::Let(register, instruction) => {
                    let value = self.value(instruction);
                    self.registers.insert(*register, value);
                }
                Statement::SinCos(sin, cos, x) => {
                    let x = self.operand(x);
                    self.registers.extend([(*sin, x.sin()), (*cos, x.cos())]);
                }
                Statement::Kepler(registers, orbits) => {
                    for (registers, orbit) in registers.iter().zip(orbits) {
                        let orbit: Vec<f64> = orbit.iter().map(|x| self.operand(x)).collect();
                        let results = Function::KEPLER.map(|function| (function.entry().value)(&orbit));
                        self.registers.extend(registers.iter().copied().zip(results));
                    }
                }
                Statement::Gather(register, four) => {
                    let four = four.map(|x| self.operand(&x));
                    self.fours.insert(*register, four);
                }
                Statement::Spread(registers, four) => {
                    let four = self.fours[four];
                    self.registers.extend(registers.iter().copied().zip(four));
                }
                Statement::FlowMatrix(..) | Statement::FlowChange(..) => {
                    unreachable!("a matrix is no number: these are tested as they are emitted")
                }
                Statement::If { registers, condition, first, second } => {
                    let values = self.run(if self.operand(condition) == 1.0 { first } else { second });
                    self.registers.extend(registers.iter().copied().zip(values));
                }
            }
        }
        block.results.iter().map(|operand| self.operand(operand)).collect()
    }

    /// Whether an instruction reads four numbers at once, and nothing else.
    fn is_of_fours(&self, instruction: &Instruction) -> bool {
        let is_four =
            |operand: &Operand| matches!(operand, Operand::Register(register) if self.fours.contains_key(register));
        let operands = instruction.operands();
        assert!(operands.iter().all(is_four) || !operands.iter().any(is_four), "{instruction:?}");
        operands.iter().any(is_four)
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
