#!/usr/bin/env python3
"""Tests of interface/calculix/check_source.f90: what build is told of a file with a UINTER. What is
read from sources is tested in test/check.

usage: test_source.py PROGRAM      prints `N passed, N failed` at the end. Types are looked at by
gfortran.
"""

import os
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "data", "uinter")
PROGRAM = os.path.abspath(sys.argv[1])
COMPILER = shutil.which("gfortran") or "true"
FIXED = "-ffixed-form -ffixed-line-length-none\n"
FREE = "-ffree-form -ffree-line-length-none\n"
# ABAQUS' list, as its manual has it; not from the file that is tested
NAMES = ("STRESS DDSDDR AMKI AMSKI FLUX DDFDDT DDSDDT DDFDDR STATEV SED SFD SPD SVD SCD PNEWDT RDISP "
         "DRDISP TEMP DTEMP PREDEF DPRED TIME DTIME FREQR CINAME SLNAME MSNAME PROPS COORDS ALOCALDIR "
         "DROT AREA CHRLNGTH NODE NDIR NSTATV NPRED NPROPS MCRD KSTEP KINC KIT LINPER LOPENCLOSE "
         "LSTATE LSDI LPRINT").split()
BODY = """      INCLUDE 'ABA_PARAM.INC'
      CHARACTER*80 CINAME,SLNAME,MSNAME
      DIMENSION STRESS(NDIR),DDSDDR(NDIR,NDIR),RDISP(NDIR),PROPS(NPROPS)
      STRESS(1)=PROPS(1)*RDISP(1)
      DDSDDR(1,1)=PROPS(1)
      END
"""
COUNTS = {True: 0, False: 0}


def check(name, good, seen):
    COUNTS[bool(good)] += 1
    print(f"{'ok  ' if good else 'FAIL'} {name}" + ("" if good else f"\n     | {seen}"))


def fixed(names, body=BODY):
    """A UINTER in fixed form, six arguments a line."""
    rows = [",".join(names[i:i + 6]) for i in range(0, len(names), 6)]
    return "      SUBROUTINE UINTER(" + ",\n     &".join(rows) + ")\n" + body


def free(names, body=BODY):
    return fixed(names, body).replace(",\n     &", ", &\n   ")


def look(path, folder="."):
    """(status, options, words) of the program."""
    done = subprocess.run([PROGRAM, path, COMPILER, folder], capture_output=True, text=True,
                          check=False)
    return done.returncode, done.stdout, done.stderr


def accepted(name, path, options, notice=""):
    status, said, words = look(path)
    check(name, status == 0 and said == options and (words == "" if notice == "" else
                                                     notice in words), (status, said, words))


def refused(name, path, text):
    status, said, words = look(path)
    check(name, status == 1 and said == "" and text in words, (status, said, words))


def write(name, text):
    with open(name, "w", encoding="ascii") as file:
        file.write(text)
    return name


def forms():
    accepted("fixed form", write("a.f", fixed(NAMES)), FIXED)
    accepted("free form", write("a.f90", free(NAMES)), FREE)
    accepted("a preprocessor's lines", write("b.f", "#define ONE 1\n" + fixed(NAMES)),
             FIXED.replace("\n", " -cpp\n"))
    accepted("freeform.for", os.path.join(DATA, "freeform.for"), FREE)
    accepted("uexternaldb.for", os.path.join(DATA, "uexternaldb.for"), FIXED)
    accepted("another name is told", write("l.f", fixed(NAMES).replace("FREQR", "FRQ")), FIXED,
             "FRQ; ABAQUS has FREQR")
    for name in ("aba_param.inc", "ABA_PARAM.INC"):
        with open(name, encoding="ascii") as file:
            text = file.read()
        check(name, "implicit real*8(a-h,o-z)" in text and "nprecd=2" in text, text)


def folders():
    folder = "a b's & $x"
    os.mkdir(folder)
    write(os.path.join(folder, "body.inc"), fixed(NAMES))
    path = write(os.path.join(folder, "own.f"), "      INCLUDE 'body.inc'\n")
    for file in (path, os.path.abspath(path)):
        status, said, words = look(file, folder)
        check(f"a file that includes it, in a folder of odd letters: {file}",
              (status, said, words) == (0, FIXED, ""), (status, said, words))


def refusals():
    refused("28 arguments", os.path.join(DATA, "args28.for"),
            "argument 1, line 2: S of 28 arguments; ABAQUS has STRESS of 47 arguments.")
    refused("44 arguments", os.path.join(DATA, "args44.for"), "argument 3, line 1: FLUX of 44 arguments")
    names = list(NAMES)
    names[15], names[16] = names[16], names[15]
    refused("two exchanged", write("p.f", fixed(names)),
            "argument 16, line 1: DRDISP, which is argument 17 of ABAQUS; ABAQUS has RDISP.")
    refused("VUINTER alone", write("r.f", fixed(NAMES[:40]).replace("UINTER", "VUINTER")),
            "no subroutine UINTER but VUINTER")
    refused("two of them", write("s.f", fixed(NAMES) + fixed(NAMES)), "2 subroutines UINTER")
    refused("no Fortran", write("t.txt", fixed(NAMES)), "no Fortran by its ending")
    refused("no file", "none.f", "cannot read none.f")


def types():
    if COMPILER == "true":
        print("skip types: no gfortran")
        return
    lines = BODY.splitlines(keepends=True)
    for name, form in (("u.f", fixed), ("u.f90", free)):
        refused(f"single precision, for want of the include, {name}", write(name, form(
            NAMES, "".join(lines[1:]))), "STRESS REAL(4)")
    integer = lines[0] + "      INTEGER AREA\n" + "".join(lines[1:-1]) + "      STRESS(1)=AREA\n      END\n"
    refused("an integer that is a real", write("v.f", fixed(NAMES, integer)),
            "types of arguments, line 1: AREA INTEGER(4); ABAQUS has AREA REAL(8).")
    accepted("names that are not declared and not used", write("w.f", fixed(
        NAMES, "".join(lines[:1] + lines[2:]))), FIXED)
    accepted("calls of its own with other types", write("x.f", fixed(NAMES) + (
        "      SUBROUTINE OTHER\n      CALL UINTER(" + ",\n     &".join(["1"]*47) + ")\n      END\n")),
        FIXED)


def main():
    with tempfile.TemporaryDirectory(prefix="asperity-source-") as folder:
        os.chdir(folder)
        for test in (forms, folders, refusals, types):
            test()
        os.chdir("/")
    print(f"{COUNTS[True]} passed, {COUNTS[False]} failed")
    return COUNTS[False] > 0


if __name__ == "__main__":
    sys.exit(main())
