#!/usr/bin/env python3
"""Constants of asperity_law_quadrature_fixed_points: a generalised Gauss rule of 20 points for the
integrals over elasto-plastic summits, in x = ln(w/w1) on 0..ln 110. The integrands are powers
(w/w1)^p, those of force, slope, work and area for all yield factors, times the density of heights,
for all w1/sigma and d/sigma that the fixed rule serves. Their span has 35 dimensions to round-off,
so that 20 points and 20 weights suffice (Bremer, Gimbutas, Rokhlin 2010): from a rule of 35 points one
is left out at a time, the one that matters least, and the rest moved to where they integrate the whole
span. Prints Fortran arrays, in half a minute. Needs numpy and mpmath (for the powers)."""

import numpy as np
from mpmath import chebyfit, exp, mp, nstr
from numpy.polynomial import legendre

PANELS, ORDER, POINTS = 12, 24, 20
ROUND_OFF = 2e-16  # of the largest singular value: where the span ends
LENGTH = np.log(110.0)
nodes, weights = legendre.leggauss(ORDER)
half = LENGTH / PANELS / 2
fine_x = np.concatenate([(2 * i + 1 + nodes) * half for i in range(PANELS)])
fine_w = np.tile(weights * half, PANELS)


def parameters():
    """Of all integrands: power, a = w1/sigma, a d/sigma; a row each."""
    rows = []
    for a in np.concatenate([[1e-8], np.sqrt(np.geomspace(1e-6, 6.25e-4, 9))]):
        largest = min(0.28, 37 * a)
        low = [-7 * a, -5.25 * a, -3.5 * a, -1.75 * a, 0]
        for product in low + [largest * f for f in (0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1)]:
            powers = [np.log(2) / LENGTH, 1 + np.log(2) / LENGTH, 0]
            for k in (0.05, 0.1, 0.25, 0.4, 0.7, 1.0):
                b = np.log(2 / k) / LENGTH
                powers += [b, 1 + b, 2 + b]
            rows += [(p, a, product) for p in powers]
    return np.array(rows, dtype=np.longdouble).T[:, :, None]


power, a, product = parameters()


def logarithms(x):
    """Of all integrands at points, and their derivatives; (integrands, points)."""
    r = np.exp(x)
    return (power + 1) * x - r * (product + a * a * r / 2), power + 1 - r * (product + a * a * r)


on_grid = logarithms(fine_x)[0]
peak = on_grid.max(axis=1, keepdims=True)
integrands = np.exp(on_grid - peak).astype(float)
integrands /= (integrands @ fine_w)[:, None]
_, singular, directions = np.linalg.svd(integrands * np.sqrt(fine_w), full_matrices=False)


class Span:
    """An orthonormal basis of the integrands: on the fine grid, and by Legendre series a panel."""

    def __init__(self):
        self.rows = directions[singular > ROUND_OFF * singular[0]]
        basis = self.rows / np.sqrt(fine_w)
        self.wanted = basis @ fine_w
        to_series = ((2 * np.arange(ORDER) + 1) / 2)[:, None] * (legendre.legvander(nodes, ORDER - 1).T * weights)
        self.series = [to_series @ basis[:, p * ORDER : (p + 1) * ORDER].T for p in range(PANELS)]
        self.slopes = [legendre.legder(c, axis=0) for c in self.series]

    def evaluate(self, x):
        """The basis and its derivatives at points; (basis, points)."""
        values, derivatives = [], []
        for point in x:
            p = min(int(point / (2 * half)), PANELS - 1)
            t = (point - 2 * p * half) / half - 1
            values.append(legendre.legvander([t], ORDER - 1)[0] @ self.series[p])
            derivatives.append(legendre.legvander([t], ORDER - 2)[0] @ self.slopes[p] / half)
        return np.array(values).T, np.array(derivatives).T


def settle(span, x, w):
    """Move points and weights to where they integrate the basis (Levenberg-Marquardt)."""
    damping = 1e-6
    f, g = span.evaluate(x)
    residual = f @ w - span.wanted
    error = np.linalg.norm(residual)
    for _ in range(200):
        u, sv, vh = np.linalg.svd(np.hstack([f, g * w]), full_matrices=False)
        for _ in range(12):
            step = -(vh.T * (sv / (sv * sv + damping * damping))) @ (u.T @ residual)
            new_w, new_x = w + step[: len(x)], x + step[len(x) :]
            if new_x.min() > 0 and new_x.max() < LENGTH and np.diff(np.sort(new_x)).min() > 1e-4:
                f_new, g_new = span.evaluate(new_x)
                new_residual = f_new @ new_w - span.wanted
                if np.linalg.norm(new_residual) < error:
                    break
            damping = max(4 * damping, 1e-14)
        else:
            break
        x, w, f, g, residual = new_x, new_w, f_new, g_new, new_residual
        error = np.linalg.norm(residual)
        damping /= 8
        if error < 3e-15:
            break
    order = np.argsort(x)
    return x[order], w[order], error


def rule(span):
    """Start from as many points as the span has dimensions, chosen by elimination."""
    rest, chosen = span.rows.copy(), []
    for _ in range(len(rest)):
        size = (rest**2).sum(axis=0)
        chosen.append(int(size.argmax()))
        q = rest[:, chosen[-1]] / np.sqrt(size[chosen[-1]])
        rest -= np.outer(q, q @ rest)
    x = np.sort(fine_x[chosen])
    w = np.linalg.lstsq(span.evaluate(x)[0], span.wanted, rcond=None)[0]
    while len(x) > POINTS:
        f, _ = span.evaluate(x)
        candidates = np.argsort(w * w * (f * f).sum(axis=0))
        tried = []
        for j in candidates[: len(x) if len(x) < 26 else 6]:
            tried.append(settle(span, np.delete(x, j), np.delete(w, j)))
            if tried[-1][2] < 1e-13:
                break
        x, w, _ = min(tried, key=lambda t: t[2])
    return x, w


def exact_gauss():
    """Gauss-Legendre on -1..1 in extended precision: Newton on the Legendre polynomial."""
    x = nodes.astype(np.longdouble)
    for _ in range(3):
        before, p = np.ones_like(x), x
        for j in range(2, ORDER + 1):
            before, p = p, ((2 * j - 1) * x * p - (j - 1) * before) / j
        slope = ORDER * (x * p - before) / (x * x - 1)
        x = x - p / slope
    return x, 2 / ((1 - x * x) * slope**2)


def polish(x, w):
    """Least squares of the relative errors of all integrals, found in extended precision: first of
    points and weights, then of the weights of rounded points."""
    gauss_x, gauss_w = exact_gauss()
    long_half = np.log(np.longdouble(110)) / PANELS / 2
    grid = np.concatenate([(2 * i + 1 + gauss_x) * long_half for i in range(PANELS)])
    integrals = np.exp(logarithms(grid)[0] - peak) @ np.tile(gauss_w * long_half, PANELS)
    for step in range(6):
        value, slope = logarithms(x)
        value = np.exp(value - peak) / integrals[:, None]
        error = (1 - value @ w).astype(float)
        if step < 3:
            change = np.linalg.lstsq(np.hstack([value, value * slope * w]).astype(float), error, rcond=1e-11)[0]
            x, w = (x + change[POINTS:]).astype(float).astype(np.longdouble), w + change[:POINTS]
        else:
            w = w + np.linalg.lstsq(value.astype(float), error, rcond=1e-15)[0]
    return x, w, abs(error).max()


def show(name, words):
    print(f"   real(wp), parameter, public :: {name} = [ &")
    for i in range(0, len(words), 4):
        end = ", &" if i + 4 < len(words) else "]"
        print("      " + ", ".join(word + "_wp" for word in words[i : i + 4]) + end)


x, w, error = polish(*rule(Span()))
print(f"largest relative error {error:.1e}")
mp.dps = 40
show("log_ratio(n_points)", [nstr(mp.mpf(float(v)), 17) for v in x])
show("ratio(n_points)", [nstr(exp(mp.mpf(nstr(mp.mpf(float(v)), 17))), 17) for v in x])
show("weight(n_points)", [nstr(mp.mpf(float(v)), 17) for v in w])
# exp on -0.75..0.75
show("c(0:13)", [nstr(v, 20) for v in reversed(chebyfit(exp, [-0.75, 0.75], 14))])
