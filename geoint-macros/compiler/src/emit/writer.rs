//! Operations to tokens: one assignment each.
//!
//! Most of what the macro emits comes from here, so tokens are pushed one by one: in an unoptimised build, as proc macros
//! are, that is several times faster than quoting.

use super::given::Given;
use super::tokens::Tokens;
use crate::ir::{Function, HashMap, Number, Relation, Symbol};
use crate::schedule::{Block, Instruction, LANES, Operand, Register, Statement};
use proc_macro2::{Delimiter, Group, Ident, Literal, Punct, Spacing, Span, TokenStream, TokenTree};
use quote::{ToTokens, format_ident};
use std::cell::RefCell;

/// The arrays in which routines find the slots of earlier levels.
pub(crate) const SLOTS: [&str; 2] = ["prepared", "start"];

/// What a routine calls what it reads and computes.
pub(crate) struct Names<'a> {
    /// Registers, as in all routines.
    pub(super) registers: &'a RefCell<Vec<Ident>>,
    pub(super) input: &'a dyn Fn(Symbol) -> Given,
    /// So many coordinates the system has.
    pub(super) degrees: usize,
}

/// Writes the statements of a routine.
pub(super) struct Writer<'a> {
    pub(super) names: Names<'a>,
    /// Inputs, slots and constants get a name where the routine begins, so that statements are made of names alone.
    given_names: HashMap<Operand, Ident>,
    /// The same names in order.
    declared: Vec<Ident>,
    given: Vec<TokenTree>,
    /// Names are made once.
    words: Vec<(&'static str, Ident)>,
    registers: Vec<Ident>,
    /// Registers that are entries of arrays.
    pub(super) members: HashMap<Register, TokenStream>,
    tokens: Vec<TokenTree>,
}

impl<'a> Writer<'a> {
    pub(super) fn new(names: Names<'a>) -> Self {
        Writer {
            given_names: HashMap::default(),
            declared: vec![],
            given: vec![],
            words: vec![],
            registers: names.registers.take(),
            members: HashMap::default(),
            tokens: vec![],
            names,
        }
    }

    /// Names, statements, and what comes last.
    pub(super) fn finished(mut self, alone: &[Register], last: impl ToTokens) -> TokenStream {
        let mut tokens = self.declaration(alone);
        self.names.registers.replace(self.registers);
        tokens.extend(self.given);
        tokens.extend(self.tokens);
        last.to_tokens(&mut tokens);
        tokens
    }
}

impl Writer<'_> {
    /// Writes the statements; returns the results.
    pub(super) fn block(&mut self, block: &Block) -> Vec<Tokens> {
        for statement in &block.statements {
            self.statement(statement);
        }
        block.results.iter().map(|operand| self.result(operand)).collect()
    }

    pub(super) fn result(&mut self, operand: &Operand) -> Tokens {
        self.apart(|writer| writer.operand(operand)).into()
    }

    /// `target = value;`
    pub(super) fn assign(&mut self, target: Tokens, value: Tokens) {
        target.push_to(&mut self.tokens);
        self.punct("=");
        value.push_to(&mut self.tokens);
        self.punct(";");
    }

    /// `let (names, registers,);` of a routine, or of a branch, which has no names of its own.
    fn declaration(&mut self, registers: &[Register]) -> TokenStream {
        let names = std::mem::take(&mut self.declared);
        if names.is_empty() && registers.is_empty() {
            return TokenStream::new();
        }
        self.inside(|writer| {
            writer.word("let");
            let list = writer.inside(|writer| {
                for name in names {
                    writer.tokens.push(name.into());
                    writer.punct(",");
                }
                for register in registers {
                    writer.register(*register);
                    writer.punct(",");
                }
            });
            writer.group(Delimiter::Parenthesis, list);
            writer.punct(";");
        })
    }

    pub(super) fn statement(&mut self, statement: &Statement) {
        match statement {
            Statement::Let(register, instruction) => {
                self.register(*register);
                self.punct("=");
                self.instruction(instruction);
            }
            Statement::SinCos(sin, cos, x) => {
                self.list(Delimiter::Parenthesis, &[*sin, *cos]);
                self.punct("=");
                self.method("sin_cos", x, &[]);
            }
            Statement::Kepler(registers, orbits) => self.kepler(registers, orbits),
            Statement::FlowMatrix(register, size, entries) => self.flow_matrix(*register, *size, entries),
            Statement::FlowChange(registers, matrix, x) => self.flow_change(registers, matrix, x),
            Statement::Gather(register, four) => {
                self.register(*register);
                self.punct("=");
                self.word("R");
                self.punct("::");
                self.word("four");
                let list = self.inside(|writer| {
                    let list = writer.inside(|writer| writer.separated(four));
                    writer.group(Delimiter::Bracket, list);
                });
                self.group(Delimiter::Parenthesis, list);
            }
            Statement::Spread(registers, four) => {
                let names = self.inside(|writer| {
                    for lane in 0..LANES {
                        match registers.get(lane) {
                            Some(register) => writer.register(*register),
                            None => writer.word("_"),
                        }
                        writer.punct(",");
                    }
                });
                self.group(Delimiter::Bracket, names);
                self.punct("=");
                self.register(*four);
                self.punct(".");
                self.literal(0);
            }
            Statement::If { registers, condition, first, second } => {
                self.list(Delimiter::Bracket, registers);
                self.punct("=");
                self.word("R");
                self.punct("::");
                self.word("choose");
                let arguments = self.inside(|writer| {
                    writer.operand(condition);
                    writer.punct(",");
                    writer.branch(first);
                    writer.punct(",");
                    writer.branch(second);
                });
                self.group(Delimiter::Parenthesis, arguments);
            }
        }
        self.punct(";");
    }

    /// `|| { statements [results,] }`
    fn branch(&mut self, block: &Block) {
        let body = self.inside(|writer| {
            let names = std::mem::take(&mut writer.declared);
            let declaration = writer.declaration(&block.registers());
            writer.declared = names;
            writer.tokens.extend(declaration);
            let results = writer.block(block);
            let list = writer.inside(|writer| {
                for result in results {
                    result.push_to(&mut writer.tokens);
                    writer.punct(",");
                }
            });
            writer.group(Delimiter::Bracket, list);
        });
        self.punct("||");
        self.group(Delimiter::Brace, body);
    }

    pub(super) fn instruction(&mut self, instruction: &Instruction) {
        match instruction {
            Instruction::Neg(a) => self.prefix("-", a),
            Instruction::Not(a) => self.prefix("!", a),
            Instruction::Add(a, b) => self.infix(a, "+", b),
            Instruction::Sub(a, b) => self.infix(a, "-", b),
            Instruction::Mul(a, b) => self.infix(a, "*", b),
            Instruction::Div(a, b) => self.infix(a, "/", b),
            Instruction::And(a, b) => self.infix(a, "&", b),
            Instruction::Or(a, b) => self.infix(a, "|", b),
            Instruction::Compare(Relation::Less, a, b) => self.method("less", a, &[*b]),
            Instruction::Compare(Relation::LessEqual, a, b) => self.method("less_equal", a, &[*b]),
            Instruction::Compare(Relation::Equal, a, b) => self.method("equal", a, &[*b]),
            Instruction::MulAdd(a, b, c) => self.method("multiply_add", a, &[*b, *c]),
            Instruction::Sqrt(a) => self.method("sqrt", a, &[]),
            Instruction::Call(function, args) => self.call(*function, args),
        }
    }

    fn prefix(&mut self, sign: &str, a: &Operand) {
        self.punct(sign);
        self.operand(a);
    }

    fn infix(&mut self, a: &Operand, sign: &str, b: &Operand) {
        self.operand(a);
        self.punct(sign);
        self.operand(b);
    }

    /// `x.name(args)`
    pub(super) fn method(&mut self, name: &'static str, x: &Operand, args: &[Operand]) {
        self.operand(x);
        self.punct(".");
        self.word(name);
        self.arguments(args);
    }

    fn call(&mut self, function: Function, args: &[Operand]) {
        let entry = function.entry();
        match args {
            [x, rest @ ..] if entry.public => self.method(entry.name, x, rest),
            _ => {
                self.word("slope");
                self.punct("::");
                self.word(entry.name);
                self.arguments(args);
            }
        }
    }

    fn arguments(&mut self, args: &[Operand]) {
        let args = self.inside(|writer| writer.separated(args));
        self.group(Delimiter::Parenthesis, args);
    }

    /// `a, b,`
    fn separated(&mut self, operands: &[Operand]) {
        for operand in operands {
            self.operand(operand);
            self.punct(",");
        }
    }

    pub(super) fn operand(&mut self, operand: &Operand) {
        match operand {
            Operand::Truth(value) => self.word(if *value { "true" } else { "false" }),
            Operand::Register(register) => match self.members.get(register) {
                Some(entry) => self.tokens.extend(entry.clone()),
                None => self.register(*register),
            },
            Operand::Input(Symbol::Time) => self.word("t"),
            Operand::Input(Symbol::StepStart) => self.word("start"),
            Operand::Input(Symbol::StepEnd) => self.word("end"),
            Operand::Input(Symbol::StepLength) => self.word("h"),
            Operand::Input(Symbol::GradientWeight) => self.word("g"),
            Operand::Input(_) | Operand::Slot(..) | Operand::Constant(_) => {
                let name = match self.given_names.get(operand) {
                    Some(name) => name.clone(),
                    None => self.give(*operand),
                };
                self.tokens.push(name.into());
            }
        }
    }

    /// Names something that the routine is given: `name = value;` before all statements.
    fn give(&mut self, operand: Operand) -> Ident {
        let name = match operand {
            Operand::Input(Symbol::Position(i)) => format_ident!("q{i}"),
            Operand::Input(Symbol::Momentum(i)) => format_ident!("p{i}"),
            Operand::Input(Symbol::Parameter(i)) => format_ident!("a{i}"),
            Operand::Input(Symbol::PositionIncrement(i)) => format_ident!("dq{i}"),
            Operand::Input(Symbol::MomentumIncrement(i)) => format_ident!("dp{i}"),
            Operand::Input(Symbol::Action) => format_ident!("action"),
            Operand::Input(Symbol::ActionIncrement) => format_ident!("ds"),
            // Not `p0`, as momenta are called.
            Operand::Slot(level, i) => format_ident!("{}_{i}", SLOTS[level]),
            _ => format_ident!("k{}", self.given_names.len()),
        };
        self.given_names.insert(operand, name.clone());
        self.declared.push(name.clone());
        let outside = std::mem::take(&mut self.tokens);
        self.tokens.push(name.clone().into());
        self.punct("=");
        match operand {
            Operand::Input(symbol) => (self.names.input)(symbol).tokens().push_to(&mut self.tokens),
            Operand::Slot(level, index) => {
                self.word(SLOTS[level]);
                let index = self.inside(|writer| writer.literal(index));
                self.group(Delimiter::Bracket, index);
            }
            Operand::Constant(value) => self.constant(value),
            Operand::Truth(_) | Operand::Register(_) => {}
        }
        self.punct(";");
        self.given.append(&mut std::mem::replace(&mut self.tokens, outside));
        name
    }

    /// A constant of the scalar type.
    fn constant(&mut self, value: Number) {
        let value = value.to_f64();
        self.word("R");
        self.punct("::");
        self.word("from_f64");
        let literal = self.inside(|writer| {
            if value < 0.0 {
                writer.punct("-");
            }
            // Coefficients may overflow in a derivative; the step will say so.
            match value.abs() {
                magnitude if magnitude.is_finite() => writer.tokens.push(Literal::f64_unsuffixed(magnitude).into()),
                magnitude => {
                    writer.word("f64");
                    writer.punct("::");
                    writer.word(if magnitude.is_nan() { "NAN" } else { "INFINITY" });
                }
            }
        });
        self.group(Delimiter::Parenthesis, literal);
    }

    // ------------------------------------------------------------------------------------------------------ tokens

    pub(super) fn extend(&mut self, tokens: TokenStream) {
        self.tokens.extend(tokens);
    }

    pub(super) fn word(&mut self, word: &'static str) {
        for (known, ident) in &self.words {
            if *known == word {
                self.tokens.push(ident.clone().into());
                return;
            }
        }
        let ident = Ident::new(word, Span::call_site());
        self.words.push((word, ident.clone()));
        self.tokens.push(ident.into());
    }

    pub(super) fn literal(&mut self, number: usize) {
        self.tokens.push(Literal::usize_unsuffixed(number).into());
    }

    pub(super) fn register(&mut self, register: Register) {
        while self.registers.len() <= register {
            self.registers.push(Ident::new(&format!("v{}", self.registers.len()), Span::mixed_site()));
        }
        self.tokens.push(self.registers.as_slice()[register].clone().into());
    }

    /// One or two characters.
    pub(super) fn punct(&mut self, punct: &str) {
        let (last, first) = punct.as_bytes().split_last().unwrap_or((&b' ', &[]));
        for c in first {
            self.tokens.push(Punct::new(*c as char, Spacing::Joint).into());
        }
        self.tokens.push(Punct::new(*last as char, Spacing::Alone).into());
    }

    /// `(a, b,)` or `[a, b,]`.
    pub(super) fn list(&mut self, delimiter: Delimiter, registers: &[Register]) {
        let names = self.inside(|writer| {
            for register in registers {
                writer.register(*register);
                writer.punct(",");
            }
        });
        self.group(delimiter, names);
    }

    pub(super) fn group(&mut self, delimiter: Delimiter, tokens: TokenStream) {
        self.tokens.push(Group::new(delimiter, tokens).into());
    }

    /// What `write` writes, apart from the rest: what is in a group.
    pub(super) fn inside(&mut self, write: impl FnOnce(&mut Self)) -> TokenStream {
        self.apart(write).into_iter().collect()
    }

    fn apart(&mut self, write: impl FnOnce(&mut Self)) -> Vec<TokenTree> {
        let outside = std::mem::take(&mut self.tokens);
        write(self);
        std::mem::replace(&mut self.tokens, outside)
    }
}
