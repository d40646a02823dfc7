#!/usr/bin/env python3
"""Coefficients of asperity_law_gaussian_tail: the ratio F_2/F_1 of the tail's moments, to 35 digits.

With u = 1/(y + 4), (y + 4) F_2(y)/F_1(y) is approximated on each of 6 equal intervals of
0 <= u <= 1/4 by a polynomial of degree 12 in the local variable -1..1: interpolation at the
Chebyshev points, error below 3e-17. Prints the Fortran array. Needs mpmath.
"""

from mpmath import chebyt, cos, erfc, exp, matrix, lu_solve, mp, mpf, nstr, pi, sqrt

mp.dps = 35
SHIFT, INTERVALS, DEGREE = 4, 6, 12


def ratio(y):
    """F_2/F_1: closed forms with digits to spare, the continued fraction far out."""
    if y > 60:
        f = mpf(0)
        for k in range(400, 2, -1):
            f = k / (y + f)
        return 2 / (y + f)
    digits = mp.dps
    mp.dps = digits + 20 + int(y)
    f_0 = erfc(y / sqrt(mpf(2))) / 2
    f_1 = exp(-y * y / 2) / sqrt(2 * pi) - y * f_0
    value = (f_0 - y * f_1) / f_1
    mp.dps = digits
    return +value


def scaled(u):
    if u == 0:
        return mpf(2)
    y = 1 / u - SHIFT
    return ratio(y) * (y + SHIFT)


def coefficients(interval):
    n = DEGREE + 1
    points = [cos(pi * (2 * k + 1) / (2 * n)) for k in range(n)]
    rows = matrix(n, n)
    values = matrix(n, 1)
    for i, x in enumerate(points):
        values[i] = scaled((interval + (1 + x) / 2) / INTERVALS / SHIFT)
        for j in range(n):
            rows[i, j] = x**j
    return lu_solve(rows, values)


for interval in range(INTERVALS):
    solution = coefficients(interval)
    print(f"! interval {interval}")
    print(", ".join(nstr(solution[j], 20) + "_wp" for j in range(DEGREE + 1)))
    worst = max(
        abs(
            sum(solution[j] * x**j for j in range(DEGREE + 1))
            / scaled((interval + (1 + x) / 2) / INTERVALS / SHIFT)
            - 1
        )
        for x in (mpf(i) / 50 - 1 for i in range(101))
    )
    print(f"! error {nstr(worst, 2)}")
