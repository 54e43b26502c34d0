//! Assignments to elements and components.

use super::*;
use geoint_runtime::nalgebra::Vector3;

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
    // Taylor coefficients up to order 4 of q' = a − q².
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
