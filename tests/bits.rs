//! Every processor gives the same bits, if `strict-math` or a processor without fused operations promises them.
//!
//! The energy is a polynomial: elementary functions come from the platform and may round otherwise.

use geoint_runtime::Method;
use geoint_runtime::prelude::*;

#[hamiltonian]
fn henon_heiles(q: [f64; 2], p: [f64; 2], m: f64) -> f64 {
    let [x, y] = q;
    (p[0] * p[0] + p[1] * p[1]) / (2.0 * m) + (x * x + y * y) / 2.0 + x * x * y - y * y * y / 3.0
}

/// True if the build contracts a·b + c, as `multiply_add` of the scalars decides.
const FUSED: bool = cfg!(all(feature = "std", target_feature = "fma", not(feature = "strict-math")));

fn bits<M: Method<HenonHeiles>>(method: M) -> [u64; 4] {
    let mut sim = HenonHeiles { m: 1.3 }.integrator(method, 0.1, State::new([0.1, -0.2], [0.3, 0.25]));
    sim.advance(1000).expect("a regular orbit");
    let State { q, p, .. } = sim.state();
    [q[0], q[1], p[0], p[1]].map(f64::to_bits)
}

#[test]
fn polynomial_energies_round_alike_everywhere() {
    let expected = [
        (
            "StormerVerlet",
            bits(StormerVerlet),
            [0x3fd3430ea2148e8a, 0x3f898387b34dbf4e, 0xbfaf736c47ac19d0, 0x3fd3b2e393d656c8],
        ),
        (
            "BlanesMoanSrkn14a",
            bits(BlanesMoanSrkn14a),
            [0x3fd338167d84a79b, 0x3f7614ad634b8b41, 0xbfa94c0f97bb967d, 0x3fd40fbe3962b9ef],
        ),
        ("RK4", bits(RK4), [0x3fd337deed2c571e, 0x3f7607e4b57b0b20, 0xbfa9479e95ec9ebc, 0x3fd41017ae48c684]),
    ];
    for (name, found, expected) in expected {
        // A fused operation rounds once instead of twice. In a fused build the bits must differ, else nothing would be fused.
        assert_eq!(found == expected, !FUSED, "{name}: {found:#x?}");
    }
}
