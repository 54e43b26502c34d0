//! T27 and T51: stream lines as dx₁/dx₂ = F₁/F₂. T46: orbits of a saddle by a Runge–Kutta method.

use geoint_runtime::methods::*;
use geoint_runtime::prelude::*;

/// Example 2.2.5: a field that reads time.
#[vector_field]
fn driven(x: [f64; 2], t: f64) -> [f64; 2] {
    [x[0] * t + 2.0 * x[1], x[0] * x[0] - x[1] * t]
}

/// The same field at an instant τ.
#[vector_field]
fn at_an_instant(x: [f64; 2], tau: f64) -> [f64; 2] {
    [x[0] * tau + 2.0 * x[1], x[0] * x[0] - x[1] * tau]
}

/// dx₁/dx₂ = F₁/F₂ at an instant: x₂ is the independent variable.
#[vector_field]
fn line(x: [f64; 1], t: f64, tau: f64) -> [f64; 1] {
    [(x[0] * tau + 2.0 * t) / (x[0] * x[0] - t * tau)]
}

/// The stream function, which is H = x₁x₂τ + x₂² − x₁³/3.
fn stream([x, y]: [f64; 2], tau: f64) -> f64 {
    x * y * tau + y * y - x.powi(3) / 3.0
}

/// T27: H is constant on a stream line of an instant, and not on the path of a particle.
#[test]
fn stream_lines_of_a_field_with_time_are_levels_of_its_energy() -> Result<(), StepError> {
    let (tau, start) = (0.7, [1.5, 0.4]);
    let level = stream(start, tau);
    let mut flow = AtAnInstant { tau }.integrator(DOP853, 0.01, FlowState::new(start));
    let mut path = Driven.integrator(DOP853, 0.01, FlowState::at(tau, start));
    for _ in 0..40 {
        flow.step()?;
        path.step()?;
        assert!((stream(flow.state().x, tau) - level).abs() < 1e-13);
    }
    // The quotient leads to the same point.
    let [x, y] = flow.state().x;
    let mut sim = Line { tau }.integrator(DOP853, (y - start[1]) / 80.0, FlowState::at(start[1], [start[0]]));
    sim.advance(80)?;
    assert!((sim.state().t - y).abs() < 1e-14 && (sim.state().x[0] - x).abs() < 1e-12, "{:?} {x}", sim.state());
    // Control: the particle leaves the stream line of its start.
    assert!((stream(path.state().x, tau) - level).abs() > 0.1, "{:?}", path.state());
    Ok(())
}

/// A free body in its frame.
#[vector_field]
fn top(x: [f64; 3], c: [f64; 3]) -> [f64; 3] {
    [c[0] * x[1] * x[2], c[1] * x[2] * x[0], c[2] * x[0] * x[1]]
}

/// Its orbits, dxₖ/dx₁ = fₖ/f₁ for k = 2, 3.
#[vector_field]
fn orbit_of_top(x: [f64; 2], t: f64, c: [f64; 3]) -> [f64; 2] {
    [c[1] * t / (c[0] * x[0]), c[2] * t / (c[0] * x[1])]
}

/// T51: with x₁ in place of the time, the quotients give the orbit in three dimensions.
#[test]
fn orbits_follow_from_quotients_of_the_field() -> Result<(), StepError> {
    let (c, start) = ([1.0, -1.4, 0.3], [0.2, 0.9, 0.7]);
    let mut motion = Top { c }.integrator(DOP853, 0.01, FlowState::new(start));
    motion.advance(60)?;
    let [end, x, y] = motion.state().x;
    let start = FlowState::at(start[0], [start[1], start[2]]);
    let run = |c: [f64; 3]| -> Result<[f64; 2], StepError> {
        let mut orbit = OrbitOfTop { c }.integrator(DOP853, (end - start.t) / 100.0, start);
        orbit.advance(100)?;
        Ok(orbit.state().x)
    };
    let [u, v] = run(c)?;
    assert!(end - start.t > 0.2 && (u - x).abs() < 1e-13 && (v - y).abs() < 1e-13, "{u} {x}, {v} {y}");
    // Control: another moment of inertia is another orbit.
    let [u, _] = run([1.0, -1.5, 0.3])?;
    assert!((u - x).abs() > 1e-3, "{u} {x}");
    Ok(())
}

/// Example 3.1.3.
#[vector_field]
fn saddle(x: [f64; 2]) -> [f64; 2] {
    [x[0] + x[1], x[0] - x[1]]
}

/// T46: the figure to example 3.1.3 shows orbits of the saddle by a Runge–Kutta method in the first quadrant, up to 10. They are hyperbolas, on which
/// H = xy + y²/2 − x²/2 is constant, and Euler's method leaves them.
#[test]
fn orbits_of_the_saddle_are_hyperbolas() -> Result<(), StepError> {
    let energy = |[x, y]: [f64; 2]| x * y + y * y / 2.0 - x * x / 2.0;
    let root = 2.0_f64.sqrt();
    for start in [[0.1, 8.0], [0.5, 5.0], [1.0, 0.5], [2.0, 3.0], [4.0, 0.1]] {
        let mut orbit = Saddle.integrator(RK4, 0.01, FlowState::new(start));
        let mut euler = Saddle.integrator(ExplicitEuler, 0.01, FlowState::new(start));
        while orbit.state().x[0] < 10.0 {
            orbit.step()?;
            euler.step()?;
            let FlowState { t, x, .. } = orbit.state();
            let (cosh, sinh) = ((root * t).cosh(), (root * t).sinh() / root);
            let exact =
                [cosh * start[0] + sinh * (start[0] + start[1]), cosh * start[1] + sinh * (start[0] - start[1])];
            assert!((x[0] - exact[0]).abs() < 1e-7 && (x[1] - exact[1]).abs() < 1e-7, "{x:?} {exact:?}");
            assert!((energy(x) - energy(start)).abs() < 1e-7 && x[1] > 0.0, "{x:?}");
        }
        let off = energy(euler.state().x) - energy(start);
        assert!(off.abs() > 1e-3, "{off}");
    }
    Ok(())
}
