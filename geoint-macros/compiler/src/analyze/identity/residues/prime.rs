//! The field of p² elements, p a prime with p ≡ 3 mod 4: residues modulo p, with a root i of −1.
//!
//! Every residue has a square root in this field, and e^(iθ) is an element. Roots, sines and cosines need no other field.

use crate::ir::Ratio;

/// The prime 2ᵇⁱᵗˢ − less.
#[derive(Clone, Copy, Debug)]
pub(in super::super) struct Prime {
    bits: u32,
    less: u64,
    pub(super) value: u64,
}

/// The primes in the order in which they are tried. The numbers 2, 3, 5, 7, 11 and 13 are squares modulo the last two.
pub(in super::super) const PRIMES: [Prime; 4] =
    [Prime::new(61, 1), Prime::new(62, 57), Prime::new(61, 11_913), Prime::new(62, 5_153)];

/// Arithmetic of residues modulo p.
impl Prime {
    const fn new(bits: u32, less: u64) -> Prime {
        Prime { bits, less, value: (1 << bits) - less }
    }

    fn reduce(self, x: u128) -> u64 {
        let fold = |x: u128| (x & ((1 << self.bits) - 1)) + (x >> self.bits) * u128::from(self.less);
        let x = fold(fold(x)) as u64;
        if x >= self.value { x - self.value } else { x }
    }

    fn add(self, a: u64, b: u64) -> u64 {
        let sum = a + b;
        if sum >= self.value { sum - self.value } else { sum }
    }

    fn neg(self, a: u64) -> u64 {
        if a == 0 { 0 } else { self.value - a }
    }

    fn mul(self, a: u64, b: u64) -> u64 {
        self.reduce(u128::from(a) * u128::from(b))
    }

    fn pow(self, base: u64, mut exponent: u64) -> u64 {
        let (mut power, mut square) = (1, base);
        while exponent > 0 {
            if exponent & 1 == 1 {
                power = self.mul(power, square);
            }
            square = self.mul(square, square);
            exponent >>= 1;
        }
        power
    }

    /// A square root, if there is one.
    fn sqrt(self, a: u64) -> Option<u64> {
        let root = self.pow(a, (self.value + 1) / 4);
        (self.mul(root, root) == a).then_some(root)
    }

    /// A residue that is not zero, from a hash.
    pub(in super::super) fn unknown(self, hash: u64) -> Element {
        Element::real(self.reduce(u128::from(hash)).max(1))
    }

    /// The residue of a ratio; `None` if p divides the denominator.
    pub(in super::super) fn ratio(self, ratio: Ratio) -> Option<Element> {
        let residue = |n: u128| (n % u128::from(self.value)) as u64;
        let numerator = residue(ratio.numerator.unsigned_abs());
        let numerator = if ratio.numerator < 0 { self.neg(numerator) } else { numerator };
        let quotient = match residue(ratio.denominator.unsigned_abs()) {
            0 => return None,
            1 => numerator,
            denominator => self.mul(numerator, self.pow(denominator, self.value - 2)),
        };
        Some(Element::real(quotient))
    }
}

/// real + i·imaginary.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(in super::super) struct Element {
    pub(super) real: u64,
    pub(super) imaginary: u64,
}

impl Element {
    pub(in super::super) const ZERO: Element = Element::real(0);
    pub(super) const ONE: Element = Element::real(1);
    pub(super) const I: Element = Element { real: 0, imaginary: 1 };

    const fn real(real: u64) -> Element {
        Element { real, imaginary: 0 }
    }

    pub(super) fn is_zero(self) -> bool {
        self == Element::ZERO
    }
}

/// Arithmetic of elements.
impl Prime {
    pub(in super::super) fn sum(self, a: Element, b: Element) -> Element {
        Element { real: self.add(a.real, b.real), imaginary: self.add(a.imaginary, b.imaginary) }
    }

    pub(super) fn negative(self, a: Element) -> Element {
        Element { real: self.neg(a.real), imaginary: self.neg(a.imaginary) }
    }

    pub(super) fn difference(self, a: Element, b: Element) -> Element {
        self.sum(a, self.negative(b))
    }

    pub(in super::super) fn product(self, a: Element, b: Element) -> Element {
        if a.imaginary == 0 && b.imaginary == 0 {
            return Element::real(self.mul(a.real, b.real));
        }
        let cross = self.add(self.mul(a.real, b.imaginary), self.mul(a.imaginary, b.real));
        let real = self.add(self.mul(a.real, b.real), self.neg(self.mul(a.imaginary, b.imaginary)));
        Element { real, imaginary: cross }
    }

    /// a·ā.
    fn norm(self, a: Element) -> u64 {
        self.add(self.mul(a.real, a.real), self.mul(a.imaginary, a.imaginary))
    }

    /// 1/a = ā/(a·ā); `None` for zero.
    pub(super) fn reciprocal(self, a: Element) -> Option<Element> {
        if a.is_zero() {
            return None;
        }
        let factor = self.pow(self.norm(a), self.value - 2);
        Some(Element { real: self.mul(a.real, factor), imaginary: self.mul(self.neg(a.imaginary), factor) })
    }

    /// baseⁿ; `None` for a negative power of zero.
    pub(in super::super) fn power(self, base: Element, n: i64) -> Option<Element> {
        let base = if n < 0 { self.reciprocal(base)? } else { base };
        let (mut power, mut square, mut n) = (Element::ONE, base, n.unsigned_abs());
        while n > 0 {
            if n & 1 == 1 {
                power = self.product(power, square);
            }
            square = self.product(square, square);
            n >>= 1;
        }
        Some(power)
    }

    /// A square root, if there is one. A number without an imaginary part always has one.
    pub(super) fn root(self, a: Element) -> Option<Element> {
        if a.imaginary == 0 {
            return Some(match self.sqrt(a.real) {
                Some(root) => Element::real(root),
                None => Element { real: 0, imaginary: self.sqrt(self.neg(a.real))? },
            });
        }
        // (x + iy)² = a: x² − y² is the real part of a, and x² + y² is a root of the norm, with either sign.
        let size = self.sqrt(self.norm(a))?;
        let half = self.value.div_ceil(2);
        let square = |size: u64| self.mul(self.add(a.real, size), half);
        let x = self.sqrt(square(size)).or_else(|| self.sqrt(square(self.neg(size))))?;
        let y = self.mul(a.imaginary, self.pow(self.add(x, x), self.value - 2));
        Some(Element { real: x, imaginary: y })
    }

    /// Returns a representative of the pair ±a, and whether it is −a.
    pub(super) fn without_sign(self, a: Element) -> (Element, bool) {
        let negative = self.negative(a);
        if negative < a { (negative, true) } else { (a, false) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn noise(state: &mut u64) -> u64 {
        *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        *state ^ (*state >> 29)
    }

    #[test]
    fn arithmetic_is_that_of_a_field() {
        let mut state = 1;
        for prime in PRIMES {
            assert_eq!(prime.value % 4, 3);
            for _ in 0..200 {
                let [a, b, c] = [(); 3].map(|()| Element {
                    real: noise(&mut state) % prime.value,
                    imaginary: noise(&mut state) % prime.value,
                });
                let left = prime.product(a, prime.sum(b, c));
                assert_eq!(left, prime.sum(prime.product(a, b), prime.product(a, c)));
                let modulo = u128::from(a.real) * u128::from(b.real) % u128::from(prime.value);
                assert_eq!(u128::from(prime.mul(a.real, b.real)), modulo);
                assert_eq!(prime.product(prime.reciprocal(a).unwrap(), a), Element::ONE);
                assert_eq!(prime.power(a, -3), prime.reciprocal(prime.product(a, prime.product(a, a))));
                let square = prime.product(a, a);
                let root = prime.root(square).unwrap();
                assert_eq!(prime.product(root, root), square);
                let real = Element::real(b.real);
                let root = prime.root(real).unwrap();
                assert_eq!(prime.product(root, root), real);
                assert_eq!(prime.without_sign(a).0, prime.without_sign(prime.negative(a)).0);
            }
        }
    }

    #[test]
    fn three_is_no_square_with_the_first_two_primes_but_has_a_root() {
        let three = Element::real(3);
        for (i, prime) in PRIMES.iter().enumerate() {
            let root = prime.root(three).unwrap();
            assert_eq!(root.imaginary == 0, i >= 2);
            assert_eq!(prime.product(root, root), three);
        }
    }
}
