//! Names of methods are distinct, and their claimed numbers of forces are right. Runs can be chosen by name.

use geoint_runtime::method::{Visitor, catalogue};
use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;
use geoint_runtime::running::{DynTrajectory, Named, UnknownMethod};
use geoint_runtime::system::StateOf;
use geoint_runtime::{Cotangent, ForceGradient, PhaseSpace, QuadraticKinetic, Separable, VectorField};
use geoint_tests::problems::{HenonHeiles, Problem};
use std::cell::Cell;
use std::collections::BTreeSet;

/// All lists for systems of `#[hamiltonian]`.
fn every(visitor: &mut impl Visitor<HenonHeiles>) {
    catalogue::general(visitor);
    catalogue::separable(visitor);
    catalogue::quadratic_kinetic(visitor);
    catalogue::force_gradient(visitor);
    catalogue::discrete_gradient(visitor);
    catalogue::conservative(visitor);
    catalogue::autonomous(visitor);
    catalogue::cubic(visitor);
}

/// T + γs + V with all kinds of methods.
#[contact_hamiltonian]
fn damped(q: [f64; 2], p: [f64; 2], s: f64, m: f64, gamma: f64) -> f64 {
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) + gamma * s + q[0].powi(4) / 4.0 + (q[0] - q[1]).cosh()
}

fn every_contact(visitor: &mut impl Visitor<Damped>) {
    catalogue::separable(visitor);
    catalogue::quadratic_kinetic(visitor);
    catalogue::force_gradient(visitor);
    catalogue::pieces(visitor);
    catalogue::mechanical(visitor);
    catalogue::contact(visitor);
}

#[derive(Default)]
struct Names(Vec<String>);

impl<S: PhaseSpace> Visitor<S> for Names {
    fn visit<M: Method<S> + 'static>(&mut self, method: M) {
        let name = method.name();
        assert!(name == *name.to_string().as_str(), "{name}");
        self.0.push(name.to_string());
    }
}

#[test]
fn names_are_unique() {
    let (mut names, mut contact) = (Names::default(), Names::default());
    every(&mut names);
    every_contact(&mut contact);
    for Names(names) in [&names, &contact] {
        let unique: BTreeSet<_> = names.iter().collect();
        assert_eq!(unique.len(), names.len(), "{names:?}");
        assert!(names.iter().all(|name| !name.is_empty() && !name.contains("Splitting of")), "{names:?}");
    }
    assert!(names.0.len() > 70 && contact.0.len() > 60, "{} {}", names.0.len(), contact.0.len());
    for known in ["StormerVerlet", "Gauss<3>", "Yoshida4 of StormerVerlet", "Projection of RK4", "DOP853"] {
        assert!(names.0.iter().any(|name| name == known), "{known}");
    }
    assert_eq!(
        Method::<HenonHeiles>::name(&Projection(Yoshida4.of(Kahan), Energy)).to_string(),
        "Projection of Yoshida4 of Kahan"
    );
    let name = Method::<HenonHeiles>::name(&Yoshida4.of(StormerVerlet));
    for other in ["Yoshida4", "Yoshida4 of ", "Yoshida4 of StormerVerlet ", "StormerVerlet", ""] {
        assert!(name != *other, "{other:?} is another name");
    }
}

thread_local! {
    /// Kicks, and evaluations of both derivatives of H.
    static COUNT: Cell<u64> = const { Cell::new(0) };
}

/// A system that counts its forces, the cost of kicks and gradients.
#[derive(Clone, Copy, Debug)]
struct Counted(HenonHeiles);

type Plane = <HenonHeiles as Cotangent>::Array;

fn count() {
    COUNT.set(COUNT.get() + 1);
}

impl PhaseSpace for Counted {
    type State = State<[f64; 2]>;
    type Phase = [Plane; 2];
    type Action = ();
    fn hamiltonian(&self, t: f64, z: &[Plane; 2], s: &()) -> f64 {
        self.0.hamiltonian(t, z, s)
    }
    fn outside_domain(&self, _: f64, _: &[Plane; 2], _: &()) -> Option<&'static str> {
        None
    }
}

impl Cotangent for Counted {
    type Coordinates = [f64; 2];
    type Array = Plane;
}

impl VectorField for Counted {
    type Proof = ();
    fn rate(&self, t: f64, z: &[Plane; 2], dz: &mut [Plane; 2]) {
        count();
        self.0.rate(t, z, dz);
    }
}

impl Hamiltonian for Counted {
    type Proof = ();
    fn gradient(&self, t: f64, z: &[Plane; 2], slopes: &mut [Plane; 2]) {
        count();
        self.0.gradient(t, z, slopes);
    }
}

impl Separable for Counted {
    type Proof = ();
    type Kick = <HenonHeiles as Separable>::Kick;
    type Drift = <HenonHeiles as Separable>::Drift;
    fn prepare_kick(&self, h: f64) -> Self::Kick {
        self.0.prepare_kick(h)
    }
    fn prepare_drift(&self, h: f64) -> Self::Drift {
        self.0.prepare_drift(h)
    }
    fn kick(&self, kick: &Self::Kick, t: f64, q: &mut Plane, p: &mut Plane, s: &mut ()) {
        count();
        self.0.kick(kick, t, q, p, s);
    }
    fn drift(&self, drift: &Self::Drift, t: f64, q: &mut Plane, p: &mut Plane, s: &mut ()) {
        self.0.drift(drift, t, q, p, s);
    }
}

impl QuadraticKinetic for Counted {
    type Proof = ();
}

impl ForceGradient for Counted {
    type GradientKick = <HenonHeiles as ForceGradient>::GradientKick;
    fn prepare_gradient_kick(&self, h: f64, g: f64) -> Self::GradientKick {
        self.0.prepare_gradient_kick(h, g)
    }
    fn gradient_kick(&self, kick: &Self::GradientKick, t: f64, q: &mut Plane, p: &mut Plane, s: &mut ()) {
        count();
        self.0.gradient_kick(kick, t, q, p, s);
    }
}

struct Forces;

impl Visitor<Counted> for Forces {
    fn visit<M: Method<Counted> + 'static>(&mut self, method: M) {
        let mut sim = Counted(HenonHeiles::system()).integrator(method, 0.01, HenonHeiles::initial(0.0));
        let mut forces = |steps: u64| {
            COUNT.set(0);
            sim.advance(steps).unwrap();
            COUNT.get()
        };
        // The difference removes the cost at both ends of a run.
        let counted = forces(30) - forces(20);
        assert_eq!(Some(counted), method.claims().forces.map(|forces| 10 * u64::from(forces)), "{}", method.name());
    }
}

#[test]
fn forces_are_counted() {
    catalogue::separable(&mut Forces);
    catalogue::quadratic_kinetic(&mut Forces);
    catalogue::force_gradient(&mut Forces);
    Forces.visit(ExplicitEuler);
    Forces.visit(RK4);
    Forces.visit(DOP853);
}

/// Methods that solve an equation claim no number of forces, because it depends on the iteration.
#[test]
fn forces_of_implicit_methods_are_not_claimed() {
    assert_eq!(Method::<HenonHeiles>::claims(&ImplicitMidpoint).forces, None);
    assert_eq!(Method::<HenonHeiles>::claims(&Projection(RK4, Energy)).forces, None);
    assert_eq!(Method::<HenonHeiles>::claims(&Suzuki4.of(Kahan)).forces, Some(5));
}

/// Asserts that every method chosen by name takes the steps of the method chosen by type.
struct ByName;

fn by_name(name: &str, start: StateOf<HenonHeiles, f64>) -> Result<DynTrajectory<HenonHeiles>, UnknownMethod> {
    let mut named = Named::new(name, HenonHeiles::system(), 0.05, start);
    every(&mut named);
    named.run()
}

impl Visitor<HenonHeiles> for ByName {
    fn visit<M: Method<HenonHeiles> + 'static>(&mut self, method: M) {
        let name = method.name().to_string();
        let start = HenonHeiles::initial(0.0);
        let mut named = by_name(&name, start).unwrap();
        let mut typed = HenonHeiles::system().integrator(method, 0.05, start);
        assert_eq!((named.time(), named.energy()), (typed.time(), typed.energy()), "{name}");
        let [a, b] = [named.advance_to(0.7), typed.advance_to(0.7)];
        assert_eq!((a, named.state(), named.steps()), (b, typed.state(), typed.steps()), "{name}");
        // Either run resumes from the saved state of the other.
        let mut elsewhere = by_name(&name, start).unwrap();
        elsewhere.resume(&typed.saved()).unwrap_or_else(|error| panic!("{name}: {error}"));
        let b = [named.advance(3), elsewhere.advance(3), typed.advance(3)];
        assert_eq!((named.saved(), b[0]), (elsewhere.saved(), b[1]), "{name}");
        assert_eq!((named.saved(), b[0]), (typed.saved(), b[2]), "{name}");
        // Output through the type-erased run is the same.
        let states: Vec<_> = named.until(1.0).collect();
        assert_eq!(states, typed.until(1.0).collect::<Vec<_>>(), "{name}");
        let at: Vec<_> = named.states_at([1.2, 1.5]).collect();
        assert_eq!(at, typed.states_at([1.2, 1.5]).collect::<Vec<_>>(), "{name}");
    }
}

#[test]
fn methods_by_name() {
    every(&mut ByName);
    let error = |name: &str| by_name(name, HenonHeiles::initial(0.0)).err().map(|error| error.to_string());
    let suggested = [
        ("BlanesMoan5", "; did you mean `BlanesMoan4` or `BlanesMoan6`?"),
        ("Yoshida5 of StormerVerlet", "; did you mean `Yoshida4 of StormerVerlet` or `Yoshida6a of StormerVerlet`?"),
        ("blanesmoan4", "; did you mean `BlanesMoan4` or `BlanesMoan6`?"),
        ("Leapfrog", ""),
        ("", ""),
    ];
    for (name, suggestion) in suggested {
        assert_eq!(error(name), Some(format!("no candidate has the name `{name}`{suggestion}")));
    }
}
