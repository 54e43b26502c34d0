//! Prints calls of routines with several results.

use super::writer::{SLOTS, Writer};
use crate::schedule::{Call, JointFunction, Operand, Register};
use proc_macro2::Delimiter;

impl Writer<'_> {
    /// Prints `results = function(arguments)`.
    pub(super) fn joint_call(&mut self, Call { function, results, arguments }: &Call) {
        match function {
            JointFunction::SinCos => {
                self.grouped(Delimiter::Parenthesis, |writer| writer.registers(&results.concat()));
                self.punct("=");
                self.sin_cos(&arguments.concat());
            }
            JointFunction::Kepler => self.kepler(results, arguments),
            JointFunction::FlowMatrix { size, places } => {
                results.concat().into_iter().for_each(|matrix| self.register(matrix));
                self.punct("=");
                self.path("slope", "flow_matrix");
                self.punct("::<");
                self.word("R");
                self.punct(",");
                self.literal(*size);
                self.punct(">");
                self.grouped(Delimiter::Parenthesis, |writer| writer.entries_of_matrix(places, &arguments.concat()));
            }
            JointFunction::FlowChange => {
                self.grouped(Delimiter::Bracket, |writer| writer.registers(&results.concat()));
                self.punct("=");
                self.path("slope", "flow_change");
                self.grouped(Delimiter::Parenthesis, |writer| writer.matrix_and_vector(&arguments.concat()));
            }
        }
    }

    /// Prints `x.sin_cos()`.
    pub(super) fn sin_cos(&mut self, arguments: &[Operand]) {
        if let [x] = arguments {
            self.method("sin_cos", x, &[]);
        }
    }

    /// Prints Kepler's motion. A row has a number for each orbit.
    fn kepler(&mut self, results: &[Vec<Register>], orbits: &[Vec<Operand>]) {
        self.grouped(Delimiter::Bracket, |writer| {
            for row in rows(results) {
                writer.grouped(Delimiter::Bracket, |writer| writer.registers(&row));
                writer.punct(",");
            }
        });
        self.punct("=");
        self.path("slope", "kepler");
        self.grouped(Delimiter::Parenthesis, |writer| {
            writer.grouped(Delimiter::Bracket, |writer| {
                for row in rows(orbits) {
                    writer.list(&row);
                    writer.punct(",");
                }
            });
        });
    }

    /// Prints `&[(place, entry), …]`.
    fn entries_of_matrix(&mut self, places: &[usize], entries: &[Operand]) {
        self.punct("&");
        self.grouped(Delimiter::Bracket, |writer| {
            for (place, entry) in places.iter().zip(entries) {
                writer.grouped(Delimiter::Parenthesis, |writer| {
                    writer.literal(*place);
                    writer.punct(",");
                    writer.operand(entry);
                });
                writer.punct(",");
            }
        });
    }

    /// Prints `matrix, [x, …]`. The matrix is a register, or a range of slots.
    fn matrix_and_vector(&mut self, arguments: &[Operand]) {
        let [matrix, x @ ..] = arguments else { return };
        match matrix {
            Operand::Slot(level, first) => {
                self.punct("&");
                self.word(SLOTS[*level]);
                self.grouped(Delimiter::Bracket, |writer| {
                    writer.literal(*first);
                    writer.punct("..");
                    writer.literal(first + x.len().pow(2));
                });
            }
            _ => {
                self.operand(matrix);
                self.punct(".");
                self.word("as_flattened");
                self.grouped(Delimiter::Parenthesis, |_| {});
            }
        }
        self.punct(",");
        self.list(x);
    }
}

/// Returns the rows of a table from its columns.
fn rows<T: Copy>(columns: &[Vec<T>]) -> Vec<Vec<T>> {
    let height = columns.first().map_or(0, Vec::len);
    (0..height).map(|row| columns.iter().map(|column| column[row]).collect()).collect()
}
