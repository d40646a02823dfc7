"""The maps on which the programs are compared, and the files they are read from."""

import struct
from collections import namedtuple

import numpy as np
from SurfaceTopography import Topography
from surfalize import Surface

# heights[j, i] in um, nan where nothing was measured; steps in um
Map = namedtuple("Map", "name meaning heights step_x step_y periodic write ending")


def noise(nx, ny, seed):
    """White noise from a generator whose numbers are promised never to change."""
    return np.random.RandomState(seed).standard_normal((ny, nx))


def waves(nx, ny):
    """Wave numbers of the points of a transform, radians per step."""
    return 2*np.pi*np.fft.fftfreq(nx)[None, :], 2*np.pi*np.fft.fftfreq(ny)[:, None]


def filtered(white, amplitude, sq):
    """Periodic map of root mean square height sq with the spectrum amplitude^2."""
    z = np.fft.ifft2(np.fft.fft2(white)*amplitude).real
    z -= z.mean()
    return z*sq/z.std()


def gaussian(nx, ny, across, along, turned=0.0, sq=1.0, seed=1):
    """Gaussian heights and correlation exp(-(x/across)^2 - (y/along)^2), lengths in steps, the
    axes turned by so many degrees."""
    q_x, q_y = waves(nx, ny)
    c, s = np.cos(np.radians(turned)), np.sin(np.radians(turned))
    return filtered(noise(nx, ny, seed),
                    np.exp(-((across*(c*q_x + s*q_y))**2 + (along*(c*q_y - s*q_x))**2)/8), sq)


def self_affine(n, hurst, longest, shortest, sq=1.0, seed=2):
    """Spectrum q^(-2-2H) between two wave lengths in steps, flat above the longest."""
    q = np.hypot(*waves(n, n))
    low, high = 2*np.pi/longest, 2*np.pi/shortest
    return filtered(noise(n, n, seed), np.where(q <= high, np.maximum(q, low)**(-1 - hurst), 0), sq)


def holed(z, seed=5):
    """Single missing points and a scratch of them."""
    z = z.copy()
    z[np.random.RandomState(seed).uniform(size=z.shape) < 0.01] = np.nan
    j, i = np.indices(z.shape)
    z[abs(j - 0.4*i - 0.2*z.shape[0]) < 2] = np.nan
    return z


def all_maps():
    """Every map, each to be written in a format of its own."""
    isotropic = gaussian(512, 512, 12, 12)
    x, y = np.arange(300)[None, :], np.arange(220)[:, None]
    return [
        Map("isotropic", "Gaussian, correlation length 12 steps", isotropic, 2.0, 2.0, True,
            write_sdf_binary, "sdf"),
        Map("coarse", "Gaussian, correlation length 3 steps", gaussian(256, 256, 3, 3, seed=3),
            1.0, 1.0, True, write_x3p_double, "x3p"),
        Map("lay", "Gaussian, 5 times longer along a lay at 120 degrees, unequal steps",
            gaussian(384, 320, 6, 30, 30, 8.0, seed=4), 2.0, 2.5, True, write_sur, "sur"),
        Map("self-affine", "Hurst exponent 0.8, waves of 6 to 128 steps",
            self_affine(512, 0.8, 128, 6), 1.0, 1.0, True, write_sdf_text, "sdf"),
        Map("wavy", "roughness on waves ten times as high",
            gaussian(300, 220, 5, 5, seed=6) + 10*np.sin(2*np.pi*x/150 + 1)
            + 3*np.cos(2*np.pi*y/70), 2.0, 2.0, False, write_x3p_single, "x3p"),
        Map("tilted", "roughness on a plane 300 times as high",
            gaussian(300, 220, 5, 7, seed=7) + 1.1*x - 0.4*y + 5000.0, 2.0, 1.5, False,
            write_matrix, "txt"),
        Map("skewed", "deep pores as in wood: exp of a Gaussian map, upside down",
            -4*np.exp(0.6*gaussian(256, 256, 7, 7, seed=8)), 5.0, 5.0, True, write_xyz, "xyz"),
        Map("stepped", "heights in whole steps of 0.05: ties and flat tops",
            np.round(gaussian(200, 260, 6, 6, seed=9)/0.05)*0.05, 1.0, 1.0, False,
            write_sdf_integers, "sdf"),
        Map("holed", "a scratch and single points missing",
            holed(gaussian(256, 200, 6, 6, seed=10)), 2.0, 2.0, False, write_x3p_integers, "x3p"),
        Map("cropped", "a corner of the isotropic map: no period", isotropic[:200, :240], 2.0, 2.0,
            False, write_sur_compressed, "sur")]


def write_sdf_binary(m, path):
    """ISO 25178-71 binary with doubles, by surfalize."""
    Surface(m.heights, m.step_x, m.step_y).save(path, binary=True)


def write_sdf_text(m, path):
    """ISO 25178-71 text with ten decimals, by surfalize."""
    Surface(m.heights, m.step_x, m.step_y).save(path, binary=False)


def write_sdf_integers(m, path):
    """ISO 25178-71 binary with 16-bit integers, which none of the programs writes."""
    size = m.heights.shape
    with open(path, "wb") as file:
        file.write(b"bISO-1.0" + b"asperity  " + 2*b"010120260000"
                   + struct.pack("<2H4d3B", size[1], size[0], m.step_x*1e-6, m.step_y*1e-6, 1e-8,
                                 -1.0, 0, 5, 0))
        file.write(np.round(m.heights*100).astype("<i2").tobytes())


def write_x3p_double(m, path):
    """ISO 25178-72 with doubles, by surfalize."""
    Surface(m.heights, m.step_x, m.step_y).save(path, dtype="D")


def write_x3p_single(m, path):
    """ISO 25178-72 in single precision, by surfalize."""
    Surface(m.heights, m.step_x, m.step_y).save(path, dtype="F")


def write_x3p_integers(m, path):
    """ISO 25178-72 with 32-bit integers and a file of valid points, by SurfaceTopography."""
    topography(m).to_x3p(path, dtype="L")


def write_sur(m, path):
    """Digital Surf SUR, by surfalize."""
    Surface(m.heights, m.step_x, m.step_y).save(path)


def write_sur_compressed(m, path):
    """Digital Surf SUR, compressed, by surfalize."""
    Surface(m.heights, m.step_x, m.step_y).save(path, compressed=True)


def write_matrix(m, path):
    """Text matrix with `# Width`, `# Height` and `# Value units`, by SurfaceTopography."""
    topography(m).to_matrix(path)


def write_xyz(m, path):
    """Three columns in um, whose order is that of no instrument."""
    j, i = (k.ravel() for k in np.indices(m.heights.shape))
    order = np.random.RandomState(11).permutation(m.heights.size)
    np.savetxt(path, np.stack([i*m.step_x, j*m.step_y, m.heights.ravel()], 1)[order],
               fmt="%.17g", header="x [um] y [um] z [um]")


def topography(m):
    """A map as SurfaceTopography has it: first index along x."""
    n_y, n_x = m.heights.shape
    return Topography(np.ma.masked_invalid(m.heights.T), (n_x*m.step_x, n_y*m.step_y), unit="µm")
