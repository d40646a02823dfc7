"""The law at random properties, beside quadrature of the paper's three stages and of what is given
back, and contact points beside what follows from the law. The seed is in the name of each test."""

import secrets

import asperity
import numpy as np
import pytest

SEEDS = [secrets.randbelow(2**31) for _ in range(5)]
NODES, WEIGHTS = np.polynomial.legendre.leggauss(24)


def properties(seed, **changes):
    random = np.random.default_rng(seed)
    limits = {"eta": (50.0, 500.0), "modulus": (100.0, 800.0), "radius": (0.05, 0.3),
              "hardness": (10.0, 60.0), "yield_factor": (0.45, 0.9), "sigma": (0.01, 0.1),
              "plastic_ratio": (25.0, 300.0), "friction_coefficient": (0.2, 0.8),
              "critical_slip": (0.05, 0.4)}
    values = {name: float(random.uniform(*ends)) for name, ends in limits.items()}
    return asperity.Properties(**values, accept_unphysical=True, **changes), random


class Summit:
    """Force, area and energy of one summit (docs/law.md), and of one that was pressed to w and has
    parted by u since (docs/unloading.md)."""

    def __init__(self, p):
        self.modulus, self.radius, self.hardness = p.modulus, p.radius, p.hardness
        self.w1 = (3.0*np.pi*p.yield_factor*p.hardness/(4.0*p.modulus))**2*p.radius
        self.w2 = p.plastic_ratio*self.w1
        self.b3 = 1.0 + np.log(2.0/p.yield_factor)/np.log(p.plastic_ratio)
        self.b2 = 1.0 + np.log(2.0)/np.log(p.plastic_ratio)
        self.n1 = 4.0/3.0*p.modulus*p.radius**0.5*self.w1**1.5

    def of_stage(self, w, elastic, elastoplastic, plastic):
        return np.where(w < self.w1, elastic, np.where(w < self.w2, elastoplastic, plastic))

    def force(self, w):
        return self.of_stage(w, 4.0/3.0*self.modulus*self.radius**0.5*w**1.5, self.n1*(w/self.w1)**self.b3,
                             2.0*np.pi*self.radius*self.hardness*w)

    def slope(self, w):
        return self.of_stage(w, 2.0*self.modulus*self.radius**0.5*w**0.5,
                             self.b3*self.n1*(w/self.w1)**self.b3/w, 2.0*np.pi*self.radius*self.hardness)

    def area(self, w):
        return self.of_stage(w, np.pi*self.radius*w, np.pi*self.radius*self.w1*(w/self.w1)**self.b2,
                             2.0*np.pi*self.radius*w)

    def energy(self, w):
        first = 0.4*self.n1*self.w1

        def second(x):
            return self.n1*self.w1*(x**(self.b3 + 1.0) - 1.0)/(self.b3 + 1.0)

        return self.of_stage(w, 0.4*self.force(w)*w, first + second(w/self.w1),
                             first + second(self.w2/self.w1)
                             + np.pi*self.radius*self.hardness*(w**2 - self.w2**2))

    def recovery(self, w):
        return 0.75*self.force(w)/(self.modulus*np.sqrt(self.area(w)/np.pi))

    def parted(self, w, u):
        """Force and energy."""
        left = np.maximum(self.recovery(w) - u, 0.0)
        flat = (4.0*self.modulus*(self.area(w)/np.pi)**1.5/(3.0*self.force(w)))**0.5
        return 4.0/3.0*self.modulus*flat*left**1.5, 8.0/15.0*self.modulus*flat*left**2.5


def over_heights(p, summit, d, function, first=0.0):
    """eta times the integral of a function of the deformation, from `first` on, over Gaussian heights."""
    last = max(12.0*p.sigma - d, 0.0)
    ends = [first, *(w for w in (summit.w1, summit.w2) if first < w < last), last]
    total = 0.0
    for start, end in zip(ends[:-1], ends[1:], strict=True):
        panels = np.linspace(0.0, 1.0, 41)
        t = 0.5*((panels[1:] + panels[:-1])[:, None] + np.diff(panels)[:, None]*NODES)
        # t squared, for the roots where contact begins
        w = start + (end - start)*t**2
        density = np.exp(-0.5*((d + w)/p.sigma)**2)/(p.sigma*np.sqrt(2.0*np.pi))
        total += (function(w)*density*2.0*(end - start)*t*0.5*np.diff(panels)[:, None]*WEIGHTS).sum()
    return p.eta*total


@pytest.mark.parametrize("compiled", [False, True])
@pytest.mark.parametrize("seed", SEEDS)
def test_law(seed, compiled):
    p, random = properties(seed, compiled=compiled)
    d, summit = p.sigma*random.uniform(0.0, 4.5, 12), Summit(p)
    values = asperity.Law(p).evaluate(d)
    for name, function in (("pressure", summit.force), ("stiffness", summit.slope),
                           ("area_fraction", summit.area), ("energy", summit.energy),
                           ("contact_density", np.ones_like)):
        np.testing.assert_allclose(getattr(values, name), [over_heights(p, summit, x, function) for x in d],
                                   rtol=1e-9 if compiled else 1e-11, err_msg=name)


@pytest.mark.parametrize("compiled", [False, True])
@pytest.mark.parametrize("seed", SEEDS)
def test_unloading(seed, compiled):
    p, random = properties(seed, unloading="elastic", compiled=compiled)
    summit, law = Summit(p), asperity.Law(p)
    d = p.sigma*random.uniform(0.5, 3.5, 6)
    # as deep as half of what a typical summit gives back
    u = random.uniform(0.05, 0.5, 6)*summit.recovery(0.3*p.sigma)
    values = law.evaluate_unloading(d, u)
    for i in range(d.size):
        # the summit that just loses contact
        low, high = 0.0, 12.0*p.sigma
        for _ in range(200):
            middle = 0.5*(low + high)
            low, high = (middle, high) if summit.recovery(middle) < u[i] else (low, middle)
        force, energy = (over_heights(p, summit, d[i], lambda w, k=k: summit.parted(w, u[i])[k], high)
                         for k in (0, 1))
        assert values.pressure[i] == pytest.approx(force, rel=1e-8)
        assert values.energy[i] == pytest.approx(energy, rel=1e-8)


@pytest.mark.parametrize("seed", SEEDS)
def test_friction(seed):
    """Along one straight path: mu p gamma/gcrit up to gcrit, then mu p, with the pressures of the
    quadrature at the overclosures."""
    p, random = properties(seed)
    closure, angle = p.sigma*random.uniform(0.5, 3.0), random.uniform(0.0, 2.0*np.pi)
    pressure = over_heights(p, Summit(p), 4.0*p.sigma - closure, Summit(p).force)
    contact, slid = asperity.Contact(asperity.Law(p), 1), 0.0
    for step in random.uniform(0.1, 0.5, 6)*p.critical_slip:
        slid += step
        response = contact.update(closure, [step*np.cos(angle), step*np.sin(angle)])
        shear = p.friction_coefficient*pressure*min(slid/p.critical_slip, 1.0)
        assert response.traction[:, 0] == pytest.approx(
            [pressure, shear*np.cos(angle), shear*np.sin(angle)], rel=1e-10, abs=1e-12*pressure)


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("changes", [
    {}, {"static_friction_coefficient": 1.0, "decay_slip": 0.5, "decay_slip_rate": 2.0},
    {"friction_coefficient_across": 0.3, "grain_angle": 20.0, "slip_direction": "stress"},
    {"unloading": "elastic", "compiled": True, "static_friction_coefficient": 1.0, "decay_slip": 0.5},
    {"stick": "summits", "shear_modulus": 80.0}, {"height_distribution": "johnson", "skewness": -0.3,
     "kurtosis": 3.4, "friction_pressures": (0.5, 2.0, 8.0), "friction_factors": (1.2, 1.0, 0.6)}],
    ids=["plain", "decay", "grain", "memory", "summits", "johnson"])
def test_tangent_with_turns(seed, changes):
    """Differences of the tractions, where slip directions turn and friction decays."""
    p, random = properties(seed, **changes)
    law, points, checked = asperity.Law(p), 30, 0
    contact = asperity.Contact(law, points)
    for _ in range(6):
        start, turn = contact.copy(), random.uniform(-0.5, 0.5, points)
        rotation = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
        motion = np.vstack([p.sigma*random.uniform(0.5, 3.0, points),
                            p.critical_slip*random.uniform(-0.6, 0.6, (2, points))])
        response = contact.update(motion[0], motion[1:], rotation, time_increment=0.1)
        status = contact.states["status"]
        for column, h in enumerate([1e-6*p.sigma, *2*[1e-6*p.critical_slip]]):
            ends = []
            for sign in 1.0, -1.0:
                moved, trial = motion.copy(), start.copy()
                moved[column] += sign*h
                ends.append((trial.update(moved[0], moved[1:], rotation, 0.1).traction,
                             trial.states["status"]))
            difference = (ends[0][0] - ends[1][0])/(2.0*h)
            same = (ends[0][1] == status) & (ends[1][1] == status)
            size = np.abs(response.tangent[:, column]).max(axis=0)
            error = np.abs(difference - response.tangent[:, column]).max(axis=0)
            assert (error/(size + 1e-3*size.max()))[same].max() < 1e-5, column
            checked += same.sum()
    assert checked > 400


def test_turned_frame(law):
    """Slip directions that turn by 90 degrees, and the same motion in turned words."""
    quarter = np.array([[0.0, -1.0], [1.0, 0.0]])
    one, other = asperity.Contact(law, 4), asperity.Contact(law, 4)
    slip = np.array([0.1, 0.05])
    for contact in one, other:
        contact.update(0.1, slip)
    found = one.update(0.11, quarter @ slip, quarter).traction
    expected = other.update(0.11, slip).traction
    np.testing.assert_allclose(found[1:], quarter @ expected[1:], atol=1e-15)
    np.testing.assert_allclose(found[0], expected[0], rtol=1e-15)
