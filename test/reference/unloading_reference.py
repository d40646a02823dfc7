#!/usr/bin/env python3
"""Reference values of the law with memory in 25 digits, for test/data/unloading_law_reference.csv.

    python3 unloading_reference.py > OUTPUT.csv

It needs mpmath. Units are any consistent ones. Inputs are doubles: mpmath gets the double that
the text stands for, not the decimal, so rounding of inputs is no error of the law.

Method, chosen to share nothing with the library but the formulas: N(1 - u/e)^(3/2), and alike area,
stiffness and stored energy, times the Gaussian density over the largest deformation w, from force
and area of each stage; virgin work less stored energy at no retraction for the plastic dissipation.
By the double exponential rule in w itself, on intervals that grow tenfold from the lower end of each
stage. The step is halved, with more digits than at first, until every column agrees with the one
before to 1e-27 relative.
"""
import csv
import random
import sys

import mpmath as mp

INPUTS = "sigma eta modulus radius hardness yield_factor closest_separation retraction".split()
OUTPUTS = ("pressure stiffness area_fraction contact_density energy plastic_dissipation "
           "elastic_share elastoplastic_share plastic_share").split()
AGREEMENT = mp.mpf(10)**-27
rules = {}


def double_exponential(level):
    """Nodes and weights on 0..1: distance from the nearer end, whether that is the lower one."""
    if (level, mp.mp.prec) not in rules:
        step = mp.mpf(2)**-level
        rule = []
        for i in range(-4*2**level, 4*2**level + 1):
            t = i*step
            near = 1/(1 + mp.exp(mp.pi*mp.sinh(abs(t))))
            weight = step*mp.pi*mp.cosh(t)*near*(1 - near)
            if weight > mp.mpf(10)**-(mp.mp.dps + 5):
                rule.append((near, t < 0, weight))
        rules[level, mp.mp.prec] = rule
    return rules[level, mp.mp.prec]


def over_range(f, sigma, d, lower, upper, level):
    """Integrals of the list f(w, w - lower) times the density of w over lower..upper."""
    peak = min(max(-d, lower), upper)
    y = (d + peak)/sigma
    reach = sigma*160/(mp.sqrt(y*y + 160) + abs(y))
    total = None
    from_ = max(lower, peak - reach)
    top = min(upper, peak + reach)
    ends = [from_, top]
    length = (top - from_)/10
    while length > mp.mpf("1e-9")*(top - from_) and from_ + length > lower*mp.mpf("1.01"):
        ends.insert(1, from_ + length)
        length /= 10
    if peak > from_ and peak < top:
        ends = sorted(set(ends + [peak, (peak + top)/2, (from_ + 2*peak)/3]))
    for a, b in zip(ends, ends[1:]):
        for near, low, weight in double_exponential(level):
            w = a + (b - a)*near if low else b - (b - a)*near
            beyond = (a - lower) + (b - a)*near if low else (b - lower) - (b - a)*near
            factor = weight*(b - a)*mp.exp(-((d + w)/sigma)**2/2)
            values = [factor*v for v in f(w, beyond)]
            total = values if total is None else [s + v for s, v in zip(total, values)]
    return [v/(sigma*mp.sqrt(2*mp.pi)) for v in total]


def law(sigma, eta, modulus, radius, hardness, k, d, u, level, only_pressure=False,
        plastic_ratio=110):
    """All outputs at the working precision."""
    w1 = (3*mp.pi*k*hardness/(4*modulus))**2*radius
    w2 = plastic_ratio*w1
    b2 = 1 + mp.log(2)/mp.log(plastic_ratio)
    b3 = 1 + mp.log(2/k)/mp.log(plastic_ratio)
    c = b3 - b2/2
    n1 = mp.pi*k*hardness*radius*w1
    work_2 = n1*w1*(mp.mpf(2)/5 + (mp.mpf(plastic_ratio)**(b3 + 1) - 1)/(b3 + 1))
    # force, area, recovery and virgin work of one summit
    stages = [
        (mp.mpf(0), w1, u, lambda w: (n1*mp.sqrt(w/w1)*w/w1, mp.pi*radius*w, w,
                                      n1*w1*mp.mpf(2)/5*(w/w1)**2*mp.sqrt(w/w1))),
        (w1, w2, w1*(u/w1)**(1/c) if u else mp.mpf(0), lambda w: (
            n1*(w/w1)**b3, mp.pi*radius*w1*(w/w1)**b2, w1*(w/w1)**c,
            n1*w1*(mp.mpf(2)/5 + ((w/w1)**(b3 + 1) - 1)/(b3 + 1)))),
        (w2, mp.inf, (k*u)**2/(2*w1), lambda w: (
            2*mp.pi*radius*hardness*w, 2*mp.pi*radius*w, mp.sqrt(2*w1*w)/k,
            work_2 + mp.pi*radius*hardness*(w*w - w2*w2)))]
    totals = []
    edge = None
    for lower, upper, edge_here, summit in stages:
        lower_here = max(lower, edge_here)
        if lower_here >= upper:
            totals.append([mp.mpf(0)]*4)
            continue
        if edge is None:
            edge = lower_here

        def values(w, beyond):
            force, area, recovery, _ = summit(w)
            left = max(1 - u/recovery, mp.mpf(0))
            root = mp.sqrt(left)
            if only_pressure:
                return [force*left*root]
            return [force*left*root, 3*force/(2*recovery)*root, area*left,
                    2*force*recovery/5*left**2*root]
        totals.append(over_range(values, sigma, d, lower_here, upper, level))
    if only_pressure:
        return eta*sum(t[0] for t in totals if t)
    lost = mp.mpf(0)
    for lower, upper, _, summit in stages[1:]:
        def dissipated(w, beyond):
            force, _, recovery, work = summit(w)
            return [work - 2*force*recovery/5]
        lost += over_range(dissipated, sigma, d, lower, upper, level)[0]
    force, slope, area, energy = (sum(column) for column in zip(*totals))
    shares = [t[0]/force for t in totals]
    return [eta*force, eta*slope, eta*area,
            eta*mp.erfc((d + edge)/sigma/mp.sqrt(2))/2, eta*energy, eta*lost, *shares]


def verified(values, plastic_ratio=110):
    """Outputs, with the step halved until nothing changes."""
    previous = None
    for digits, level in (50, 4), (60, 5), (60, 6), (60, 7):
        with mp.workdps(digits):
            result = law(*map(mp.mpf, values), level, plastic_ratio=mp.mpf(plastic_ratio))
        if previous and all(abs(a - b) <= AGREEMENT*abs(b) for a, b in zip(previous, result)):
            return result
        previous = result
    sys.exit(f"not settled: {values}")


def pressure(values, plastic_ratio=110):
    with mp.workdps(30):
        return law(*map(mp.mpf, values), 3, True, mp.mpf(plastic_ratio))


def farthest(values, d, plastic_ratio=110):
    """Retraction at which the pressure is 1e-12 of that at the closest separation."""
    wanted = pressure([*values, d, 0.0], plastic_ratio)*mp.mpf(10)**-12
    near, far = 0.0, values[0]
    while pressure([*values, d, far], plastic_ratio) > wanted:
        near, far = far, 2*far
    for _ in range(12):
        middle = 0.5*(near + far)
        if pressure([*values, d, middle], plastic_ratio) > wanted:
            near = middle
        else:
            far = middle
    return near


def properties(ratio, yield_factor, stream):
    """Properties with w1/sigma = ratio and a plausible eta R sigma."""
    sigma, radius, hardness = (10**stream.uniform(*limits) for limits in ((-5, 1), (-3, 1), (0, 3)))
    sigma, radius, hardness = (float(f"{v:.4g}") for v in (sigma, radius, hardness))
    modulus = 0.75*float(mp.pi)*yield_factor*hardness*(radius/(ratio*sigma))**0.5
    eta = float(f"{10**stream.uniform(-1.5, 0.6)/(radius*sigma):.4g}")
    return [sigma, eta, modulus, radius, hardness, yield_factor]


def cases():
    stream = random.Random(1110)
    for i in range(130):
        ratio = 10**(stream.uniform(-6, 2) if i % 2 else stream.uniform(-4, 0))
        yield_factor = float(f"{stream.uniform(0.1907, 1):.4g}")
        values = properties(ratio, yield_factor, stream)
        d = float(f"{stream.uniform(-8, 8):.5g}")*values[0]
        part = stream.uniform(0, 1) if i % 3 else 10**stream.uniform(-8, 0)
        yield "random", values, d, part
    for h in -8.0, -2.0, 1.0, 8.0:
        for yield_factor in 0.1907, 1.0:
            for ratio in 1e-6, 1e-3, 0.02, 1.0, 1e2:
                values = properties(ratio, yield_factor, stream)
                for part in 0.0, 1e-6, 1.0:
                    yield "edge", values, h*values[0], part
    for ratio in 0.01, 0.1:  # summits about to lose contact are the last or the first of a stage
        values = properties(ratio, 0.4, stream)
        w1 = (0.75*float(mp.pi)*0.4*values[4]/values[2])**2*values[3]
        for recovery in 1.0, 220**0.5/0.4:
            for factor in 0.999, 1.001:
                yield "stage", values, 0.5*values[0], -recovery*factor*w1
    for ratio in 0.12, 0.16, 0.25:  # the density peaks among elasto-plastic summits
        values = properties(ratio, 0.4, stream)
        for part in 0.0, 0.5, 1.2:
            yield "peak", values, -8*values[0], -part*ratio*values[0]


def main():
    out = csv.writer(sys.stdout, lineterminator="\n")
    out.writerow(["kind", *INPUTS, *OUTPUTS])
    for kind, values, d, part in cases():
        retraction = -part
        if part > 0:
            retraction = part*farthest(values, d)
        row = [*values, d, abs(retraction)]
        result = verified(row)
        out.writerow([kind, *map(repr, row), *(mp.nstr(v, 25) if v > mp.mpf(2)**-1075 else "0.0"
                                               for v in result)])
        sys.stdout.flush()


if __name__ == "__main__":
    main()
