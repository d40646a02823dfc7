#!/usr/bin/env python3
"""Reference values of the law with heights by Johnson's distributions, for test/data/johnson_reference.csv.

    python3 johnson_reference.py > OUTPUT.csv

It needs mpmath. Inputs are doubles, as in normal_law_reference.py.

Method, chosen to share nothing with the library but the formulas: the distribution in Johnson's own
numbers gamma and delta, found from skewness and kurtosis in closed form (unbounded) or by the
trapezoidal rule (bounded), in 40 digits; then one summit's response times the density of heights
over the deformation w, by composite Gauss-Legendre quadrature in sqrt(w) and ln(w), or of bounded
heights over their Gaussian number by the double exponential rule, the panels doubled until every column agrees with the one before to 1e-17 relative, shares absolutely.
"""
import csv
import random
import sys

import mpmath as mp
from normal_law_reference import gauss_legendre
from unloading_reference import double_exponential, properties

INPUTS = "skewness kurtosis plastic_ratio sigma eta modulus radius hardness yield_factor separation".split()
OUTPUTS = ("pressure stiffness area_fraction contact_density energy elastic_share "
           "elastoplastic_share plastic_share").split()
SHAPES = ((0, 3.001), (0, 3.2), (0, 3.61), (0, 6), (0, 20), (0.5, 4.5), (-0.7, 4), (1, 6), (2, 12),
          (-1.5, 9), (0, 2.99), (0, 2.5), (0, 2), (0.5, 3), (-0.6, 2.8), (0.3, 2.9), (-0.5, 3.2),
          (1, 4))
AGREEMENT = mp.mpf(10)**-17
NODES = 40
mp.mp.dps = 40


def lognormal_kurtosis(skewness):
    w = mp.findroot(lambda w: (w + 2)**2*(w - 1) - skewness**2, 1 + skewness**2/10)
    return w**4 + 2*w**3 + 3*w**2 - 3


class Unbounded:
    """z = sinh((x - gamma)/delta), to mean 0 and variance 1."""

    def __init__(self, skewness, kurtosis):
        def shape(v, o):
            w = mp.exp(v)  # v = 1/delta^2, o = gamma/delta
            root = w*mp.cosh(2*o) + 1
            third = mp.sqrt(w*(w - 1)/2)*(w*(w + 2)*mp.sinh(3*o) + 3*mp.sinh(o))/root**1.5
            fourth = (w**2*(w**4 + 2*w**3 + 3*w**2 - 3)*mp.cosh(4*o)
                      + 4*w**2*(w + 2)*mp.cosh(2*o) + 3*(2*w + 1))/(2*root**2)
            return third, fourth

        skew = abs(skewness)
        if skew == 0:
            w = mp.sqrt(mp.sqrt(2*kurtosis - 2) - 1)
            v, o = mp.log(w), mp.mpf(0)
        else:
            v, o = path(lambda v, o: shape(v, o), skew, kurtosis, (mp.mpf("0.05"), mp.mpf("0.3")))
        w = mp.exp(v)
        self.sign = 1 if skewness >= 0 else -1
        self.delta, self.gamma = 1/mp.sqrt(v), -o/mp.sqrt(v)
        self.mean = mp.sqrt(w)*mp.sinh(o)
        self.sd = mp.sqrt((w - 1)*(w*mp.cosh(2*o) + 1)/2)

    def height(self, x):
        return self.sign*(mp.sinh((self.sign*x - self.gamma)/self.delta) - self.mean)/self.sd

    def score(self, z):
        return self.sign*(self.gamma + self.delta*mp.asinh(self.sign*z*self.sd + self.mean))

    def density(self, z):
        u = self.sign*z*self.sd + self.mean
        x = self.gamma + self.delta*mp.asinh(u)
        return mp.exp(-x*x/2)/mp.sqrt(2*mp.pi)*self.delta*self.sd/mp.sqrt(1 + u*u)

    bounds = (-mp.inf, mp.inf)


class Bounded:
    """z = 1/(1 + exp(-(x - gamma)/delta)), to mean 0 and variance 1."""

    def __init__(self, skewness, kurtosis):
        self.sign = 1 if skewness >= 0 else -1
        skew = abs(skewness)
        if skew == 0:
            v = mp.findroot(lambda v: self.moments(v, mp.mpf(0))[3] - kurtosis,
                            (mp.mpf("0.0001"), mp.mpf(9)), solver="anderson", tol=mp.mpf(10)**-60)
            o = mp.mpf(0)
        else:
            v, o = path(lambda v, o: self.moments(v, o)[2:], skew, kurtosis,
                        (mp.mpf("0.2"), mp.mpf("0.6")))
        self.delta, self.gamma = 1/mp.sqrt(v), -o/mp.sqrt(v)
        self.mean, self.sd = self.moments(v, o)[:2]
        ends = [(0 - self.mean)/self.sd, (1 - self.mean)/self.sd]
        self.bounds = (ends[0], ends[1]) if self.sign > 0 else (-ends[1], -ends[0])

    @staticmethod
    def moments(v, o):
        # o > 0 moves heights to the low side, for a skewness above zero
        s, step = mp.sqrt(v), mp.mpf(1)/16
        points = [(step*mp.exp(-(i*step)**2/2)/mp.sqrt(2*mp.pi), 1/(1 + mp.exp(-s*i*step + o)))
                  for i in range(-16*14, 16*14 + 1)]
        mean = sum(p*z for p, z in points)
        second, third, fourth = (sum(p*(z - mean)**n for p, z in points) for n in (2, 3, 4))
        return mean, mp.sqrt(second), third/second**1.5, fourth/second**2

    def height(self, x):
        u = 1/(1 + mp.exp(-(self.sign*x + self.gamma)/self.delta))
        return self.sign*(u - self.mean)/self.sd

    def step(self, x, beyond):
        with mp.extradps(40):
            return self.height(x + beyond) - self.height(x)

    def score(self, z):
        u = self.sign*z*self.sd + self.mean
        return self.sign*(-self.gamma + self.delta*mp.log(u/(1 - u)))


def path(shape, skew, kurtosis, start):
    """Newton from several starts."""
    for scale_v in 1, 3, mp.mpf(1)/3, 10, mp.mpf(1)/10:
        for scale_o in 1, 3, mp.mpf(1)/3, 6:
            try:
                v, o = mp.findroot(lambda v, o: (shape(v, o)[0] - skew, shape(v, o)[1] - kurtosis),
                                   (start[0]*scale_v, start[1]*scale_o), tol=mp.mpf(10)**-60,
                                   maxsteps=60)
            except (ValueError, ZeroDivisionError, OverflowError):
                continue
            if mp.im(v) == 0 and v > 0 and o > 0:
                return v, o
    sys.exit(f"no distribution of {skew}, {kurtosis}")


def over_numbers(functions, heights, sigma, d, lower, upper, level):
    """The same as `over_range` of bounded heights, whose density is all but zero at their ends: over
    their Gaussian numbers, by the double exponential rule."""
    low, high = heights.bounds
    if (d + lower)/sigma >= high:
        return [mp.mpf(0)]*len(functions)
    first = heights.score((d + lower)/sigma) if (d + lower)/sigma > low else mp.mpf(-16)
    first = max(first, mp.mpf(-16))
    last = max(first, 0) + 16
    if (d + upper)/sigma < high:
        if (d + upper)/sigma <= low:
            return [mp.mpf(0)]*len(functions)
        last = min(last, heights.score((d + upper)/sigma))
    totals = [mp.mpf(0)]*len(functions)
    if not last > first:
        return totals
    least = lower if (d + lower)/sigma > low and first > -16 else sigma*heights.height(first) - d
    ends, length = [first, last], mp.mpf(1)
    while ends[-2] + length < last:
        ends.insert(-1, ends[-2] + length)
    while length > (last - first)*mp.mpf(10)**-4:  # the powers of w near its least
        length /= 10
        if first + length < ends[1]:
            ends.insert(1, first + length)
    for a, b in zip(ends, ends[1:]):
        for near, is_low, weight in double_exponential(level):
            x = a + (b - a)*near if is_low else b - (b - a)*near
            beyond = (a - first) + (b - a)*near if is_low else (b - first) - (b - a)*near
            w = least + sigma*heights.step(first, beyond)
            factor = weight*(b - a)*mp.exp(-x*x/2)/mp.sqrt(2*mp.pi)
            totals = [total + factor*f(w) for total, f in zip(totals, functions)]
    return totals


def over_range(functions, heights, sigma, d, lower, upper, panels, logarithmic):
    """Integrals of f(w) times the density of w over lower..upper, for each f."""
    if isinstance(heights, Bounded):
        return over_numbers(functions, heights, sigma, d, lower, upper, int(mp.log(panels, 2)) + 1)
    to_w, to_x = (mp.exp, mp.log) if logarithmic else (lambda x: x*x, mp.sqrt)
    jacobian = mp.exp if logarithmic else (lambda x: 2*x)
    totals = [mp.mpf(0)]*len(functions)
    low = max(heights.bounds[0], heights.height(mp.mpf(-16)))
    top = heights.height(mp.sqrt(max(heights.score(d/sigma) if d/sigma > low else 0, 0)**2 + 200) + 6)
    lower, upper = max(lower, sigma*low - d), min(upper, sigma*top - d)
    if not upper > lower:
        return totals
    a, b = to_x(lower), to_x(upper)
    half = (b - a)/(2*panels)
    for panel in range(panels):
        middle = a + (2*panel + 1)*half
        for node, weight in gauss_legendre(NODES):
            x = middle + half*node
            w = to_w(x)
            factor = weight*half*jacobian(x)*heights.density((d + w)/sigma)/sigma
            totals = [total + factor*f(w) for total, f in zip(totals, functions)]
    return totals


def law(heights, plastic_ratio, sigma, eta, modulus, radius, hardness, k, d, panels):
    w1 = (3*mp.pi*k*hardness/(4*modulus))**2*radius
    w2 = plastic_ratio*w1
    n1 = mp.pi*k*hardness*radius*w1
    b2 = 1 + mp.log(2)/mp.log(plastic_ratio)
    b3 = 1 + mp.log(2/k)/mp.log(plastic_ratio)
    half = mp.mpf(1)/2
    elastic = [lambda w: n1*(w/w1)**(3*half), lambda w: 3*half*n1/w1*mp.sqrt(w/w1),
               lambda w: mp.pi*radius*w, lambda w: 2*w*n1*(w/w1)**(3*half)/5]
    middle = [lambda w: n1*(w/w1)**b3, lambda w: b3*n1/w1*(w/w1)**(b3 - 1),
              lambda w: mp.pi*radius*w1*(w/w1)**b2,
              lambda w: n1*w1*(mp.mpf(2)/5 + ((w/w1)**(b3 + 1) - 1)/(b3 + 1))]
    energy_2 = middle[3](w2)
    plastic = [lambda w: 2*mp.pi*radius*hardness*w, lambda w: 2*mp.pi*radius*hardness,
               lambda w: 2*mp.pi*radius*w, lambda w: energy_2 + mp.pi*radius*hardness*(w**2 - w2**2)]
    pieces = [over_range(elastic, heights, sigma, d, mp.mpf(0), w1, panels, False),
              over_range(middle, heights, sigma, d, w1, w2, panels, True),
              over_range(plastic, heights, sigma, d, w2, mp.inf, 2*panels, True)]
    force, slope, area, energy = (sum(column) for column in zip(*pieces))
    share = mp.mpf(1)
    if d/sigma > heights.bounds[0]:
        share = mp.erfc(heights.score(d/sigma)/mp.sqrt(2))/2
    return [eta*force, eta*slope, eta*area, eta*share, eta*energy,
            *(piece[0]/force for piece in pieces)]


def verified(heights, values):
    previous = None
    for panels in 4, 8, 16, 32, 64:
        result = law(heights, *map(mp.mpf, values), panels)
        scales = [*result[:5], 1, 1, 1]
        if previous and all(abs(a - b) <= AGREEMENT*c for a, b, c in zip(previous, result, scales)):
            return result
        previous = result
    sys.exit(f"not settled: {values}")


def main():
    out = csv.writer(sys.stdout, lineterminator="\n")
    out.writerow([*INPUTS, *OUTPUTS])
    stream = random.Random(361)
    for skewness, kurtosis in SHAPES:
        skew, kurt = mp.mpf(skewness), mp.mpf(kurtosis)
        kind = Unbounded if kurt > lognormal_kurtosis(abs(skew)) else Bounded
        heights = kind(skew, kurt)
        low, top = max(-6.0, float(heights.bounds[0]) - 1), min(8.0, float(heights.bounds[1]) - 0.02)
        for h in (-6.0, top, *(stream.uniform(low, top) for _ in range(8))):
            plastic_ratio = stream.choice((110.0, 110.0, 10.0, 1000.0))
            values = properties(10**stream.uniform(-6, 1), float(f"{stream.uniform(0.05, 1):.4g}"), stream)
            row = [plastic_ratio, *values, float(f"{h:.5g}")*values[0]]
            result = verified(heights, row)
            out.writerow([repr(float(skewness)), repr(float(kurtosis)), *map(repr, row),
                          *(mp.nstr(v, 22) for v in result)])
            sys.stdout.flush()


if __name__ == "__main__":
    main()
