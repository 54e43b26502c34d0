//! Symplecticity and symmetry of every method, as claimed and not otherwise.

use geoint_runtime::Method;
use geoint_runtime::method::Refusal;
use geoint_tests::measure::{form_defect, symmetry_defect};
use geoint_tests::methods::{self, Visitor};
use geoint_tests::problems::*;
use geoint_tests::scalars::Dual;
use std::marker::PhantomData;

/// A step long enough for what is not symplectic or symmetric to show.
struct Geometry<P> {
    h: f64,
    failures: Vec<String>,
    controls: usize,
    problem: PhantomData<P>,
}

impl<P: Problem> Geometry<P> {
    fn with_step(h: f64) -> Self {
        Geometry { h, failures: vec![], controls: 0, problem: PhantomData }
    }

    /// `kept` bounds the defect from above if the property is claimed, 10⁻⁶ from below if not: of a composition of high
    /// order that is not asked, because it may come as close to the exact flow as its order says.
    fn judge(&mut self, name: &str, order: u32, claimed: bool, defect: Result<f64, Refusal>, kept: f64) {
        let control = !claimed && order <= 2;
        self.controls += usize::from(control);
        let good = matches!(defect, Ok(defect) if (!claimed || defect <= kept) && (!control || defect > 1e-6));
        let shown = defect.map_or_else(|error| error.to_string(), |defect| format!("{defect:.1e}"));
        println!("{:16} {name:45} {claimed:5} {shown}", P::NAME);
        if !good {
            self.failures.push(format!("{name}: claimed {claimed}, defect {shown}"));
        }
    }

    fn finish(self) {
        assert!(self.failures.is_empty(), "{}:\n{}", P::NAME, self.failures.join("\n"));
        assert!(self.controls > 0, "nothing showed what a failure looks like");
    }
}

impl<P: Problem> Visitor<P::Over<Dual>, Dual> for Geometry<P> {
    fn visit<M: Method<P::Over<Dual>, Dual> + 'static>(&mut self, method: M) {
        let name = method.name().to_string();
        let defect = form_defect::<P, M>(method, self.h, 3);
        self.judge(&name, method.claims().order, method.claims().symplectic, defect, 1e-12);
    }
}

/// The same measurement for symmetry; another type because its scalar is another.
struct Symmetry<P>(Geometry<P>);

impl<P: Problem> Visitor<P::Over<f64>, f64> for Symmetry<P> {
    fn visit<M: Method<P::Over<f64>, f64> + 'static>(&mut self, method: M) {
        let name = method.name().to_string();
        let defect = symmetry_defect::<P, M>(method, self.0.h, 3);
        self.0.judge(&name, method.claims().order, method.claims().symmetric, defect, 1e-13);
    }
}

macro_rules! geometry {
    ($($System:ident, $h:literal, $($list:ident)*;)*) => {
        #[test]
        fn symplecticity() { $(
            let mut geometry = Geometry::<$System>::with_step($h);
            $( methods::$list(&mut geometry); )*
            geometry.finish();
        )* }

        #[test]
        fn symmetry() { $(
            let mut geometry = Symmetry(Geometry::<$System>::with_step($h));
            $( methods::$list(&mut geometry); )*
            geometry.0.finish();
        )* }
    };
}

geometry! {
    HenonHeiles, 0.2, general discrete_gradient projected relaxed separable nystrom force_gradient perturbed perturbed_gradient cubic itoh_abe;
    Planets, 0.3, general perturbed perturbed_gradient;
    Relativistic, 0.1, general discrete_gradient itoh_abe itoh_abe_one_way projected relaxed separable;
    DoublePendulum, 0.1, general discrete_gradient itoh_abe itoh_abe_one_way projected;
    Breathing, 0.1, general discrete_gradient separable;
    SwingingMass, 0.1, general discrete_gradient itoh_abe itoh_abe_one_way coordinate_increment;
    Magnetic, 0.1, general;
}
