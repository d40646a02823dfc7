#!/usr/bin/env python3
"""What build needs to know of a Fortran file with a UINTER: its form, and whether the arguments are
ABAQUS'.

usage: source.py FILE COMPILER FOLDER

Prints the compiler's options for the form of the file, and notices on standard error; writes what
user subroutines include, ABA_PARAM.INC, into FOLDER. Exit status 1, and what is wrong on standard
error, for a file whose UINTER ABAQUS would call otherwise.
"""

import os
import re
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
FIXED = (".f", ".for", ".ftn", ".f77", ".fpp")
FREE = (".f90", ".f95", ".f03", ".f08", ".f18")
OPTIONS = {"fixed": "-ffixed-form -ffixed-line-length-none",
           "free": "-ffree-form -ffree-line-length-none"}
# Other names of ABAQUS' own for arguments, by release
ALSO = {"amki": "dviscous", "amski": "dstructural", "secname": "slname", "mainname": "msname"}
# Lists that were met, by their length
KNOWN_LISTS = {44: ", the list of releases up to 6.6, without DVISCOUS, DSTRUCTURAL and FREQR",
               49: ", as many as VUINTER of ABAQUS/Explicit has"}
# What ABA_PARAM.INC has in effect
EFFECT = "      implicit real*8(a-h,o-z)\n      parameter (nprecd=2)\n"
DIRECTIVE = re.compile(r"^\s*[!c*](?:dir|dec)\$\s*(no)?(free|fixed)form", re.I)
SUBROUTINE = re.compile(r"(?:recursive|pure|impure|elemental|module)*subroutine"
                        r"([a-z]\w*?)(?:\(([^()]*)\)|$)")


class SourceError(Exception):
    """What is wrong with a source file."""


def read(path):
    with open(path, encoding="utf-8", errors="surrogateescape") as file:
        return file.read().splitlines()


def form_of(path, lines):
    """'fixed' or 'free', by the directive of Intel's compiler if there is one, else by the ending."""
    for line in lines:
        found = DIRECTIVE.match(line)
        if found:
            return "free" if (found[2].lower() == "free") != bool(found[1]) else "fixed"
    ending = os.path.splitext(path)[1].lower()
    if ending not in FIXED + FREE:
        raise SourceError(f"neither Fortran by its ending ({', '.join(FIXED + FREE)}) nor "
                          "an object file (.o, .obj)")
    return "fixed" if ending in FIXED else "free"


def options_of(form, lines):
    """The compiler's options for a form, and for lines of a preprocessor."""
    return OPTIONS[form].split() + ["-cpp"]*any(line.startswith("#") for line in lines)


def without_comment(line):
    """A line up to its comment; a ! in quotes begins none."""
    quote = ""
    for i, letter in enumerate(line):
        if quote:
            quote = "" if letter == quote else quote
        elif letter in "'\"":
            quote = letter
        elif letter == "!":
            return line[:i]
    return line


def statements(lines, form):
    """Statements in lower case without blanks, continuation lines joined."""
    whole, open_end = [], False
    for line in lines:
        if form == "fixed":
            if line[:1].lower() in ("c", "*", "d", "!", "#"):
                continue
            text = without_comment(line)
            if text.startswith("\t"):       # after a tab a digit continues
                text = "     " + (text[1:] if text[1:2] in tuple("123456789") else text)
            goes_on = text[:5].strip() == "" and text[5:6] not in ("", " ", "\t", "0")
            part = text[6:] if goes_on else text
            if not part.strip():
                continue
        else:
            if line.lstrip()[:1] == "#":
                continue
            text = without_comment(line).strip()
            if not text:
                continue
            goes_on, part = open_end, text.strip("&") if open_end else text.rstrip("&")
            open_end = text.endswith("&")
        part = re.sub(r"\s+", "", part).lower()
        if goes_on and whole:
            whole[-1] += part
        else:
            whole.append(part)
    return whole


def subroutines(path, lines, form, depth=0):
    """[(name, [argument])] of a file and of the files beside it that it includes."""
    found = []
    for text in statements(lines, form):
        part = SUBROUTINE.match(text)
        if part:
            found.append((part[1], part[2].split(",") if part[2] else []))
        include = re.match(r"include['\"](.+)['\"]$", text)
        if include and depth < 9:
            found += included(path, include[1], form, depth)
    return found


def included(path, name, form, depth):
    """Subroutines of an included file; the statement has lost the case of its name."""
    folder = os.path.dirname(os.path.abspath(path))
    for other in os.listdir(folder):
        if other.lower() == os.path.basename(name):
            return subroutines(path, read(os.path.join(folder, other)), form, depth + 1)
    return []


def right_arguments():
    """ABAQUS' list, from the signature that our hosts call by."""
    path = os.path.join(HERE, "..", "..", "abaqus", "routines", "uinter_signature.f90")
    for text in statements(read(path), "free"):
        part = SUBROUTINE.match(text)
        if part and part[1] == "uinter_interface":
            return part[2].split(",")
    raise SourceError(f"{path} has no uinter_interface")


def compare(found, right):
    """Notices on a list of arguments; an error where it is not ABAQUS'."""
    mine = [ALSO.get(name, name) for name in found]
    other = [i for i, (a, b) in enumerate(zip(mine, right)) if a != b and a in right]
    if len(mine) != len(right):
        first = next((i for i, (a, b) in enumerate(zip(mine, right)) if a != b),
                     min(len(mine), len(right)))
        at = (f"argument {first + 1} is {found[first].upper() if first < len(found) else 'missing'},"
              f" it should be {right[first].upper()}" if first < len(right) else
              f"argument {first + 1}, {found[first].upper()}, is one too many")
        raise SourceError(f"UINTER has {len(mine)} arguments{KNOWN_LISTS.get(len(mine), '')}; ABAQUS "
                          f"and CalculiX call it with {len(right)}: {at}")
    if other:
        i = other[0]
        raise SourceError(f"argument {i + 1} of UINTER is {found[i].upper()}, which ABAQUS has as "
                          f"argument {right.index(mine[i]) + 1}; its {i + 1} is {right[i].upper()}")
    unknown = [f"{found[i].upper()} for {right[i].upper()}" for i, name in enumerate(mine)
               if name not in right]
    return [f"names of UINTER's arguments, taken by their places: {', '.join(unknown)}"] \
        if unknown else []


def check(path):
    """(form, notices) of a file; SourceError for what cannot be a UINTER of ABAQUS."""
    lines = read(path)
    form = form_of(path, lines)
    found = subroutines(path, lines, form)
    lists = [arguments for name, arguments in found if name == "uinter"]
    if not lists:
        also = " but VUINTER, which ABAQUS/Explicit calls: there is no host of it here" \
            if any(name == "vuinter" for name, _ in found) else ""
        raise SourceError(f"no subroutine UINTER{also}")
    notices = []
    for arguments in lists:
        notices += compare(arguments, right_arguments())
    return form, notices


def caller(right, form):
    """A routine that calls UINTER with arguments of the right types. An element of an array goes to
    a scalar and to an array alike."""
    characters = ("ciname", "slname", "msname")
    integers = right[right.index("node"):]
    reals = [name for name in right if name not in (*characters, *integers)]
    margin, more, go_on = ("", " &", "   ") if form == "free" else ("      ", "", "     &")
    def listed(head, names, tail=""):
        rows = [", ".join(names[i:i + 5]) for i in range(0, len(names), 5)]
        return [margin + head + more, *[f"{go_on}{row}," + more for row in rows[:-1]],
                go_on + rows[-1] + tail]
    return "\n".join([
        "", margin + "subroutine calls_uinter()", margin + "implicit none",
        *listed("character(len=80) ::", characters), *listed("integer ::", integers),
        *listed("double precision ::", [f"{name}(1)" for name in reals]),
        *listed("call uinter(", [f"{name}(1)" if name in reals else name for name in right], ")"),
        margin + "end", ""])


def write_include(folder):
    """ABA_PARAM.INC as far as it matters, in both casings."""
    for name in ("aba_param.inc", "ABA_PARAM.INC"):
        with open(os.path.join(folder, name), "w", encoding="ascii") as file:
            file.write(EFFECT)


def check_types(path, form, compiler, right):
    """Error for arguments that are used and have another type than ABAQUS', by the compiler."""
    with open(path, encoding="utf-8", errors="surrogateescape") as file:
        text = file.read()
    with tempfile.TemporaryDirectory() as folder:
        write_include(folder)

        def said_of(part):
            copy = os.path.join(folder, "check" + os.path.splitext(path)[1])
            with open(copy, "w", encoding="utf-8", errors="surrogateescape") as file:
                file.write(part)
            return subprocess.run(
                [compiler, "-S", "-std=legacy", "-Wunused-dummy-argument", "-fmax-errors=0",
                 f"-J{folder}", f"-I{folder}", "-I" + os.path.dirname(os.path.abspath(path)),
                 *options_of(form, text.splitlines()), copy, "-o", os.path.join(folder, "check.s")],
                capture_output=True, text=True, check=False, errors="replace", cwd=folder,
                env={**os.environ, "LC_ALL": "C"}).stderr
        # by the calls in the file itself, which the compiler warns of later
        mismatch = r"Type mismatch in argument .(\w+). at \(1\); passed (\S+) to (\S+)"
        said = said_of(text)
        ours = re.findall(mismatch, said_of(text + caller(right, form)))
        unused = re.findall(r"Unused dummy argument .(\w+).", said)
        wrong = [f"{name.upper()} is {has}, not {passed}" for name, passed, has in ours
                 if name not in unused and has != "UNKNOWN"
                 and (name, passed, has) not in re.findall(mismatch, said)]
    if wrong:
        more = f" and {len(wrong) - 3} more" if len(wrong) > 3 else ""
        raise SourceError("UINTER's arguments have other types than ABAQUS': "
                          f"{'; '.join(wrong[:3])}{more}. Is INCLUDE 'ABA_PARAM.INC' missing?")


def main():
    path, compiler, folder = sys.argv[1:]
    write_include(folder)
    try:
        form, notices = check(path)
        check_types(path, form, compiler, right_arguments())
    except SourceError as problem:
        print(problem, file=sys.stderr)
        return 1
    for notice in notices:
        print(notice, file=sys.stderr)
    print(*options_of(form, read(path)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
