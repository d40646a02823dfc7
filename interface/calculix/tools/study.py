"""What the comparison studies share: programs, runs of decks, tables, curves."""

import math
import os
import shutil
import subprocess
import sys

from . import history, pictures
from .files import tables

HERE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
PALETTE = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#555555")


class StudyError(Exception):
    """Why a study cannot be done; status is the exit status."""

    def __init__(self, message, status=1):
        super().__init__(message)
        self.status = status


def add_programs(parser):
    """Options that name the three programs."""
    parser.add_argument("--asperity", metavar="PROGRAM",
                        default=found("build/asperity", "asperity"), help="asperity [%(default)s]")
    parser.add_argument("--uinter", metavar="PROGRAM",
                        default=found("build/calculix/ccx_uinter", "ccx_uinter"),
                        help="CalculiX with UINTER, of interface/calculix/build [%(default)s]")
    parser.add_argument("--ccx", metavar="PROGRAM", default="ccx",
                        help="CalculiX as it comes [ccx]")


def found(built, name):
    """The program built below the current folder if it is there, else that of PATH."""
    return built if os.path.exists(built) else name


def need(program, remedy):
    """The path of a program, or an error that says how to get it."""
    path = shutil.which(program)
    if path is None:
        raise StudyError(f"no program '{program}': {remedy}", 3)
    return os.path.abspath(path)


def programs(options):
    """Set the three programs to paths."""
    options.asperity = need(options.asperity, "./run build makes it, --asperity names it")
    options.uinter = need(options.uinter, "interface/calculix/build makes it, --uinter names it")
    options.ccx = need(options.ccx, "the Debian package calculix-ccx has it, --ccx names it")


def asperity(options, *arguments):
    """Run asperity; what it prints is returned."""
    done = subprocess.run([options.asperity, *arguments], capture_output=True, text=True,
                          check=False)
    if done.returncode != 0:
        said = (done.stderr.strip() or done.stdout.strip()).splitlines()
        raise StudyError(said[-1] if said else f"asperity {arguments[0]} failed", done.returncode)
    return done.stdout


def run_deck(program, deck, folder, *arguments):
    """Run a deck, or go on with it; nothing is computed again that is there."""
    print(f"== {os.path.basename(deck)}, {os.path.basename(program)}", flush=True)
    command = [sys.executable, os.path.join(HERE, "run"), deck, "--ccx", program,
               "--output", folder, "--resume", *arguments]
    status = subprocess.run(command, check=False).returncode
    if status == 2:
        raise StudyError(f"{folder} holds something else: choose another --output, or remove it", 2)
    if status != 0:
        raise StudyError(f"the run of {deck} failed, see above", status)


def table(path):
    """Rows of a CSV file by the names of its columns, numbers as numbers."""
    return [{name: number(text) for name, text in row.items()} for row in tables.read_rows(path)]


def number(text):
    try:
        return float(text)
    except ValueError:
        return text


def costs(folder, run):
    """What a run took: increments, iterations, cutbacks, seconds, and the share of UINTER."""
    rows = history.read_increments(os.path.join(folder, "increments.csv"))
    cpu = sum(row["cpu_time"] for row in rows)
    known = [part["uinter"] for part in run["parts"] if "uinter" in part]
    share = sum(part["seconds"] for part in known)/max(
        sum(part["of_seconds"] for part in known), 0.01) if known else math.nan
    increments = max(len(rows), 1)
    return {"increments": len(rows), "iterations": sum(row["iterations"] for row in rows),
            "cutbacks": sum(row["attempts"] - 1 for row in rows), "seconds": cpu,
            "per_increment": cpu/increments,
            "per_iteration": cpu/max(sum(row["iterations"] for row in rows), 1), "share": share}


def print_costs(named):
    """Table of the costs of runs, {name: costs}."""
    print_table(["", "increments", "iterations", "cutbacks", "CPU s", "s/increment", "s/iteration",
                 "in UINTER"],
                [[name, c["increments"], c["iterations"], c["cutbacks"], f"{c['seconds']:.1f}",
                  f"{c['per_increment']:.3f}", f"{c['per_iteration']:.3f}",
                  "-" if math.isnan(c["share"]) else f"{100.0*c['share']:.2f} %"]
                 for name, c in named.items()])


def print_table(header, rows):
    """Columns as wide as they need, numbers to the right."""
    texts = [[str(v) for v in row] for row in [header, *rows]]
    widths = [max(len(row[i]) for row in texts) for i in range(len(header))]
    for row in texts:
        print("  " + "  ".join(v.ljust(w) if i == 0 else v.rjust(w)
                               for i, (v, w) in enumerate(zip(row, widths))).rstrip())
    print()


def print_faces(header, rows):
    """Rows of faces, [([text, ...], faces.FaceRow)], with the header of the texts before them."""
    print_table(list(map(tables.heading, [*header, *rows[0][1]._fields])),
                [[*texts, row.face, *(f"{value:.5g}" for value in row[1:])] for texts, row in rows])


def curves(path, series, title, labels, zero=True):
    """A picture of curves: series is [(name, x, y, style)], style 'line', 'dots' or 'dashes'."""
    script, plots = [], []
    for i, (name, x, y, style) in enumerate(series):
        script += [f"$d{i} << END", *(f"{a:.8g} {b:.8g}" for a, b in zip(x, y)), "END"]
        look = {"line": "lines lw 1.8", "dashes": "lines dt 2 lw 1.8",
                "dots": "points pt 6 ps 0.8 lw 1.2"}[style]
        plots.append(f"$d{i} using 1:2 with {look} lc rgb '{PALETTE[i % len(PALETTE)]}' "
                     f"title '{pictures.quoted(name)}' noenhanced")
    script += [f"set title '{pictures.quoted(title)}' noenhanced",
               f"set xlabel '{labels[0]}'", f"set ylabel '{labels[1]}'", "set grid lc '#dddddd'",
               "set key outside bottom center horizontal", "set bmargin 6"]
    if zero:
        script += ["set xzeroaxis lc '#888888'", "set yzeroaxis lc '#888888'"]
    pictures.draw(path, "\n".join(script + ["plot " + ", ".join(plots)]), 900, 620)
