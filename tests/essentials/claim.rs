//! A claim, and the control that must break it.
//!
//! A test that passes for every method proves nothing. So each claim is checked twice under the same bound: for the method that makes it, and for
//! a method that does not, the control.

use geoint_runtime::Trajectory;
use geoint_runtime::space::Snapshot;

/// The bound that the control must exceed, in units of the bound of the claim.
const CONTROL: f64 = 10.0;

/// Asserts that `defect` is at most `bound` for the method and at least ten times as large for the control.
pub(crate) fn holds<X: Snapshot<Real = f64>>(
    claim: &str,
    bound: f64,
    defect: impl Fn(&mut dyn Trajectory<State = X>) -> f64,
    mut method: impl Trajectory<State = X>,
    mut control: impl Trajectory<State = X>,
) {
    let (kept, broken) = (defect(&mut method), defect(&mut control));
    assert!(kept <= bound, "{claim}: the defect is {kept:.1e}, the bound {bound:.1e}");
    assert!(
        broken > CONTROL * bound,
        "{claim}: the control has a defect of {broken:.1e} only, the bound is {bound:.1e}"
    );
}

/// Returns the largest change of a quantity over `steps` steps, relative to its size at the start or to 1, whichever is larger.
pub(crate) fn change<X: Snapshot<Real = f64>>(
    steps: u64,
    quantity: impl Fn(&X) -> f64,
) -> impl Fn(&mut dyn Trajectory<State = X>) -> f64 {
    move |run| {
        let start = quantity(&run.state());
        let mut largest = 0.0;
        for _ in 0..steps {
            run.step().expect("the problem is regular");
            let change = (quantity(&run.state()) - start).abs() / start.abs().max(1.0);
            assert!(change.is_finite());
            largest = f64::max(largest, change);
        }
        largest
    }
}

/// Returns the largest relative change of the energy over `steps` steps.
pub(crate) fn energy<X: Snapshot<Real = f64>>(steps: u64) -> impl Fn(&mut dyn Trajectory<State = X>) -> f64 {
    move |run| {
        let start = run.energy();
        let mut largest = 0.0;
        for _ in 0..steps {
            run.step().expect("the problem is regular");
            let change = (run.energy() / start - 1.0).abs();
            assert!(change.is_finite());
            largest = f64::max(largest, change);
        }
        largest
    }
}

/// Returns the distance from a known state, after a run to its time.
pub(crate) fn distance_from<X: Snapshot<Real = f64>>(known: X) -> impl Fn(&mut dyn Trajectory<State = X>) -> f64 {
    move |run| {
        let (end, expected, action) = known.parts();
        run.advance_to(end).expect("the problem is regular");
        let (t, found, found_action) = run.state().parts();
        assert!((t - end).abs() < 1e-12, "the run ends at {t}, not at {end}");
        let numbers = |phase: &X::Phase, action: &X::Action| numbers::<X>(phase, action);
        let pairs = numbers(&found, &found_action).into_iter().zip(numbers(&expected, &action));
        pairs.map(|(a, b)| (a - b).abs()).fold(0.0, |largest, d| if d <= largest { largest } else { d })
    }
}

/// Returns all coordinates of a phase, and the action if there is one.
fn numbers<X: Snapshot<Real = f64>>(phase: &X::Phase, action: &X::Action) -> Vec<f64> {
    use geoint_runtime::private::Action;
    use geoint_runtime::space::Array;
    [phase.as_slice(), action.numbers()].concat()
}

/// Asserts the order of convergence of a method, and that the control has a lower one.
///
/// `method` and `control` make a run with a given step length. The order follows from the errors at the time of `solution` with steps of `h` and
/// `h/2`; an observed order may miss the claim by 0.25.
pub(crate) fn has_order<X, M, C>(
    name: &str,
    order: u32,
    h: f64,
    solution: X,
    method: impl Fn(f64) -> M,
    control: impl Fn(f64) -> C,
) where
    X: Snapshot<Real = f64>,
    M: Trajectory<State = X>,
    C: Trajectory<State = X>,
{
    let error = distance_from(solution);
    let (found, lower) = (
        (error(&mut method(h)) / error(&mut method(h / 2.0))).log2(),
        (error(&mut control(h)) / error(&mut control(h / 2.0))).log2(),
    );
    let claimed = f64::from(order);
    assert!(found > claimed - 0.25, "{name} claims order {order}, observed {found:.2}");
    assert!(lower < claimed - 0.75, "{name}: the control must have an order below {order}, observed {lower:.2}");
}
