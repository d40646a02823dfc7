#!/usr/bin/env python3
"""Constants of asperity_law_quadrature_fixed_points: Gauss-Legendre points over the elastic range, even in
sqrt(w/w1) on 0..1, and over the elasto-plastic range, even in ln(w/w1) on 0..ln 110, to 35
digits. Prints Fortran arrays. Needs mpmath."""

from mpmath import cos, exp, log, mp, mpf, nstr, pi

mp.dps = 40


def gauss_legendre(n):
    """Points and weights on -1..1, ascending, by Newton on the Legendre polynomial."""
    rule = []
    for i in range(n):
        x = -cos(pi * (i + mpf(3) / 4) / (n + mpf(1) / 2))
        for _ in range(60):
            p, q = mpf(1), x
            for j in range(2, n + 1):
                p, q = q, ((2 * j - 1) * x * q - (j - 1) * p) / j
            slope = n * (x * q - p) / (x * x - 1)
            step = q / slope
            x -= step
            if abs(step) < mpf(10) ** -38:
                break
        rule.append((x, 2 / ((1 - x * x) * slope**2)))
    return rule


def show(name, values):
    print(f"   real(wp), parameter :: {name}({len(values)}) = [ &")
    words = [nstr(v, 20) + "_wp" for v in values]
    for i in range(0, len(words), 3):
        end = " &" if i + 3 < len(words) else "]"
        print("      " + ", ".join(words[i : i + 3]) + ("," if i + 3 < len(words) else "") + end)


elastic = gauss_legendre(8)
show("root_ratio", [(1 + x) / 2 for x, _ in elastic])
show("elastic_weight", [w / 2 for _, w in elastic])
length = log(mpf(110))
elastoplastic = gauss_legendre(28)
show("log_ratio", [length * (1 + x) / 2 for x, _ in elastoplastic])
show("elastoplastic_ratio", [exp(length * (1 + x) / 2) for x, _ in elastoplastic])
show("elastoplastic_weight", [length * w / 2 for _, w in elastoplastic])
