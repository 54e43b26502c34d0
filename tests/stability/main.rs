//! Stays right: what is kept over long times, what bad input gets, how trajectories are walked.

/// A test for each kind of phase space: `$Visitor` is shown every method for it.
macro_rules! every_method {
    ($Visitor:ident) => {
        every_method! { $Visitor:
            canonical on geoint_tests::problems::HenonHeiles, 0.05: methods general, methods discrete_gradient, methods itoh_abe,
                methods itoh_abe_one_way, methods separable, methods nystrom, methods force_gradient, methods perturbed,
                methods perturbed_gradient, methods processed, methods projected, methods relaxed, methods cubic;
            in_coordinates_of_jacobi on geoint_tests::problems::Planets, 0.05: methods perturbed, methods processed;
            one_degree_of_freedom on geoint_tests::scenes::Shears, 0.05: methods coordinate_increment, catalogue coupled;
            constrained on geoint_tests::scenes::Spheres, 0.02: methods constrained;
            contact on geoint_tests::scenes::Charges, 0.05: catalogue pieces, catalogue contact;
            damped on geoint_tests::scenes::Relativists, 0.05: methods separable, catalogue mechanical;
            flows on geoint_tests::scenes::Spins, 0.05: catalogue poisson, catalogue planar;
            bodies on geoint_tests::scenes::Heavies, 0.05: methods separable, catalogue principal_axes;
        }
    };
    ($Visitor:ident: $($test:ident on $Scene:ty, $h:literal: $($from:ident $list:ident),*;)*) => { $(
        #[test]
        fn $test() {
            #[allow(unused_imports)]
            use {geoint_runtime::method::catalogue, geoint_tests::methods};
            let mut visitor = $Visitor::<$Scene> { h: $h, scene: std::marker::PhantomData };
            $( $from::$list(&mut visitor); )*
        }
    )* };
}

mod damping;
mod adaptive;
mod by_value;
mod refusals;
mod poles;
mod walls;
mod switches;
mod domains;
mod forms;
mod near_misses;
mod small_waves;
mod units;
mod long_steps;
mod rounding;
mod time;
mod names;
mod tolerance;
mod saved;
mod hostile;
