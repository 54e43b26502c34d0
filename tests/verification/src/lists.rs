//! The measured lists of the catalogue: their scenes, durations, and the step size for conservation.

use crate::methods::{Forms, List, Orders, Runs, Symmetries};
use geoint_runtime::method::{Visitor, catalogue};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_tests::problems::*;
use geoint_tests::scene::Scene;
use geoint_tests::scenes::*;
use std::marker::PhantomData;

/// Measures the list that `$show!` shows to a visitor.
macro_rules! measured {
    ($show:ident, $name:expr, $about:literal: $First:ident over $first:literal by $h:literal, $Second:ident over $second:literal) => {{
        let mut list = List::new($name, $about, [<$First as Scene>::NAME, <$Second as Scene>::NAME]);
        $show!(Orders::<$First>::over(&mut list, $first));
        $show!(Orders::<$Second>::over(&mut list, $second));
        $show!(Symmetries::<$First> { list: &mut list, h: $h, scene: PhantomData });
        $show!(Forms::<$First> { list: &mut list, h: $h, scene: PhantomData });
        $show!(Runs::<$First> { list: &mut list, h: $h, scene: PhantomData });
        eprintln!("{}: {}", list.name, list.rows.len());
        list
    }};
}

/// Methods that keep first integrals. They form no list of the catalogue, because each has different requirements.
macro_rules! integrals {
    ($visitor:expr) => {{
        let mut visitor = $visitor;
        catalogue::discrete_gradient(&mut visitor);
        visitor.visit(FourthOrder(DiscreteGradient));
        visitor.visit(Projection(RK4, Integrals));
        visitor.visit(Projection(DOP853, Integrals));
    }};
}

macro_rules! lists {
    ($($list:ident, $about:literal: $First:ident over $first:literal by $h:literal, $Second:ident over $second:literal;)*) => {
        /// All lists, measured.
        pub(crate) fn all() -> Vec<List> {
            vec![
                $( {
                    macro_rules! show {
                        ($visitor:expr) => { catalogue::$list(&mut $visitor) };
                    }
                    measured!(show, concat!("`catalogue::", stringify!($list), "`"), $about: $First over $first by $h, $Second over $second)
                }, )*
                measured!(integrals, "Fields with integrals", "x' = f(x) with first integrals.": Turns over 2.3 by 0.1, Chains over 2.3),
            ]
        }
    };
}

lists! {
    general, "Every H(q, p, t).":
        HenonHeiles over 6.1 by 0.2, DoublePendulum over 1.3;
    separable, "T(p, t) + V(q, t), and T(p) + g(t)s + V(q) of contact systems.":
        HenonHeiles over 6.1 by 0.2, Relativistic over 1.3;
    quadratic_kinetic, "Quadratic T with a constant mass matrix.":
        HenonHeiles over 6.1 by 0.2, DrivenPendulum over 3.9;
    force_gradient, "Quadratic T with a constant mass matrix, with force gradients.":
        HenonHeiles over 6.1 by 0.2, DrivenPendulum over 3.9;
    processed_force_gradient, "Force gradients with a processor, for systems without an action.":
        HenonHeiles over 6.1 by 0.2, DrivenDuffing over 3.9;
    perturbed, "H = A + B, an exact flow and a kick.":
        HenonHeiles over 6.1 by 0.2, DrivenDuffing over 3.9;
    perturbed_gradient, "H = A + B, where [B, [A, B]] is a kick, or [B, [B, [B, A]]] = 0.":
        HenonHeiles over 6.1 by 0.2, DrivenDuffing over 3.9;
    processed, "H = A + B with the property of `perturbed_gradient`, by steps with a processor.":
        HenonHeiles over 6.1 by 0.2, DrivenDuffing over 3.9;
    principal_axes, "Rigid bodies in their principal axes.":
        Heavies over 2.3 by 0.1, Pulls over 2.3;
    discrete_gradient, "Every H whose divided differences are known.":
        HenonHeiles over 6.1 by 0.2, DoublePendulum over 1.3;
    mean_gradients, "Every undamped H whose divided differences are known.":
        HenonHeiles over 6.1 by 0.2, DoublePendulum over 1.3;
    itoh_abe, "Every undamped H, one coordinate after the other, forward and backward.":
        HenonHeiles over 6.1 by 0.2, Relativistic over 1.3;
    itoh_abe_one_way, "Every undamped H, one coordinate after the other, forward or backward.":
        DoublePendulum over 1.3 by 0.1, Relativistic over 1.3;
    coordinate_increment, "Undamped H. With more than one degree of freedom, a step fails if an increment is orthogonal to its direction.":
        Shears over 2.3 by 0.1, SwingingMass over 3.9;
    projected, "Undamped H(q, p), by steps projected onto the surface of constant energy.":
        HenonHeiles over 6.1 by 0.2, DoublePendulum over 1.3;
    relaxed, "Undamped H(q, p), by steps scaled to keep the energy.":
        HenonHeiles over 6.1 by 0.2, Relativistic over 1.3;
    cubic, "H of degree 3.":
        HenonHeiles over 6.1 by 0.2, OfDegreeThree over 3.1;
    coupled, "Coupled q and p, in pieces with flows in closed form.":
        Shears over 2.3 by 0.1, Pulsating over 1.5;
    nystrom_pieces, "Two pieces with {B, {B, {B, A}}} = 0.":
        Sheet over 1.5 by 0.1, Ridge over 1.5;
    constrained, "Systems with constraints.":
        Spheres over 1.7 by 0.05, Ellipses over 0.9;
    constrained_contact, "Contact systems with constraints.":
        DampedSpheres over 1.7 by 0.05, DampedEllipses over 0.9;
    pieces, "Contact systems in pieces with flows in closed form.":
        Charges over 2.3 by 0.0625, Tangles over 2.3;
    mechanical, "Contact systems T(p) + g(t)s + V(q).":
        Relativists over 2.3 by 0.0625, Quartics over 2.3;
    contact, "Every contact system.":
        Charges over 2.3 by 0.0625, Tangles over 2.3;
    poisson, "x' = S(x) ∇H, in terms with flows in closed form.":
        Spins over 2.3 by 0.1, TwoSpeciesMeet over 2.3;
    planar, "Fields with planar parts.":
        Spins over 2.3 by 0.1, TwoSpeciesMeet over 2.3;
    solved_planes, "Fields with planar parts, by solving an equation in each plane.":
        Spins over 2.3 by 0.1, TwoSpeciesMeet over 2.3;
}
