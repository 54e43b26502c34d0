//! Symplecticity and symmetry of every kind of method. A method has the property to rounding if it claims to. A method of order 1 or 2 without the claim
//! must violate the property measurably; these methods are the controls. `geoint-verification` measures every method.

use geoint_tests::claims::{Geometry, Symmetry};
use geoint_tests::methods;
use geoint_tests::problems::*;

/// Writes the two tests. A row holds a system, the step size, and lists of methods. `finish` returns the number of controls, which must not be zero.
macro_rules! geometry {
    ($($System:ident, $h:literal, $($list:ident)*;)*) => {
        #[test]
        fn symplecticity() { $(
            let mut geometry = Geometry::<$System>::with_step($h);
            $( methods::$list(&mut geometry); )*
            assert!(geometry.finish() > 0, "no control violated the property");
        )* }

        #[test]
        fn symmetry() { $(
            let mut geometry = Symmetry(Geometry::<$System>::with_step($h));
            $( methods::$list(&mut geometry); )*
            assert!(geometry.0.finish() > 0, "no control violated the property");
        )* }
    };
}

geometry! {
    HenonHeiles, 0.2, kinds_of_general kinds_of_discrete_gradient projected relaxed kinds_of_separable kinds_of_nystrom kinds_of_force_gradient
        kinds_of_perturbed kinds_of_perturbed_gradient kinds_of_cubic kinds_of_itoh_abe;
    Planets, 0.3, kinds_of_general kinds_of_perturbed kinds_of_perturbed_gradient;
    Relativistic, 0.1, kinds_of_general kinds_of_discrete_gradient itoh_abe_one_way relaxed kinds_of_separable;
    DoublePendulum, 0.1, kinds_of_general kinds_of_discrete_gradient kinds_of_itoh_abe projected;
    Breathing, 0.1, kinds_of_general kinds_of_discrete_gradient kinds_of_separable;
    SwingingMass, 0.1, kinds_of_general kinds_of_discrete_gradient itoh_abe_one_way coordinate_increment;
    Magnetic, 0.1, kinds_of_general;
}
