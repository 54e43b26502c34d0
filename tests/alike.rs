//! The same bits from two runs, by each kind of step; and from two builds: where `BITS` names a folder, the last states are written to it by the
//! first one, and read by the next. `.ci/alike` lets one without optimisation write, and one with it read.

use geoint_runtime::prelude::*;
use geoint_runtime::space::{Snapshot, Summation};
use geoint_runtime::{Method, PhaseSpace, TaylorIntegrator};
use geoint_tests::methods::Visitor;
use geoint_tests::problems::{DoublePendulum, Problem};
use geoint_tests::scene::{Scene, flat, point};
use std::marker::PhantomData;
use std::path::Path;

/// The coordinates of a state, to the last bit.
fn bits(state: &impl Snapshot<Real = f64>) -> String {
    flat(state).iter().chain([&state.time()]).map(|x| format!("{:016x}\n", x.to_bits())).collect()
}

/// Two runs lead to the same state, and so did that of the build before.
fn alike(name: &str, run: impl Fn() -> String) {
    let found = run();
    assert_eq!(found, run(), "{name}: two runs");
    let Some(folder) = std::env::var_os("BITS") else { return };
    let file = Path::new(&folder).join(name);
    if file.exists() {
        assert_eq!(std::fs::read_to_string(file).expect("a state"), found, "{name}: two builds");
    } else {
        std::fs::write(file, found).expect("a state");
    }
}

/// Steps by the bare loop, and one by one.
fn ended<S: PhaseSpace, M: Method<S>, C: Summation<S::Phase>>(mut sim: Integrator<S, M, f64, C>) -> String {
    sim.advance(25).and_then(|()| sim.step()).expect("steps");
    bits(&sim.state())
}

/// Methods of a list on a scene.
struct Alike<P> {
    h: f64,
    scene: PhantomData<P>,
}

impl<P: Scene> Visitor<P::Over<f64>> for Alike<P> {
    fn visit<M: Method<P::Over<f64>> + 'static>(&mut self, method: M) {
        let (t, x) = P::start();
        let run = || Integrator::new(P::over::<f64>(), method, self.h, point(t, &x));
        alike(&format!("{}, {}", P::NAME, method.name()), || ended(run()) + &ended(run().compensated()));
    }
}

// Tables go through the same steps: one method of each kind is enough, and is built twice.
geoint_tests::every_method! { Alike:
    canonical on geoint_tests::problems::HenonHeiles, 0.05: methods kinds_of_general, methods kinds_of_discrete_gradient,
        methods itoh_abe_one_way, methods kinds_of_separable, methods kinds_of_nystrom, methods kinds_of_force_gradient,
        methods processed, methods projected, methods relaxed, methods cubic;
    in_coordinates_of_jacobi on geoint_tests::problems::Planets, 0.05: methods perturbed;
    one_degree_of_freedom on geoint_tests::scenes::Shears, 0.05: methods coordinate_increment, catalogue coupled;
    constrained on geoint_tests::scenes::Spheres, 0.02: methods constrained;
    contact on geoint_tests::scenes::Charges, 0.05: methods kinds_of_pieces, catalogue contact;
    damped on geoint_tests::scenes::Relativists, 0.05: methods kinds_of_separable, catalogue mechanical;
    flows on geoint_tests::scenes::Spins, 0.05: catalogue poisson;
    bodies on geoint_tests::scenes::Heavies, 0.05: methods kinds_of_separable, catalogue principal_axes;
}

/// Estimates of errors choose the steps of these.
#[test]
fn steps_that_adapt() {
    fn check<T: Trajectory<State = State<[f64; 2]>>>(name: &str, run: impl Fn() -> T) {
        alike(name, || {
            let mut run = run();
            run.advance(100).expect("steps");
            bits(&run.state())
        });
    }
    let (system, start) = (DoublePendulum::system::<f64>(), DoublePendulum::initial(0.2));
    check("adaptive DOP853", || system.adaptive(DOP853, 1e-9, start));
    check("adaptive Gauss", || system.adaptive(Gauss::<3>, 1e-9, start));
    check("adaptive discrete gradient", || system.adaptive(DiscreteGradient, 1e-6, start));
    check("Taylor", || TaylorIntegrator::new(system, Taylor::default(), start));
}
