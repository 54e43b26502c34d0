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

geoint_tests::every_kind!(Alike);

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
