"""Rows on the law, wood, surfaces, shear tests and the set-up of the joint: what asperity says of each.

(id, paper, what it says, command or procedure, check or fixed answer, why); a check takes the program.
"""

import math

from joint_rows import CLOSE, NO, OPEN, YES, percent, verdict

CASE = "examples/tenon_joint/base.nml"
# Table 1: E across and along the grain, MPa, and Poisson's ratios of radial-tangential and longitudinal
ALONG, ACROSS, NU_LT, NU_RT = 3727.12, 351.01, 0.42, 0.35
STRENGTHS = {"along": 50.1, "across": 4.7}
# Table 2: sigma, µm, R, mm, eta, 1/µm^2; Table 4: mu, gcrit, eta, E*, R, H, k
TABLE_2 = {"unpolished-cross": (59.3, 0.1477, 0.000206), "unpolished-tangential": (41.6, 0.1142, 0.000134),
           "unpolished-radial": (27.6, 0.0696, 0.000127), "mesh-200-cross": (28.0, 0.2437, 0.000330),
           "mesh-200-tangential": (19.7, 0.1508, 0.000297), "mesh-200-radial": (15.6, 0.1746, 0.000196),
           "mesh-400-cross": (23.9, 0.4465, 0.000322), "mesh-400-tangential": (14.7, 0.3446, 0.000296),
           "mesh-400-radial": (11.7, 0.2336, 0.000169)}
TABLE_4 = {"transverse-tangential": (0.5, 0.31, 0.000206, 297.0, 0.1477, 24.53, 0.4),
           "tangential-tangential": (0.5, 0.31, 0.000134, 263.0, 0.1142, 12.14, 0.4)}
PER_MM2 = 1e6  # of 1/µm^2
# Table 5: test, hard, rough: Myield, Mu, K; errors in %
TABLE_5 = ((19.56, 22.14, 181.06), (16.02, 17.91, 154.39), (18.03, 19.84, 163.82))
ERRORS = ((18.1, 19.1, 14.7), (7.8, 10.4, 9.5))


def modulus(one, other):
    """Eq. 4 of two (E, nu)."""
    return 1.0/sum((1.0 - nu**2)/e for e, nu in (one, other))


def equation_4(_):
    pairs = modulus((ALONG, NU_LT), (ACROSS, NU_RT)), modulus((ACROSS, NU_RT), (ACROSS, NU_RT))
    close = all(abs(ours/table - 1.0) < CLOSE for ours, table in zip(pairs, (297.0, 263.0)))
    return verdict(close), f"{pairs[0]:.1f} and {pairs[1]:.1f} MPa for 297 and 263"


def presets(program):
    """{name: {column: value}} of `asperity pairs`."""
    table = program.run("pairs")["data"]
    return {name: {column: values[i] for column, values in table.items()}
            for i, name in enumerate(table["name"])}


def same(preset, names, row, factors):
    return all(abs(preset[name] - value*factor) < 1e-9*abs(preset[name])
               for name, value, factor in zip(names, row, factors))


def table_2(program):
    given = presets(program)
    good = sum(same(given[name], ("sigma", "radius", "eta"), row, (1e-3, 1.0, PER_MM2))
               for name, row in TABLE_2.items())
    return verdict(good == len(TABLE_2)), f"{good} of {len(TABLE_2)}"


def table_4(program):
    given = presets(program)
    names = ("friction_coefficient", "critical_slip", "eta", "modulus", "radius", "hardness", "yield_factor")
    good = sum(same(given[name], names, row, (1.0, 1.0, PER_MM2, 1.0, 1.0, 1.0, 1.0))
               for name, row in TABLE_4.items())
    return verdict(good == len(TABLE_4)), f"{good} of {len(TABLE_4)}"


def wood(program):
    joint = program.run("tenon", CASE)["settings"]
    values = [joint[f"{name}_{axis}"] for axis in "lr" for name in ("young_modulus", "compression_strength")]
    return verdict(all(abs(a/b - 1.0) < 1e-3 for a, b in zip(values, (
        ALONG, STRENGTHS["along"], ACROSS, STRENGTHS["across"])))), ", ".join(
            f"{v:g}" for v in values) + " MPa"


def summit(program):
    """w1 by Eq. 6 and w2."""
    pair = presets(program)["transverse-tangential"]
    w1 = (0.75*math.pi*pair["yield_factor"]*pair["hardness"]/pair["modulus"])**2*pair["radius"]
    return YES, f"w1 = {1e3*w1:.3f} µm, w2 = {110e3*w1:.0f} µm"


def interaction(program):
    data = program.run("press", "--peak", "4.7")["data"]
    return OPEN, f"real area {100.0*max(data['area_fraction']):.0f} % of nominal at fc90"


def test_settings(program):
    answer = program.run("shear")["settings"]
    good = (answer["normal_stress"] == [0.05, 0.1, 0.2] and answer["rate"] == 1.2
            and answer["diameter"] == 61.8)
    return verdict(good), f"{answer['diameter']:g} mm, {', '.join(f'{v:g}' for v in answer['normal_stress'])} MPa"


def elements(program):
    """Elements of the joint's deck, which is half of it."""
    count, inside = 0, False
    for row in program.text("deck", "tenon", CASE, "--mesh-size", "30", "--inp", "-").splitlines():
        if row.startswith("*"):
            inside = row.upper().startswith("*ELEMENT, TYPE=C3D8")
        else:
            count += inside
    return OPEN, f"{count} elements of 30 mm in our half"


def column_load(program):
    text = program.text("deck", "tenon", CASE, "--inp", "-")
    return verdict("54000" in text), "54 kN as a pressure on the top"


def pressure(program, *options):
    answer = program.run("curve", "--separation", "0.1", *options)["data"]
    return answer["pressure"][0]


def curve(program):
    return YES, f"{pressure(program):.5f} MPa at 0.1 mm"


def softer(program):
    ratio = pressure(program, "--hardness", "12.14")/pressure(program)
    return NO, f"pressure {percent(ratio)} with the softer"


def rougher(program):
    surfaces = presets(program)
    kinds = [[surfaces[f"{finish}-{section}"]["sigma"]*1e3 for section in ("cross", "tangential", "radial")]
             for finish in ("unpolished", "mesh-200", "mesh-400")]
    return verdict(all(a > b > c for a, b, c in kinds)), "; ".join(
        ", ".join(f"{v:.1f}" for v in kind) for kind in kinds) + " µm"


def smoother(program):
    surfaces = presets(program)
    kinds = [[surfaces[f"{finish}-{section}"]["sigma"]*1e3 for finish in ("unpolished", "mesh-200",
             "mesh-400")] for section in ("cross", "tangential", "radial")]
    return verdict(all(a > b > c for a, b, c in kinds)), "sigma falls in all three sections"


def strains(_):
    return OPEN, f"yield at {100.0*STRENGTHS['along']/ALONG:.2f} and " \
        f"{100.0*STRENGTHS['across']/ACROSS:.2f} % strain"


def press(program):
    return program.run("press", "--control", "overclosure", "--peak", "0.14")["data"]


def nonlinear(program):
    k = press(program)["stiffness"]
    peak = max(range(len(k)), key=lambda i: k[i])
    return verdict(k[peak] > 2.0*k[0]), f"stiffness {k[0]:.2f} to {k[peak]:.0f} MPa/mm"


def stages(program):
    data = press(program)
    shares = [max(data[name]) for name in ("elastic_share", "elastoplastic_share")]
    return verdict(shares[0] > 0.5), f"elastic {100.0*shares[0]:.2f} %, elasto-plastic up to " \
        f"{100.0*shares[1]:.1f} % of the pressure"


def shear(program):
    return program.run("shear", "--normal-stress", "0.05,0.1,0.2")


def plateaus(program):
    table = shear(program)["summary"]
    return YES, f"{', '.join(f'{v:.3g}' for v in table['plateau_nominal'])} MPa after " \
        f"{', '.join(f'{v:.3g}' for v in table['initial_slope'])} MPa/mm"


def no_level(program):
    table = shear(program)["summary"]
    ratio = table["plateau"][0]/table["plateau_nominal"][0]
    return verdict(ratio > 1.01), f"{percent(ratio)} on the overlap at 3 mm"


def knee(program):
    data = program.run("shear", "--normal-stress", "0.05")["data"]
    slip, stress = data["slip"], data["shear_stress_nominal"]
    slopes = [(b - a)/(v - u) for u, v, a, b in zip(slip, slip[1:], stress, stress[1:])]
    between = sum(0.05*slopes[0] < s < 0.95*slopes[0] for s in slopes)
    bent = program.run("shear", "--normal-stress", "0.05", "--stick", "summits", "--displacement", "0.1",
                       "--displacement-increment", "0.005")["data"]["shear_stress"]
    parts = ", ".join(f"{100.0*bent[i]/max(bent):.0f}" for i in (1, 2, 4))
    return verdict(between > 3), f"{between} of {len(slopes)} increments between the two slopes; with " \
        f"stick = summits at 0.05 MPa {parts} % of the plateau after 0.005, 0.01, 0.02 mm"


def programme(program):
    joint = program.run("tenon", CASE)["settings"]
    return YES, f"{sum(joint['cycles']):.0f} cycles, {joint['amplitudes'][0]:g} to " \
        f"{joint['amplitudes'][-1]:g} mm"


def first_contact(program):
    """Fig. 2: where the pressure is largest when the load point is up."""
    rows = [row for row in program.points("tenon", CASE) if row["model"] == "rough"]
    top = max(float(row["displacement"]) for row in rows)
    place = {}
    for face in ("upper", "lower"):
        mine = [row for row in rows if row["face"] == face and float(row["displacement"]) == top]
        place[face] = float(max(mine, key=lambda row: float(row["pressure"]))["x"])
    return verdict(place["upper"] > -50.0 > place["lower"]), f"upper face {place['upper']:.0f} mm from the " \
        f"column face, lower {place['lower']:.0f} mm"


def table_5_errors(_):
    worst = max(abs(100.0*(1.0 - v/t) - e) for row, errors in zip(TABLE_5[1:], ERRORS)
                for v, t, e in zip(row, TABLE_5[0], errors))
    return verdict(worst < 0.051), f"within {worst:.2f} percentage points"


def table_5_rotation(_):
    turns = [mu/k for _, mu, k in TABLE_5]
    return NO, f"K = Mu/rotation needs {min(turns):.3f} to {max(turns):.3f} rad for 0.096"


def moments(program):
    table = program.run("tenon", CASE)["summary"]["ultimate_moment"]
    return OPEN, f"{-table[-2]:.1f} and {-table[-1]:.1f} kN m for 17.91 and 19.84"


def standard_normal(program):
    answer = program.run("tenon", CASE, "--sigma", "1", "--initial-separation", "4", "--accept-unphysical")
    cycles = answer["cycles"]
    first = cycles["secant_stiffness_rough"][0]/cycles["secant_stiffness_hard"][0]
    return NO, f"Mu {percent(answer['summary']['ultimate_to_hard'][-1])}, but stiffness at 0.5 mm " \
        f"times {first:.1f}"


def old_wood(program):
    f = 0.7
    ratio = pressure(program, "--modulus", f"{297*f:.6g}", "--hardness", f"{24.53*f:.6g}")/pressure(program)
    return OPEN, f"E and H times {f}: p times {ratio:.3f}"


EXACT = "[errors](equations.md)"
DRAWN = "a drawing or photograph"
LAW = [
    ("E1", "Eqs 1-3", "elastic summit: area, force, mean pressure", "evaluate_asperity", (YES, EXACT), ""),
    ("E4a", "Eq. 4", "E* of two faces", "equivalent_modulus", (YES, EXACT), ""),
    ("E4b", "Eq. 4, Table 4", "E* = 297 and 263 MPa", "equivalent_modulus", equation_4,
     "no reading of Table 1 gives them; the pairs keep Table 4"),
    ("E5a", "Eqs 5-9", "first yield at k H, k = 0.4: w1", "new_normal_properties", (YES, EXACT), ""),
    ("E5b", "Eq. 6", "H is the softer face's", "curve", softer, "Table 4 takes the harder, 24.53 MPa"),
    ("E10", "Eqs 10-13", "plastic summit, w2 = 110 w1", "evaluate_asperity", (YES, EXACT), ""),
    ("E14", "Eqs 14-16, 19-22", "elasto-plastic summit, exponents 0.1949, 1.1475, 1.3424",
     "[summit](../examples/summit/summit.f90)", (YES, "the same to four digits"), ""),
    ("E17", "Eqs 17, 18", "continuous and differentiable at w1, w2", "evaluate_asperity",
     (NO, "continuous"), "powers meet there with different slopes"),
    ("F5", "Fig. 5", "three stages of one summit", "[picture](law.md#force-of-one-summit)", summit, ""),
    ("E23", "Eq. 23, Fig. 6", "Gaussian heights", "evaluate_normal_law", (YES, EXACT),
     "sigma is missing from Tables 3 and 4"),
    ("E24", "Eqs 24-26", "summits in contact, area, load of the faces", "curve", curve, ""),
    ("E27", "Eq. 27", "f = mu N", "shear", (YES, EXACT), ""),
    ("E28", "Eqs 28-30", "sigma = Sq, R = 1/Spc, eta = Spd", "surface", (YES, EXACT), ""),
    ("S7", "text", "summits are spheres, alike, and do not interact", "press", interaction,
     "the assumption ends near nominal area; flagged above it"),
    ("C1", "Conclusion 1", "the law relates area, load, wood and surface", "curve", curve, ""),
    ("F4", "Figs 1, 4", "types of joints; rough faces", "", (OPEN, ""),
     DRAWN + "; the dovetail joint is not modelled"),
]
SURFACES = [
    ("T1a", "Table 1", "E and strength along and across the grain", "tenon", wood, ""),
    ("T1b", "Table 1", "tests of the wood", "", (OPEN, ""), "in other publications"),
    ("F7", "Figs 7, 8", "cubes, microscope", "", (OPEN, ""), DRAWN),
    ("S1", "text", "scan 50 x 50 mm every 100 nm", "surface", (OPEN, "2.5e11 heights"),
     "as printed it cannot have been"),
    ("F9", "Figs 9-11", "3-D profiles", "surface", (OPEN, ""), "the heights are not published"),
    ("T2a", "Table 2", "nine surfaces", "pairs", table_2, "units read as 1/µm², mm, µm; 120 mesh is "
     "200 in the table"),
    ("T2b", "Table 2, conclusion 2", "cross section rougher than tangential than radial", "pairs", rougher, ""),
    ("T2c", "Table 2", "smoother the finer the sanding", "pairs", smoother, ""),
    ("T2d", "Table 2", "Sku close to 3, so heights are Gaussian", "", (OPEN, "3.01 to 3.61"),
     "the law has no other heights to compare with"),
]
SHEAR = [
    ("F12", "Fig. 12", "steps of UINTER", "[picture](abaqus.md#what-a-call-does)", (YES, ""), ""),
    ("T3a", "Table 3", "eight PROPS", "uinter", (YES, ""), "and sigma, without which nothing follows"),
    ("T3b", "Table 3", "gcrit = 0.31 mm", "shear", (OPEN, "0.005 x 61.8 mm = 0.309 mm"),
     "ABAQUS' slip tolerance times the specimen: probably numerical"),
    ("F13", "Figs 13, 14", "discs of 61.8 mm, three stresses", "shear", test_settings, ""),
    ("F15", "Fig. 15", "discs of C3D8R, 2.5 mm, 0.05 MPa", "deck shear", (YES, ""),
     "CalculiX: [within 0.1 %](calculix.md#the-shear-test-the-papers-figs-15-18) of `asperity shear`, "
     "other elements"),
    ("F16", "Fig. 16", "plastic curves along and across the grain", "deck", strains,
     "the curves are not printed; ours are bilinear"),
    ("F17a", "Fig. 17", "pressure over time strongly nonlinear", "press", nonlinear, ""),
    ("F17b", "Fig. 17", "elastic, elasto-plastic and plastic phase", "press", stages,
     "nearly all summits in contact are elasto-plastic from first touch"),
    ("F18a", "Fig. 18", "steep, then moderate", "shear", plateaus, "at 0.05, 0.1 and 0.2 MPa"),
    ("F18b", "Fig. 18", "no horizontal end, as the contact area changes", "shear", no_level,
     "the force stays level, the overlap shrinks"),
    ("F18c", "Fig. 18", "gradual, not two stages", "shear", knee,
     "Coulomb with one gcrit has a corner, [summits that stick](stick.md) bend"),
    ("F18d", "Fig. 18, conclusion 3", "agrees with the test", "", (OPEN, ""), "the test's curves are not "
     "printed; dead weight tests friction alone"),
]
SET_UP = [
    ("F2", "Fig. 2", "turning, the neck presses above, the head below", "tenon", first_contact, ""),
    ("F3", "Fig. 3", "two pairs of faces: top and bottom, sides", "tenon", (YES, ""), ""),
    ("F19", "Figs 19-21", "test, sizes, mesh of 7144 elements", "deck tenon", elements,
     "sizes are in the drawing alone; ours are chosen"),
    ("F21", "Fig. 21", "foot fixed, top level, 54 kN", "deck tenon", column_load,
     "the load has no part in the plane replay"),
    ("F22", "Fig. 22", "programme", "tenon", programme, ""),
    ("T4", "Table 4", "two pairs", "pairs", table_4, "eta and R are of one face; E4b, E5b"),
    ("T5d", "Table 5", "moments in kN m", "tenon", moments,
     "the height is chosen for their order of size"),
    ("T5e", "Table 5", "errors against the test, %", "arithmetic", table_5_errors, ""),
    ("T5f", "Table 5, Fig. 30", "K is ultimate moment over ultimate rotation", "arithmetic",
     table_5_rotation, "beyond the end of Fig. 30"),
    ("S2", "text", "heights are standard normal, sigma = 1 mm", "tenon", standard_normal,
     "Fig. 27 forbids it"),
    ("S3", "Figs 25-30, conclusion 4", "the rough model is nearer to the test", "", (OPEN, ""),
     "the test's curves are not printed, its sizes not in the text"),
    ("S4", "Fig. 27", "the test is stiffer at first for want of clearance", "", (OPEN, ""), "as S3"),
    ("S5", "Fig. 29", "stiffness is the mean of both sides", "hysteresis", (YES, ""),
     "as the sum of forces over the sum of displacements, the same where both go as far"),
    ("S6", "text", "degraded wood, in future", "curve", old_wood, "no factors are printed"),
]
