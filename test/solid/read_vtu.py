#!/usr/bin/env python3
"""What pyvista, and with it ParaView's reader, finds in the files that the solid's tests write.

    read_vtu.py TESTS    runs the program of tests, asperity_solid_tests, which writes them

The fields are those of test/solid/vtu.f90, in closed form; the last line is `N passed, N failed`."""
import os
import subprocess
import sys
import tempfile

import numpy
import pyvista

results = []


def check(name, found, expected):
    """Count an array that is equal but for round-off."""
    found, expected = numpy.asarray(found, float), numpy.asarray(expected, float)
    fine = found.shape == expected.shape and numpy.allclose(found, expected, rtol=1e-14, atol=1e-14)
    results.append(fine)
    print('ok  ' if fine else 'FAIL', name, '' if fine else f'expected {expected} found {found}')


def body(grid, step, name):
    """Two bricks of 2 x 3 x 5 mm, sheared a hundredth a step."""
    x = grid.points
    check(f'{name}: volumes', grid.compute_cell_sizes()['Volume'], [30, 30])
    check(f'{name}: kinds of cells', grid.celltypes, [pyvista.CellType.HEXAHEDRON]*2)
    check(f'{name}: displacement', grid['displacement'],
          0.01*step*numpy.column_stack([x[:, 2], 0*x[:, 0], x[:, 0]]))
    check(f'{name}: part', grid['part'], [1, 2])
    check(f'{name}: stress', grid['stress'],
          4.5*step*numpy.outer([1, -1], [1, 2, 3, 4, 5, 6]))
    check(f'{name}: plastic strain', grid['plastic_strain'], [0.04*step, 0.08*step])


with tempfile.TemporaryDirectory() as folder:
    subprocess.run([os.path.abspath(sys.argv[1])], check=True, stdout=subprocess.DEVNULL,
                   env=os.environ | {'ASPERITY_VTU': folder})
    for step in (1, 2):
        body(pyvista.read(f'{folder}/body_{step}.vtu'), step, f'body, step {step}')
    series = pyvista.get_reader(f'{folder}/body.pvd')
    check('series: times', series.time_values, [0.25, 1.5])
    for step, time in enumerate(series.time_values, 1):
        series.set_active_time_value(time)
        body(series.read()[0], step, f'series, time {time}')

    contact = pyvista.read(f'{folder}/contact.vtu')
    # of the trapezium (0, 0), (6, 0), (3, 6), (0, 3), which is flat
    cells = contact.compute_cell_sizes()['Area']
    check('contact: area', cells.sum(), 22.5)
    corners = contact.points[contact.cells.reshape(9, 5)[:, 1:]]
    across = numpy.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    check('contact: all cells face up', numpy.sign(across[:, 2]), [1]*9)
    number = numpy.arange(1, 10)
    check('contact: pressure', contact['pressure'], 0.5*number)
    check('contact: gap', contact['gap'], -0.01*number)
    check('contact: coverage', contact['coverage'], 0.1*number)
    check('contact: status', contact['status'], 1 + number % 3)
    check('contact: face', contact['face'], [2]*9)
    check('contact: shear', contact['shear'], numpy.arange(1, 28).reshape(9, 3))
    check('contact: displacement', contact['displacement'], 0.01*contact.points)

print(f'{sum(results)} passed, {len(results) - sum(results)} failed')
sys.exit(not all(results))
