"""What a UINTER is given: every argument as ABAQUS would fill it, from the record that recorder.f90
makes of its calls while two blocks, tilted by 20 degrees, are pressed, slid, turned about the
normal, lifted and pressed again.
"""

import math

from blocks import Deck, Interaction, tilt
from harness import Run, at_most, check, close
from results import recorded_calls

SIDE, HEIGHT, MODULUS = 30.0, 10.0, 351.0
TILT, TURN = 20.0, 10.0
DOWN, ALONG, LIFT = 0.3, 0.05, 0.83
PRESSURE, LENGTH, MU, SLOPE = 0.02, 0.1, 0.5, 0.3
# What ABAQUS passes as "large" and what stands for "no opposite surface"
LARGE, NO_SURFACE = 1.0, -1e35


def props(pressure=PRESSURE, length=LENGTH, exponential=1, mu=MU, slope=SLOPE, cut_after=0.0,
          longest=0.0, factor=0.5, record=1):
    """PROPS of recorder.f90."""
    return [pressure, length, exponential, mu, slope, cut_after, longest, factor, record]


def turned(at, angle):
    """Displacement of a turn about the middle of the contact, in the plane before the tilt."""
    cosine, sine = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    x, y = at[0] - SIDE / 2, at[1] - SIDE / 2
    return (cosine * x - sine * y - x, sine * x + cosine * y - y, 0.0)


def turning_deck():
    """Press and slide along the first slip direction, within stick; then turn everything."""
    deck = Deck(tilt(TILT))
    low = deck.block("LOW", (-5, -5, -HEIGHT), (SIDE + 5, SIDE + 5, 0), (5, 5, 1), MODULUS)
    high = deck.block("HIGH", (0, 0, 0), (SIDE, SIDE, HEIGHT), (4, 4, 1), MODULUS)
    deck.contact(Interaction.uinter("WOOD", props(), depvar=5, search_distance=0.5), "HIGH_DOWN",
                 "LOW_UP")
    deck.step({"LOW_ALL": (0, 0, 0), "HIGH_TOP": (0, 0, -DOWN)}, increment=0.5)
    deck.step({"HIGH_TOP": (ALONG, 0, -DOWN)}, increment=0.5)
    # each turn in one increment: in between, ccx moves the nodes along chords. The block is lifted
    # out of reach and turned in the air, where the first iteration swells it: springs come and go
    for angle, lift in ((TURN, 0.0), (2 * TURN, 0.0), (2 * TURN, LIFT), (3 * TURN, LIFT),
                        (3 * TURN, 0.0)):
        motion = {number: turned(at, angle) for number, at in low.nodes.values()}
        for number, at in high.layer(-1).items():
            x, y, _ = turned((at[0] + ALONG, at[1]), angle)
            motion[number] = (x + ALONG, y, lift - DOWN)
        deck.step(motion, increment=1.0, residual=1e-7)
    return deck


def dot(a, b):
    """Scalar product."""
    return sum(x * y for x, y in zip(a, b))


def columns(call):
    """Normal and slip directions."""
    return [call["ALOCALDIR"][3 * i:3 * i + 3] for i in range(3)]


def largest(values):
    """Largest size."""
    return max(abs(value) for value in values)


def met(calls):
    """The calls with an opposite surface."""
    return [call for call in calls if call.one("RDISP") > NO_SURFACE]


def last_of_increments(calls):
    """{(step, increment): {node: its last call}}, of the attempt that converged."""
    found = {}
    for call in met(calls):
        found.setdefault(tuple(call["COUNTERS"][:2]), {})[call.one("NODE")] = call
    return found


def constants(calls, high):
    """Names, sizes, flags and numbers that do not depend on the motion."""
    names = {tuple(call.names) for call in calls}
    expected = tuple(name.ljust(80) for name in ("WOOD", "HIGH_DOWN", "LOW_UP"))
    check("arguments: CINAME, SLNAME, MSNAME, 80 characters", names == {expected},
          str([tuple(name.strip() for name in row) for row in names]))
    sizes = {tuple(call["SIZES"]) for call in calls}
    check("arguments: NDIR, NSTATV, NPRED, NPROPS, MCRD", sizes == {(3, 5, 0, 9, 3)}, str(sizes))
    check("arguments: PROPS", all(call["PROPS"] == [float(f"{p:.12g}") for p in props()]
                                  for call in calls))
    check("arguments: PREDEF and DPRED are empty", not any(call["PREDEF"] for call in calls))
    check("arguments: TEMP and DTEMP are 0 in a deck without temperatures", not any(
        any(call["TEMP"]) for call in calls))
    flags = {(call["FLAGS"][0], call["FLAGS"][3], call["FLAGS"][4]) for call in calls}
    check("arguments: LINPER, LSDI and LPRINT are 0", flags == {(0, 0, 0)}, str(flags))
    check("arguments: PNEWDT comes as a large number", all(
        call.one("PNEWDT") > LARGE for call in calls), f"{calls[0].one('PNEWDT'):g}")
    check("arguments: SFD, SPD, SVD, SCD, dampings and fluxes come as zeros", all(
        not any(call["ENERGIES"][1:]) and not any(call["ZEROS"]) for call in calls))
    nodes = {call.one("NODE") for call in calls}
    check("arguments: NODE is each of the slave nodes", nodes == set(high.layer(0)),
          f"{len(nodes)} nodes")


def counters(run, calls, high):
    """KSTEP, KINC, KIT, TIME, DTIME against JOB.sta."""
    seen, good = {}, True
    for call in calls:
        step, increment, iteration = call["COUNTERS"]
        before = seen.get((step, increment))
        if step <= 4:
            good = good and (iteration == 0 if before is None else 0 <= iteration - before <= 1)
        seen[step, increment] = iteration
    check("arguments: KIT begins at 0 and goes up by 1 in every increment", good)
    check("arguments: the last KIT is the number of iterations in JOB.sta, or one less", all(
        row[3] - 1 <= seen[row[:2]] <= row[3] for row in run.increments if row[0] <= 4),
        ", ".join(f"{seen[row[:2]]}: {row[3]}" for row in run.increments))
    table = {(row[0], row[1]): row for row in run.increments}
    check("arguments: KSTEP and KINC are those of JOB.sta", set(seen) == set(table))
    per_iteration = {}
    for call in (call for call in calls if call["COUNTERS"][0] <= 4):
        per_iteration.setdefault(tuple(call["COUNTERS"]), set()).add(call.one("NODE"))
    check("arguments: every slave node in every iteration", all(
        nodes == set(high.layer(0)) for nodes in per_iteration.values()))
    worst = 0.0
    for call in calls:
        _, _, _, _, total, step_time, length = table[tuple(call["COUNTERS"][:2])]
        worst = max(worst, largest(a - b for a, b in zip(call["TIME"], (step_time, total, length))))
    at_most("arguments: TIME(1), TIME(2) at the end, and DTIME, against JOB.sta", worst, 1e-6)


def state(calls):
    """What comes in is what the converged iteration of the increment before gave back."""
    fresh, start, worst, good_flags, seen = {}, {}, 0.0, True, None
    for call in met(calls):
        key, node = tuple(call["COUNTERS"][:2]), call.one("NODE")
        if key[0] > 4:
            break
        if key != seen:
            start, seen = dict(fresh), key
        before = start.get(node)
        expected, flags = [0.0] * 9, [-1, -1]
        if before is not None:
            expected = before["OUT_STATEV"] + before["OUT_STRESS"] + before["OUT_SED"]
            flags = before["OUT_FLAGS"]
        found = call["STATEV"] + call["STRESS"] + call["ENERGIES"][:1]
        worst = max(worst, largest(a - b for a, b in zip(found, expected)))
        good_flags = good_flags and call["FLAGS"][1:3] == flags
        fresh[node] = call
    at_most("arguments: STATEV, STRESS, SED come as the last increment's end left them, in every "
            "iteration; zeros in the first", worst, 0.0)
    check("arguments: LOPENCLOSE and LSTATE come as -1, then as the last increment left them",
          good_flags)
    ends = last_of_increments(calls)[4, 1].values()
    counts = {call["OUT_STATEV"][0] for call in ends}
    check("arguments: an increment counts once in STATEV, whatever its iterations", counts == {6},
          str(counts))
    at_most("arguments: sum of DTIME in STATEV", largest(
        call["OUT_STATEV"][3] - 4 for call in ends), 1e-9)


def fields(run, calls):
    """What *CONTACT FILE shows is what UINTER was given and gave back."""
    shown, worst = run.contact_history[2.0], 0.0
    for node, call in last_of_increments(calls)[2, 2].items():
        expected = [-call["RDISP"][0], *call["RDISP"][1:], *call["OUT_STRESS"]]
        worst = max(worst, largest(a - b for a, b in zip(shown[node], expected)))
    at_most("fields: COPEN, CSLIP, CPRESS and CSHEAR are -RDISP(1), RDISP(2:3) and STRESS", worst,
            2e-6)


def reopening(run, calls):
    """Springs that vanish and come again, for good and for a few iterations only."""
    springs = {step: [row[0] for row in rows] for (step, _, _), rows in run.iterations.items()
               if step > 4}
    check("reopening: no spring is left in the air", springs[5][-1] == springs[6][-1] == 0,
          str(springs))
    check("reopening: while the block turns there, springs come and go", max(springs[6]) > 0)
    for step, words in ((6, "a spring that comes and goes"), (7, "a spring that comes to stay")):
        lost = [call for call in calls if call["COUNTERS"][0] == step
                and call.one("RDISP") < NO_SURFACE]
        check(f"reopening, {words}: RDISP(1) = -1.E36 tells of the time before, with the STATEV of "
              "its last increment", bool(lost) and all(
                  call["STATEV"][0] == 6 for call in lost), f"{len(lost)} calls")
        check(f"reopening, {words}: DRDISP(1) is huge", all(
            call["DRDISP"][0] > -NO_SURFACE for call in met(calls)
            if call["COUNTERS"][0] == step))
    check("reopening: RDISP(1) = -1.E36 never while the spring is there", not any(
        call.one("RDISP") < NO_SURFACE for call in calls if call["COUNTERS"][0] < 6))
    ends = last_of_increments(calls)
    check("reopening: the increment in the air counts for nothing", {
        call["OUT_STATEV"][0] for call in ends[7, 1].values()} == {7})
    at_most("reopening: RDISP(1) as before at the same place", largest(
        call["RDISP"][0] - ends[4, 1][node]["RDISP"][0]
        for node, call in ends[7, 1].items()), 2e-3)


def places(run, calls, deck):
    """COORDS, RDISP, DRDISP, ALOCALDIR, AREA against the printed displacements."""
    ends, times = last_of_increments(calls), {row[:2]: row[4] for row in run.increments}
    high = deck.blocks[1]
    bottom, on_master = high.layer(0), deck.place((0, 0, 0))
    off = {"COORDS": 0.0, "RDISP(1)": 0.0, "normal": 0.0, "orthonormal": 0.0, "first": 0.0,
           "handed": 0.0, "sum": 0.0, "change": 0.0, "AREA": 0.0, "CHRLNGTH": 0.0}
    before, total = {}, {}
    for key, nodes in ends.items():
        if key[0] > 4:
            break
        when = times[key]
        moved = run.printed.at("HIGH_ALL", when)
        normal, area = deck.place((0, 0, 1)), 0.0
        for node, call in nodes.items():
            at = [a + b for a, b in zip(deck.place(bottom[node]), moved[node])]
            off["COORDS"] = max(off["COORDS"], math.dist(at, call["COORDS"]))
            axes = columns(call)
            off["orthonormal"] = max(off["orthonormal"], largest(
                dot(axes[i], axes[j]) - (i == j) for i in range(3) for j in range(3)))
            cross = [axes[1][1] * axes[2][2] - axes[1][2] * axes[2][1],
                     axes[1][2] * axes[2][0] - axes[1][0] * axes[2][2],
                     axes[1][0] * axes[2][1] - axes[1][1] * axes[2][0]]
            off["handed"] = max(off["handed"], math.dist(cross, axes[0]))
            # the master is held, or turned about its own normal: its face stays in one plane
            off["normal"] = max(off["normal"], math.dist(axes[0], normal))
            off["first"] = max(off["first"], math.dist(axes[1], deck.place((1, 0, 0))))
            depth = dot([a - b for a, b in zip(on_master, at)], normal)
            off["RDISP(1)"] = max(off["RDISP(1)"], abs(call["RDISP"][0] - depth))
            if node in before:
                off["change"] = max(off["change"], abs(
                    call["DRDISP"][0] - call["RDISP"][0] + before[node]["RDISP"][0]))
                turn = call["DROT"]
                old = total[node]
                total[node] = [turn[0] * old[0] + turn[2] * old[1] + call["DRDISP"][1],
                               turn[1] * old[0] + turn[3] * old[1] + call["DRDISP"][2]]
            else:
                total[node] = call["DRDISP"][1:]
            off["sum"] = max(off["sum"], math.dist(total[node], call["RDISP"][1:]))
            area += call.one("AREA")
            x, y, _ = bottom[node]
            share = SIDE**2 / 16 * (0.5 if x in (0, SIDE) else 1) * (0.5 if y in (0, SIDE) else 1)
            off["AREA"] = max(off["AREA"], abs(call.one("AREA") / share - 1))
            off["CHRLNGTH"] = max(off["CHRLNGTH"], abs(math.log(call["AREA"][1] / (SIDE / 4))))
        before = nodes
        if key == (1, 2):
            close("arguments: sum of AREA is the area of the slave surface", area, SIDE**2,
                  relative=1e-6)
    shown = {"COORDS": ("COORDS are the slave node's at the end", 1e-6),
             "orthonormal": ("ALOCALDIR is orthonormal", 1e-12),
             "handed": ("ALOCALDIR is right-handed", 1e-12),
             "normal": ("ALOCALDIR(:,1) is the master's outward normal", 1e-6),
             "first": ("ALOCALDIR(:,2) is global x projected on the face", 1e-6),
             "RDISP(1)": ("RDISP(1) is the overclosure of the printed displacements", 1e-6),
             "change": ("DRDISP(1) is the change of RDISP(1)", 1e-12),
             "sum": ("RDISP(2:3) is the sum of DRDISP(2:3), turned by DROT", 1e-12),
             "AREA": ("AREA is a quarter of each adjoining face", 5e-3),
             "CHRLNGTH": ("CHRLNGTH is a length of a face, within a factor of 2", math.log(2.001))}
    for name, (words, limit) in shown.items():
        at_most(f"arguments: {words}", off[name], limit)
    slid = [call["RDISP"][1] for call in ends[2, 2].values()]
    check("arguments: RDISP(2) grows by what the block is slid, less its own shear",
          all(0.8 * ALONG < slip < ALONG for slip in slid), f"{min(slid):.4f} to {max(slid):.4f}")


def rotations(run, calls, deck):
    """DROT turns the slip directions with the body, so that the shear stress turns with it."""
    ends = last_of_increments(calls)
    still = [call["DROT"] for key in ((1, 1), (1, 2), (2, 1), (2, 2))
             for call in ends[key].values()]
    at_most("arguments: DROT is 1 while nothing turns", largest(
        a - b for drot in still for a, b in zip(drot, (1, 0, 0, 1))), 1e-9)
    cosine, sine = math.cos(math.radians(TURN)), math.sin(math.radians(TURN))
    turning = [call["DROT"] for step in (3, 4) for call in ends[step, 1].values()]
    at_most("arguments: DROT is the turn of the increment (columns c s, -s c)", largest(
        a - b for drot in turning for a, b in zip(drot, (cosine, sine, -sine, cosine))), 1e-6)
    # the shear force turns with the blocks, and keeps its size
    forces = {when: run.printed.forces["HIGH_TOP"][when] for when in (2.0, 4.0)}
    axes = [deck.place(axis) for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
    before, after = [[dot(force, axis) for axis in axes] for force in forces.values()]
    cosine, sine = math.cos(math.radians(2 * TURN)), math.sin(math.radians(2 * TURN))
    expected = [cosine * before[0] - sine * before[1], sine * before[0] + cosine * before[1],
                before[2]]
    at_most("arguments: the force turns with the blocks, shear against its size",
            math.dist(after, expected) / math.hypot(*before[:2]), 1e-4)


def arguments(recorder, folder):
    """All of it, from one run."""
    deck = turning_deck()
    run = Run(recorder, folder, "arguments", deck).completed(7)
    calls = recorded_calls(run.folder / "uinter.log")
    high = deck.blocks[1]
    constants(calls, high)
    counters(run, calls, high)
    state(calls)
    places(run, calls, deck)
    rotations(run, calls, deck)
    fields(run, calls)
    reopening(run, calls)
