//! An interpreter of statements.

use crate::ir::{Function, HashMap, Symbol};
use crate::schedule::{Block, Instruction, Operand, Statement};

/// Runs statements.
pub(super) struct Machine<'a> {
    pub(super) registers: HashMap<usize, f64>,
    pub(super) slots: &'a [Vec<f64>],
    pub(super) input: &'a dyn Fn(Symbol) -> f64,
}

impl Machine<'_> {
    pub(super) fn run(&mut self, block: &Block) -> Vec<f64> {
        for statement in &block.statements {
            match statement {
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
        Symbol::Parameter(_) | Symbol::H | Symbol::G => 0,
        Symbol::Q(_) | Symbol::P(_) | Symbol::V(_) | Symbol::S | Symbol::T | Symbol::Start | Symbol::End => 1,
        Symbol::Dq(_) | Symbol::Dp(_) | Symbol::Ds | Symbol::Dv(_) | Symbol::Multiplier(_) => 2,
    }
}
