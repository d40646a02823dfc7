#!/usr/bin/env python3
"""Reference values of the normal law in 30 digits, for test/data/normal_law_reference.csv.

    python3 normal_law_reference.py INPUT.csv > OUTPUT.csv     recompute the rows of INPUT.csv
    python3 normal_law_reference.py > OUTPUT.csv               make the sweep, share and edge rows

It needs mpmath. Units are any consistent ones. Inputs are doubles: mpmath gets the double that
the text stands for, not the decimal, so rounding of inputs is no error of the law.

Method, chosen to share nothing with the library but the formulas: the integrals of one summit's
response times the Gaussian density (Eqs 24-26) over the elastic and the elasto-plastic range by
composite Gauss-Legendre quadrature in sqrt(w) and ln(w), cut where the density has fallen to
exp(-110) of its largest value on the range; the plastic range from erfc with guard digits for the
cancellation. The panels are doubled, with 15 more digits than at first, until every column agrees
with the one before to 1e-32 relative.
"""
import csv
import random
import sys

import mpmath as mp

INPUTS = "sigma eta modulus radius hardness yield_factor".split()
OUTPUTS = ("pressure stiffness area_fraction contact_density energy elastic_share "
           "elastoplastic_share plastic_share w1 w2").split()
AGREEMENT = mp.mpf(10)**-32
SMALLEST = mp.mpf(2)**-1075  # a double below it is zero, and is written so
NODES = 40
rules = {}


def gauss_legendre(n):
    """Nodes and weights on [-1, 1], by Newton on the Legendre polynomial."""
    if (n, mp.mp.prec) not in rules:
        rule = []
        for i in range(n):
            x = mp.cos(mp.pi*(i + mp.mpf(3)/4)/(n + mp.mpf(1)/2))
            while True:
                p, q = mp.mpf(1), x
                for j in range(2, n + 1):
                    p, q = q, ((2*j - 1)*x*q - (j - 1)*p)/j
                slope = n*(x*q - p)/(x*x - 1)
                x -= q/slope
                if abs(q/slope) < mp.mpf(10)**(-mp.mp.dps + 5):
                    break
            rule.append((x, 2/((1 - x*x)*slope*slope)))
        rules[n, mp.mp.prec] = rule
    return rules[n, mp.mp.prec]


def over_range(functions, sigma, d, lower, upper, panels, logarithmic):
    """Integrals of f(w) times the density of w over lower..upper, for each f."""
    to_w, to_x = (mp.exp, mp.log) if logarithmic else (lambda x: x*x, mp.sqrt)
    jacobian = mp.exp if logarithmic else (lambda x: 2*x)
    peak = min(max(-d, lower), upper)
    y = (d + peak)/sigma
    reach = sigma*220/(mp.sqrt(y*y + 220) + abs(y))
    a, b = to_x(max(lower, peak - reach)), to_x(min(upper, peak + reach))
    half = (b - a)/(2*panels)
    totals = [mp.mpf(0)]*len(functions)
    for panel in range(panels):
        middle = a + (2*panel + 1)*half
        for node, weight in gauss_legendre(NODES):
            x = middle + half*node
            w = to_w(x)
            factor = weight*half*jacobian(x)*density((d + w)/sigma)/sigma
            totals = [total + factor*f(w) for total, f in zip(totals, functions)]
    return totals


def density(y):
    return mp.exp(-y*y/2)/mp.sqrt(2*mp.pi)


def normal_law(sigma, eta, modulus, radius, hardness, yield_factor, d, panels, plastic_ratio=110):
    """All outputs at the working precision."""
    k = yield_factor
    w1 = (3*mp.pi*k*hardness/(4*modulus))**2*radius
    w2 = plastic_ratio*w1
    n1 = mp.pi*k*hardness*radius*w1
    b2 = 1 + mp.log(2)/mp.log(plastic_ratio)
    b3 = 1 + mp.log(2/k)/mp.log(plastic_ratio)
    half = mp.mpf(1)/2
    # force, its slope, area and energy of one summit
    elastic = [lambda w: n1*(w/w1)**(3*half), lambda w: 3*half*n1/w1*mp.sqrt(w/w1),
               lambda w: mp.pi*radius*w, lambda w: 2*w*n1*(w/w1)**(3*half)/5]
    middle = [lambda w: n1*(w/w1)**b3, lambda w: b3*n1/w1*(w/w1)**(b3 - 1),
              lambda w: mp.pi*radius*w1*(w/w1)**b2,
              lambda w: n1*w1*(mp.mpf(2)/5 + ((w/w1)**(b3 + 1) - 1)/(b3 + 1))]
    energy_2 = middle[3](w2)
    with mp.extradps(25):  # the moments cancel by up to (d/sigma)^4 each
        y = (d + w2)/sigma
        q0 = mp.erfc(y/mp.sqrt(2))/2
        q1 = density(y) - y*q0
        q2 = q0 - y*q1
        plastic = [2*mp.pi*radius*hardness*(sigma*q1 + w2*q0), 2*mp.pi*radius*hardness*q0,
                   2*mp.pi*radius*(sigma*q1 + w2*q0),
                   energy_2*q0 + mp.pi*radius*hardness*(sigma**2*q2 + 2*w2*sigma*q1)]
    pieces = [over_range(elastic, sigma, d, mp.mpf(0), w1, panels, False),
              over_range(middle, sigma, d, w1, w2, panels, True), plastic]
    force, slope, area, energy = (sum(column) for column in zip(*pieces))
    shares = [piece[0]/force for piece in pieces]
    return [eta*force, eta*slope, eta*area, eta*mp.erfc(d/sigma/mp.sqrt(2))/2, eta*energy,
            *shares, w1, w2]


def verified(values, plastic_ratio=110):
    """Outputs, with the panels doubled until nothing changes."""
    previous = None
    for digits, panels in (45, 6), (60, 12), (60, 24), (60, 48):
        with mp.workdps(digits):
            result = normal_law(*map(mp.mpf, values), panels, mp.mpf(plastic_ratio))
        with mp.workdps(60):
            if previous and all(abs(a - b) <= AGREEMENT*b for a, b in zip(previous, result)):
                return result
        previous = result
    sys.exit(f"not settled: {values}")


def row_with(kind, ratio, yield_factor, h, stream):
    """A row with w1/sigma = ratio and a plausible eta R sigma."""
    sigma, radius, hardness = (10**stream.uniform(*limits) for limits in ((-5, 1), (-3, 1), (0, 3)))
    sigma, radius, hardness = (float(f"{v:.4g}") for v in (sigma, radius, hardness))
    modulus = 0.75*float(mp.pi)*yield_factor*hardness*(radius/(ratio*sigma))**0.5
    eta = float(f"{10**stream.uniform(-1.5, 0.6)/(radius*sigma):.4g}")
    return dict(kind=kind, sigma=sigma, eta=eta, modulus=modulus, radius=radius,
                hardness=hardness, yield_factor=yield_factor, h=h, separation=h*sigma)


def sweep():
    stream = random.Random(110)
    for i in range(240):
        ratio = 10**stream.uniform(-8, 3)
        h = stream.uniform(-40, 37) if i % 2 else stream.uniform(-6, 6)
        yield_factor = float(f"{stream.uniform(0.05, 1):.4g}")
        yield row_with("sweep", ratio, yield_factor, float(f"{h:.5g}"), stream)
    for i in range(60):  # stages that carry 1e-306 to 1e-240 of the pressure
        h = float(f"{stream.uniform(-40, 37):.5g}")
        top = (max(h, 0)**2 + 2*stream.uniform(550, 703))**0.5
        ratio = (top - h)/(110 if i % 2 else 1)
        yield row_with("share", ratio, float(f"{stream.uniform(0.05, 1):.4g}"), h, stream)
    for h in -40.0, -2.0, 0.0, 2.0, 37.0:
        for yield_factor in 0.05, 1.0:
            for ratio in 1e-8, 1.0, 1e3:
                yield row_with("edge", ratio, yield_factor, h, stream)


def given(path):
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            row["yield_factor"] = row.get("yield_factor") or row["k"]
            yield dict(row, **{name: float(row[name]) for name in [*INPUTS, "h", "separation"]})


def main():
    out = csv.writer(sys.stdout, lineterminator="\n")
    out.writerow(["kind", *INPUTS, "h", "separation", *OUTPUTS])
    for row in given(sys.argv[1]) if len(sys.argv) > 1 else sweep():
        values = verified([row[name] for name in [*INPUTS, "separation"]])
        out.writerow([row["kind"], *(repr(row[name]) for name in [*INPUTS, "h", "separation"]),
                      *(mp.nstr(v, 30) if v > SMALLEST else "0.0" for v in values)])


if __name__ == "__main__":
    main()
