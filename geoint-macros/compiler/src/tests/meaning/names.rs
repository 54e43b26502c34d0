//! Names: shadowing, items, closures, attributes.

use super::*;

#[test]
fn shadowing() {
    agrees!(|q, p, t, a| {
        let a = a + 1.0;
        let a = a * a;
        a + {
            let a = 0.5;
            q[0] * a
        }
    });
    agrees!(|q, p, t, a| {
        let q = q[0];
        let x = {
            let q = q * q;
            q + 1.0
        };
        x * q
    });
    agrees!(|q, p, t, a| {
        let mut e = a;
        {
            e += q[0];
            let mut e = 1.0;
            e += 100.0;
        }
        e
    });
    agrees!(|q, p, t, a| {
        let mut e = 0.0;
        for a in 0..3 {
            let e2 = a as f64;
            e += e2 * q[a];
        }
        e + a
    });
    agrees!(|q, p, t, a| {
        fn q(x: f64) -> f64 {
            2.0 * x
        }
        q(a)
    });
    agrees!(|q, p, t, a| {
        let f = |a: f64| a * q[0];
        let a = f(2.0);
        f(a)
    });
}

#[test]
fn items_see_items_where_they_are_written() {
    agrees!(|q, p, t, a| {
        const K: f64 = 2.0;
        fn f(x: f64) -> f64 {
            K * x
        }
        {
            const K: f64 = 3.0;
            f(q[0]) + K
        }
    });
    agrees!(|q, p, t, a| {
        const E: f64 = TAU;
        const TAU: f64 = 2.0;
        E * q[0]
    });
    agrees!(|q, p, t, a| {
        const X: f64 = E * 2.0;
        {
            const E: f64 = 1.0;
            X * E
        }
    });
    agrees!(|q, p, t, a| {
        fn f(x: f64) -> f64 {
            g(x) + 1.0
        }
        fn g(x: f64) -> f64 {
            x * x
        }
        {
            fn g(x: f64) -> f64 {
                9.0
            }
            f(q[0]) + g(a)
        }
    });
    agrees!(|q, p, t, a| {
        fn f(x: f64) -> f64 {
            fn f(x: f64) -> f64 {
                x + 1.0
            }
            2.0 * f(x)
        }
        f(q[0])
    });
    agrees!(|q, p, t, a| {
        let h = |x: f64| {
            const K: f64 = 4.0;
            fn g(x: f64) -> f64 {
                K * x
            }
            g(x) + a
        };
        h(q[0])
    });
    agrees!(|q, p, t, a| {
        let x = f(q[0]);
        fn f(x: f64) -> f64 {
            x + K
        }
        const K: f64 = 0.5;
        x
    });
    agrees!(|q, p, t, a| {
        const W: [f64; 3] = [1.0, 2.0, 3.0];
        let mut e = 0.0;
        for i in 0..3 {
            e += W[i] * q[i];
        }
        e
    });
    agrees!(|q, p, t, a| {
        const R: usize = 3;
        let mut e = 0.0;
        for i in 0..R {
            e += q[i];
        }
        e
    });
    refuses!("cannot be generic", |q, p, t, a| {
        fn f<const N: usize>(x: [f64; N]) -> f64 {
            N as f64
        }
        f(q)
    });
    refuses!("calls itself", |q, p, t, a| {
        fn f(x: f64) -> f64 {
            if x > 0.0 { f(x - 1.0) } else { x }
        }
        f(q[0])
    });
    refuses!("calls itself", |q, p, t, a| {
        fn f(x: f64) -> f64 {
            g(x)
        }
        fn g(x: f64) -> f64 {
            if x > 0.0 { f(x - 1.0) } else { x }
        }
        g(q[0])
    });
    refuses!("this item", |q, p, t, a| {
        static K: f64 = 2.0;
        K * q[0]
    });
    refuses!("move this above", |q, p, t, a| {
        use crate::tests::meaning::E as PI;
        PI * q[0]
    });
    refuses!("move this above", |q, p, t, a| {
        use crate::tests::meaning::consts::*;
        PI * q[0]
    });
}

#[test]
fn closures() {
    agrees!(|q, p, t, a| {
        let k = 2.0;
        let f = move |x: f64| k * x;
        let k = 5.0;
        f(q[0]) + k
    });
    agrees!(|q, p, t, a| {
        let f = |x: f64| move |y: f64| x - y;
        let g = f(q[0]);
        g(p[0])
    });
    agrees!(|q, p, t, a| {
        let f = |[x, y, _]: [f64; 3], (u, v): (f64, f64)| x * u - y * v;
        f(q, (p[0], a))
    });
    agrees!(|q, p, t, a| {
        let mut s = a;
        let c = s;
        s += 1.0;
        let f = move || s;
        s += 1.0;
        f() * c + s
    });
    agrees!(|q, p, t, a| {
        let f = |mut x: f64| {
            x += 1.0;
            x
        };
        f(a) + a
    });
    refuses!("outside", |q, p, t, a| {
        let mut s = 0.0;
        let mut f = |x: f64| {
            s += x;
            s
        };
        f(q[0])
    });
    refuses!("outside", |q, p, t, a| {
        let mut s = 0.0;
        q.iter()
            .map(|x| {
                s += x;
                s
            })
            .sum::<f64>()
    });
}

#[test]
fn code_that_others_may_change_is_refused() {
    refuses!("may change or remove", |q, p, t, a| {
        #[cfg(any())]
        let a = 2.0;
        a
    });
    refuses!("may change or remove", |q, p, t, a| {
        let x = [
            #[cfg(any())]
            1.0,
            a,
        ];
        x[0]
    });
    refuses!("may change or remove", |q, p, t, a| {
        #[cfg(any())]
        fn f() -> f64 {
            1.0
        }
        q[0]
    });
    agrees!(|q, p, t, a| {
        #[allow(unused_variables)]
        let b = 2.0;
        #[rustfmt::skip] let c = a;
        c
    });
}

#[test]
fn names_for_types() {
    agrees!(|q, p, t, a| {
        type Number = f64;
        let n: Number = 2 as Number;
        let inner = {
            type Number = i32;
            (7 as Number / 2) as f64
        };
        n * Number::sin(q[0]) + inner * a
    });
    agrees!(|q, p, t, a| {
        type Pair = [Number; 2];
        type Number = f64;
        let pair: Pair = [q[0], Number::cos(a)];
        fn twice(x: f64) -> f64 {
            type Number = f64;
            x * 2 as Number
        }
        twice(pair[0]) * pair[1]
    });
}
