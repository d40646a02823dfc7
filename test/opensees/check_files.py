#!/usr/bin/env python3
"""Whether openseespy finds in the files that asperity writes what asperity says it will:
check_files.py ASPERITY FOLDER

Energy of every cycle and force at every peak, for each material, of records in mm and in rad, from
the file in Python and, where Python has Tcl, from that in Tcl; and whether the least steps of half
a cycle that a file states give the energies to 1 %. The last line is `N passed, N failed`."""
import contextlib
import importlib.util
import json
import os
import pathlib
import subprocess
import sys

import openseespy.opensees as ops

# Steps at which asperity compares, and how far openseespy may be off, over the record's largest
FINE, TOLERANCE = 200, 1e-9
passed, failed = 0, 0


def check(fine, message):
    """Count, and say what failed."""
    global passed, failed
    passed, failed = passed + bool(fine), failed + (not fine)
    if not fine:
        print('FAIL', message)


def cycles_of(rows):
    """Energy of each cycle, and force where it is furthest out on each side."""
    energy, tips = {}, {}
    for (_, x0, f0), (cycle, x1, f1) in zip(rows, rows[1:]):
        energy[cycle] = energy.get(cycle, 0.0) + 0.5*(f0 + f1)*(x1 - x0)
        for side, x in (('positive', x1), ('negative', -x1)):
            if x > tips.get((cycle, side), (0.0, 0.0))[0]:
                tips[cycle, side] = (x, f1)
    return energy, {key: force for key, (_, force) in tips.items()}


def rows_of_python(path, steps):
    """What a file in Python replays."""
    spec = importlib.util.spec_from_file_location('written', path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.replay(steps) if steps else module.replay()


def rows_of_tcl(path, steps):
    """What a file in Tcl replays, its commands given to openseespy."""
    import tkinter
    tcl, out = tkinter.Tcl(), []

    def number(word):
        try:
            return int(word)
        except ValueError:
            try:
                return float(word)
            except ValueError:
                return word

    def command(name):
        def run(*words):
            answer = getattr(ops, name)(*map(number, words))
            return repr(answer) if answer is not None else ''
        return run

    for name in ('wipe', 'uniaxialMaterial', 'testUniaxialMaterial', 'setStrain', 'getStress'):
        tcl.createcommand(name, command(name))
    tcl.createcommand('puts', lambda line: out.append(line) or '')
    tcl.setvar('argv0', 'none')
    tcl.eval(path.read_text())
    tcl.eval(f'replay {steps}')
    return [(int(c), float(x), float(f)) for c, x, f in (line.split(',') for line in out[1:])]


def compare(name, table, rows):
    """The table that asperity gives, and what openseespy does."""
    energy, tips = cycles_of(rows)
    largest = max(map(abs, table['material_energy']))
    for cycle, expected in zip(table['cycle'], table['material_energy']):
        check(abs(energy[cycle] - expected) <= TOLERANCE*largest,
              f'{name}: energy of cycle {cycle} is {energy[cycle]:.12g}, not {expected:.12g}')
        for side in ('positive', 'negative'):
            force = table[side + '_material'][table['cycle'].index(cycle)]
            if force is None:
                continue
            strongest = max(abs(f) for f in table[side + '_material'] if f is not None)
            check(abs(tips[cycle, side] - force) <= TOLERANCE*strongest,
                  f'{name}: peak of cycle {cycle} is {tips[cycle, side]:.12g}, not {force:.12g}')


def check_record(asperity, folder, name, arguments, material):
    """Write a material, replay it."""
    path, result = folder/f'{name}.py', folder/f'{name}.json'
    run = subprocess.run([asperity, *arguments, '--opensees-material', material, '--opensees', path,
                          '--json', result], capture_output=True, text=True)
    check(run.returncode == 0, f'{name}: {run.stderr}')
    if run.returncode:
        return
    tables = json.loads(result.read_text())
    table = tables['opensees_cycles']
    chosen = tables['opensees']
    row = chosen['written'].index('yes')
    compare(name, table, rows_of_python(path, FINE))
    energy, _ = cycles_of(rows_of_python(path, None))
    for cycle, fine, error in zip(table['cycle'], table['material_energy'], table['energy_error']):
        if error is not None and chosen['material'][row] != 'elastic_gap':
            check(abs(energy[cycle] - fine) <= 0.0101*abs(fine),
                  f'{name}: the least steps give {energy[cycle]:.6g} in cycle {cycle},'
                  f' not {fine:.6g}')
    with contextlib.suppress(ImportError):
        import tkinter  # noqa: F401
        run = subprocess.run([asperity, *arguments, '--opensees-material', material, '--opensees',
                              path.with_suffix('.tcl')], capture_output=True, text=True)
        check(run.returncode == 0, f'{name}.tcl: {run.stderr}')
        compare(f'{name}.tcl', table, rows_of_tcl(path.with_suffix('.tcl'), FINE))
    print(f'{name}: {chosen["material"][row]}, energies within {chosen["energy_error"][row]:.1f} %,'
          f' peaks within {chosen["peak_error"][row]:.1f} % of the record')


def main():
    asperity, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    loops = folder/'loops.csv'
    subprocess.run([asperity, 'tenon', 'examples/tenon_joint/base.nml', '--csv', loops],
                   check=True, capture_output=True)
    rough = ['hysteresis', loops, '--where', 'model=rough']
    check_record(asperity, folder, 'joint_best', rough, 'best')
    for material in ('pinching4', 'elastic_gap'):
        check_record(asperity, folder, f'rotation_{material}', rough + ['--quantity', 'moment'],
                     material)
    check_record(asperity, folder, 'tenon', ['tenon', 'examples/tenon_joint/base.nml'],
                 'dowel_type')
    # strength is lost inside an excursion
    check_record(asperity, folder, 'falling', ['hysteresis', 'test/data/records/peak_inside.csv'],
                 'best')
    print(f'{passed} passed, {failed} failed')
    return failed > 0


if __name__ == '__main__':
    status = main()
    # a last word of openseespy's on standard error would stand behind the counts
    sys.stdout.flush()
    os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
    raise SystemExit(status)
