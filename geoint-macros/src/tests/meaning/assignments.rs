//! Assignments, and loops with them.

use super::*;
use geoint_runtime::nalgebra::Vector3;

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
fn loops_that_assign_again_are_unrolled() {
    // Kepler's equation by Newton's iteration.
    agrees!(|q, p, t, a| {
        let (mean, e) = (q[0], 0.3);
        let mut x = mean;
        for _ in 0..8 {
            x = x - (x - e * x.sin() - mean) / (1.0 - e * x.cos());
        }
        x
    });
    // Horner's scheme.
    agrees!(|q, p, t, a| {
        let mut value = 0.0;
        for c in [1.0, -2.0, 0.5, a] {
            value = value * q[0] + c;
        }
        value
    });
    // Chebyshev polynomials by their recurrence.
    agrees!(|q, p, t, a| {
        let (mut before, mut now) = (1.0, q[0]);
        for _ in 2..6 {
            (before, now) = (now, 2.0 * q[0] * now - before);
        }
        now + a * before
    });
    // Powers and factorials.
    agrees!(|q, p, t, a| {
        let mut sum = 1.0;
        let mut term = 1.0;
        for n in 1..8 {
            term *= q[0];
            term /= n as f64;
            sum += term;
        }
        sum
    });
    agrees!(|q, p, t, a| {
        let mut n = 1;
        let mut k = 100;
        for i in 1..4 {
            n = n * i;
            k /= 2;
            k %= 13;
        }
        n as f64 * q[0] + k as f64
    });
    agrees!(|q, p, t, a| {
        let mut largest = 0;
        for i in 0..3 {
            if i * i > largest {
                largest = i;
            }
        }
        q[largest]
    });
    agrees!(|q, p, t, a| {
        let mut x = a;
        for i in 0..3 {
            if i == 1 {
                x = q[i];
            } else if i == 2 {
                x *= p[i];
            }
        }
        x
    });
    agrees!(|q, p, t, a| {
        let mut x = a;
        for i in 0..2 {
            let mut y = x;
            for j in 0..i + 1 {
                y = y * q[j] + x;
            }
            x = y;
        }
        x
    });
    agrees!(|q, p, t, a| {
        let mut swapped = false;
        let mut e = a;
        for i in 0..3 {
            if swapped {
                e -= q[i];
            }
            swapped = !swapped;
        }
        e
    });
    agrees!(|q, p, t, a| {
        let mut e = 0.0;
        for mut x in q {
            x *= a;
            e += x;
        }
        e + q[0]
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
}

#[test]
fn elements_are_assigned_to() {
    agrees!(|q, p, t, a| {
        let mut x = [0.0; 3];
        for i in 0..3 {
            x[i] = q[i] * p[i];
            x[(i + 1) % 3] += a;
        }
        x[0] - x[1] * x[2]
    });
    agrees!(|q, p, t, a| {
        let mut m = [[0.0; 3]; 3];
        for i in 0..3 {
            for j in 0..3 {
                m[i][j] += q[i] * p[j];
                m[j][i] -= a;
            }
        }
        let row = m[1];
        m[1] = [1.0, 2.0, 3.0];
        m[1][2] *= row[0];
        m[1].iter().sum::<f64>() + m[0][1]
    });
    agrees!(|q, p, t, a| {
        let x = q;
        let mut y = x;
        y[0] = a;
        x[0] + y[0]
    });
    agrees!(|q, p, t, a| {
        let mut e = 0.0;
        let mut y = q;
        for x in y {
            y[2] = a;
            e += x;
        }
        e + y[2]
    });
    agrees!(|q, p, t, a| {
        let mut pair = (q[0], [a, 1.0]);
        pair.0 *= 2.0;
        pair.1[1] = pair.0;
        pair.1[0] + pair.1[1]
    });
    agrees!(|q, p, t, a| {
        let mut i = 0;
        let mut x = [0.0; 3];
        x[i] = {
            i = 2;
            q[1]
        };
        x[i] += {
            i = 1;
            a
        };
        x[1] - x[0] + x[2]
    });
    agrees!(|q, p, t, a| {
        let mut v = Vector3::new(q[0], q[1], q[2]);
        let w = v;
        v[0] = a;
        v.y *= 2.0;
        v += w * p[0];
        v -= w;
        v /= 3.0;
        v *= a;
        v.dot(&w) + v.z
    });
    agrees!(|q, p, t, a| {
        let mut v = [Vector3::new(q[0], q[1], q[2]); 2];
        v[1].x = 2.0;
        v[0] = v[1] * 2.0;
        v[0].norm_squared() - v[1].x
    });
    // Fourth-order Taylor coefficients of q' = a − q².
    agrees!(|q, p, t, a| {
        let mut c = [q[0], 0.0, 0.0, 0.0, 0.0];
        for n in 0..4 {
            let mut square = 0.0;
            for k in 0..=n {
                square += c[k] * c[n - k];
            }
            c[n + 1] = ((if n == 0 { a } else { 0.0 }) - square) / (n + 1) as f64;
        }
        c[4] + c[3]
    });
    refuses!("bind it with `let` first", |q, p, t, a| {
        let mut i = 0;
        let mut x = [0.0; 3];
        x[{
            i += 1;
            i
        }] = a;
        x[1]
    });
    refuses!("build the array from its elements first", |q, p, t, a| {
        let mut x = OUTSIDE;
        x[0] = a;
        x[0]
    });
}
