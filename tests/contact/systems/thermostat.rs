//! Energies that are multiplied by a function of the action.

use super::*;
use geoint_runtime::methods::*;

const SYSTEM: Thermostat = Thermostat { k: 0.3 };

#[test]
fn it_takes_two_pieces_and_has_its_order() {
    let start = ContactState::new(1.0, 0.5, 0.3);
    let truth = solution(&Thermostat { k: Double::from(SYSTEM.k) }, &flat(&start), 10.0, 40);
    let two = [0.1, 0.05].map(|h| gap(&after(SYSTEM, ContactSplitting, h, start, 10.0), &truth));
    assert!(two[1] < 8e-4 && (order(two) - 2.0).abs() < 0.05, "{two:?}");
    let four = [0.2, 0.1].map(|h| gap(&after(SYSTEM, BlanesMoan4X, h, start, 10.0), &truth));
    assert!(four[1] < 1e-6 && (order(four) - 4.0).abs() < 0.2, "{four:?}");
    assert_eq!(<Thermostat as Pieces<ContactSplitting>>::PIECES.len(), 2);
}

/// H' = −H ∂H/∂s = −k H².
#[test]
fn the_reciprocal_of_the_energy_grows_steadily() {
    let start = ContactState::new(1.0, 1.8, 0.0);
    let law = |t: f64| 1.0 / (1.0 / SYSTEM.energy(&start) + SYSTEM.k * t);
    let errors = [0.2, 0.1].map(|h| {
        let mut sim = SYSTEM.integrator(BlanesMoan4X, h, start);
        largest(sim.until(100.0).map(|x| x.map(|x| SYSTEM.energy(&x) / law(x.t) - 1.0).unwrap()))
    });
    assert!(errors[1] < 2.5e-7 && (order(errors) - 4.0).abs() < 0.2, "{errors:?}");
}
