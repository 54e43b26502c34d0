//! Statements with many results, each a call of the runtime: Kepler's motion, linear flows.

use super::writer::{SLOTS, Writer};
use crate::schedule::{Operand, Register};
use proc_macro2::{Delimiter, TokenStream};

impl Writer<'_> {
    pub(super) fn kepler(&mut self, registers: &[[Register; 4]], orbits: &[Vec<Operand>]) {
        // A row holds one number of each orbit.
        let results = self.inside(|writer| {
            for kind in 0..4 {
                let row: Vec<Register> = registers.iter().map(|registers| registers[kind]).collect();
                writer.list(Delimiter::Bracket, &row);
                writer.punct(",");
            }
        });
        self.group(Delimiter::Bracket, results);
        self.punct("=");
        self.word("slope");
        self.punct("::");
        self.word("kepler");
        let rows = self.inside(|writer| {
            for kind in 0..5 {
                let row = writer.inside(|writer| {
                    for orbit in orbits {
                        writer.operand(&orbit[kind]);
                        writer.punct(",");
                    }
                });
                writer.group(Delimiter::Bracket, row);
                writer.punct(",");
            }
        });
        let rows = self.inside(|writer| writer.group(Delimiter::Bracket, rows));
        self.group(Delimiter::Parenthesis, rows);
    }

    /// exp(A) − 1 from the entries of A.
    pub(super) fn flow_matrix(&mut self, register: Register, size: usize, entries: &[(usize, Operand)]) {
        self.register(register);
        self.punct("=");
        self.word("slope");
        self.punct("::");
        self.word("flow_matrix");
        self.punct("::<");
        self.word("R");
        self.punct(",");
        self.literal(size);
        self.punct(">");
        let list = self.inside(|writer| {
            for (place, entry) in entries {
                let pair = writer.inside(|writer| {
                    writer.literal(*place);
                    writer.punct(",");
                    writer.operand(entry);
                });
                writer.group(Delimiter::Parenthesis, pair);
                writer.punct(",");
            }
        });
        let list = self.inside(|writer| {
            writer.punct("&");
            writer.group(Delimiter::Bracket, list);
        });
        self.group(Delimiter::Parenthesis, list);
    }

    /// Such a matrix times a vector.
    pub(super) fn flow_change(&mut self, registers: &[Register], matrix: &Operand, x: &[Operand]) {
        self.list(Delimiter::Bracket, registers);
        self.punct("=");
        self.word("slope");
        self.punct("::");
        self.word("flow_change");
        let arguments = self.inside(|writer| {
            match matrix {
                Operand::Slot(level, first) => {
                    writer.punct("&");
                    writer.word(SLOTS[*level]);
                    let range = writer.inside(|writer| {
                        writer.literal(*first);
                        writer.punct("..");
                        writer.literal(first + x.len().pow(2));
                    });
                    writer.group(Delimiter::Bracket, range);
                }
                _ => {
                    writer.operand(matrix);
                    writer.punct(".");
                    writer.word("as_flattened");
                    writer.group(Delimiter::Parenthesis, TokenStream::new());
                }
            }
            writer.punct(",");
            let x = writer.inside(|writer| {
                for x in x {
                    writer.operand(x);
                    writer.punct(",");
                }
            });
            writer.group(Delimiter::Bracket, x);
        });
        self.group(Delimiter::Parenthesis, arguments);
    }
}
