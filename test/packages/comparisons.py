"""Parameters of maps by asperity and by others."""

import math

import maps
import numpy as np
import packages
import surface_statistics
from surfalize import Surface
from surfalize.filter import GaussianFilter
from table import check

UM = 1e-3  # mm
# Differences of sums that were taken in another order; heights above a steep plane lose more
SAME = 1e-10
REFERENCE = 1e-9


def read(m, path):
    """{package: the map as it reads the file}, as another does where its own reader cannot."""
    found = {}
    for name, reader in (("surfalize", packages.read_by_surfalize),
                         ("SurfaceTopography", packages.read_by_surfacetopography)):
        try:
            heights, step_x, step_y = reader(path)
        except Exception as problem:  # whatever its reader says of a file it does not know
            print(f"     {m.name}: {name} does not read {path.name}: "
                  f"{str(problem).splitlines()[0][:60]}")
            continue
        if heights.shape == m.heights.shape and abs(step_x/m.step_x - 1) < 1e-6:
            found[name] = m._replace(heights=heights)
        else:
            print(f"     {m.name}: {name} reads {path.name} with {heights.shape} points, "
                  f"step {step_x:g} um")
    check(f"{m.name}: {path.suffix[1:]} read by others too", bool(found), ", ".join(found))
    as_read = next(iter(found.values()), m)
    return {name: found.get(name, as_read) for name in ("surfalize", "SurfaceTopography")}


def compare_map(program, table, m):
    """All parameters of one map."""
    path = program.write(m)
    columns = program.columns(path)
    ours, others = columns["value"], read(m, path)
    heights, steps = others["SurfaceTopography"].heights*UM, (m.step_x*UM, m.step_y*UM)
    compare_reference(m.name, ours, heights, *steps)
    level = surface_statistics.level(heights, *steps)
    for every in (2, 4):
        compare_reference(f"{m.name}, step_{every}", columns[f"step_{every}"],
                          level[::every, ::every], steps[0]*every, steps[1]*every, degree=0)
    compare_surfacetopography(m.name, ours,
                              packages.by_surfacetopography(others["SurfaceTopography"]), table)
    if np.isnan(m.heights).any():
        return
    compare_surfalize(m.name, ours, packages.by_surfalize(others["surfalize"]), table)
    compare_tamaas(m, ours, packages.by_tamaas(others["SurfaceTopography"]), table)


def compare_reference(where, ours, heights, step_x, step_y, **how):
    """Every parameter by the second implementation."""
    expected = surface_statistics.statistics(heights, step_x, step_y, **how)
    worst, name_of_worst = 0.0, "none"
    for name, value in expected.items():
        if name == "direction":
            off = abs((ours[name] - value + 90) % 180 - 90)/180
        elif name == "ssk":
            off = abs(ours[name] - value)
        else:
            off = abs(ours[name]/value - 1)
        if math.isnan(off):
            off = math.inf
        if off > worst:
            worst, name_of_worst = off, name
    check(f"{where}: all parameters by the second implementation", worst <= REFERENCE,
          f"{worst:.1e} off in {name_of_worst} (at most {REFERENCE:.0e})")
    others = sorted(set(ours) ^ set(expected))
    check(f"{where}: no other parameters", not others, ", ".join(others))


def compare_surfalize(where, ours, theirs, table):
    """Heights, gradient and peaks."""
    for name in ("sa", "sq", "sku", "sz", "sp", "sv", "sdq"):
        table.same(where, name.capitalize(), ours[name], "surfalize", theirs[name], SAME)
    table.same(where, "Ssk", ours["ssk"], "surfalize", theirs["ssk"], SAME, absolute=SAME)
    table.same(where, "Spc", ours["spc"], "surfalize, hills at the border counted",
               theirs["spc with the border's hills"], SAME)
    table.same(where, "Spd", ours["spd"], "surfalize, its peaks on inner points",
               theirs["peaks inside"], SAME)
    table.compare(where, "Spd", ours["spd"], "surfalize, hills at the border counted",
                  theirs["spd with the border's hills"], -0.3, 0.02,
                  "it counts peaks on border points, which are none by their missing neighbours")
    table.compare(where, "Spd", ours["spd"], "surfalize", theirs["spd"], -1e-9, 2.0,
                  "it leaves out hills that reach the border, yet divides by the whole area")
    table.compare(where, "Spc", ours["spc"], "surfalize", theirs["spc"], -0.2, 0.2,
                  "it leaves out hills that reach the border")


def compare_surfacetopography(where, ours, theirs, table):
    """Height, slopes and curvatures of profiles."""
    table.same(where, "Sq", ours["sq"], "SurfaceTopography", theirs["sq"], SAME)
    for name in ("m2_x", "m2_y", "m4_x", "m4_y"):
        if name in theirs:
            table.same(where, name, ours[name], "SurfaceTopography", theirs[name], SAME)
    if "sdq by rms_gradient" in theirs:
        table.compare(where, "Sdq", ours["sdq"], "SurfaceTopography rms_gradient",
                      theirs["sdq by rms_gradient"], -0.01, 0.01,
                      "it leaves out the last profile of either direction")
        table.compare(where, "sqrt(m4_x)", math.sqrt(ours["m4_x"]), "SurfaceTopography Rddq",
                      theirs["sqrt(m4_x) by Rddq"], -0.01, 0.01,
                      "it leaves out the first and last profile")


def compare_tamaas(m, ours, theirs, table):
    """Spectral moments, where the map has the period that tamaas takes for granted."""
    table.same(m.name, "Sq", ours["sq"], "tamaas", theirs["sq"], SAME)
    if not m.periodic:
        return
    for name in ("m2_x", "m2_y", "m4_x", "m4_y"):
        table.compare(m.name, name, ours[name], "tamaas, differences in its spectrum",
                      theirs[name + " by spectrum"], -0.01, 0.01,
                      "its differences go on across the seam, to the other end of a profile")
    if "m2" in theirs:
        table.compare(m.name, "m2", ours["m2"], "tamaas computeMoments", theirs["m2"], -0.12, 0.0,
                      "derivatives of the waves themselves: differences over a step see less")
        table.compare(m.name, "m4", ours["m4"], "tamaas computeMoments", theirs["m4"], -0.25, 0.0,
                      "the same, by the fourth power of the wave number")


def compare_options(program, table):
    """Form, filters and pruning."""
    m = next(m for m in maps.all_maps() if m.name == "wavy")
    path = program.write(m)
    others = read(m, path)
    heights, steps = others["surfalize"].heights*UM, (m.step_x*UM, m.step_y*UM)
    level = surface_statistics.level(heights, *steps)

    ours = program.values(path, "--form", "2")
    compare_reference("form 2", ours, heights, *steps, degree=2)
    theirs = packages.by_surfalize(others["surfalize"], 2)
    for name in ("sq", "sku", "sdq"):
        table.same("wavy, form 2", name, ours[name], "surfalize", theirs[name], SAME)
    theirs = packages.by_surfacetopography(others["SurfaceTopography"], 2)
    for name in ("sq", "m4_x"):
        table.same("wavy, form 2", name, ours[name], "SurfaceTopography", theirs[name], SAME)
    compare_reference("form 6", program.values(path, "--form", "6"), heights, *steps, degree=6)

    short = surface_statistics.smoothed(level, 10, 10)
    ours = program.values(path, "--short-cutoff", "0.02")
    compare_reference("S filter 20 um", ours, short, *steps)
    long = short - surface_statistics.smoothed(short, 40, 40)
    compare_reference("S filter 20 um, L filter 80 um",
                      program.values(path, "--short-cutoff", "0.02", "--long-cutoff", "0.08"),
                      long, *steps)
    theirs = GaussianFilter(20.0, "lowpass")(Surface(level/UM, m.step_x, m.step_y)).level()
    table.compare("wavy, S filter 20 um", "Sq", ours["sq"], "surfalize", theirs.Sq()*UM, -1e-3,
                  1e-3, "it reflects the map at its border, which bends slopes there")
    table.compare("wavy, S filter 20 um", "Sdq", ours["sdq"], "surfalize", theirs.Sdq(), -0.02,
                  0.02, "it reflects the map at its border, which bends slopes there")
    for share in (0.02, 0.2):
        ours = program.values(path, "--pruning", str(share))
        compare_reference(f"pruning {share}", ours, heights, *steps, share=share)
        theirs = Surface(level/UM, m.step_x, m.step_y).Spc(pruning=100*share, exclude_edge=False)
        table.same(f"wavy, pruning {share}", "Spc", ours["spc"],
                   "surfalize, hills at the border counted", theirs/UM, SAME)


def compare_filled(program, table):
    """Missing points filled by a membrane."""
    m = next(m for m in maps.all_maps() if m.name == "holed")
    path = program.write(m)
    as_read = read(m, path)["SurfaceTopography"]
    filled = maps.topography(as_read).interpolate_undefined_data_with_harmonic_function()
    theirs = packages.by_surfacetopography(
        as_read._replace(heights=np.asarray(filled.heights()).T))
    ours = program.values(path, "--missing", "fill")
    for name, limit in (("sq", 1e-4), ("m2_x", 1e-3), ("m2_y", 1e-3), ("m4_x", 1e-2),
                        ("m4_y", 1e-2)):
        table.compare("holed, filled", name, ours[name], "SurfaceTopography", theirs[name], -limit,
                      limit, "harmonic too, solved to the end; ours by a stated number of sweeps")


def compare_written(program, table):
    """Maps that asperity writes, levelled, as others read them."""
    m = next(m for m in maps.all_maps() if m.name == "tilted")
    path = program.write(m)
    written = path.with_name("written.sdf")
    ours = program.values(path, "--map", str(written))
    readers = (("surfalize", packages.read_by_surfalize, packages.by_surfalize),
               ("SurfaceTopography", packages.read_by_surfacetopography,
                packages.by_surfacetopography))
    for name, reader, evaluate in readers:
        heights, step_x, step_y = reader(written)
        check(f"written SDF, read by {name}: points and steps",
              heights.shape == m.heights.shape and abs(step_x/m.step_x - 1) < 1e-14
              and abs(step_y/m.step_y - 1) < 1e-14, f"{step_x} {step_y}")
        theirs = evaluate(m._replace(heights=heights))
        table.same("written SDF", "Sq", ours["sq"], name, theirs["sq"], SAME)
    for ending in ("xyz", "csv"):
        again = path.with_name(f"written.{ending}")
        program.values(path, "--map", str(again))
        theirs = program.values(again)
        off = max(abs(theirs[name]/ours[name] - 1) for name in ours if name not in ("ssk",))
        check(f"written {ending}, read again: the same parameters", off < SAME, f"{off:.1e} off")


def compare_border(program, table):
    """Density of peaks on maps cut from endless ones, whose own density is known: they are
    periodic, so that it is that of the middle of nine copies."""
    names = ("asperity", "surfalize, hills at the border counted", "surfalize")
    shares, seeds, n = [], range(100, 130), 128
    for seed in seeds:
        m = maps.Map(f"border-{seed}", "", maps.gaussian(n, n, 6, 6, seed=seed), 1.0, 1.0, True,
                     maps.write_sdf_binary, "sdf")
        nine = np.tile(m.heights, (3, 3))
        peaks = surface_statistics.wolf_peaks(nine)[n:2*n, n:2*n].sum()/(n*UM)**2
        theirs = Surface(m.heights, 1.0, 1.0)
        shares.append([program.values(program.write(m))["spd"]/peaks,
                       theirs.Spd(exclude_edge=False)/UM**2/peaks, theirs.Spd()/UM**2/peaks])
    mean = np.mean(shares, axis=0)
    error = np.std(shares, axis=0)/math.sqrt(len(seeds) - 1)
    # a hill that is joined to a higher one only beyond the border is not pruned
    check("border: mean Spd is that of the endless maps", abs(mean[0] - 1) < 0.05,
          f"{mean[0]:.3f} of it, standard error {error[0]:.3f}")
    for k, bounds in ((1, (-0.25, -0.1)), (2, (0.3, 1.0))):
        table.compare(f"{len(seeds)} maps of 128 x 128 points, correlation length 6 steps", "Spd",
                      mean[0], names[k], mean[k], *bounds, "over that of endless maps, from which "
                      "these were cut: 1 is no bias")
