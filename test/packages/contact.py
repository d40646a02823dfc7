"""Elastic contact of a map with a plane: tamaas' boundary elements against asperity's law.

The map is pressed without friction against an elastic half-space, periodic in both directions.
The separation is the mean gap, that of the mean planes of the two deformed faces: it is what a
finite-element model sees, whose faces move with the bulk. Heights and lengths in mm, E* in MPa.
"""

import math

import maps
import numpy as np
import surface_statistics
import tamaas
from surface_statistics import derivatives, summits
from table import check

# E*, MPa, of the paper's first pair; a hardness that nothing reaches
MODULUS, HARDNESS = 297.0, 1e9
# Hardness and yield factor of that pair
REAL_HARDNESS, YIELD_FACTOR = 24.53, 0.4
# Mean pressures, MPa: from a few contacts to a third of the area
LOADS = (0.01, 0.03, 0.1, 0.3, 1.0, 3.0)
# Real area up to which contacts do not grow together, so that they interact as point forces do
APART = 0.15
# The program's remark on interaction: area by the law, and its pressure over tamaas'
REMARK = ((0.06, 0.57), (0.1, 0.38))

# 1/r of a point force on a square cell, less its mean: the force on itself is felt as this/side
OWN_IMAGE = -3.900264920001956


class Plane:
    """tamaas' solver of one map; heights[j, i] with the same step both ways."""

    def __init__(self, heights, step, modulus, tolerance=1e-8):
        size = [heights.shape[1]*step, heights.shape[0]*step]
        model = tamaas.ModelFactory.createModel(tamaas.model_type.basic_2d, size,
                                                list(heights.shape[::-1]))
        model.E, model.nu = modulus, 0.0
        # model and map are kept: the solver only refers to them
        self.model, self.heights = model, np.ascontiguousarray(heights)
        self.solver = tamaas.PolonskyKeerRey(model, self.heights, tolerance)
        self.solver.max_iter = 3000

    def press(self, pressure):
        """(mean gap, share of points in contact) at a mean pressure."""
        self.solver.solve(pressure)
        return (float(np.mean(self.model["gap"])),
                float(np.mean(np.asarray(self.model.traction) > 0)))


class Summits:
    """The summits of a levelled map as independent Hertzian contacts, and as dependent ones."""

    def __init__(self, heights, step, modulus):
        top = summits(heights)
        _, _, z_xx, z_yy, z_xy = (d[top] for d in derivatives(heights, step, step))
        self.height = heights[top]
        self.mean_curvature = -(z_xx + z_yy)/2
        self.gauss_curvature = np.sqrt(np.maximum(z_xx*z_yy - z_xy**2, 1e-12))
        self.modulus = modulus
        self.area = (heights.shape[0] - 2)*(heights.shape[1] - 2)*step**2
        self.cell = heights.size*step**2
        self.influence = self.influences(top, step)

    def influences(self, top, step):
        """Displacement at each summit by a unit force at each, mean displacement zero."""
        n_y, n_x = top.shape
        q = 2*np.pi*np.hypot(np.fft.fftfreq(n_y)[:, None], np.fft.fftfreq(n_x)[None, :])/step
        q[0, 0] = np.inf
        kernel = np.fft.ifft2(2/(self.modulus*q)).real/step**2
        j, i = np.nonzero(top)
        found = kernel[(j[:, None] - j) % n_y, (i[:, None] - i) % n_x]
        np.fill_diagonal(found, OWN_IMAGE/(np.pi*self.modulus*np.sqrt(n_x*n_y)*step))
        return found

    def independent(self, separation, radius=None, hardness=HARDNESS):
        """Pressure by asperity's law: no summit knows of another. Each has its own radius, or all
        have the one given."""
        radius = 1/self.mean_curvature if radius is None else radius
        overlap = np.maximum(self.height - separation, 0)
        return np.sum(force(overlap, radius, self.modulus, hardness))/self.area

    def dependent(self, separation):
        """Pressure when each force displaces every summit, as far from a point force; summits are
        not round, and harder for it, as the curvature's geometric mean says."""
        overlap = self.height - separation
        factor = 4/3*self.modulus/np.sqrt(self.gauss_curvature)
        approach = np.maximum(overlap, 0)
        for _ in range(200):
            depth = np.maximum(approach, 0)
            slope = self.influence*(1.5*factor*np.sqrt(depth))
            change = np.linalg.solve(np.eye(len(depth)) + slope,
                                     overlap - approach - self.influence @ (factor*depth**1.5))
            approach = approach + change
            if abs(change).max() < 1e-12*abs(overlap).max():
                break
        return np.sum(factor*np.maximum(approach, 0)**1.5)/self.cell


def force(overlap, radius, modulus, hardness):
    """The paper's law of one summit: elastic, elasto-plastic from w1, plastic from 110 w1 on."""
    w1 = (3*np.pi*YIELD_FACTOR*hardness/(4*modulus))**2*radius
    plastic = np.pi*hardness*radius
    middle = YIELD_FACTOR*plastic*w1*(overlap/w1)**(1 + np.log(2/YIELD_FACTOR)/np.log(110))
    return np.where(overlap < w1, 4/3*modulus*np.sqrt(radius)*overlap**1.5,
                    np.where(overlap < 110*w1, middle, 2*plastic*overlap))


def gaussian(separation, density, radius, sigma, hardness=HARDNESS):
    """Pressure by the same law and Gaussian heights: the trapezoidal rule, in the square root of
    the overlap, where the integrand has no corner but those of the law."""
    root = np.linspace(0, np.sqrt(12*sigma + max(-separation, 0)), 400001)
    z = (separation + root**2)/sigma
    height = np.exp(-z**2/2)/(np.sqrt(2*np.pi)*sigma)
    value = force(root**2, radius, MODULUS, hardness)*height*2*root
    return density*np.sum((value[1:] + value[:-1])/2)*(root[1] - root[0])


def touching_area(separation, density, radius, sigma):
    """Share of the area that touches by the elastic law and Gaussian heights, in closed form."""
    h = separation/sigma
    return math.pi*density*radius*sigma*(math.exp(-h*h/2)/math.sqrt(2*math.pi)
                                         - h*math.erfc(h/math.sqrt(2))/2)


def paraboloid(points, step, radius, modulus, pressure):
    """(mean gap by tamaas, by Hertz and the displacement of its images, approach) of one
    paraboloid in a periodic cell."""
    x = (np.arange(points) - points//2)*step
    z = -(x[None, :]**2 + x[:, None]**2)/(2*radius)
    gap, _ = Plane(z - z.mean(), step, modulus, 1e-9).press(pressure)
    force = pressure*(points*step)**2
    approach = (force/(4/3*modulus*np.sqrt(radius)))**(2/3)
    own = OWN_IMAGE*force/(np.pi*modulus*points*step)
    return gap, -z.mean() - approach - own, approach


def compare_contact(program, table):
    """The same map pressed elastically by both, and the sum over its summits a second time."""
    gap, expected, approach = paraboloid(256, 2e-3, 0.5, MODULUS, 0.03)
    check("contact: mean gap of one paraboloid is that of Hertz",
          abs(gap - expected) < 1e-3*approach,
          f"{abs(gap - expected)/approach:.1e} of the approach off")
    m = maps.Map("contact", "", maps.gaussian(512, 512, 16, 16, seed=21), 2.0, 2.0, True,
                 maps.write_sdf_binary, "sdf")
    path = program.write(m)
    heights = surface_statistics.level(m.heights*1e-3, 2e-3, 2e-3)
    plane, found = Plane(heights, 2e-3, MODULUS), Summits(heights, 2e-3, MODULUS)
    values = program.values(path)
    pressed = [(load, *plane.press(load)) for load in LOADS]
    separations = [d - values["summit_plane"] for _, d, _ in pressed]
    law = {hardness: program.run(
        path, "--verify", "--route", "nayak", "--modulus", str(MODULUS), "--hardness",
        str(hardness), "--yield-factor", str(YIELD_FACTOR), "--separation",
        ",".join(map(repr, separations)))["law"] for hardness in (HARDNESS, REAL_HARDNESS)}
    for hardness, curves in law.items():
        compare_law(f"contact, hardness {hardness:g} MPa", values, found, curves, hardness)
    law = law[HARDNESS]
    share_before = 2.0
    for i, (load, d, area) in enumerate(pressed):
        where = f"contact at {load} MPa"
        own, mean = law["pressure_own_radii"][i], law["pressure_summits"][i]
        check(f"{where}: the sum is below tamaas, the more the higher the load",
              own/load < min(share_before, 1), f"{own/load:.3f} of it")
        share_before = own/load
        dependent = found.dependent(d)/load
        if area < APART:
            check(f"{where}: most of the rest is interaction and roundness",
                  abs(dependent - 1) < 0.2, f"{dependent:.3f} of tamaas with both")
        own_area = touching_area(separations[i], *(values[name] for name in (
            "eta_nayak", "radius_nayak", "sigma_nayak")))
        table.contact.append((load, d/values["sq"], area, own_area, law["pressure_nayak"][i]/load,
                              law["pressure_paper"][i]/load, mean/load, own/load, dependent))
    light = [row for row in table.contact if row[2] < 0.02]
    check("contact: own radii within a quarter while less than 2 % of the area touches",
          len(light) >= 3 and all(0.75 < row[7] <= 1 for row in light))
    check("contact: the Gaussian integral within a fifth there",
          all(0.8 < row[4] < 1.2 for row in light))
    for row, (own_area, share) in zip(table.contact[-2:], REMARK):
        check(f"contact at {row[0]} MPa: the remark on interaction says what was measured",
              abs(row[3] - own_area) < 0.005 and abs(row[4] - share) < 0.01,
              f"area {row[3]:.3f}, pressure {row[4]:.3f} of it")


def compare_law(where, values, found, law, hardness):
    """Gaussian integrals by both routes and sums over summits, each a second time."""
    one = values["radius_nayak"]
    for name, second in (
            ("pressure_own_radii", lambda d, gap: found.independent(gap, None, hardness)),
            ("pressure_summits", lambda d, gap: found.independent(gap, one, hardness)),
            ("pressure_nayak", lambda d, gap: gaussian(d, values["eta_nayak"], one,
                                                       values["sigma_nayak"], hardness)),
            ("pressure_paper", lambda d, gap: gaussian(d, values["eta_paper"],
                                                       values["radius_paper"],
                                                       values["sigma_paper"], hardness))):
        off = max(abs(law[name][i]/second(d, d + values["summit_plane"]) - 1)
                  for i, d in enumerate(law["separation"]))
        check(f"{where}: {name} a second time", off < 1e-8, f"{off:.1e} off (at most 1e-8)")
