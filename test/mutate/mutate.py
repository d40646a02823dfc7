#!/usr/bin/env python3
"""Do the tests see a change? N random single changes of the sources in the folders of suites.py,
one at a time: compiled in a copy of the tree, then the suites of its folder run until one fails.

   test/mutate/mutate.py [N] [--seed SEED] [--only PATH] [--again]

N is 10, the seed a new one. The same seed draws the same changes, a quarter of each kind of
fortran.py; --only draws from the files that start so. What was found is kept in
build/mutate/results.csv and not sought again; --again runs those that survived once more. A change
that does not compile does not count, and another one is drawn. Status 1 if any survived."""

import argparse
import csv
import hashlib
import json
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import time
from itertools import chain, zip_longest
from pathlib import Path

from fortran import KINDS, mutants_of
from suites import FOLDERS, suites_of

ROOT = Path(__file__).resolve().parents[2]
WORK = ROOT / 'build' / 'mutate'
TREE, BUILD, RESULTS = WORK / 'tree', WORK / 'build', WORK / 'results.csv'
FIELDS = ['id', 'seed', 'file', 'line', 'before', 'after', 'outcome', 'suite', 'seconds']
# A mutant may ask for any memory and write without end
MEMORY, DISC = 8 << 30, 1 << 30


def fail(message):
    sys.exit(f'mutate: error: {message}')


def copy_tree():
    """Bring the copy up to date; files that are the same keep their time, so that no more than what
    changed is compiled."""
    listed = subprocess.run(['git', 'ls-files', '-co', '--exclude-standard'], cwd=ROOT, text=True,
                            capture_output=True, check=True).stdout.splitlines()
    wanted = {name for name in listed if os.path.lexists(ROOT / name)}
    for folder, _, names in os.walk(TREE):
        for name in names:
            path = Path(folder, name)
            if str(path.relative_to(TREE)) not in wanted:
                path.unlink()
    for name in wanted:
        source, copy = ROOT / name, TREE / name
        copy.parent.mkdir(parents=True, exist_ok=True)
        if source.is_symlink():
            if not (copy.is_symlink() and os.readlink(copy) == os.readlink(source)):
                copy.unlink(missing_ok=True)
                copy.symlink_to(os.readlink(source))
        elif not copy.is_file() or copy.read_bytes() != source.read_bytes():
            shutil.copyfile(source, copy)
            shutil.copymode(source, copy)


def limit():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_FSIZE, (DISC, DISC))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def build_copy():
    """Configure and build the copy, and find the tests: their commands and folders."""
    log = subprocess.run(
        ['cmake', '-S', TREE, '-B', BUILD, '-G', 'Ninja', '-DBUILD_TESTING=ON',
         '-DASPERITY_BUILD_PROGRAM=OFF', '-DASPERITY_BUILD_BENCH=OFF', '-DCMAKE_BUILD_TYPE=None',
         '-DCMAKE_Fortran_COMPILER=gfortran',
         '-DCMAKE_Fortran_FLAGS=-O1 -fcheck=bounds -w'], text=True, capture_output=True)
    if log.returncode:
        fail('the copy cannot be configured:\n' + log.stdout + log.stderr)
    print('mutate: building the copy in build/mutate', flush=True)
    complaint = build()
    if complaint:
        fail('the copy does not compile:\n' + complaint[-3000:])
    listed = subprocess.run(['ctest', '--test-dir', BUILD, '--show-only=json-v1'], text=True,
                            capture_output=True, check=True).stdout
    tests = {}
    for test in json.loads(listed)['tests']:
        folder = [p['value'] for p in test['properties'] if p['name'] == 'WORKING_DIRECTORY']
        tests[test['name']] = (test['command'], folder[0] if folder else BUILD)
    missing = {s for f in FOLDERS for s in suites_of(f + '/')} - set(tests)
    if missing:
        fail('suites.py names tests that ctest does not know: ' + ', '.join(sorted(missing)))
    return tests


def build(*targets):
    """Build programs, all when none is named; what the compiler said if that fails."""
    log = subprocess.run(['cmake', '--build', BUILD, '--target', *(targets or ['all'])], text=True,
                         capture_output=True)
    return '' if log.returncode == 0 else log.stdout + log.stderr


def run_suite(command, folder, longest):
    """Run a test: passed, timeout, or what failed first, at which it is stopped."""
    process = subprocess.Popen(
        command, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT, start_new_session=True, preexec_fn=limit,
        env={**os.environ, 'GFORTRAN_UNBUFFERED_ALL': '1'})
    late = []

    def stop(*_):
        late.append(True)
        os.killpg(process.pid, signal.SIGKILL)

    # the clock runs also while the test says nothing
    signal.signal(signal.SIGALRM, stop)
    signal.alarm(int(longest))
    try:
        for line in process.stdout:
            if line.startswith(b'FAIL'):
                return line.decode(errors='replace').strip()[5:]
        status = process.wait()
    finally:
        signal.alarm(0)
        if process.poll() is None:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
    if late:
        return 'timeout'
    return 'passed' if status == 0 else f'status {status}'


def measure(tests):
    """Seconds that each suite takes when nothing is changed; all must pass."""
    suites = sorted({s for f in FOLDERS for s in suites_of(f + '/')})
    seconds = {}
    for suite in suites:
        start = time.monotonic()
        found = run_suite(*tests[suite], 3600)
        seconds[suite] = time.monotonic() - start
        if found != 'passed':
            fail(f'{suite} fails without a change: {found}')
    return seconds


def try_mutant(mutant, tests, seconds):
    """Outcome of a mutant, and the suite that saw it."""
    path = TREE / mutant.file
    source = path.read_text()
    lines = source.split('\n')
    lines[mutant.first:mutant.last + 1] = mutant.lines
    suites = suites_of(mutant.file)
    path.write_text('\n'.join(lines))
    try:
        for suite in suites:
            if build(Path(tests[suite][0][0]).name):
                return 'not compiled', ''
            found = run_suite(*tests[suite], 30 + 5 * seconds[suite])
            if found == 'timeout':
                return 'timeout', suite
            if found != 'passed':
                return 'killed', f'{suite}: {found}'
        return 'survived', ''
    finally:
        path.write_text(source)


def draw(seed, only):
    """All mutants in the order of a seed, the kinds in turn. Each has its place by itself, so that
    changes of other lines do not move it."""
    def place(mutant):
        return hashlib.sha256(f'{seed} {mutant.id}'.encode()).digest()

    found = [mutant for path in sorted(TREE.rglob('*.f90'))
             for name in [str(path.relative_to(TREE))]
             if suites_of(name) and name.startswith(only) and not path.is_symlink()
             for mutant in mutants_of(name, path.read_text())]
    by_kind = [sorted((m for m in found if m.kind == kind), key=place) for kind in KINDS]
    return [m for m in chain.from_iterable(zip_longest(*by_kind)) if m]


def read_results():
    if not RESULTS.exists():
        return {}
    with RESULTS.open(newline='') as file:
        return {row['id']: row for row in csv.DictReader(file)}


def keep(row):
    new = not RESULTS.exists()
    with RESULTS.open('a', newline='') as file:
        writer = csv.DictWriter(file, FIELDS)
        if new:
            writer.writeheader()
        writer.writerow(row)


def report(rows):
    survivors = [row for row in rows if row['outcome'] == 'survived']
    for row in survivors:
        print(f"\n{row['file']}:{row['line']}\n   - {row['before']}\n   + {row['after']}")
    print(f'\n{len(survivors)} of {len(rows)} survived '
          f'({100 * len(survivors) / max(len(rows), 1):.0f} %)')
    return 1 if survivors else 0


def main():
    parser = argparse.ArgumentParser(prog='./run mutate', description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('number', nargs='?', type=int, default=10)
    parser.add_argument('--seed', default=str(random.SystemRandom().randrange(10**6)))
    parser.add_argument('--only', default='')
    parser.add_argument('--again', action='store_true')
    options = parser.parse_args()
    print(f'mutate: seed {options.seed}', flush=True)
    WORK.mkdir(parents=True, exist_ok=True)
    copy_tree()
    tests = build_copy()
    known = read_results()
    seconds = None
    rows = []
    for mutant in draw(options.seed, options.only):
        if len(rows) >= options.number:
            break
        row = known.get(mutant.id)
        if row is None or (options.again and row['outcome'] == 'survived'):
            seconds = seconds or measure(tests)
            start = time.monotonic()
            outcome, suite = try_mutant(mutant, tests, seconds)
            row = dict(zip(FIELDS, [
                mutant.id, options.seed, mutant.file, mutant.first + 1, mutant.before, mutant.after,
                outcome, suite, f'{time.monotonic() - start:.0f}']))
            keep(row)
            print(f"{outcome:12} {row['seconds']:>4} s  {mutant.file}:{row['line']}  {suite}",
                  flush=True)
        if row['outcome'] != 'not compiled':
            rows.append(row)
    return report(rows)


if __name__ == '__main__':
    sys.exit(main())
