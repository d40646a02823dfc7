#!/usr/bin/env python3
"""The environment file for gfortran, used as ABAQUS would: each subroutine is compiled and linked by its
words, defines its routine and lacks nothing but ABAQUS' own.

usage: gfortran_environment.py WORK
"""
import pathlib
import re
import subprocess
import sys

READY = pathlib.Path('interface/abaqus/ready')
NEEDED = {'asperity_uinter': 'stdb_abqerr_ xit_', 'asperity_vuinter': 'xplb_abqerr_ xplb_exit_',
          'asperity_vuinter_single': 'xplb_abqerr_ xplb_exit_'}


def words_of(name, replaced):
    """The words of a command, with what ABAQUS puts in; releases differ in whether they name the source."""
    names = {'compile_fortran': ['ifort', '%P']}
    exec((READY / 'environment/linux_gfortran.env').read_text(), names)
    words = [word for word in names[name] if word not in ('%E', '%A', '%L', '%B')]
    for mark, text in replaced.items():
        words = [word.replace(mark, text) for word in words]
    return words


work = pathlib.Path(sys.argv[1]).resolve()
work.mkdir(parents=True, exist_ok=True)
passed = 0
for stem, needed in NEEDED.items():
    routine = re.sub('asperity_|_single', '', stem) + '_'
    for ending in 'for', 'f', 'f90':
        source = (READY / f'{stem}.{ending}').resolve()
        subprocess.run(words_of('compile_fortran', {'%P': str(source), '%I': str(work)}) + ['-o', 'user.o'],
                       cwd=work, check=True)
        subprocess.run(words_of('link_sl', {'%U': 'libuser.so', '%F': 'user.o'}), cwd=work, check=True)
        symbols = subprocess.check_output(['nm', '-D', '--format=posix', 'libuser.so'], cwd=work, text=True)
        defined = re.findall(r'^(\w+) T', symbols, re.M)
        lacking = re.findall(r'^([a-z]\w*_) U', symbols, re.M)
        assert routine in defined, f'{source} does not define {routine}'
        assert sorted(lacking) == needed.split(), f'{source} lacks {lacking}, not {needed}'
        passed += 1
print(f'{passed} passed, 0 failed')
