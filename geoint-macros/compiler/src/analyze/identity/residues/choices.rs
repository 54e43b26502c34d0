//! Choices at a point of the field: the signs of roots, and the signs of numbers in conditions. All combinations are visited.

use super::prime::Element;

/// A choice to be made. Nodes that ask the same question get one answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Question {
    /// Which of the two roots of a number is taken?
    Root(Element),
    /// Is a number positive, negative, or zero? The field has no order.
    Sign(Element),
}

/// The largest number of choices of each kind.
pub(super) const MOST: usize = 8;

#[derive(Clone, Copy, Debug)]
struct Choice {
    question: Question,
    answer: u8,
    /// The number of possible answers.
    answers: u8,
    /// The position in the evaluation at which the question was first asked.
    position: usize,
}

/// One combination of choices, in the order of the questions.
#[derive(Clone, Debug, Default)]
pub(super) struct Choices(Vec<Choice>);

impl Choices {
    /// Returns the answer to a question. A new question gets the answer 0. `None` if there are too many choices.
    pub(super) fn answer(&mut self, question: Question, answers: u8, position: usize) -> Option<u8> {
        if let Some(known) = self.known(question) {
            return Some(known);
        }
        let is_root = |question: &Question| matches!(question, Question::Root(_));
        let alike = self.0.iter().filter(|choice| is_root(&choice.question) == is_root(&question)).count();
        self.0.push(Choice { question, answer: 0, answers, position });
        (alike < MOST).then_some(0)
    }

    /// The answer to a question, if it was asked.
    pub(super) fn known(&self, question: Question) -> Option<u8> {
        self.0.iter().find(|choice| choice.question == question).map(|choice| choice.answer)
    }

    /// Advances to the next combination. Returns the first position that it changes, or `None` after the last combination.
    pub(super) fn advance(&mut self) -> Option<usize> {
        while let Some(last) = self.0.last_mut() {
            if last.answer + 1 < last.answers {
                last.answer += 1;
                return Some(last.position);
            }
            self.0.pop();
        }
        None
    }

    /// The signs of numbers in this combination.
    pub(super) fn signs(&self) -> Vec<(Question, u8)> {
        let signs = self.0.iter().filter(|choice| matches!(choice.question, Question::Sign(_)));
        signs.map(|choice| (choice.question, choice.answer)).collect()
    }
}
