"""What surfalize, SurfaceTopography and tamaas say of a map: {quantity: value}, in mm."""

import warnings

import numpy as np
import SurfaceTopography
import tamaas
from maps import topography
from surfalize import Surface
from SurfaceTopography.Uniform.Derivative import DiscreteDerivative

tamaas.set_log_level(tamaas.LogLevel.error)
warnings.filterwarnings("ignore", message=".*different pixel size.*")
UM = 1e-3  # mm
IN_UM = {"m": 1e6, "mm": 1e3, "µm": 1.0, "nm": 1e-3}


def read_by_surfalize(path):
    """(heights[j, i], step_x, step_y) in um."""
    surface = Surface.load(path)
    return surface.data, surface.step_x, surface.step_y


def read_by_surfacetopography(path):
    """The same by SurfaceTopography, which leaves out the unit of columns x y z: um here."""
    read = SurfaceTopography.read_topography(path)
    um = IN_UM[read.unit or "µm"]
    heights = np.ma.filled(np.ma.asarray(read.heights(), dtype=float), np.nan)
    return heights.T*um, *(step*um for step in read.pixel_size)


def by_surfalize(m, degree=1):
    """Parameters by surfalize, of a map without missing points."""
    surface = Surface(m.heights, m.step_x, m.step_y).detrend_polynomial(degree)
    found = {name.lower(): value for name, value in surface.height_parameters().items()}
    for name in ("sa", "sq", "sz", "sp", "sv"):
        found[name] *= UM
    found["sdq"] = surface.Sdq()
    for words, exclude in (("", True), (" with the border's hills", False)):
        found["spd" + words] = surface.Spd(exclude_edge=exclude)/UM**2
        found["spc" + words] = surface.Spc(exclude_edge=exclude)/UM
    # extrema[:, 0], [:, 1]: row and column of every peak left by Wolf pruning
    extrema = surface.get_feature_parameters()._segment(True, 5.0, False).extrema
    size = surface.data.shape
    inside = ((extrema > 0) & (extrema < np.array(size) - 1)).all(axis=1)
    found["peaks inside"] = inside.sum()/((size[0] - 2)*(size[1] - 2)*m.step_x*m.step_y*UM**2)
    return found


def by_surfacetopography(m, degree=1):
    """Parameters by SurfaceTopography; slopes and curvatures only where no point is missing."""
    t = topography(m).detrend({1: "height", 2: "curvature"}[degree])
    found = {"sq": t.Sq()*UM}
    if np.isnan(m.heights).any():
        return found

    def mean_square(order, stencil, along_x):
        shape = (-1, 1) if along_x else (1, -1)
        start = -(order//2)
        operator = DiscreteDerivative([start, 0] if along_x else [0, start],
                                      np.reshape(stencil, shape))
        values = t.derivative(order, operator=operator, periodic=False)
        return np.mean(np.asarray(values)**2)/UM**(2*order - 2)

    for name, order, stencil in (("m2", 1, [-1, 1]), ("m4", 2, [1, -2, 1])):
        found[name + "_x"] = mean_square(order, stencil, True)
        found[name + "_y"] = mean_square(order, stencil, False)
    found["sdq by rms_gradient"] = t.rms_gradient()
    found["sqrt(m4_x) by Rddq"] = t.Rddq()/UM
    return found


def by_tamaas(m):
    """Sq of the levelled map; spectral moments of the map as it is, whose period tamaas takes for
    granted: a plane would add a step at its seam."""
    level = np.ascontiguousarray(np.asarray(topography(m).detrend("height").heights()).T)*UM
    # it divides by one point less
    found = {"sq": tamaas.Statistics2D.computeRMSHeights(level)*np.sqrt(1 - 1/level.size)}
    if not m.periodic:
        return found
    z = np.ascontiguousarray(m.heights - m.heights.mean())*UM
    side = z.shape[0]*m.step_y*UM
    if m.step_x == m.step_y and z.shape[0] == z.shape[1]:
        # it counts wave numbers in periods of the map
        _, m2, m4 = tamaas.Statistics2D.computeMoments(z)
        found["m2"], found["m4"] = m2*(2*np.pi/side)**2, m4*(2*np.pi/side)**4
    power = spectrum(z)
    for axis, name, step in ((1, "x", m.step_x*UM), (0, "y", m.step_y*UM)):
        q = 2*np.pi*np.fft.fftfreq(z.shape[axis])
        difference = (2*np.sin(q/2)/step).reshape((1, -1) if axis else (-1, 1))
        found[f"m2_{name} by spectrum"] = (power*difference**2).sum()
        found[f"m4_{name} by spectrum"] = (power*difference**4).sum()
    return found


def spectrum(z):
    """tamaas' power spectrum on all wave numbers, whose sum is the mean square; it keeps those of
    half a plane."""
    half = np.asarray(tamaas.Statistics2D.computePowerSpectrum(z)).real
    n = z.shape[1]
    others = half[(-np.arange(z.shape[0])) % z.shape[0]][:, 1:(n + 1)//2][:, ::-1]
    return np.concatenate([half, others], axis=1)
