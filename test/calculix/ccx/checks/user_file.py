"""What a file of user subroutines meets: the course of a job by UEXTERNALDB, states as a table, outputs
that it leaves unset, areas of slave nodes, pairs that UINTER cannot serve. Two blocks, penalty law."""

import csv
import subprocess
from pathlib import Path

from blocks import Deck, Interaction
from harness import Run, at_most, check, close

ROOT = Path(__file__).resolve().parents[4]
SIDE, PENALTY = 10.0, 1000.0
RIGID = 1e9
NAME = "two blocks"


def blocks(props, overlap=0.0, kind="NODE TO SURFACE", modulus=RIGID, law="UINTER"):
    """Two blocks of 10 x 10 x 5, faces of 5 x 5, which overlap."""
    deck = Deck()
    low = deck.block("LOW", (0, 0, -5), (SIDE, SIDE, 0), (2, 2, 1), modulus)
    high = deck.block("HIGH", (0, 0, -overlap), (SIDE, SIDE, 5 - overlap), (2, 2, 1), modulus)
    interaction = Interaction.uinter("WOOD", props, depvar=3, search_distance=1.0)
    if law == "TABULAR":
        interaction = Interaction.table("WOOD", [(0, 0), (PENALTY, 1.0)], 0.5, 10.0)
    deck.contact(interaction, "HIGH_DOWN", "LOW_UP")
    deck.model[-2] = deck.model[-2].replace("NODE TO SURFACE", kind)
    return deck, low, high


def by_nodes(deck, nodes):
    """Give the slave surface by nodes."""
    place = deck.model.index("*SURFACE,NAME=HIGH_DOWN")
    deck.model[place:place + 5] = ["*SURFACE,NAME=HIGH_DOWN,TYPE=NODE",
                                   *[f"{node}," for node in nodes]]


def built(events, uinter):
    """What build said of events.for; what it refuses."""
    said = Path(events + ".log").read_text(encoding="utf-8")
    for text in ("UEXTERNALDB of the same file is called", "URDFIL of the same file is called",
                 "own dsort : CalculiX, which has such names too, does not call them",
                 "COMMON blocks, or variables that last from call to call: COUNTS EVENTS",
                 "the compiler warns", "COMMON block"):
        check(f"build says: {text}", text in said, "" if text in said else said)
    before = Path(uinter).stat().st_mtime
    for name, text in (("args28.for", "28 arguments"), ("args44.for", "44 arguments")):
        done = subprocess.run(
            [ROOT / "interface/calculix/build", "--uinter", ROOT / "test/data/uinter" / name,
             "--folder", Path(uinter).parent, "--output", uinter], capture_output=True, text=True,
            check=False)
        check(f"build refuses {name}", done.returncode == 1 and text in done.stderr
              and Path(uinter).stat().st_mtime == before, done.stderr)


def no_stress(events, folder):
    """A UINTER that gives no stress is told."""
    for penalty, told in ((0.0, True), (PENALTY, False)):
        deck, _, _ = blocks([penalty, 99.0, 0.0])
        deck.step({"LOW_BOTTOM": (0, 0, 0), "HIGH_TOP": (0, 0, -0.01)})
        run = Run(events, folder, f"stress-{penalty:g}", deck).completed(1)
        check(f"no stress at all is told, penalty {penalty:g}",
              ("*WARNING: UINTER gave no stress in any of" in run.log) == told)


def course(events, folder):
    """Two steps of two increments, the first of the second step in two attempts."""
    deck, _, _ = blocks([PENALTY, 1.0, 0.0])
    deck.step({"LOW_BOTTOM": (0, 0, 0), "HIGH_TOP": (0, 0, -0.01)}, increment=0.5)
    deck.step({"HIGH_TOP": (0, 0, -0.02)}, increment=0.5)
    run = Run(events, folder, "events", deck, {"ASPERITY_CALCULIX_JOB": NAME,
                                               "ASPERITY_CALCULIX_STATES": "1"}).completed(2)
    seen = [line.split()[1:] for line in (run.folder / f"{NAME}.events").read_text(
        encoding="ascii").splitlines()]
    seen = [(*map(int, words[:3]), *map(float, words[3:])) for words in seen]
    expected = [(0, 0, 0, 0, 0, 0), (5, 1, 0, 0, 0, 0),
                (1, 1, 1, 0, 0, .5), (2, 1, 1, .5, .5, .5),
                (1, 1, 2, .5, .5, .5), (2, 1, 2, 1, 1, .5), (6, 1, 2, 1, 1, .5),
                (5, 2, 0, 0, 1, 0),
                (1, 2, 1, 0, 1, .5), (1, 2, 1, 0, 1, .25), (2, 2, 1, .25, 1.25, .25)]
    check("UEXTERNALDB: start of job, step and increment, again after a cut, ends",
          seen[:len(expected)] == expected, str(seen))
    check("UEXTERNALDB: end of the last increment, step and job", [row[:2] for row in seen[-3:]]
          == [(2, 2), (6, 2), (3, 2)] and [row[4] for row in seen[-3:]] == [2, 2, 2],
          str(seen[-3:]))
    attempts = sum(row[2] for row in run.increments)
    ended = [row[1:5] for row in seen if row[0] == 2]
    table = [(row[0], row[1], row[5], row[4]) for row in run.increments]
    check("UEXTERNALDB: the ends are those of JOB.sta", ended == table, f"{ended}, {table}")
    began = sum(row[0] == 1 for row in seen)
    check("UEXTERNALDB: a beginning for every attempt of JOB.sta", began == attempts > len(table),
          f"{began}, {attempts}")
    states(run)


def states(run):
    """JOB.states.csv against JOB.frd and what UINTER writes into STATEV."""
    with open(run.file("states.csv"), encoding="ascii", newline="") as file:
        rows = list(csv.DictReader(file))
    check("states: the columns", list(rows[0]) == [
        "step", "increment", "time", "pair", "node", "statev_1", "statev_2", "statev_3"])
    check("states: nine points in every increment", len(rows) == 9*len(run.increments)
          and {row["pair"] for row in rows} == {"HIGH_DOWN"}, f"{len(rows)} rows")
    fields = run.contact_history
    off = max(abs(float(row["statev_1"]) + fields[min(fields, key=lambda t: abs(
        t - float(row["time"])))][int(row["node"])][0]) for row in rows)
    at_most("states: RDISP(1) against the clearance of JOB.frd, mm", off, 1e-7)
    off = max(abs(float(row["statev_2"]) - float(row["time"])) for row in rows)
    at_most("states: TIME(2) against the time", off, 1e-9)
    last = [float(row["statev_3"]) for row in rows if row["time"] == rows[-1]["time"]]
    check("UEXTERNALDB: LOP = 1 came before every call", min(last) > 0, str(last))
    close("AREA: sum over the face, mm2", sum(last), SIDE*SIDE, relative=1e-6)


def stopped(events, folder):
    """URDFIL ends the job."""
    deck, _, _ = blocks([PENALTY, 99.0, 1.0])
    for down in (-0.01, -0.02):
        deck.step({"LOW_BOTTOM": (0, 0, 0), "HIGH_TOP": (0, 0, down)}, increment=0.5)
    run = Run(events, folder, "urdfil", deck)
    check("URDFIL: LSTOP = 1 ends the job after the increment", run.status != 0
          and "URDFIL ended the analysis" in run.log and [row[:2] for row in run.increments]
          == [(1, 1), (1, 2)], f"{run.status}, {run.increments}")


def node_surface(events, folder):
    """1 MPa on blocks that hardly give: closure of pressure over penalty, force shared as by faces."""
    areas = {}
    for name in ("faces", "nodes"):
        deck, _, high = blocks([PENALTY, 99.0, 0.0], overlap=0.0005)
        if name == "nodes":
            by_nodes(deck, high.layer(0))
        deck.model += ["*BOUNDARY", "HIGH_ALL,1,2"]
        load = ["*DLOAD", *[f"{number},P2,1." for number, _ in high.faces(-1, "S2")]]
        deck.step({"LOW_BOTTOM": (0, 0, 0)}, increment=1.0, more=load)
        run = Run(events, folder, f"areas-{name}", deck,
                  {"ASPERITY_CALCULIX_STATES": "1"}).completed(1)
        for node, row in run.contact.items():
            if abs(-row[0] - 1.0/PENALTY) > 1e-8:
                check(f"slave surface of {name}: closure at node {node}", False, f"{-row[0]:.9g}")
        close(f"slave surface of {name}: mean closure under 1 MPa, mm",
              -sum(row[0] for row in run.contact.values())/9, 1.0/PENALTY, relative=1e-5)
        with open(run.file("states.csv"), encoding="ascii", newline="") as file:
            areas[name] = [float(row["statev_3"]) for row in csv.DictReader(file)]
    close("slave surface of nodes: sum of the areas, mm2", sum(areas["nodes"]), SIDE*SIDE,
          relative=1e-6)
    check("slave surface of nodes: areas as of faces", sorted(areas["nodes"]) == sorted(
        areas["faces"]), f"{areas}")
    deck, _, high = blocks([PENALTY, 99.0, 0.0])
    by_nodes(deck, list(high.layer(0))[:3])
    deck.step({"LOW_BOTTOM": (0, 0, 0), "HIGH_TOP": (0, 0, -0.01)})
    run = Run(events, folder, "areas-row", deck)
    check("slave surface of a row of nodes: refused", run.status != 0
          and "slave node 19 has no area" in run.log, f"{run.status}")


def poison(penalty, uinter, law, folder):
    """Entries of DDSDDR and STRESS that a UINTER never sets; asperity's sets them all."""
    deck, _, _ = blocks([PENALTY])
    deck.step({"LOW_BOTTOM": (0, 0, 0), "HIGH_TOP": (0.001, 0, -0.01)})
    run = Run(penalty, folder, "poison-penalty", deck, {"ASPERITY_CALCULIX_POISON": "1"})
    said = [line for line in run.log.splitlines() if "UINTER did not set" in line]
    check("poison: what a UINTER leaves unset is named", run.status != 0 and len(said) == 1
          and all(name in said[0] for name in ("DDSDDR(1,2)", "DDSDDR(2,2)", "DDSDDR(3,1)", "node ",
                                               "step 1, increment 1")), str(said))
    results = []
    for name, surroundings in (("clean", {}), ("poison", {"ASPERITY_CALCULIX_POISON": "1"})):
        deck, _, _ = blocks([], modulus=351.0)
        deck.model[deck.model.index("*SURFACE INTERACTION,NAME=WOOD") + 1:] = [
            *Interaction.uinter("WOOD", law.props()).lines, *deck.model[-2:]]
        deck.step({"LOW_BOTTOM": (0, 0, 0), "HIGH_TOP": (0, 0, -0.08)})
        deck.step({"HIGH_TOP": (0.4, 0.1, -0.08)})
        results.append(Run(uinter, folder, f"poison-{name}", deck, surroundings).completed(2))
    check("poison: asperity's UINTER sets all that it must, and what it may",
          "UINTER sets STRESS and DDSDDR" in results[1].log
          and "leaves unset" not in results[1].log, results[1].log[-300:].replace("\n", " "))
    check("poison: nothing else changes", results[0].printed.last_force("HIGH_TOP")
          == results[1].printed.last_force("HIGH_TOP"))


def pairs(stock, events, folder):
    """Pairs that are not node to surface, and a table in them, which stock ccx takes."""
    for kind, word in (("SURFACE TO SURFACE", "write *CONTACT PAIR, INTERACTION=name, "
                        "TYPE=NODE TO SURFACE, and below it"), ("MORTAR", "ERROR")):
        deck, _, _ = blocks([PENALTY, 99.0, 0.0], kind=kind)
        deck.step({"LOW_BOTTOM": (0, 0, 0), "HIGH_TOP": (0, 0, -0.01)})
        run = Run(events, folder, f"pair-{kind.split()[0]}", deck)
        check(f"{kind} with UINTER: refused", run.status != 0 and word in run.log
              and "Job finished" not in run.log, f"{run.status}")
    forces = {}
    for kind in ("NODE TO SURFACE", "SURFACE TO SURFACE"):
        deck, _, _ = blocks([], overlap=0.0005, kind=kind, law="TABULAR")
        deck.step({"LOW_BOTTOM": (0, 0, 0), "HIGH_TOP": (0, 0, 0)}, increment=0.2)
        run = Run(stock, folder, f"table-{kind.split()[0]}", deck).completed(1)
        forces[kind] = [abs(row[2]) for _, row in sorted(run.printed.forces["HIGH_TOP"].items())]
    # the blocks give way a little
    whole = 0.0005/(1.0/PENALTY + 10.0/RIGID)*SIDE*SIDE
    found = forces["NODE TO SURFACE"]
    close("a table in stock ccx, an overlap at the start: its share in the first increment, N",
          found[0], 0.2*whole, relative=1e-6)
    close("... all of it in the second", found[1], whole, relative=1e-6)
    close("... and at the end of the step, N", found[-1], whole, relative=1e-6)
    at_most("a table in stock ccx, surface to surface: no force, no message, N",
            max(forces["SURFACE TO SURFACE"]), 1e-6)
