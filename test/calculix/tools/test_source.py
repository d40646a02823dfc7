#!/usr/bin/env python3
"""Tests of interface/calculix/tools/source.py: which files have a UINTER with ABAQUS' arguments.

usage: test_source.py      prints `N passed, N failed` at the end. Types are looked at by gfortran.
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
SOURCE = os.path.join(HERE, "..", "..", "..", "interface", "calculix", "tools", "source.py")
DATA = os.path.join(HERE, "..", "..", "data", "uinter")
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


def fixed(names, begin="      SUBROUTINE UINTER(", go_on="     &", body=BODY):
    """A UINTER in fixed form, six arguments a line."""
    rows = [",".join(names[i:i + 6]) for i in range(0, len(names), 6)]
    return begin + f",\n{go_on}".join(rows) + ")\n" + body


def look(path):
    """(status, options, words) of source.py."""
    done = subprocess.run([sys.executable, SOURCE, path, shutil.which("gfortran") or "true", "."],
                          capture_output=True, text=True, check=False)
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


def swapped(a, b):
    """The list with two names exchanged."""
    names = list(NAMES)
    i, j = names.index(a), names.index(b)
    names[i], names[j] = names[j], names[i]
    return names


def forms():
    free = re.sub(r",\n     &", ", &\n   ", fixed(NAMES).lower())
    for name, file, text, options in (
            ("fixed form", "a.f", fixed(NAMES), FIXED),
            ("a .for", "a.for", fixed(NAMES), FIXED),
            ("digits continue, comments between", "b.f", "C  subroutine uinter(nothing)\n"
             + fixed(NAMES, go_on="C    a comment ('\n!\n     2 "), FIXED),
            ("labels of one digit", "x.f", " 5   CONTINUE\n      END\n" + fixed(NAMES), FIXED),
            ("tabs", "c.f", fixed(NAMES, "\tSUBROUTINE UINTER(", "\t1"), FIXED),
            ("blanks in names, as fixed form allows", "d.f",
             fixed(NAMES, "      SUB ROUTINE  U INTER  ("), FIXED),
            ("a comment behind each line", "e.f", fixed(NAMES, go_on="     & ").replace(
                ",\n", ", ! (one, two)\n"), FIXED),
            ("a line beyond 72 columns", "f.f", fixed(NAMES).replace(",\n     &", ","), FIXED),
            ("free form", "a.f90", free, FREE),
            ("free form, & at the beginning too", "b.f90", free.replace("&\n   ", "&\n !\n  & "), FREE),
            ("free form beyond 132 columns", "c.f90", free.replace("&\n", ""), FREE),
            ("recursive", "d.f90", free.replace("subroutine", "recursive subroutine"), FREE),
            ("free form by directive", "g.for", "!DIR$ FREEFORM\n" + free, FREE),
            ("free form by the older directive", "h.f", "!dec$ freeform\n" + free, FREE),
            ("fixed form by directive", "e.f90", "!DIR$ NOFREEFORM\n" + fixed(NAMES), FIXED),
            ("a preprocessor's lines", "i.f", "#define ONE 1\n" + fixed(NAMES), FIXED.replace(
                "\n", " -cpp\n")),
            ("names of newer manuals", "j.f", fixed(NAMES).replace("SLNAME", "SECNAME").replace(
                "MSNAME", "MAINNAME").replace("AMKI", "DVISCOUS").replace("AMSKI", "DSTRUCTURAL"),
             FIXED)):
        accepted(name, write(file, text), options)
    write("body.inc", fixed(NAMES))
    accepted("a file that includes it", write("k.f", "      INCLUDE 'body.inc'\n"), FIXED)
    accepted("freeform.for", os.path.join(DATA, "freeform.for"), FREE)
    accepted("uexternaldb.for", os.path.join(DATA, "uexternaldb.for"), FIXED)
    accepted("another name is told", write("l.f", fixed(NAMES).replace("FREQR", "FRQ")), FIXED,
             "FRQ for FREQR")


def lists():
    refused("28 arguments", os.path.join(DATA, "args28.for"),
            "28 arguments; ABAQUS and CalculiX call it with 47: argument 1 is S, it should be STRESS")
    refused("44 arguments", os.path.join(DATA, "args44.for"), "44 arguments, the list of releases up "
            "to 6.6, without DVISCOUS, DSTRUCTURAL and FREQR; ABAQUS and CalculiX call it with 47: "
            "argument 3 is FLUX, it should be DVISCOUS")
    refused("one too few", write("m.f", fixed(NAMES[:-1])), "46 arguments; ABAQUS and CalculiX call "
            "it with 47: argument 47 is missing, it should be LPRINT")
    refused("one too many", write("n.f", fixed([*NAMES, "MORE"])), "48 arguments; ABAQUS and CalculiX "
            "call it with 47: argument 48, MORE, is one too many")
    refused("none", write("o.f", "      SUBROUTINE UINTER\n" + BODY), "0 arguments")
    refused("two exchanged", write("p.f", fixed(swapped("RDISP", "DRDISP"))),
            "argument 16 of UINTER is DRDISP, which ABAQUS has as argument 17; its 16 is RDISP")
    refused("two others exchanged, by their older names", write("q.f", fixed(
        swapped("AMKI", "AMSKI"))), "argument 3 of UINTER is AMSKI, which ABAQUS has as argument 4")
    refused("VUINTER alone", write("r.f", fixed(NAMES[:40]).replace("UINTER", "VUINTER")),
            "no subroutine UINTER but VUINTER")
    refused("no UINTER", write("s.f", "      SUBROUTINE UINTERS(A)\n      END\n"),
            "no subroutine UINTER\n")
    refused("no Fortran", write("t.txt", fixed(NAMES)), "neither Fortran by its ending")


def types():
    if not shutil.which("gfortran"):
        print("skip types: no gfortran")
        return
    lines = BODY.splitlines(keepends=True)
    refused("single precision, for want of the include", write("u.f", fixed(
        NAMES, body="".join(lines[1:]))), "STRESS is REAL(4), not REAL(8)")
    refused("an integer that is a real", write("v.f", fixed(NAMES, body=lines[0] + "      INTEGER AREA\n"
            + "".join(lines[1:-1]) + "      STRESS(1)=AREA\n      END\n")), "AREA is INTEGER(4)")
    accepted("names that are not declared and not used", write("w.f", fixed(
        NAMES, body="".join(lines[:1] + lines[2:]))), FIXED)


def main():
    with tempfile.TemporaryDirectory(prefix="asperity-source-") as folder:
        os.chdir(folder)
        for test in (forms, lists, types):
            test()
        os.chdir("/")
    print(f"{COUNTS[True]} passed, {COUNTS[False]} failed")
    return COUNTS[False] > 0


if __name__ == "__main__":
    sys.exit(main())
