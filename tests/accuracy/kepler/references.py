"""Writes references.txt: Kepler orbits to 50 digits, by Kepler's equation in the eccentric anomaly (not the universal variables of the
runtime), for numbers that are exactly those of the file. Needs mpmath.

A line: e, h, q, v, the same at time h, and the condition: by how much, relative to its size, the end moves (the larger of q and v) for a
relative change of 1 of every number that is given, |q| and |v| as the units of their components. mu = 1.
"""
from mpmath import mp, mpf, sqrt, cos, sin, cosh, sinh, asinh, atan2, pi, matrix, norm, floor
import random

mp.dps = 120
random.seed(11)


def solve(f, slope, low, high):
    """The zero of an increasing function."""
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if f(middle) < 0 else (low, middle)
    x = (low + high) / 2
    for _ in range(12):
        x -= f(x) / slope(x)
    return x


def orbit(q, v, h):
    """The end by Gauss's f and g, with the change of the eccentric anomaly from Kepler's equation."""
    r, eta = sqrt(sum(x * x for x in q)), sum(a * b for a, b in zip(q, v))
    alpha = 2 / r - sum(x * x for x in v)
    if alpha > 0:
        a = 1 / alpha
        n = alpha ** mpf(1.5)
        c, s = 1 - r * alpha, eta * sqrt(alpha)  # e cos E, e sin E
        f = lambda d: d - c * sin(d) + s * (1 - cos(d)) - n * h
        slope = lambda d: 1 - c * cos(d) + s * sin(d)
        d = solve(f, slope, n * h - 4, n * h + 4)
        r1 = a * (1 - c * cos(d) + s * sin(d))
        F, G = 1 - a / r * (1 - cos(d)), h - (d - sin(d)) / n
        Ft, Gt = -sqrt(a) / (r * r1) * sin(d), 1 - a / r1 * (1 - cos(d))
    else:
        a = 1 / alpha
        n = (-alpha) ** mpf(1.5)
        c, s = 1 - r * alpha, eta * sqrt(-alpha)  # e cosh H, e sinh H
        f = lambda d: -d + c * sinh(d) + s * (cosh(d) - 1) - n * h
        slope = lambda d: -1 + c * cosh(d) + s * sinh(d)
        low, high = (mpf(0), mpf(1e-40)) if h > 0 else (mpf(-1e-40), mpf(0))
        while h > 0 and f(high) < 0: high *= 2
        while h < 0 and f(low) > 0: low *= 2
        # The bracket starts wide on a logarithmic scale.
        for _ in range(60):
            middle = (low + high) / 2
            low, high = (middle, high) if f(middle) < 0 else (low, middle)
        d = solve(f, slope, low, high)
        r1 = -a * (-1 + c * cosh(d) + s * sinh(d))
        F, G = 1 + a / r * (cosh(d) - 1), h - (sinh(d) - d) / n
        Ft, Gt = -sqrt(-a) / (r * r1) * sinh(d), 1 + a / r1 * (cosh(d) - 1)
    return [F * a_ + G * b for a_, b in zip(q, v)], [Ft * a_ + Gt * b for a_, b in zip(q, v)]


def size(x):
    return sqrt(sum(a * a for a in x))


def difference(a, b):
    return size([x - y for x, y in zip(a, b)])


def condition(q, v, h):
    small = mpf(10) ** -40
    end = orbit(q, v, h)
    total = [mpf(0), mpf(0)]
    changes = []
    for i in range(3):
        changes.append((q[:i] + [q[i] + small * size(q)] + q[i + 1:], v, h))
        changes.append((q, v[:i] + [v[i] + small * size(v)] + v[i + 1:], h))
    changes.append((q, v, h + small * h))
    for changed in changes:
        other = orbit(*changed)
        for k in (0, 1): total[k] += difference(other[k], end[k]) / small / size(end[k])
    return max(total)


def rotated(x, y):
    """A point of the plane of an orbit in space."""
    return [mpf('0.6') * x - mpf('0.64') * y, mpf('0.8') * x + mpf('0.48') * y, mpf('0.6') * y]


lines = []
for e in ("0", "0.05", "0.3", "0.7", "0.95", "0.999", "1", "1.001", "1.5", "5"):
    for h in ("0.01", "0.3", "1", "5", "40"):
        for sign in (1, -1):
            ecc = mpf(e)
            # The semi-latus rectum is that of a = 1, of a parabola 2 (pericentre 1); hyperbolas have |a| = 1.
            p = mpf(2) if ecc == 1 else abs(1 - ecc * ecc)
            if ecc < 1: nu = random.uniform(-3.1415, 3.1415)
            else: nu = random.uniform(-1.5, 1.5)
            r = p / (1 + ecc * cos(nu))
            q = rotated(r * cos(nu), r * sin(nu))
            v = rotated(-sin(nu) / sqrt(p), (ecc + cos(nu)) / sqrt(p))
            q, v = [mpf(float(x)) for x in q], [mpf(float(x)) for x in v]
            t = mpf(float(sign * mpf(h)))
            end = orbit(q, v, t)
            numbers = [float(x) for x in [*q, *v, *end[0], *end[1]]]
            lines.append(" ".join([e, repr(float(t)), *map(repr, numbers), f"{float(condition(q, v, t)):.3g}"]))
open("references.txt", "w").write("\n".join(lines) + "\n")
