//! What has two values at a point of the field: roots, and the signs that conditions ask for. All combinations are gone through.

use super::prime::Element;

/// What is chosen. Nodes that ask for the same get the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Question {
    /// Which of the two roots of a number is taken.
    Root(Element),
    /// Whether a number is positive, negative, or zero: the field has no order.
    Sign(Element),
}

/// One more than that of each kind would take too long.
const MOST: usize = 8;

/// The number of a question's answer, and where it was asked first.
#[derive(Clone, Copy, Debug)]
struct Choice {
    question: Question,
    answer: u8,
    answers: u8,
    position: usize,
}

/// The choices of one combination.
#[derive(Clone, Debug, Default)]
pub(super) struct Choices(Vec<Choice>);

impl Choices {
    /// The answer to a question; `None` if there are too many.
    pub(super) fn answer(&mut self, question: Question, answers: u8, position: usize) -> Option<u8> {
        if let Some(known) = self.0.iter().find(|choice| choice.question == question) {
            return Some(known.answer);
        }
        let is_root = |question: &Question| matches!(question, Question::Root(_));
        let alike = self.0.iter().filter(|choice| is_root(&choice.question) == is_root(&question)).count();
        self.0.push(Choice { question, answer: 0, answers, position });
        (alike < MOST).then_some(0)
    }

    /// The answer that a question has got.
    pub(super) fn of(&self, question: Question) -> Option<u8> {
        self.0.iter().find(|choice| choice.question == question).map(|choice| choice.answer)
    }

    /// Goes on to the next combination; the position from which it differs, or `None` after the last.
    pub(super) fn next(&mut self) -> Option<usize> {
        while let Some(last) = self.0.last_mut() {
            if last.answer + 1 < last.answers {
                last.answer += 1;
                return Some(last.position);
            }
            self.0.pop();
        }
        None
    }

    /// The signs of this combination.
    pub(super) fn signs(&self) -> Vec<(Question, u8)> {
        let sign = |choice: &&Choice| matches!(choice.question, Question::Sign(_));
        self.0.iter().filter(sign).map(|choice| (choice.question, choice.answer)).collect()
    }
}
