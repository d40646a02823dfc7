#!/usr/bin/env bash
# openseespy 3.7.1.2: Pinching4 with rForce = uForce = 0, fully pinched, gives energy in every cycle.
#
# A good guess: a joint with slack is unloaded to nothing and reloads from nothing, which is rForce = 0 and
# uForce = 0, and a cycle of constant amplitude takes little energy. Seen: with rForce = 0.01 a cycle takes 23.44,
# with 0 it gives 145.15. Where rForce is no larger than uForce pinching is gone as well: at 0.05 and 0.05 a cycle
# takes nothing, at 0.30 and 0.05 it takes 83.34.
source "$(dirname "$0")/lib/setup.sh"
python_packages openseespy==3.7.1.2
expect '23.44 -145.15 0.00 83.34' "$("$python" - 2>/dev/null <<'PY'
import openseespy.opensees as ops


def energy(reload_force, unload_force):
    """Work of the third cycle between 6 and -6."""
    points = [10.0, 1.0, 16.0, 4.0, 20.0, 8.0, 21.0, 20.0]
    pinching = [0.5, reload_force, unload_force]
    ops.wipe()
    ops.uniaxialMaterial("Pinching4", 1, *points, *(-x for x in points), *pinching, *pinching,
                         *[0.0]*15, 10.0, "cycle")
    ops.testUniaxialMaterial(1)
    work, x, force = 0.0, 0.0, 0.0
    for turn, end in enumerate([6.0, -6.0]*3 + [6.0]):
        begin = x
        for step in range(1, 601):
            before, x = x, begin + (end - begin)*step/600
            ops.setStrain(x)
            new = ops.getStress()
            if turn > 4:
                work += 0.5*(force + new)*(x - before)
            force = new
    return work


pairs = (0.01, 0.0), (0.0, 0.0), (0.05, 0.05), (0.3, 0.05)
print(*(f"{round(energy(*pair), 2) + 0.0:.2f}" for pair in pairs))
PY
)"
