//! Methods of order 4 from symmetric methods of order 2: by a modified structure matrix in place of J (Eidnes 2022), or by a projection.
//!
//! This file documents both, and computes the modified structure matrix. The projection is in `projected.rs` and `canonical.rs`.

use super::energy::{Energy, Slope};
use super::matrix::{Matrix, j_times};
use super::mean::{FourthOrderBase, MeanGradient};
use crate::method::{Failure, Name, Probe};
use crate::scalar::Real;
use crate::space::Array;
use crate::space::vector::{difference, moved, opposite, scaled, sum};
use crate::system::{Conservative, DiscreteField};

/// A step of order 4 that keeps the invariants of a symmetric method of order 2, in one solve. It has two forms.
///
/// # `FourthOrder(DiscreteGradient)`
/// The step projects a mean velocity, x₁ = x₀ + h (F − G(GᵀG)⁻¹GᵀF). The columns of G are the discrete gradients of the invariants. The mean velocity of
/// x' = f(x) is F = (f(x₀) + 4 f(c) + f(x₁))/6 with c = (x₀ + x₁)/2 + h/8 (f(x₀) − f(x₁)).
///
/// The form is for every energy without damping, and for every field with first integrals. It keeps the energy, unless H reads
/// time, and the momenta that the report of the system names.
/// For canonical systems the projection has a metric M, F − MG(GᵀMG)⁻¹GᵀF, so that it does not depend on units. If their energy has different sides of a
/// condition (`if`, `abs`) at both ends, the step is the step of [`DiscreteGradient`](super::DiscreteGradient), of order 2.
///
/// On a circle, and on some other orbits, the gradient of a momentum depends on the gradient of the energy all along the orbit. GᵀMG is then singular. The
/// step keeps the energy only, and the error of the momentum is of the order of the square of the distance from the orbit. Such a step need not be
/// symmetric: on the way back in time, other steps may have this error.
///
/// Steps are refused if a part of the energy is in oscillations of a frequency ω with hω > √12. They turn by more than half a turn in a step. A
/// correction by the weight λ of a column changes the energy by λ ∇H(x₁)·(1 − h ∂F/∂x₁)⁻¹MG, in which such an oscillation has the factor 1 − (hω)²/12. At
/// hω = √12 the projection would therefore move along the surface of constant energy.
///
/// # `FourthOrder(Gonzalez)` and other means
/// With a mean g of gradients, the step is x₁ = x₀ + h S̃ g(x₀, x₁) with S̃ = J + ⅔h JQJ − h²/12 JBJBJ. Here J(q, p) = (p, −q),
/// B = ∇²H((x₀ + x₁)/2), Q = ½(Dᵀ − D), and D = ½(∂g/∂x₁ − ∂g/∂x₀).
///
/// Order 4, symmetric, for every H. S̃ is skew, so accepted steps keep the energy to rounding for every h, if g is a discrete gradient and H does not read
/// time. If H reads time, terms of Magnus' series, with differences of ∇H over the step, preserve the order. In the example `which_discrete_gradient`,
/// [`Suzuki4`](crate::Suzuki4) of the method of order 2 has a tenth of the error of this form at equal h, at about the same cost.
///
/// After S. Eidnes, BIT 62 (2022) 1207, who takes Q from one end: from ∂g(x₀, y)/∂y at y = (x₀ + 2x₁)/3. That step is not symmetric, and has order 3 if
/// third derivatives are not constant. Here Q is taken from both ends. For [`MeanValue`](super::MeanValue), where Q = 0: G. R. W. Quispel &
/// D. I. McLaren, J. Phys. A 41 (2008) 045206.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FourthOrder<G>(
    /// The symmetric method of order 2.
    pub G,
);

impl<G: FourthOrderBase> MeanGradient for FourthOrder<G> {
    const OF_ENERGIES: bool = G::OF_ENERGIES;

    fn mean_name(&self) -> Name {
        Name::new("FourthOrder").of(self.0.mean_name())
    }

    fn is_exact<S: DiscreteField<R>, R: Real>() -> bool {
        G::is_exact::<S, R>()
    }

    /// Returns (1 + ⅔h QJ − h²/12 BJBJ)g, whose product with J is S̃g, plus the terms for a time-dependent H. Returns the derivative of g alone: the
    /// omitted derivatives are O(h).
    fn between<S: DiscreteField<R> + Conservative<R>, R: Real, P: Probe<S, R>>(
        &self,
        energy: &mut Energy<'_, S, R, P>,
        x: &S::Phase,
        d: &S::Phase,
    ) -> Result<Slope<S::Array>, Failure> {
        let (h, [one, half, sixth, twelfth]) = (energy.h, [1.0, 1.0 / 2.0, 1.0 / 6.0, 1.0 / 12.0].map(R::from_f64));
        let Slope { g, mut derivative } = self.0.between(energy, x, d)?;
        let (rate, mut modified) = (j_times(&g), g);
        if !G::CURL_FREE {
            // g is symmetric in both ends. With the ends exchanged, the derivative is ∂g/∂x₀. The difference of both products is 4Q Jg.
            let end = sum(x, d);
            let mut start = self.0.between(energy, &end, &opposite(d))?.derivative;
            let skew_times_rate =
                |slope: &mut Matrix<_>| difference(&slope.transpose_times(&rate), &slope.times(&rate));
            modified
                .add_scaled(sixth * h, &difference(&skew_times_rate(&mut derivative), &skew_times_rate(&mut start)));
        }
        let m = moved(x, half, d);
        let mut middle = energy.gradient(energy.t, &m);
        let acceleration = j_times(&middle.derivative.times(&rate));
        modified.add_scaled(-h * h * twelfth, &middle.derivative.times(&acceleration));

        modified.add_scaled(one, &magnus_terms(energy, &m, &mut middle));
        Ok(Slope { g: modified, derivative })
    }
}

/// Returns h²/24 ∇H'' + h²/12 (B'J∇H − BJ∇H') at the midpoint `m`, where a prime is a derivative with respect to time. Differences over the step
/// replace these derivatives.
///
/// The result is exactly zero if H does not depend on time.
fn magnus_terms<S: DiscreteField<R> + Conservative<R>, R: Real, P: Probe<S, R>>(
    energy: &mut Energy<'_, S, R, P>,
    m: &S::Phase,
    middle: &mut Slope<S::Array>,
) -> S::Phase {
    let (h, [half, sixth, twelfth]) = (energy.h, [1.0 / 2.0, 1.0 / 6.0, 1.0 / 12.0].map(R::from_f64));
    let mut before = energy.gradient(energy.t - half * h, m);
    let mut after = energy.gradient(energy.t + half * h, m);
    let (rate, change) = (j_times(&middle.g), difference(&after.g, &before.g));
    let mut bracket = difference(&after.derivative.times(&rate), &before.derivative.times(&rate));
    bracket = difference(&bracket, &middle.derivative.times(&j_times(&change)));
    let curvature = difference(&difference(&after.g, &middle.g), &difference(&middle.g, &before.g));
    moved(&scaled(sixth, &curvature), h * twelfth, &bracket)
}
