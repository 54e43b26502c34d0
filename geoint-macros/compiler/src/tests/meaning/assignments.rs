//! Assignments to variables.

use super::*;

#[test]
fn accumulation() {
    agrees!(|q, p, t, a| {
        let mut s = a;
        let r = s;
        s += q[0];
        s -= 2.0 * p[0];
        r * s
    });
    agrees!(|q, p, t, a| {
        let mut s = a;
        s += {
            s += 1.0;
            s * q[0]
        };
        s
    });
    agrees!(|q, p, t, a| {
        let mut s = a;
        let x = s + {
            s += 1.0;
            s
        };
        x * s
    });
    agrees!(|q, p, t, a| {
        let mut k = 0;
        for i in 0..3 {
            k += i;
        }
        k as f64 * q[0]
    });
    agrees!(|q, p, t, a| {
        let mut e = 0.0;
        for i in 0..3 {
            if i == 1 {
                e += q[i];
            } else {
                e -= p[i];
            }
        }
        e
    });
    agrees!(|q, p, t, a| {
        let mut e = 0.0;
        for i in 0..3 {
            for j in (i + 1)..3 {
                e += (q[i] - q[j]).powi(2);
            }
        }
        e
    });
    agrees!(|q, p, t, a| {
        let mut e = 0.0;
        for i in 0..3 {
            e += if q[i] > 0.0 { q[i] } else { -p[i] };
        }
        e
    });
    agrees!(|q, p, t, a| {
        let (mut x, mut y) = (q[0], a);
        x += y;
        y -= x;
        x * y
    });
    refuses!("outside", |q, p, t, a| {
        let mut e = 0.0;
        if q[0] > 0.0 {
            e += 1.0;
        }
        e
    });
    refuses!("outside", |q, p, t, a| {
        let mut e = 0.0;
        if q[0] > 0.0 && {
            e += 1.0;
            true
        } {
            e
        } else {
            2.0 * e
        }
    });
    refuses!("outside", |q, p, t, a| {
        let mut e = 0.0;
        let b = q[0] > 0.0 || {
            e += 1.0;
            true
        };
        e
    });
    refuses!("not followed", |q, p, t, a| {
        let mut x = a;
        let ref mut y = x;
        *y += 1.0;
        x
    });
    agrees!(|q, p, t, a| {
        let mut e = a;
        for i in 0..3 {
            e += e * q[i];
        }
        e
    });
    agrees!(|q, p, t, a| {
        let mut e = a;
        for i in 0..3 {
            let f = |x: f64| x * e;
            e += f(q[i]);
        }
        e
    });
}

#[test]
fn assignments_in_order() {
    agrees!(|q, p, t, a| {
        let mut x = q[0];
        let before = x;
        x = {
            x = p[0];
            x * 2.0
        };
        x - before
    });
    agrees!(|q, p, t, a| {
        let mut x = a;
        x = x * x;
        {
            x = x + q[0];
            let mut x = 5.0;
            x = 7.0;
        }
        x
    });
    agrees!(|q, p, t, a| {
        let mut x = a;
        let f = move |y: f64| x * y;
        x = q[0];
        f(x) + x
    });
    agrees!(|q, p, t, a| {
        fn horner(x: f64, mut value: f64) -> f64 {
            for c in [2.0, 3.0] {
                value = value * x + c;
            }
            value
        }
        horner(q[0], a) * horner(q[1], 1.0)
    });
    agrees!(|q, p, t, a| {
        let mut x = 0.0;
        x = if q[0] > 0.0 {
            let mut y = q[0];
            y = y * y;
            y += a;
            y
        } else {
            a
        };
        x
    });
    agrees!(|q, p, t, a| {
        let (mut x, mut y, mut z) = (a, q[0], q[1]);
        (x, (y, _)) = (y, (x, 3.0));
        [z, x] = [x, z];
        _ = a;
        x - y * z
    });
    agrees!(|mut q, p, t, mut a| {
        a += 1.0;
        q[1] = a;
        q[0] -= a;
        q[0] * q[1] * q[2]
    });
    refuses!("outside of this branch", |q, p, t, a| {
        let mut x = a;
        if q[0] > 0.0 {
            x = q[0];
        }
        x
    });
    refuses!("outside of this branch", |q, p, t, a| {
        let mut x = [a, a];
        for i in 0..2 {
            if q[i] > 0.0 {
                x[i] = q[i];
            }
        }
        x[0]
    });
    refuses!("outside of this function", |q, p, t, a| {
        let mut x = a;
        let mut set = |y: f64| x = y;
        set(q[0]);
        x
    });
    refuses!("no such operator", |q, p, t, a| {
        let (mut x, mut y) = (a, q[0]);
        (x, y) = (y % 2.0, x);
        x + y
    });
}
