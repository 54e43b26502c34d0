//! Loops that reassign variables, and loops that end early.

use super::*;

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
fn rounds_and_loops_may_end_early() {
    agrees!(|q, p, t, a| {
        let mut e = 0.0;
        for i in 0..3 {
            for j in 0..3 {
                if i == j {
                    continue;
                }
                e += q[i] * p[j];
            }
        }
        e
    });
    agrees!(|q, p, t, a| {
        let mut e = a;
        for i in 0..3 {
            e *= q[i];
            if i == 1 {
                break;
            }
            e += p[i];
        }
        e
    });
    agrees!(|q, p, t, a| {
        let mut e = a;
        'rows: for i in 0..3 {
            for j in 0..3 {
                if i + j == 3 {
                    continue 'rows;
                }
                if i * j > 3 {
                    break 'rows;
                }
                e += q[i] * p[j];
            }
            e *= a;
        }
        e
    });
    agrees!(|q, p, t, a| {
        let mut e = a;
        for i in 0..3 {
            let x = if i == 1 { continue } else { q[i] };
            e -= {
                if i == 2 {
                    e += 1.0;
                    continue;
                }
                e += p[i];
                x
            };
        }
        e
    });
    agrees!(|q, p, t, a| {
        if q[0] > 0.0 {
            let mut e = a;
            for i in 0..3 {
                if i == 1 {
                    break;
                }
                e += q[i];
            }
            e
        } else {
            a
        }
    });
    agrees!(|q, p, t, a| {
        let row = |k: usize| {
            let mut e = 0.0;
            for i in 0..3 {
                if i == k {
                    continue;
                }
                e += q[i];
            }
            e
        };
        let mut e = 0.0;
        for k in 0..3 {
            e += row(k) * p[k];
        }
        e
    });
    refuses!("data cannot decide", |q, p, t, a| {
        let mut e = 0.0;
        for i in 0..3 {
            if q[i] > 0.0 {
                continue;
            }
            e += q[i];
        }
        e
    });
    refuses!("data cannot decide", |q, p, t, a| {
        let mut e = 0.0;
        for i in 0..3 {
            let x = if q[i] > 0.0 { p[i] } else { break };
            e += x;
        }
        e
    });
}

#[test]
fn iterators_that_fold() {
    // Horner's scheme as a fold.
    agrees!(|q, p, t, a| { [1.0, -2.0, 0.5, a].iter().rev().fold(0.0, |value, c| value * q[0] + c) });
    agrees!(|q, p, t, a| { (1..5).fold((1.0, a), |(x, y), n| (x * q[0] + y, y / n as f64)).0 });
    agrees!(|q, p, t, a| {
        q.iter().map(|x| 1.0 + x * x).product::<f64>() + (0..0).map(|i| q[i]).product::<f64>() * a
    });
    agrees!(|q, p, t, a| {
        (0..3).step_by(2).map(|i| q[i] * p[i]).sum::<f64>() + (0..3).rev().step_by(3).count() as f64
    });
    agrees!(|q, p, t, a| { (2..2).fold(a, |x, i| x * q[i]) });
}
