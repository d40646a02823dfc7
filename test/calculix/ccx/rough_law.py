"""The paper's normal contact law by numerical quadrature, written from its equations alone.

Nothing of the library is used here: what CalculiX finds with UINTER is held against this. N-mm-MPa.
"""

import math

PI = math.pi


def gauss_legendre(count):
    """Nodes and weights on -1..1."""
    nodes, weights = [], []
    for i in range(count):
        x = math.cos(PI * (i + 0.75) / (count + 0.5))
        for _ in range(100):
            low, here = 0.0, 1.0
            for k in range(count):
                low, here = here, ((2 * k + 1) * x * here - k * low) / (k + 1)
            slope = count * (x * here - low) / (x * x - 1)
            step = here / slope
            x -= step
            if abs(step) < 1e-15:
                break
        nodes.append(x)
        weights.append(2 / ((1 - x * x) * slope * slope))
    return nodes, weights


RULE = gauss_legendre(60)


def integrate(function, low, high):
    """Integral; nodes crowd at the lower end, where the function may behave like a power."""
    total, root_low, root_high = 0.0, 0.0, math.sqrt(high - low)
    half, middle = (root_high - root_low) / 2, (root_high + root_low) / 2
    for x, weight in zip(*RULE):
        root = middle + half * x
        total += weight * function(low + root * root) * 2 * root
    return half * total


class RoughLaw:
    """A pair of faces: elasto-plastic summits of Gaussian height, and friction of elastic slip."""

    def __init__(self, eta=206.0, modulus=297.0, radius=0.1477, hardness=24.53, factor=0.4,
                 sigma=0.0593, mu=0.5, critical_slip=0.31):
        self.eta, self.modulus, self.radius, self.hardness = eta, modulus, radius, hardness
        self.factor, self.sigma, self.mu, self.critical_slip = factor, sigma, mu, critical_slip
        self.initial_separation = 4 * sigma
        self.first_yield = (3 * PI * factor * hardness / (4 * modulus))**2 * radius
        self.full_yield = 110 * self.first_yield

    def props(self):
        """PROPS of UINTER: rule `abaqus`, slip integrated exactly."""
        return [self.mu, self.critical_slip, self.eta, self.modulus, PI, self.radius,
                self.hardness, self.factor, self.sigma, self.initial_separation, 1.0, 1.0]

    def summit_force(self, deformation):
        """Force of one summit (Eqs 1 to 11)."""
        w, w1, w2 = deformation, self.first_yield, self.full_yield
        if w < w1:
            return 4 / 3 * self.modulus * math.sqrt(self.radius) * w**1.5
        if w < w2:
            force = PI * self.factor * self.hardness * self.radius * w1
            return force * (w / w1)**(1 + math.log(2 / self.factor) / math.log(110))
        return 2 * PI * self.radius * self.hardness * w

    def pressure(self, closure):
        """Pressure at an overclosure (eta times the mean force of a summit)."""
        separation, sigma = self.initial_separation - closure, self.sigma

        def integrand(w):
            t = (w + separation) / sigma
            return self.summit_force(w) * math.exp(-t * t / 2) / (math.sqrt(2 * PI) * sigma)

        # beyond 12 sigma below the highest density nothing is left
        end = max(-separation, 0.0) + 12 * sigma
        corners = [0.0] + [w for w in (self.first_yield, self.full_yield) if w < end] + [end]
        pieces = []
        for low, high in zip(corners, corners[1:]):
            parts = max(1, math.ceil((high - low) / (2 * sigma)))
            pieces += [(low + (high - low) * i / parts, low + (high - low) * (i + 1) / parts)
                       for i in range(parts)]
        return self.eta * math.fsum(integrate(integrand, low, high) for low, high in pieces)

    def closure(self, pressure):
        """Overclosure at a pressure, by bisection."""
        low, high = -4 * self.sigma, 8 * self.sigma
        while high - low > 1e-14:
            middle = (low + high) / 2
            low, high = (middle, high) if self.pressure(middle) < pressure else (low, middle)
        return (low + high) / 2

    def stick_slope(self, pressure):
        """Shear stress over elastic slip, MPa/mm."""
        return self.mu * pressure / self.critical_slip

    def table(self, pressure, band=2.0, rows=200):
        """Rows (pressure, overclosure) for a stock ccx: fine from pressure/band to pressure*band.

        A few rows lead there from zero pressure at zero overclosure, and some lead on.
        """
        low, high = self.closure(pressure / band), self.closure(pressure * band)
        fine = rows - 32
        closures = [low * i / 20 for i in range(1, 20)]
        closures += [low + (high - low) * i / (fine - 1) for i in range(fine)]
        closures += [high + 0.01 * i * self.sigma * 20 for i in range(1, 12)]
        return [(0.0, 0.0)] + [(self.pressure(closure), closure) for closure in closures]
