"""PNEWDT of a UINTER cuts the increment by its factor, and nothing of the attempt that was given up
stays: the run ends as one whose increments were short from the start."""

from blocks import Deck, Interaction
from harness import Run, at_most, check
from results import recorded_calls
from .arguments import last_of_increments, props

SIDE, HEIGHT, MODULUS = 30.0, 10.0, 351.0
CUT_AFTER, LONGEST, FACTOR = 1.3, 0.1, 0.4


def sliding_deck(properties, increment, end=-0.2):
    """Press in one step, slide beyond the stick in another."""
    deck = Deck()
    deck.block("LOW", (-5, -5, -HEIGHT), (SIDE + 5, SIDE + 5, 0), (5, 5, 1), MODULUS)
    deck.block("HIGH", (0, 0, 0), (SIDE, SIDE, HEIGHT), (4, 4, 1), MODULUS)
    deck.contact(Interaction.uinter("WOOD", properties, depvar=5), "HIGH_DOWN", "LOW_UP")
    deck.step({"LOW_BOTTOM": (0, 0, 0), "HIGH_TOP": (0, 0, -0.2)}, increment=0.25)
    deck.step({"HIGH_TOP": (1.5, 0.5, end)}, increment=increment)
    return deck


def ends(run):
    """Forces at the end, and printed pressures and shears of all springs."""
    return run.printed.last_force("HIGH_TOP"), run.contact


def far(one, other):
    """Largest difference of forces, over the normal force, and of fields, over a pressure."""
    (force, springs), (other_force, other_springs) = one, other
    forces = max(abs(a - b) for a, b in zip(force, other_force)) / abs(force[2])
    fields = max(abs(a - b) / row[3] for node, row in springs.items()
                 for a, b in zip(row[3:], other_springs[node][3:]))
    return max(forces, fields)


def cutback(recorder, folder):
    """Asked by UINTER after 1.3 s, where the increment is 0.2 s."""
    asked = Run(recorder, folder, "cut-asked", sliding_deck(
        props(cut_after=CUT_AFTER, longest=LONGEST, factor=FACTOR), 0.2)).completed(2)
    plain = Run(recorder, folder, "cut-none", sliding_deck(props(), 0.2)).completed(2)
    rows = asked.increments
    lengths = [row[6] for row in rows if row[0] == 2]
    attempts = [row[2] for row in rows if row[0] == 2]
    check("cutback: the increments as UINTER asks for them", lengths[0] == 0.2
          and abs(lengths[1] - FACTOR * 0.2) < 1e-6 and max(lengths[1:]) <= LONGEST + 1e-6
          and attempts[:2] == [1, 2], ", ".join(f"{length:g}" for length in lengths))
    check("cutback: as many attempts more than increments as UINTER asked for",
          sum(attempts) > len(attempts), f"attempts {attempts}")
    tried = recorded_calls(asked.folder / "uinter.log")
    given_up = {key: len(table) for key, table in asked.iterations.items()
                if key not in {row[:3] for row in rows}}
    check("cutback: an attempt is given up in the iteration in which UINTER asks",
          given_up and set(given_up.values()) == {1}, str(given_up))
    check("cutback: no increment begins with the state that UINTER left when it asked",
          min(one["STATEV"][0] for one in tried) >= 0)
    last = last_of_increments(tried)[rows[-1][0], rows[-1][1]].values()
    check("cutback: increments counted in STATEV are those of JOB.sta", all(
        call["OUT_STATEV"][0] == len(rows) for call in last),
        f"{next(iter(last))['OUT_STATEV'][0]:g} and {len(rows)}")
    at_most("cutback: the sum of DTIME in STATEV is the total time", max(
        abs(call["OUT_STATEV"][3] - 2) for call in last), 1e-9)
    # the path is straight: other increments end at the same place
    at_most("cutback: ends as the run without a cut", far(ends(asked), ends(plain)), 1e-4)
    check("cutback: the run without a request has no cut", all(
        row[2] == 1 for row in plain.increments) and len(plain.increments) < len(rows),
        f"{len(plain.increments)} increments, {len(rows)} with")


def no_automatic_increments(recorder, folder):
    """As in ABAQUS, a job of increments of fixed length ends when UINTER asks for shorter ones."""
    text = sliding_deck(props(cut_after=CUT_AFTER, longest=LONGEST), 0.2).text()
    run = Run(recorder, folder, "cut-direct", text.replace("*STATIC", "*STATIC,DIRECT"))
    check("cutback with DIRECT: the job ends with an error status", run.status != 0,
          f"{run.status}")
    check("cutback with DIRECT: no increment after the request is done", max(
        row[4] for row in run.increments) <= CUT_AFTER)


def impatient(deck):
    """The deck with so few iterations allowed in its last step that the solver gives up long
    increments."""
    patient = "20,25,9,40,12,4,,12"
    first, last = deck.text().rsplit(patient, 1)
    return first + "3,4,9,4,12,4,,12" + last


def solver_cutback(uinter, recorder, law, folder):
    """A cut by the solver itself, when an increment is far too long."""
    runs = {}
    for words, increment in (("long", 1.0), ("short", 0.05)):
        deck = Deck()
        deck.block("LOW", (-5, -5, -HEIGHT), (SIDE + 5, SIDE + 5, 0), (5, 5, 1), MODULUS)
        deck.block("HIGH", (0, 0, 0), (SIDE, SIDE, HEIGHT), (4, 4, 1), MODULUS)
        deck.contact(Interaction.uinter("WOOD", law.props(), search_distance=3.0), "HIGH_DOWN",
                     "LOW_UP")
        deck.step({"LOW_BOTTOM": (0, 0, 0), "HIGH_TOP": (0, 0, -0.1)}, increment=0.25)
        deck.step({"HIGH_TOP": (2.0, 0, -0.45)}, increment=increment)
        runs[words] = Run(uinter, folder, f"cut-solver-{words}",
                          impatient(deck) if words == "long" else deck).completed(2)
    attempts = [row[2] for row in runs["long"].increments]
    check("cutback by the solver: there is one", max(attempts) > 1, f"attempts {attempts}")
    # the pressure grows while the block slides, so the increments' lengths do matter a little
    at_most("cutback by the solver: ends as a run of short increments",
            far(ends(runs["long"]), ends(runs["short"])), 1e-3)
    run = Run(recorder, folder, "cut-solver-recorded",
              impatient(sliding_deck(props(), 1.0, -2.0))).completed(2)
    rows, tried = run.increments, recorded_calls(run.folder / "uinter.log")
    last = last_of_increments(tried)[rows[-1][:2]].values()
    check("cutback by the solver: increments counted in STATEV are those of JOB.sta",
          max(row[2] for row in rows) > 1 and all(
              call["OUT_STATEV"][0] == len(rows) for call in last),
          f"{next(iter(last))['OUT_STATEV'][0]:g} and {len(rows)}, attempts "
          f"{[row[2] for row in rows]}")
    at_most("cutback by the solver: the sum of DTIME in STATEV is the total time", max(
        abs(call["OUT_STATEV"][3] - 2) for call in last), 1e-9)
