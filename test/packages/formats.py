"""Maps in every format: written by other programs and read by asperity, and the other way round.

They have unequal steps, are no square, and are written with and without missing points where the
format has any. What another program is known to do wrong is a check of its own, which fails when it
no longer does it.
"""

import warnings
from collections import namedtuple

import gsffile
import gwyddion
import gwyfile.objects as gwy
import maps
import numpy as np
import packages
import sdfio
import sensofar
import surface_statistics
import x3pio
from surfalize import Surface
from table import check

M = 1e-6  # of a um
# Heights are off by at most so much of the highest, of either sign; whether points may be missing;
# options that say what the file does not; whether the rows of the file are turned over
Writer = namedtuple("Writer", "name ending write resolution holes hints turned",
                    defaults=(True, (), False))

# Of singles: 2^-24, and as much for figures that print them; of whole numbers of so many bits
SINGLE, SHORT, LONG, DOUBLE = 2.0**-23, 2.0**-15, 2.0**-31, 1e-15


def all_writers():
    """Every program and form."""
    # its text has ten decimals of a um
    for binary, resolution in ((True, DOUBLE), (False, 2e-11)):
        yield Writer(f"surfalize SDF {'binary' if binary else 'text'}", "sdf",
                     lambda m, path, b=binary: surface(m).save(path, binary=b), resolution)
    for kind, resolution in (("D", DOUBLE), ("F", SINGLE)):
        yield Writer(f"surfalize X3P {kind}", "x3p",
                     lambda m, path, k=kind: surface(m).save(path, dtype=k), resolution)
    for packed in (False, True):
        yield Writer(f"surfalize SUR{' compressed' if packed else ''}", "sur",
                     lambda m, path, p=packed: surface(m).save(path, compressed=p), SINGLE)
    for kind, resolution in (("D", DOUBLE), ("F", SINGLE), ("L", LONG), ("I", SHORT)):
        yield Writer(f"SurfaceTopography X3P {kind}", "x3p",
                     lambda m, path, k=kind: maps.topography(m).to_x3p(path, dtype=k), resolution)
    yield Writer("SurfaceTopography matrix", "txt",
                 lambda m, path: maps.topography(m).to_matrix(path), DOUBLE)
    for revision in sdfio.Revision:
        for kind in sdfio.DataType:
            if kind in sdfio.Revision(revision).rules.data_types:
                for form in sdfio.FileFormat:
                    yield sdfio_writer(revision, kind, form)
    for kind, resolution in zip(x3pio.DataType, (SHORT, LONG, SINGLE, DOUBLE)):
        for storage in x3pio.DataStorage:
            yield Writer(f"x3pio X3P {kind.value} {storage.name.lower()}", "x3p",
                         lambda m, path, k=kind, s=storage: x3pio.write(
                             path, m.heights*M, x_scale=m.step_x*M, y_scale=m.step_y*M, z_type=k,
                             storage=s), resolution)
    yield Writer("SurfaceTopography GWY", "gwy",
                 lambda m, path: maps.topography(m).to_gwy(str(path)), DOUBLE)
    yield Writer("gwyfile GWY", "gwy", write_gwyfile, DOUBLE)
    yield Writer("gsffile GSF", "gsf", lambda m, path: gsffile.write_gsf(
        path, (m.heights*M).astype("f4"), {
            "XReal": 40*m.step_x*M, "YReal": 32*m.step_y*M, "XYUnits": "m", "ZUnits": "m"}), SINGLE)
    # whatever is read alike by others in compare_sensofar
    yield Writer("PLU by its layout", "plu", sensofar.write_plu, SINGLE)
    yield Writer("PLUX by its layout", "plux", sensofar.write_plux, SINGLE)
    if not gwyddion.missing():
        yield Writer("Gwyddion GWY", "gwy", gwyddion.write, DOUBLE)
        # singles, and six figures of the sides
        yield Writer("Gwyddion GSF", "gsf", gwyddion.write, SINGLE, holes=False)
        # five and six figures, and no masks
        yield Writer("Gwyddion SDF", "sdf", gwyddion.write, 1e-6, holes=False, turned=True)
        yield Writer("Gwyddion SUR", "sur", gwyddion.write, SINGLE, holes=False)
        yield Writer("Gwyddion XYZ", "xyz", gwyddion.write, 1e-5, holes=False)
        # it prints lengths in whole um: only the user knows the step
        yield Writer("Gwyddion text", "txt", gwyddion.write, 1e-5, False,
                     ("--step", "0.0025,0.002"))


def sdfio_writer(revision, kind, form):
    """One of sdfio's."""
    resolution = {"BINARY64": DOUBLE, "BINARY32": SINGLE, "UINT8": 2.0**-7, "INT8": 2.0**-7,
                  "UINT16": SHORT, "INT16": SHORT}.get(kind.name, LONG)

    def write(m, path):
        # numbers without sign are heights above 0
        z = (m.heights - np.nanmin(m.heights))*M if kind.name.startswith("U") else m.heights*M
        sdfio.write(path, z, x_scale=m.step_x*M, y_scale=m.step_y*M, format=form,
                    metadata=sdfio.Metadata(revision=revision, data_type=kind))

    return Writer(f"sdfio {revision.value} {kind.name.lower()} {form.name.lower()}", "sdf", write,
                  resolution)


def write_gwyfile(m, path):
    """A channel with other values before it, and points that are missing under a mask."""
    holes = np.isnan(m.heights)
    sides = {"xreal": 40*m.step_x*M, "yreal": 32*m.step_y*M}
    file = gwy.GwyContainer()
    file["/0/data/title"], file["/3/data/title"] = "Phase", "Topography"
    file["/0/data"] = gwy.GwyDataField(0*m.heights, **sides, si_unit_xy="m", si_unit_z="deg")
    file["/3/data"] = gwy.GwyDataField(np.where(holes, 7.0, m.heights)*M, **sides, si_unit_xy="m",
                                       si_unit_z="m")
    if holes.any():
        file["/3/mask"] = gwy.GwyDataField(holes.astype(float), **sides, si_unit_xy="m")
    file.tofile(str(path))


def surface(m):
    """A map as surfalize has it."""
    return Surface(m.heights.copy(), m.step_x, m.step_y)


def read_by_asperity(program, path, hints):
    """(heights[j, i], step_x, step_y) in um, levelled."""
    out = path.with_name(path.name + ".map.csv")
    program.run(path, "--most-missing", "0.5", *hints, "--map", str(out))
    with open(out, encoding="utf-8") as file:
        head = [next(file) for _ in range(4)]
    steps = [1e3*float(line.split()[2]) for line in head[1:3]]
    return 1e3*np.genfromtxt(out, delimiter=",", comments="#"), *steps


def two_maps():
    """The same map without and with holes: single ones, a corner, the opposite one, a scratch."""
    z = maps.gaussian(40, 32, 4, 9, sq=1.7, seed=12) + 3.0
    holes = maps.holed(z)
    holes[0, 0] = holes[31, 39] = np.nan
    return [maps.Map(name, "", heights, 2.5, 2.0, False, None, None)
            for name, heights in (("full", z), ("holed", holes))]


def compare(where, found, m, resolution, turned=False):
    """Check a map that was read, (heights, step_x, step_y) in um."""
    heights, step_x, step_y = found
    good = heights.shape == m.heights.shape and max(abs(step_x/m.step_x - 1),
                                                    abs(step_y/m.step_y - 1)) < 1e-6
    if not check(f"{where}: points and steps", good,
                 f"{heights.shape[1]} x {heights.shape[0]}, {step_x:.9g} x {step_y:.9g} um"):
        return
    if turned:
        heights = heights[::-1]
    same = np.array_equal(np.isnan(heights), np.isnan(m.heights))
    check(f"{where}: the same points are missing", same, f"{np.isnan(heights).sum()}")
    if same:
        steps = m.step_x, m.step_y
        off = np.nanmax(np.abs(surface_statistics.level(heights, *steps)
                               - surface_statistics.level(m.heights, *steps)))
        share = off/np.nanmax(np.abs(m.heights))
        check(f"{where}: heights", share < 1.1*resolution,
              f"{share:.1e} of the highest off ({resolution:.1e} by its numbers)")


def compare_formats(program, _):
    """All writers and readers."""
    warnings.filterwarnings("ignore", message=".*different pixel size.*")
    if gwyddion.missing():
        print(f"     left out: Gwyddion, as there is no {gwyddion.missing()}")
    for m in two_maps():
        for writer in all_writers():
            if writer.holes or m.name == "full":
                path = program.folder / f"{writer.name} {m.name}.{writer.ending}".replace(" ", "_")
                writer.write(m, path)
                compare(f"{writer.name}, {m.name}, read by asperity",
                        read_by_asperity(program, path, writer.hints), m, writer.resolution,
                        writer.turned)
        compare_own(program, m)
        compare_sensofar(program, m)
    compare_scans(program)
    compare_faults(program)


def compare_own(program, m):
    """Maps that asperity writes, as others read them. Holes make whole numbers of 32 bits, of which
    half of one is lost."""
    source = program.folder / f"own_{m.name}.x3p"
    surface(m).save(source)
    written = {}
    for ending in ("sdf", "xyz"):
        written[ending] = program.folder / f"own_{m.name}.{ending}"
        program.run(source, "--most-missing", "0.5", "--map", str(written[ending]))
    readers = [("surfalize", packages.read_by_surfalize),
               ("SurfaceTopography", packages.read_by_surfacetopography),
               ("sdfio", read_by_sdfio)]
    if not gwyddion.missing():
        readers.append(("Gwyddion", gwyddion.read))
    for name, reader in readers:
        compare(f"asperity SDF, {m.name}, read by {name}", reader(written["sdf"]), m,
                LONG/2 if m.name == "holed" else DOUBLE)
    # without a unit in the file: its mm are um here
    compare(f"asperity XYZ, {m.name}, read by SurfaceTopography",
            [1e3*found for found in packages.read_by_surfacetopography(written["xyz"])], m, DOUBLE)
    heights, step_x, step_y = packages.read_by_surfalize(written["xyz"])
    check(f"asperity XYZ, {m.name}, read by surfalize: numbers as metres, and steps of range/n",
          abs(step_x/(2500*39/40) - 1) < 1e-9 and abs(step_y/(2000*31/32) - 1) < 1e-9
          and np.array_equal(np.isnan(heights), np.isnan(m.heights)), f"{step_x:g} x {step_y:g} um")


def compare_sensofar(program, m):
    """PLU and PLUX, which no program but the instruments' own writes: files by the layout that is
    taken for right are read alike by others."""
    for ending, write, readers in (
            ("plu", sensofar.write_plu, ["SurfaceTopography"]),
            ("plux", sensofar.write_plux, ["SurfaceTopography", "surfalize"])):
        path = program.folder / f"others_{m.name}.{ending}"
        write(m, path)
        for name in readers + ([] if gwyddion.missing() else ["Gwyddion"]):
            reader = {"surfalize": packages.read_by_surfalize, "Gwyddion": gwyddion.read,
                      "SurfaceTopography": packages.read_by_surfacetopography}[name]
            compare(f"{ending.upper()} by its layout, {m.name}, read by {name}", reader(path), m,
                    SINGLE)
    heights = packages.read_by_surfalize(program.folder / f"others_{m.name}.plu")[0].ravel()
    check(f"PLU by its layout, {m.name}, read by surfalize: two points late",
          np.array_equal(heights[2:], m.heights.ravel()[:-2].astype("f4"), equal_nan=True))


def compare_scans(program):
    """Scans of real microscopes, by asperity and by others."""
    for path in sensofar.real_files(program.folder):
        heights, step_x, step_y = packages.read_by_surfacetopography(path)
        m = maps.Map(path.name, "", heights, step_x, step_y, False, None, None)
        compare(f"{path.name}, read by asperity as by SurfaceTopography",
                read_by_asperity(program, path, ()), m, 1e-12)
        if not gwyddion.missing():
            compare(f"{path.name}, read by Gwyddion as by SurfaceTopography", gwyddion.read(path),
                    m, 1e-12)


def compare_faults(program):
    """Faults of writers, as asperity reads their files."""
    m = two_maps()[0]
    singles = m.heights.astype("f4")
    path = program.folder / "singles.sur"
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # the cast that goes wrong
        surface(m._replace(heights=singles)).save(path)
    singles[singles == singles.max()] = singles.min()
    compare("surfalize SUR of singles, whose highest point is written as the lowest, by asperity",
            read_by_asperity(program, path, ()), m._replace(heights=singles), SINGLE)
    if gwyddion.missing():
        return
    m = two_maps()[1]
    for ending in ("txt", "xyz", "gsf", "sdf", "sur"):
        hints = ("--step", "0.0025,0.002") if ending == "txt" else ()
        path = program.folder / f"masked.{ending}"
        gwyddion.write(m, path)
        check(f"Gwyddion {ending.upper()} with a mask: points below it are written as heights",
              not np.isnan(read_by_asperity(program, path, hints)[0]).any())


def read_by_sdfio(path):
    """(heights[j, i], step_x, step_y) in um."""
    read = sdfio.read(path)
    return read.data/M, read.header.x_scale/M, read.header.y_scale/M
