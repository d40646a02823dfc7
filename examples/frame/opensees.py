#!/usr/bin/env python3
"""The frame of two_columns.nml in OpenSees: elastic columns and beam, a rotational spring a joint with the material
that `asperity solid --opensees joint.py` has made of the single joint; base shear beside that of `asperity frame`.

    asperity frame two_columns.nml --contact rough --csv frame.csv
    asperity solid joint.nml --opensees joint.py
    python opensees.py frame.csv joint.py
"""
import csv
import importlib.util
import sys

import openseespy.opensees as ops

# kN, m, rad; whole sections of two_columns.nml
HEIGHT, SPAN, LEVEL, DEPTH, LOAD = 3.0, 2.1, 2.0, 0.3, 54.0
MODULUS, SHEAR, RIGID = 3727.12e3, 280.32e3, 1.0e3
# The material has the bending of the single joint's column too: elastic columns count it twice, rigid ones once
COLUMNS = {'elastic': 1.0, 'rigid': RIGID}


def read_frame(path):
    """Sway in m and base shear in kN of every increment of the rough law."""
    with open(path) as file:
        rows = list(csv.reader(line for line in file if not line.startswith('#')))
    names = [name.split(' ')[0] for name in rows[0]]
    rows = [dict(zip(names, row)) for row in rows[1:]]
    return [(float(row['sway'])/1e3, float(row['base_shear'])/1e3) for row in rows if row['model'] == 'rough']


def build(joint, stiffer):
    """Columns on hinges, P-delta; from column axis to the spring at mid-span the beam is rigid, as the material, which
    is displacement over arm, has all that bends between the column and the load point."""
    ops.wipe()
    ops.model('basic', '-ndm', 2, '-ndf', 3)
    ops.geomTransf('PDelta', 1)
    area, inertia = DEPTH**2, DEPTH**4/12
    for side, x in enumerate((0.0, SPAN)):
        base = 10*side
        for node, z in ((1, 0.0), (2, LEVEL), (3, HEIGHT), (4, LEVEL)):
            ops.node(base + node, x, z)
        ops.fix(base + 1, 1, 1, 0)
        for element, (i, j) in enumerate(((1, 2), (2, 3))):
            ops.element('ElasticTimoshenkoBeam', base + element + 1, base + i, base + j, stiffer*MODULUS, stiffer*SHEAR,
                        area, inertia, area*5/6, 1)
        joint(100 + 10*side)
        ops.equalDOF(base + 2, base + 4, 1, 2)
        ops.element('zeroLength', base + 5, base + 2, base + 4, '-mat', 100 + 10*side, '-dir', 6)
    # x of the beam is held by one column only, as friction holds it
    ops.element('elasticBeamColumn', 50, 4, 14, area, RIGID*MODULUS, RIGID*inertia, 1)
    ops.timeSeries('Constant', 1)
    ops.pattern('Plain', 1, 1)
    for head in (3, 13):
        ops.load(head, 0.0, -LOAD, 0.0)


def solve(sway):
    """Base shear along a path of the sway of both heads."""
    ops.timeSeries('Path', 2, '-time', *range(len(sway)), '-values', *sway)
    ops.pattern('Plain', 2, 2)
    for head in (3, 13):
        ops.sp(head, 1, 1.0)
    ops.constraints('Transformation')
    ops.numberer('RCM')
    ops.system('BandGeneral')
    ops.test('NormDispIncr', 1e-8, 100)
    ops.algorithm('Newton')
    ops.integrator('LoadControl', 0.05)
    ops.analysis('Static')
    steps, shear = 20, [0.0]
    for _ in sway[1:]:
        if ops.analyze(steps):
            raise SystemExit('OpenSees finds no equilibrium')
        ops.reactions()
        shear.append(-sum(ops.nodeReaction(foot, 1) for foot in (1, 11)))
    return shear


def work(sway, shear):
    """Of a path, by trapezoids."""
    return sum(0.5*(f + g)*(y - x) for x, y, f, g in zip(sway, sway[1:], shear, shear[1:]))


def main():
    """Compare."""
    frame = [(0.0, 0.0)] + read_frame(sys.argv[1])
    sway, solid = zip(*frame)
    spec = importlib.util.spec_from_file_location('joint', sys.argv[2])
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    found = {}
    for columns, stiffer in COLUMNS.items():
        build(module.joint_material, stiffer)
        found[columns] = solve(sway)
    print('sway (mm), base shear (kN), in OpenSees (kN): columns', ', '.join(COLUMNS))
    for x, force, *others in zip(sway, solid, *found.values()):
        print(f'{1e3*x:.1f}, {force:.2f}, ' + ', '.join(f'{other:.2f}' for other in others))
    largest = max(map(abs, solid))
    for columns, shear in found.items():
        peaks = [other/force for force, other in zip(solid, shear) if abs(force) > 0.9*largest]
        difference = (sum((force - other)**2 for force, other in zip(solid, shear))/len(solid))**0.5
        print(f'{columns} columns: peaks over those of the solid ' + ', '.join(f'{peak:.2f}' for peak in peaks)
              + f'; energy of the cycle over its {work(sway, shear)/work(sway, solid):.2f}'
              + f'; root mean square difference {100*difference/largest:.1f} % of the largest base shear')


if __name__ == '__main__':
    main()
