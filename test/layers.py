#!/usr/bin/env python3
"""Whether `use` only leads down: no arrow to a layer above or beside, no module whose name is not
its path, no folder of more than 15 files, and no library that uses its own face."""
import collections
import pathlib
import re
import subprocess

# Below comes first; folders of one line know nothing of each other
LAYERS = ['base', 'paper', 'law wood', 'faces', 'contact',
          'abaqus c height_map hysteresis', 'replay surface', 'deck fit check', 'solid frame calculix',
          'program/system', 'program/input', 'program/plot', 'program/report', 'program/record', 'program/commands', 'program', 'app']
RANK = {folder: rank for rank, line in enumerate(LAYERS) for folder in line.split()}
MOST_FILES = 15
FACE = pathlib.Path('src/asperity.f90')

files = [pathlib.Path(name) for name in subprocess.check_output(
    ['git', 'ls-files', '--cached', '--others', '--exclude-standard', 'src', 'interface', 'app'],
    text=True).split() if pathlib.Path(name).is_file()]
# interface/abaqus/ready is made of the others
sources = [path for path in files if path.suffix == '.f90' and 'ready' not in path.parts]
failures, checked = [], 0


def check(fine, message):
    """Count, and remember what failed."""
    global checked
    checked += 1
    if not fine:
        failures.append(message)


def layer(path):
    """The longest known folder that a path begins with."""
    parts = path.parts if path.parts[0] == 'app' else path.parts[1:]
    return next((folder for n in range(len(parts) - 1, 0, -1)
                 if (folder := '/'.join(parts[:n])) in RANK), None)


texts = {path: path.read_text() for path in sources}
home = {}
for path, text in texts.items():
    for module in re.findall(r'^module (?!procedure)(\w+)', text, re.M):
        home[module] = path
        # Fortran of interface/calculix and interface/abaqus is all in one folder each
        parts = [part for part in path.with_suffix('').parts[1:] if part not in ('glue', 'routines')]
        check(module == '_'.join(['asperity'] + parts) or path == FACE,
              f'{path}: module {module}')
for path, text in texts.items():
    if path == FACE:
        continue
    own = layer(path)
    check(own is not None, f'{path}: in no layer')
    for used in re.findall(r'^ *use (asperity\w*)', text, re.M):
        if used == 'asperity':
            check(own == 'app', f'{path} uses the face of the library it is of')
            continue
        other = layer(home[used]) if used in home else None
        check(other is not None and own is not None
              and (own == other or RANK[own] > RANK[other]), f'{path} ({own}) uses {used} ({other})')
for folder, number in collections.Counter(path.parent for path in files).items():
    check(number <= MOST_FILES, f'{folder}: {number} files')
for failure in failures:
    print('FAIL', failure)
print(f'{checked - len(failures)} passed, {len(failures)} failed')
raise SystemExit(bool(failures))
